// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace trex {

/// Tells when the person can no longer watch: the screen is locked, or the computer goes to sleep.
/// By logind and the desktop's screen saver on the D-Bus, where there is one, at build and at run
/// time; else it never tells anything. GUI thread; never waits for the bus.
class SessionWatch : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(SessionWatch)

public:
    explicit SessionWatch(QObject* parent = nullptr);
    ~SessionWatch() override;
    /// Asks for a moment before the computer sleeps (logind's delay), while motors may move.
    void delaySleep(bool wanted);
    [[nodiscard]] static bool isBuiltIn();

signals:
    void locked();
    void suspending();

private slots: // called by the bus, by name
    void onScreenSaver(bool active);
    void onPrepareForSleep(bool begins);
    void onLock();

private:
    void listenToSession();
    int m_delay = -1; ///< logind's descriptor; closed: sleep may go on
    bool m_isDelayWanted = false;
};

} // namespace trex
