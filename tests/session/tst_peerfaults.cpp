// SPDX-License-Identifier: GPL-3.0-or-later
// What a peer on the network can do to a connection whose motors run, with the whole link above and
// the simulated controller's own record as witness: the link says that it is bad, comes back by
// itself, what it says first is stop, and nothing is armed again.
#include "protocol/codec/packet.h"
#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "protocol/session/floodguard.h"
#include "protocol/session/linkengine.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/middleman.h"
#include "tests/support/simwitness.h"

#include <QElapsedTimer>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <ctime>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

using Way = test::Middleman::Way;

/// Resident memory of this process, in MiB.
double residentMiB()
{
    QFile file(u"/proc/self/statm"_s);
    if (!file.open(QIODevice::ReadOnly)) {
        return 0.0;
    }
    constexpr double kPagesPerMiB = 256.0;
    return file.readAll().split(' ').value(1).toDouble() / kPagesPerMiB;
}

double epochMs()
{
    return static_cast<double>(QDateTime::currentMSecsSinceEpoch());
}

} // namespace

class TestPeerFaults : public QObject {
    Q_OBJECT

private slots:
    void peer_failsWhileMotorsRun_data();
    void peer_failsWhileMotorsRun();
    void slowPeer_isStoppedAndTellsNothingWrong();
    void rubbish_leavesTheProgramItsTimeAndMemory();
    void mutePeer_isToldAndClosedInTime();
    void nameThatResolvesToNothing_isAMissingPort();
    void flood_isTold();
};

void TestPeerFaults::peer_failsWhileMotorsRun_data()
{
    QTest::addColumn<int>("way");
    QTest::newRow("torn off") << static_cast<int>(Way::Reset);
    QTest::newRow("closed") << static_cast<int>(Way::Finish);
    QTest::newRow("silent") << static_cast<int>(Way::Silent);
    QTest::newRow("rubbish") << static_cast<int>(Way::Rubbish);
    QTest::newRow("rubbish once") << static_cast<int>(Way::RubbishOnce);
}

void TestPeerFaults::peer_failsWhileMotorsRun()
{
    QFETCH(int, way);
    QTemporaryDir folder;
    const QString log = folder.filePath(u"log.jsonl"_s);
    sim::SimOptions simulated;
    simulated.pace = true;
    test::SimWitness witness(simulated, 0, log);
    QVERIFY(witness.isOk());
    test::Middleman peer(witness.tcpPort());

    Controller controller(nullptr, nullptr);
    controller.want(this, PollId::Currents, 80.0);
    controller.want(this, PollId::Mode, 2.0);
    OpenOptions options;
    options.port = u"tcp://127.0.0.1:%1"_s.arg(peer.port());
    controller.open(options);
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Connected, 10'000);
    QVERIFY(controller.arm().has_value());
    QVERIFY(controller.driveBoth({MotorOrder::Action::Set, 60}, {MotorOrder::Action::Set, -60}));
    QVERIFY(controller.driveMotor(MotorId::Aux, {MotorOrder::Action::Set, 30}));
    const quint64 before = controller.stats().transactions;
    QTRY_VERIFY(controller.stats().transactions > before + 20);

    QSignalSpy reconnected(&controller, &Controller::reconnected);
    peer.be(static_cast<Way>(way));
    QTRY_VERIFY_WITH_TIMEOUT(controller.state() != LinkState::Connected, 10'000);
    QVERIFY(!controller.isArmed());
    QVERIFY(controller.lastError().has_value());
    QTest::qWait(600); // tried again in vain meanwhile
    QVERIFY(controller.state() != LinkState::Connected);
    QVERIFY(!controller.driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 90}));
    QVERIFY(!controller.arm());

    const double returned = epochMs();
    QElapsedTimer clock;
    clock.start();
    peer.be(Way::Pass);
    QTRY_COMPARE_WITH_TIMEOUT(reconnected.count(), 1, 15'000);
    qInfo("back after %lld ms", static_cast<long long>(clock.elapsed()));
    QVERIFY2(clock.elapsed() < 4000, "two seconds, and as much again for a loaded computer");
    QTest::qWait(300);
    QVERIFY(!controller.isArmed());
    witness.end(); // before the façade: its own close would stop the motors once more

    const test::SimRecord record = test::readSimRecord(log);
    QCOMPARE(record.speeds, (std::array{0, 0, 0}));
    QCOMPARE(record.moved, (std::array{true, true, true}));
    // What is heard of us once the peer is back begins with stop, and holds nothing else.
    const auto stops = stopCommands(false);
    std::size_t later = 0;
    for (const auto& packet : record.motorPackets) {
        if (packet.epochMs > returned) {
            QCOMPARE(packet.bytes, encode(stops.at(later++ % stops.size()), options.line));
        }
    }
    QVERIFY(later >= stops.size());
    // Motors' orders between the fault and the return: none but stop, where anything passed.
    QVERIFY(record.lastMovedMs < returned);
    const auto isEarlyStop = [&](const auto& packet) {
        return packet.epochMs < returned && packet.bytes == encode(stops.front(), options.line);
    };
    if (static_cast<Way>(way) == Way::RubbishOnce) { // it still hears us: stopped before it is left
        QVERIFY(std::any_of(record.motorPackets.begin(), record.motorPackets.end(), isEarlyStop));
    }
}

/// A byte in 200 ms: answers of one byte come in time, longer ones never do. The connection stands,
/// what it cannot carry is counted, and a stop is heard at once.
void TestPeerFaults::slowPeer_isStoppedAndTellsNothingWrong()
{
    QTemporaryDir folder;
    const QString log = folder.filePath(u"log.jsonl"_s);
    sim::SimOptions simulated;
    simulated.pace = true;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        simulated.scenario.channels.push_back(
            {.channel = channel, .wave = sim::Wave::Hold, .minimum = 3750, .maximum = 3750});
    }
    test::SimWitness witness(simulated, 0, log);
    QVERIFY(witness.isOk());
    test::Middleman peer(witness.tcpPort());
    TelemetryStore store;
    Controller controller(&store, nullptr);
    controller.want(this, PollId::RawChannels, 50.0); // ten bytes: about 3750 each
    controller.want(this, PollId::Mode, 5.0);
    OpenOptions options;
    options.port = u"tcp://127.0.0.1:%1"_s.arg(peer.port());
    controller.open(options);
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Connected, 10'000);
    QTRY_VERIFY(store.latest(PollId::RawChannels) != nullptr);
    const auto isAtRest = [](std::uint16_t raw) { return raw > 3600 && raw < 3900; };
    QVERIFY(controller.arm().has_value());
    QVERIFY(controller.driveBoth({MotorOrder::Action::Set, 60}, {MotorOrder::Action::Set, -60}));
    bool isWrong = false;
    connect(&controller, &Controller::deviceChanged, this, [&] {
        const auto mode = controller.device().mode;
        isWrong = isWrong || (mode && *mode != Mode::SerialRc);
    });
    connect(&controller, &Controller::batchArrived, this, [&] {
        const PollSample* sample = store.latest(PollId::RawChannels);
        isWrong = isWrong
            || (sample != nullptr
                && !std::all_of(sample->raw.begin(), sample->raw.end(), isAtRest));
    });
    peer.be(Way::Slow);
    QTest::qWait(2000);
    QVERIFY(!isWrong);
    QVERIFY(controller.health().total.shortReplies + controller.health().total.timeouts > 2);
    QSignalSpy stopped(&controller, &Controller::stopped);
    QElapsedTimer clock;
    clock.start();
    controller.stop();
    QTRY_COMPARE_WITH_TIMEOUT(stopped.count(), 1, 5000);
    qInfo("stop after %lld ms", static_cast<long long>(clock.elapsed()));
    QVERIFY(!controller.isArmed());
    peer.be(Way::Pass);
    const auto isFresh = [&] {
        const PollSample* sample = store.latest(PollId::RawChannels);
        return controller.state() == LinkState::Connected && sample != nullptr
            && std::chrono::steady_clock::now() - sample->time < 100ms;
    };
    QTRY_VERIFY_WITH_TIMEOUT(isFresh(), 15'000);
    QVERIFY(!isWrong);
    QVERIFY(!controller.isArmed());
    witness.end();
    const test::SimRecord record = test::readSimRecord(log);
    QCOMPARE(record.speeds, (std::array{0, 0, 0}));
    QVERIFY(record.moved[0] && record.moved[1]);
}

void TestPeerFaults::rubbish_leavesTheProgramItsTimeAndMemory()
{
    test::SimWitness witness({}, 0, QString());
    QVERIFY(witness.isOk());
    test::Middleman peer(witness.tcpPort());
    TelemetryStore store;
    Controller controller(&store, nullptr);
    controller.want(this, PollId::Currents, 80.0);
    OpenOptions options;
    options.port = u"tcp://127.0.0.1:%1"_s.arg(peer.port());
    controller.open(options);
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Connected, 10'000);

    qsizetype recorded = 0;
    connect(&controller, &Controller::recordsArrived, this,
            [&](const std::vector<TransactionRecord>& records) {
                for (const TransactionRecord& record : records) {
                    recorded += record.receivedBytes.size();
                }
            });
    peer.be(Way::Rubbish);
    QTRY_VERIFY_WITH_TIMEOUT(controller.state() != LinkState::Connected, 10'000);
    const double start = residentMiB();
    const std::clock_t used = std::clock(); // of all threads
    int ticks = 0;
    QTimer ticker;
    connect(&ticker, &QTimer::timeout, this, [&ticks] { ++ticks; });
    ticker.start(5);
    QTest::qWait(1500);
    QVERIFY2(ticks > 12, qPrintable(QString::number(ticks))); // the window would have been served
    QVERIFY(controller.state() != LinkState::Connected);
    QCOMPARE(controller.lastError()->code, ErrorCode::Garbage);
    QVERIFY(errorText(*controller.lastError()).contains(u"tcp://"_s));
    const double grown = residentMiB() - start;
    qInfo("%.1f MiB, %.2f s of processor, %.1f MB taken, %lld bytes recorded", grown,
          static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC,
          static_cast<double>(peer.poured()) / 1e6, static_cast<long long>(recorded));
    QVERIFY2(grown < 40.0, qPrintable(QString::number(grown)));
    QVERIFY(recorded < 1'000'000);
    // What we took of it is bounded: a flood is cut off, and asked again twice a second.
    QVERIFY2(peer.poured() < 64'000'000, qPrintable(QString::number(peer.poured())));
    peer.be(Way::Pass);
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Connected, 15'000);
}

void TestPeerFaults::mutePeer_isToldAndClosedInTime()
{
    QTcpServer server; // accepts, and never answers
    QVERIFY(server.listen(QHostAddress::LocalHost));
    Controller controller(nullptr, nullptr);
    OpenOptions options;
    options.port = u"tcp://127.0.0.1:%1"_s.arg(server.serverPort());
    controller.open(options);
    QTRY_VERIFY_WITH_TIMEOUT(controller.lastError().has_value(), 10'000);
    QCOMPARE(controller.lastError()->code, ErrorCode::NoReply);
    QCOMPARE(controller.state(), LinkState::Retrying);
    QVERIFY(!controller.arm());
    QSignalSpy closed(&controller, &Controller::closed);
    controller.close();
    QTRY_COMPARE_WITH_TIMEOUT(closed.count(), 1, 5000);
    // A line that never answered hears no order, and no stop either (it may have another speed).
    QVERIFY(server.hasPendingConnections());
    const QByteArray heard = server.nextPendingConnection()->readAll();
    for (const Command& command : stopCommands(false)) {
        QVERIFY(!heard.contains(encode(command, options.line)));
    }
}

void TestPeerFaults::nameThatResolvesToNothing_isAMissingPort()
{
    Controller controller(nullptr, nullptr);
    OpenOptions options;
    options.port = u"tcp://no-such-host.invalid:4000"_s;
    controller.open(options);
    QTRY_VERIFY_WITH_TIMEOUT(controller.lastError().has_value(), 15'000);
    QCOMPARE(controller.lastError()->code, ErrorCode::PortMissing);
    QVERIFY(errorText(*controller.lastError()).contains(u"no-such-host.invalid"_s));
    QSignalSpy closed(&controller, &Controller::closed);
    controller.close();
    QTRY_COMPARE_WITH_TIMEOUT(closed.count(), 1, 5000);
}

void TestPeerFaults::flood_isTold()
{
    FloodGuard guard;
    const Instant start{1h};
    // The fastest line of all, for a minute, in chunks as they come.
    for (int i = 0; i < 60'000; ++i) {
        QVERIFY(!guard.isTooMuch(12, start + i * 1ms));
    }
    QVERIFY(!guard.isTooMuch(FloodGuard::kMostBytes, start + 70s)); // what a server had kept
    QVERIFY(guard.isTooMuch(1, start + 70s + 999ms));
    QVERIFY(!guard.isTooMuch(1, start + 71s + 1ms));
}

QTEST_GUILESS_MAIN(TestPeerFaults)
#include "tst_peerfaults.moc"
