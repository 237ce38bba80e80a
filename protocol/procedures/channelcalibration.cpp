// SPDX-License-Identifier: GPL-3.0-or-later
// The steps. What is said about them: channelcalibrationtext.cpp.
#include "protocol/procedures/channelcalibration.h"

#include "protocol/errortext.h"

#include <utility>

using namespace std::chrono_literals;

namespace trex {
namespace {

constexpr auto kWatchInterval = 250ms;
constexpr qint64 kStarvedMs = 1000;

constexpr std::uint8_t bitOf(int channel)
{
    return static_cast<std::uint8_t>(1U << (channel - 1));
}

} // namespace

ChannelCalibration::ChannelCalibration(Controller& controller, DeviceSettings& settings,
                                       QObject* parent)
    : Procedure(parent), m_controller(controller), m_settings(settings), m_watch(this)
{
    m_watch.setInterval(kWatchInterval);
    connect(&m_watch, &QTimer::timeout, this, &ChannelCalibration::updated);
    connect(&controller, &Controller::stateChanged, this, &ChannelCalibration::onState);
    connect(&controller, &Controller::deviceChanged, this, &ChannelCalibration::onDevice);
    connect(&controller, &Controller::restarted, this, [this] {
        if (isRunning()) {
            const Error error{ErrorCode::LineLost, {}};
            stop(error, tr("The controller was switched off and on."));
        }
    });
    connect(&controller, &Controller::armedChanged, this, [this](bool armed) {
        if (armed && m_step == Step::Writing) {
            m_isCancelAsked = true;
        } else if (armed && isRunning()) {
            stop({ErrorCode::Cancelled, {}},
                 tr("The motors were armed, which ends a calibration."));
        }
    });
}

bool ChannelCalibration::isCollecting() const
{
    return m_step == Step::Neutral || m_step == Step::Extremes;
}

bool ChannelCalibration::isStarved() const
{
    return isCollecting() && m_sinceSample.isValid() && m_sinceSample.hasExpired(kStarvedMs);
}

bool ChannelCalibration::canWrite() const
{
    const auto& mode = m_controller.device().mode;
    return mode && isSerial(*mode);
}

InputKind ChannelCalibration::input() const
{
    if (m_learner) {
        return m_learner->input();
    }
    const auto& mode = m_controller.device().mode;
    return mode ? inputOf(*mode) : InputKind::Rc;
}

const CalibrationLearner* ChannelCalibration::learner() const
{
    return m_learner ? &*m_learner : nullptr;
}

std::optional<Calibration> ChannelCalibration::before(int channel) const
{
    return m_learner ? at(channel).before : m_settings.calibration(input(), channel);
}

const LearnedChannel* ChannelCalibration::learned(int channel) const
{
    const auto& learned = at(channel).learned;
    return learned ? &*learned : nullptr;
}

ChannelCalibration::WriteState ChannelCalibration::writeState(int channel) const
{
    return at(channel).state;
}

std::optional<Calibration> ChannelCalibration::readBack(int channel) const
{
    return at(channel).readBack;
}

std::uint8_t ChannelCalibration::acceptable() const
{
    std::uint8_t mask = 0;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        const auto* learned = this->learned(channel);
        if (learned != nullptr && learned->verdict != Verdict::DoAgain) {
            mask |= bitOf(channel);
        }
    }
    return mask;
}

void ChannelCalibration::setChannels(std::uint8_t mask)
{
    if (m_step == Step::Choose && !m_isPreparing) {
        m_channels = m_chosenBefore = mask & kAllChannelsMask;
    } else if (m_step == Step::Review) {
        m_channels = mask & acceptable();
    }
    emit updated();
}

void ChannelCalibration::setStep(Step step)
{
    m_step = step;
    if (isCollecting()) {
        m_sinceSample.start();
        m_watch.start();
    } else {
        m_watch.stop();
    }
    emit stepChanged();
    emit updated();
}

// ---- choose → neutral → extremes → review

void ChannelCalibration::start()
{
    if (m_step != Step::Choose || m_isPreparing || !canContinue()) {
        return;
    }
    setRunning();
    const int run = ++m_run;
    m_isPreparing = true;
    m_isCancelAsked = false;
    m_outcome.clear();
    m_data = {};
    m_chosenBefore = m_channels;
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
            return;
        }
        m_learner.emplace(inputOf(*mode), m_channels, m_stillTime);
        readBefore(1, run);
    });
}

void ChannelCalibration::readBefore(int channel, int run)
{
    if (channel > kChannelCount) {
        m_isPreparing = false;
        beginNeutral();
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
                                   at(channel).before = *before;
                                   readBefore(channel + 1, run);
                               });
}

void ChannelCalibration::beginNeutral()
{
    m_learner->beginNeutral();
    setStep(Step::Neutral);
}

void ChannelCalibration::feed(const PollSample& sample)
{
    if (!isCollecting() || sample.poll != PollId::RawChannels) {
        return;
    }
    m_sinceSample.start();
    m_learner->feed(sample);
    emit updated();
}

void ChannelCalibration::review()
{
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        at(channel).learned =
            isChosen(channel) ? std::optional(m_learner->result(channel)) : std::nullopt;
    }
    m_channels = m_channels & acceptable();
    setStep(Step::Review);
}

void ChannelCalibration::finishExtremes()
{
    if (m_step == Step::Extremes) {
        review();
    }
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
    case Step::Neutral:
        m_learner->beginExtremes();
        setStep(Step::Extremes);
        break;
    case Step::Extremes:
        review();
        break;
    case Step::Review:
        write();
        break;
    case Step::Writing:
        break;
    case Step::Done:
    case Step::Stopped:
        m_learner.reset();
        m_data = {};
        m_channels = m_chosenBefore;
        m_outcome.clear();
        setStep(Step::Choose);
        break;
    }
}

void ChannelCalibration::back()
{
    switch (m_step) {
    case Step::Neutral:
        cancel();
        break;
    case Step::Extremes:
        beginNeutral();
        break;
    case Step::Review:
        m_channels = m_learner->mask();
        for (Channel& channel : m_data) {
            channel.learned.reset();
        }
        m_learner->beginExtremes(); // from the same neutral
        setStep(Step::Extremes);
        break;
    default:
        break;
    }
}

// ---- writing

void ChannelCalibration::write()
{
    m_isCancelAsked = false;
    setStep(Step::Writing);
    writeNext(1, m_run);
}

void ChannelCalibration::writeNext(int channel, int run)
{
    while (channel <= kChannelCount && !isChosen(channel)) {
        ++channel;
    }
    if (channel > kChannelCount) {
        m_outcome = writtenText({});
        end(Step::Done, {});
        return;
    }
    if (m_isCancelAsked) {
        stop({ErrorCode::Cancelled, {}}, tr("Cancelled on request."));
        return;
    }
    if (at(channel).before == at(channel).learned->calibration) {
        at(channel).state = WriteState::Unchanged;
        at(channel).readBack = at(channel).before;
        writeNext(channel + 1, run);
        return;
    }
    at(channel).state = WriteState::Writing;
    emit progressed(channel, kChannelCount, tr("Writing channel %1").arg(channel));
    emit updated();
    m_settings.writeCalibration(
        channel, at(channel).learned->calibration, this,
        [this, channel, run](const Result<DeviceSettings::CalibrationWrite>& result) {
            onWritten(channel, run, result);
        });
}

void ChannelCalibration::onWritten(int channel, int run,
                                   const Result<DeviceSettings::CalibrationWrite>& result)
{
    if (run != m_run || m_step != Step::Writing) {
        return;
    }
    if (!result) {
        at(channel).state = WriteState::Failed;
        stop(result.error(), errorText(result.error()));
        return;
    }
    at(channel).readBack = result->readBack;
    at(channel).state = result->verified ? WriteState::Written : WriteState::NearestWritten;
    emit updated();
    writeNext(channel + 1, run);
}

// ---- ends

void ChannelCalibration::cancel()
{
    if (m_step == Step::Writing) {
        m_isCancelAsked = true; // a packet on its way cannot be called back
        emit updated();
        return;
    }
    if (!isRunning()) {
        return;
    }
    ++m_run;
    m_isPreparing = false;
    m_learner.reset();
    m_data = {};
    m_channels = m_chosenBefore;
    m_outcome = tr("Cancelled: nothing was changed.");
    end(Step::Choose, fail(ErrorCode::Cancelled));
}

void ChannelCalibration::stop(const Error& error, const QString& sentence)
{
    ++m_run;
    m_isPreparing = false;
    for (Channel& channel : m_data) {
        if (channel.state == WriteState::Writing) {
            channel.state = WriteState::Failed;
        }
    }
    m_outcome = sentence + u' ' + writtenText(error);
    end(Step::Stopped, tl::make_unexpected(error));
}

void ChannelCalibration::end(Step step, const Result<void>& result)
{
    setStep(step);
    finish(result);
    emit updated(); // it runs no more
}

void ChannelCalibration::onState(LinkState state)
{
    if (isRunning() && state != LinkState::Connected) {
        const Error error = m_controller.lastError().value_or(Error{ErrorCode::LineLost, {}});
        stop({ErrorCode::LineLost, error.context},
             tr("The connection to the controller was lost."));
    } else {
        emit updated();
    }
}

void ChannelCalibration::onDevice()
{
    const auto& mode = m_controller.device().mode;
    if (isRunning() && m_learner && mode && inputOf(*mode) != m_learner->input()) {
        stop({ErrorCode::Cancelled, {}},
             tr("The controller changed between RC and analog inputs, whose calibrations differ."));
    } else {
        emit updated();
    }
}

} // namespace trex
