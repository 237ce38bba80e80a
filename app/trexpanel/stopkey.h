// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace trex {

class Controller;

/// Esc stops all motors, whatever window of the program has the keys: dialogs, wizards, menus and
/// other popups. The key goes on afterwards, so that a dialog closes by it, too. GUI thread.
class StopKey : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(StopKey)

public:
    explicit StopKey(Controller& controller, QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    Controller& m_controller;
};

} // namespace trex
