// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/holdbutton.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace trex {

HoldButton::HoldButton(Qt::ArrowType arrow, QWidget* parent) : QToolButton(parent), m_hold(*this)
{
    setArrowType(arrow);
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QToolButton::pressed, this, &HoldButton::begin);
    connect(this, &QToolButton::released, this, &HoldButton::end);
    connect(&m_hold, &HoldWatch::lost, this, [this] {
        setDown(false);
        emit heldChanged(false);
    });
}

void HoldButton::begin()
{
    m_hold.begin(m_isByKey ? HoldWatch::By::Key : HoldWatch::By::Mouse);
    m_isByKey = false;
    emit heldChanged(true);
}

void HoldButton::end()
{
    if (m_hold.isHeld()) {
        m_hold.end();
        emit heldChanged(false);
    }
}

void HoldButton::keyPressEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat()) {
        m_hold.sign();
        return;
    }
    m_isByKey = true;
    QToolButton::keyPressEvent(event);
    m_isByKey = false;
}

void HoldButton::mouseMoveEvent(QMouseEvent* event)
{
    if (m_hold.isHeld() && (event->buttons() & Qt::LeftButton) == 0) {
        setDown(false); // its release went elsewhere
        end();
    }
    QToolButton::mouseMoveEvent(event);
}

} // namespace trex
