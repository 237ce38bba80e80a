// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/calibrationwriter.h"

#include <algorithm>
#include <utility>

namespace trex {
namespace {

constexpr const ParameterRow& kReversed = parameterRow("reversed-channels");
constexpr int kLargestLowByte = 0x7F;

/// A value whose low byte a seven-bit data byte can carry, next to `wanted`.
int nearestSendable(int wanted)
{
    const int low = wanted & 0xFF;
    const int high = wanted & ~0xFF;
    if (low <= kLargestLowByte) {
        return wanted;
    }
    return low >= (kLargestLowByte + 0x100 + 1) / 2 ? high + 0x100 : high + kLargestLowByte;
}

bool isRefusal(ErrorCode code)
{
    return code == ErrorCode::BadValue || code == ErrorCode::NotInSerialMode
        || code == ErrorCode::OutOfRange || code == ErrorCode::BadParameterNumber;
}

} // namespace

Calibration nearestForEightBit(const Calibration& wanted)
{
    Calibration nearest{nearestSendable(wanted.minimum), nearestSendable(wanted.neutral),
                        nearestSendable(wanted.maximum), 0};
    // What rests at the true neutral must still read as neutral: no motor may creep.
    const int off = std::abs(nearest.neutral - wanted.neutral);
    const int deadband = wanted.deadband + off;
    nearest.deadband = nearestSendable(deadband);
    if (nearest.deadband < deadband) {
        nearest.deadband = (deadband | 0xFF) + 1;
    }
    return nearest;
}

std::uint8_t CalibrationWriter::merged(int now, std::uint8_t mask, std::uint8_t bits)
{
    return static_cast<std::uint8_t>((now & ~mask) | (bits & mask));
}

CalibrationWriter::CalibrationWriter(Controller& controller, DeviceSettings& settings,
                                     QObject* parent)
    : QObject(parent), m_controller(controller), m_settings(settings)
{
    connect(&controller, &Controller::stateChanged, this, [this](LinkState state) {
        if (state == LinkState::Disconnected || state == LinkState::Connecting) {
            m_isEightBit = false; // perhaps another controller
        }
    });
}

void CalibrationWriter::reset()
{
    ++m_run;
    m_task = Task::None;
    m_plan = {};
    m_items = {};
    m_reversedBefore.reset();
    m_isStopAsked = false;
    m_isInterrupted = false;
    emit changed();
}

void CalibrationWriter::setBefore(int channel, const Calibration& calibration)
{
    at(channel).before = calibration;
}

void CalibrationWriter::setReversedBefore(std::uint8_t reversed)
{
    m_reversedBefore = reversed;
}

void CalibrationWriter::begin(Task task)
{
    m_task = task;
    ++m_run;
    m_isStopAsked = false;
}

void CalibrationWriter::end(const Result<void>& result)
{
    const Task task = std::exchange(m_task, Task::None);
    ++m_run;
    emit changed();
    switch (task) {
    case Task::None:
        break;
    case Task::Write:
        emit written(result);
        break;
    case Task::Check:
        m_isInterrupted = m_isInterrupted && !result;
        emit checked();
        break;
    case Task::Undo:
        emit undone(result);
        break;
    }
}

void CalibrationWriter::put(int item, State state, const std::optional<Calibration>& readBack)
{
    at(item).state = state;
    at(item).readBack = readBack;
    emit changed();
}

void CalibrationWriter::failed(int item, const Error& error)
{
    const bool isRefused = isRefusal(error.code);
    m_isInterrupted = m_isInterrupted || !isRefused;
    put(item, isRefused && m_task == Task::Write ? State::Refused : State::Failed);
    end(tl::make_unexpected(error));
}

// ---- writing

void CalibrationWriter::write(const CalibrationPlan& plan)
{
    m_plan = plan;
    m_port = m_controller.options().port;
    m_device = m_controller.options().line.device;
    m_isInterrupted = false;
    begin(Task::Write);
    writeItem(1);
}

void CalibrationWriter::writeItem(int item)
{
    const auto isPlanned = [this](int number) {
        return number == kDirections
            ? m_plan.reversedMask != 0
            : m_plan.calibrations.at(static_cast<std::size_t>(number - 1)).has_value();
    };
    while (item <= kDirections && !isPlanned(item)) {
        ++item;
    }
    if (item > kDirections) {
        end({});
        return;
    }
    if (m_isStopAsked) {
        end(fail(ErrorCode::Cancelled));
        return;
    }
    put(item, State::Writing);
    emit itemBegun(item);
    item == kDirections ? writeDirections() : writeChannel(item);
}

void CalibrationWriter::writeChannel(int channel)
{
    const Calibration wanted = *m_plan.calibrations.at(static_cast<std::size_t>(channel - 1));
    if (at(channel).before == wanted) {
        put(channel, State::Unchanged, wanted); // EEPROM lives about 100,000 writes
        writeItem(channel + 1);
        return;
    }
    m_settings.writeCalibration(
        channel, wanted, this,
        [this, channel, wanted,
         run = m_run](const Result<DeviceSettings::CalibrationWrite>& result) {
            if (run != m_run) {
                return;
            }
            if (!result) {
                failed(channel, result.error());
                return;
            }
            m_isEightBit = m_isEightBit || result->eightBitBytes;
            const int off = std::abs(result->readBack.neutral - wanted.neutral);
            if (!result->verified && result->readBack.deadband < wanted.deadband + off) {
                writeWidened(channel, wanted);
                return;
            }
            put(channel, result->verified ? State::Written : State::NearestWritten,
                result->readBack);
            writeItem(channel + 1);
        });
}

void CalibrationWriter::writeWidened(int channel, const Calibration& wanted)
{
    const Calibration nearest = nearestForEightBit(wanted);
    m_settings.writeCalibration(
        channel, nearest, this,
        [this, channel, run = m_run](const Result<DeviceSettings::CalibrationWrite>& result) {
            if (run != m_run) {
                return;
            }
            if (!result) {
                failed(channel, result.error());
                return;
            }
            put(channel, State::NearestWritten, result->readBack);
            writeItem(channel + 1);
        });
}

void CalibrationWriter::writeDirections()
{
    const int run = m_run;
    m_settings.readParameter(kReversed, this, [this, run](const Result<int>& now) {
        if (run != m_run) {
            return;
        }
        if (!now) {
            failed(kDirections, now.error());
            return;
        }
        m_reversedBefore = static_cast<std::uint8_t>(*now);
        const int wanted = merged(*now, m_plan.reversedMask, m_plan.reversed);
        if (wanted == *now) {
            put(kDirections, State::Unchanged);
            writeItem(kDirections + 1);
            return;
        }
        m_settings.writeParameter(
            kReversed, wanted, true, this,
            [this, run](const Result<DeviceSettings::ParameterWrite>& result) {
                if (run != m_run) {
                    return;
                }
                if (!result) {
                    failed(kDirections, result.error());
                    return;
                }
                put(kDirections, State::Written);
                writeItem(kDirections + 1);
            });
    });
}

void CalibrationWriter::stopAfterPresent()
{
    m_isStopAsked = isBusy();
}

void CalibrationWriter::interrupt()
{
    if (!isBusy()) {
        return;
    }
    ++m_run;
    m_task = Task::None;
    for (Item& item : m_items) {
        if (item.state == State::Writing) {
            item.state = State::Failed;
        }
    }
    m_isInterrupted = true;
    emit changed();
}

// ---- getters

CalibrationWriter::State CalibrationWriter::state(int item) const
{
    return at(item).state;
}

std::uint8_t CalibrationWriter::channelsIn(State state) const
{
    std::uint8_t mask = 0;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if (at(channel).state == state) {
            mask = static_cast<std::uint8_t>(mask | 1U << (channel - 1));
        }
    }
    return mask;
}

std::optional<Calibration> CalibrationWriter::before(int channel) const
{
    return at(channel).before;
}

std::optional<Calibration> CalibrationWriter::readBack(int channel) const
{
    return at(channel).readBack;
}

} // namespace trex
