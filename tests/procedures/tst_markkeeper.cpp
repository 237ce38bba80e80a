// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of a real connection to a simulated controller, and of latched bits.
#include "protocol/procedures/markkeeper.h"
#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QTest>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

struct Bench {
    Bench()
        : controller(&store, &latch)
        , settings(controller)
        , keeper(track, controller, latch, settings)
    {
    }
    [[nodiscard]] bool connectTo(const QString& port)
    {
        controller.open({.port = port, .line = {}});
        return QTest::qWaitFor(
            [this] {
                return controller.state() == LinkState::Connected && controller.device().mode;
            },
            10'000);
    }
    [[nodiscard]] std::vector<MarkKind> kinds() const
    {
        std::vector<MarkKind> all;
        for (const Mark& mark : track.marks()) {
            all.push_back(mark.kind);
        }
        return all;
    }
    [[nodiscard]] int count(MarkKind kind) const
    {
        const auto all = kinds();
        return static_cast<int>(std::count(all.begin(), all.end(), kind));
    }
    [[nodiscard]] QString textOf(MarkKind kind) const
    {
        for (const Mark& mark : track.marks()) {
            if (mark.kind == kind) {
                return mark.text;
            }
        }
        return {};
    }

    TelemetryStore store;
    StatusLatch latch;
    MarkTrack track;
    Controller controller;
    DeviceSettings settings;
    MarkKeeper keeper;
    QObject context;
};

} // namespace

class TestMarkKeeper : public QObject {
    Q_OBJECT

private slots:
    void session_isMarkedFromConnectToDisconnect()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:?pace=0"_s));
        QVERIFY(bench.controller.arm());
        bench.controller.stop();
        QTRY_COMPARE(bench.count(MarkKind::Stop), 1);
        bench.controller.close();
        QTRY_COMPARE(bench.count(MarkKind::Disconnected), 1);
        const std::vector<MarkKind> all = bench.kinds();
        QCOMPARE((std::vector(all.begin(), all.begin() + 4)),
                 (std::vector{MarkKind::Connected, MarkKind::Armed, MarkKind::Disarmed,
                              MarkKind::Stop}));
        QCOMPARE(all.back(), MarkKind::Disconnected);
        QVERIFY(std::is_sorted(bench.track.marks().begin(), bench.track.marks().end(),
                               [](const Mark& a, const Mark& b) { return a.time < b.time; }));
    }
    void write_isMarkedWithBothValues_refusalIsNot()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:?pace=0"_s));
        const ParameterRow& row = parameterRow("motor1-current-limit");
        int answers = 0;
        const auto write = [&](int raw) {
            bench.settings.writeParameter(row, raw, true, &bench.context,
                                          [&](const auto&) { ++answers; });
        };
        write(25);
        QTRY_COMPARE(answers, 1);
        QCOMPARE(bench.count(MarkKind::Written), 1);
        const QString text = bench.textOf(MarkKind::Written);
        QVERIFY2(text.startsWith(u"Motor 1 current limit: "_s) && text.endsWith(u"2.00 A"_s),
                 qPrintable(text));
        write(25); // nothing to write
        write(999);
        QTRY_COMPARE(answers, 3);
        QCOMPARE(bench.count(MarkKind::Written), 1);
    }
    void loss_isMarkedOnce_andItsEnd()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:?fault=silent-after=2&fault=silent-for=2"_s));
        QTRY_COMPARE_WITH_TIMEOUT(bench.count(MarkKind::LinkLost), 1, 20'000);
        QTRY_COMPARE_WITH_TIMEOUT(bench.count(MarkKind::Connected), 2, 20'000);
        QCOMPARE(bench.count(MarkKind::LinkLost), 1);
        QVERIFY(bench.textOf(MarkKind::LinkLost).startsWith(u"Link lost: "_s));
    }
    void latchedBit_isMarkedWhereItIsFirstSeen()
    {
        Bench bench;
        const Instant first{500s};
        const auto record = [&](StatusLatch::Byte byte, std::uint8_t bits, Duration after) {
            bench.latch.record(byte, bits, first + after);
        };
        record(StatusLatch::Byte::Status, statusbit::kMotor1OverCurrent, 0s);
        record(StatusLatch::Byte::Status, statusbit::kMotor1OverCurrent, 100ms); // the same event
        record(StatusLatch::Byte::Status, 0, 200ms);
        record(StatusLatch::Byte::Status, statusbit::kMotor1OverCurrent, 300ms);
        record(StatusLatch::Byte::Status, statusbit::kMotor2Fault, 400ms);
        record(StatusLatch::Byte::Uart, uartbit::kTimeout, 500ms);
        record(StatusLatch::Byte::Uart, uartbit::kParity, 600ms);
        QCOMPARE(bench.kinds(),
                 (std::vector{MarkKind::OverCurrent, MarkKind::OverCurrent, MarkKind::Fault,
                              MarkKind::Timeout, MarkKind::LineError}));
        QCOMPARE(bench.track.marks()[0].time, first);
        QCOMPARE(bench.track.marks()[1].time, first + 300ms);
    }
};

QTEST_GUILESS_MAIN(TestMarkKeeper)
#include "tst_markkeeper.moc"
