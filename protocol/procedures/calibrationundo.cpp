// SPDX-License-Identifier: GPL-3.0-or-later
// CalibrationWriter's way back: what an interruption left, and the former values put back.
#include "protocol/procedures/calibrationwriter.h"

namespace trex {
namespace {

constexpr const ParameterRow& kReversed = parameterRow("reversed-channels");

} // namespace

// ---- reading back after an interruption

bool CalibrationWriter::wasTouched(int item) const
{
    switch (at(item).state) {
    case State::Untouched:
    case State::Unchanged:
    case State::Writing:
    case State::Refused:
        return false;
    default:
        return true;
    }
}

bool CalibrationWriter::needsCheck() const
{
    return m_isInterrupted && !isBusy();
}

bool CalibrationWriter::canReach() const
{
    const auto& mode = m_controller.device().mode;
    return m_controller.state() == LinkState::Connected && mode && isSerial(*mode)
        && inputOf(*mode) == m_plan.input && m_controller.options().port == m_port
        && m_controller.options().line.device == m_device;
}

void CalibrationWriter::check()
{
    if (!isBusy() && canReach()) {
        begin(Task::Check);
        checkItem(1);
    }
}

CalibrationWriter::State CalibrationWriter::seen(const Calibration& now, const Item& item,
                                                 const std::optional<Calibration>& wanted,
                                                 bool isEightBit)
{
    const bool isNew = now == wanted || now == item.readBack
        || (isEightBit && wanted && now == nearestForEightBit(*wanted));
    if (isNew && now != item.before) {
        return State::HoldsNew;
    }
    return now == item.before ? State::HoldsOld : State::HoldsOther;
}

void CalibrationWriter::checkItem(int item)
{
    while (item <= kDirections && !wasTouched(item)) {
        ++item;
    }
    const int run = m_run;
    if (item > kDirections) {
        end({});
    } else if (item == kDirections) {
        m_settings.readParameter(kReversed, this, [this, run](const Result<int>& now) {
            if (run != m_run) {
                return;
            }
            if (!now) {
                end(tl::make_unexpected(now.error()));
                return;
            }
            const auto mask = m_plan.reversedMask;
            const bool isNew = ((*now ^ m_plan.reversed) & mask) == 0;
            const bool isOld = m_reversedBefore && ((*now ^ *m_reversedBefore) & mask) == 0;
            put(kDirections, isNew ? State::HoldsNew : isOld ? State::HoldsOld : State::HoldsOther);
            end({});
        });
    } else {
        m_settings.readCalibration(item, this, [this, item, run](const Result<Calibration>& now) {
            if (run != m_run) {
                return;
            }
            if (!now) {
                end(tl::make_unexpected(now.error()));
                return;
            }
            const auto& wanted = m_plan.calibrations.at(static_cast<std::size_t>(item - 1));
            put(item, seen(*now, at(item), wanted, m_isEightBit), *now);
            checkItem(item + 1);
        });
    }
}

// ---- undo

bool CalibrationWriter::canUndo() const
{
    const auto isToUndo = [this](int item) {
        const State state = at(item).state;
        const bool isBack =
            state == State::Restored || state == State::NearestRestored || state == State::HoldsOld;
        const bool isKnown =
            item == kDirections ? m_reversedBefore.has_value() : at(item).before.has_value();
        return wasTouched(item) && !isBack && isKnown;
    };
    for (int item = 1; item <= kDirections; ++item) {
        if (isToUndo(item)) {
            return !isBusy();
        }
    }
    return false;
}

void CalibrationWriter::undo()
{
    if (canUndo() && canReach()) {
        begin(Task::Undo);
        undoItem(1);
    }
}

void CalibrationWriter::undoItem(int item)
{
    while (item < kDirections && (!wasTouched(item) || !at(item).before)) {
        ++item;
    }
    if (item == kDirections) {
        undoDirections();
        return;
    }
    put(item, State::Writing);
    m_settings.writeCalibration(
        item, *at(item).before, this,
        [this, item, run = m_run](const Result<DeviceSettings::CalibrationWrite>& result) {
            if (run != m_run) {
                return;
            }
            if (!result) {
                failed(item, result.error());
                return;
            }
            put(item, result->verified ? State::Restored : State::NearestRestored,
                result->readBack);
            undoItem(item + 1);
        });
}

void CalibrationWriter::undoDirections()
{
    if (!wasTouched(kDirections) || !m_reversedBefore) {
        end({});
        return;
    }
    put(kDirections, State::Writing);
    const int run = m_run;
    m_settings.readParameter(kReversed, this, [this, run](const Result<int>& now) {
        if (run != m_run) {
            return;
        }
        if (!now) {
            failed(kDirections, now.error());
            return;
        }
        m_settings.writeParameter(
            kReversed, merged(*now, m_plan.reversedMask, *m_reversedBefore), true, this,
            [this, run](const Result<DeviceSettings::ParameterWrite>& result) {
                if (run != m_run) {
                    return;
                }
                if (!result) {
                    failed(kDirections, result.error());
                    return;
                }
                put(kDirections, State::Restored);
                end({});
            });
    });
}

} // namespace trex
