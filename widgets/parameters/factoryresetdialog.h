// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace trex {

class Controller;

/// Asks before all parameters go back to the factory's: accepted() only after a box is ticked. Not
/// modal, with a STOP of its own. GUI thread.
class FactoryResetDialog : public QDialog {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(FactoryResetDialog)

public:
    explicit FactoryResetDialog(Controller& controller, QWidget* parent = nullptr);
};

} // namespace trex
