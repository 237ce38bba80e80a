// SPDX-License-Identifier: GPL-3.0-or-later
// On a real pseudo-terminal, whose other end the test holds.
#include "protocol/transport/serialtransport.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

class Pty {
public:
    Pty() : m_master(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK))
    {
        ::grantpt(m_master);
        ::unlockpt(m_master);
    }
    ~Pty() { hangUp(); }
    Pty(const Pty&) = delete;
    Pty& operator=(const Pty&) = delete;
    [[nodiscard]] QString name() const { return QString::fromLocal8Bit(::ptsname(m_master)); }
    void say(const QByteArray& bytes) const
    {
        QCOMPARE(::write(m_master, bytes.data(), static_cast<std::size_t>(bytes.size())),
                 bytes.size());
    }
    QByteArray hear()
    {
        std::array<char, 64> chunk{};
        const auto count = ::read(m_master, chunk.data(), chunk.size());
        if (count > 0) {
            m_heard.append(chunk.data(), count);
        }
        return m_heard;
    }
    void hangUp()
    {
        if (m_master >= 0) {
            ::close(std::exchange(m_master, -1));
        }
    }

private:
    int m_master;
    QByteArray m_heard;
};

/// A transport with everything that it has said.
struct Bench {
    explicit Bench(const QString& port) : transport(port)
    {
        QObject::connect(&transport, &Transport::opened, &transport, [this] { ++opened; });
        QObject::connect(&transport, &Transport::received, &transport,
                         [this](const QByteArray& bytes, Instant) { received += bytes; });
        QObject::connect(&transport, &Transport::failed, &transport,
                         [this](const Error& error) { errors.push_back(error); });
    }
    SerialTransport transport;
    int opened = 0;
    QByteArray received;
    std::vector<Error> errors;
};

} // namespace

class TestSerialTransport : public QObject {
    Q_OBJECT

private slots:
    void pty_carriesAllBytesBothWays()
    {
        Pty pty;
        Bench bench(pty.name());
        bench.transport.open({});
        QCOMPARE(bench.opened, 1);
        QByteArray all;
        for (int i = 0; i < 256; ++i) { // XON, XOFF, line ends, NUL: nothing is special
            all.append(static_cast<char>(i));
        }
        bench.transport.write(all);
        QTRY_COMPARE(pty.hear(), all);
        pty.say(all);
        QTRY_COMPARE(bench.received, all);
        QVERIFY(bench.errors.empty());
    }

    void waitForBytes_tellsWhetherSomethingCame()
    {
        Pty pty;
        Bench bench(pty.name());
        bench.transport.open({});
        QVERIFY(!bench.transport.waitForBytes(5ms));
        pty.say("TReX");
        QVERIFY(bench.transport.waitForBytes(1s));
        QCOMPARE(bench.received, QByteArray("TReX"));
    }

    void parityAndStopBits_doNotKeepAPtyFromWorking()
    {
        for (const auto detection : {ErrorDetection::Even, ErrorDetection::Odd}) {
            Pty pty;
            Bench bench(pty.name());
            LineSettings settings;
            settings.errorDetection = detection;
            settings.stopBits = 2;
            settings.baud = 115200;
            bench.transport.open(settings);
            QCOMPARE(bench.opened, 1);
            bench.transport.write("\x01");
            QTRY_COMPARE(pty.hear(), QByteArray("\x01"));
        }
    }

    void notAPort_isRefusedWithItsReason_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<ErrorCode>("code");
        QTest::newRow("missing") << u"missing"_s << ErrorCode::PortMissing;
        QTest::newRow("regular file") << u"file"_s << ErrorCode::PortNotSerial;
        QTest::newRow("directory") << u"folder"_s << ErrorCode::PortNotSerial;
        QTest::newRow("device that is no terminal") << u"/dev/null"_s << ErrorCode::PortNotSerial;
    }
    void notAPort_isRefusedWithItsReason()
    {
        QFETCH(QString, kind);
        QFETCH(ErrorCode, code);
        QTemporaryDir folder;
        QString path = folder.filePath(u"port"_s);
        if (kind == u"file"_s) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("precious");
        } else if (kind == u"folder"_s) {
            path = folder.path();
        } else if (kind.startsWith(u'/')) {
            path = kind;
        }
        Bench bench(path);
        bench.transport.open({});
        QCOMPARE(bench.opened, 0);
        QCOMPARE(bench.errors.size(), std::size_t{1});
        QCOMPARE(bench.errors.front().code, code);
        QCOMPARE(bench.errors.front().context, path);
        if (kind == u"file"_s) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::ReadOnly));
            QCOMPARE(file.readAll(), QByteArray("precious"));
        }
    }

    void portInUse_isBusy()
    {
        Pty pty;
        Bench first(pty.name());
        first.transport.open({});
        QCOMPARE(first.opened, 1);
        Bench second(pty.name());
        second.transport.open({});
        QCOMPARE(second.errors.size(), std::size_t{1}); // also for the superuser
        QCOMPARE(second.errors.front().code, ErrorCode::PortBusy);
        QCOMPARE(second.errors.front().context, pty.name()); // it is us: no other program to name
        first.transport.close();
        second.transport.open({});
        QCOMPARE(second.opened, 1);
    }

    void portLockedByAnother_isBusy()
    {
        Pty pty;
        const int other = ::open(pty.name().toLocal8Bit().constData(), O_RDWR | O_NOCTTY);
        QVERIFY(other >= 0);
        QCOMPARE(::flock(other, LOCK_EX | LOCK_NB), 0);
        Bench bench(pty.name());
        bench.transport.open({});
        QCOMPARE(bench.opened, 0);
        QCOMPARE(bench.errors.size(), std::size_t{1});
        QCOMPARE(bench.errors.front().code, ErrorCode::PortBusy);
        ::close(other);
        bench.transport.open({});
        QCOMPARE(bench.opened, 1);
    }

    void holder_isNamedWhereTheSystemTells()
    {
        QTemporaryDir folder;
        const auto make = [&folder](const QString& process, const QString& name,
                                    const QString& target) {
            QVERIFY(QDir(folder.path()).mkpath(process + u"/fd"_s));
            QFile comm(folder.filePath(process + u"/comm"_s));
            QVERIFY(comm.open(QIODevice::WriteOnly));
            comm.write(name.toUtf8() + '\n');
            QVERIFY(QFile::link(target, folder.filePath(process + u"/fd/7"_s)));
        };
        make(u"77"_s, u"bash"_s, u"/dev/pts/0"_s);
        make(u"4711"_s, u"mini com"_s, u"/dev/ttyUSB9"_s);
        make(u"self"_s, u"us"_s, u"/dev/ttyUSB9"_s);
        make(QString::number(QCoreApplication::applicationPid()), u"us"_s, u"/dev/ttyUSB9"_s);
        QCOMPARE(portHolder(u"/dev/ttyUSB9"_s, folder.path()), u"mini com, process 4711"_s);
        QVERIFY(portHolder(u"/dev/ttyUSB8"_s, folder.path()).isEmpty());
        QVERIFY(portHolder(u"/dev/ttyUSB9"_s, folder.filePath(u"none"_s)).isEmpty());
    }

    void adapter_isReadFromTheSystem()
    {
        QTemporaryDir folder;
        const QString tty = u"class/tty/ttyUSB9/device"_s;
        const QString usb = u"bus/usb-serial/devices/ttyUSB9"_s;
        QVERIFY(QDir(folder.path()).mkpath(tty));
        QVERIFY(QDir(folder.path()).mkpath(usb));
        QVERIFY(QDir(folder.path()).mkpath(u"drivers/ftdi_sio"_s));
        QVERIFY(
            QFile::link(u"../../../../drivers/ftdi_sio"_s, folder.filePath(tty + u"/driver"_s)));
        AdapterFacts facts = readAdapterFacts(u"/dev/ttyUSB9"_s, folder.path());
        QCOMPARE(facts.driver, u"ftdi_sio"_s);
        QCOMPARE(facts.port, u"ttyUSB9"_s);
        QVERIFY(!facts.latencyTimerMs); // not every driver has one
        QVERIFY(facts.timerFile.isEmpty());
        QFile timer(folder.filePath(usb + u"/latency_timer"_s));
        QVERIFY(timer.open(QIODevice::WriteOnly));
        timer.write("16\n");
        timer.close();
        facts = readAdapterFacts(u"/dev/ttyUSB9"_s, folder.path());
        QCOMPARE(facts.latencyTimerMs, std::optional(16));
        QCOMPARE(facts.timerFile, timer.fileName());
        QVERIFY(timer.open(QIODevice::WriteOnly));
        timer.write("soon\n");
        timer.close();
        QVERIFY(!readAdapterFacts(u"/dev/ttyUSB9"_s, folder.path()).latencyTimerMs);
        facts = readAdapterFacts(u"/dev/ttyS77"_s, folder.path());
        QCOMPARE(facts.kind, AdapterFacts::Kind::Serial);
        QVERIFY(facts.driver.isEmpty());
    }

    void pty_hasNothingToAskFor()
    {
        Pty pty;
        Bench bench(pty.name());
        bench.transport.open({});
        QCOMPARE(bench.transport.adapter().kind, AdapterFacts::Kind::PseudoTerminal);
        QCOMPARE(bench.transport.adapter().lowLatency, AdapterFacts::LowLatency::NotAsked);
    }

    void hiddenPort_isDenied() // a folder that we may not look into hides it
    {
        if (::geteuid() == 0) {
            QSKIP("the superuser may look into every folder");
        }
        QTemporaryDir folder;
        QVERIFY(QFile::setPermissions(folder.path(), QFileDevice::Permissions()));
        Bench bench(folder.filePath(u"port"_s));
        bench.transport.open({});
        QFile::setPermissions(folder.path(),
                              QFileDevice::ReadOwner | QFileDevice::WriteOwner
                                  | QFileDevice::ExeOwner);
        QCOMPARE(bench.errors.front().code, ErrorCode::PortDenied);
    }

    void hangUp_isALostLine_andAnotherCanBeOpened()
    {
        QTemporaryDir folder;
        const QString link = folder.filePath(u"port"_s);
        auto pty = std::make_unique<Pty>();
        QVERIFY(QFile::link(pty->name(), link));
        Bench bench(link);
        bench.transport.open({});
        QCOMPARE(bench.opened, 1);
        pty->hangUp();
        QTRY_COMPARE(bench.errors.size(), std::size_t{1});
        QCOMPARE(bench.errors.front().code, ErrorCode::LineLost);
        bench.transport.write("\x81"); // goes nowhere, harms nothing
        QVERIFY(QFile::remove(link));
        Pty next;
        QVERIFY(QFile::link(next.name(), link));
        bench.transport.open({}); // before the event loop has come round
        QTRY_COMPARE(bench.opened, 2);
        QTest::qWait(20);
        bench.transport.write("\x81");
        QTRY_COMPARE(next.hear(), QByteArray("\x81"));
        QCOMPARE(bench.errors.size(), std::size_t{1});
    }

    void hangUpWhileWaiting_isALostLine()
    {
        Pty pty;
        Bench bench(pty.name());
        bench.transport.open({});
        pty.hangUp();
        for (int i = 0; i < 50 && bench.errors.empty(); ++i) {
            bench.transport.waitForBytes(20ms);
        }
        QCOMPARE(bench.errors.size(), std::size_t{1});
        QCOMPARE(bench.errors.front().code, ErrorCode::LineLost);
    }
};

QTEST_GUILESS_MAIN(TestSerialTransport)
#include "tst_serialtransport.moc"
