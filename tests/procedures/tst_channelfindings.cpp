// SPDX-License-Identifier: GPL-3.0-or-later
// Each thing that the learner detects about a single channel.
#include "protocol/procedures/calibrationtext.h"
#include "protocol/procedures/responsecurve.h"

#include "tests/procedures/learnerbench.h"

#include <QTest>

using namespace std::chrono_literals;
using namespace trex;

class TestChannelFindings : public QObject {
    Q_OBJECT

private slots:
    void notMoving_isFound();
    void oneDirection_isFound();
    void saturated_isFound();
    void beyondWhatIsRead_isSaturated();
    void jitter_isFound();
    void dropoutsAtRest_areJitter();
    void missingPulses_areFound();
    void analogReadings_areNoPulses();
    void pulsesOnAnalog_areSuspected();
    void quietZeroVolts_isNoSuspicion();
    void floatingInput_isSuspected();
    void coarseTravel_isFound();
    void switchOnAtNeutral_isFound();
    void rushedEnds_areFound();
};

void TestChannelFindings::notMoving_isFound()
{
    Bench bench;
    bench.learnNeutral();
    bench.learner.beginExtremes();
    bench.sweep(1, 2500, 5000);
    bench.move(2, 3800, 500ms); // play
    const auto learned = bench.learner.result(2);
    QCOMPARE(learned.findings, std::vector{Finding::NotMoved});
    QCOMPARE(learned.verdict, Verdict::DoAgain);
    QCOMPARE(bench.learner.result(1).verdict, Verdict::Good);
}

void TestChannelFindings::oneDirection_isFound()
{
    Bench bench;
    bench.learnNeutral();
    bench.learner.beginExtremes();
    bench.sweep(1, 3750, 5000);
    QCOMPARE(bench.learner.result(1).findings, std::vector{Finding::OneDirection});
    QVERIFY(!bench.learner.areExtremesDone());
}

void TestChannelFindings::saturated_isFound()
{
    Bench bench(InputKind::Analog, 0b00001);
    bench.disturb = [](int /*channel*/, int raw) { return std::clamp(raw, 0, 1023); };
    bench.learnAll(-100, 900);
    QVERIFY(bench.learner.result(1).has(Finding::Saturated));
    QCOMPARE(bench.learner.result(1).verdict, Verdict::Usable);
    Bench inside(InputKind::Analog, 0b00001);
    inside.learnAll(50, 900);
    QVERIFY(!inside.learner.result(1).has(Finding::Saturated));
}

void TestChannelFindings::beyondWhatIsRead_isSaturated()
{
    Bench bench(InputKind::Rc, 0b00001);
    bench.disturb = [](int, int raw) { return raw > 6250 ? int(kInvalidPulse) : raw; };
    bench.learnNeutral();
    bench.learner.beginExtremes();
    for (int i = 0; i < 6; ++i) {
        for (int step = 0; step <= 20; ++step) { // up to 2.56 ms in 0.4 s
            bench.at[0] = 3750 + step * 132;
            bench.hold(20ms);
        }
        bench.hold(200ms);
        for (int step = 20; step >= 0; --step) {
            bench.at[0] = 2500 + step * 200;
            bench.hold(20ms);
        }
        bench.hold(600ms);
    }
    const auto learned = bench.learner.result(1);
    QCOMPARE(learned.verdict, Verdict::DoAgain);
    QCOMPARE(learned.findings.front(), Finding::Saturated);
}

void TestChannelFindings::jitter_isFound()
{
    for (const int every : {12, 80, 100'000}) { // 8 %, 1.2 %, none
        Bench bench(InputKind::Analog, 0b00001);
        int count = 0;
        bench.disturb = [&count, every](int channel, int raw) {
            count += channel == 1 ? 1 : 0;
            return channel == 1 && count % every == 0 ? 1023 : raw; // the wiper lifts
        };
        bench.learnAll(100, 900);
        const auto learned = bench.learner.result(1);
        QCOMPARE(learned.has(Finding::Jitter), every == 12);
        QCOMPARE(learned.has(Finding::SomeJitter), every == 80);
        QCOMPARE(learned.verdict == Verdict::DoAgain, every == 12);
        if (every != 12) { // and none of it counted
            QVERIFY(std::abs(learned.highEnd - 900) <= 1 && std::abs(learned.neutral - 512) <= 1);
        }
    }
}

void TestChannelFindings::dropoutsAtRest_areJitter()
{
    Bench bench(InputKind::Rc, 0b00001);
    int count = 0;
    bool isResting = true;
    bench.disturb = [&](int channel, int raw) {
        count += channel == 1 ? 1 : 0;
        return isResting && count % 10 < 2 ? 3000 : raw;
    };
    bench.learnNeutral();
    isResting = false;
    bench.learner.beginExtremes();
    bench.sweep(1, 2500, 5000);
    const auto learned = bench.learner.result(1);
    QVERIFY(learned.has(Finding::Jitter));
    QCOMPARE(learned.neutral, 3750.0);
}

void TestChannelFindings::missingPulses_areFound()
{
    for (const int every : {3, 10, 100'000}) { // 33 %, 10 %, none
        Bench bench(InputKind::Rc, 0b00001);
        int count = 0;
        bench.disturb = [&count, every](int channel, int raw) {
            count += channel == 1 ? 1 : 0;
            return channel == 1 && count % every == 0 ? int(kInvalidPulse) : raw;
        };
        bench.learnAll();
        const auto learned = bench.learner.result(1);
        QCOMPARE(learned.has(Finding::MissingPulses), every == 3);
        QCOMPARE(learned.has(Finding::SomeMissing), every == 10);
        QCOMPARE(learned.missed > 0, every != 100'000);
        QCOMPARE(learned.neutral, 3750.0);
    }
}

void TestChannelFindings::analogReadings_areNoPulses()
{
    Bench rc(InputKind::Rc, 0b00001);
    rc.at.fill(512);
    rc.hold(3s);
    QVERIFY(!rc.learner.isNeutralDone());
    QCOMPARE(rc.learner.result(1).findings.front(), Finding::InputConfused);
    QCOMPARE(rc.learner.result(1).confusion, Confusion::OtherKindsReadings);
    QVERIFY(reasonText(rc.learner.result(1), InputKind::Rc).contains(QStringLiteral("voltage")));

    Bench analog(InputKind::Analog, 0b00001);
    analog.at.fill(3750);
    analog.hold(3s);
    QCOMPARE(analog.learner.result(1).findings.front(), Finding::InputConfused);

    Bench silent(InputKind::Rc, 0b00001); // no pulse at all is no proof of a voltage
    silent.disturb = [](int, int) { return int(kInvalidPulse); };
    silent.hold(3s);
    QCOMPARE(silent.learner.result(1).findings.front(), Finding::NoReadings);
    QCOMPARE(silent.learner.result(1).confusion, Confusion::None);
}

void TestChannelFindings::pulsesOnAnalog_areSuspected()
{
    Bench bench(InputKind::Analog, 0b00001);
    bench.at.fill(0);
    int count = 0;
    bench.disturb = [&count](int, int raw) {
        ++count;
        return count / kChannelCount % 7 == 0 ? 300 + count % 400 : std::max(0, raw);
    };
    bench.hold(3s);
    bench.learner.beginExtremes();
    bench.hold(3s);
    const auto learned = bench.learner.result(1);
    QCOMPARE(learned.findings.front(), Finding::InputConfused);
    QCOMPARE(learned.confusion, Confusion::PulsesOnAnalog);
    QVERIFY(reasonText(learned, InputKind::Analog).contains(QStringLiteral("a guess")));
}

void TestChannelFindings::quietZeroVolts_isNoSuspicion()
{
    Bench bench(InputKind::Analog, 0b00100); // a lever that rests at 0 V
    bench.at.fill(0);
    bench.learnNeutral();
    bench.learner.beginExtremes();
    bench.sweep(3, 0, 1000);
    const auto learned = bench.learner.result(3);
    QCOMPARE(learned.confusion, Confusion::None);
    QVERIFY(!learned.has(Finding::InputConfused));
    QCOMPARE(learned.verdict, Verdict::Usable);
}

void TestChannelFindings::floatingInput_isSuspected()
{
    Bench bench(InputKind::Analog, 0b00001);
    for (int i = 0; i < 500; ++i) { // 10 s, wandering by 2 V
        bench.at[0] = 500 + static_cast<int>(200 * std::sin(i / 40.0));
        bench.hold(20ms);
    }
    QVERIFY(!bench.learner.isNeutralDone());
    const auto learned = bench.learner.result(1);
    QCOMPARE(learned.findings.front(), Finding::NotStill); // which is certain
    QVERIFY(learned.has(Finding::InputConfused)); // and this is a guess
    QCOMPARE(learned.confusion, Confusion::Floating);
}

void TestChannelFindings::coarseTravel_isFound()
{
    Bench coarse(InputKind::Analog, 0b00001);
    coarse.learnAll(512 - 130, 512 + 130);
    QVERIFY(coarse.learner.result(1).has(Finding::CoarseTravel));
    QCOMPARE(coarse.learner.result(1).verdict, Verdict::Usable);
    Bench fine(InputKind::Analog, 0b00001);
    fine.learnAll(512 - 140, 512 + 140);
    QVERIFY(!fine.learner.result(1).has(Finding::CoarseTravel));
}

void TestChannelFindings::switchOnAtNeutral_isFound()
{
    Bench low(InputKind::Rc, 0b10000);
    low.at[4] = 2500;
    low.learnNeutral();
    low.learner.beginExtremes();
    low.sweep(5, 2500, 5000);
    const auto resting = low.learner.result(5);
    QVERIFY(resting.has(Finding::SwitchOnAtNeutral));
    QCOMPARE(resting.findings.front(), Finding::SwitchOnAtNeutral);
    QVERIFY(reasonText(resting, InputKind::Rc).contains(QStringLiteral("a guess")));

    Bench high(InputKind::Rc, 0b01000);
    high.at[3] = 5000;
    high.learnNeutral();
    high.learner.beginExtremes();
    high.sweep(4, 2500, 5000);
    const auto off = high.learner.result(4);
    QVERIFY(!off.has(Finding::SwitchOnAtNeutral));
    QVERIFY(off.switchThreshold.has_value());
    QVERIFY(*off.switchThreshold > 3600 && *off.switchThreshold < 3800);
    const ResponseCurve curve{off.calibration, false, false};
    QVERIFY(curve.isSwitchedOn(*off.switchThreshold));
    QVERIFY(!curve.isSwitchedOn(*off.switchThreshold + 20));

    Bench drive(InputKind::Rc, 0b00001);
    drive.learnAll(3000, 5200);
    QVERIFY(!drive.learner.result(1).has(Finding::SwitchOnAtNeutral));
    QVERIFY(!drive.learner.result(1).switchThreshold.has_value());
}

void TestChannelFindings::rushedEnds_areFound()
{
    Bench bench(InputKind::Rc, 0b00001);
    bench.learnNeutral();
    bench.learner.beginExtremes();
    for (int i = 0; i < 10; ++i) {
        bench.sweep(1, 2700, 4800); // held here
        bench.move(1, 5000, 20ms); // and touched there
        bench.move(1, 3750, 100ms);
    }
    const auto learned = bench.learner.result(1);
    QCOMPARE(learned.verdict, Verdict::DoAgain);
    QCOMPARE(learned.findings.front(), Finding::NotHeld);
}

QTEST_GUILESS_MAIN(TestChannelFindings)
#include "tst_channelfindings.moc"
