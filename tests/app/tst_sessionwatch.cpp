// SPDX-License-Identifier: GPL-3.0-or-later
// Screen lock and sleep as the D-Bus tells them, on a bus of the test's own that stands for both
// the session's and the system's.
#include "app/trexpanel/sessionwatch.h"

#include <QCoreApplication>
#include <QDBusConnection>
#include <QDBusContext>
#include <QDBusMessage>
#include <QDBusObjectPath>
#include <QDBusUnixFileDescriptor>
#include <QProcess>
#include <QSignalSpy>
#include <QTest>

#include <unistd.h>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

const QString kLoginPath = u"/org/freedesktop/login1"_s;
const QString kOurSession = u"/org/freedesktop/login1/session/_37"_s;

/// What SessionWatch asks of logind.
class Login : public QObject {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.login1.Manager")

public:
    std::array<int, 2> ends{-1, -1}; ///< of the pipe whose write end is the delay
    QStringList inhibited;

public slots:
    QDBusObjectPath GetSessionByPID(uint pid)
    {
        return QDBusObjectPath(static_cast<qint64>(pid) == QCoreApplication::applicationPid()
                                   ? kOurSession
                                   : u"/none"_s);
    }
    QDBusUnixFileDescriptor Inhibit(const QString& what, const QString& /*who*/,
                                    const QString& /*why*/, const QString& mode)
    {
        inhibited = {what, mode};
        if (::pipe(ends.data()) != 0) {
            return {};
        }
        QDBusUnixFileDescriptor descriptor(ends[1]);
        ::close(ends[1]);
        return descriptor;
    }
};

/// True when nobody holds the other end any more.
bool isClosed(int end)
{
    char byte = 0;
    return ::read(end, &byte, 1) == 0;
}

} // namespace

class TestSessionWatch : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!QDBusConnection::sessionBus().isConnected()) {
            QSKIP("there is no dbus-daemon here");
        }
        QVERIFY(m_bus.isConnected());
        QVERIFY(m_bus.registerService(u"org.freedesktop.login1"_s));
        QVERIFY(m_bus.registerObject(kLoginPath, &m_login, QDBusConnection::ExportAllSlots));
    }

    void screenSaver_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("interface");
        QTest::newRow("freedesktop")
            << u"/org/freedesktop/ScreenSaver"_s << u"org.freedesktop.ScreenSaver"_s;
        QTest::newRow("freedesktop, old path")
            << u"/ScreenSaver"_s << u"org.freedesktop.ScreenSaver"_s;
        QTest::newRow("gnome") << u"/org/gnome/ScreenSaver"_s << u"org.gnome.ScreenSaver"_s;
    }

    void screenSaver()
    {
        QFETCH(QString, path);
        QFETCH(QString, interface);
        const SessionWatch watch;
        QSignalSpy locked(&watch, &SessionWatch::locked);
        tell(path, interface, u"ActiveChanged"_s, {true});
        QTRY_COMPARE(locked.count(), 1);
        tell(path, interface, u"ActiveChanged"_s, {false});
        QTest::qWait(50);
        QCOMPARE(locked.count(), 1);
    }

    void lockOfOurSession_andOfNoOther()
    {
        const SessionWatch watch;
        QSignalSpy locked(&watch, &SessionWatch::locked);
        const QString session = u"org.freedesktop.login1.Session"_s;
        // Until the answer about our session has come, nobody listens yet.
        QTRY_VERIFY([&] {
            tell(kOurSession, session, u"Lock"_s, {});
            QTest::qWait(20);
            return locked.count() > 0;
        }());
        const int before = static_cast<int>(locked.count());
        tell(u"/org/freedesktop/login1/session/_99"_s, session, u"Lock"_s, {});
        QTest::qWait(50);
        QCOMPARE(locked.count(), before);
    }

    void sleep_isToldWhenItBegins()
    {
        const SessionWatch watch;
        QSignalSpy suspending(&watch, &SessionWatch::suspending);
        const QString manager = u"org.freedesktop.login1.Manager"_s;
        tell(kLoginPath, manager, u"PrepareForSleep"_s, {true});
        QTRY_COMPARE(suspending.count(), 1);
        tell(kLoginPath, manager, u"PrepareForSleep"_s, {false}); // awake again
        QTest::qWait(50);
        QCOMPARE(suspending.count(), 1);
    }

    void delay_isHeldUntilItIsGivenUp()
    {
        SessionWatch watch;
        m_login.inhibited.clear();
        watch.delaySleep(true);
        QTRY_COMPARE(m_login.inhibited, (QStringList{u"sleep"_s, u"delay"_s}));
        QTest::qWait(100); // the answer reaches it
        watch.delaySleep(false);
        QTRY_VERIFY(isClosed(m_login.ends[0]));
        ::close(m_login.ends[0]);
    }

private:
    void tell(const QString& path, const QString& interface, const QString& name,
              const QVariantList& arguments)
    {
        QDBusMessage signal = QDBusMessage::createSignal(path, interface, name);
        signal.setArguments(arguments);
        QVERIFY(m_bus.send(signal));
    }

    Login m_login;
    QDBusConnection m_bus =
        QDBusConnection::connectToBus(QDBusConnection::SessionBus, u"another program"_s);
};

int main(int argc, char** argv)
{
    QCoreApplication app(argc, argv);
    QProcess daemon;
    daemon.start(u"dbus-daemon"_s, {u"--session"_s, u"--nofork"_s, u"--print-address"_s});
    daemon.waitForReadyRead(5000);
    const QByteArray address = daemon.readLine().trimmed();
    qputenv("DBUS_SESSION_BUS_ADDRESS", address.isEmpty() ? "unix:path=/nonexistent" : address);
    qputenv("DBUS_SYSTEM_BUS_ADDRESS", address.isEmpty() ? "unix:path=/nonexistent" : address);
    TestSessionWatch test;
    const int result = QTest::qExec(&test, argc, argv);
    daemon.kill();
    daemon.waitForFinished();
    return result;
}

#include "tst_sessionwatch.moc"
