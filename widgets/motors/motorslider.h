// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/theme.h"
#include "widgets/motors/holdwatch.h"

#include <QSlider>

namespace trex {

/// A speed slider: bar from neutral to the handle, a mark and a detent at neutral. The wheel does
/// nothing unless the slider has the focus; Home and Space are neutral, and no key jumps to full
/// speed. GUI thread.
class MotorSlider : public QSlider {
    Q_OBJECT

public:
    MotorSlider(int minimum, int maximum, ColourRole role, QWidget* parent = nullptr);
    /// Hold to run: springs to neutral when it is let go, or no longer surely held.
    void setSpring(bool springs);
    void setReached(int speed); ///< marked beside the order while a ramp runs
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] double xOf(int value) const;
    [[nodiscard]] int valueAt(double x) const;
    void paintScale(QPainter& painter) const;

    void springBack();

    ColourRole m_role;
    HoldWatch m_hold;
    bool m_springs = false;
    int m_reached = 0;
    double m_grip = 0.0; ///< where in the handle it was taken
};

} // namespace trex
