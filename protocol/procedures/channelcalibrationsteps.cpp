// SPDX-License-Identifier: GPL-3.0-or-later
// The way through the steps, up to the review.
#include "protocol/errortext.h"
#include "protocol/procedures/channelcalibration.h"

namespace trex {
namespace {

constexpr const ParameterRow& kReversed = parameterRow("reversed-channels");
constexpr const ParameterRow& kParabolic = parameterRow("parabolic-channels");

} // namespace

void ChannelCalibration::setStep(Step step)
{
    m_step = step;
    isCollecting() ? m_watch.start() : m_watch.stop();
    emit stepChanged();
    emit updated();
}

// ---- choose → neutral

void ChannelCalibration::start()
{
    if (m_step != Step::Choose || m_isPreparing || !canContinue()) {
        return;
    }
    setRunning();
    m_chosenBefore = m_channels;
    forget();
    const int run = m_run;
    m_isPreparing = true;
    if (m_controller.isArmed()) {
        m_controller.disarm();
    }
    emit updated();
    m_controller.request(query("get-mode"), this, [this, run](const Result<Reply>& reply) {
        if (run != m_run) {
            return;
        }
        const auto mode = reply ? parseMode(reply->payload) : tl::make_unexpected(reply.error());
        if (!mode) {
            stop(mode.error(), errorText(mode.error()));
        } else if (!isSerial(*mode) && !m_isMotorPowerOff) {
            stop({ErrorCode::NotInSerialMode, {}}, sticksDriveText());
        } else {
            m_learner.emplace(inputOf(*mode), m_channels, m_stillTime);
            readNumber(kReversed, run, [this, run](int reversed) {
                m_reversed = static_cast<std::uint8_t>(reversed);
                m_writer.setReversedBefore(m_reversed);
                readNumber(kParabolic, run, [this, run](int parabolic) {
                    m_parabolic = static_cast<std::uint8_t>(parabolic);
                    readBefore(1, run);
                });
            });
        }
    });
}

void ChannelCalibration::readNumber(const ParameterRow& row, int run,
                                    const std::function<void(int)>& then)
{
    m_settings.readParameter(row, this, [this, run, then](const Result<int>& raw) {
        if (run != m_run) {
            return;
        }
        if (!raw) {
            stop(raw.error(), errorText(raw.error()));
            return;
        }
        then(*raw);
    });
}

void ChannelCalibration::readBefore(int channel, int run)
{
    if (channel > kChannelCount) {
        m_isPreparing = false;
        enter(Step::Neutral);
        return;
    }
    m_settings.readCalibration(channel, this,
                               [this, channel, run](const Result<Calibration>& before) {
                                   if (run != m_run) {
                                       return;
                                   }
                                   if (!before) {
                                       stop(before.error(), errorText(before.error()));
                                       return;
                                   }
                                   m_writer.setBefore(channel, *before);
                                   readBefore(channel + 1, run);
                               });
}

// ---- from step to step

ChannelCalibration::Step ChannelCalibration::following(Step step) const
{
    switch (step) {
    case Step::Neutral:
        return m_hasOptional ? Step::Returns : Step::Extremes;
    case Step::Returns:
        return Step::Extremes;
    case Step::Extremes:
        return m_hasOptional ? Step::Direction : Step::Review;
    case Step::Direction:
        return Step::Verify;
    default:
        return Step::Review;
    }
}

/// What a step begins with.
void ChannelCalibration::enter(Step step)
{
    switch (step) {
    case Step::Neutral:
        m_learner->beginNeutral();
        break;
    case Step::Returns:
        m_learner->beginReturns();
        break;
    case Step::Extremes:
        m_channels = m_learner->mask();
        m_learned = {};
        m_directions = {};
        m_reversed = m_writer.reversedBefore().value_or(0);
        m_learner->beginExtremes(); // from the same neutral
        break;
    case Step::Direction:
        m_channels = m_learner->mask();
        learn();
        beginDirections();
        break;
    case Step::Verify:
        m_channels = m_learner->mask();
        learn();
        beginVerify();
        break;
    case Step::Review:
        learn();
        m_channels = m_channels & acceptable();
        break;
    default:
        break;
    }
    setStep(step);
}

void ChannelCalibration::next()
{
    if (!canContinue()) {
        return;
    }
    switch (m_step) {
    case Step::Choose:
        start();
        break;
    case Step::Review:
        write();
        break;
    case Step::Writing:
        break;
    case Step::Done:
    case Step::Stopped:
        forget();
        setStep(Step::Choose);
        break;
    default:
        enter(following(m_step));
        break;
    }
}

void ChannelCalibration::back()
{
    switch (m_step) {
    case Step::Neutral:
        cancel();
        break;
    case Step::Returns:
    case Step::Extremes:
        enter(Step::Neutral);
        break;
    case Step::Direction:
        enter(Step::Extremes);
        break;
    case Step::Verify:
        enter(Step::Direction);
        break;
    case Step::Review:
        enter(m_hasOptional ? Step::Verify : Step::Extremes);
        break;
    default:
        break;
    }
}

void ChannelCalibration::finishExtremes()
{
    if (m_step == Step::Extremes) {
        enter(Step::Review);
    }
}

void ChannelCalibration::feed(const PollSample& sample)
{
    if (!isCollecting() || sample.poll != PollId::RawChannels) {
        return;
    }
    m_watch.sampleCame(sample.time);
    if (!isCollecting()) {
        return; // that sample showed an interruption
    }
    m_learner->feed(sample);
    if (m_step == Step::Direction) {
        followDirection();
    }
    emit updated();
}

void ChannelCalibration::learn()
{
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        m_learned.at(static_cast<std::size_t>(channel - 1)) =
            m_learner->isUsed(channel) ? std::optional(m_learner->result(channel)) : std::nullopt;
    }
}

// ---- direction and verify

void ChannelCalibration::beginDirections()
{
    m_directionChannel = 0;
    for (int channel = kChannelCount; channel >= 1; --channel) {
        if (hasDirection(channel) && isIn(acceptable(), channel) && !direction(channel)) {
            m_directionChannel = channel;
        }
    }
    if (m_directionChannel != 0) {
        m_learner->beginDirection(m_directionChannel);
    }
}

void ChannelCalibration::selectDirection(int channel)
{
    if (m_step == Step::Direction && hasDirection(channel) && isIn(acceptable(), channel)) {
        m_directions.at(static_cast<std::size_t>(channel - 1)).reset();
        m_directionChannel = channel;
        m_learner->beginDirection(channel);
        emit updated();
    }
}

void ChannelCalibration::followDirection()
{
    const auto result = m_learner->directionResult();
    if (m_directionChannel == 0 || !result) {
        return;
    }
    const int channel = m_directionChannel;
    m_directions.at(static_cast<std::size_t>(channel - 1)) = result;
    if (result->movedChannel == channel) {
        setReversed(channel, result->isReversed()); // offered; the person may differ
    }
    beginDirections();
}

void ChannelCalibration::beginVerify()
{
    CalibrationLearner::Curves before;
    CalibrationLearner::Curves after;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        before.at(static_cast<std::size_t>(channel - 1)) = curveBefore(channel);
        after.at(static_cast<std::size_t>(channel - 1)) = curveAfter(channel);
    }
    m_learner->beginVerify(before, after);
}

bool ChannelCalibration::isOptional() const
{
    return m_step == Step::Returns || m_step == Step::Direction || m_step == Step::Verify;
}

std::vector<ChannelCalibration::Step> ChannelCalibration::skipped() const
{
    std::vector<Step> steps;
    if (!m_learner || !m_hasOptional) {
        return steps;
    }
    if (!m_learner->areReturnsDone()) {
        steps.push_back(Step::Returns);
    }
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (hasDirection(channel) && isIn(acceptable(), channel) && !direction(channel)) {
            steps.push_back(Step::Direction);
            break;
        }
    }
    if (!m_learner->isVerified()) {
        steps.push_back(Step::Verify);
    }
    return steps;
}

bool ChannelCalibration::isStepDone() const
{
    switch (m_step) {
    case Step::Returns:
        return m_learner->areReturnsDone();
    case Step::Direction:
        return m_directionChannel == 0;
    case Step::Verify:
        return m_learner->isVerified();
    default:
        return canContinue();
    }
}

} // namespace trex
