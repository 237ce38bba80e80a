// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of generated sticks, whose truth is known, played to the learner as a person would move
// them: each is learned right or declined for what is wrong with it.
#include "protocol/procedures/calibrationtext.h"

#include "tests/procedures/stickplayer.h"

#include <QTest>

#include <cstdio>
#include <map>

using namespace trex;
using namespace trex::test;

namespace {

constexpr double kEndTolerance = 0.01; // of the travel
constexpr double kNeutralTolerance = 1.5; // σ, but one count at least
constexpr int kCasesEach = 240; // of each class
constexpr unsigned kSeedStep = 1'200'000; // keeps what the seed decides of a stick

/// TREX_STICKS: how many in all. TREX_STICKS_ROUND: another number, other sticks.
int casesEach()
{
    const int all = qEnvironmentVariableIntValue("TREX_STICKS");
    return all > 0 ? all / int(std::size(kStickClasses)) + 1 : kCasesEach;
}

unsigned firstSeed()
{
    return kSeedStep * static_cast<unsigned>(qEnvironmentVariableIntValue("TREX_STICKS_ROUND"));
}

struct Figures {
    int cases = 0;
    int accepted = 0;
    int wrong = 0; ///< accepted, and not what the stick is
    int untold = 0; ///< a flaw not told, or declined for something else
    int stale = 0; ///< a reading used that was repeated, old or invalid
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

/// The readings of an end's window are fresh, valid ones of its time, each of them once.
bool isMadeOf(const EndWindow& window, const Played& played)
{
    int samples = 0;
    for (const auto& [time, raw] : played.readings) {
        const bool isIn = time >= window.from && time <= window.to;
        samples += isIn && raw >= window.lowest && raw <= window.highest ? 1 : 0;
    }
    return window.samples == 0 || window.samples == samples;
}

bool usesOnlyWhatCame(const Played& played)
{
    const auto& learned = played.learned;
    const int valid = static_cast<int>(played.readings.size());
    return learned.samples <= valid && learned.missed <= played.fed - valid
        && isMadeOf(learned.lowWindow, played) && isMadeOf(learned.highWindow, played);
}

bool isUntold(const Case& one, const Played& played)
{
    const auto& learned = played.learned;
    const auto& stick = one.stick;
    return (played.spikeShare > 0.02 && !learned.has(Finding::SomeJitter))
        || (stick.missingShare > 0.05 && !learned.has(Finding::SomeMissing))
        || (stick.sigma > 0.005 * stick.travel() && !learned.has(Finding::SomeNoise));
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
    for (int row = 0; row < int(std::size(kStickClasses)); ++row) {
        QTest::newRow(kStickClasses[row].name) << row;
    }
}

void TestLearnerProperties::sticks_areLearnedRightOrDeclinedForTheirReason()
{
    QFETCH(int, row);
    const StickClass& kind = kStickClasses[row];
    Figures& figures = m_figures[kind.name];
    QStringList problems;
    std::mt19937 random(static_cast<unsigned>(1000 + row) + firstSeed());
    for (int i = 1; i <= casesEach(); ++i) {
        const unsigned seed = firstSeed() + static_cast<unsigned>(i);
        Case one = usualCase(seed, random);
        kind.shape(one, random);
        const Played played = CasePlayer(one, true).play();
        const auto& learned = played.learned;
        ++figures.cases;
        QString problem;
        if (learned.verdict == Verdict::DoAgain) {
            const Finding reason = learned.findings.front();
            ++figures.declined[reason];
            problem = kind.isRight(reason, one) ? QString() : QStringLiteral("not the reason");
            figures.untold += problem.isEmpty() ? 0 : 1;
        } else {
            ++figures.accepted;
            problem = wrongness(one, played, figures);
            figures.wrong += problem.isEmpty() ? 0 : 1;
            if (problem.isEmpty() && isUntold(one, played)) {
                problem = QStringLiteral("does not tell what is wrong with it");
                ++figures.untold;
            }
        }
        if (!usesOnlyWhatCame(played)) {
            problem = QStringLiteral("uses readings that never came");
            figures.stale += 1;
        }
        if (!problem.isEmpty()) {
            problems << problem + describe(one, seed, learned);
        }
    }
    // Of very many sticks, a few are told something else than what they were made for.
    const int mostUntold = casesEach() > kCasesEach ? casesEach() / 100 : 0;
    QVERIFY2(problems.isEmpty()
                 || (figures.wrong + figures.stale == 0 && figures.untold <= mostUntold),
             qPrintable(QString::number(problems.size())
                        + problems.first(std::min<qsizetype>(4, problems.size())).join(u'\n')));
    const double accepted = double(figures.accepted) / figures.cases;
    QVERIFY2(accepted >= kind.leastAccepted, qPrintable(QString::number(accepted)));
    QVERIFY2(accepted <= kind.mostAccepted, qPrintable(QString::number(accepted)));
}

void TestLearnerProperties::staleSamples_haveNoInfluence()
{
    for (int row = 0; row < int(std::size(kStickClasses)); ++row) {
        std::mt19937 random(static_cast<unsigned>(5000 + row));
        for (unsigned seed = 1; seed <= 10; ++seed) {
            Case one = usualCase(seed, random);
            kStickClasses[row].shape(one, random);
            const auto poisoned = CasePlayer(one, true).play().learned;
            const auto plain = CasePlayer(one, false).play().learned;
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
    Figures all;
    const auto print = [](const char* name, const Figures& figures, const QString& declined) {
        const double share =
            100.0 * (figures.cases - figures.accepted) / std::max(1, figures.cases);
        std::printf("%-28s %7d %8d %6.2f %6d %6d %6d %6.2f %9.2f  %s\n", name, figures.cases,
                    figures.accepted, share, figures.wrong, figures.untold, figures.stale,
                    figures.worstEnd, figures.worstNeutral, qPrintable(declined));
    };
    std::printf("%-28s %7s %8s %6s %6s %6s %6s %6s %9s  %s\n", "class", "cases", "accepted",
                "decl.%", "wrong", "untold", "stale", "end %", "neutral σ", "declined for");
    for (const StickClass& kind : kStickClasses) {
        const Figures& figures = m_figures[kind.name];
        QString declined;
        for (const auto& [finding, count] : figures.declined) {
            declined +=
                QStringLiteral("%1 %2  ").arg(QLatin1StringView(nameOf(finding))).arg(count);
        }
        print(kind.name, figures, declined);
        all.cases += figures.cases;
        all.accepted += figures.accepted;
        all.wrong += figures.wrong;
        all.untold += figures.untold;
        all.stale += figures.stale;
        all.worstEnd = std::max(all.worstEnd, figures.worstEnd);
        all.worstNeutral = std::max(all.worstNeutral, figures.worstNeutral);
    }
    print("all", all, {});
    std::fflush(stdout);
}

QTEST_GUILESS_MAIN(TestLearnerProperties)
#include "tst_learnerproperties.moc"
