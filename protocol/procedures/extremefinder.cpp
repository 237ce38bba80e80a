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

// Held or only passed: a stick that swings through its end is, one window earlier and one later,
// this many times as far from it as the window's middle value is. What noise leaves of the error
// that an end may have, but within limits, is allowed.
constexpr double kDropFactor = 16.0;
constexpr double kMostError = 0.0055; // of the travel, and the margin is on top
constexpr double kMostAllowed = 0.002; // of the travel
constexpr double kLeastDropSigmas = 2.0;
constexpr std::size_t kLeastBeside = 3; // readings, to say anything about the time beside
constexpr double kOutlierSigmas = 5.0;
constexpr std::size_t kLeastAgreeing =
    3; // one in so many: the rest may be spikes and the way there

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

Instant ExtremeFinder::tellableAt() const
{
    return std::max(m_low.to + (m_low.to - m_low.from), m_high.to + (m_high.to - m_high.from));
}

std::vector<int> ExtremeFinder::between(Instant from, Instant to) const
{
    std::vector<int> values;
    for (auto place = std::ranges::lower_bound(m_sweep, from, {}, &Point::time);
         place != m_sweep.end() && place->time <= to; ++place) {
        values.push_back(place->raw);
    }
    return values;
}

ExtremeFinder::End ExtremeFinder::end(int sign) const
{
    const Reach& reach = sign > 0 ? m_high : m_low;
    if (sign * (reach.value - m_neutral) <= 0.0) {
        return {m_neutral, {}, true};
    }
    End end{reach.value, {0, 0, 0, reach.from, reach.to}, true};
    const double limit = std::max(kOutlierSigmas * m_sigma, m_rules.stillFloor);
    const auto held = between(reach.from, reach.to);
    for (const int raw : held) {
        if (std::abs(raw - reach.value) <= limit) {
            auto& [lowest, highest, samples, from, to] = end.window;
            lowest = samples == 0 ? raw : std::min(lowest, raw);
            highest = samples == 0 ? raw : std::max(highest, raw);
            ++samples;
        }
    }
    const bool agrees =
        kLeastAgreeing * static_cast<std::size_t>(end.window.samples) >= held.size();
    end.isHeld = agrees && !isOnlyPassed(reach, sign) && !isRushedPast(reach, sign);
    return end;
}

bool ExtremeFinder::isOnlyPassed(const Reach& reach, int sign) const
{
    const Duration length = reach.to - reach.from;
    std::optional<double> least; // of the drops to either side; a hold needs one side only
    for (const auto& beside : {between(reach.from - length, reach.from - 1ns),
                               between(reach.to + 1ns, reach.to + length)}) {
        if (beside.size() >= kLeastBeside) {
            const double drop = sign * (reach.value - medianOf(beside));
            least = std::min(least.value_or(drop), drop);
        }
    }
    const double travel = m_high.value - m_low.value;
    const double allowed =
        kDropFactor * std::min(kMostError * travel - m_sigma, kMostAllowed * travel);
    return least.value_or(0.0) > std::max(allowed, kLeastDropSigmas * m_sigma);
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
