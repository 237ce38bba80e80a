// SPDX-License-Identifier: GPL-3.0-or-later
// The learner's figures and verdicts as words for people; the only place that makes them.
#pragma once

#include "protocol/procedures/calibrationverdict.h"

#include <QString>

namespace trex {

/// A reading with its unit: "1.455 ms", "2.41 V".
[[nodiscard]] QString readingText(double raw, InputKind input);
/// A difference of readings: "210 µs", "0.61 V".
[[nodiscard]] QString spanText(double raw, InputKind input);

[[nodiscard]] QString verdictText(Verdict verdict); ///< "good", "usable", "do again"
/// One sentence: what was found and, where something can be done, what to do.
[[nodiscard]] QString findingText(Finding finding, const LearnedChannel& learned, InputKind input);
/// The first finding as a sentence; "good" has one of its own.
[[nodiscard]] QString reasonText(const LearnedChannel& learned, InputKind input);
/// How well it comes back to its neutral, or that this was not tried.
[[nodiscard]] QString centringText(const LearnedChannel& learned, InputKind input);
/// The deadband and which of its terms decided it, with its factor.
[[nodiscard]] QString deadbandText(const LearnedChannel& learned, InputKind input);
/// How well its ends are known, and from how many samples.
[[nodiscard]] QString endsText(const LearnedChannel& learned, InputKind input);
/// Samples, missed pulses, noise, travel, symmetry, centring, deadband, ends, margins and a
/// switch's threshold, one a line.
[[nodiscard]] QString figuresText(const LearnedChannel& learned, InputKind input);
/// "1, 2 and 5" of a mask (bit n is channel n + 1).
[[nodiscard]] QString channelListText(std::uint8_t mask);

} // namespace trex
