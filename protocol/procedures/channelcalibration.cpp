// SPDX-License-Identifier: GPL-3.0-or-later
// What is known, how it is written, and how it ends. The steps: channelcalibrationsteps.cpp; what
// is said: channelcalibrationtext.cpp.
#include "protocol/procedures/channelcalibration.h"

#include "protocol/errortext.h"

#include <QSignalBlocker>

#include <utility>

namespace trex {
namespace {

constexpr const ParameterRow& kReversed = parameterRow("reversed-channels");
constexpr const ParameterRow& kParabolic = parameterRow("parabolic-channels");

constexpr std::uint8_t bitOf(int channel)
{
    return static_cast<std::uint8_t>(1U << (channel - 1));
}

std::uint8_t withBit(std::uint8_t mask, int channel, bool isSet)
{
    return static_cast<std::uint8_t>(isSet ? mask | bitOf(channel) : mask & ~bitOf(channel));
}

} // namespace

ChannelCalibration::ChannelCalibration(Controller& controller, DeviceSettings& settings,
                                       QObject* parent)
    : Procedure(parent)
    , m_controller(controller)
    , m_settings(settings)
    , m_writer(controller, settings)
{
    connect(&m_watch, &InterruptionWatch::ticked, this, &ChannelCalibration::updated);
    connect(&m_watch, &InterruptionWatch::interrupted, this, &ChannelCalibration::interrupt);
    connect(&m_writer, &CalibrationWriter::changed, this, &ChannelCalibration::updated);
    connect(&m_writer, &CalibrationWriter::written, this, &ChannelCalibration::onWritten);
    connect(&m_writer, &CalibrationWriter::checked, this, &ChannelCalibration::onChecked);
    connect(&m_writer, &CalibrationWriter::undone, this, &ChannelCalibration::onUndone);
    connect(&m_writer, &CalibrationWriter::itemBegun, this, [this](int item) {
        emit progressed(item, CalibrationWriter::kDirections,
                        item == CalibrationWriter::kDirections
                            ? tr("Writing the directions")
                            : tr("Writing channel %1").arg(item));
    });
    connect(&controller, &Controller::stateChanged, this, &ChannelCalibration::onState);
    connect(&controller, &Controller::deviceChanged, this, &ChannelCalibration::onDevice);
    connect(&controller, &Controller::restarted, this, [this] {
        m_isMotorPowerOff = false;
        if (isRunning()) {
            stop({ErrorCode::LineLost, {}}, tr("The controller was switched off and on."));
        }
        checkWhenThere();
    });
    connect(&controller, &Controller::armedChanged, this, [this](bool armed) {
        if (armed && isRunning()) {
            interrupt(tr("The motors were armed, which ends a calibration."));
        }
    });
}

// ---- what is known

bool ChannelCalibration::isCollecting() const
{
    return m_step >= Step::Neutral && m_step <= Step::Verify;
}

bool ChannelCalibration::isStarved() const
{
    return isCollecting() && m_watch.isStarved();
}

bool ChannelCalibration::canWrite() const
{
    const auto& mode = m_controller.device().mode;
    return mode && isSerial(*mode);
}

bool ChannelCalibration::doSticksDrive() const
{
    const auto& mode = m_controller.device().mode;
    return mode && !isSerial(*mode);
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
    return m_learner ? m_writer.before(channel) : m_settings.calibration(input(), channel);
}

const LearnedChannel* ChannelCalibration::learned(int channel) const
{
    const auto& learned = m_learned.at(static_cast<std::size_t>(channel - 1));
    return learned ? &*learned : nullptr;
}

std::optional<Calibration> ChannelCalibration::planned(int channel) const
{
    const LearnedChannel* learned = this->learned(channel);
    if (learned == nullptr || learned->verdict == Verdict::DoAgain) {
        return std::nullopt;
    }
    return m_writer.isEightBit() ? nearestForEightBit(learned->calibration) : learned->calibration;
}

bool ChannelCalibration::isNearest(int channel) const
{
    const auto planned = this->planned(channel);
    return planned && *planned != learned(channel)->calibration;
}

std::optional<Calibration> ChannelCalibration::readBack(int channel) const
{
    return m_writer.readBack(channel);
}

std::optional<DirectionResult> ChannelCalibration::direction(int channel) const
{
    return m_directions.at(static_cast<std::size_t>(channel - 1));
}

bool ChannelCalibration::wasReversed(int channel) const
{
    return isIn(m_writer.reversedBefore().value_or(0), channel);
}

std::optional<ResponseCurve> ChannelCalibration::curveBefore(int channel) const
{
    const auto held = before(channel);
    if (m_learner && held) {
        return ResponseCurve{*held, wasReversed(channel), isIn(m_parabolic, channel)};
    }
    const auto reversed = m_settings.parameter(kReversed.number);
    const auto parabolic = m_settings.parameter(kParabolic.number);
    if (!held || !reversed || !parabolic) {
        return std::nullopt; // none is drawn that may be wrong
    }
    return ResponseCurve{*held, isIn(*reversed, channel), isIn(*parabolic, channel)};
}

std::optional<ResponseCurve> ChannelCalibration::curveAfter(int channel) const
{
    const auto held = m_writer.readBack(channel);
    const auto now = held ? held : planned(channel);
    return m_learner && now
        ? std::optional(ResponseCurve{*now, isReversed(channel), isIn(m_parabolic, channel)})
        : std::nullopt;
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

std::uint8_t ChannelCalibration::changedDirections() const
{
    const std::uint8_t before = m_writer.reversedBefore().value_or(m_reversed);
    return static_cast<std::uint8_t>((before ^ m_reversed) & m_channels);
}

// ---- what the person chooses

void ChannelCalibration::setChannels(std::uint8_t mask)
{
    if (m_step == Step::Choose && !m_isPreparing) {
        m_channels = m_chosenBefore = mask & kAllChannelsMask;
    } else if (m_step == Step::Review) {
        m_channels = mask & acceptable();
    }
    emit updated();
}

void ChannelCalibration::setMotorPowerOff(bool off)
{
    m_isMotorPowerOff = off;
    emit updated();
}

void ChannelCalibration::setReversed(int channel, bool reversed)
{
    const bool isOpen = m_step == Step::Direction || m_step == Step::Review;
    if (isOpen && hasDirection(channel)) {
        m_reversed = withBit(m_reversed, channel, reversed);
        emit updated();
    }
}

// ---- writing

void ChannelCalibration::write()
{
    CalibrationPlan plan;
    plan.input = input();
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (isChosen(channel)) {
            plan.calibrations.at(static_cast<std::size_t>(channel - 1)) = planned(channel);
        }
    }
    plan.reversedMask = changedDirections();
    plan.reversed = m_reversed;
    m_stopReason.clear();
    setStep(Step::Writing);
    m_writer.write(plan);
}

void ChannelCalibration::onWritten(const Result<void>& result)
{
    if (result) {
        m_outcome = m_writer.writtenText();
        end(Step::Done, {});
    } else if (result.error().code == ErrorCode::Cancelled && m_writer.isStopping()) {
        stop(result.error(), m_stopReason.isEmpty() ? tr("Cancelled on request.") : m_stopReason);
    } else if (result.error().code == ErrorCode::Cancelled) { // by closing the line
        stop({ErrorCode::LineLost, {}}, tr("The connection to the controller was lost."));
    } else {
        stop(result.error(), errorText(result.error()));
    }
}

bool ChannelCalibration::isReadingBack() const
{
    return !isRunning() && !m_isUndoing && m_writer.isBusy();
}

bool ChannelCalibration::canUndo() const
{
    const bool isOver = m_step == Step::Done || m_step == Step::Stopped;
    return isOver && m_writer.canUndo() && m_writer.canReach();
}

void ChannelCalibration::undo()
{
    if (canUndo()) {
        m_isUndoing = true;
        m_writer.undo();
        emit updated();
    }
}

void ChannelCalibration::onUndone(const Result<void>& result)
{
    m_isUndoing = false;
    m_stopReason = result ? QString() : errorText(result.error());
    m_outcome = result ? m_writer.undoneText() : m_stopReason + u' ' + m_writer.writtenText();
    emit updated();
    emit noted(m_outcome);
    checkWhenThere();
}

void ChannelCalibration::checkWhenThere()
{
    if (!isRunning() && m_writer.needsCheck() && m_writer.canReach()) {
        m_writer.check();
        emit updated();
    }
}

void ChannelCalibration::onChecked()
{
    if (m_writer.needsCheck()) {
        return; // lost again: once more when the controller is there
    }
    m_outcome =
        m_stopReason.isEmpty() ? m_writer.heldText() : m_stopReason + u' ' + m_writer.heldText();
    emit updated();
    emit noted(m_writer.heldText());
}

// ---- ends

void ChannelCalibration::cancel()
{
    if (m_step == Step::Writing) {
        m_writer.stopAfterPresent(); // a packet on its way cannot be called back
        emit updated();
        return;
    }
    if (!isRunning()) {
        return;
    }
    forget();
    m_outcome = tr("Cancelled: nothing was changed.");
    end(Step::Choose, fail(ErrorCode::Cancelled));
}

void ChannelCalibration::interrupt(const QString& sentence)
{
    if (m_step == Step::Writing) {
        m_stopReason = sentence;
        m_writer.stopAfterPresent();
        emit updated();
    } else if (isRunning()) {
        stop({ErrorCode::Cancelled, {}}, sentence);
    }
}

void ChannelCalibration::forget()
{
    ++m_run;
    m_isPreparing = false;
    m_learner.reset();
    m_learned = {};
    m_directions = {};
    {
        const QSignalBlocker quiet(m_writer); // nobody looks before all of it is put back
        m_writer.reset();
    }
    m_channels = m_chosenBefore;
    m_outcome.clear();
    m_stopReason.clear();
}

void ChannelCalibration::stop(const Error& error, const QString& sentence)
{
    ++m_run;
    m_isPreparing = false;
    m_writer.interrupt();
    m_stopReason = sentence;
    m_outcome = sentence + u' ' + m_writer.writtenText();
    end(Step::Stopped, tl::make_unexpected(error));
    checkWhenThere();
}

void ChannelCalibration::end(Step step, const Result<void>& result)
{
    setStep(step);
    finish(result);
    emit updated(); // it runs no more
}

void ChannelCalibration::onState(LinkState state)
{
    if (state != LinkState::Connected) {
        m_isMotorPowerOff = false;
    }
    if (isRunning() && state != LinkState::Connected) {
        const Error error = m_controller.lastError().value_or(Error{ErrorCode::LineLost, {}});
        stop({ErrorCode::LineLost, error.context},
             tr("The connection to the controller was lost."));
    } else if (m_isUndoing && state != LinkState::Connected) {
        m_isUndoing = false;
        m_writer.interrupt();
        m_stopReason =
            tr("The connection to the controller was lost while the former values were put back.");
        m_outcome = m_stopReason + u' ' + m_writer.writtenText();
        setStep(Step::Stopped);
    } else {
        emit updated();
        checkWhenThere();
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
        checkWhenThere();
    }
}

} // namespace trex
