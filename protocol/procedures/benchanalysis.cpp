// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/benchanalysis.h"

#include "protocol/procedures/benchresults.h"
#include "protocol/storage/benchtext.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <cmath>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr std::array kVerdicts{"not-judged", "passed", "failed", "not-measured"};
constexpr std::array kEnds{"completed",      "limit",   "not-met",   "no-readings",
                           "not-in-control", "stopped", "link-lost", "failed"};

void judge(BenchResult& result, const BenchProfile& profile)
{
    result.expected = {};
    result.verdict = BenchVerdict::NotJudged;
    const auto found = profile.expect.find(result.key);
    if (found == profile.expect.end()) {
        return;
    }
    result.expected = found->second;
    const auto& [minimum, maximum] = found->second;
    if (!result.value) {
        result.verdict = BenchVerdict::NotMeasured;
    } else {
        const bool isLow = minimum && *result.value < *minimum;
        const bool isHigh = maximum && *result.value > *maximum;
        result.verdict = isLow || isHigh ? BenchVerdict::Failed : BenchVerdict::Passed;
    }
}

/// Expected, but no result of this test.
void addMissing(BenchOutcome& outcome)
{
    for (const auto& [key, expectation] : outcome.profile.expect) {
        if (bench::find(outcome, key) == nullptr) {
            outcome.results.push_back(
                {.key = key,
                 .title = key,
                 .value = {},
                 .unit = {},
                 .expected = expectation,
                 .verdict = BenchVerdict::NotMeasured,
                 .note = Bench::tr("This test has no such result; its name may be mistyped.")});
        }
    }
}

void addLine(BenchOutcome& outcome)
{
    const BenchTrace& trace = outcome.trace;
    const double rate = trace.seconds > 0.0 ? double(trace.samples.size()) / trace.seconds : 0.0;
    bench::add(outcome, u"line"_s, Bench::tr("Line"),
               {"readings", Bench::tr("readings of the currents"), u"1/s"_s, 1},
               bench::Estimate{rate, 0.0}, {});
    bench::add(outcome, u"line"_s, Bench::tr("Line"),
               {"errors", Bench::tr("replies lost or damaged"), {}, 0},
               bench::Estimate{double(trace.linkErrors), 0.0}, {});
}

QByteArray commentJson(const QString& text)
{
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return list.mid(1, list.size() - 2);
}

} // namespace

BenchOutcome evaluate(const BenchRun& run, bool isDryRun)
{
    BenchOutcome outcome{.profile = run.profile(),
                         .ending = run.ending(),
                         .trace = run.trace(),
                         .isDryRun = isDryRun,
                         .results = {},
                         .proposals = {},
                         .curves = {}};
    using Evaluate = void (*)(BenchOutcome&);
    constexpr std::array<Evaluate, 7> kEvaluate{
        bench::evaluateGeneral,      bench::evaluateStepResponse, bench::evaluateSlowRamp,
        bench::evaluateCurrentSpeed, bench::evaluateLeftRight,    bench::evaluateBraking,
        bench::evaluateEndurance};
    if (run.hasStarted()) {
        kEvaluate.at(std::size_t(outcome.profile.analysis))(outcome);
        addLine(outcome);
    }
    addMissing(outcome);
    judge(outcome);
    if (outcome.ending.end == BenchEnd::Completed) {
        bench::propose(outcome);
    }
    return outcome;
}

void judge(BenchOutcome& outcome)
{
    for (BenchResult& result : outcome.results) {
        judge(result, outcome.profile);
    }
}

bool BenchOutcome::hasPassed() const
{
    return ending.end == BenchEnd::Completed
        && std::ranges::none_of(results, [](const BenchResult& result) {
               return result.verdict == BenchVerdict::Failed
                   || result.verdict == BenchVerdict::NotMeasured;
           });
}

BenchVerdict BenchOutcome::verdict() const
{
    const bool isJudged = std::ranges::any_of(results, [](const BenchResult& result) {
        return result.verdict != BenchVerdict::NotJudged;
    });
    return !hasPassed() ? BenchVerdict::Failed
        : isJudged      ? BenchVerdict::Passed
                        : BenchVerdict::NotJudged;
}

QString BenchOutcome::verdictText() const
{
    if (ending.end != BenchEnd::Completed) {
        return Bench::tr("Not passed: ended before its time (%1).").arg(ending.reason);
    }
    const auto count = [this](BenchVerdict verdict) {
        return int(std::ranges::count(results, verdict, &BenchResult::verdict));
    };
    const int failed = count(BenchVerdict::Failed) + count(BenchVerdict::NotMeasured);
    const int passed = count(BenchVerdict::Passed);
    if (failed > 0) {
        return Bench::tr("Not passed: of the expectations, %1 of %2 are not met.")
            .arg(failed)
            .arg(failed + passed);
    }
    return passed == 0 ? Bench::tr("Done. The profile expects nothing of the results.")
                       : Bench::tr("Passed: every expectation is met (%1).").arg(passed);
}

Configuration configurationOf(const std::vector<BenchProposal>& proposals,
                              const QString& profileName)
{
    Configuration configuration;
    const QString head =
        Bench::tr("Proposals of the bench test \"%1\". Look at each before it is written.")
            .arg(profileName);
    configuration.unknown[{QString(), u"comment"_s}] = {u"version"_s, commentJson(head)};
    for (const BenchProposal& proposal : proposals) {
        const ParameterRow* row = findParameter(proposal.parameter);
        if (row == nullptr) {
            continue;
        }
        configuration.parameters[proposal.parameter] = proposal.raw;
        configuration.unknown[{u"parameters."_s + keyText(*row), u"comment"_s}] = {
            u"raw"_s, commentJson(proposal.reason)};
    }
    return configuration;
}

QLatin1StringView keyOf(BenchVerdict verdict)
{
    return QLatin1StringView(kVerdicts.at(std::size_t(verdict)));
}

QLatin1StringView keyOf(BenchEnd end)
{
    return QLatin1StringView(kEnds.at(std::size_t(end)));
}

QString textOf(BenchVerdict verdict)
{
    switch (verdict) {
    case BenchVerdict::NotJudged:
        return Bench::tr("not judged");
    case BenchVerdict::Passed:
        return Bench::tr("passed");
    case BenchVerdict::Failed:
        return Bench::tr("failed");
    case BenchVerdict::NotMeasured:
        return Bench::tr("not measured");
    }
    return {};
}

QString valueText(const BenchResult& result)
{
    if (!result.value) {
        return u"–"_s;
    }
    QString text = QString::number(*result.value, 'f', result.decimals);
    if (result.uncertainty > 0.0) {
        // Rounded up to the last digit shown: never 0.
        const double digit = std::pow(10.0, -result.decimals);
        const double shown = std::ceil(result.uncertainty / digit - 1e-9) * digit;
        text += u" ± "_s + QString::number(shown, 'f', result.decimals);
    }
    return result.unit.isEmpty() ? text : text + u' ' + result.unit;
}

QString expectedText(const BenchResult& result)
{
    const auto& [minimum, maximum] = result.expected;
    const auto number = [](double value) {
        return QString::number(value).replace(u'-', u'\u2212');
    };
    if (minimum && maximum) {
        return Bench::tr("%1 to %2").arg(number(*minimum), number(*maximum));
    }
    return minimum ? Bench::tr("at least %1").arg(number(*minimum))
        : maximum  ? Bench::tr("at most %1").arg(number(*maximum))
                   : QString();
}

} // namespace trex

namespace trex::bench {

QString keyOf(MotorId motor)
{
    return motor == MotorId::Motor1 ? u"motor1"_s : u"motor2"_s;
}

QString titleOf(MotorId motor)
{
    return motor == MotorId::Motor1 ? Bench::tr("Motor 1") : Bench::tr("Motor 2");
}

void add(BenchOutcome& outcome, const QString& prefix, const QString& prefixTitle,
         const Measure& measure, const std::optional<Estimate>& estimate, const QString& note)
{
    BenchResult result{.key = prefix + u'.' + QLatin1StringView(measure.key),
                       .title = prefixTitle + u": "_s + measure.title,
                       .value = {},
                       .unit = measure.unit,
                       .decimals = measure.decimals,
                       .expected = {},
                       .note = note};
    if (estimate && std::isfinite(estimate->value)) {
        result.value = estimate->value;
        result.uncertainty = std::isfinite(estimate->uncertainty) ? estimate->uncertainty : 0.0;
    }
    outcome.results.push_back(std::move(result));
}

void add(BenchOutcome& outcome, MotorId motor, const Measure& measure,
         const std::optional<Estimate>& estimate, const QString& note)
{
    add(outcome, keyOf(motor), titleOf(motor), measure, estimate, note);
}

const BenchResult* find(const BenchOutcome& outcome, const QString& key)
{
    const auto found = std::ranges::find(outcome.results, key, &BenchResult::key);
    return found == outcome.results.end() ? nullptr : &*found;
}

} // namespace trex::bench
