// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/benchstatistics.h"

#include <algorithm>
#include <cmath>

namespace trex::bench {
namespace {

std::size_t firstAt(const BenchTrace& trace, double seconds)
{
    const auto tick = BenchTrace::tickOf(seconds);
    return std::size_t(std::ranges::lower_bound(trace.samples, tick, {}, &BenchTrace::Sample::tick)
                       - trace.samples.begin());
}

/// Sum of squares that are left when y = end + height × e^(−x / constant) is fitted with this
/// constant; the fit itself in the other two.
double residual(std::span<const Point> points, double constant, double& end, double& height)
{
    double n = 0.0;
    double sg = 0.0;
    double sgg = 0.0;
    double sy = 0.0;
    double sgy = 0.0;
    for (const Point& point : points) {
        const double g = std::exp(-point.x / constant);
        n += 1.0;
        sg += g;
        sgg += g * g;
        sy += point.y;
        sgy += g * point.y;
    }
    const double det = n * sgg - sg * sg;
    if (det <= 0.0) {
        return HUGE_VAL;
    }
    height = (n * sgy - sg * sy) / det;
    end = (sy - height * sg) / n;
    double squares = 0.0;
    for (const Point& point : points) {
        const double error = point.y - end - height * std::exp(-point.x / constant);
        squares += error * error;
    }
    return squares;
}

} // namespace

std::vector<Segment> segments(const BenchTrace& trace, MotorId motor)
{
    std::vector<Segment> all;
    for (const BenchTrace::Order& order : trace.orders) {
        if (order.motor != motor) {
            continue;
        }
        const double at = BenchTrace::secondsOf(order.tick);
        if (!all.empty()) {
            all.back().to = at;
        }
        all.push_back({at, trace.seconds, order.action, order.amount, 0, 0});
    }
    for (Segment& segment : all) {
        segment.begin = firstAt(trace, segment.from);
        segment.end = firstAt(trace, segment.to);
    }
    return all;
}

bool isDriven(const BenchTrace& trace, MotorId motor)
{
    return std::ranges::any_of(trace.orders, [motor](const BenchTrace::Order& order) {
        return order.motor == motor && order.action != MotorOrder::Action::Brake
            && order.amount != 0;
    });
}

Segment settled(const BenchTrace& trace, const Segment& segment, double after)
{
    Segment part = segment;
    part.from = std::min(segment.from + after, segment.to);
    part.begin = firstAt(trace, part.from);
    return part;
}

std::optional<Estimate> meanCurrent(const BenchTrace& trace, const Segment& segment, MotorId motor)
{
    const std::size_t count = segment.end > segment.begin ? segment.end - segment.begin : 0;
    if (count < 3) {
        return std::nullopt;
    }
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = segment.begin; i < segment.end; ++i) {
        const double amperes = trace.amperes(i, motor);
        sum += amperes;
        squares += amperes * amperes;
    }
    const auto n = double(count);
    const double mean = sum / n;
    const double deviation = std::sqrt(std::max(squares / n - mean * mean, 0.0) * n / (n - 1.0));
    const double step = amperesPerCount(trace.model);
    const bool isDithered = deviation > 0.3 * step;
    return Estimate{mean, isDithered ? 2.0 * deviation / std::sqrt(n) + 0.1 * step : 0.5 * step};
}

double largestCurrent(const BenchTrace& trace, const Segment& segment, MotorId motor)
{
    double largest = 0.0;
    for (std::size_t i = segment.begin; i < segment.end; ++i) {
        largest = std::max(largest, trace.amperes(i, motor));
    }
    return largest;
}

double charge(const BenchTrace& trace, const Segment& segment, MotorId motor)
{
    double sum = 0.0;
    for (std::size_t i = segment.begin + 1; i < segment.end; ++i) {
        const double step = BenchTrace::secondsOf(trace.samples[i].tick)
            - BenchTrace::secondsOf(trace.samples[i - 1].tick);
        if (step < BenchTrace::kGapSeconds) {
            sum += step * (trace.amperes(i, motor) + trace.amperes(i - 1, motor)) / 2.0;
        }
    }
    return sum;
}

std::optional<Line> fitLine(std::span<const Point> points)
{
    const auto n = double(points.size());
    double sx = 0.0;
    double sy = 0.0;
    for (const Point& point : points) {
        sx += point.x / n;
        sy += point.y / n;
    }
    double sxx = 0.0;
    double sxy = 0.0;
    for (const Point& point : points) {
        sxx += (point.x - sx) * (point.x - sx);
        sxy += (point.x - sx) * (point.y - sy);
    }
    if (points.size() < 3 || sxx <= 0.0) {
        return std::nullopt;
    }
    Line line;
    line.slope.value = sxy / sxx;
    line.offset.value = sy - line.slope.value * sx;
    for (const Point& point : points) {
        const double error = point.y - line.offset.value - line.slope.value * point.x;
        line.squares += error * error;
    }
    const double variance = line.squares / (n - 2.0);
    line.slope.uncertainty = 2.0 * std::sqrt(variance / sxx);
    line.offset.uncertainty = 2.0 * std::sqrt(variance * (1.0 / n + sx * sx / sxx));
    return line;
}

std::optional<Knee> fitKnee(std::span<const Point> points, double common)
{
    constexpr std::size_t kLeastBefore = 2;
    constexpr std::size_t kLeastAfter = 4;
    constexpr double kLessSteep = 0.5;
    std::optional<Knee> best;
    double least = HUGE_VAL;
    for (std::size_t split = kLeastBefore; split + kLeastAfter <= points.size(); ++split) {
        double sxx = 0.0;
        double sxy = 0.0;
        double sx = 0.0;
        for (const Point& point : points.first(split)) {
            sx += point.x;
            sxx += point.x * point.x;
            sxy += point.x * point.y;
        }
        const auto after = fitLine(points.subspan(split));
        if (sxx <= 0.0 || !after) {
            continue;
        }
        const double slope = sxy / sxx;
        double squares = after->squares;
        for (const Point& point : points.first(split)) {
            squares += (point.y - slope * point.x) * (point.y - slope * point.x);
        }
        if (squares >= least) {
            continue;
        }
        least = squares;
        best.reset();
        const double difference = slope - after->slope.value;
        if (slope <= 0.0 || difference < kLessSteep * slope) {
            continue;
        }
        const double variance = squares / std::max(double(points.size()) - 3.0, 1.0);
        const double slopeDoubt = 2.0 * std::sqrt(variance / sxx) + common * sx / sxx;
        const double x = after->offset.value / difference;
        const double offsetDoubt =
            after->offset.uncertainty + std::abs(x) * after->slope.uncertainty + common;
        best = Knee{.x = {x, std::hypot(offsetDoubt, x * slopeDoubt) / difference},
                    .y = {slope * x, offsetDoubt},
                    .slope = {slope, slopeDoubt},
                    .slopeAfter = after->slope.value};
    }
    return best;
}

std::optional<Decay> fitDecay(std::span<const Point> points)
{
    constexpr int kSteps = 120;
    constexpr double kShortest = 0.008; // s; faster than the readings come
    constexpr double kLongest = 4.0;
    if (points.size() < 8) {
        return std::nullopt;
    }
    const auto at = [](double place) {
        return kShortest * std::pow(kLongest / kShortest, place / kSteps);
    };
    double end = 0.0;
    double height = 0.0;
    double best = 0.0;
    double least = HUGE_VAL;
    for (int i = 0; i <= kSteps; ++i) {
        const double squares = residual(points, at(i), end, height);
        if (squares < least) {
            least = squares;
            best = i;
        }
    }
    for (double step = 0.5; step > 0.002; step /= 2.0) { // closer and closer around the best
        for (const double place : {best - step, best + step}) {
            const double squares = residual(points, at(place), end, height);
            if (squares < least) {
                least = squares;
                best = place;
            }
        }
    }
    residual(points, at(best), end, height);
    const double n = double(points.size());
    const double variance = least / (n - 3.0);
    // Nothing decays when the whole height drowns in the noise, or the constant is at a border.
    if (best <= 0.0 || best >= kSteps || height < 3.0 * std::sqrt(variance)) {
        return std::nullopt;
    }
    double doubt = 0.0;
    for (const double direction : {-1.0, 1.0}) {
        double place = best;
        double ignoredEnd = 0.0;
        double ignoredHeight = 0.0;
        while (place > 0.0 && place < kSteps
               && residual(points, at(place), ignoredEnd, ignoredHeight) < least + 4.0 * variance) {
            place += direction * 0.05;
        }
        doubt = std::max(doubt, std::abs(at(place) - at(best)));
    }
    auto fitted = fitHeight(points, at(best));
    if (fitted) {
        fitted->constant = {at(best), doubt + 0.03 * at(best)};
    }
    return fitted;
}

std::optional<Decay> fitHeight(std::span<const Point> points, double constant)
{
    std::vector<Point> straight; // a straight line over e^(−x / constant)
    straight.reserve(points.size());
    for (const Point& point : points) {
        straight.push_back({std::exp(-point.x / constant), point.y});
    }
    const auto line = fitLine(straight);
    if (!line) {
        return std::nullopt;
    }
    return Decay{line->offset, line->slope, {constant, 0.0}};
}

std::optional<Estimate> meanOf(std::span<const Estimate> estimates)
{
    if (estimates.empty()) {
        return std::nullopt;
    }
    const auto n = double(estimates.size());
    double sum = 0.0;
    double doubt = 0.0;
    for (const Estimate& each : estimates) {
        sum += each.value / n;
        doubt += each.uncertainty * each.uncertainty;
    }
    double squares = 0.0;
    for (const Estimate& each : estimates) {
        squares += (each.value - sum) * (each.value - sum);
    }
    const double spread = n > 1.0 ? 2.0 * std::sqrt(squares / (n - 1.0) / n) : 0.0;
    return Estimate{sum, std::max(std::sqrt(doubt) / n, spread)};
}

} // namespace trex::bench
