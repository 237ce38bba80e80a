// SPDX-License-Identifier: GPL-3.0-or-later
// However a session ends, the motors are told to stop and hear nothing after that. The witness is
// the simulated controller's own record, on a pseudo-terminal, beyond the reach of the host's code.
#include "protocol/codec/packet.h"
#include "protocol/session/controller.h"
#include "protocol/session/linkengine.h"
#include "tests/support/simwitness.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

enum class Exit { Stop, Disarm, Close, Destructor, LostLine };
enum class Traffic { Set, Accelerate, Polls };

} // namespace

class TestExitPaths : public QObject {
    Q_OBJECT

private slots:
    void exit_leavesAllMotorsNeutral_data();
    void exit_leavesAllMotorsNeutral();
    void portTakenWhileLost_isSaidAndStoppedAfterwards();
};

void TestExitPaths::exit_leavesAllMotorsNeutral_data()
{
    QTest::addColumn<int>("exit");
    QTest::addColumn<int>("traffic");
    QTest::addColumn<int>("line");
    constexpr std::array kExits{"stop", "disarm", "close", "destructor", "lost line"};
    constexpr std::array kTraffics{"set", "accelerate", "polls"};
    constexpr std::array kLines{"compact", "pololu", "CRC"};
    for (std::size_t exit = 0; exit < kExits.size(); ++exit) {
        for (std::size_t traffic = 0; traffic < kTraffics.size(); ++traffic) {
            for (std::size_t line = 0; line < kLines.size(); ++line) {
                QTest::addRow("%s, %s, %s", kExits.at(exit), kTraffics.at(traffic), kLines.at(line))
                    << static_cast<int>(exit) << static_cast<int>(traffic)
                    << static_cast<int>(line);
            }
        }
    }
}

void TestExitPaths::exit_leavesAllMotorsNeutral()
{
    QFETCH(int, exit);
    QFETCH(int, traffic);
    QFETCH(int, line);
    const auto way = static_cast<Exit>(exit);
    const bool drives = static_cast<Traffic>(traffic) != Traffic::Polls;

    QTemporaryDir folder;
    const QString log = folder.filePath(u"log.jsonl"_s);
    sim::SimOptions simulated;
    OpenOptions options;
    options.port = folder.filePath(u"port"_s);
    options.line.form = line == 1 ? PacketForm::Pololu : PacketForm::Compact;
    options.line.errorDetection = simulated.errorDetection =
        line == 2 ? ErrorDetection::Crc7 : ErrorDetection::None;
    simulated.parameters[0x0E] = simulated.parameters[0x0F] = simulated.parameters[0x10] = 60;
    test::SimWitness server(simulated, options.port, log);
    QVERIFY(server.isOk());

    auto controller = std::make_unique<Controller>(nullptr, nullptr);
    controller->want(this, PollId::Currents, 80.0);
    controller->want(this, PollId::RawChannels, 50.0);
    controller->open(options);
    QTRY_COMPARE_WITH_TIMEOUT(controller->state(), LinkState::Connected, 5000);
    QVERIFY(controller->arm().has_value());

    // Orders as from a slider that is being dragged; it does not stop when the session ends.
    int orders = 0;
    QTimer hand;
    connect(&hand, &QTimer::timeout, this, [&] {
        if (!controller) {
            return;
        }
        const auto action = static_cast<Traffic>(traffic) == Traffic::Set
            ? MotorOrder::Action::Set
            : MotorOrder::Action::Accelerate;
        const int speed = 60 + ++orders % 60;
        std::ignore = controller->driveMotor(MotorId::Motor1, {action, speed});
        std::ignore = controller->driveMotor(MotorId::Motor2, {action, -speed});
        std::ignore = controller->driveMotor(MotorId::Aux, {action, speed});
        std::ignore = controller->driveBoth({action, speed}, {action, -speed});
    });
    if (drives) {
        hand.start(3);
    }
    QTRY_VERIFY(controller->stats().transactions > 60 && (!drives || orders > 30));

    switch (way) {
    case Exit::Stop:
    case Exit::Disarm: {
        QSignalSpy stopped(controller.get(), &Controller::stopped);
        way == Exit::Stop ? controller->stop() : controller->disarm();
        QTRY_COMPARE(stopped.count(), 1);
        QTest::qWait(100); // the hand goes on, in vain
        controller->wantNothing(this);
        break;
    }
    case Exit::Close:
        controller->close();
        QTRY_COMPARE(controller->state(), LinkState::Disconnected);
        QTest::qWait(100);
        break;
    case Exit::Destructor:
        controller.reset();
        break;
    case Exit::LostLine: {
        QSignalSpy reconnected(controller.get(), &Controller::reconnected);
        server.hangUp(0.4);
        QTRY_COMPARE_WITH_TIMEOUT(reconnected.count(), 1, 6000);
        QTest::qWait(200);
        break;
    }
    }
    hand.stop();
    QTest::qWait(50); // what is on its way arrives
    server.end(); // before the façade: its own close would stop the motors once more
    controller.reset();

    const test::SimRecord record = test::readSimRecord(log);
    QVERIFY(!record.isBad);
    QCOMPARE(record.speeds, (std::array{0, 0, 0}));
    QCOMPARE(record.moved, (std::array{drives, drives, drives}));
    if (way == Exit::LostLine && !drives) {
        QVERIFY2(record.motorPackets.empty(), "nothing moved, nothing needs a stop");
        return;
    }
    const auto stops = stopCommands(false);
    QVERIFY(record.motorPackets.size() >= stops.size());
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const auto& heard =
            record.motorPackets.at(record.motorPackets.size() - stops.size() + i).bytes;
        QCOMPARE(heard, encode(stops.at(i), options.line));
    }
}

/// The adapter was pulled, and another program was quicker when it came back: which is said, and as
/// soon as the port is free again the motors are stopped.
void TestExitPaths::portTakenWhileLost_isSaidAndStoppedAfterwards()
{
    QTemporaryDir folder;
    const QString log = folder.filePath(u"log.jsonl"_s);
    OpenOptions options;
    options.port = folder.filePath(u"port"_s);
    test::SimWitness server({}, options.port, log);
    QVERIFY(server.isOk());
    Controller controller(nullptr, nullptr);
    QSignalSpy reconnected(&controller, &Controller::reconnected);
    controller.open(options);
    QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Connected, 5000);

    int other = -1;
    for (int attempt = 0; attempt < 8 && other < 0; ++attempt) {
        QVERIFY(QTest::qWaitFor([&] { return controller.arm().has_value(); }, 5000));
        QVERIFY(controller.driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 60}));
        const quint64 sent = controller.stats().transactions;
        QTRY_VERIFY(controller.stats().transactions > sent);
        server.hangUp(0.2);
        QTRY_VERIFY_WITH_TIMEOUT(controller.state() != LinkState::Connected, 5000);
        // The controller tries twice a second; whoever looks more often comes first, mostly.
        const QByteArray path = options.port.toLocal8Bit();
        while (other < 0 && controller.state() != LinkState::Connected) {
            other = ::open(path.constData(), O_RDWR | O_NOCTTY | O_NONBLOCK);
            if (other >= 0 && ::flock(other, LOCK_EX | LOCK_NB) != 0) {
                ::close(std::exchange(other, -1));
            }
            QTest::qWait(2);
        }
        QTRY_VERIFY(other >= 0 || controller.state() == LinkState::Connected);
    }
    QVERIFY2(other >= 0, "the port was never ours");
    QTRY_VERIFY_WITH_TIMEOUT(
        controller.lastError() && controller.lastError()->code == ErrorCode::PortBusy, 5000);
    QVERIFY(!controller.isArmed());
    reconnected.clear();
    ::close(other);
    QTRY_COMPARE_WITH_TIMEOUT(reconnected.count(), 1, 6000);
    QTest::qWait(100);
    QVERIFY(!controller.isArmed());
    server.end();
    const test::SimRecord record = test::readSimRecord(log);
    QCOMPARE(record.speeds, (std::array{0, 0, 0}));
    QVERIFY(record.moved.front());
    QCOMPARE(record.motorPackets.back().bytes, encode(stopCommands(false).back(), options.line));
}

QTEST_GUILESS_MAIN(TestExitPaths)
#include "tst_exitpaths.moc"
