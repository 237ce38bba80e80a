// SPDX-License-Identifier: GPL-3.0-or-later
// What the controller makes of a raw reading, as far as the documents say it. Pure.
#pragma once

#include "protocol/codec/command.h"

namespace trex {

/// Raw reading → remapped value of one channel (command documentation, 0x87; facts.md 5.3), before
/// mixing and flipping: 0 within neutral ± deadband, from there to ±127 at the calibrated ends,
/// clamped beyond them, then reversed.
///
/// Guesses (grade I), to be marked wherever they are shown: the parabola's exact form lin² / 127
/// (the document names it, but publishes no formula), the rounding towards zero, and the threshold
/// of the switch channels, half-way between neutral and minimum (facts.md 5.4).
struct ResponseCurve {
    Calibration calibration;
    bool reversed = false; ///< the channel's bit in parameter 0x03
    bool parabolic = false; ///< the channel's bit in parameter 0x04

    [[nodiscard]] int remap(double raw) const; ///< −127 to 127
    [[nodiscard]] double shape(double raw) const; ///< the same without rounding, for drawing
    /// The raw reading at which channel 4 or 5 switches.
    [[nodiscard]] double switchThreshold() const;
    /// Channels 4 and 5: the reading stands on the side that switches flip or serial override on.
    [[nodiscard]] bool isSwitchedOn(double raw) const;
    /// The curve's form, or the threshold, is inferred: a parabola is, a line is documented.
    [[nodiscard]] Grade grade() const { return parabolic ? Grade::Inferred : Grade::Documented; }
    bool operator==(const ResponseCurve&) const = default;
};

/// Remapped value at and below which a switch channel is on (conformance C-64). A guess.
inline constexpr int kSwitchOnLevel = -64;

/// Channels 4 (flip) and 5 (serial override), facts.md 5.4.
[[nodiscard]] constexpr bool isSwitchChannel(int channel)
{
    return channel >= 4;
}

} // namespace trex
