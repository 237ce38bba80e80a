// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/extremefinder.h"

#include "protocol/procedures/robuststatistics.h"

#include <array>
#include <cmath>

using namespace std::chrono_literals;

namespace trex {
namespace {

constexpr std::size_t kLeastSustained = 7; // three spikes in a row reach nothing
constexpr std::size_t kMostSustained = 15;
constexpr Duration kLeastSustainedTime = 100ms;
constexpr Duration kLargestGap = 600ms; // a longer silence breaks what was held
constexpr std::size_t kMostKept = 60'000; // 20 minutes at 50 Hz

constexpr double kOutlierSigmas = 5.0;

// Rushing past an end: groups of readings in a row beyond it that agree with each other, as spikes
// do not.
constexpr double kBeyondSigmas = 5.0;
constexpr double kBeyondShare = 0.005; // of the travel
constexpr double kLeastBeyond = 3.0; // raw
constexpr double kAgreeShare = 0.05; // of the travel
constexpr int kRushGroup = 2;
constexpr int kLongRush = 4;
constexpr int kMostRushes = 2;

constexpr std::size_t kNeighbours = 7; // a spike may last three readings
constexpr double kSpikeSigmas = 8.0;
constexpr double kSpikeShare = 0.08; // of the travel

} // namespace

void ExtremeFinder::begin(double neutral, double sigma, Instant now)
{
    m_neutral = neutral;
    m_sigma = sigma;
    m_sweep.clear();
    m_samples = 0;
    m_low = {neutral, neutral, now, now, now};
    m_high = m_low;
}

std::size_t ExtremeFinder::sustainedCount() const
{
    // The noisier, the longer an end must be held, so that it is not a peak of the noise.
    const double share = m_sigma / m_rules.neededTravel;
    const auto extra = static_cast<std::size_t>(std::lround(share * 300.0));
    return std::min(kLeastSustained + extra, kMostSustained);
}

void ExtremeFinder::feed(int raw, Instant time)
{
    if (m_sweep.size() >= kMostKept) {
        m_sweep.pop_front();
    }
    m_sweep.push_back({raw, time});
    ++m_samples;
    const std::size_t needed = sustainedCount();
    std::vector<int> held{raw};
    std::size_t first = m_sweep.size() - 1;
    while (first > 0
           && (held.size() < needed || time - m_sweep[first].time < kLeastSustainedTime)) {
        if (m_sweep[first].time - m_sweep[first - 1].time > kLargestGap) {
            return; // nothing is sustained across a silence
        }
        --first;
        held.push_back(m_sweep[first].raw);
    }
    const Instant from = m_sweep[first].time;
    if (held.size() >= needed && time - from >= kLeastSustainedTime) {
        const double middle = medianOf(held);
        grow(m_low, -1, middle, from, time);
        grow(m_high, 1, middle, from, time);
    }
}

void ExtremeFinder::grow(Reach& reach, int sign, double held, Instant from, Instant to)
{
    if (sign * (held - reach.value) <= 0.0) {
        return;
    }
    reach.value = held;
    reach.from = from;
    reach.to = to;
    // An end that creeps up within its own noise has stopped growing.
    const double notable = std::max(2.0 * m_sigma, m_rules.neededTravel / 100.0);
    if (std::abs(reach.value - reach.noted) > notable) {
        reach.noted = reach.value;
        reach.grownAt = to;
    }
}

Instant ExtremeFinder::grownAt() const
{
    return std::max(m_low.grownAt, m_high.grownAt);
}

std::size_t ExtremeFinder::placeOf(Instant time) const
{
    const auto place = std::ranges::lower_bound(m_sweep, time, {}, &SweepPoint::time);
    return static_cast<std::size_t>(place - m_sweep.begin());
}

ExtremeFinder::End ExtremeFinder::end(int sign) const
{
    const Reach& reach = sign > 0 ? m_high : m_low;
    const std::size_t first = placeOf(reach.from);
    const std::size_t last = placeOf(reach.to);
    if (sign * (reach.value - m_neutral) <= 0.0 || last >= m_sweep.size()) {
        return {m_neutral, {}, 0.0, true};
    }
    const double outlier = std::max(kOutlierSigmas * m_sigma, m_rules.stillFloor);
    const auto found = estimateEnd(m_sweep, first, last, sign, m_sigma, outlier);
    return {found.value, found.window, found.uncertainty,
            found.isAgreed && !isRushedPast(reach, sign)};
}

bool ExtremeFinder::isRushedPast(const Reach& reach, int sign) const
{
    const double travel = m_high.value - m_low.value;
    const double limit = std::max({kBeyondSigmas * m_sigma, kBeyondShare * travel, kLeastBeyond});
    int rushes = 0;
    int group = 0;
    for (std::size_t i = 0; i < m_sweep.size(); ++i) {
        const bool isBeyond = sign * (m_sweep[i].raw - reach.value) > limit;
        const bool agrees =
            group == 0 || std::abs(m_sweep[i].raw - m_sweep[i - 1].raw) <= kAgreeShare * travel;
        group = isBeyond && agrees ? group + 1 : isBeyond ? 1 : 0;
        rushes += group == kRushGroup ? 1 : 0;
        if (group == kLongRush || rushes > kMostRushes) {
            return true;
        }
    }
    return false;
}

int ExtremeFinder::spikes() const
{
    const double travel = m_high.value - m_low.value;
    const double limit =
        std::max({kSpikeSigmas * m_sigma, kSpikeShare * travel, m_rules.stillFloor});
    int spikes = 0;
    constexpr std::size_t kHalf = kNeighbours / 2;
    std::array<int, kNeighbours> around{};
    for (std::size_t i = kHalf; i + kHalf < m_sweep.size(); ++i) {
        for (std::size_t k = 0; k < kNeighbours; ++k) {
            around[k] = m_sweep[i + k - kHalf].raw;
        }
        std::ranges::nth_element(around, around.begin() + kHalf);
        const bool isClose = m_sweep[i + kHalf].time - m_sweep[i - kHalf].time <= kLargestGap;
        spikes += isClose && std::abs(m_sweep[i].raw - around[kHalf]) > limit ? 1 : 0;
    }
    return spikes;
}

} // namespace trex
