// SPDX-License-Identifier: GPL-3.0-or-later
// How sticks return, which way they go, what a new calibration gives before it is written, and the
// curve between raw and remapped.
#include "protocol/procedures/calibrationtext.h"
#include "protocol/procedures/responsecurve.h"

#include "tests/procedures/learnerbench.h"

#include <QTest>

using namespace std::chrono_literals;
using namespace trex;

class TestLearnerSteps : public QObject {
    Q_OBJECT

private slots:
    void swappedChannels_areFoundAndSaid();
    void pushedChannel_tellsItsDirection_data();
    void pushedChannel_tellsItsDirection();
    void movingTogether_theAskedChannelWins();
    void spikesAndHaste_areNoPush();
    void briefTouch_isNoPush();
    void othersMove_isNotSwappedWhileTheAskedStirs();
    void otherStillMoving_isWatchedOnceItRests();
    void unlearnedChannel_isFoundToo();
    void returns_tellRepeatabilityAndHysteresis();
    void returns_skippedAreSaid();
    void returns_mustBeStill();
    void levers_areNotWaitedForToReturn();
    void lostCentre_isDeclined();
    void deadband_saysItsTerm();
    void verify_comparesBeforeAndNow();
    void verify_restBesideNeutralIsNotZero();
    void verify_ignoresSpikes();
    void staleRepeats_neitherPushNorVerify();
    void curve_followsTheDocument(); // C-28
    void curve_switchesHalfWay();
    void figures_nameEveryTerm();
};

void TestLearnerSteps::swappedChannels_areFoundAndSaid()
{
    Bench bench;
    bench.learnAll();
    bench.learner.beginDirection(1);
    bench.hold(500ms);
    QVERIFY(bench.learner.isDirectionReady());
    bench.move(2, 4600, 1s); // 1 was asked for
    const auto result = bench.learner.directionResult();
    QVERIFY(result.has_value());
    QCOMPARE(result->askedChannel, 1);
    QCOMPARE(result->movedChannel, 2);
    QVERIFY(result->isSwapped());
    const auto learned = bench.learner.result(1);
    QVERIFY(learned.has(Finding::SwappedWith));
    QCOMPARE(learned.swappedWith, 2);
    QCOMPARE(learned.forwardSign, 0);
    QCOMPARE(learned.verdict, Verdict::Usable);
    QVERIFY(reasonText(learned, InputKind::Rc).startsWith(QStringLiteral("Channel 2 moved")));
    QVERIFY(!bench.learner.result(2).has(Finding::SwappedWith));
    bench.move(2, 3750, 500ms);
    bench.learner.beginDirection(1); // again, the right one now
    bench.hold(500ms);
    bench.move(1, 4600, 500ms);
    QVERIFY(!bench.learner.result(1).has(Finding::SwappedWith));
    QCOMPARE(bench.learner.result(1).forwardSign, 1);
}

void TestLearnerSteps::pushedChannel_tellsItsDirection_data()
{
    QTest::addColumn<int>("channel");
    QTest::addColumn<int>("raw");
    QTest::addColumn<int>("sign");
    QTest::newRow("1 up") << 1 << 4600 << 1;
    QTest::newRow("1 down") << 1 << 2900 << -1;
    QTest::newRow("2 down") << 2 << 2900 << -1;
    QTest::newRow("2, a little over a quarter") << 2 << 3750 + 330 << 1;
    QTest::newRow("2, not a quarter") << 2 << 3750 + 290 << 0;
}

void TestLearnerSteps::pushedChannel_tellsItsDirection()
{
    QFETCH(int, channel);
    QFETCH(int, raw);
    QFETCH(int, sign);
    Bench bench;
    bench.learnAll();
    bench.learner.beginDirection(channel);
    bench.hold(500ms);
    bench.move(channel, raw, 500ms);
    const auto result = bench.learner.directionResult();
    QCOMPARE(result.has_value(), sign != 0);
    QCOMPARE(result ? result->sign : 0, sign);
    QVERIFY(!result || !result->isSwapped());
    QCOMPARE(bench.learner.result(channel).forwardSign, sign);
    QCOMPARE(bench.learner.result(channel).isReversed(), sign < 0);
}

void TestLearnerSteps::movingTogether_theAskedChannelWins()
{
    Bench bench;
    bench.learnAll();
    bench.learner.beginDirection(2);
    bench.hold(500ms);
    bench.at[0] = 2600; // a mixing transmitter moves 1 first and further
    bench.hold(60ms);
    bench.move(2, 4300, 600ms);
    QCOMPARE(bench.learner.directionResult(), (std::optional<DirectionResult>({2, 2, 1})));
}

void TestLearnerSteps::spikesAndHaste_areNoPush()
{
    Bench bench;
    bench.learnAll();
    bench.move(1, 4900, 300ms);
    bench.learner.beginDirection(1); // still held from before
    bench.hold(3s);
    QVERIFY(!bench.learner.isDirectionReady());
    QVERIFY(!bench.learner.directionResult());
    bench.move(1, 3750, 600ms);
    QVERIFY(bench.learner.isDirectionReady());
    for (int i = 0; i < 5; ++i) {
        bench.at[0] = 6000;
        bench.hold(40ms); // two wrong readings
        bench.at[0] = 3750;
        bench.hold(200ms);
    }
    QVERIFY(!bench.learner.directionResult());
}

void TestLearnerSteps::briefTouch_isNoPush()
{
    Bench bench;
    bench.learnAll();
    bench.learner.beginDirection(1);
    bench.hold(500ms);
    bench.at[0] = 4600;
    bench.hold(120ms); // past a majority of the latest readings, but not for long enough
    bench.at[0] = 3750;
    bench.hold(500ms);
    QVERIFY(!bench.learner.directionResult());
}

void TestLearnerSteps::othersMove_isNotSwappedWhileTheAskedStirs()
{
    Bench bench;
    bench.learnAll();
    bench.learner.beginDirection(1);
    bench.hold(500ms);
    bench.at = {3750 + 240, 3200, 3750, 3750, 3750}; // pushed slowly, and the other axis with it
    bench.hold(2s);
    QVERIFY(!bench.learner.directionResult());
    bench.move(1, 4300, 500ms);
    QCOMPARE(bench.learner.directionResult(), (std::optional<DirectionResult>({1, 1, 1})));
}

void TestLearnerSteps::otherStillMoving_isWatchedOnceItRests()
{
    Bench bench;
    bench.learnAll();
    bench.learner.beginDirection(1);
    for (int i = 0; i < 3; ++i) { // still played with while it is asked to rest
        bench.move(2, 4600, 300ms);
        bench.move(2, 3000, 300ms);
    }
    QVERIFY(bench.learner.isDirectionReady()); // it is not waited for for ever
    QVERIFY(!bench.learner.directionResult());
    bench.move(2, 3750, 500ms);
    bench.move(2, 4600, 1s);
    QCOMPARE(bench.learner.directionResult(), (std::optional<DirectionResult>({1, 2, 1})));
}

void TestLearnerSteps::unlearnedChannel_isFoundToo()
{
    Bench bench(InputKind::Rc, 0b00010);
    bench.at = {3700, 3750, int(kInvalidPulse), 2500, 5000};
    bench.learnAll();
    bench.learner.beginDirection(2);
    bench.hold(500ms);
    QVERIFY(bench.learner.isDirectionReady());
    bench.move(1, 3300, 1s);
    QCOMPARE(bench.learner.directionResult(), (std::optional<DirectionResult>({2, 1, -1})));
    QCOMPARE(bench.learner.result(2).swappedWith, 1);
}

void TestLearnerSteps::returns_tellRepeatabilityAndHysteresis()
{
    Bench bench(InputKind::Rc, 0b00001);
    bench.at[0] = 3720; // it came from below before
    bench.learnNeutral();
    bench.learner.beginReturns();
    QVERIFY(!bench.learner.areReturnsDone());
    bench.move(1, 4600, 300ms);
    QCOMPARE(bench.learner.returnState(1), ReturnState::Away);
    bench.move(1, 3780, 300ms);
    QCOMPARE(bench.learner.returnState(1), ReturnState::Settling);
    QCOMPARE(bench.learner.returnsSeen(1), 0);
    bench.hold(1s);
    QCOMPARE(bench.learner.returnsSeen(1), 1);
    QCOMPARE(bench.learner.returnState(1), ReturnState::Rest);
    bench.hold(3s); // only moved once
    QCOMPARE(bench.learner.returnsSeen(1), 1);
    bench.move(1, 2900, 300ms);
    bench.move(1, 3720, 1300ms);
    QCOMPARE(bench.learner.returnsSeen(1), 2);
    QVERIFY(bench.learner.areReturnsDone());
    bench.learner.beginExtremes();
    bench.sweep(1, 2500, 5000);
    const auto learned = bench.learner.result(1);
    QCOMPARE(learned.returns, 2);
    QCOMPARE(learned.neutral, 3750.0); // the middle of both sides
    QCOMPARE(learned.repeatability, 60.0);
    QCOMPARE(learned.hysteresis, std::optional(60.0));
    QCOMPARE(learned.farthestRest, 30.0);
    const ResponseCurve curve{learned.calibration, false, false};
    QCOMPARE(curve.remap(3720), 0);
    QCOMPARE(curve.remap(3780), 0);
    QVERIFY(centringText(learned, InputKind::Rc).contains(QStringLiteral("24 µs")));
}

void TestLearnerSteps::returns_skippedAreSaid()
{
    Bench bench(InputKind::Rc, 0b00001);
    bench.learnNeutral();
    bench.learner.beginReturns();
    bench.move(1, 4600, 300ms);
    bench.move(1, 3752, 1300ms);
    bench.learner.beginExtremes(); // left early
    bench.sweep(1, 2500, 5000);
    const auto once = bench.learner.result(1);
    QCOMPARE(once.returns, 1);
    QVERIFY(!once.hysteresis.has_value());
    QCOMPARE(once.verdict, Verdict::Good);

    Bench never(InputKind::Rc, 0b00001);
    never.learnAll();
    QCOMPARE(never.learner.result(1).returns, 0);
    QVERIFY(figuresText(never.learner.result(1), InputKind::Rc)
                .contains(QStringLiteral("Centring: not tried")));
}

void TestLearnerSteps::returns_mustBeStill()
{
    Bench bench(InputKind::Rc, 0b00001);
    bench.learnNeutral();
    bench.learner.beginReturns();
    bench.move(1, 4600, 300ms);
    for (int i = 0; i < 100; ++i) { // brought back by hand, never let go
        bench.at[0] = 3750 + (i % 20 < 10 ? i % 20 : 20 - i % 20) * 12;
        bench.hold(20ms);
    }
    QCOMPARE(bench.learner.returnsSeen(1), 0);
    bench.move(1, 3751, 1300ms);
    QCOMPARE(bench.learner.returnsSeen(1), 1);
    bench.move(1, 4100, 2s); // held beside its neutral: not away, and no return
    QCOMPARE(bench.learner.returnsSeen(1), 1);
}

void TestLearnerSteps::levers_areNotWaitedForToReturn()
{
    Bench bench(InputKind::Rc, 0b00101);
    bench.at[2] = 2500;
    bench.learnNeutral();
    bench.learner.beginReturns();
    for (int i = 0; i < 2; ++i) {
        QVERIFY(!bench.learner.areReturnsDone());
        bench.move(1, 4600, 300ms);
        bench.move(1, 3750, 1300ms);
    }
    QVERIFY(bench.learner.areReturnsDone());
    QCOMPARE(bench.learner.returnsSeen(3), 0);
}

void TestLearnerSteps::lostCentre_isDeclined()
{
    Bench bench(InputKind::Rc, 0b00001);
    bench.at[0] = 3640;
    bench.learnNeutral();
    bench.learner.beginReturns();
    for (const int rest : {3870, 3640}) {
        bench.move(1, rest > 3750 ? 4370 : 3130, 300ms);
        bench.move(1, rest, 1300ms);
    }
    QCOMPARE(bench.learner.returnsSeen(1), 2);
    bench.learner.beginExtremes();
    bench.sweep(1, 3110, 4400); // little travel: a quarter of it would be deadband
    const auto wide = bench.learner.result(1);
    QVERIFY(wide.has(Finding::SloppyCentre) || wide.has(Finding::CentreLost));
    ChannelMeasurement measured{.samples = 500, .hasNeutral = true, .neutral = 3750, .sigma = 2};
    measured.lowEnd = 3100;
    measured.highEnd = 4400;
    measured.returns = 2;
    measured.farthestRest = 125;
    QCOMPARE(judge(measured, InputKind::Rc).findings, std::vector{Finding::SloppyCentre});
    measured.farthestRest = 126.5;
    QCOMPARE(judge(measured, InputKind::Rc).findings, std::vector{Finding::CentreLost});
    measured.channel = 3; // a lever has no spring to lose
    QCOMPARE(judge(measured, InputKind::Rc).findings, std::vector{Finding::SloppyCentre});
}

void TestLearnerSteps::deadband_saysItsTerm()
{
    ChannelMeasurement measured{.samples = 500, .hasNeutral = true, .neutral = 3750, .sigma = 2};
    measured.lowEnd = 2500;
    measured.highEnd = 5000;
    auto learned = judge(measured, InputKind::Rc);
    QCOMPARE(learned.deadbandBasis, DeadbandBasis::Floor);
    QCOMPARE(learned.calibration.deadband, calibrationRules(InputKind::Rc).deadbandFloor);
    measured.sigma = 20;
    learned = judge(measured, InputKind::Rc);
    QCOMPARE(learned.deadbandBasis, DeadbandBasis::Noise);
    QCOMPARE(learned.calibration.deadband, 80); // 4 σ
    QVERIFY(deadbandText(learned, InputKind::Rc).contains(QStringLiteral("4 σ")));
    measured.returns = 2;
    measured.farthestRest = 40;
    learned = judge(measured, InputKind::Rc);
    QCOMPARE(learned.deadbandBasis, DeadbandBasis::Rests);
    QCOMPARE(learned.calibration.deadband, 110); // 1.25 × 40 + 3 σ
    QVERIFY(deadbandText(learned, InputKind::Rc).contains(QStringLiteral("1.25")));
}

void TestLearnerSteps::verify_comparesBeforeAndNow()
{
    Bench bench(InputKind::Rc, 0b00001);
    bench.learnAll(2600, 4900);
    CalibrationLearner::Curves before{};
    before[0] = ResponseCurve{{2500, 3750, 5000, 100}, false, false};
    bench.learner.beginVerify(before);
    const auto* channel = bench.learner.verified(1);
    QVERIFY(channel != nullptr);
    QVERIFY(bench.learner.verified(2) == nullptr); // not chosen
    QVERIFY(!channel->isConfirmed());
    bench.hold(1s);
    QCOMPARE(channel->now().atRest, std::optional(0));
    QVERIFY(!channel->isConfirmed());
    bench.sweep(1, 2600, 4900);
    QCOMPARE(channel->now().highest, 127);
    QCOMPARE(channel->now().lowest, -127);
    QCOMPARE(channel->before().highest, 115); // 127 × 1050 / 1150
    QCOMPARE(channel->before().lowest, -115);
    QVERIFY(channel->isConfirmed());
    QVERIFY(bench.learner.isVerified());
    QCOMPARE(bench.learner.result(1).verdict, Verdict::Good); // nothing was learned meanwhile
}

void TestLearnerSteps::verify_restBesideNeutralIsNotZero()
{
    Bench bench(InputKind::Rc, 0b00001);
    bench.learnAll();
    CalibrationLearner::Curves now{};
    now[0] = ResponseCurve{{2500, 3750, 5000, 10}, true, false}; // a person's own numbers, reversed
    bench.learner.beginVerify({}, now);
    bench.move(1, 3800, 1s);
    const auto* channel = bench.learner.verified(1);
    QVERIFY(channel->now().atRest.has_value());
    QVERIFY(*channel->now().atRest < 0);
    QVERIFY(!channel->isNeutralZero());
    bench.move(1, 3750, 1s);
    QVERIFY(channel->isNeutralZero());
}

void TestLearnerSteps::verify_ignoresSpikes()
{
    Bench bench(InputKind::Rc, 0b00001);
    bench.learnAll();
    bench.learner.beginVerify();
    for (int i = 0; i < 10; ++i) {
        bench.at[0] = 6000;
        bench.hold(60ms); // three in a row
        bench.at[0] = 3750;
        bench.hold(200ms);
    }
    const auto* channel = bench.learner.verified(1);
    QVERIFY(channel->samples() > 100);
    QCOMPARE(channel->now().highest, 0);
}

void TestLearnerSteps::staleRepeats_neitherPushNorVerify()
{
    Bench bench;
    bench.learnAll();
    const auto repeat = [&bench](int raw) {
        PollSample stale{PollId::RawChannels, {}, bench.now};
        stale.raw.fill(static_cast<std::uint16_t>(raw));
        for (int i = 0; i < 100; ++i) {
            bench.learner.feed(stale);
        }
    };
    bench.learner.beginDirection(1);
    bench.hold(500ms);
    repeat(4900);
    bench.hold(60ms);
    repeat(4900);
    QVERIFY(!bench.learner.directionResult());
    bench.learner.beginVerify();
    bench.hold(500ms);
    const int samples = bench.learner.verified(1)->samples();
    repeat(5000);
    QCOMPARE(bench.learner.verified(1)->samples(), samples);
    QCOMPARE(bench.learner.verified(1)->now().highest, 0);
}

void TestLearnerSteps::curve_followsTheDocument()
{
    ResponseCurve curve{{2500, 3750, 5000, 100}, false, false};
    QCOMPARE(curve.remap(3750), 0);
    QCOMPARE(curve.remap(3850), 0);
    QCOMPARE(curve.remap(3650), 0);
    QCOMPARE(curve.remap(5000), 127);
    QCOMPARE(curve.remap(6250), 127);
    QCOMPARE(curve.remap(2500), -127);
    QCOMPARE(curve.remap(1250), -127);
    QCOMPARE(curve.remap(3850 + 575), 63); // half of what is left
    QCOMPARE(curve.remap(3650 - 575), -63);
    QCOMPARE(curve.shape(3850 + 575), 63.5);
    QCOMPARE(curve.grade(), Grade::Documented);
    curve.reversed = true;
    QCOMPARE(curve.remap(5000), -127);
    QCOMPARE(curve.remap(3075), 63);
    curve.parabolic = true;
    QCOMPARE(curve.remap(5000), -127);
    QCOMPARE(curve.remap(3075), 31); // 63² / 127
    QVERIFY(isGuess(curve.grade()));
    // A deadband that reaches beyond an end: 127 there still, and nothing divided by nothing.
    const ResponseCurve narrow{{3700, 3750, 3800, 100}, false, false};
    QCOMPARE(narrow.remap(3800), 127);
    QCOMPARE(narrow.remap(3799), 0);
    QCOMPARE(narrow.remap(3700), -127);
}

void TestLearnerSteps::curve_switchesHalfWay()
{
    for (const bool reversed : {false, true}) {
        for (const bool parabolic : {false, true}) {
            const ResponseCurve curve{{2500, 3750, 5000, 100}, reversed, parabolic};
            const double threshold = curve.switchThreshold();
            const double off = reversed ? -15 : 15;
            QVERIFY(!curve.isSwitchedOn(3750));
            QVERIFY(curve.isSwitchedOn(threshold - off));
            QVERIFY(!curve.isSwitchedOn(threshold + off));
        }
    }
    const ResponseCurve plain{{2500, 3750, 5000, 100}, false, false};
    QVERIFY(std::abs(plain.switchThreshold() - (3650 - 1150 * 64 / 127.0)) < 0.001);
}

void TestLearnerSteps::figures_nameEveryTerm()
{
    Bench bench(InputKind::Rc, 0b00001);
    bench.learnAll();
    const QString text = figuresText(bench.learner.result(1), InputKind::Rc);
    for (const auto* term : {"Samples", "missed", "Noise", "σ", "Travel", "symmetry", "Centring",
                             "Deadband", "pulled in", "127"}) {
        QVERIFY2(text.contains(QString::fromUtf8(term)), term);
    }
    QVERIFY(!text.contains(u'%' + QStringLiteral("1")));
}

QTEST_GUILESS_MAIN(TestLearnerSteps)
#include "tst_learnersteps.moc"
