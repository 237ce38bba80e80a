// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/linechange.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace trex {

/// What a change of the line settings waits for, and what the person can do meanwhile. Hidden when
/// there is nothing to say. GUI thread.
class LineChangeBox : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(LineChangeBox)
    Q_PROPERTY(QString phase READ phase)

public:
    explicit LineChangeBox(LineChange& change, QWidget* parent = nullptr);
    /// "none", "waiting", "reconnecting", "recovering"; never translated.
    [[nodiscard]] QString phase() const;

private:
    void refresh();

    LineChange& m_change;
    QLabel* m_text;
    QPushButton* m_reconnect;
    QPushButton* m_recover;
    QPushButton* m_cancel;
};

} // namespace trex
