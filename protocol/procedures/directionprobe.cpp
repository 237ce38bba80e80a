// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/directionprobe.h"

#include "protocol/procedures/robuststatistics.h"

#include <cmath>

using namespace std::chrono_literals;

namespace trex {
namespace {

constexpr std::size_t kKept = 15; // 0.3 s at 50 Hz
constexpr std::size_t kRecent = 5; // two spikes are no movement
constexpr double kMoveSigmas = 4.0;
constexpr double kPushShare = 0.25; // of the travel
constexpr double kStirShare = 0.12; // from here on the asked stick is on its way itself
constexpr double kRestShare = 0.15; // of the travel: how near a sprung stick is to its neutral
constexpr Duration kPushTime = 150ms;
constexpr Duration kOtherPushTime = 500ms; // time for the asked stick to stir
constexpr Duration kPatience = 2s; // with channels that give nothing or never rest

double recentMedian(const std::deque<int>& values)
{
    const auto count = static_cast<std::ptrdiff_t>(std::min(kRecent, values.size()));
    return medianOf(std::vector<int>(values.end() - count, values.end()));
}

double earlyMedian(const std::deque<int>& values)
{
    const auto count = static_cast<std::ptrdiff_t>(std::min(kRecent, values.size()));
    return medianOf(std::vector<int>(values.begin(), values.begin() + count));
}

} // namespace

DirectionProbe::DirectionProbe(int asked, InputKind input,
                               const std::array<Channel, kChannelCount>& channels)
    : m_asked(asked), m_rules(calibrationRules(input))
{
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const bool isSprung = channels[i].neutral && !mayRestAtEnd(static_cast<int>(i) + 1);
        m_tracks[i].rest = isSprung ? channels[i].neutral : std::nullopt;
        m_tracks[i].isLearned = channels[i].neutral.has_value();
        m_tracks[i].travel = std::max(channels[i].travel, double(m_rules.neededTravel));
        m_tracks[i].sigma = channels[i].sigma;
    }
}

void DirectionProbe::feed(const std::array<int, kChannelCount>& raw, Instant time)
{
    if (m_result) {
        return;
    }
    if (!m_begun) {
        m_begun = time;
    }
    for (std::size_t i = 0; i < raw.size(); ++i) {
        auto& track = m_tracks[i];
        if (raw[i] < m_rules.smallest || raw[i] > m_rules.largest) {
            continue;
        }
        track.recent.push_back(raw[i]);
        if (track.recent.size() > kKept) {
            track.recent.pop_front();
        }
        if (m_isWatching) {
            watch(track, time);
        }
    }
    m_isWatching ? decide(time) : startWatching(time);
}

bool DirectionProbe::isResting(const Track& track) const
{
    if (track.recent.size() < kKept) {
        return false;
    }
    const double limit =
        std::clamp(kMoveSigmas * track.sigma, m_rules.stillFloor, m_rules.stillLimit);
    const double now = recentMedian(track.recent);
    return std::abs(now - earlyMedian(track.recent)) <= limit
        && (!track.rest || std::abs(now - *track.rest) <= kRestShare * track.travel);
}

void DirectionProbe::startWatching(Instant time)
{
    const bool isLate = time - *m_begun >= kPatience;
    for (std::size_t i = 0; i < m_tracks.size(); ++i) {
        const auto& track = m_tracks[i];
        const bool isAsked = static_cast<int>(i) + 1 == m_asked;
        const bool isWaitedFor = isAsked ? !isLate || !track.recent.empty()
                                         : !isLate && (track.isLearned || !track.recent.empty());
        if (isWaitedFor && !isResting(track)) {
            return;
        }
    }
    m_isWatching = true;
    for (auto& track : m_tracks) {
        tryRest(track);
    }
}

/// Without a rest nothing can be said of a channel. A sprung one that still moves when the watch
/// begins is watched from when it has come to its neutral.
void DirectionProbe::tryRest(Track& track) const
{
    if (isResting(track)) {
        if (!track.rest) {
            track.rest = medianOf(std::vector<int>(track.recent.begin(), track.recent.end()));
        }
        track.isWatched = true;
        track.recent.clear();
    }
}

void DirectionProbe::watch(Track& track, Instant time)
{
    if (!track.isWatched) {
        if (track.rest) { // one that is not known would be wherever it pauses
            tryRest(track);
        }
        return;
    }
    if (track.recent.size() < kRecent) {
        return;
    }
    const double share = (recentMedian(track.recent) - *track.rest) / track.travel;
    const int sign = share >= kPushShare ? 1 : share <= -kPushShare ? -1 : 0;
    if (sign != track.sign) {
        track.sign = sign;
        track.since = time;
    }
    track.hasStirred = track.hasStirred || std::abs(share) > kStirShare;
}

void DirectionProbe::decide(Instant time)
{
    const auto& asked = m_tracks.at(static_cast<std::size_t>(m_asked - 1));
    if (asked.sign != 0 && time - asked.since >= kPushTime) {
        m_result = DirectionResult{m_asked, m_asked, asked.sign};
        return;
    }
    for (std::size_t i = 0; i < m_tracks.size() && !asked.hasStirred; ++i) {
        const auto& track = m_tracks[i];
        if (track.sign != 0 && time - track.since >= kOtherPushTime) {
            m_result = DirectionResult{m_asked, static_cast<int>(i) + 1, track.sign};
            return;
        }
    }
}

} // namespace trex
