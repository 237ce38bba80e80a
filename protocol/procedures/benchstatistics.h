// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic of the bench tests: what can be said about a motor from its commands and from a
// current in steps of 40 mA. Uncertainties are about two standard deviations. Pure.
#pragma once

#include "protocol/procedures/benchtrace.h"

#include <optional>
#include <span>

namespace trex::bench {

/// A number and how far off it may be.
struct Estimate {
    double value = 0.0;
    double uncertainty = 0.0;
};

/// A stretch of time in which a motor was told one thing.
struct Segment {
    double from = 0.0; ///< s
    double to = 0.0;
    MotorOrder::Action action = MotorOrder::Action::Set;
    int amount = 0; ///< signed speed or duty
    std::size_t begin = 0; ///< samples in it
    std::size_t end = 0;
    [[nodiscard]] bool isDriving() const
    {
        return action != MotorOrder::Action::Brake && amount != 0;
    }
    [[nodiscard]] bool isCoasting() const { return amount == 0; } ///< speed 0, or braking duty 0
    [[nodiscard]] double length() const { return to - from; }
};
/// The last one is the stop at the end, of no length. The time before a motor's first order is none
/// of its segments.
[[nodiscard]] std::vector<Segment> segments(const BenchTrace& trace, MotorId motor);
[[nodiscard]] bool isDriven(const BenchTrace& trace, MotorId motor);
/// A part of a segment, `after` seconds from its begin to its end.
[[nodiscard]] Segment settled(const BenchTrace& trace, const Segment& segment, double after);

/// Mean of a motor's current; none with fewer than three readings. Where the noise is smaller than
/// a step of the converter, averaging does not help: then half a step is the uncertainty.
[[nodiscard]] std::optional<Estimate> meanCurrent(const BenchTrace& trace, const Segment& segment,
                                                  MotorId motor);
[[nodiscard]] double largestCurrent(const BenchTrace& trace, const Segment& segment, MotorId motor);
/// Current × time in ampere seconds; gaps in the readings are left out.
[[nodiscard]] double charge(const BenchTrace& trace, const Segment& segment, MotorId motor);

struct Point {
    double x = 0.0;
    double y = 0.0;
};
struct Line {
    Estimate offset;
    Estimate slope;
    double squares = 0.0; ///< of the residuals, summed
};
/// Least squares; none with fewer than three points, or all at one place.
[[nodiscard]] std::optional<Line> fitLine(std::span<const Point> points);

/// y = slope × x up to the knee, and a straight line of its own from there on.
struct Knee {
    Estimate x; ///< where the two meet
    Estimate y;
    Estimate slope; ///< before it
    double slopeAfter = 0.0;
};
/// None: the points show no knee (the slope behind it is not clearly less). `common`: what all y
/// may be off by together.
[[nodiscard]] std::optional<Knee> fitKnee(std::span<const Point> points, double common);

/// y = end + height × exp(−x / constant), x from 0.
struct Decay {
    Estimate end;
    Estimate height; ///< at x = 0
    Estimate constant;
};
/// Least squares over all three; none with fewer than eight points, or when nothing decays. The
/// constant is doubted by at least 3 %: the readings' ages spread, and not evenly.
[[nodiscard]] std::optional<Decay> fitDecay(std::span<const Point> points);
/// The same with a known constant.
[[nodiscard]] std::optional<Decay> fitHeight(std::span<const Point> points, double constant);

[[nodiscard]] std::optional<Estimate> meanOf(std::span<const Estimate> estimates);

} // namespace trex::bench
