// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/returnlearner.h"

#include "protocol/procedures/robuststatistics.h"

#include <cmath>

using namespace std::chrono_literals;

namespace trex {
namespace {

constexpr std::size_t kRecent = 5; // two spikes are no movement
constexpr std::size_t kLeastSamples = 12;
constexpr std::size_t kMostKept = 200; // longer than any rest that is looked at
constexpr Duration kRestTime = 800ms;
constexpr Duration kLargestGap = 600ms;
constexpr double kAwayShare = 0.6; // of the needed travel: it was moved
constexpr double kBackShare = 0.4; // and it is back, wherever its play leaves it
constexpr double kMoveSigmas = 4.0;
constexpr double kDriftSigmas = 1.25;
constexpr double kLeastDrift = 2.0;

} // namespace

void ReturnLearner::begin(double neutral, double sigma)
{
    m_first = neutral;
    m_sigma = sigma;
    m_state = ReturnState::Rest;
    m_side = 0;
    m_window.clear();
    m_rests.clear();
}

void ReturnLearner::feed(int raw, Instant time)
{
    if (!m_window.empty() && time - m_window.back().time > kLargestGap) {
        m_window.clear(); // what happened in the silence is not known
    }
    m_window.push_back({raw, time});
    if (m_window.size() > kMostKept) {
        m_window.pop_front();
    }
    if (m_window.size() < kRecent) {
        return;
    }
    std::vector<int> recent;
    for (std::size_t i = m_window.size() - kRecent; i < m_window.size(); ++i) {
        recent.push_back(m_window[i].raw);
    }
    const double off = medianOf(recent) - m_first;
    if (std::abs(off) > kAwayShare * m_rules.neededTravel) {
        m_state = ReturnState::Away;
        m_side = off > 0.0 ? 1 : -1;
    } else if (std::abs(off) > kBackShare * m_rules.neededTravel) {
        if (m_state == ReturnState::Settling) {
            m_state = ReturnState::Away;
        }
    } else if (m_state == ReturnState::Away) {
        m_state = ReturnState::Settling;
        m_window = {m_window.back()};
    } else if (m_state == ReturnState::Settling) {
        settle();
    }
}

void ReturnLearner::settle()
{
    std::vector<int> values;
    for (const Point& point : m_window) {
        values.push_back(point.raw);
    }
    const std::span all(values);
    const std::size_t third = values.size() / 3;
    const double moved =
        medianOf(all.last(kRecent)) - medianOf(all.first(std::max<std::size_t>(1, third)));
    if (std::abs(moved)
        > std::clamp(kMoveSigmas * m_sigma, m_rules.stillFloor, m_rules.stillLimit)) {
        while (m_window.size() > kRecent) {
            m_window.pop_front();
        }
        return;
    }
    const bool isLong = m_window.back().time - m_window.front().time >= kRestTime;
    if (!isLong || values.size() < kLeastSamples) {
        return;
    }
    const double drift = medianOf(all.last(third)) - medianOf(all.first(third));
    if (std::abs(drift) > std::max(kLeastDrift, kDriftSigmas * m_sigma)) {
        m_window.pop_front();
        return;
    }
    m_rests.push_back({medianOf(values), m_side});
    m_state = ReturnState::Rest;
}

std::optional<double> ReturnLearner::medianFrom(int side) const
{
    std::vector<double> values;
    for (const Rest& rest : m_rests) {
        if (rest.side == side) {
            values.push_back(rest.value);
        }
    }
    return values.empty() ? std::nullopt : std::optional(middleOf(values));
}

double ReturnLearner::neutral() const
{
    const auto above = medianFrom(1);
    const auto below = medianFrom(-1);
    if (above && below) {
        return (*above + *below) / 2.0;
    }
    std::vector<double> values{m_first};
    for (const Rest& rest : m_rests) {
        values.push_back(rest.value);
    }
    return middleOf(values);
}

double ReturnLearner::repeatability() const
{
    double lowest = m_first;
    double highest = m_first;
    for (const Rest& rest : m_rests) {
        lowest = std::min(lowest, rest.value);
        highest = std::max(highest, rest.value);
    }
    return highest - lowest;
}

double ReturnLearner::farthestRest() const
{
    const double centre = neutral();
    double farthest = std::abs(m_first - centre);
    for (const Rest& rest : m_rests) {
        farthest = std::max(farthest, std::abs(rest.value - centre));
    }
    return farthest;
}

std::optional<double> ReturnLearner::hysteresis() const
{
    const auto above = medianFrom(1);
    const auto below = medianFrom(-1);
    return above && below ? std::optional(*above - *below) : std::nullopt;
}

} // namespace trex
