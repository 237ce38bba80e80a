// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/measurement.h"

#include <cmath>

namespace trex {

namespace {

constexpr Duration kFresh = std::chrono::milliseconds(500); ///< the last sample stands so long

} // namespace

std::optional<Measurement> measure(const TimeSeries& series, const ValueScale& scale, Instant from,
                                   Instant to)
{
    const auto [begin, end] = series.range(from, to);
    const TimeSeries::Sum sum = series.sum(begin, end);
    if (sum.valid == 0) {
        return std::nullopt;
    }
    const Extent extent = series.extent(begin, end);
    const auto count = static_cast<double>(sum.valid);
    const auto total = static_cast<double>(sum.sum);
    const double offset = scale.offset;
    // Σ(v + o)² = Σv² + 2oΣv + no²
    const double squares =
        static_cast<double>(sum.squares) + 2.0 * offset * total + count * offset * offset;
    Measurement result;
    result.samples = sum.valid;
    result.minimum = scale.physical(extent.low);
    result.maximum = scale.physical(extent.high);
    result.mean = scale.physical(total / count);
    result.rms = std::sqrt(std::max(squares / count, 0.0)) * std::abs(scale.scale);
    if (scale.offset == 0) {
        const double tick = std::chrono::duration<double>(TimeAxis::kTick).count();
        result.integral =
            static_cast<double>(series.doubleArea(begin, end)) / 2.0 * tick * scale.scale;
    }
    return result;
}

std::optional<std::size_t> sampleAt(const TimeSeries& series, Instant time)
{
    const TimeAxis::Tick wanted = TimeAxis::ticksOf(time);
    const std::size_t after = series.axis().lowerBound(wanted);
    std::size_t chosen = after;
    if (after < series.size() && series.axis().tick(after) == wanted) {
        chosen = after;
    } else if (after == series.first()) {
        return std::nullopt;
    } else if (after == series.size()) {
        if (time - series.time(after - 1) > kFresh) {
            return std::nullopt;
        }
        chosen = after - 1;
    } else if (series.axis().hasGapBetween(after - 1, after)) {
        return std::nullopt;
    } else {
        const bool isLaterNearer =
            series.axis().tick(after) - wanted < wanted - series.axis().tick(after - 1);
        chosen = isLaterNearer ? after : after - 1;
    }
    return series.isValid(chosen) ? std::optional(chosen) : std::nullopt;
}

} // namespace trex
