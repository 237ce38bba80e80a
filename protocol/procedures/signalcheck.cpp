// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/signalcheck.h"

#include <cmath>

using namespace std::chrono_literals;

namespace trex {
namespace {

constexpr double kZeroShare = 0.01; // of the range: counts as 0 V
constexpr double kHighShare = 0.05; // of the range: well above it
// A pulse of 1 to 2 ms in a frame of 20 ms, seen by 16 conversions in a row (facts.md 5.2), shows
// in some 15 of 100 readings; frames of 8 ms show in more.
constexpr double kLeastAtZero = 0.5;
constexpr double kLeastHigh = 0.03;
constexpr int kLeastBursts = 4;
constexpr int kLeastWanders = 4;
constexpr Duration kWanderTime = 8s;
constexpr int kLeastForeign = 20;

} // namespace

void SignalCheck::begin()
{
    m_samples = m_missed = m_foreign = m_atZero = m_high = m_bursts = 0;
    m_isHigh = false;
    m_first.reset();
}

void SignalCheck::feed(int raw, Instant time)
{
    m_first = m_first.value_or(time);
    m_last = time;
    const auto& other =
        calibrationRules(m_input == InputKind::Rc ? InputKind::Analog : InputKind::Rc);
    if (raw >= m_rules.smallest && raw <= m_rules.largest) {
        ++m_samples;
    } else {
        ++m_missed;
        // 0xFFFF says "no valid pulse", which no voltage can (command documentation, 0x86).
        const bool isOthers = raw >= other.smallest && raw <= other.largest;
        const bool isNoPulse = raw == kInvalidPulse && m_input == InputKind::Analog;
        m_foreign += isOthers || isNoPulse ? 1 : 0;
        return;
    }
    const double range = m_rules.largest - m_rules.smallest;
    const double above = raw - m_rules.smallest;
    m_atZero += above <= kZeroShare * range ? 1 : 0;
    const bool isHigh = above >= kHighShare * range;
    m_high += isHigh ? 1 : 0;
    m_bursts += isHigh && !m_isHigh ? 1 : 0;
    m_isHigh = isHigh;
}

Confusion SignalCheck::confusion(int restarts, bool hasNeutral) const
{
    const int all = m_samples + m_missed;
    if (m_foreign >= kLeastForeign && m_foreign >= kPlainForeignShare * all) {
        return Confusion::OtherKindsReadings;
    }
    if (m_input != InputKind::Analog) {
        return Confusion::None;
    }
    if (m_bursts >= kLeastBursts && m_atZero >= kLeastAtZero * m_samples
        && m_high >= kLeastHigh * m_samples) {
        return Confusion::PulsesOnAnalog;
    }
    const bool isLong = m_first && m_last - *m_first >= kWanderTime;
    return !hasNeutral && isLong && restarts >= kLeastWanders ? Confusion::Floating
                                                              : Confusion::None;
}

} // namespace trex
