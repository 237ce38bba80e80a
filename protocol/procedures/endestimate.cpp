// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/endestimate.h"

#include "protocol/procedures/calibrationverdict.h"
#include "protocol/procedures/robuststatistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

using namespace std::chrono_literals;

namespace trex {
namespace {

// Of sixteen thousand ends whose uncertainty is just allowed, one is further away.
constexpr double kNoiseErrors = 4.0;
constexpr double kCut = 0.125; // of the readings on either side
constexpr double kCutError = 1.04; // of the mean's standard error, for normal noise and that cut
constexpr double kPartCut = 0.25; // of a part of the window, in which spikes weigh more
constexpr double kRoundingSigma = 0.29; // of readings in whole counts

constexpr std::size_t kBlock = 7; // of readings that join at a time: three spikes tell nothing
constexpr double kJoinErrors = 4.0; // standard errors that a block may differ by
constexpr double kJoinRounding = 1.0; // raw
constexpr std::size_t kMostUsed = 250; // 5 s at 50 Hz
constexpr Duration kLargestGap = 600ms; // a longer silence ends what was held
constexpr double kAgreeing = 0.75; // share of the readings: the rest may be spikes
constexpr std::size_t kLeastUsed = 7; // readings: three spikes in a row make no end
// By how much more the end is off than the highest third of the window stands out. Swung through in
// a short time: mass makes a parabola of it, whose middle third stands out by 0.82 to 0.89 of that.
// Crept to in a long one: a straight line, whose last third does by 2/3.
constexpr double kSwingFactor = 1.2;
constexpr double kCreepFactor = 1.5;
constexpr std::size_t kLeastPart = 3;
// In a long hold the highest part stands out by so many standard errors: the hold was found by it.
// A shorter one may have been a swing through the end, of which nothing is explained away.
constexpr double kChosenErrors = 2.0;
constexpr std::size_t kLongHold = kHoldSamples;
// The noise of a long hold counts when it is plainly more than that at rest.
constexpr double kMoreNoise = 1.25;

// A parabola through a swing: for windows of so many readings, where it explains all but the noise.
constexpr std::array<std::size_t, 3> kSwings{11, 17, 25};
constexpr double kVertexError = 1.5; // of its vertex, in standard errors of the mean
constexpr double kResidualErrors = 1.5; // of the residual σ: more is no parabola
constexpr double kMisfit = 0.7; // in σ: what such a test does not see
constexpr double kMostOff = 0.5; // of half the window, from its middle to the vertex

struct Span {
    std::size_t first;
    std::size_t last; // included
};

class Estimator {
public:
    Estimator(const std::deque<SweepPoint>& sweep, Span core, int sign, double sigma,
              double outlier)
        : m_sweep(sweep), m_core(core), m_sign(sign), m_sigma(sigma), m_outlier(outlier)
    {
        m_centre = medianOf(all(core));
    }

    [[nodiscard]] EndEstimate best() const
    {
        const EndEstimate core = of(m_core);
        EndEstimate best = core;
        // A part of it, when it was passed: the less time, the less the stick moved in it.
        for (std::size_t first = m_core.first; first + kLeastUsed <= m_core.last + 1; ++first) {
            for (std::size_t last = first + kLeastUsed - 1; last <= m_core.last; ++last) {
                keepSurer(best, of({first, last}));
            }
        }
        for (const std::size_t samples : kSwings) {
            if (const auto swing = ofSwing(samples)) {
                keepSurer(best, *swing);
            }
        }
        // More than it, when it was held: the more readings, the less their noise counts.
        Span span = m_core;
        EndEstimate present = core;
        const auto grow = [&](const std::optional<Span>& block) {
            if (!block || !joins(*block, present)) {
                return false;
            }
            span = {std::min(span.first, block->first), std::max(span.last, block->last)};
            present = of(span);
            keepSurer(best, present);
            return true;
        };
        while (span.last - span.first < kMostUsed) {
            const bool hasGrownBefore = grow(blockBefore(span));
            if (!grow(blockBehind(span)) && !hasGrownBefore) {
                break;
            }
        }
        return best;
    }

private:
    static void keepSurer(EndEstimate& best, const EndEstimate& other)
    {
        if (other.isAgreed && (!best.isAgreed || other.uncertainty < best.uncertainty)) {
            best = other;
        }
    }
    [[nodiscard]] std::vector<int> all(Span span) const
    {
        std::vector<int> values;
        for (std::size_t i = span.first; i <= span.last; ++i) {
            values.push_back(m_sweep[i].raw);
        }
        return values;
    }
    [[nodiscard]] bool isUnbroken(Span span) const
    {
        for (std::size_t i = span.first; i < span.last; ++i) {
            if (m_sweep[i + 1].time - m_sweep[i].time > kLargestGap) {
                return false;
            }
        }
        return true;
    }
    [[nodiscard]] std::optional<Span> blockBefore(Span span) const
    {
        const bool isThere = span.first >= kBlock && isUnbroken({span.first - kBlock, span.first});
        return isThere ? std::optional(Span{span.first - kBlock, span.first - 1}) : std::nullopt;
    }
    [[nodiscard]] std::optional<Span> blockBehind(Span span) const
    {
        const bool isThere =
            span.last + kBlock < m_sweep.size() && isUnbroken({span.last, span.last + kBlock});
        return isThere ? std::optional(Span{span.last + 1, span.last + kBlock}) : std::nullopt;
    }
    [[nodiscard]] bool joins(Span block, const EndEstimate& present) const
    {
        const double error = noiseUncertainty(m_sigma, 1) / kNoiseErrors
            * std::sqrt(1.0 / kBlock + 1.0 / std::max(1, present.window.samples));
        return std::abs(medianOf(all(block)) - present.value)
            <= kJoinErrors * error + kJoinRounding;
    }
    [[nodiscard]] EndEstimate of(Span span) const;
    [[nodiscard]] std::optional<EndEstimate> ofSwing(std::size_t samples) const;

    const std::deque<SweepPoint>& m_sweep;
    Span m_core;
    int m_sign;
    double m_sigma;
    double m_outlier;
    double m_centre = 0.0;
};

EndEstimate Estimator::of(Span span) const
{
    const std::vector<int> whole = all(span);
    std::vector<int> values;
    std::ranges::copy_if(whole, std::back_inserter(values),
                         [this](int raw) { return std::abs(raw - m_centre) <= m_outlier; });
    const std::size_t count = values.size();
    EndEstimate estimate;
    estimate.isAgreed = kAgreeing * double(whole.size()) <= double(count);
    if (values.empty()) {
        estimate.value = m_centre;
        estimate.uncertainty = m_outlier;
        return estimate;
    }
    const auto [lowest, highest] = std::ranges::minmax(values);
    estimate.value = trimmedMeanOf(values, kCut);
    estimate.window = {lowest, highest, static_cast<int>(count), m_sweep[span.first].time,
                       m_sweep[span.last].time};
    // The noise at an end may be more than at rest.
    const bool isLong = count >= kLongHold;
    const double spread = isLong ? refinedSigma(values) : 0.0;
    const double sigma = spread > kMoreNoise * m_sigma ? spread : m_sigma;
    // All readings here: what stands out may be the end, passed too fast.
    const std::size_t third = std::max<std::size_t>(kLeastPart, whole.size() / 3);
    const std::size_t step = std::max<std::size_t>(1, third / 2);
    double farthest = 0.0;
    for (std::size_t from = 0; from + third <= whole.size(); from += step) {
        const double part = trimmedMeanOf(std::span(whole).subspan(from, third), kPartCut);
        farthest = std::max(farthest, m_sign * (part - estimate.value));
    }
    const double error = noiseUncertainty(sigma, 1); // of one reading
    if (isLong) {
        const double explained = kChosenErrors / kNoiseErrors * error / std::sqrt(double(third));
        estimate.uncertainty =
            error / std::sqrt(double(count)) + kCreepFactor * std::max(0.0, farthest - explained);
    } else {
        // The part is of the same readings: their noise counts in both.
        const double factor = kSwingFactor * kSwingFactor;
        estimate.uncertainty =
            error * std::sqrt(factor / double(third) - (factor - 1.0) / double(count))
            + kSwingFactor * farthest;
    }
    return estimate;
}

std::optional<EndEstimate> Estimator::ofSwing(std::size_t samples) const
{
    const std::size_t middle = (m_core.first + m_core.last) / 2;
    const std::size_t half = samples / 2;
    if (middle < half || middle + half >= m_sweep.size()) {
        return std::nullopt;
    }
    const Span span{middle - half, middle + half};
    const double reach =
        std::chrono::duration<double>(m_sweep[span.last].time - m_sweep[span.first].time).count()
        / 2.0;
    if (!isUnbroken(span) || reach <= 0.0) {
        return std::nullopt;
    }
    const Instant centre = m_sweep[middle].time;
    std::vector<CurvePoint> points;
    for (std::size_t i = span.first; i <= span.last; ++i) {
        const double x = std::chrono::duration<double>(m_sweep[i].time - centre).count() / reach;
        points.push_back({x, double(m_sign * m_sweep[i].raw)});
    }
    const auto parabola = fitParabola(points);
    const double sigma = std::max(m_sigma, kRoundingSigma);
    const double mostResidual = 1.0 + kResidualErrors / std::sqrt(2.0 * double(samples - 3));
    if (!parabola || parabola->curvature >= 0.0 || std::abs(parabola->vertexAt) > kMostOff
        || parabola->residualSigma > mostResidual * sigma) {
        return std::nullopt;
    }
    const std::vector<int> whole = all(span);
    const auto [lowest, highest] = std::ranges::minmax(whole);
    EndEstimate estimate;
    // Never beyond what was read.
    estimate.value = std::clamp(m_sign * parabola->vertex, double(lowest), double(highest));
    estimate.window = {lowest, highest, static_cast<int>(whole.size()), m_sweep[span.first].time,
                       m_sweep[span.last].time};
    estimate.uncertainty = kVertexError * noiseUncertainty(sigma, whole.size()) + kMisfit * sigma;
    estimate.isAgreed = true;
    return estimate;
}

} // namespace

double noiseUncertainty(double sigma, std::size_t samples)
{
    return kNoiseErrors * kCutError * std::max(sigma, kRoundingSigma)
        / std::sqrt(static_cast<double>(std::max<std::size_t>(1, samples)));
}

EndEstimate estimateEnd(const std::deque<SweepPoint>& sweep, std::size_t first, std::size_t last,
                        int sign, double sigma, double outlier)
{
    return Estimator(sweep, {first, last}, sign, sigma, outlier).best();
}

} // namespace trex
