// SPDX-License-Identifier: GPL-3.0-or-later
// The state of the motor gate, on a clock of the test's own.
#include "protocol/session/motorgate.h"

#include <QTest>

using namespace trex;
using namespace std::chrono_literals;

namespace {

constexpr Instant kStart{1h};

ErrorCode codeOf(const Result<void>& result)
{
    return result ? ErrorCode::Cancelled : result.error().code; // Cancelled: none of the gate's
}

} // namespace

class TestMotorGate : public QObject {
    Q_OBJECT

private slots:
    void start_isClosedAndSaysWhy()
    {
        const MotorGate gate;
        QCOMPARE(codeOf(gate.check(kStart)), ErrorCode::Disarmed);
        QCOMPARE(gate.lastDisarming().reason, DisarmReason::NeverArmed);
    }

    void everyReason_hasItsOwnWords()
    {
        QStringList seen;
        for (int i = 0; i <= static_cast<int>(DisarmReason::Frozen); ++i) {
            const QString text = disarmText(static_cast<DisarmReason>(i));
            QVERIFY2(!text.isEmpty() && !text.endsWith(u'.'), qPrintable(QString::number(i)));
            QVERIFY2(!seen.contains(text), qPrintable(text));
            seen << text;
        }
    }

    void disarm_keepsTheFirstReason()
    {
        MotorGate gate;
        gate.arm(kStart);
        QVERIFY(gate.disarm(DisarmReason::MotorFault, QStringLiteral("motor 1")));
        QVERIFY2(!gate.disarm(DisarmReason::LinkLost, {}), "it is closed already");
        QCOMPARE(gate.lastDisarming().reason, DisarmReason::MotorFault);
        QCOMPARE(gate.lastDisarming().detail, QStringLiteral("motor 1"));
    }

    void stop_locksOutForItsTime()
    {
        MotorGate gate;
        gate.arm(kStart);
        gate.stopAsked({1, 2}, kStart);
        QCOMPARE(codeOf(gate.check(kStart + 499ms)), ErrorCode::LockedOut);
        QCOMPARE(codeOf(gate.check(kStart + 500ms)), ErrorCode::Cancelled);
    }

    void stop_isSentWhenEachPacketIsRecorded()
    {
        MotorGate gate;
        gate.stopAsked({7, 8}, kStart);
        QCOMPARE(gate.stopProgress(), StopProgress::Asked);
        QCOMPARE(gate.stopRecorded(6, true), MotorGate::StopStep::NotOurs);
        QCOMPARE(gate.stopRecorded(7, true), MotorGate::StopStep::More);
        QCOMPARE(gate.stopProgress(), StopProgress::Asked);
        QCOMPARE(gate.stopRecorded(8, true), MotorGate::StopStep::Sent);
        QCOMPARE(gate.stopProgress(), StopProgress::Sent);

        gate.stopAsked({9, 10}, kStart);
        QCOMPARE(gate.stopRecorded(9, false), MotorGate::StopStep::Failed);
        QCOMPARE(gate.stopRecorded(10, true), MotorGate::StopStep::NotOurs);
        QCOMPARE(gate.stopProgress(), StopProgress::Failed);
    }

    void idle_countsAtNeutralOnly()
    {
        MotorGate gate;
        gate.setRules({.idle = 60s});
        QVERIFY(!gate.isIdle(kStart + 1h));
        gate.arm(kStart);
        QVERIFY(!gate.isIdle(kStart + 59s));
        QVERIFY(gate.isIdle(kStart + 60s));
        gate.setOrder(MotorId::Motor2, {MotorOrder::Action::Set, 5}, kStart + 60s);
        QVERIFY2(!gate.isIdle(kStart + 1h), "a long run that a person started goes on");
        gate.setOrder(MotorId::Motor2, {}, kStart + 1h);
        QVERIFY(gate.isIdle(kStart + 1h + 60s));
        gate.setRules({.idle = 0s});
        QVERIFY(!gate.isIdle(kStart + 10h));
    }

    void faults_closeByTheRules_data() // C-20, C-21
    {
        QTest::addColumn<bool>("uart");
        QTest::addColumn<int>("bits");
        QTest::addColumn<int>("reason");
        const auto row = [](const char* name, bool uart, int bits, DisarmReason reason) {
            QTest::newRow(name) << uart << bits << static_cast<int>(reason);
        };
        row("motor 1 fault", false, 0x10, DisarmReason::MotorFault);
        row("motor 2 fault", false, 0x40, DisarmReason::MotorFault);
        row("motor 1 over current", false, 0x20, DisarmReason::OverCurrent);
        row("motor 2 over current", false, 0x80, DisarmReason::OverCurrent);
        row("status: UART error", false, 0x01, DisarmReason::NeverArmed);
        row("timeout", true, 0x80, DisarmReason::SerialTimeout);
        for (const int bit : {0x40, 0x20, 0x10, 0x08, 0x04, 0x02, 0x01}) {
            row(qPrintable(QStringLiteral("UART bit %1").arg(bit)), true, bit,
                DisarmReason::UartError);
        }
        row("nothing", false, 0x00, DisarmReason::NeverArmed);
    }

    void faults_closeByTheRules()
    {
        QFETCH(bool, uart);
        QFETCH(int, bits);
        QFETCH(int, reason);
        const auto byte = static_cast<std::uint8_t>(bits);
        MotorGate gate;
        gate.setRules({true, true, true, true, {}});
        const auto found = gate.faultIn(uart, byte);
        QCOMPARE(static_cast<int>(found ? found->reason : DisarmReason::NeverArmed), reason);
        gate.setRules({false, false, false, false, {}});
        QVERIFY(!gate.faultIn(uart, byte).has_value());
    }
};

QTEST_GUILESS_MAIN(TestMotorGate)
#include "tst_motorgate.moc"
