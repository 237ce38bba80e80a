// SPDX-License-Identifier: GPL-3.0-or-later
// Step response and braking: what the decay of the starting current tells.
#include "protocol/procedures/benchresults.h"
#include "protocol/storage/benchtext.h"

#include <cmath>
#include <tuple>

using namespace Qt::Literals::StringLiterals;

namespace trex::bench {
namespace {

constexpr double kShortestRun = 0.2; // s
constexpr double kRestAfterBrake = 0.9; // s; then it stands
constexpr double kRestAfterCoast = 1.9;
constexpr double kStopped = 10.0; // percent of the speed before: as good as standing

/// The readings behind a start, by the time since the order acted.
void addPoints(const BenchTrace& trace, const Segment& segment, MotorId motor,
               std::vector<Point>& points)
{
    for (std::size_t i = segment.begin; i < segment.end; ++i) {
        const double since = BenchTrace::secondsOf(trace.samples[i].tick) - segment.from;
        if (since >= kClean) {
            points.push_back({since - kDelay, trace.amperes(i, motor)});
        }
    }
}

bool startsFromRest(const std::vector<Segment>& all, std::size_t index)
{
    if (!all[index].isDriving() || all[index].length() < kShortestRun) {
        return false;
    }
    double rest = 0.0; // a brake counts double
    for (std::size_t i = index; i-- > 0 && !all[i].isDriving();) {
        const bool isBrake = all[i].action == MotorOrder::Action::Brake && all[i].amount > 0;
        rest += all[i].length() / (isBrake ? kRestAfterBrake : kRestAfterCoast);
    }
    // Before the first order the motor is taken to stand.
    const bool isFirst = std::none_of(all.begin(), all.begin() + std::ptrdiff_t(index),
                                      [](const Segment& s) { return s.isDriving(); });
    return isFirst || rest >= 1.0;
}

Estimate heightAtStart(const Decay& decay)
{
    const double value = decay.end.value + decay.height.value;
    const double delay = decay.height.value * kDelayDoubt / decay.constant.value;
    return {value, decay.height.uncertainty + decay.end.uncertainty + delay};
}

struct Starts {
    std::vector<Point> points;
    std::vector<Estimate> steady;
    double peak = 0.0;
    int amount = 0; ///< magnitude
    int count = 0;
};

/// Starts from rest to the speed that most of them go to.
Starts startsOf(const BenchTrace& trace, MotorId motor)
{
    const auto all = segments(trace, motor);
    std::map<int, Starts> by;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (startsFromRest(all, i)) {
            Starts& starts = by[std::abs(all[i].amount)];
            addPoints(trace, all[i], motor, starts.points);
            const auto part = settled(trace, all[i], all[i].length() * 0.6);
            if (const auto mean = meanCurrent(trace, part, motor)) {
                starts.steady.push_back(*mean);
            }
            starts.peak = std::max(starts.peak, largestCurrent(trace, all[i], motor));
            starts.amount = std::abs(all[i].amount);
            ++starts.count;
        }
    }
    Starts most;
    for (const auto& [amount, starts] : by) {
        if (starts.count >= most.count) {
            most = starts;
        }
    }
    return most;
}

std::optional<Estimate> resistance(const BenchOutcome& outcome, const std::optional<Decay>& decay,
                                   int amount)
{
    if (!outcome.profile.supplyVolts || !decay) {
        return std::nullopt;
    }
    const Estimate inrush = heightAtStart(*decay);
    const double volts = *outcome.profile.supplyVolts * amount / kFullSpeed;
    const double ohms = volts / inrush.value;
    return Estimate{ohms, ohms * inrush.uncertainty / inrush.value};
}

QString needsVolts(const BenchOutcome& outcome)
{
    return outcome.profile.supplyVolts
        ? Bench::tr("All resistance of the circuit: winding, brushes, wires, bridge.")
        : Bench::tr("Needs the supply voltage (supplyVolts in the profile).");
}

} // namespace

void evaluateStepResponse(BenchOutcome& outcome)
{
    for (const MotorId motor : kMeasured) {
        if (!isDriven(outcome.trace, motor)) {
            continue;
        }
        const Starts starts = startsOf(outcome.trace, motor);
        const auto decay = fitDecay(starts.points);
        const QString none = decay
            ? QString()
            : Bench::tr("The current shows no decay after the start: too little inertia for "
                        "readings every 12 ms, or the motor did not turn.");
        add(outcome, motor, {"steady-current", Bench::tr("running current"), u"A"_s, 3},
            meanOf(starts.steady),
            Bench::tr("Mean of the last two fifths of %1 runs at speed %2.")
                .arg(starts.count)
                .arg(starts.amount));
        add(outcome, motor, {"peak-current", Bench::tr("largest reading"), u"A"_s, 2},
            Estimate{starts.peak, amperesPerCount(outcome.trace.model)},
            Bench::tr("A mean over one reading; the true peak is higher."));
        add(outcome, motor, {"inrush-current", Bench::tr("starting current"), u"A"_s, 2},
            decay ? std::optional(heightAtStart(*decay)) : std::nullopt,
            decay ? Bench::tr("Extrapolated back to the moment of the step.") : none);
        std::optional<Estimate> ms;
        if (decay) {
            ms = Estimate{decay->constant.value * 1000.0, decay->constant.uncertainty * 1000.0};
        }
        add(outcome, motor, {"time-constant", Bench::tr("mechanical time constant"), u"ms"_s, 1},
            ms,
            decay ? Bench::tr("Of the starting current's decay: inertia × resistance / (motor "
                              "constant)². The three cannot be told apart without a speed sensor.")
                  : none);
        add(outcome, motor, {"winding-resistance", Bench::tr("resistance"), u"Ω"_s, 2},
            resistance(outcome, decay, starts.amount), needsVolts(outcome));
    }
}

namespace {

/// How much of the speed is left after a pause of each kind and length, in percent.
struct Pause {
    bool isBrake = false;
    int duty = 0;
    int milliseconds = 0; ///< in tens
    bool operator<(const Pause& other) const
    {
        return std::tie(isBrake, duty, milliseconds)
            < std::tie(other.isBrake, other.duty, other.milliseconds);
    }
};

std::map<Pause, std::vector<Estimate>> speedsLeft(const BenchTrace& trace, MotorId motor,
                                                  const Decay& reference, int amount)
{
    std::map<Pause, std::vector<Estimate>> left;
    const auto all = segments(trace, motor);
    for (std::size_t i = 2; i < all.size(); ++i) {
        const Segment& pause = all[i - 1];
        const bool isRestart = all[i].isDriving() && !pause.isDriving() && all[i - 2].isDriving()
            && all[i].amount == all[i - 2].amount && std::abs(all[i].amount) == amount
            && !startsFromRest(all, i);
        std::vector<Point> points;
        if (isRestart) {
            addPoints(trace, all[i], motor, points);
        }
        const auto height = fitHeight(points, reference.constant.value);
        if (!isRestart || !height) {
            continue;
        }
        const double part = height->height.value / reference.height.value;
        const double doubt = height->height.uncertainty / reference.height.value
            + std::abs(part) * kDelayDoubt / reference.constant.value;
        const bool isBrake = pause.action == MotorOrder::Action::Brake && pause.amount > 0;
        left[{isBrake, isBrake ? pause.amount : 0, int(std::lround(pause.length() * 100.0)) * 10}]
            .push_back({100.0 * (1.0 - part), 100.0 * doubt});
    }
    return left;
}

/// Where the speed has fallen to a tenth, between the lengths that were tried; the logarithm of the
/// speed is taken to run straight between them.
std::optional<Estimate> timeToStop(const std::vector<std::pair<double, Estimate>>& left)
{
    double before = 0.0;
    double percentBefore = 100.0;
    for (const auto& [milliseconds, percent] : left) {
        if (percent.value <= kStopped) {
            const double end = std::max(percent.value, 1.0);
            const double slope = std::log(percentBefore / end) / (milliseconds - before);
            const double at = before + std::log(percentBefore / kStopped) / slope;
            return Estimate{
                at,
                std::max(percent.uncertainty / kStopped / slope, (milliseconds - before) * 0.1)};
        }
        before = milliseconds;
        percentBefore = std::min(percentBefore, percent.value);
    }
    return std::nullopt;
}

void addPauses(BenchOutcome& outcome, MotorId motor, bool isBrake,
               const std::map<Pause, std::vector<Estimate>>& left)
{
    std::vector<std::pair<double, Estimate>> course;
    BenchCurve curve{.title = titleOf(motor) + u", "_s
                         + (isBrake ? Bench::tr("braking") : Bench::tr("coasting")),
                     .group = Bench::tr("Speed left after a pause"),
                     .xTitle = Bench::tr("pause, ms"),
                     .yTitle = Bench::tr("speed left, %"),
                     .motor = motor,
                     .points = {{0.0, 100.0}}};
    for (const auto& [pause, estimates] : left) {
        const auto mean = meanOf(estimates);
        if (pause.isBrake != isBrake || !mean) {
            continue;
        }
        course.emplace_back(pause.milliseconds, *mean);
        curve.points.push_back({double(pause.milliseconds), mean->value});
        const QString kind = isBrake ? u"brake"_s : u"coast"_s;
        const QString title =
            isBrake ? Bench::tr("after braking %1 ms") : Bench::tr("after coasting %1 ms");
        add(outcome, u"%1.%2-%3ms"_s.arg(keyOf(motor), kind).arg(pause.milliseconds),
            titleOf(motor) + u", "_s + title.arg(pause.milliseconds),
            {"speed-left", Bench::tr("speed left"), u"%"_s, 1}, mean,
            Bench::tr("From the current of the next start, against a start from rest."));
    }
    if (course.empty()) {
        return;
    }
    outcome.curves.push_back(std::move(curve));
    const auto stop = timeToStop(course);
    add(outcome, motor,
        isBrake ? Measure{"brake-time", Bench::tr("braking to a tenth of the speed"), u"ms"_s, 0}
                : Measure{"coast-time", Bench::tr("coasting to a tenth of the speed"), u"ms"_s, 0},
        stop,
        stop ? Bench::tr("Interpolated between the pauses that were tried.")
             : Bench::tr("Longer than the longest pause that was tried (%1 ms).")
                   .arg(course.back().first));
}

} // namespace

void evaluateBraking(BenchOutcome& outcome)
{
    for (const MotorId motor : kMeasured) {
        if (!isDriven(outcome.trace, motor)) {
            continue;
        }
        const Starts starts = startsOf(outcome.trace, motor);
        const auto reference = fitDecay(starts.points);
        if (!reference) {
            add(outcome, motor,
                {"brake-time", Bench::tr("braking to a tenth of the speed"), u"ms"_s, 0}, {},
                Bench::tr("The current shows no decay after a start from rest, so that nothing "
                          "tells how fast the motor still turns."));
            continue;
        }
        add(outcome, motor, {"time-constant", Bench::tr("mechanical time constant"), u"ms"_s, 1},
            Estimate{reference->constant.value * 1000.0, reference->constant.uncertainty * 1000.0},
            Bench::tr("Of %1 starts from rest.").arg(starts.count));
        const auto left = speedsLeft(outcome.trace, motor, *reference, starts.amount);
        addPauses(outcome, motor, true, left);
        addPauses(outcome, motor, false, left);
    }
}

} // namespace trex::bench
