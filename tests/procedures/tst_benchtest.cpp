// SPDX-License-Identifier: GPL-3.0-or-later
// A bench test through the real façade and its thread: however it ends, the last thing that the
// motors hear is stop. The witness is the simulated controller's own record on a pseudo-terminal.
#include "protocol/procedures/benchtest.h"
#include "protocol/sim/simserver.h"
#include "protocol/telemetry/statuslatch.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

/// A simulated controller on a thread of its own, as another program would be.
class Server : public QThread {
public:
    Server(sim::SimOptions options, QString link, QString log)
        : m_options(std::move(options)), m_link(std::move(link)), m_log(std::move(log))
    {
        start();
        m_started.acquire();
    }
    ~Server() override { end(); }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    [[nodiscard]] bool isOk() const { return m_server != nullptr; }
    template <class Change>
    void change(Change change)
    {
        QMetaObject::invokeMethod(m_server, [server = m_server, change] { change(*server); });
    }
    void end() ///< the log is complete after this
    {
        quit();
        wait();
    }

protected:
    void run() override
    {
        sim::SimServer server(m_options);
        if (server.setLogFile(m_log).has_value() && server.listenPty(m_link).has_value()) {
            m_server = &server;
        }
        m_started.release();
        exec();
    }

private:
    sim::SimOptions m_options;
    QString m_link;
    QString m_log;
    QSemaphore m_started;
    sim::SimServer* m_server = nullptr; ///< on its own thread
};

struct Record {
    std::array<int, 3> speeds{}; ///< last output of each motor
    std::array<bool, 3> moved{};
    QStringList motorPackets; ///< in hex
};

Record readRecord(const QString& path)
{
    Record record;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return record;
    }
    while (!file.atEnd()) {
        const QJsonObject entry = QJsonDocument::fromJson(file.readLine()).object();
        if (entry[u"event"] == u"output"_s) {
            const auto motor = static_cast<std::size_t>(entry[u"motor"].toInt() - 1);
            record.speeds.at(motor) = entry[u"speed"].toInt();
            record.moved.at(motor) = record.moved.at(motor) || entry[u"speed"].toInt() != 0;
        } else if (entry[u"kind"] == u"motor"_s) {
            record.motorPackets << entry[u"bytes"].toString().toUpper();
        }
    }
    return record;
}

BenchProfile profileOf(const QByteArray& steps, const QByteArray& more = {})
{
    const auto profile =
        parseBenchProfile(R"({"format":"trexpanel-bench-profile","version":1,"name":"Test",)" + more
                              + R"("steps":[)" + steps + "]}",
                          u"test"_s);
    if (!profile) {
        qFatal("%s", qPrintable(profile.error().context));
    }
    return *profile;
}

/// A machine under load may keep readings back for a while; only one test is about that.
constexpr auto kPatient = R"("limits":{"staleSeconds":5},)";

/// All three motors run, for as long as nothing ends it.
BenchProfile longRun(const QByteArray& more = {})
{
    return profileOf(R"({"do":"set","motor":"aux","speed":40},
        {"do":"sine","middle":50,"amplitude":20,"period":0.5,"seconds":60})",
                     more);
}

class Bed {
public:
    explicit Bed(const sim::SimOptions& options = {})
        : server(options, folder.filePath(u"port"_s), log())
    {
    }
    [[nodiscard]] QString log() const { return folder.filePath(u"log"_s); }
    [[nodiscard]] bool connect()
    {
        OpenOptions options;
        options.port = folder.filePath(u"port"_s);
        controller->open(options);
        return server.isOk() && QTest::qWaitFor([this] {
                   return controller->state() == LinkState::Connected && controller->device().mode;
               });
    }
    [[nodiscard]] Record finish()
    {
        controller.reset();
        server.end();
        return readRecord(log());
    }
    QTemporaryDir folder;
    Server server;
    StatusLatch latch;
    std::unique_ptr<Controller> controller = std::make_unique<Controller>(nullptr, &latch);
};

enum class Way {
    End,
    Limit,
    Stop,
    Disarm,
    Cancel,
    Destroyed,
    Close,
    Fault,
    Override,
    Silence,
    HangUp
};

} // namespace

class TestBenchTest : public QObject {
    Q_OBJECT

private slots:
    void everyWayOut_stopsAllMotors_data();
    void everyWayOut_stopsAllMotors();
    void notInControl_movesNothing();
    void notConnected_isAnError();
    void afterStop_isLockedOut();
    void readings_areKeptWithTheirTimes();
};

void TestBenchTest::everyWayOut_stopsAllMotors_data()
{
    QTest::addColumn<int>("way");
    QTest::addColumn<int>("end");
    const auto row = [](const char* name, Way way, BenchEnd end) {
        QTest::newRow(name) << int(way) << int(end);
    };
    row("its end", Way::End, BenchEnd::Completed);
    row("a limit", Way::Limit, BenchEnd::Limit);
    row("STOP", Way::Stop, BenchEnd::Stopped);
    row("disarmed", Way::Disarm, BenchEnd::Stopped);
    row("cancelled", Way::Cancel, BenchEnd::Stopped);
    row("destroyed", Way::Destroyed, BenchEnd::Stopped);
    row("disconnected", Way::Close, BenchEnd::Stopped);
    row("a driver fault", Way::Fault, BenchEnd::Limit);
    row("serial override ends", Way::Override, BenchEnd::NotInControl);
    row("a silent controller", Way::Silence, BenchEnd::Stale);
    row("a lost line", Way::HangUp, BenchEnd::LinkLost);
}

void TestBenchTest::everyWayOut_stopsAllMotors()
{
    QFETCH(int, way);
    QFETCH(int, end);
    Bed bed;
    QVERIFY(bed.connect());
    const BenchProfile profile = Way(way) == Way::End
        ? profileOf(R"({"do":"set","motor":"aux","speed":40},{"do":"set","speed":50},
                       {"do":"hold","seconds":0.3})",
                    kPatient)
        : longRun(Way(way) == Way::Silence     ? ""
                      : Way(way) == Way::Limit ? R"("limits":{"seconds":0.4,"staleSeconds":5},)"
                                               : kPatient);
    auto test = std::make_unique<BenchTest>(*bed.controller, profile);
    QSignalSpy finished(test.get(), &Procedure::finished);
    QVERIFY(!bed.controller->isArmed());
    test->start();
    QVERIFY(QTest::qWaitFor([&] { return test->run().seconds() > 0.2 || !finished.isEmpty(); }));
    switch (Way(way)) {
    case Way::End:
    case Way::Limit:
        break;
    case Way::Stop:
        bed.controller->stop();
        break;
    case Way::Disarm:
        bed.controller->disarm();
        break;
    case Way::Cancel:
        test->cancel();
        break;
    case Way::Destroyed:
        test.reset();
        QVERIFY(!bed.controller->isArmed());
        break;
    case Way::Close:
        bed.controller->close();
        break;
    case Way::Fault:
        bed.server.change([](sim::SimServer& s) { s.line().device().setDriverFault(2, true); });
        break;
    case Way::Override:
        bed.server.change([](sim::SimServer& s) { s.line().setMode(sim::JumperMode::Rc); });
        break;
    case Way::Silence:
    case Way::HangUp:
        bed.server.change([way](sim::SimServer& s) {
            sim::Faults faults;
            (Way(way) == Way::Silence ? faults.silentFor : faults.hangupFor) = 1.2;
            s.line().setFaults(faults, s.virtualNow());
        });
        break;
    }
    if (test) {
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, 20'000);
        const BenchEnding ending = test->run().ending();
        // A line that is closed or silent may be noticed as either.
        const bool isEither = Way(way) == Way::Close || Way(way) == Way::Silence;
        QVERIFY2(int(ending.end) == end || (isEither && ending.end == BenchEnd::LinkLost),
                 qPrintable(ending.reason));
        QVERIFY(!test->isRunning());
        if (Way(way) == Way::Override) {
            bed.server.change([](sim::SimServer& s) { s.line().setMode(sim::JumperMode::Serial); });
        }
    }
    QTRY_VERIFY(!bed.controller->isArmed());
    if (Way(way) == Way::Silence || Way(way) == Way::HangUp) {
        QVERIFY(QTest::qWaitFor([&] { return bed.controller->state() == LinkState::Connected; },
                                20'000));
    }
    QTest::qWait(100); // whatever were still to come would come now
    const Record record = bed.finish();
    const bool hasMoved = record.moved[0] && record.moved[1] && record.moved[2];
    QVERIFY(hasMoved);
    QCOMPARE(record.speeds, (std::array{0, 0, 0}));
    QVERIFY(record.motorPackets.size() > 2);
    const QString last = record.motorPackets.last();
    const QString before = record.motorPackets.at(record.motorPackets.size() - 2);
    QVERIFY2(last == u"F000"_s && before.startsWith(u'D') && before.endsWith(u"0000"_s),
             qPrintable(before + u' ' + last));
}

void TestBenchTest::notInControl_movesNothing()
{
    sim::SimOptions options;
    options.mode = sim::JumperMode::Rc; // an order would wait there until override begins
    Bed bed(options);
    QVERIFY(bed.connect());
    BenchTest test(*bed.controller, longRun());
    QSignalSpy finished(&test, &Procedure::finished);
    test.start();
    QTRY_COMPARE(finished.size(), 1);
    QCOMPARE(test.run().ending().end, BenchEnd::NotInControl);
    QVERIFY(!test.run().hasStarted());
    const Record record = bed.finish();
    for (const QString& packet : record.motorPackets) {
        QVERIFY2(packet.endsWith(u"00"_s), qPrintable(packet));
    }
}

void TestBenchTest::notConnected_isAnError()
{
    Controller controller(nullptr, nullptr);
    BenchTest test(controller, longRun());
    QSignalSpy finished(&test, &Procedure::finished);
    test.start();
    QCOMPARE(finished.size(), 1);
    QCOMPARE(finished.first().first().value<Result<void>>().error().code, ErrorCode::NotConnected);
    QVERIFY(!test.isRunning());
}

void TestBenchTest::afterStop_isLockedOut()
{
    Bed bed;
    QVERIFY(bed.connect());
    bed.controller->stop();
    BenchTest test(*bed.controller, longRun());
    QSignalSpy finished(&test, &Procedure::finished);
    test.start();
    QCOMPARE(finished.size(), 1);
    QCOMPARE(finished.first().first().value<Result<void>>().error().code, ErrorCode::LockedOut);
    const Record record = bed.finish();
    QVERIFY(!record.moved[0]);
}

void TestBenchTest::readings_areKeptWithTheirTimes()
{
    Bed bed;
    QVERIFY(bed.connect());
    BenchTest test(
        *bed.controller,
        profileOf(R"({"do":"set","motor":"1","speed":100},{"do":"hold","seconds":1})", kPatient));
    QSignalSpy finished(&test, &Procedure::finished);
    test.start();
    QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, 20'000);
    QCOMPARE(test.run().ending().end, BenchEnd::Completed);
    const BenchTrace& trace = test.run().trace();
    QVERIFY2(trace.samples.size() > 10, qPrintable(QString::number(trace.samples.size())));
    int highest = 0;
    for (std::size_t i = 0; i < trace.samples.size(); ++i) {
        QVERIFY(i == 0 || trace.samples[i].tick > trace.samples[i - 1].tick);
        highest = std::max<int>(highest, trace.samples[i].raw[0]);
        QCOMPARE(int(trace.samples[i].raw[1]), 0);
    }
    QVERIFY(highest > 20); // it had to start: more than 0.8 A
    QVERIFY(trace.seconds >= 1.0);
}

QTEST_GUILESS_MAIN(TestBenchTest)
#include "tst_benchtest.moc"
