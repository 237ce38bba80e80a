// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/channelunit.h"

#include <algorithm>

namespace trex::sim {
namespace {

// facts.md 5.3 (C-28): integers, as an 8-bit controller would.
int scale(int raw, const CalibrationValues& calibration)
{
    const auto& [minimum, neutral, maximum, deadband] = calibration;
    if (raw >= maximum) {
        return kFullSpeed;
    }
    if (raw <= minimum) {
        return -kFullSpeed;
    }
    if (raw > neutral + deadband) {
        return kFullSpeed * (raw - neutral - deadband) / (maximum - neutral - deadband);
    }
    if (raw < neutral - deadband) {
        return -kFullSpeed * (neutral - deadband - raw) / (neutral - deadband - minimum);
    }
    return 0;
}

int clip(int value)
{
    return std::clamp(value, -kFullSpeed, kFullSpeed);
}

} // namespace

void ChannelUnit::capture(int channel, std::uint16_t raw, Instant now)
{
    m_captures[static_cast<std::size_t>(channel - 1)] = {raw, now, true};
}

void ChannelUnit::forget()
{
    m_captures = {};
}

std::uint16_t ChannelUnit::raw(int channel, InputKind kind, Instant now,
                               Duration invalidAfter) const
{
    const Capture& capture = m_captures[static_cast<std::size_t>(channel - 1)];
    if (kind == InputKind::Analog) {
        return capture.isFresh ? capture.raw : 0;
    }
    const bool isRecent = capture.isFresh && now - capture.at <= invalidAfter;
    return isRecent ? capture.raw : kInvalidPulse;
}

ChannelUnit::Values ChannelUnit::remap(const std::array<std::uint16_t, kChannelCount>& raw,
                                       const std::array<CalibrationValues, kChannelCount>& cals,
                                       const RemapSettings& settings)
{
    Values values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        const int bit = 1 << i;
        const bool isInvalid = settings.kind == InputKind::Rc && raw[i] == kInvalidPulse;
        if (isInvalid || (settings.ignored & bit) != 0) {
            continue; // C-64; facts.md 2, 0x02: fixed at neutral
        }
        int value = scale(raw[i], cals[i]);
        if ((settings.parabolic & bit) != 0) {
            value = value * std::abs(value) / kFullSpeed;
        }
        values[i] = (settings.reversed & bit) != 0 ? -value : value;
    }
    if (settings.mix) { // C-65
        const int turn = values[0];
        const int forward = values[1];
        values[0] = clip(forward + turn);
        values[1] = clip(forward - turn);
    }
    if (values[3] <= kSwitchesOn) { // flip: the motors change places and directions
        std::swap(values[0], values[1]);
        values[0] = -values[0];
        values[1] = -values[1];
    }
    return values;
}

} // namespace trex::sim
