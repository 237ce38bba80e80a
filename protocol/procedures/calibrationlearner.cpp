// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/calibrationlearner.h"

namespace trex {

CalibrationLearner::CalibrationLearner(InputKind input, std::uint8_t mask, Duration stillTime)
    : m_input(input), m_mask(mask & kAllChannelsMask), m_stillTime(stillTime)
{
    m_channels.reserve(kChannelCount);
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        m_channels.emplace_back(channel, input, stillTime);
    }
}

void CalibrationLearner::beginNeutral()
{
    for (auto& channel : m_channels) {
        channel.beginNeutral();
    }
}

void CalibrationLearner::beginExtremes()
{
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (isUsed(channel)) {
            m_channels[static_cast<std::size_t>(channel - 1)].beginExtremes();
        }
    }
}

void CalibrationLearner::feed(const PollSample& sample)
{
    if (sample.poll != PollId::RawChannels) {
        return;
    }
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        m_channels[i].feed(sample.raw[i], sample.time);
    }
}

const ChannelLearner& CalibrationLearner::channel(int channel) const
{
    return m_channels.at(static_cast<std::size_t>(channel - 1));
}

bool CalibrationLearner::isNeutralDone() const
{
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (isUsed(channel) && !this->channel(channel).hasStillWindow()) {
            return false;
        }
    }
    return m_mask != 0;
}

Duration CalibrationLearner::neutralRemaining() const
{
    Duration longest = Duration::zero();
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (isUsed(channel)) {
            longest = std::max(longest, m_stillTime - this->channel(channel).stillFor());
        }
    }
    return longest;
}

bool CalibrationLearner::areExtremesDone() const
{
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (isUsed(channel) && !this->channel(channel).areEndsSettled()) {
            return false;
        }
    }
    return m_mask != 0;
}

} // namespace trex
