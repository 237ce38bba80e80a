// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware's reading of its five channels: last pulses or conversions, and the remapping of
// the command documentation, 0x87.
#pragma once

#include "protocol/codec/quantities.h"
#include "protocol/sim/eeprom.h"

#include <array>

namespace trex::sim {

/// Everything that bends a channel's value on its way.
struct RemapSettings {
    InputKind kind = InputKind::Rc;
    int ignored = 0; ///< bit n is channel n + 1, here and below
    int reversed = 0;
    int parabolic = 0;
    bool mix = false;
};

/// Channels 4 (flip) and 5 (serial override) are on from here downwards (C-64).
inline constexpr int kSwitchesOn = -64;

class ChannelUnit {
public:
    using Values = std::array<int, kChannelCount>;

    /// A new pulse width or conversion; kInvalidPulse for a pulse that is too long or too short.
    void capture(int channel, std::uint16_t raw, Instant now);
    void forget(); ///< after power-up, or when the inputs are read another way
    /// 0xFFFF: no valid pulse. An analog channel always has a value.
    [[nodiscard]] std::uint16_t raw(int channel, InputKind kind, Instant now,
                                    Duration invalidAfter) const;

    /// Raw values to signed −127 to 127; calibrations by channel.
    [[nodiscard]] static Values remap(const std::array<std::uint16_t, kChannelCount>& raw,
                                      const std::array<CalibrationValues, kChannelCount>& cals,
                                      const RemapSettings& settings);

private:
    struct Capture {
        std::uint16_t raw = kInvalidPulse;
        Instant at;
        bool isFresh = false; ///< anything captured at all
    };
    std::array<Capture, kChannelCount> m_captures;
};

} // namespace trex::sim
