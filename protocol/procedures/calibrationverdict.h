// SPDX-License-Identifier: GPL-3.0-or-later
// What the learner found for a channel, in figures, and what it thinks of it. Pure.
#pragma once

#include "protocol/codec/command.h"

#include <vector>

namespace trex {

/// What the learner judges by, for one input kind; raw units. Host choices, not device facts, but
/// for the range of a reading (facts.md 5.1 and 5.2).
struct CalibrationRules {
    int smallest; ///< readings outside smallest to largest are no readings
    int largest;
    double stillFloor; ///< a move smaller than this is never called one
    double stillLimit; ///< a move larger than this always is, whatever the noise
    int neededTravel; ///< from neutral to each end
    int deadbandFloor; ///< covers how well a stick comes back to its neutral
};
[[nodiscard]] const CalibrationRules& calibrationRules(InputKind input);

inline constexpr double kDeadbandSigmas = 4.0; ///< deadband = this many σ, at least the floor
inline constexpr double kGoodNoiseShare = 0.004; ///< σ / travel up to which noise is good
inline constexpr double kMostNoiseShare = 0.0125; ///< σ / travel above which it is to be done again
inline constexpr double kGoodMissedShare = 0.02;
inline constexpr double kMostMissedShare = 0.20;
inline constexpr double kGoodSymmetry = 0.5; ///< smaller / larger side

enum class Verdict : std::uint8_t { Good, Usable, DoAgain };

/// Why a verdict is not "good". The order is that of telling: the first found is the reason.
enum class Finding : std::uint8_t {
    NoReadings, ///< no valid reading at all
    NotStill, ///< no still window for the neutral
    MissingPulses, ///< more than kMostMissedShare of the readings invalid
    NotMoved,
    TravelTooSmall, ///< moved both ways, but not far enough
    OneDirection, ///< a drive channel that was moved one way only
    Noisy, ///< σ above kMostNoiseShare of the travel
    // from here on the channel is usable
    RestsAtEnd, ///< channels 3 to 5: moves one way only, as levers and switches do
    SomeMissing,
    SomeNoise,
    Asymmetric,
    Saturated, ///< an end lies at the limit of what can be read
};

/// One channel as learned; values in raw units.
struct LearnedChannel {
    Verdict verdict = Verdict::DoAgain;
    std::vector<Finding> findings; ///< empty: good
    Calibration calibration; ///< to be written; meaningless when the verdict is DoAgain
    int samples = 0; ///< valid ones, of the neutral window and of the sweep
    int missed = 0; ///< invalid ones
    double neutral = 0.0;
    double sigma = 0.0; ///< noise at neutral
    double lowEnd = 0.0; ///< reached and sustained, before the margin
    double highEnd = 0.0;
    int lowMargin = 0; ///< pulled in by, so that the full stick gives 127
    int highMargin = 0;

    [[nodiscard]] double lowTravel() const { return neutral - lowEnd; }
    [[nodiscard]] double highTravel() const { return highEnd - neutral; }
    [[nodiscard]] double symmetry() const; ///< smaller / larger side, 0 to 1
    [[nodiscard]] double missedShare() const; ///< 0 to 1
    [[nodiscard]] bool has(Finding finding) const;
};

/// What was measured, before it is judged.
struct ChannelMeasurement {
    int channel = 1;
    int samples = 0;
    int missed = 0;
    bool hasNeutral = false;
    double neutral = 0.0;
    double sigma = 0.0;
    double lowEnd = 0.0; ///< neutral when nothing was reached
    double highEnd = 0.0;
};
[[nodiscard]] LearnedChannel judge(const ChannelMeasurement& measurement, InputKind input);

/// Channels 3 to 5 (throttle and switches, facts.md 5.4) may rest at one end of their travel.
[[nodiscard]] constexpr bool mayRestAtEnd(int channel)
{
    return channel >= 3;
}

} // namespace trex
