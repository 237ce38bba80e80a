// SPDX-License-Identifier: GPL-3.0-or-later
// What a controller leaves the factory with, and what it takes.
#pragma once

#include "protocol/sim/eeprom.h"

namespace trex::sim {

/// What a number may be (the host's parameter table gives the ranges; all else is read afresh).
struct ParameterLimits {
    bool exists = false;
    int minimum = 0;
    int maximum = 127;
    int initial = 0;
};
[[nodiscard]] const ParameterLimits& parameterLimits(int number);
/// Also needs a baud index that exists for 0x7E (C-59).
[[nodiscard]] bool takesParameter(int number, int raw);
[[nodiscard]] CalibrationValues factoryCalibration(InputKind kind);

} // namespace trex::sim
