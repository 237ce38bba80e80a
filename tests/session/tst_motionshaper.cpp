// SPDX-License-Identifier: GPL-3.0-or-later
// Ramps, limits and the stall guard, on a clock of the test's own.
#include "protocol/session/motionshaper.h"

#include <QTest>

using namespace trex;
using namespace std::chrono_literals;

namespace {

constexpr Instant kStart{1h};
constexpr auto kM1 = MotorId::Motor1;

MotorOrder set(int speed)
{
    return {MotorOrder::Action::Set, speed};
}

/// Steps until the ramp ends; how long that took, and every speed that was sent.
struct Ramp {
    Duration took{0};
    std::vector<int> speeds;
};
Ramp play(MotionShaper& shaper, MotorId motor, Instant from)
{
    Ramp ramp;
    Instant now = from;
    for (int i = 0; i < 10'000 && shaper.isRamping(); ++i) {
        now += MotionShaper::kStep;
        if (const auto order = shaper.step(motor, now)) {
            ramp.speeds.push_back(order->amount);
        }
    }
    ramp.took = now - from;
    return ramp;
}

} // namespace

class TestMotionShaper : public QObject {
    Q_OBJECT

private slots:
    void nothingChosen_everyOrderPassesAsItIs()
    {
        MotionShaper shaper;
        for (const MotorOrder& order :
             {set(127), set(-127), set(0), MotorOrder{MotorOrder::Action::Accelerate, 90},
              MotorOrder{MotorOrder::Action::Brake, 127}}) {
            QCOMPARE(shaper.take(kM1, shaper.limited(kM1, order), kStart), order);
            QVERIFY(!shaper.isRamping());
            QVERIFY(!shaper.step(kM1, kStart + 1s).has_value());
        }
    }

    void maximum_boundsSpeedsAndNoBrake()
    {
        MotionShaper shaper;
        shaper.setLimits({.maximum = {40, 127, 10}});
        QCOMPARE(shaper.limited(kM1, set(127)), set(40));
        QCOMPARE(shaper.limited(kM1, set(-127)), set(-40));
        QCOMPARE(shaper.limited(kM1, set(39)), set(39));
        QCOMPARE(shaper.limited(MotorId::Motor2, set(127)), set(127));
        QCOMPARE(shaper.limited(MotorId::Aux, set(127)), set(10));
        const MotorOrder brake{MotorOrder::Action::Brake, 127};
        QCOMPARE(shaper.limited(kM1, brake), brake);
    }

    void softStart_takesItsTimeAndNeverOvershoots()
    {
        MotionShaper shaper;
        shaper.setLimits({.softStart = 100});
        const MotorOrder first = shaper.take(kM1, set(100), kStart);
        QVERIFY2(first.amount > 0 && first.amount <= 2, "a step of 20 ms at 100 a second");
        const Ramp ramp = play(shaper, kM1, kStart);
        QVERIFY(ramp.took > 900ms && ramp.took <= 1000ms);
        QVERIFY(std::is_sorted(ramp.speeds.begin(), ramp.speeds.end()));
        QCOMPARE(ramp.speeds.back(), 100);
        QCOMPARE(shaper.sent(kM1), set(100));
        QCOMPARE(shaper.take(kM1, set(0), kStart + 5s), set(0)); // no soft stop was chosen
    }

    void softStop_leadsDownToExactlyZero()
    {
        MotionShaper shaper;
        shaper.setLimits({.softStop = 200});
        QCOMPARE(shaper.take(kM1, set(-100), kStart), set(-100)); // no soft start was chosen
        QCOMPARE(shaper.take(kM1, set(0), kStart + 1s).amount, -96);
        const Ramp ramp = play(shaper, kM1, kStart + 1s);
        QVERIFY(ramp.took >= 460ms && ramp.took <= 520ms);
        QCOMPARE(ramp.speeds.back(), 0);
        QVERIFY(std::all_of(ramp.speeds.begin(), ramp.speeds.end(), [](int s) { return s <= 0; }));
    }

    void reversal_goesThroughNeutral()
    {
        MotionShaper shaper;
        shaper.setLimits({.softStart = 100, .softStop = 400});
        shaper.take(kM1, set(80), kStart);
        play(shaper, kM1, kStart);
        shaper.take(kM1, set(-60), kStart + 10s);
        const Ramp ramp = play(shaper, kM1, kStart + 10s);
        QVERIFY(std::is_sorted(ramp.speeds.rbegin(), ramp.speeds.rend()));
        QCOMPARE(ramp.speeds.back(), -60);
        // 80 / 400 s down and 60 / 100 s up, but for the first step
        QVERIFY(ramp.took >= 760ms && ramp.took <= 820ms);
    }

    void manyOrders_doNotHurryTheRamp()
    {
        MotionShaper shaper;
        shaper.setLimits({.softStart = 50});
        Instant now = kStart;
        for (int i = 0; i < 200; ++i) { // a drag: an order every millisecond for 0.2 s
            shaper.take(kM1, set(100 + i % 27), now);
            now += 1ms;
        }
        QVERIFY2(shaper.sent(kM1).amount <= 12,
                 qPrintable(QString::number(shaper.sent(kM1).amount)));
    }

    void brake_isAtOnceAndEndsTheRamp()
    {
        MotionShaper shaper;
        shaper.setLimits({.softStart = 50, .softStop = 50});
        shaper.take(kM1, set(100), kStart);
        const MotorOrder brake{MotorOrder::Action::Brake, 60};
        QCOMPARE(shaper.take(kM1, brake, kStart + 500ms), brake);
        QVERIFY(!shaper.isRamping());
    }

    void accelerate_isTheFirmwaresOwn()
    {
        MotionShaper shaper;
        shaper.setLimits({.softStart = 50, .softStop = 50});
        const MotorOrder accelerate{MotorOrder::Action::Accelerate, 100};
        QCOMPARE(shaper.take(kM1, accelerate, kStart), accelerate);
        // How far it has come is not known: a ramp down from 100 could make it faster first.
        QCOMPARE(shaper.take(kM1, set(0), kStart + 100ms), set(0));
        QVERIFY(!shaper.isRamping());
    }

    void reset_forgetsTheRamp() // STOP never ramps
    {
        MotionShaper shaper;
        shaper.setLimits({.softStart = 50, .softStop = 50});
        shaper.take(kM1, set(100), kStart);
        shaper.reset();
        QVERIFY(!shaper.isRamping());
        QVERIFY(!shaper.step(kM1, kStart + 1s).has_value());
        QCOMPARE(shaper.sent(kM1), MotorOrder{});
    }

    void stallGuard_needsTheCurrentForItsTime()
    {
        MotionShaper shaper;
        QVERIFY2(!shaper.isStalled(kM1, 99.0, kStart) && !shaper.isStalled(kM1, 99.0, kStart + 9s),
                 "off until it is chosen");
        shaper.setLimits({.stallAmperes = 3.0, .stallTime = 300ms});
        QVERIFY(!shaper.isStalled(kM1, 3.5, kStart));
        QVERIFY(!shaper.isStalled(kM1, 3.5, kStart + 200ms));
        QVERIFY(!shaper.isStalled(kM1, 2.9, kStart + 250ms)); // a start, no stall
        QVERIFY(!shaper.isStalled(kM1, 3.5, kStart + 299ms));
        QVERIFY(!shaper.isStalled(MotorId::Motor2, 3.5, kStart + 599ms));
        QVERIFY(shaper.isStalled(kM1, 3.5, kStart + 599ms));
    }

    void stallGuard_leadsAllDownWithoutASoftStopToo()
    {
        MotionShaper shaper;
        shaper.setLimits({.stallAmperes = 3.0});
        shaper.take(kM1, set(127), kStart);
        shaper.take(MotorId::Aux, set(60), kStart);
        shaper.rampDown(kStart + 1s);
        QVERIFY(shaper.isRampingDown());
        Instant now = kStart + 1s;
        int last = 127;
        while (shaper.isRamping() && now < kStart + 5s) {
            now += MotionShaper::kStep;
            for (const auto motor : {kM1, MotorId::Motor2, MotorId::Aux}) {
                const auto order = shaper.step(motor, now);
                if (order && motor == kM1) {
                    QVERIFY(order->amount < last);
                    last = order->amount;
                }
            }
        }
        QCOMPARE(last, 0);
        QVERIFY(now - kStart > 1300ms && now - kStart <= 1520ms);
        QCOMPARE(shaper.sent(MotorId::Aux).amount, 0);
    }
};

QTEST_GUILESS_MAIN(TestMotionShaper)
#include "tst_motionshaper.moc"
