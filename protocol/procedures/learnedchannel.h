// SPDX-License-Identifier: GPL-3.0-or-later
// The learner's one result for a channel. Pure.
#pragma once

#include "protocol/codec/command.h"

#include <optional>
#include <vector>

namespace trex {

enum class Verdict : std::uint8_t { Good, Usable, DoAgain };

/// Why a verdict is not "good". The order is that of telling: the first found is the reason.
enum class Finding : std::uint8_t {
    NoReadings, ///< no valid reading at all
    InputConfused, ///< RC and analog mixed up; LearnedChannel::confusion says by what one sees it
    NotStill, ///< no still window for the neutral
    MissingPulses, ///< more than kMostMissedShare of the readings invalid
    Jitter, ///< spikes or dropouts beyond what the noise explains: a failing potentiometer
    NotMoved,
    TravelTooSmall, ///< moved both ways, but not far enough
    OneDirection, ///< a drive channel that was moved one way only
    Noisy, ///< σ above kMostNoiseShare of the travel
    NotHeld, ///< not rested at an end for long enough to know it within kMostEndError
    CentreLost, ///< comes back to rests so far apart that no deadband can cover them
    // from here on the channel is usable
    SwappedWith, ///< another channel moved when this one was asked for (see swappedWith)
    SwitchOnAtNeutral, ///< channels 4 and 5: at rest on the low side, which is "on". A guess.
    RestsAtEnd, ///< channels 3 to 5: moves one way only, as levers and switches do
    SomeMissing,
    SomeNoise,
    SomeJitter,
    SloppyCentre, ///< comes back to its neutral badly; the deadband is wider for it
    CoarseTravel, ///< fewer counts than the 127 steps to each side
    Asymmetric,
    Saturated, ///< an end lies at the limit of what can be read
};

/// By what the learner thinks that RC and analog are mixed up.
enum class Confusion : std::uint8_t {
    None,
    OtherKindsReadings, ///< certain: most readings are such as only the other kind gives
    PulsesOnAnalog, ///< a guess: 0 V most of the time with short bursts, at rest
    Floating, ///< a guess: an analog input that wanders for seconds without ever resting
};

/// Which of its three terms decided the deadband.
enum class DeadbandBasis : std::uint8_t { Floor, Noise, Rests };

/// The readings that an end was learned from: all of them lie in lowest to highest.
struct EndWindow {
    int lowest = 0;
    int highest = 0;
    int samples = 0;
    Instant from{};
    Instant to{};
};

/// One channel as learned; values in raw units.
struct LearnedChannel {
    int channel = 1;
    Verdict verdict = Verdict::DoAgain;
    std::vector<Finding> findings; ///< empty: good
    Calibration calibration; ///< to be written; meaningless when the verdict is DoAgain
    int samples = 0; ///< valid ones, of all steps
    int missed = 0; ///< invalid ones
    double neutral = 0.0;
    double sigma = 0.0; ///< noise at neutral
    double lowEnd = 0.0; ///< reached and sustained, before the margin
    double highEnd = 0.0;
    double lowUncertainty = 0.0; ///< ±: the end lies no further from lowEnd (see EndEstimate)
    double highUncertainty = 0.0;
    int lowMargin = 0; ///< pulled in by, so that the full stick gives 127
    int highMargin = 0;
    EndWindow lowWindow; ///< no samples: that end was not reached
    EndWindow highWindow;

    int returns = 0; ///< times it was moved and let go; 0: how it comes back is not known
    double repeatability = 0.0; ///< from the lowest to the highest of its rests
    double farthestRest = 0.0; ///< of a rest from the neutral: the centring error
    std::optional<double> hysteresis; ///< rests come from above minus from below, if both are known

    DeadbandBasis deadbandBasis = DeadbandBasis::Floor;
    int checked = 0; ///< samples looked at for spikes: those of the neutral and of the sweep
    int spikes = 0; ///< readings beyond what the noise explains
    Confusion confusion = Confusion::None;
    int swappedWith = 0; ///< the channel that moved instead of this; 0: none, or not tried
    int forwardSign = 0; ///< 1: readings rise when pushed forward, −1: they fall, 0: not tried
    /// Channels 4 and 5: the raw reading at and below which they are on, with the calibration
    /// proposed. A guess (facts.md 5.4, grade I−), to be marked as such.
    std::optional<int> switchThreshold;

    [[nodiscard]] double lowTravel() const { return neutral - lowEnd; }
    [[nodiscard]] double highTravel() const { return highEnd - neutral; }
    [[nodiscard]] double symmetry() const; ///< smaller / larger side, 0 to 1
    [[nodiscard]] double missedShare() const; ///< 0 to 1
    [[nodiscard]] double spikeShare() const; ///< 0 to 1
    [[nodiscard]] bool has(Finding finding) const;
    /// Pushed forward it falls, so that parameter 0x03 should reverse it.
    [[nodiscard]] bool isReversed() const { return forwardSign < 0; }
};

} // namespace trex
