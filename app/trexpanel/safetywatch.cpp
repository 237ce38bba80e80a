// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/safetywatch.h"

#include "protocol/session/controller.h"
#include "widgets/common/safetysettings.h"
#include "widgets/common/uisettings.h"

#include <QApplication>
#include <QEvent>
#include <QWidget>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

/// One that a person can see, and reach STOP in.
bool isToBeSeen(const QWidget& window)
{
    const Qt::WindowType type = window.windowType();
    const bool isReal = type == Qt::Window || type == Qt::Dialog || type == Qt::Tool;
    return isReal && window.isVisible() && !window.isMinimized();
}

} // namespace

SafetyWatch::SafetyWatch(Controller& controller, const TelemetryStore& store, UiSettings& settings,
                         QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_settings(settings)
    , m_restart(controller, store, this)
    , m_session(this)
{
    listen();
    applySettings();
    QCoreApplication::instance()->installEventFilter(this);
}

void SafetyWatch::listen()
{
    connect(&m_settings, &UiSettings::changed, this, [this](const QString& key) {
        if (key.startsWith("safety/"_L1) || key.startsWith("motion/"_L1)) {
            applySettings();
        }
    });
    connect(&m_session, &SessionWatch::locked, this, [this] {
        if (m_settings.value(settings::kDisarmLocked)) {
            m_controller.disarm(DisarmReason::SessionLocked);
        }
    });
    connect(&m_session, &SessionWatch::suspending, this, [this] {
        if (m_settings.value(settings::kDisarmLocked)) {
            m_controller.disarm(DisarmReason::Suspending);
        }
        if (m_controller.gate().stopProgress() != StopProgress::Asked) {
            m_session.delaySleep(false);
        }
    });
    connect(&m_controller, &Controller::armedChanged, this, [this](bool armed) {
        if (armed) {
            m_session.delaySleep(true);
        }
    });
    // Sleep may go on as soon as it is known how the stop went.
    connect(&m_controller, &Controller::stopped, this, [this] { m_session.delaySleep(false); });
    connect(&m_controller, &Controller::stopFailed, this, [this] { m_session.delaySleep(false); });
}

void SafetyWatch::applySettings()
{
    m_controller.setDisarmRules(disarmRules(m_settings));
    const MotionLimits limits = motionLimits(m_settings);
    if (limits != m_controller.shaper().limits()) {
        m_controller.setMotionLimits(limits);
    }
}

bool SafetyWatch::eventFilter(QObject* watched, QEvent* event)
{
    const bool mayMatter =
        event->type() == QEvent::Hide || event->type() == QEvent::WindowStateChange;
    if (mayMatter && !m_isLookPosted && watched->isWidgetType()
        && static_cast<QWidget*>(watched)->isWindow()) {
        m_isLookPosted = true; // later: another may be shown in its place
        QMetaObject::invokeMethod(this, &SafetyWatch::lookForWindows, Qt::QueuedConnection);
    }
    return QObject::eventFilter(watched, event);
}

void SafetyWatch::lookForWindows()
{
    m_isLookPosted = false;
    const QWidgetList windows = QApplication::topLevelWidgets();
    const bool isAnyToBeSeen = std::any_of(windows.begin(), windows.end(),
                                           [](const QWidget* w) { return isToBeSeen(*w); });
    if (!isAnyToBeSeen && m_settings.value(settings::kDisarmHidden)) {
        m_controller.disarm(DisarmReason::WindowHidden);
    }
}

} // namespace trex
