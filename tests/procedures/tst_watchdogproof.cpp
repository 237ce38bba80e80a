// SPDX-License-Identifier: GPL-3.0-or-later
// The watchdog proof against simulated controllers that do, and do not, stop for silence (C-51).
#include "protocol/procedures/watchdogproof.h"
#include "protocol/session/devicesettings.h"
#include "protocol/session/serialtimeoutwatch.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QSignalSpy>
#include <QTest>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

/// As in the program: everything is polled, the latched bits above all, and kept alive.
class Bench {
public:
    Bench() : controller(&store, &latch), settings(controller), watch(controller, settings)
    {
        QObject::connect(&controller, &Controller::recordsArrived, &context,
                         [this](const std::vector<TransactionRecord>& arrived) {
                             for (const TransactionRecord& record : arrived) {
                                 if (record.command.row().kind == CommandKind::Motor) {
                                     motorPackets.append(record.sentBytes);
                                 }
                             }
                         });
    }
    [[nodiscard]] bool armed(const QString& options)
    {
        OpenOptions open;
        open.port = u"sim:?"_s + options;
        controller.want(&context, PollId::Currents, 80.0);
        controller.open(open);
        return QTest::qWaitFor([this] { return controller.state() == LinkState::Connected; }, 5000)
            && QTest::qWaitFor([this] { return controller.device().mode.has_value(); }, 5000)
            && controller.arm().has_value();
    }
    [[nodiscard]] bool endsInStop() const
    {
        return motorPackets.size() >= 2
            && motorPackets.last(2)
            == QByteArrayList{QByteArray::fromHex("da0000"), QByteArray::fromHex("f000")};
    }

    QObject context;
    TelemetryStore store;
    StatusLatch latch;
    Controller controller;
    DeviceSettings settings;
    SerialTimeoutWatch watch;
    QByteArrayList motorPackets;
};

} // namespace

class TestWatchdogProof : public QObject {
    Q_OBJECT

private slots:
    void timeoutThatActs_passes()
    {
        Bench bench;
        QVERIFY(bench.armed(u"param=serial-timeout=5"_s));
        WatchdogProof proof(bench.controller, bench.settings, {});
        QSignalSpy finished(&proof, &Procedure::finished);
        proof.start();
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30'000);
        const WatchdogVerdict& verdict = proof.verdict();
        QVERIFY2(verdict.isPassed, qPrintable(verdict.sentence));
        QCOMPARE(verdict.configured, 500ms);
        QVERIFY(verdict.isCurrentSeen && verdict.isLatched);
        QVERIFY(verdict.survivedMs < verdict.stoppedMs);
        QVERIFY2(verdict.survivedMs >= 240.0 && verdict.stoppedMs <= 620.0,
                 qPrintable(verdict.sentence));
        QVERIFY(!bench.controller.isArmed());
        QTRY_VERIFY(bench.endsInStop());
        QCOMPARE(bench.controller.gate().lastDisarming().reason, DisarmReason::Stop);
    }

    void timeoutThatDoesNotAct_failsHonestly()
    {
        Bench bench;
        QVERIFY(bench.armed(u"param=serial-timeout=3&quirk=serial-timeout=off"_s));
        WatchdogProof proof(bench.controller, bench.settings, {});
        QSignalSpy finished(&proof, &Procedure::finished);
        proof.start();
        QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 30'000);
        QVERIFY(!proof.verdict().isPassed);
        QCOMPARE(proof.verdict().stoppedMs, 0.0);
        QVERIFY(proof.verdict().sentence.contains(u"still ran"_s));
        QTRY_VERIFY(bench.endsInStop());
    }

    void timeoutOff_failsWithoutMoving()
    {
        Bench bench;
        QVERIFY(bench.armed(u"seed=1"_s));
        WatchdogProof proof(bench.controller, bench.settings, {});
        QSignalSpy finished(&proof, &Procedure::finished);
        proof.start();
        QTRY_COMPARE(finished.count(), 1);
        QVERIFY(!proof.verdict().isPassed);
        QVERIFY(proof.verdict().sentence.contains(u"is off"_s));
        QTRY_VERIFY(bench.endsInStop());
        QCOMPARE(bench.motorPackets.size(), 2);
    }

    void disarmed_isRefused()
    {
        Bench bench;
        QVERIFY(bench.armed(u"param=serial-timeout=3"_s));
        bench.controller.disarm();
        WatchdogProof proof(bench.controller, bench.settings, {});
        QSignalSpy finished(&proof, &Procedure::finished);
        proof.start();
        QCOMPARE(finished.count(), 1);
        QCOMPARE(finished.first().first().value<Result<void>>().error().code, ErrorCode::Disarmed);
    }

    void stopOrAnotherOrder_endsItAtOnce_data()
    {
        QTest::addColumn<bool>("isStop");
        QTest::newRow("stop") << true;
        QTest::newRow("order") << false;
    }

    void stopOrAnotherOrder_endsItAtOnce()
    {
        QFETCH(bool, isStop);
        Bench bench;
        QVERIFY(bench.armed(u"param=serial-timeout=20"_s));
        WatchdogProof proof(bench.controller, bench.settings, {});
        QSignalSpy finished(&proof, &Procedure::finished);
        proof.start();
        QTRY_VERIFY(!bench.motorPackets.isEmpty());
        QTest::qWait(900); // into the silence
        if (isStop) {
            bench.controller.stop();
        } else {
            std::ignore = bench.controller.driveMotor(MotorId::Motor2, {});
            std::ignore =
                bench.controller.driveMotor(MotorId::Motor2, {MotorOrder::Action::Set, 9});
        }
        QCOMPARE(finished.count(), 1);
        QTRY_VERIFY(bench.endsInStop());
        QVERIFY(!bench.controller.isArmed());
        // Not silent any more.
        const quint64 before = bench.controller.stats().transactions;
        QTRY_VERIFY(bench.controller.stats().transactions > before + 5);
    }
};

QTEST_GUILESS_MAIN(TestWatchdogProof)
#include "tst_watchdogproof.moc"
