// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/stopkey.h"

#include "protocol/session/controller.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace trex {

StopKey::StopKey(Controller& controller, QObject* parent)
    : QObject(parent), m_controller(controller)
{
    QCoreApplication::instance()->installEventFilter(this);
}

bool StopKey::eventFilter(QObject* watched, QEvent* event)
{
    // At the window, before any widget, popup or shortcut can take it.
    if (event->type() == QEvent::KeyPress && watched->isWindowType()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Escape && !key->isAutoRepeat()) {
            m_controller.stop();
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace trex
