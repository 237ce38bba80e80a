// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/motors/holdwatch.h"

#include <QToolButton>

namespace trex {

/// A button that does something while it is held, by the mouse or by Space, and only while that is
/// sure (HoldWatch). GUI thread.
class HoldButton : public QToolButton {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(HoldButton)

public:
    explicit HoldButton(Qt::ArrowType arrow, QWidget* parent = nullptr);

signals:
    void heldChanged(bool held);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    void begin();
    void end();
    HoldWatch m_hold;
    bool m_isByKey = false;
};

} // namespace trex
