// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/polltable.h"
#include "protocol/procedures/channellearner.h"
#include "protocol/procedures/channelverifier.h"
#include "protocol/procedures/directionprobe.h"

#include <vector>

namespace trex {

/// Learns the chosen channels side by side: neutral → returns (may be left out) → extremes →
/// direction (of any channel, any number of times) → verify. Pure: no clock, no I/O; time comes
/// with the samples.
class CalibrationLearner {
public:
    static constexpr Duration kDefaultStillTime = std::chrono::seconds(2);
    static constexpr int kReturnsNeeded = 2;
    enum class Phase : std::uint8_t { Neutral, Returns, Extremes, Direction, Verify };
    using Curves = std::array<std::optional<ResponseCurve>, kChannelCount>; ///< [0]: channel 1

    /// `mask`: bit n is channel n + 1.
    CalibrationLearner(InputKind input, std::uint8_t mask, Duration stillTime = kDefaultStillTime);

    void beginNeutral();
    /// The sticks are now moved and let go, each kReturnsNeeded times, best from both sides. Only
    /// when isNeutralDone(). May be left early: confidence then says how often it was done.
    void beginReturns();
    void beginExtremes(); ///< only when isNeutralDone(), or from the returns, or once more
    /// "Push this channel's stick forward": watches all five channels. Behind the extremes.
    void beginDirection(int channel);
    /// The sticks are moved once more, and nothing is learned: what is reached with the curves
    /// `now` (where none is given: the learned calibration, linear, not reversed) and `before`.
    /// Channels to be done again are not verified.
    void beginVerify(const Curves& before = {}, const Curves& now = {});
    /// A fresh sample of the raw channels poll; others, and repeats of the same read, are ignored.
    void feed(const PollSample& sample);

    [[nodiscard]] Phase phase() const { return m_phase; }
    [[nodiscard]] bool isUsed(int channel) const { return (m_mask >> (channel - 1) & 1) != 0; }
    [[nodiscard]] std::uint8_t mask() const { return m_mask; }
    [[nodiscard]] InputKind input() const { return m_input; }
    [[nodiscard]] const ChannelLearner& channel(int channel) const;
    [[nodiscard]] Duration stillTime() const { return m_stillTime; }

    [[nodiscard]] bool isNeutralDone() const; ///< every chosen channel is still at the same time
    /// Until then when nothing moves; the longest of all channels.
    [[nodiscard]] Duration neutralRemaining() const;

    [[nodiscard]] int returnsSeen(int channel) const { return this->channel(channel).returns(); }
    [[nodiscard]] ReturnState returnState(int channel) const;
    /// Levers and switches (mayRestAtEnd()) have no spring: they are counted but not waited for.
    [[nodiscard]] bool areReturnsDone() const;

    [[nodiscard]] bool areExtremesDone() const;

    [[nodiscard]] bool isDirectionReady() const; ///< the sticks rest: push now
    [[nodiscard]] std::optional<DirectionResult> directionResult() const; ///< of the latest probe

    /// Null before beginVerify(), for channels not chosen and for those to be done again.
    [[nodiscard]] const ChannelVerifier* verified(int channel) const;
    [[nodiscard]] bool isVerified() const; ///< every verified channel is confirmed

    [[nodiscard]] LearnedChannel result(int channel) const;

private:
    [[nodiscard]] ChannelLearner& at(int channel);
    void noteDirection(const DirectionResult& result);

    InputKind m_input;
    std::uint8_t m_mask;
    Duration m_stillTime;
    Phase m_phase = Phase::Neutral;
    std::optional<Instant> m_latest;
    std::vector<ChannelLearner> m_channels; ///< all five, chosen or not
    std::optional<DirectionProbe> m_probe;
    std::array<std::optional<ChannelVerifier>, kChannelCount> m_verifiers;
};

} // namespace trex
