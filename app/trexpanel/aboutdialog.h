// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace trex {

class Controller;

/// What this program is, its licence, and the licences of what it is built with. Not modal, with a
/// STOP of its own.
class AboutDialog : public QDialog {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(AboutDialog)

public:
    explicit AboutDialog(Controller& controller, QWidget* parent = nullptr);
};

} // namespace trex
