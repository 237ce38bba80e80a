// SPDX-License-Identifier: GPL-3.0-or-later
// The motor gate of the façade, with its real threads, as the line sees it: what closes it, that it
// stays closed, and what the motion limits make of an order.
#include "protocol/codec/packet.h"
#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "protocol/session/linkworker.h"
#include "protocol/session/restartwatch.h"
#include "protocol/session/serialtimeoutwatch.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr MotorOrder kHalf{MotorOrder::Action::Set, 64};

class Bench {
public:
    Bench() : controller(&store, &latch), settings(controller)
    {
        QObject::connect(&controller, &Controller::recordsArrived, &context,
                         [this](const std::vector<TransactionRecord>& arrived) {
                             for (const TransactionRecord& record : arrived) {
                                 if (!record.isRaw
                                     && record.command.row().kind == CommandKind::Motor) {
                                     motorPackets.append(record.sentBytes);
                                 }
                             }
                         });
        QObject::connect(&controller, &Controller::eventLogged, &context,
                         [this](int, const QString& text) { log.append(text); });
    }
    /// With a scenario of these events, if any.
    [[nodiscard]] bool connected(const QByteArray& events = {}, const QString& more = {})
    {
        OpenOptions options;
        options.port = u"sim:?seed=1"_s + more;
        if (!events.isEmpty()) {
            QFile file(folder.filePath(u"scenario.json"_s));
            if (!file.open(QIODevice::WriteOnly)
                || file.write("{\"events\":[" + events + "]}") < 0) {
                return false;
            }
            options.port += u"&scenario="_s + file.fileName();
        }
        controller.open(options);
        return QTest::qWaitFor([this] { return controller.state() == LinkState::Connected; }, 5000);
    }
    /// Armed, with both motors and the auxiliary one running.
    [[nodiscard]] bool driving()
    {
        return controller.arm().has_value() && controller.driveBoth(kHalf, kHalf).has_value()
            && controller.driveMotor(MotorId::Aux, kHalf).has_value()
            && QTest::qWaitFor([this] { return motorPackets.size() >= 2; }, 5000);
    }
    [[nodiscard]] bool endsInStop() const
    {
        return motorPackets.size() >= 2 && motorPackets.last(2) == kStop;
    }

    inline static const QByteArrayList kStop{QByteArray::fromHex("da0000"),
                                             QByteArray::fromHex("f000")};
    QObject context;
    QTemporaryDir folder;
    TelemetryStore store;
    StatusLatch latch;
    QByteArrayList motorPackets;
    QStringList log;
    Controller controller;
    DeviceSettings settings;
};

ErrorCode codeOf(const Result<void>& result)
{
    return result ? ErrorCode::Cancelled : result.error().code;
}

} // namespace

class TestGate : public QObject {
    Q_OBJECT

private slots:
    void fault_disarmsStopsAndSaysSo_data()
    {
        QTest::addColumn<QByteArray>("events");
        QTest::addColumn<int>("reason");
        QTest::newRow("motor fault") << QByteArray(R"({"t":0.5,"set":{"fault2":true}})")
                                     << static_cast<int>(DisarmReason::MotorFault);
        QTest::newRow("over current") << QByteArray(
            R"({"t":0.5,"set":{"stall1":true,"parameter":{"motor1-current-limit":10}}})")
                                      << static_cast<int>(DisarmReason::OverCurrent);
    }

    void fault_disarmsStopsAndSaysSo()
    {
        QFETCH(QByteArray, events);
        QFETCH(int, reason);
        Bench bench;
        bench.controller.setDisarmRules({true, true, true, true, {}});
        QVERIFY(bench.connected(events));
        QVERIFY(bench.driving());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.controller.isArmed(), 10'000);
        QCOMPARE(static_cast<int>(bench.controller.gate().lastDisarming().reason), reason);
        QTRY_VERIFY(bench.endsInStop());
        QVERIFY2(!bench.log.filter(disarmText(static_cast<DisarmReason>(reason))).isEmpty(),
                 qPrintable(bench.log.join(u'\n')));
        // Never armed again by itself, and nothing passes.
        const auto count = bench.motorPackets.size();
        QCOMPARE(codeOf(bench.controller.driveMotor(MotorId::Motor1, kHalf)), ErrorCode::LockedOut);
        QTRY_COMPARE(codeOf(bench.controller.driveMotor(MotorId::Motor1, kHalf)),
                     ErrorCode::Disarmed);
        QCOMPARE(bench.motorPackets.size(), count);
    }

    void fault_ofNoConcern_doesNotDisarm()
    {
        Bench bench;
        bench.controller.setDisarmRules({false, false, false, false, {}});
        QVERIFY(bench.connected(R"({"t":0.5,"set":{"fault2":true}})"));
        QVERIFY(bench.driving());
        QTRY_VERIFY_WITH_TIMEOUT(bench.latch.entry(StatusLatch::Byte::Status, 6).count > 3, 10'000);
        QVERIFY(bench.controller.isArmed());
    }

    void idle_disarms()
    {
        Bench bench;
        bench.controller.setDisarmRules({.idle = 1s});
        QVERIFY(bench.connected());
        QVERIFY(bench.controller.arm().has_value());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.controller.isArmed(), 10'000);
        QCOMPARE(bench.controller.gate().lastDisarming().reason, DisarmReason::Idle);
    }

    void otherReasons_areKept()
    {
        Bench bench;
        QVERIFY(bench.connected());
        bench.controller.disarm(DisarmReason::SessionLocked);
        QVERIFY2(bench.motorPackets.isEmpty(), "not armed: nothing to stop");
        QVERIFY(bench.driving());
        bench.controller.disarm(DisarmReason::SessionLocked);
        QVERIFY(!bench.controller.isArmed());
        QCOMPARE(bench.controller.gate().lastDisarming().reason, DisarmReason::SessionLocked);
        QTRY_VERIFY(bench.endsInStop());
    }

    void frozenProgram_isStoppedByTheLinkThread()
    {
        Bench bench;
        QVERIFY(bench.connected());
        QVERIFY(bench.driving());
        // What a hanging program looks like: its main thread does nothing for a while.
        QThread::sleep(4);
        QVERIFY(bench.controller.isArmed()); // this thread has not heard of it yet
        std::ignore = bench.controller.driveMotor(MotorId::Motor1, kHalf); // asked before it does
        QTRY_VERIFY(!bench.controller.isArmed());
        QCOMPARE(bench.controller.gate().lastDisarming().reason, DisarmReason::Frozen);
        QTest::qWait(50);
        QVERIFY(bench.endsInStop());
        QCOMPARE(bench.motorPackets.count(encode(*driveMotor(MotorId::Motor1, kHalf), {})), 0);
    }

    void stop_isToldWhenItsRecordsAreThere()
    {
        Bench bench;
        QVERIFY(bench.connected());
        QVERIFY(bench.driving());
        QSignalSpy stopped(&bench.controller, &Controller::stopped);
        bench.controller.stop();
        QCOMPARE(bench.controller.gate().stopProgress(), StopProgress::Asked);
        QTRY_COMPARE(stopped.count(), 1);
        QCOMPARE(bench.controller.gate().stopProgress(), StopProgress::Sent);
        QVERIFY(bench.endsInStop());
    }

    void stop_thatCannotBeSent_isSaidSo()
    {
        Bench bench;
        QVERIFY(bench.connected({}, u"&fault=hangup-after=0.7"_s));
        QVERIFY(bench.driving());
        QTRY_VERIFY_WITH_TIMEOUT(bench.controller.state() != LinkState::Connected, 5000);
        QSignalSpy failed(&bench.controller, &Controller::stopFailed);
        bench.controller.stop();
        QTRY_COMPARE(failed.count(), 1);
        QCOMPARE(bench.controller.gate().stopProgress(), StopProgress::Failed);
        QVERIFY(!bench.log.filter(u"Stop could not be sent"_s).isEmpty());
    }

    void limits_holdOnTheWire_evenForWhatRunsAlready()
    {
        Bench bench;
        QVERIFY(bench.connected());
        QVERIFY(bench.driving());
        bench.controller.setMotionLimits({.maximum = {30, 127, 127}});
        QTRY_VERIFY(bench.motorPackets.last() == QByteArray::fromHex("c21e"));
        QVERIFY(bench.controller.driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, -127}));
        QTRY_VERIFY(bench.motorPackets.last() == QByteArray::fromHex("c11e"));
        QCOMPARE(bench.controller.lastOrder(MotorId::Motor1).amount, -30);
    }

    void ramps_areSent_butStopNeverRamps()
    {
        Bench bench;
        QVERIFY(bench.connected());
        bench.controller.setMotionLimits({.softStart = 127, .softStop = 127});
        QVERIFY(bench.controller.arm().has_value());
        QVERIFY(bench.controller.driveMotor(MotorId::Motor1, kHalf));
        QCOMPARE(bench.controller.lastOrder(MotorId::Motor1).amount, 64);
        QVERIFY(bench.controller.sentOrder(MotorId::Motor1).amount < 10);
        QTRY_COMPARE(bench.controller.sentOrder(MotorId::Motor1).amount, 64);
        QTRY_VERIFY(bench.motorPackets.last() == QByteArray::fromHex("c240"));
        QVERIFY(bench.motorPackets.size() > 10);
        QVERIFY(bench.controller.driveMotor(MotorId::Motor1, {}));
        QVERIFY(bench.controller.sentOrder(MotorId::Motor1).amount > 50);
        bench.controller.stop();
        const auto count = bench.motorPackets.size();
        QTRY_VERIFY(bench.endsInStop());
        QVERIFY(bench.motorPackets.size() <= count + 3); // at most one that was on its way
        QTest::qWait(100);
        QVERIFY(bench.endsInStop());
    }

    void stall_leadsAllToZeroAndDisarms()
    {
        Bench bench;
        bench.controller.setMotionLimits({.stallAmperes = 2.0, .stallTime = 200ms});
        QVERIFY(bench.connected(R"({"t":0.8,"set":{"stall1":true}})"));
        QVERIFY(bench.driving());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.controller.isArmed(), 10'000);
        QCOMPARE(bench.controller.gate().lastDisarming().reason, DisarmReason::Stalled);
        QVERIFY(!bench.log.filter(u"Stall guard: motor 1 drew"_s).isEmpty());
        QTRY_VERIFY(bench.endsInStop());
        QVERIFY2(bench.motorPackets.size() > 8, "a ramp, not a jump");
    }

    void restartUnderWay_disarms()
    {
        Bench bench;
        const RestartWatch watch(bench.controller, bench.store); // no panel wants the currents
        QVERIFY(bench.connected(
            R"({"t":1.5,"set":{"powerCycle":true}},{"t":1.5,"fault":{"silent-for":0.3}})"));
        QVERIFY(bench.driving());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.controller.isArmed(), 10'000);
        QCOMPARE(bench.controller.gate().lastDisarming().reason, DisarmReason::Restarted);
        QTRY_VERIFY(bench.endsInStop());
    }

    void lostReplies_aloneDoNotDisarm()
    {
        Bench bench;
        const RestartWatch watch(bench.controller, bench.store);
        bench.controller.want(&bench.context, PollId::Currents, 40.0);
        QVERIFY(bench.connected(R"({"t":1.0,"fault":{"silent-for":0.3}})"));
        QVERIFY(bench.driving());
        QTRY_VERIFY_WITH_TIMEOUT(bench.controller.stats().timeouts > 0, 10'000);
        QTest::qWait(1000);
        QVERIFY(bench.controller.isArmed());
    }

    void keepAlive_isOftenEnough()
    {
        QCOMPARE(SerialTimeoutWatch::keepAliveHertz(0ms), 0.0);
        for (const auto timeout : {100ms, 500ms, 12'700ms}) {
            const double period = 1000.0 / SerialTimeoutWatch::keepAliveHertz(timeout);
            QVERIFY(period <= static_cast<double>(timeout.count()) / 3.0);
        }
    }

    void keepAlive_armedAndNothingElsePolled_noTimeout() // C-51
    {
        // Without a store and a latch nothing is polled at all.
        Controller controller(nullptr, nullptr);
        DeviceSettings settings(controller);
        const SerialTimeoutWatch watch(controller, settings);
        OpenOptions options;
        options.port = u"sim:?param=serial-timeout=3"_s;
        controller.open(options);
        QTRY_COMPARE(watch.state(), SerialTimeoutWatch::State::On);
        QCOMPARE(watch.timeout(), 300ms);
        const auto uartErrors = [&controller](QObject& asker) {
            std::optional<int> bits;
            controller.request(query("get-uart-errors"), &asker, [&](const Result<Reply>& reply) {
                bits = reply ? static_cast<std::uint8_t>(reply->payload.front()) : -1;
            });
            [&] { QTRY_VERIFY(bits.has_value()); }();
            return bits.value_or(-1);
        };
        QObject asker;
        QTest::qWait(700); // disarmed: nothing is sent, and it does act
        QCOMPARE(uartErrors(asker), 0x80);
        QVERIFY(controller.arm().has_value());
        QTest::qWait(1500);
        QCOMPARE(uartErrors(asker), 0x00);
    }

    void serialTimeout_offIsTold_andSetInOneCall()
    {
        Bench bench;
        SerialTimeoutWatch watch(bench.controller, bench.settings);
        QVERIFY(bench.connected());
        QTRY_COMPARE(watch.state(), SerialTimeoutWatch::State::Off);
        QCOMPARE(bench.log.filter(u"serial timeout is off"_s).size(), 1);
        watch.setIt();
        QTRY_COMPARE(watch.state(), SerialTimeoutWatch::State::On);
        QCOMPARE(watch.timeout(), 500ms);
    }
};

QTEST_GUILESS_MAIN(TestGate)
#include "tst_gate.moc"
