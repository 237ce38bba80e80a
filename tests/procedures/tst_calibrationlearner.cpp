// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/calibrationlearner.h"
#include "protocol/procedures/robuststatistics.h"

#include "tests/procedures/generatedstick.h"

#include <QTest>

using namespace std::chrono_literals;
using namespace trex;

namespace {

struct Learning {
    bool neutralDone = false;
    bool endsDone = false;
    LearnedChannel learned;
};

/// Plays a stick to one channel as the wizard would: still for 3 s (again if it must), then swept
/// until done, 24 s at most.
Learning learn(const GeneratedStick& stick, int number = 1, InputKind input = InputKind::Rc)
{
    Learning outcome;
    ChannelLearner channel(number, input, CalibrationLearner::kDefaultStillTime);
    StickPlayer player(stick);
    const auto& rules = calibrationRules(input);
    Instant now{};
    channel.beginNeutral();
    for (int i = 0; i < 500 && !channel.hasStillWindow(); ++i) {
        now += GeneratedStick::kInterval;
        channel.feed(player.reading(stick.neutral, rules.smallest, rules.largest), now);
    }
    outcome.neutralDone = channel.hasStillWindow();
    if (outcome.neutralDone) {
        channel.beginExtremes();
        for (int i = 0; i < 1200 && !channel.areEndsSettled(); ++i) {
            now += GeneratedStick::kInterval;
            const double at = i * std::chrono::duration<double>(GeneratedStick::kInterval).count();
            channel.feed(player.reading(stick.position(at), rules.smallest, rules.largest), now);
        }
        outcome.endsDone = channel.areEndsSettled();
    }
    outcome.learned = channel.result();
    return outcome;
}

void feedFor(ChannelLearner& channel, Instant& now, Duration time, int raw)
{
    for (const Instant end = now + time; now < end;) {
        now += GeneratedStick::kInterval;
        channel.feed(raw, now);
    }
}

} // namespace

class TestCalibrationLearner : public QObject {
    Q_OBJECT

private slots:
    void statistics_ignoreSpikes();
    void cleanStick_isGood_data();
    void cleanStick_isGood();
    void generatedSticks_areLearnedOrDeclined_data();
    void generatedSticks_areLearnedOrDeclined();
    void declined_saysWhy_data();
    void declined_saysWhy();
    void spike_reachesNoEnd();
    void spike_doesNotBreakTheStillWindow();
    void movement_restartsTheWindow();
    void slowDrift_isNotStill();
    void silence_breaksTheWindow();
    void repeatedRead_isNoSample();
    void invalidPulse_isCountedNotAveraged(); // C-24
    void lever_getsTheOtherEndAsFarAway();
    void margin_letsFullStickGiveFullSpeed();
    void deadband_growsWithNoise();
    void otherChannels_areNotWaitedFor();
    void endsGrowing_areNotSettled();
};

void TestCalibrationLearner::statistics_ignoreSpikes()
{
    std::vector<int> values;
    for (int i = 0; i < 100; ++i) {
        values.push_back(100 + i % 3); // 100, 101, 102
    }
    values[10] = values[50] = 6000;
    QCOMPARE(medianOf(values), 101.0);
    QVERIFY(robustSigma(values) < 2.0);
    QVERIFY(robustSigma(values) > 0.5);
    QVERIFY(differenceSigma(values) < 2.5);
    QCOMPARE(medianOf({}), 0.0);
    QCOMPARE(robustSigma({}), 0.0);
    const std::vector<int> mostlyEqual{5, 5, 5, 5, 5, 5, 5, 6, 6, 6};
    QVERIFY(robustSigma(mostlyEqual) > 0.0); // the median deviation alone would say 0
}

void TestCalibrationLearner::cleanStick_isGood_data()
{
    QTest::addColumn<int>("input");
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("neutral");
    QTest::addColumn<double>("high");
    QTest::addColumn<bool>("startsDown");
    const int rc = int(InputKind::Rc);
    const int analog = int(InputKind::Analog);
    QTest::newRow("rc") << rc << 2500.0 << 3750.0 << 5000.0 << false;
    QTest::newRow("rc, reversed") << rc << 2500.0 << 3750.0 << 5000.0 << true;
    QTest::newRow("rc, off centre") << rc << 2700.0 << 3600.0 << 5100.0 << false;
    QTest::newRow("analog") << analog << 100.0 << 512.0 << 900.0 << false;
}

void TestCalibrationLearner::cleanStick_isGood()
{
    QFETCH(int, input);
    QFETCH(double, low);
    QFETCH(double, neutral);
    QFETCH(double, high);
    QFETCH(bool, startsDown);
    const GeneratedStick stick{
        .neutral = neutral, .low = low, .high = high, .sigma = 1.0, .startsDown = startsDown};
    const auto outcome = learn(stick, 1, static_cast<InputKind>(input));
    QVERIFY(outcome.neutralDone && outcome.endsDone);
    QCOMPARE(outcome.learned.verdict, Verdict::Good);
    const Calibration& learned = outcome.learned.calibration;
    QVERIFY(std::abs(learned.neutral - neutral) <= 1.5);
    QVERIFY(std::abs(learned.minimum - low) <= 0.01 * (high - low));
    QVERIFY(std::abs(learned.maximum - high) <= 0.01 * (high - low));
    QCOMPARE(learned.deadband, calibrationRules(static_cast<InputKind>(input)).deadbandFloor);
    QVERIFY(validate(learned).has_value());
}

void TestCalibrationLearner::generatedSticks_areLearnedOrDeclined_data()
{
    QTest::addColumn<double>("mostNoise"); // share of the travel
    QTest::addColumn<double>("spikes");
    QTest::addColumn<double>("missing");
    QTest::addColumn<int>("sweep");
    QTest::addColumn<double>("tolerance"); // of the ends, share of the travel
    QTest::addColumn<double>("leastLearned"); // share of the sticks
    const int dwell = int(GeneratedStick::Sweep::Dwell);
    const int sine = int(GeneratedStick::Sweep::Sine);
    QTest::newRow("clean") << 0.003 << 0.0 << 0.0 << dwell << 0.01 << 1.0;
    QTest::newRow("clean sine") << 0.003 << 0.0 << 0.0 << sine << 0.01 << 0.98;
    QTest::newRow("noisy") << 0.02 << 0.0 << 0.0 << dwell << 0.01 << 0.4;
    // Noise and an end that is never held: it is learned right, or declined.
    QTest::newRow("noisy sine") << 0.006 << 0.0 << 0.0 << sine << 0.01 << 0.6;
    QTest::newRow("spikes") << 0.005 << 0.02 << 0.0 << dwell << 0.01 << 0.9;
    QTest::newRow("missing pulses") << 0.005 << 0.0 << 0.2 << dwell << 0.01 << 0.5;
    QTest::newRow("all of it") << 0.02 << 0.02 << 0.2 << dwell << 0.01 << 0.1;
}

void TestCalibrationLearner::generatedSticks_areLearnedOrDeclined()
{
    QFETCH(double, mostNoise);
    QFETCH(double, spikes);
    QFETCH(double, missing);
    QFETCH(int, sweep);
    QFETCH(double, tolerance);
    QFETCH(double, leastLearned);
    constexpr int kSticks = 300;
    int learnedCount = 0;
    std::mt19937 random(20);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (unsigned seed = 1; seed <= kSticks; ++seed) {
        GeneratedStick stick;
        stick.neutral = 3500.0 + 500.0 * unit(random);
        stick.low = stick.neutral - 800.0 - 500.0 * unit(random);
        stick.high = stick.neutral + 800.0 + 500.0 * unit(random);
        const double travel = stick.high - stick.low;
        stick.sigma = mostNoise * travel * unit(random);
        stick.spikeShare = spikes;
        stick.missingShare = missing * unit(random);
        stick.sweep = static_cast<GeneratedStick::Sweep>(sweep);
        stick.startsDown = unit(random) < 0.5;
        stick.seed = seed;
        const auto outcome = learn(stick);
        const auto& learned = outcome.learned;
        const auto where =
            QStringLiteral("stick %1: σ %2, missing %3; learned %4 %5 %6 of %7 %8 %9")
                .arg(seed)
                .arg(stick.sigma)
                .arg(stick.missingShare)
                .arg(learned.calibration.minimum)
                .arg(learned.calibration.neutral)
                .arg(learned.calibration.maximum)
                .arg(stick.low)
                .arg(stick.neutral)
                .arg(stick.high)
                .toUtf8();
        if (learned.verdict == Verdict::DoAgain) {
            // Only for what is wrong with it: an end that is not held is sooner lost in noise.
            const double leastNoise = stick.sweep == GeneratedStick::Sweep::Sine ? 0.0015 : 0.007;
            for (const Finding finding : learned.findings) {
                const bool isTrue = (finding == Finding::Noisy && stick.sigma > leastNoise * travel)
                    || (finding == Finding::NotHeld && stick.sigma > leastNoise * travel)
                    || (finding == Finding::NotStill && stick.sigma > 0.009 * travel)
                    || (finding == Finding::Jitter && stick.spikeShare >= 0.02)
                    || (finding == Finding::MissingPulses && stick.missingShare > 0.15);
                QVERIFY2(isTrue, where.constData());
            }
            continue;
        }
        ++learnedCount;
        QVERIFY2(outcome.endsDone, where.constData());
        QVERIFY2(std::abs(learned.calibration.minimum - stick.low) <= tolerance * travel,
                 where.constData());
        QVERIFY2(std::abs(learned.calibration.maximum - stick.high) <= tolerance * travel,
                 where.constData());
        QVERIFY2(std::abs(learned.calibration.neutral - stick.neutral)
                     <= std::max(1.0, 1.5 * stick.sigma),
                 where.constData());
        QVERIFY2(validate(learned.calibration).has_value(), where.constData());
        QVERIFY2(learned.calibration.deadband >= 3.0 * stick.sigma, where.constData());
    }
    QVERIFY2(learnedCount >= leastLearned * kSticks, qPrintable(QString::number(learnedCount)));
}

void TestCalibrationLearner::declined_saysWhy_data()
{
    QTest::addColumn<int>("sweep");
    QTest::addColumn<double>("reach");
    QTest::addColumn<double>("sigma");
    QTest::addColumn<double>("missing");
    QTest::addColumn<int>("reason");
    using Sweep = GeneratedStick::Sweep;
    QTest::newRow("not moved") << int(Sweep::Nothing) << 1250.0 << 2.0 << 0.0
                               << int(Finding::NotMoved);
    QTest::newRow("up only") << int(Sweep::UpOnly) << 1250.0 << 2.0 << 0.0
                             << int(Finding::OneDirection);
    QTest::newRow("down only") << int(Sweep::DownOnly) << 1250.0 << 2.0 << 0.0
                               << int(Finding::OneDirection);
    QTest::newRow("too small") << int(Sweep::Dwell) << 400.0 << 2.0 << 0.0
                               << int(Finding::TravelTooSmall);
    QTest::newRow("noisy") << int(Sweep::Dwell) << 1250.0 << 40.0 << 0.0 << int(Finding::Noisy);
    QTest::newRow("jitter") << int(Sweep::Dwell) << 1250.0 << 400.0 << 0.0
                            << int(Finding::NotStill);
    QTest::newRow("missing") << int(Sweep::Dwell) << 1250.0 << 2.0 << 0.4
                             << int(Finding::MissingPulses);
    QTest::newRow("no pulse") << int(Sweep::Dwell) << 1250.0 << 2.0 << 1.0
                              << int(Finding::NoReadings);
}

void TestCalibrationLearner::declined_saysWhy()
{
    QFETCH(int, sweep);
    QFETCH(double, reach);
    QFETCH(double, sigma);
    QFETCH(double, missing);
    QFETCH(int, reason);
    const GeneratedStick stick{.low = 3750.0 - reach,
                               .high = 3750.0 + reach,
                               .sigma = sigma,
                               .missingShare = missing,
                               .sweep = static_cast<GeneratedStick::Sweep>(sweep)};
    const auto learned = learn(stick).learned;
    QCOMPARE(learned.verdict, Verdict::DoAgain);
    QCOMPARE(int(learned.findings.front()), reason);
}

void TestCalibrationLearner::spike_reachesNoEnd()
{
    ChannelLearner channel(1, InputKind::Rc, 2s);
    Instant now{};
    feedFor(channel, now, 3s, 3750);
    channel.beginExtremes();
    feedFor(channel, now, 1s, 4600);
    for (int i = 0; i < 3; ++i) { // three wrong readings in a row
        now += GeneratedStick::kInterval;
        channel.feed(6000, now);
    }
    feedFor(channel, now, 1s, 4600);
    QCOMPARE(channel.highTravel(), 850);
    QCOMPARE(channel.lowTravel(), 0);
    feedFor(channel, now, 300ms, 6000); // held: an end
    QCOMPARE(channel.highTravel(), 2250);
}

void TestCalibrationLearner::spike_doesNotBreakTheStillWindow()
{
    ChannelLearner channel(1, InputKind::Rc, 2s);
    Instant now{};
    feedFor(channel, now, 1s, 3750);
    now += GeneratedStick::kInterval;
    channel.feed(6000, now);
    feedFor(channel, now, 1100ms, 3750);
    QVERIFY(channel.hasStillWindow());
    QCOMPARE(channel.restarts(), 0);
    channel.beginExtremes();
    QCOMPARE(channel.result().neutral, 3750.0);
}

void TestCalibrationLearner::movement_restartsTheWindow()
{
    ChannelLearner channel(1, InputKind::Rc, 2s);
    Instant now{};
    feedFor(channel, now, 1900ms, 3750);
    QVERIFY(!channel.hasStillWindow());
    feedFor(channel, now, 500ms, 3850);
    QVERIFY(!channel.hasStillWindow());
    QCOMPARE(channel.restarts(), 1);
    QCOMPARE(channel.movedBy(), 100);
    QVERIFY(channel.stillFor() < 600ms);
    feedFor(channel, now, 2s, 3850);
    QVERIFY(channel.hasStillWindow());
    channel.beginExtremes();
    QCOMPARE(channel.result().neutral, 3850.0); // nothing of before the movement
}

void TestCalibrationLearner::slowDrift_isNotStill()
{
    // 10 µs a second restarts the window now and then; 5 µs a second shows only over all of it.
    for (const int percent : {50, 26}) {
        ChannelLearner channel(1, InputKind::Rc, 2s);
        Instant now{};
        for (int i = 0; i < 300; ++i) {
            now += GeneratedStick::kInterval;
            channel.feed(3750 + i * percent / 100, now);
            QVERIFY(!channel.hasStillWindow());
        }
    }
}

void TestCalibrationLearner::silence_breaksTheWindow()
{
    ChannelLearner channel(1, InputKind::Rc, 2s);
    Instant now{};
    feedFor(channel, now, 1500ms, 3750);
    now += 1s;
    feedFor(channel, now, 1s, 3750);
    QVERIFY(!channel.hasStillWindow());
    feedFor(channel, now, 1100ms, 3750);
    QVERIFY(channel.hasStillWindow());
    feedFor(channel, now, 1s, kInvalidPulse); // still no more: the window is old
    QVERIFY(!channel.hasStillWindow());
}

void TestCalibrationLearner::repeatedRead_isNoSample()
{
    ChannelLearner channel(1, InputKind::Rc, 2s);
    const Instant now = Instant{} + 1s;
    for (int i = 0; i < 1000; ++i) {
        channel.feed(3750, now); // a stale value, repeated
    }
    QCOMPARE(channel.result().samples, 1);
    QVERIFY(!channel.hasStillWindow());
    channel.feed(3750, now - 1ms); // out of order
    QCOMPARE(channel.result().samples, 1);
}

void TestCalibrationLearner::invalidPulse_isCountedNotAveraged()
{
    ChannelLearner channel(1, InputKind::Rc, 2s);
    Instant now{};
    for (int i = 0; i < 110; ++i) {
        now += GeneratedStick::kInterval;
        channel.feed(i % 10 == 0 ? kInvalidPulse : 3750, now);
        QCOMPARE(channel.isValid(), i % 10 != 0);
    }
    QVERIFY(channel.hasStillWindow());
    channel.beginExtremes();
    const auto learned = channel.result();
    QCOMPARE(learned.neutral, 3750.0);
    QCOMPARE(learned.sigma, 0.0);
    QVERIFY(learned.missed >= 9 && learned.missed <= 11);
    QCOMPARE(learned.highEnd, 3750.0);
}

void TestCalibrationLearner::lever_getsTheOtherEndAsFarAway()
{
    GeneratedStick stick{.neutral = 2500.0,
                         .low = 2500.0,
                         .high = 5000.0,
                         .sigma = 2.0,
                         .sweep = GeneratedStick::Sweep::UpOnly};
    const auto lever = learn(stick, 3);
    QVERIFY(lever.endsDone);
    QCOMPARE(lever.learned.verdict, Verdict::Usable);
    QVERIFY(lever.learned.has(Finding::RestsAtEnd));
    QCOMPARE(lever.learned.calibration.minimum, 1250); // as far away, within what can be read
    QVERIFY(std::abs(lever.learned.calibration.maximum - 5000) <= 25);

    stick = {.neutral = 5000.0,
             .low = 3500.0,
             .high = 5000.0,
             .sigma = 2.0,
             .sweep = GeneratedStick::Sweep::DownOnly};
    const auto aSwitch = learn(stick, 5);
    QCOMPARE(aSwitch.learned.verdict, Verdict::Usable);
    QVERIFY(aSwitch.learned.calibration.maximum > 5000 + 1000);
    QCOMPARE(learn(stick, 1).learned.verdict, Verdict::DoAgain); // a drive channel is not a lever
}

void TestCalibrationLearner::margin_letsFullStickGiveFullSpeed()
{
    for (unsigned seed = 1; seed <= 30; ++seed) {
        const GeneratedStick stick{.sigma = 4.0, .seed = seed};
        const auto learned = learn(stick).learned;
        // The stick held at its end, without noise, is beyond the calibration's end (C-28: 127).
        QVERIFY(learned.calibration.maximum <= stick.high);
        QVERIFY(learned.calibration.minimum >= stick.low);
        QVERIFY(learned.highMargin >= 6 && learned.highMargin <= 10); // 0.5 to 0.75 % of 1250
    }
}

void TestCalibrationLearner::deadband_growsWithNoise()
{
    const auto quiet = learn({.sigma = 1.0}).learned;
    const auto noisy = learn({.sigma = 20.0}).learned;
    QCOMPARE(quiet.calibration.deadband, calibrationRules(InputKind::Rc).deadbandFloor);
    QCOMPARE(noisy.verdict, Verdict::Usable);
    QVERIFY(noisy.has(Finding::SomeNoise));
    QCOMPARE(noisy.calibration.deadband, int(std::ceil(kDeadbandSigmas * noisy.sigma)));
    QVERIFY(noisy.calibration.deadband > 55 && noisy.calibration.deadband < 120);
}

void TestCalibrationLearner::otherChannels_areNotWaitedFor()
{
    CalibrationLearner learner(InputKind::Rc, 0b00010);
    learner.beginNeutral();
    PollSample sample{PollId::RawChannels, {}, {}};
    sample.raw.fill(kInvalidPulse);
    sample.raw[1] = 3750;
    QVERIFY(!learner.isNeutralDone());
    for (int i = 0; i < 110; ++i) {
        sample.time += GeneratedStick::kInterval;
        learner.feed(sample);
    }
    QVERIFY(learner.isNeutralDone());
    QCOMPARE(learner.neutralRemaining(), Duration::zero());
    CalibrationLearner both(InputKind::Rc, 0b00011);
    both.beginNeutral();
    for (int i = 0; i < 110; ++i) {
        sample.time += GeneratedStick::kInterval;
        both.feed(sample);
        auto other = sample;
        other.poll = PollId::RemappedChannels; // not what it learns from
        other.time += 1ms;
        other.raw.fill(3750);
        both.feed(other);
    }
    QVERIFY(!both.isNeutralDone());
    QCOMPARE(both.neutralRemaining(), Duration(2s));
}

void TestCalibrationLearner::endsGrowing_areNotSettled()
{
    ChannelLearner channel(1, InputKind::Rc, 2s);
    Instant now{};
    feedFor(channel, now, 3s, 3750);
    channel.beginExtremes();
    QCOMPARE(channel.highNeeded(), 625);
    feedFor(channel, now, 1s, 4375);
    QCOMPARE(channel.highNeeded(), 0);
    QCOMPARE(channel.lowNeeded(), 625);
    feedFor(channel, now, 2s, 3000);
    QVERIFY(channel.areEndsSettled());
    feedFor(channel, now, 500ms, 2500); // goes on
    QVERIFY(!channel.areEndsSettled());
    feedFor(channel, now, 2s, 3750);
    QVERIFY(channel.areEndsSettled());
    QCOMPARE(channel.lowTravel(), 1250);
}

QTEST_GUILESS_MAIN(TestCalibrationLearner)
#include "tst_calibrationlearner.moc"
