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
    m_phase = Phase::Neutral;
    m_probe.reset();
    m_verifiers = {};
    for (auto& channel : m_channels) {
        channel.beginNeutral();
    }
}

void CalibrationLearner::beginReturns()
{
    m_phase = Phase::Returns;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (isUsed(channel)) {
            at(channel).beginReturns();
        }
    }
}

void CalibrationLearner::beginExtremes()
{
    m_phase = Phase::Extremes;
    m_probe.reset();
    m_verifiers = {};
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (isUsed(channel)) {
            at(channel).beginExtremes();
        }
    }
}

void CalibrationLearner::beginDirection(int channel)
{
    m_phase = Phase::Direction;
    std::array<DirectionProbe::Channel, kChannelCount> known;
    for (int number = 1; number <= kChannelCount; ++number) {
        auto& learner = at(number);
        learner.beginWatching();
        if (isUsed(number)) {
            const auto travel = std::max(learner.lowTravel(), learner.highTravel());
            known.at(static_cast<std::size_t>(number - 1)) = {learner.neutral(), double(travel),
                                                              learner.sigma()};
        }
    }
    m_probe.emplace(channel, m_input, known);
}

void CalibrationLearner::beginVerify(const Curves& before, const Curves& now)
{
    m_phase = Phase::Verify;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        const auto i = static_cast<std::size_t>(channel - 1);
        at(channel).beginWatching();
        m_verifiers[i].reset();
        const auto learned = result(channel);
        if (isUsed(channel) && learned.verdict != Verdict::DoAgain) {
            const auto curve = now[i].value_or(ResponseCurve{learned.calibration, false, false});
            m_verifiers[i].emplace(curve, before[i], learned.sigma,
                                   learned.has(Finding::RestsAtEnd));
        }
    }
}

void CalibrationLearner::feed(const PollSample& sample)
{
    if (sample.poll != PollId::RawChannels || (m_latest && sample.time <= *m_latest)) {
        return; // the same read once more is no new sample
    }
    m_latest = sample.time;
    std::array<int, kChannelCount> raw{};
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        raw.at(i) = sample.raw[i];
        m_channels[i].feed(raw.at(i), sample.time);
        if (m_phase == Phase::Verify && m_verifiers.at(i) && m_channels[i].isValid()) {
            m_verifiers.at(i)->feed(raw.at(i), sample.time);
        }
    }
    if (m_phase == Phase::Direction && !m_probe->result()) {
        m_probe->feed(raw, sample.time);
        if (const auto& result = m_probe->result()) {
            noteDirection(*result);
        }
    }
}

void CalibrationLearner::noteDirection(const DirectionResult& result)
{
    at(result.askedChannel)
        .setDirection(result.isSwapped() ? 0 : result.sign,
                      result.isSwapped() ? result.movedChannel : 0);
}

ChannelLearner& CalibrationLearner::at(int channel)
{
    return m_channels.at(static_cast<std::size_t>(channel - 1));
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

ReturnState CalibrationLearner::returnState(int channel) const
{
    return this->channel(channel).returnState();
}

bool CalibrationLearner::areReturnsDone() const
{
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (isUsed(channel) && !mayRestAtEnd(channel) && returnsSeen(channel) < kReturnsNeeded) {
            return false;
        }
    }
    return m_mask != 0;
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

bool CalibrationLearner::isDirectionReady() const
{
    return m_probe && m_probe->isWatching();
}

std::optional<DirectionResult> CalibrationLearner::directionResult() const
{
    return m_probe ? m_probe->result() : std::nullopt;
}

const ChannelVerifier* CalibrationLearner::verified(int channel) const
{
    const auto& verifier = m_verifiers.at(static_cast<std::size_t>(channel - 1));
    return verifier ? &*verifier : nullptr;
}

bool CalibrationLearner::isVerified() const
{
    bool hasAny = false;
    for (const auto& verifier : m_verifiers) {
        if (verifier && !verifier->isConfirmed()) {
            return false;
        }
        hasAny = hasAny || verifier;
    }
    return hasAny;
}

LearnedChannel CalibrationLearner::result(int channel) const
{
    return this->channel(channel).result();
}

} // namespace trex
