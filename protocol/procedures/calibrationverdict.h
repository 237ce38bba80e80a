// SPDX-License-Identifier: GPL-3.0-or-later
// What the learner found for a channel, in figures, and what it thinks of it. Pure.
#pragma once

#include "protocol/procedures/learnedchannel.h"

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

inline constexpr double kDeadbandSigmas = 4.0; ///< deadband = this many σ, at least the floor,
inline constexpr double kDeadbandRests = 1.25; ///< and this many times the farthest rest
inline constexpr double kDeadbandRestSigmas = 3.0; ///< with this many σ around that rest
inline constexpr double kGoodNoiseShare = 0.004; ///< σ / travel up to which noise is good
inline constexpr double kMostNoiseShare = 0.009; ///< σ / travel above which it is to be done again
/// An end that may lie further from the truth than this share of the travel, all in all, is not
/// written: its uncertainty, its margin and the rounding to whole counts together.
inline constexpr double kMostEndError = 0.01;
/// Half a second at 50 Hz, for which a person is asked to hold an end. Where even that would not
/// tell the end for its noise, it is the noise that is at fault.
inline constexpr std::size_t kHoldSamples = 25;
inline constexpr double kEndMarginShare = 0.005; ///< of a side, by which its end is pulled in
inline constexpr double kGoodMissedShare = 0.02;
inline constexpr double kMostMissedShare = 0.20;
inline constexpr double kGoodSpikeShare = 0.005;
inline constexpr double kMostSpikeShare = 0.04;
inline constexpr double kGoodSymmetry = 0.5; ///< smaller / larger side
inline constexpr double kGoodRestShare = 0.02; ///< farthest rest / travel
inline constexpr double kPlainForeignShare = 0.5; ///< readings that only the other kind can give

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
    EndWindow lowWindow{}; ///< what the ends were learned from
    EndWindow highWindow{};
    double lowUncertainty = 0.0; ///< ±, raw; see EndEstimate
    double highUncertainty = 0.0;
    bool isLowHeld = true; ///< the stick did not pass beyond the end without resting there
    bool isHighHeld = true;
    int returns = 0;
    double repeatability = 0.0;
    double farthestRest = 0.0; ///< from the neutral
    std::optional<double> hysteresis{};
    int checked = 0; ///< samples looked at for spikes
    int spikes = 0;
    Confusion confusion = Confusion::None;
    int swappedWith = 0;
    int forwardSign = 0;
};
[[nodiscard]] LearnedChannel judge(const ChannelMeasurement& measurement, InputKind input);

/// Channels 3 to 5 (throttle and switches, facts.md 5.4) may rest at one end of their travel.
[[nodiscard]] constexpr bool mayRestAtEnd(int channel)
{
    return channel >= 3;
}

} // namespace trex
