// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/trexpanel/sessionwatch.h"
#include "protocol/session/restartwatch.h"

namespace trex {

class UiSettings;

/// Brings what the person chose about safety to the façade, and disarms it when nobody can watch
/// the motors any more: screen locked, computer going to sleep, no window to be seen. GUI thread.
class SafetyWatch : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(SafetyWatch)

public:
    SafetyWatch(Controller& controller, const TelemetryStore& store, UiSettings& settings,
                QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void applySettings();
    void lookForWindows();
    void listen();

    Controller& m_controller;
    UiSettings& m_settings;
    RestartWatch m_restart;
    SessionWatch m_session;
    bool m_isLookPosted = false;
};

} // namespace trex
