// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

namespace trex {

class Controller;

/// The red STOP: stops all three motors when it goes down, without waiting for the release. Always
/// enabled. GUI thread.
class StopButton : public QPushButton {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(StopButton)

public:
    explicit StopButton(Controller& controller, QWidget* parent = nullptr);
    [[nodiscard]] QSize sizeHint() const override;
};

} // namespace trex
