// SPDX-License-Identifier: GPL-3.0-or-later
// What the samples between two moments say, computed from the samples themselves (never from what a
// plot drew). Quick at any length: extremes climb the pyramid, the rest comes from running sums.
// Pure.
#pragma once

#include "protocol/telemetry/timeseries.h"

namespace trex {

/// How stored numbers become physical ones: (stored + offset) × scale.
struct ValueScale {
    double scale = 1.0;
    int offset = 0;
    [[nodiscard]] constexpr double physical(double stored) const
    {
        return (stored + offset) * scale;
    }
};

/// Of the valid samples in a part of time; all in physical units.
struct Measurement {
    std::size_t samples = 0;
    double minimum = 0.0;
    double mean = 0.0; ///< of the samples, each weighing the same
    double rms = 0.0;
    double maximum = 0.0;
    /// Area under the samples joined by straight lines, from the first to the last, in unit ×
    /// seconds. Gaps count nothing. None where zero is not stored as zero.
    std::optional<double> integral;
};

/// Samples of [from, to); none when no valid sample lies there.
[[nodiscard]] std::optional<Measurement> measure(const TimeSeries& series, const ValueScale& scale,
                                                 Instant from, Instant to);

/// A charge: ampere seconds as milliampere hours.
[[nodiscard]] constexpr double milliampereHours(double ampereSeconds)
{
    return ampereSeconds / 3.6;
}

/// The sample that stands for a moment: the nearer of its two neighbours. None in a gap, before the
/// first sample, well after the last, and where the neighbour is no valid value.
[[nodiscard]] std::optional<std::size_t> sampleAt(const TimeSeries& series, Instant time);

} // namespace trex
