// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/calibrationverdict.h"

#include <array>
#include <deque>

namespace trex {

/// What happened when one stick was to be pushed forward.
struct DirectionResult {
    int askedChannel = 1;
    int movedChannel = 1; ///< another one: plugs or axes are swapped
    int sign = 1; ///< 1: its readings rose, −1: they fell

    [[nodiscard]] bool isSwapped() const { return movedChannel != askedChannel; }
    /// The moved channel should be reversed (parameter 0x03) for forward to be forward.
    [[nodiscard]] bool isReversed() const { return sign < 0; }
    bool operator==(const DirectionResult&) const = default;
};

/// Watches all five channels while one stick is pushed forward. It first waits until the sticks
/// rest, so that a movement still going on is not taken for the push. Pure.
class DirectionProbe {
public:
    /// Where a channel rests and how far it goes, as far as it was learned.
    struct Channel {
        std::optional<double> neutral; ///< none: where it is found at rest
        double travel = 0.0; ///< to the larger side
        double sigma = 0.0;
    };
    DirectionProbe(int asked, InputKind input, const std::array<Channel, kChannelCount>& channels);

    void feed(const std::array<int, kChannelCount>& raw, Instant time);

    [[nodiscard]] int askedChannel() const { return m_asked; }
    [[nodiscard]] bool isWatching() const { return m_isWatching; } ///< at rest: push now
    /// Once a move of more than a quarter of its travel has lasted; it then stays as it is. The
    /// asked channel wins over others that move with it, as they do with mixing transmitters.
    [[nodiscard]] const std::optional<DirectionResult>& result() const { return m_result; }

private:
    struct Track {
        std::optional<double> rest; ///< of a sprung channel: its neutral
        bool isWatched = false; ///< it has rested, so that a move can be told
        double travel = 0.0;
        double sigma = 0.0;
        bool isLearned = false;
        std::deque<int> recent; ///< latest valid readings
        int sign = 0; ///< of the move under way, 0: none
        Instant since; ///< when it began
        bool hasStirred = false; ///< moved at all since watching
    };
    [[nodiscard]] bool isResting(const Track& track) const;
    void startWatching(Instant time);
    void tryRest(Track& track) const;
    void watch(Track& track, Instant time);
    void decide(Instant time);

    int m_asked;
    const CalibrationRules& m_rules;
    std::array<Track, kChannelCount> m_tracks;
    bool m_isWatching = false;
    std::optional<Instant> m_begun;
    std::optional<DirectionResult> m_result;
};

} // namespace trex
