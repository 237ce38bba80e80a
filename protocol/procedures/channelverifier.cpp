// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/channelverifier.h"

#include "protocol/procedures/robuststatistics.h"

#include <cmath>

using namespace std::chrono_literals;

namespace trex {
namespace {

constexpr std::size_t kHeld = 7; // samples: three spikes in a row reach nothing
constexpr Duration kHeldTime = 100ms;
constexpr std::size_t kRest = 25;
constexpr Duration kRestTime = 400ms;
constexpr Duration kLargestGap = 600ms;
constexpr double kMoveSigmas = 4.0;
constexpr double kNearShare = 1.0 / 16.0; // of the whole range
constexpr double kTail = 0.125; // of the readings at rest, to each side: spikes, or moving off

void note(CurveReach& reach, int remapped)
{
    reach.lowest = std::min(reach.lowest, remapped);
    reach.highest = std::max(reach.highest, remapped);
}

int larger(int a, int b)
{
    return std::abs(a) > std::abs(b) ? a : b;
}

} // namespace

ChannelVerifier::ChannelVerifier(const ResponseCurve& now, std::optional<ResponseCurve> before,
                                 double sigma, bool isOneWay)
    : m_now(now), m_before(before), m_sigma(sigma), m_isOneWay(isOneWay)
{
}

void ChannelVerifier::feed(int raw, Instant time)
{
    ++m_samples;
    if (!m_window.empty() && time - m_window.back().time > kLargestGap) {
        m_window.clear();
    }
    m_window.push_back({raw, time});
    if (m_window.size() > kRest) {
        m_window.pop_front();
    }
    if (m_window.size() >= kHeld) {
        std::vector<int> held;
        const std::size_t first = m_window.size() - kHeld;
        for (std::size_t i = first; i < m_window.size(); ++i) {
            held.push_back(m_window[i].raw);
        }
        if (time - m_window[first].time >= kHeldTime) {
            reach(medianOf(held));
        }
    }
    if (m_window.size() == kRest && time - m_window.front().time >= kRestTime) {
        rest();
    }
}

void ChannelVerifier::reach(double held)
{
    note(m_reach, m_now.remap(held));
    if (m_before) {
        note(m_reachBefore, m_before->remap(held));
    }
}

void ChannelVerifier::rest()
{
    std::vector<int> values;
    for (const Point& point : m_window) {
        values.push_back(point.raw);
    }
    const auto& calibration = m_now.calibration;
    const double range = calibration.maximum - calibration.minimum;
    const std::span all(values);
    const double moved = medianOf(all.last(kHeld)) - medianOf(all.first(kHeld));
    const double off = medianOf(values) - calibration.neutral;
    if (std::abs(moved) > std::max(kMoveSigmas * m_sigma, range / 200.0)
        || std::abs(off) > kNearShare * range) {
        return;
    }
    const double low = quantileOf(values, kTail);
    const double high = quantileOf(values, 1.0 - kTail);
    m_reach.atRest = larger(m_now.remap(low), m_now.remap(high));
    if (m_before) {
        m_reachBefore.atRest = larger(m_before->remap(low), m_before->remap(high));
    }
}

bool ChannelVerifier::isConfirmed() const
{
    const bool areEnds = m_isOneWay ? isLowFull() || isHighFull() : isLowFull() && isHighFull();
    return areEnds && isNeutralZero();
}

} // namespace trex
