// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of generated sticks, whose truth is known, played to the learner as a person would move
// them: each is learned right or declined for what is wrong with it.
#include "protocol/procedures/calibrationlearner.h"
#include "protocol/procedures/calibrationtext.h"

#include "tests/procedures/generatedstick.h"

#include <QTest>

#include <cstdio>
#include <functional>
#include <map>

using namespace std::chrono_literals;
using namespace trex;

namespace {

constexpr double kEndTolerance = 0.01; // of the travel
constexpr double kNeutralTolerance = 1.5; // σ, but one count at least
constexpr int kCasesEach = 240; // of each class

double seconds(Duration time)
{
    return std::chrono::duration<double>(time).count();
}

using Chance = std::uniform_real_distribution<double>;

/// One stick and how it is played.
struct Case {
    GeneratedStick stick;
    InputKind input = InputKind::Rc;
    int channel = 1;
    bool hasReturns = true;
    /// Replaces the stick's readings where it is none: another kind of input, nothing at all.
    std::function<int(double seconds, std::mt19937& random)> foreign{};
};

/// A class of sticks: how to make one, and for what it may be declined.
struct StickClass {
    const char* name;
    void (*shape)(Case& one, std::mt19937& random);
    bool (*isRight)(Finding reason, const Case& one);
    double leastAccepted; ///< share
    double mostAccepted; ///< share
};

struct Played {
    LearnedChannel learned;
    bool endsDone = false;
    double seconds = 0.0; ///< when the neutral was settled
    int fed = 0; ///< fresh readings
    int fedValid = 0;
    double spikeShare = 0.0; ///< of the fresh readings
};

/// Plays a case as the wizard would. With `poison`, each fresh sample is followed by repeats of its
/// time (and earlier ones) with other values: a dead link's stale data.
class Player {
public:
    Player(const Case& one, bool poison)
        : m_case(one)
        , m_poison(poison)
        , m_player(one.stick)
        , m_random(one.stick.seed + 77)
        , m_rules(calibrationRules(one.input))
        , m_learner(one.input, static_cast<std::uint8_t>(1U << (one.channel - 1)))
    {
    }

    Played play()
    {
        const auto& stick = m_case.stick;
        m_learner.beginNeutral();
        const double rest = stick.neutral + stick.play * (stick.startsDown ? -1 : 1);
        for (int i = 0; i < 600 && !m_learner.isNeutralDone(); ++i) {
            feed(rest);
        }
        if (m_learner.isNeutralDone()) {
            if (m_case.hasReturns && stick.sweep != GeneratedStick::Sweep::Nothing) {
                playReturns();
            }
            m_played.seconds = seconds(m_now.time_since_epoch());
            m_learner.beginExtremes();
            const auto start = m_now;
            for (int i = 0; i < 1200 && !m_learner.areExtremesDone(); ++i) {
                feed(stick.position(seconds(m_now - start)));
            }
        }
        m_played.endsDone = m_learner.areExtremesDone();
        m_played.spikeShare = double(m_player.spikes()) / std::max(1, m_played.fed);
        m_played.learned = m_learner.result(m_case.channel);
        return m_played;
    }

private:
    void playReturns()
    {
        const auto& stick = m_case.stick;
        m_learner.beginReturns();
        int side = stick.startsDown ? -1 : 1;
        side = stick.sweep == GeneratedStick::Sweep::UpOnly  ? 1
            : stick.sweep == GeneratedStick::Sweep::DownOnly ? -1
                                                             : side;
        const bool isOneWay = stick.sweep == GeneratedStick::Sweep::UpOnly
            || stick.sweep == GeneratedStick::Sweep::DownOnly;
        for (int move = 0; move < 6 && !m_learner.areReturnsDone(); ++move) {
            for (int i = 0; i < 50; ++i) { // out, held, back
                feed(stick.at(side * std::min({i / 15.0, 0.9, (49 - i) / 15.0})));
            }
            for (int i = 0; i < 70 && !m_learner.areReturnsDone(); ++i) {
                feed(stick.neutral + side * stick.play);
            }
            side = isOneWay ? side : -side;
        }
    }

    void feed(double position)
    {
        m_now += GeneratedStick::kInterval;
        const double at = seconds(m_now.time_since_epoch());
        PollSample sample{PollId::RawChannels, {}, m_now};
        sample.raw.fill(kInvalidPulse);
        auto& raw = sample.raw.at(static_cast<std::size_t>(m_case.channel - 1));
        const int value = m_case.foreign ? m_case.foreign(at, m_random)
                                         : m_player.reading(position + m_case.stick.offset(at),
                                                            m_rules.smallest, m_rules.largest);
        raw = static_cast<std::uint16_t>(value);
        m_learner.feed(sample);
        ++m_played.fed;
        m_played.fedValid += value >= m_rules.smallest && value <= m_rules.largest ? 1 : 0;
        if (m_poison) {
            for (const int bad : {m_rules.smallest, m_rules.largest, int(kInvalidPulse)}) {
                raw = static_cast<std::uint16_t>(bad);
                m_learner.feed(sample);
            }
            sample.time -= 1ms;
            m_learner.feed(sample);
        }
    }

    const Case& m_case;
    bool m_poison;
    StickPlayer m_player;
    std::mt19937 m_random;
    const CalibrationRules& m_rules;
    CalibrationLearner m_learner;
    Instant m_now{};
    Played m_played;
};

double between(double low, double high, std::mt19937& random)
{
    return Chance(low, high)(random);
}

/// A usual stick of either kind, with next to no noise.
Case usualCase(unsigned seed, std::mt19937& random)
{
    Case one;
    const bool isRc = seed % 2 == 0;
    one.input = isRc ? InputKind::Rc : InputKind::Analog;
    one.channel = seed % 4 < 2 ? 1 : 2;
    auto& stick = one.stick;
    stick.neutral = isRc ? between(3500, 4000, random) : between(440, 580, random);
    stick.low = stick.neutral - (isRc ? between(750, 1300, random) : between(180, 420, random));
    stick.high = stick.neutral + (isRc ? between(750, 1300, random) : between(180, 420, random));
    stick.sigma = between(0.0, 0.001, random) * stick.travel();
    stick.startsDown = between(0, 1, random) < 0.5;
    stick.seed = seed;
    one.hasReturns = seed % 3 != 0;
    return one;
}

bool never(Finding /*reason*/, const Case& /*one*/)
{
    return false;
}

/// For noise, spikes and missing pulses: only when there are nearly so many as are not accepted.
bool isTooMuch(Finding reason, const Case& one)
{
    const auto& stick = one.stick;
    return (reason == Finding::Noisy && stick.sigma > 0.005 * stick.travel())
        || (reason == Finding::NotStill && stick.sigma > 0.0085 * stick.travel())
        || (reason == Finding::MissingPulses && stick.missingShare > 0.15)
        || (reason == Finding::Jitter && stick.spikeShare > 0.015);
}

/// With noise, an end must be held.
bool isTooMuchToSwing(Finding reason, const Case& one)
{
    return isTooMuch(reason, one)
        || (reason == Finding::NotHeld && one.stick.sigma > 0.0025 * one.stick.travel());
}

/// Expo makes a swing through an end shorter still.
bool isSteepSwing(Finding reason, const Case& one)
{
    return reason == Finding::NotHeld && one.stick.sweep == GeneratedStick::Sweep::Sine
        && one.stick.expo > 2.2;
}

template <Finding... kReasons>
bool isOneOf(Finding reason, const Case& /*one*/)
{
    return ((reason == kReasons) || ...);
}

using Sweep = GeneratedStick::Sweep;

// clang-format off
const StickClass kClasses[] = {
    {"clean", [](Case&, std::mt19937&) {}, never, 1.0, 1.0},
    {"noise 0 to 2 %, held", [](Case& one, std::mt19937& random) {
        one.stick.sigma = between(0, 0.02, random) * one.stick.travel(); }, isTooMuch, 0.4, 0.6},
    {"noise 0 to 2 %, swung", [](Case& one, std::mt19937& random) {
        one.stick.sigma = between(0, 0.02, random) * one.stick.travel();
        one.stick.sweep = Sweep::Sine; }, isTooMuchToSwing, 0.12, 0.6},
    {"spikes to 3.5 %", [](Case& one, std::mt19937& random) {
        one.stick.sigma = between(0, 0.005, random) * one.stick.travel();
        one.stick.spikeShare = between(0, 0.035, random); }, isTooMuch, 0.98, 1.0},
    {"pulses missing to 20 %", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Rc; one.stick = usualCase(one.stick.seed & ~1U, random).stick;
        one.stick.missingShare = between(0, 0.2, random); }, isTooMuch, 0.85, 1.0},
    {"pulses missing 28 to 60 %", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Rc; one.stick = usualCase(one.stick.seed & ~1U, random).stick;
        one.stick.missingShare = between(0.28, 0.6, random); }, isOneOf<Finding::MissingPulses>, 0.0, 0.0},
    {"reversed", [](Case& one, std::mt19937&) { one.stick.startsDown = true; }, never, 1.0, 1.0},
    {"one-sided, drive", [](Case& one, std::mt19937& random) {
        one.stick.sweep = between(0, 1, random) < 0.5 ? Sweep::UpOnly : Sweep::DownOnly; },
        isOneOf<Finding::OneDirection>, 0.0, 0.0},
    {"one-sided, lever or switch", [](Case& one, std::mt19937& random) {
        one.channel = 3 + static_cast<int>(one.stick.seed % 3);
        one.stick.sweep = between(0, 1, random) < 0.5 ? Sweep::UpOnly : Sweep::DownOnly; }, never, 1.0, 1.0},
    {"asymmetrical to 1:4", [](Case& one, std::mt19937& random) {
        const bool isRc = one.input == InputKind::Rc;
        const double side = isRc ? between(640, 700, random) : between(130, 150, random);
        const double other = side * between(1.5, isRc ? 3.3 : 3.8, random);
        one.stick.neutral = isRc ? 3750 : between(1, 2, random) < 1.5 ? 440 : 580;
        const bool isUp = isRc ? between(0, 1, random) < 0.5 : one.stick.neutral < 500;
        one.stick.low = std::max(isRc ? 1260.0 : 5.0, one.stick.neutral - (isUp ? side : other));
        one.stick.high = std::min(isRc ? 6240.0 : 1018.0, one.stick.neutral + (isUp ? other : side)); },
        never, 1.0, 1.0},
    {"expo to cubic", [](Case& one, std::mt19937& random) {
        one.stick.expo = between(1.0, 3.0, random);
        one.stick.sweep = between(0, 1, random) < 0.5 ? Sweep::Sine : Sweep::Dwell; }, isSteepSwing, 0.95, 1.0},
    {"sticky centre", [](Case& one, std::mt19937& random) {
        one.hasReturns = true;
        one.stick.play = between(0.002, 0.02, random) * one.stick.travel(); }, never, 1.0, 1.0},
    {"wandering to 0.3 %", [](Case& one, std::mt19937& random) {
        one.stick.wander = between(0, 0.003, random) * one.stick.travel();
        one.stick.wanderPeriod = between(2, 15, random); }, isOneOf<Finding::NotStill>, 0.9, 1.0},
    {"creeping, then at rest", [](Case& one, std::mt19937& random) {
        const double least = std::max(3.0, 3.0 * one.stick.sigma);
        one.stick.creep = between(least, 20.0 * least, random);
        one.stick.creepUntil = between(1.5, 7.5, random) * least / one.stick.creep; }, never, 1.0, 1.0},
    {"creeping for ever", [](Case& one, std::mt19937& random) {
        one.stick.creep = between(1.0, 4.0, random) * std::max(3.0, 3.0 * one.stick.sigma);
        one.stick.creepUntil = 1e9; }, isOneOf<Finding::NotStill>, 0.0, 0.0},
    {"not moved", [](Case& one, std::mt19937&) { one.stick.sweep = Sweep::Nothing; },
        isOneOf<Finding::NotMoved>, 0.0, 0.0},
    {"too little travel", [](Case& one, std::mt19937& random) {
        const double needed = calibrationRules(one.input).neededTravel;
        one.stick.low = one.stick.neutral - between(0.35, 0.95, random) * needed;
        one.stick.high = one.stick.neutral + between(0.35, 0.95, random) * needed; },
        isOneOf<Finding::TravelTooSmall>, 0.0, 0.0},
    {"rushed, never held", [](Case& one, std::mt19937& random) {
        one.stick.sweep = Sweep::Sine; one.stick.period = between(0.25, 3.0, random); },
        isOneOf<Finding::NotHeld, Finding::TravelTooSmall, Finding::Jitter>, 0.1, 0.9},
    {"failing potentiometer", [](Case& one, std::mt19937& random) {
        one.stick.spikeShare = between(0.12, 0.3, random); one.stick.spikeRun = 3; },
        isOneOf<Finding::Jitter, Finding::NotStill>, 0.0, 0.05},
    {"potentiometer at its rails", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Analog; one.stick.neutral = between(480, 540, random);
        one.stick.low = -20; one.stick.high = 1040; one.stick.sigma = between(0, 2, random); }, never, 1.0, 1.0},
    {"pulses beyond what is read", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Rc; one.stick.neutral = 3750; one.stick.low = 2500;
        one.stick.high = between(6255, 6700, random); one.stick.sigma = between(0, 4, random); },
        isOneOf<Finding::Saturated>, 0.0, 0.3},
    {"RC pulses on analog", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Analog;
        const double share = between(0.1, 0.25, random);
        one.foreign = [share](double, std::mt19937& draw) {
            return Chance(0, 1)(draw) < share ? static_cast<int>(Chance(20, 900)(draw))
                                              : static_cast<int>(Chance(0, 3)(draw)); }; },
        isOneOf<Finding::InputConfused>, 0.0, 0.0},
    {"readings of the other kind", [](Case& one, std::mt19937& random) {
        const bool isRc = one.input == InputKind::Rc;
        const double at = isRc ? between(100, 900, random) : between(2500, 5000, random);
        const double missing = isRc ? 0.0 : between(0, 0.3, random);
        one.foreign = [at, missing](double, std::mt19937& draw) {
            return Chance(0, 1)(draw) < missing ? int(kInvalidPulse)
                                                : static_cast<int>(at + Chance(-2, 2)(draw)); }; },
        isOneOf<Finding::InputConfused>, 0.0, 0.0},
    {"floating analog input", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Analog;
        const double period = between(3, 9, random);
        one.foreign = [period](double at, std::mt19937& draw) {
            return static_cast<int>(500 + 200 * std::sin(at / period * 6.28) + 60 * std::sin(at * 5)
                                    + Chance(-8, 8)(draw)); }; },
        isOneOf<Finding::NotStill, Finding::InputConfused>, 0.0, 0.0},
    {"all of it", [](Case& one, std::mt19937& random) {
        auto& stick = one.stick;
        stick.sigma = between(0, 0.012, random) * stick.travel();
        stick.spikeShare = between(0, 0.03, random);
        stick.missingShare = one.input == InputKind::Rc ? between(0, 0.15, random) : 0.0;
        stick.expo = between(1, 2, random);
        stick.play = one.hasReturns ? between(0, 0.01, random) * stick.travel() : 0.0; },
        isTooMuch, 0.7, 1.0},
};
// clang-format on

struct Figures {
    int cases = 0;
    int accepted = 0;
    int wrong = 0;
    std::map<Finding, int> declined;
    double worstEnd = 0.0; ///< percent of the travel
    double worstNeutral = 0.0; ///< σ, of one count at least
};

const char* nameOf(Finding finding)
{
    static const std::map<Finding, const char*> kNames{{Finding::NoReadings, "no readings"},
                                                       {Finding::InputConfused, "confused"},
                                                       {Finding::NotStill, "not still"},
                                                       {Finding::MissingPulses, "missing pulses"},
                                                       {Finding::Jitter, "jitter"},
                                                       {Finding::NotMoved, "not moved"},
                                                       {Finding::TravelTooSmall, "too small"},
                                                       {Finding::OneDirection, "one direction"},
                                                       {Finding::NotHeld, "not held"},
                                                       {Finding::Noisy, "noisy"},
                                                       {Finding::CentreLost, "centre lost"},
                                                       {Finding::Saturated, "saturated"}};
    return kNames.at(finding);
}

QString describe(const Case& one, unsigned seed, const LearnedChannel& learned)
{
    const auto& stick = one.stick;
    return QStringLiteral(" [%1: channel %2, σ %3, spikes %11, play %12, returns %13; learned %4 "
                          "%5 %6 of %7 %8 %9; %10]")
        .arg(seed)
        .arg(one.channel)
        .arg(stick.sigma)
        .arg(learned.calibration.minimum)
        .arg(learned.calibration.neutral)
        .arg(learned.calibration.maximum)
        .arg(stick.low)
        .arg(stick.neutral)
        .arg(stick.high)
        .arg(reasonText(learned, one.input))
        .arg(stick.spikeShare)
        .arg(stick.play)
        .arg(learned.returns);
}

bool isInside(double end, const EndWindow& window, const CalibrationRules& rules)
{
    return window.samples >= 3 && window.lowest >= rules.smallest && window.highest <= rules.largest
        && end >= window.lowest && end <= window.highest;
}

/// What is wrong with an accepted calibration; empty when it is right.
QString wrongness(const Case& one, const Played& played, Figures& figures)
{
    const auto& learned = played.learned;
    const auto& calibration = learned.calibration;
    const auto& stick = one.stick;
    const auto& rules = calibrationRules(one.input);
    if (one.foreign) {
        return QStringLiteral("no stick at all");
    }
    // The truth: where it stands by then, within what can be read.
    const double moved = stick.creep * std::min(played.seconds, stick.creepUntil);
    const double low = std::max(stick.low + moved, double(rules.smallest));
    const double high = std::min(stick.high + moved, double(rules.largest));
    // Noise, wandering, and the rounding of readings to whole counts.
    const double sigma = std::hypot(stick.sigma, stick.wander, 0.29);
    const bool goesLow = stick.sweep != Sweep::UpOnly;
    const bool goesHigh = stick.sweep != Sweep::DownOnly;
    const double travel = (goesHigh ? high : stick.neutral) - (goesLow ? low : stick.neutral);
    const double lowError = goesLow ? std::abs(calibration.minimum - low) / travel : 0.0;
    const double highError = goesHigh ? std::abs(calibration.maximum - high) / travel : 0.0;
    const double neutralError = std::abs(learned.neutral - stick.neutral - moved);
    const double unit = std::max(sigma, 1.0 / kNeutralTolerance);
    figures.worstEnd = std::max({figures.worstEnd, lowError * 100, highError * 100});
    figures.worstNeutral = std::max(figures.worstNeutral, neutralError / unit);
    if (lowError > kEndTolerance || highError > kEndTolerance) {
        return QStringLiteral("wrong end");
    }
    if (neutralError > kNeutralTolerance * unit
        || calibration.neutral != std::lround(learned.neutral)) {
        return QStringLiteral("wrong neutral");
    }
    // At rest, wherever its play leaves it, it gives 0.
    if (calibration.deadband < neutralError + stick.play + 2.0 * sigma) {
        return QStringLiteral("deadband too small");
    }
    if ((goesLow && !isInside(learned.lowEnd, learned.lowWindow, rules))
        || (goesHigh && !isInside(learned.highEnd, learned.highWindow, rules))) {
        return QStringLiteral("end outside of its window");
    }
    if ((played.spikeShare > 0.02 && !learned.has(Finding::SomeJitter))
        || (stick.missingShare > 0.05 && !learned.has(Finding::SomeMissing))
        || (stick.sigma > 0.005 * travel && !learned.has(Finding::SomeNoise))) {
        return QStringLiteral("does not tell what is wrong with it");
    }
    if (!played.endsDone) {
        return QStringLiteral("ends never done");
    }
    return validate(calibration) ? QString() : QStringLiteral("cannot be written");
}

} // namespace

class TestLearnerProperties : public QObject {
    Q_OBJECT

private slots:
    void sticks_areLearnedRightOrDeclinedForTheirReason_data();
    void sticks_areLearnedRightOrDeclinedForTheirReason();
    void staleSamples_haveNoInfluence();
    void cleanupTestCase();

private:
    std::map<const char*, Figures> m_figures;
};

void TestLearnerProperties::sticks_areLearnedRightOrDeclinedForTheirReason_data()
{
    QTest::addColumn<int>("row");
    for (int row = 0; row < int(std::size(kClasses)); ++row) {
        QTest::newRow(kClasses[row].name) << row;
    }
}

void TestLearnerProperties::sticks_areLearnedRightOrDeclinedForTheirReason()
{
    QFETCH(int, row);
    const StickClass& kind = kClasses[row];
    Figures& figures = m_figures[kind.name];
    QStringList problems;
    std::mt19937 random(static_cast<unsigned>(1000 + row));
    for (unsigned seed = 1; seed <= kCasesEach; ++seed) {
        Case one = usualCase(seed, random);
        kind.shape(one, random);
        const Played played = Player(one, true).play();
        const auto& learned = played.learned;
        ++figures.cases;
        QString problem;
        if (learned.verdict == Verdict::DoAgain) {
            const Finding reason = learned.findings.front();
            ++figures.declined[reason];
            problem = kind.isRight(reason, one) ? QString() : QStringLiteral("not the reason");
        } else {
            ++figures.accepted;
            problem = wrongness(one, played, figures);
            figures.wrong += problem.isEmpty() ? 0 : 1;
        }
        if (learned.samples > played.fedValid || learned.missed > played.fed - played.fedValid) {
            problem = QStringLiteral("counts readings that never came");
        }
        if (!problem.isEmpty()) {
            problems << problem + describe(one, seed, learned);
        }
    }
    QVERIFY2(problems.isEmpty(),
             qPrintable(QString::number(problems.size())
                        + problems.first(std::min<qsizetype>(4, problems.size())).join(u'\n')));
    const double accepted = double(figures.accepted) / figures.cases;
    QVERIFY2(accepted >= kind.leastAccepted, qPrintable(QString::number(accepted)));
    QVERIFY2(accepted <= kind.mostAccepted, qPrintable(QString::number(accepted)));
}

void TestLearnerProperties::staleSamples_haveNoInfluence()
{
    for (int row = 0; row < int(std::size(kClasses)); ++row) {
        std::mt19937 random(static_cast<unsigned>(5000 + row));
        for (unsigned seed = 1; seed <= 10; ++seed) {
            Case one = usualCase(seed, random);
            kClasses[row].shape(one, random);
            const auto poisoned = Player(one, true).play().learned;
            const auto plain = Player(one, false).play().learned;
            QCOMPARE(figuresText(poisoned, one.input), figuresText(plain, one.input));
            QCOMPARE(poisoned.findings, plain.findings);
            QCOMPARE(poisoned.calibration, plain.calibration);
            QCOMPARE(poisoned.samples, plain.samples);
            QCOMPARE(poisoned.missed, plain.missed);
            QCOMPARE(poisoned.sigma, plain.sigma);
        }
    }
}

void TestLearnerProperties::cleanupTestCase()
{
    int cases = 0;
    int accepted = 0;
    int wrong = 0;
    std::printf("%-28s %6s %8s %6s %7s %9s  %s\n", "class", "cases", "accepted", "wrong", "end %",
                "neutral σ", "declined for");
    for (const StickClass& kind : kClasses) {
        const Figures& figures = m_figures[kind.name];
        QString declined;
        for (const auto& [finding, count] : figures.declined) {
            declined +=
                QStringLiteral("%1 %2  ").arg(QLatin1StringView(nameOf(finding))).arg(count);
        }
        std::printf("%-28s %6d %8d %6d %7.2f %9.2f  %s\n", kind.name, figures.cases,
                    figures.accepted, figures.wrong, figures.worstEnd, figures.worstNeutral,
                    qPrintable(declined));
        cases += figures.cases;
        accepted += figures.accepted;
        wrong += figures.wrong;
    }
    std::printf("%-28s %6d %8d %6d\n", "all", cases, accepted, wrong);
    std::fflush(stdout);
}

QTEST_GUILESS_MAIN(TestLearnerProperties)
#include "tst_learnerproperties.moc"
