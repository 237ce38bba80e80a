// SPDX-License-Identifier: GPL-3.0-or-later
// What a recording knows of line and controller at one moment. Plain values.
#pragma once

#include "protocol/session/openoptions.h"
#include "protocol/session/transaction.h"

namespace trex {

struct RecordedState {
    LinkState link = LinkState::Disconnected;
    OpenOptions options;
    DeviceInfo device;
    LinkStats stats;
    std::array<MotorOrder, 3> orders{}; ///< by MotorId
};

} // namespace trex
