// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/motors/holdwatch.h"

#include <QSet>
#include <QWidget>

namespace trex {

/// Drives both motors like one stick: up and down is forward and back, left and right is turn. Held
/// with the mouse, or by the arrow keys; let go, or no longer surely held, it springs to neutral.
/// GUI thread.
class DrivePad : public QWidget {
    Q_OBJECT
    Q_PROPERTY(int forward READ forward)
    Q_PROPERTY(int turn READ turn)

public:
    explicit DrivePad(QWidget* parent = nullptr);
    [[nodiscard]] int forward() const { return m_forward; } ///< −127 to 127
    [[nodiscard]] int turn() const { return m_turn; } ///< −127 (left) to 127
    void setKeySpeed(int speed) { m_keySpeed = speed; } ///< what an arrow key stands for, 1 to 127
    void springBack(); ///< to neutral, as if let go
    /// By a gamepad, whose own button is the hold; a mouse or a key that is held goes first. What
    /// was held while the pad could not be used has to be let go once.
    void steer(int forward, int turn);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    void moved(int forward, int turn);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    void set(int forward, int turn);
    void followMouse(const QPointF& position);
    void followKeys();
    [[nodiscard]] QRectF field() const;

    HoldWatch m_hold;
    QSet<int> m_keys; ///< arrow keys that are down
    int m_forward = 0;
    int m_turn = 0;
    int m_keySpeed = 40;
    bool m_isSteerStale = false;
};

} // namespace trex
