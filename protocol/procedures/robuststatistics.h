// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics that a few spikes cannot bend. Pure; an empty span gives 0.
#pragma once

#include <optional>
#include <span>

namespace trex {

[[nodiscard]] double medianOf(std::span<const int> values);
[[nodiscard]] double middleOf(std::span<const double> values); ///< median, for rests
/// The mean without `cut` (0 to below 0.5) of the values on either side, rounded up: nearly as
/// exact as the mean, and deaf to so many spikes.
[[nodiscard]] double trimmedMeanOf(std::span<const int> values, double cut);
/// The value below which `share` (0 to 1) of the values lie.
[[nodiscard]] double quantileOf(std::span<const int> values, double share);
/// 1.4826 × the median absolute deviation: σ, even when nearly half of the values are wild.
[[nodiscard]] double deviationSigma(std::span<const int> values);
/// Spread as the σ of the normal distribution that has the same middle: the larger of
/// 1.4826 × the median absolute deviation and (90 % − 10 % quantile) / 2.563. The second keeps
/// coarse readings, most of them equal, from looking like no noise at all.
[[nodiscard]] double robustSigma(std::span<const int> values);
/// The standard deviation of the values within 4 robust σ of the median: as deaf to spikes, and a
/// third more exact for the same number of values.
[[nodiscard]] double refinedSigma(std::span<const int> values);
/// σ from successive differences: slow movement hardly counts in it, noise does.
[[nodiscard]] double differenceSigma(std::span<const int> values);

struct CurvePoint {
    double x;
    double y;
};
struct Parabola {
    double vertexAt; ///< x
    double vertex; ///< y there
    double curvature; ///< negative: the vertex is the highest point
    double residualSigma; ///< of the points about it
};
/// By least squares, so not deaf to spikes; none for fewer than 4 points or a straight line.
[[nodiscard]] std::optional<Parabola> fitParabola(std::span<const CurvePoint> points);

} // namespace trex
