// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/sessionwatch.h"

#ifdef TREX_HAS_DBUS
#include <QCoreApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusObjectPath>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusUnixFileDescriptor>

#include <unistd.h>
#endif

namespace trex {

#ifdef TREX_HAS_DBUS

using namespace Qt::Literals::StringLiterals;

namespace {

const QString kLogin = u"org.freedesktop.login1"_s;
const QString kLoginPath = u"/org/freedesktop/login1"_s;
const QString kManager = u"org.freedesktop.login1.Manager"_s;

// Qt's D-Bus knows receivers by name only; the leading 1 is what its macro for slots puts there.
constexpr auto kOnScreenSaver = "1onScreenSaver(bool)";
constexpr auto kOnPrepareForSleep = "1onPrepareForSleep(bool)";
constexpr auto kOnLock = "1onLock()";

} // namespace

SessionWatch::SessionWatch(QObject* parent) : QObject(parent)
{
    // No service is named: looking up its owner would wait for the bus, and whoever says so does no
    // more harm than to stop motors.
    auto session = QDBusConnection::sessionBus();
    for (const auto& [path, interface] :
         {std::pair{u"/org/freedesktop/ScreenSaver"_s, u"org.freedesktop.ScreenSaver"_s},
          {u"/ScreenSaver"_s, u"org.freedesktop.ScreenSaver"_s},
          {u"/org/gnome/ScreenSaver"_s, u"org.gnome.ScreenSaver"_s}}) {
        session.connect({}, path, interface, u"ActiveChanged"_s, this, kOnScreenSaver);
    }
    auto system = QDBusConnection::systemBus();
    system.connect({}, kLoginPath, kManager, u"PrepareForSleep"_s, this, kOnPrepareForSleep);
    listenToSession();
}

SessionWatch::~SessionWatch()
{
    delaySleep(false);
}

bool SessionWatch::isBuiltIn()
{
    return true;
}

/// The lock of our own session only: others on the same computer lock theirs.
void SessionWatch::listenToSession()
{
    auto system = QDBusConnection::systemBus();
    if (!system.isConnected()) {
        return;
    }
    QDBusMessage call =
        QDBusMessage::createMethodCall(kLogin, kLoginPath, kManager, u"GetSessionByPID"_s);
    call << static_cast<uint>(QCoreApplication::applicationPid());
    auto* watcher = new QDBusPendingCallWatcher(system.asyncCall(call), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher] {
        const QDBusPendingReply<QDBusObjectPath> reply = *watcher;
        watcher->deleteLater();
        if (!reply.isError()) {
            QDBusConnection::systemBus().connect({}, reply.value().path(),
                                                 u"org.freedesktop.login1.Session"_s, u"Lock"_s,
                                                 this, kOnLock);
        }
    });
}

void SessionWatch::delaySleep(bool wanted)
{
    m_isDelayWanted = wanted;
    if (!wanted) {
        if (m_delay >= 0) {
            ::close(std::exchange(m_delay, -1));
        }
        return;
    }
    auto system = QDBusConnection::systemBus();
    if (m_delay >= 0 || !system.isConnected()) {
        return;
    }
    QDBusMessage call = QDBusMessage::createMethodCall(kLogin, kLoginPath, kManager, u"Inhibit"_s);
    call << u"sleep"_s << QCoreApplication::applicationName()
         << tr("The motors are stopped before the computer sleeps.") << u"delay"_s;
    auto* watcher = new QDBusPendingCallWatcher(system.asyncCall(call), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher] {
        const QDBusPendingReply<QDBusUnixFileDescriptor> reply = *watcher;
        watcher->deleteLater();
        if (!reply.isError() && m_isDelayWanted && m_delay < 0) {
            m_delay = ::dup(reply.value().fileDescriptor());
        }
    });
}

#else

SessionWatch::SessionWatch(QObject* parent) : QObject(parent) { }
SessionWatch::~SessionWatch() = default;

bool SessionWatch::isBuiltIn()
{
    return false;
}

void SessionWatch::listenToSession() { }

void SessionWatch::delaySleep(bool wanted)
{
    m_isDelayWanted = wanted;
}

#endif

void SessionWatch::onScreenSaver(bool active)
{
    if (active) {
        emit locked();
    }
}

void SessionWatch::onPrepareForSleep(bool begins)
{
    if (begins) {
        emit suspending();
    }
}

void SessionWatch::onLock()
{
    emit locked();
}

} // namespace trex
