// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/holdwatch.h"

#include <QEvent>
#include <QGuiApplication>
#include <QWidget>

namespace trex {

HoldWatch::HoldWatch(QWidget& held) : QObject(&held), m_key(this)
{
    held.installEventFilter(this);
    m_key.setSingleShot(true);
    connect(&m_key, &QTimer::timeout, this, &HoldWatch::lose);
    connect(qGuiApp, &QGuiApplication::applicationStateChanged, this, [this](auto state) {
        if (state != Qt::ApplicationActive) {
            lose();
        }
    });
}

void HoldWatch::begin(By by)
{
    m_isHeld = true;
    if (by == By::Key) {
        m_key.start(kWithoutRepeat);
    }
}

void HoldWatch::sign()
{
    if (m_isHeld) {
        m_key.start(kBetweenRepeats);
    }
}

void HoldWatch::end()
{
    m_isHeld = false;
    m_key.stop();
}

void HoldWatch::lose()
{
    if (m_isHeld) {
        end();
        emit lost();
    }
}

bool HoldWatch::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::FocusOut:
    case QEvent::Hide:
    case QEvent::WindowDeactivate:
    case QEvent::WindowBlocked: // a modal dialog has come up
    case QEvent::UngrabMouse:
        lose();
        break;
    case QEvent::EnabledChange:
        if (!static_cast<QWidget*>(watched)->isEnabled()) {
            lose();
        }
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace trex
