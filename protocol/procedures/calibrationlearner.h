// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/polltable.h"
#include "protocol/procedures/channellearner.h"

#include <vector>

namespace trex {

/// Learns the chosen channels side by side. Pure: no clock, no I/O; time comes with the samples.
class CalibrationLearner {
public:
    static constexpr Duration kDefaultStillTime = std::chrono::seconds(2);

    /// `mask`: bit n is channel n + 1.
    CalibrationLearner(InputKind input, std::uint8_t mask, Duration stillTime = kDefaultStillTime);

    void beginNeutral();
    void beginExtremes(); ///< only when isNeutralDone()
    /// A fresh sample of the raw channels poll; others, and repeats of the same read, are ignored.
    void feed(const PollSample& sample);

    [[nodiscard]] bool isUsed(int channel) const { return (m_mask >> (channel - 1) & 1) != 0; }
    [[nodiscard]] std::uint8_t mask() const { return m_mask; }
    [[nodiscard]] InputKind input() const { return m_input; }
    [[nodiscard]] const ChannelLearner& channel(int channel) const;
    [[nodiscard]] bool isNeutralDone() const; ///< every chosen channel is still at the same time
    /// Until then when nothing moves; the longest of all channels.
    [[nodiscard]] Duration neutralRemaining() const;
    [[nodiscard]] Duration stillTime() const { return m_stillTime; }
    [[nodiscard]] bool areExtremesDone() const;
    [[nodiscard]] LearnedChannel result(int channel) const
    {
        return this->channel(channel).result();
    }

private:
    InputKind m_input;
    std::uint8_t m_mask;
    Duration m_stillTime;
    std::vector<ChannelLearner> m_channels; ///< all five, chosen or not
};

} // namespace trex
