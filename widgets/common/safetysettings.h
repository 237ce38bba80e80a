// SPDX-License-Identifier: GPL-3.0-or-later
// What a person chose about the motor gate and the motion limits, between the settings file and the
// façade.
#pragma once

#include "protocol/session/motionshaper.h"
#include "protocol/session/motorgate.h"

namespace trex {

class UiSettings;

[[nodiscard]] DisarmRules disarmRules(const UiSettings& settings);
[[nodiscard]] MotionLimits motionLimits(const UiSettings& settings);
void store(UiSettings& settings, const DisarmRules& rules);
void store(UiSettings& settings, const MotionLimits& limits);

} // namespace trex
