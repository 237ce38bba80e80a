// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/channellearner.h"

#include "protocol/procedures/robuststatistics.h"

#include <cmath>
#include <vector>

using namespace std::chrono_literals;

namespace trex {
namespace {

constexpr std::size_t kRecent = 5; // samples that a movement must last: two spikes do not move it
constexpr std::size_t kLeastBefore = 5; // samples before them to compare with
constexpr std::size_t kLeastSamples = 20;
constexpr double kMoveSigmas = 4.0;
constexpr double kDriftSigmas = 1.25;
constexpr double kLeastDrift = 1.3; // raw: more than the rounding of a median
constexpr Duration kLargestGap = 600ms; // a longer silence breaks a window

constexpr Duration kSettledTime = 1500ms;
constexpr Duration kOneWayPatience = 6s; // before a lever is believed to have one end only
constexpr Duration kVaguePatience = 8s; // for ends to be held for longer, until they are known
constexpr int kLookEvery = 5; // samples: 10 times a second
constexpr std::size_t kMostKept = 60'000; // 20 minutes at 50 Hz
constexpr double kSpikeSigmas = 8.0;

template <class Points>
std::vector<int> valuesOf(const Points& points, std::size_t from, std::size_t to)
{
    std::vector<int> values;
    values.reserve(to - from);
    for (std::size_t i = from; i < to; ++i) {
        values.push_back(points[i].raw);
    }
    return values;
}

} // namespace

ChannelLearner::ChannelLearner(int channel, InputKind input, Duration stillTime)
    : m_channel(channel)
    , m_input(input)
    , m_rules(calibrationRules(input))
    , m_stillTime(stillTime)
    , m_check(input)
    , m_returns(input)
    , m_extremes(input)
{
}

void ChannelLearner::beginNeutral()
{
    m_phase = Phase::Neutral;
    m_window.clear();
    m_missedInWindow.clear();
    m_restarts = 0;
    m_movedBy = 0;
    m_check.begin();
    m_hasNeutral = false;
    m_neutralSpikes = 0;
    m_samplesBefore = m_missedBefore = 0;
    m_returnSamples = m_returnMissed = 0;
    m_returns.begin(0.0, 0.0);
    m_extremes.begin(0.0, 0.0, m_latest.value_or(Instant()));
    m_sweepMissed = 0;
    m_forwardSign = m_swappedWith = 0;
}

void ChannelLearner::takeNeutral()
{
    const auto values = valuesOf(m_window, 0, m_window.size());
    m_neutral = medianOf(values);
    m_sigma = refinedSigma(values);
    m_samplesBefore = static_cast<int>(values.size());
    m_missedBefore = static_cast<int>(m_missedInWindow.size());
    const double limit = std::max(kSpikeSigmas * deviationSigma(values), m_rules.stillFloor);
    m_neutralSpikes = static_cast<int>(
        std::ranges::count_if(values, [&](int raw) { return std::abs(raw - m_neutral) > limit; }));
    m_hasNeutral = true;
}

void ChannelLearner::beginReturns()
{
    if (m_phase == Phase::Neutral) {
        takeNeutral();
    }
    m_phase = Phase::Returns;
    m_returnSamples = m_returnMissed = 0;
    m_returns.begin(m_neutral, m_sigma);
}

void ChannelLearner::beginExtremes()
{
    if (m_phase == Phase::Neutral) {
        takeNeutral();
    } else if (m_returns.count() > 0) {
        m_neutral = m_returns.neutral();
    }
    m_phase = Phase::Extremes;
    m_sweepMissed = 0;
    m_areEndsKnown = false;
    m_extremes.begin(m_neutral, m_sigma, m_latest.value_or(Instant()));
}

void ChannelLearner::feed(int raw, Instant time)
{
    if (m_latest && time <= *m_latest) {
        return; // a repeat of what was fed before is no new sample
    }
    m_latest = time;
    m_isValid = raw != kInvalidPulse && raw >= m_rules.smallest && raw <= m_rules.largest;
    m_raw = m_isValid ? raw : m_raw;
    switch (m_phase) {
    case Phase::Neutral:
        m_check.feed(raw, time);
        if (m_isValid) {
            feedNeutral(raw, time);
        } else {
            m_missedInWindow.push_back(time);
        }
        if (m_missedInWindow.size() > kMostKept) {
            m_missedInWindow.pop_front();
        }
        break;
    case Phase::Returns:
        ++(m_isValid ? m_returnSamples : m_returnMissed);
        if (m_isValid) {
            m_returns.feed(raw, time);
        }
        break;
    case Phase::Extremes:
        m_isValid ? feedExtremes(raw, time) : void(++m_sweepMissed);
        break;
    case Phase::Watching:
        break;
    }
}

void ChannelLearner::restartWindow(std::size_t keep)
{
    while (m_window.size() > keep) {
        m_window.pop_front();
    }
    while (!m_missedInWindow.empty()
           && (m_window.empty() || m_missedInWindow.front() < m_window.front().time)) {
        m_missedInWindow.pop_front();
    }
}

void ChannelLearner::feedNeutral(int raw, Instant time)
{
    if (!m_window.empty() && time - m_window.back().time > kLargestGap) {
        restartWindow(0);
    }
    m_window.push_back({raw, time});
    if (m_window.size() >= kLeastBefore + kRecent) {
        const std::size_t split = m_window.size() - kRecent;
        const auto before = valuesOf(m_window, 0, split);
        const double moved =
            medianOf(valuesOf(m_window, split, m_window.size())) - medianOf(before);
        // Judged against the channel's own noise, within absolute limits.
        const double limit = std::clamp(kMoveSigmas * differenceSigma(before), m_rules.stillFloor,
                                        m_rules.stillLimit);
        if (std::abs(moved) > limit) {
            ++m_restarts;
            m_movedBy = static_cast<int>(std::lround(moved));
            m_movedAt = time;
            restartWindow(kRecent);
        }
    }
    // The window slides once it is long enough, so that it is the latest still time.
    while (m_window.size() > kLeastSamples && time - m_window[1].time >= m_stillTime) {
        restartWindow(m_window.size() - 1);
    }
}

bool ChannelLearner::isDrifting() const
{
    const std::size_t third = m_window.size() / 3;
    const double drift = medianOf(valuesOf(m_window, m_window.size() - third, m_window.size()))
        - medianOf(valuesOf(m_window, 0, third));
    const double sigma = differenceSigma(valuesOf(m_window, 0, m_window.size()));
    return std::abs(drift) > std::clamp(kDriftSigmas * sigma, kLeastDrift, m_rules.stillLimit);
}

Duration ChannelLearner::stillFor() const
{
    return m_window.empty() ? Duration::zero() : m_window.back().time - m_window.front().time;
}

bool ChannelLearner::hasStillWindow() const
{
    const bool isCurrent = m_phase != Phase::Neutral || !m_latest || m_window.empty()
        || *m_latest - m_window.back().time <= kLargestGap;
    return m_window.size() >= kLeastSamples && stillFor() >= m_stillTime && isCurrent
        && !isDrifting();
}

int ChannelLearner::lowTravel() const
{
    return m_hasNeutral ? static_cast<int>(std::lround(m_neutral - m_extremes.reachedLow())) : 0;
}

int ChannelLearner::highTravel() const
{
    return m_hasNeutral ? static_cast<int>(std::lround(m_extremes.reachedHigh() - m_neutral)) : 0;
}

int ChannelLearner::lowNeeded() const
{
    return std::max(0, m_rules.neededTravel - lowTravel());
}

int ChannelLearner::highNeeded() const
{
    return std::max(0, m_rules.neededTravel - highTravel());
}

bool ChannelLearner::areEndsSettled() const
{
    if ((m_phase != Phase::Extremes && m_phase != Phase::Watching) || !m_latest) {
        return false;
    }
    const Duration rest = *m_latest - m_extremes.grownAt();
    if (areEndsReached()) {
        return rest >= (m_areEndsKnown ? kSettledTime : kVaguePatience);
    }
    const bool isOneWay = lowNeeded() == 0 || highNeeded() == 0;
    return isOneWay && mayRestAtEnd(m_channel) && rest >= kOneWayPatience;
}

bool ChannelLearner::areEndsReached() const
{
    return lowNeeded() == 0 && highNeeded() == 0;
}

bool ChannelLearner::areEndsVague() const
{
    return m_phase == Phase::Extremes && areEndsReached() && !areEndsSettled()
        && *m_latest - m_extremes.grownAt() >= kSettledTime;
}

void ChannelLearner::feedExtremes(int raw, Instant time)
{
    m_extremes.feed(raw, time);
    const bool isResting = areEndsReached() && time - m_extremes.grownAt() >= kSettledTime;
    if (!isResting) {
        m_areEndsKnown = false;
    } else if (!m_areEndsKnown && m_extremes.samples() % kLookEvery == 0) {
        m_areEndsKnown = !result().has(Finding::NotHeld);
    }
}

void ChannelLearner::setDirection(int forwardSign, int swappedWith)
{
    m_forwardSign = forwardSign;
    m_swappedWith = swappedWith;
}

LearnedChannel ChannelLearner::result() const
{
    ChannelMeasurement measured;
    measured.channel = m_channel;
    measured.hasNeutral = m_hasNeutral;
    measured.confusion = m_check.confusion(m_restarts, m_hasNeutral);
    if (m_hasNeutral) {
        const auto low = m_extremes.end(-1);
        const auto high = m_extremes.end(1);
        measured.samples = m_samplesBefore + m_returnSamples + m_extremes.samples();
        measured.missed = m_missedBefore + m_returnMissed + m_sweepMissed;
        measured.neutral = m_neutral;
        measured.sigma = m_sigma;
        measured.lowEnd = low.value;
        measured.highEnd = high.value;
        measured.lowWindow = low.window;
        measured.highWindow = high.window;
        measured.lowUncertainty = low.uncertainty;
        measured.highUncertainty = high.uncertainty;
        measured.isLowHeld = low.isHeld;
        measured.isHighHeld = high.isHeld;
        measured.checked = m_samplesBefore + m_extremes.samples();
        measured.spikes = m_neutralSpikes + m_extremes.spikes();
        measured.returns = m_returns.count();
        measured.repeatability = m_returns.repeatability();
        measured.farthestRest = m_returns.farthestRest();
        measured.hysteresis = m_returns.hysteresis();
        measured.forwardSign = m_forwardSign;
        measured.swappedWith = m_swappedWith;
    } else {
        measured.samples = m_check.samples();
        measured.missed = m_check.missed();
    }
    return judge(measured, m_input);
}

} // namespace trex
