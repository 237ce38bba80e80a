// SPDX-License-Identifier: GPL-3.0-or-later
// What settled currents tell: dead zone, current over speed, left against right, endurance.
#include "protocol/procedures/benchresults.h"
#include "protocol/storage/benchtext.h"

#include <cmath>

using namespace Qt::Literals::StringLiterals;

namespace trex::bench {
namespace {

constexpr double kShortestLevel = 0.08; // s
constexpr double kSettling = 0.3; // of a level's length
constexpr double kLongestSettling = 2.0; // s
constexpr double kMilliampereHours = 1000.0 / 3600.0;
constexpr int kSlowest = 16; // below, a motor may not turn

struct Level {
    int amount = 0; ///< signed
    Estimate current;
    double from = 0.0;
};

/// Each stretch of one speed with the mean of its settled part.
std::vector<Level> levels(const BenchTrace& trace, MotorId motor, double settling)
{
    std::vector<Level> all;
    for (const Segment& segment : segments(trace, motor)) {
        if (!segment.isDriving() || segment.length() < kShortestLevel) {
            continue;
        }
        const auto part =
            settled(trace, segment, std::min(segment.length() * settling, kLongestSettling));
        if (const auto mean = meanCurrent(trace, part, motor)) {
            all.push_back({segment.amount, *mean, segment.from});
        }
    }
    return all;
}

std::vector<Point> pointsOf(const std::vector<Level>& all, int sign, int slowest)
{
    std::vector<Point> points;
    for (const Level& level : all) {
        if (level.amount * sign >= slowest) {
            points.push_back({double(std::abs(level.amount)), level.current.value});
        }
    }
    return points;
}

void addCurve(BenchOutcome& outcome, MotorId motor, const QString& group,
              const std::vector<Level>& all)
{
    BenchCurve curve{.title = titleOf(motor),
                     .group = group,
                     .xTitle = Bench::tr("speed (of 127)"),
                     .yTitle = Bench::tr("current, A"),
                     .motor = motor,
                     .points = {}};
    for (const Level& level : all) {
        curve.points.push_back({double(level.amount), level.current.value});
    }
    std::ranges::sort(curve.points, {}, &BenchCurve::Point::x);
    if (!curve.points.empty()) {
        outcome.curves.push_back(std::move(curve));
    }
}

void addDirection(BenchOutcome& outcome, MotorId motor, int sign, const std::optional<Knee>& knee)
{
    const QString prefix = keyOf(motor) + (sign > 0 ? u".forward"_s : u".reverse"_s);
    const QString title =
        titleOf(motor) + u", "_s + (sign > 0 ? Bench::tr("forward") : Bench::tr("reverse"));
    const QString none = Bench::tr("The current grows evenly to the end of the ramp: the shaft may "
                                   "not have started. Let the ramp go further.");
    std::optional<Estimate> zone;
    std::optional<Estimate> breakaway;
    if (knee) {
        // Speeds are whole numbers: nothing is known between two of them.
        zone = Estimate{knee->x.value, std::max(knee->x.uncertainty, 0.5)};
        breakaway = knee->y;
    }
    add(outcome, prefix, title, {"dead-zone", Bench::tr("dead zone, in speed steps of 127"), {}, 1},
        zone,
        knee ? Bench::tr("Where the current stops growing with the speed; taken as the moment the "
                         "shaft starts to turn, which no sensor shows.")
             : none);
    add(outcome, prefix, title,
        {"breakaway-current", Bench::tr("current at the start of motion"), u"A"_s, 3}, breakaway,
        knee ? Bench::tr("Proportional to the friction at rest.") : none);
}

} // namespace

void evaluateSlowRamp(BenchOutcome& outcome)
{
    for (const MotorId motor : kMeasured) {
        if (!isDriven(outcome.trace, motor)) {
            continue;
        }
        const auto all = levels(outcome.trace, motor, kSettling);
        std::vector<Estimate> slopes;
        for (const int sign : {1, -1}) {
            const auto points = pointsOf(all, sign, 1);
            if (points.empty()) {
                continue;
            }
            const auto knee = fitKnee(points, 0.1 * amperesPerCount(outcome.trace.model));
            addDirection(outcome, motor, sign, knee);
            if (knee) {
                slopes.push_back(knee->slope);
            }
        }
        addCurve(outcome, motor, Bench::tr("Current over a slow ramp"), all);
        auto stall = meanOf(slopes);
        if (stall) {
            stall = Estimate{stall->value * kFullSpeed, stall->uncertainty * kFullSpeed};
        }
        add(outcome, motor,
            {"stall-current", Bench::tr("current held fast at full speed"), u"A"_s, 2}, stall,
            Bench::tr("Extrapolated from the speeds at which the shaft stands; far beyond what was "
                      "measured."));
        std::optional<Estimate> ohms;
        if (stall && outcome.profile.supplyVolts) {
            const double value = *outcome.profile.supplyVolts / stall->value;
            ohms = Estimate{value, value * stall->uncertainty / stall->value};
        }
        add(outcome, motor, {"winding-resistance", Bench::tr("resistance"), u"Ω"_s, 2}, ohms,
            outcome.profile.supplyVolts
                ? Bench::tr("All resistance of the circuit: winding, brushes, wires, bridge.")
                : Bench::tr("Needs the supply voltage (supplyVolts in the profile)."));
    }
}

void evaluateCurrentSpeed(BenchOutcome& outcome)
{
    for (const MotorId motor : kMeasured) {
        if (!isDriven(outcome.trace, motor)) {
            continue;
        }
        const auto all = levels(outcome.trace, motor, 0.5);
        addCurve(outcome, motor, Bench::tr("Current over speed"), all);
        std::vector<Estimate> offsets;
        std::vector<Estimate> tops;
        std::vector<double> means;
        for (const int sign : {1, -1}) {
            const auto points = pointsOf(all, sign, kSlowest);
            const auto line = fitLine(points);
            if (!line) {
                continue;
            }
            offsets.push_back(line->offset);
            tops.push_back({line->offset.value + line->slope.value * kFullSpeed,
                            line->offset.uncertainty + line->slope.uncertainty * kFullSpeed / 2.0});
            double sum = 0.0;
            for (const Point& point : points) {
                sum += point.y / double(points.size());
            }
            means.push_back(sum);
        }
        const QString none =
            Bench::tr("Needs three speeds or more, of at least 16, in a direction.");
        const auto offset = meanOf(offsets);
        add(outcome, motor,
            {"friction-current", Bench::tr("current that friction takes"), u"A"_s, 3}, offset,
            offset ? Bench::tr("The straight line through the settled currents, at speed 0.")
                   : none);
        add(outcome, motor, {"full-current", Bench::tr("current at full speed"), u"A"_s, 3},
            meanOf(tops), offset ? Bench::tr("The same line, at speed 127.") : none);
        std::optional<Estimate> difference;
        if (means.size() == 2) {
            difference =
                Estimate{means[0] - means[1], offsets[0].uncertainty + offsets[1].uncertainty};
        }
        add(outcome, motor, {"direction-difference", Bench::tr("forward less reverse"), u"A"_s, 3},
            difference,
            difference ? Bench::tr("Mean over all speeds.") : Bench::tr("Needs both directions."));
    }
}

void evaluateLeftRight(BenchOutcome& outcome)
{
    const auto left = levels(outcome.trace, MotorId::Motor1, 0.5);
    const auto right = levels(outcome.trace, MotorId::Motor2, 0.5);
    addCurve(outcome, MotorId::Motor1, Bench::tr("Left against right"), left);
    addCurve(outcome, MotorId::Motor2, Bench::tr("Left against right"), right);
    std::vector<Estimate> differences;
    std::vector<Estimate> ratios;
    double largest = 0.0;
    for (const Level& one : left) {
        for (const Level& other : right) {
            // The same order at the same time.
            if (other.amount != one.amount || std::abs(other.from - one.from) > 0.01) {
                continue;
            }
            const double difference = one.current.value - other.current.value;
            differences.push_back(
                {difference, std::hypot(one.current.uncertainty, other.current.uncertainty)});
            if (std::abs(difference) > std::abs(largest)) {
                largest = difference;
            }
            if (other.current.value > 0.0) {
                const double ratio = 100.0 * one.current.value / other.current.value;
                ratios.push_back(
                    {ratio, ratio * differences.back().uncertainty / other.current.value});
            }
        }
    }
    const QString none = Bench::tr("Needs both motors at the same speeds at the same time.");
    const QString note = differences.empty()
        ? none
        : Bench::tr("Motor 1 less motor 2, mean of %1 speeds.").arg(differences.size());
    const QString title = Bench::tr("Left against right");
    add(outcome, u"left-right"_s, title,
        {"difference", Bench::tr("difference of the currents"), u"A"_s, 3}, meanOf(differences),
        note);
    add(outcome, u"left-right"_s, title,
        {"largest-difference", Bench::tr("largest difference"), u"A"_s, 3},
        differences.empty() ? std::nullopt
                            : std::optional(Estimate{largest, differences.front().uncertainty}),
        differences.empty() ? none : Bench::tr("At the speed where they differ most."));
    add(outcome, u"left-right"_s, title,
        {"ratio", Bench::tr("motor 1 in parts of motor 2"), u"%"_s, 1}, meanOf(ratios),
        ratios.empty() ? none
                       : Bench::tr("More current at the same speed: more friction or load."));
}

void evaluateGeneral(BenchOutcome& outcome)
{
    for (const MotorId motor : kMeasured) {
        if (!isDriven(outcome.trace, motor)) {
            continue;
        }
        std::vector<Estimate> means;
        double peak = 0.0;
        double drawn = 0.0;
        for (const Segment& segment : segments(outcome.trace, motor)) {
            drawn += charge(outcome.trace, segment, motor);
            peak = std::max(peak, largestCurrent(outcome.trace, segment, motor));
            const auto mean = meanCurrent(outcome.trace, segment, motor);
            if (segment.isDriving() && mean) {
                means.push_back(*mean);
            }
        }
        const double step = amperesPerCount(outcome.trace.model);
        add(outcome, motor, {"mean-current", Bench::tr("mean current while driven"), u"A"_s, 3},
            meanOf(means), Bench::tr("Mean of the means at each speed."));
        add(outcome, motor, {"peak-current", Bench::tr("largest reading"), u"A"_s, 2},
            Estimate{peak, step}, Bench::tr("A mean over one reading; the true peak is higher."));
        add(outcome, motor, {"charge", Bench::tr("charge"), u"mAh"_s, 2},
            Estimate{drawn * kMilliampereHours, drawn * kMilliampereHours * 0.02}, {});
    }
}

void evaluateEndurance(BenchOutcome& outcome)
{
    evaluateGeneral(outcome);
    for (const MotorId motor : kMeasured) {
        const auto all = levels(outcome.trace, motor, kSettling);
        if (all.empty()) {
            continue;
        }
        std::vector<Estimate> first;
        std::vector<Estimate> last;
        const double quarter = outcome.trace.seconds / 4.0;
        for (const Level& level : all) {
            if (level.from < quarter) {
                first.push_back(level.current);
            } else if (level.from >= 3.0 * quarter) {
                last.push_back(level.current);
            }
        }
        std::optional<Estimate> drift;
        const auto before = meanOf(first);
        const auto after = meanOf(last);
        if (before && after) {
            drift = Estimate{after->value - before->value,
                             std::hypot(after->uncertainty, before->uncertainty)};
        }
        add(outcome, motor, {"drift", Bench::tr("drift of the running current"), u"A"_s, 3}, drift,
            drift ? Bench::tr("Last quarter of the test less the first; warming, running in and "
                              "wear all show here.")
                  : Bench::tr("Needs runs in the first and in the last quarter of the test."));
        add(outcome, motor, {"runs", Bench::tr("runs"), {}, 0}, Estimate{double(all.size()), 0.0},
            {});
    }
}

} // namespace trex::bench
