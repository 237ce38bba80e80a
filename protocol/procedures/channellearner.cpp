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
constexpr Duration kLargestGap = 600ms; // a longer silence breaks a window

constexpr std::size_t kLeastSustained = 7; // three spikes in a row reach nothing
constexpr std::size_t kMostSustained = 15;
constexpr Duration kLeastSustainedTime = 100ms;
constexpr Duration kSettledTime = 1500ms;
constexpr Duration kOneWayPatience = 6s; // before a lever is believed to have one end only
constexpr std::size_t kMostKept = 60'000; // 20 minutes at 50 Hz

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
    : m_channel(channel), m_input(input), m_rules(calibrationRules(input)), m_stillTime(stillTime)
{
}

void ChannelLearner::beginNeutral()
{
    m_isExtremes = false;
    m_window.clear();
    m_missedInWindow.clear();
    m_restarts = 0;
    m_movedBy = 0;
    m_sweep.clear();
    m_sweepSamples = m_sweepMissed = 0;
    m_neutralSamples = m_neutralMissed = 0;
}

void ChannelLearner::beginExtremes()
{
    const auto values = valuesOf(m_window, 0, m_window.size());
    m_neutral = medianOf(values);
    m_sigma = robustSigma(values);
    m_neutralSamples = static_cast<int>(values.size());
    m_neutralMissed = static_cast<int>(m_missedInWindow.size());
    m_isExtremes = true;
    m_sweep.clear();
    m_sweepSamples = m_sweepMissed = 0;
    const Instant now = m_latest.value_or(Instant());
    m_low = {m_neutral, m_neutral, now};
    m_high = {m_neutral, m_neutral, now};
}

void ChannelLearner::feed(int raw, Instant time)
{
    if (m_latest && time <= *m_latest) {
        return; // a repeat of what was fed before is no new sample
    }
    m_latest = time;
    m_isValid = raw != kInvalidPulse && raw >= m_rules.smallest && raw <= m_rules.largest;
    if (m_isValid) {
        m_raw = raw;
        m_hasSeenReading = true;
        m_isExtremes ? feedExtremes(raw, time) : feedNeutral(raw, time);
    } else if (m_isExtremes) {
        ++m_sweepMissed;
    } else {
        m_missedInWindow.push_back(time);
        if (m_missedInWindow.size() > kMostKept) {
            m_missedInWindow.pop_front();
        }
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
    return std::abs(drift)
        > std::clamp(kDriftSigmas * sigma, m_rules.stillFloor, m_rules.stillLimit);
}

Duration ChannelLearner::stillFor() const
{
    return m_window.empty() ? Duration::zero() : m_window.back().time - m_window.front().time;
}

bool ChannelLearner::hasStillWindow() const
{
    const bool isCurrent = m_isExtremes || !m_latest || m_window.empty()
        || *m_latest - m_window.back().time <= kLargestGap;
    return m_window.size() >= kLeastSamples && stillFor() >= m_stillTime && isCurrent
        && !isDrifting();
}

std::size_t ChannelLearner::sustainedCount() const
{
    // The noisier, the longer an end must be held, so that it is not a peak of the noise.
    const double share = m_sigma / m_rules.neededTravel;
    const auto extra = static_cast<std::size_t>(std::lround(share * 300.0));
    return std::min(kLeastSustained + extra, kMostSustained);
}

void ChannelLearner::feedExtremes(int raw, Instant time)
{
    if (m_sweep.size() >= kMostKept) {
        m_sweep.pop_front();
    }
    m_sweep.push_back({raw, time});
    ++m_sweepSamples;
    std::size_t first = m_sweep.size() - 1;
    std::size_t count = 1;
    while (first > 0
           && (count < sustainedCount() || time - m_sweep[first].time < kLeastSustainedTime)) {
        if (m_sweep[first].time - m_sweep[first - 1].time > kLargestGap) {
            return; // nothing is sustained across a silence
        }
        --first;
        ++count;
    }
    if (count >= sustainedCount() && time - m_sweep[first].time >= kLeastSustainedTime) {
        growEnds(medianOf(valuesOf(m_sweep, first, m_sweep.size())), time);
    }
}

void ChannelLearner::growEnds(double sustained, Instant time)
{
    // An end that creeps up within its own noise has stopped growing.
    const double notable = std::max(2.0 * m_sigma, m_rules.neededTravel / 100.0);
    const auto grow = [&](End& end, double by) {
        if (by <= 0.0) {
            return;
        }
        end.value = sustained;
        if (std::abs(end.value - end.noted) > notable) {
            end.noted = end.value;
            end.grownAt = time;
        }
    };
    grow(m_low, m_low.value - sustained);
    grow(m_high, sustained - m_high.value);
}

int ChannelLearner::lowTravel() const
{
    return m_isExtremes ? static_cast<int>(std::lround(m_neutral - m_low.value)) : 0;
}

int ChannelLearner::highTravel() const
{
    return m_isExtremes ? static_cast<int>(std::lround(m_high.value - m_neutral)) : 0;
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
    if (!m_isExtremes || !m_latest) {
        return false;
    }
    const Duration rest = *m_latest - std::max(m_low.grownAt, m_high.grownAt);
    if (lowNeeded() == 0 && highNeeded() == 0) {
        return rest >= kSettledTime;
    }
    const bool isOneWay = lowNeeded() == 0 || highNeeded() == 0;
    return isOneWay && mayRestAtEnd(m_channel) && rest >= kOneWayPatience;
}

double ChannelLearner::refinedEnd(double reached, int sign) const
{
    // The best sustained value is a little lucky in noise; the median of all samples of that end's
    // plateau is not. Spikes beyond the plateau stay out.
    const double sigma = std::max(1.0, m_sigma);
    std::vector<int> plateau;
    for (const Point& point : m_sweep) {
        const double beyond = sign * (point.raw - reached);
        if (beyond >= -sigma && beyond <= 5.0 * sigma) {
            plateau.push_back(point.raw);
        }
    }
    return plateau.empty() ? reached : medianOf(plateau);
}

LearnedChannel ChannelLearner::result() const
{
    ChannelMeasurement measured;
    measured.channel = m_channel;
    measured.hasNeutral = m_isExtremes;
    if (m_isExtremes) {
        measured.samples = m_neutralSamples + m_sweepSamples;
        measured.missed = m_neutralMissed + m_sweepMissed;
        measured.neutral = m_neutral;
        measured.sigma = m_sigma;
        measured.lowEnd = lowTravel() > 0 ? refinedEnd(m_low.value, -1) : m_neutral;
        measured.highEnd = highTravel() > 0 ? refinedEnd(m_high.value, 1) : m_neutral;
    } else {
        measured.samples = m_hasSeenReading ? static_cast<int>(m_window.size()) : 0;
        measured.missed = static_cast<int>(m_missedInWindow.size());
    }
    return judge(measured, m_input);
}

} // namespace trex
