// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/trigger.h"

namespace trex {

void Trigger::arm(Instant now)
{
    m_state = State::Waiting;
    m_armed = now;
    m_seen = now;
    m_crossing.reset();
    m_wasBelow = false;
    m_wasAbove = false;
    m_count = 0;
}

/// Takes one sample; true when it is the first on the far side of the level.
bool Trigger::crosses(double physical)
{
    const double level = m_settings.level;
    const bool isUp = physical >= level;
    const bool rose = isUp && m_wasBelow && m_settings.edge != TriggerSettings::Edge::Falling;
    const bool fell = !isUp && m_wasAbove && m_settings.edge != TriggerSettings::Edge::Rising;
    if (isUp) {
        m_wasBelow = false;
    } else {
        m_wasAbove = false;
    }
    m_wasBelow |= physical < level && physical <= level - m_settings.hysteresis;
    m_wasAbove |= isUp && physical >= level + m_settings.hysteresis;
    return rose || fell;
}

bool Trigger::advance(const TimeSeries& series, const ValueScale& scale, Instant now)
{
    const State before = m_state;
    bool found = false;
    std::size_t i = m_seen ? series.axis().lowerBound(TimeAxis::ticksOf(*m_seen) + 1)
                           : series.first(); // a sample at the moment of arming was there before
    if (m_state == State::Holding) {
        i = series.size();
    }
    for (; i < series.size() && m_state != State::Holding; ++i) {
        const Instant time = series.time(i);
        m_seen = time;
        const bool isAfterGap = i > 0 && series.axis().hasGapBetween(i - 1, i);
        if (isAfterGap || !series.isValid(i)) {
            m_wasBelow = false;
            m_wasAbove = false;
        }
        if (!series.isValid(i)) {
            continue;
        }
        const bool isCrossing = crosses(scale.physical(series.value(i)));
        if (m_state == State::Capturing && time >= *m_crossing + m_settings.after) {
            m_state =
                m_settings.mode == TriggerSettings::Mode::Single ? State::Holding : State::Waiting;
        }
        if (isCrossing && m_state == State::Waiting) {
            m_crossing = time;
            m_state = State::Capturing;
            ++m_count;
            found = true;
        }
    }
    if (m_state == State::Capturing && now >= *m_crossing + m_settings.after) {
        m_state =
            m_settings.mode == TriggerSettings::Mode::Single ? State::Holding : State::Waiting;
    }
    return found || m_state != before;
}

bool Trigger::runsFreely(Instant now) const
{
    if (m_settings.mode != TriggerSettings::Mode::Auto || m_state != State::Waiting) {
        return false;
    }
    const Duration shown = m_settings.before + m_settings.after;
    return !m_crossing || now - *m_crossing >= m_settings.after + shown;
}

std::optional<Instant> firstCrossing(const TimeSeries& series, const ValueScale& scale,
                                     const TriggerSettings& settings, Instant from)
{
    TriggerSettings once = settings;
    once.mode = TriggerSettings::Mode::Single;
    Trigger trigger(once);
    trigger.arm(from - TimeAxis::kTick); // a sample at `from` counts
    trigger.advance(series, scale, from);
    return trigger.crossing();
}

} // namespace trex
