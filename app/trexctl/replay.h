// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/result.h"
#include "protocol/sim/scenario.h"

namespace trex {

/// Puts a recording's raw channels and currents into a scenario, so that the simulated controller
/// measures them again; time 0 is the first sample. Errors: FileUnreadable, FileMalformed (also a
/// recording with neither).
[[nodiscard]] Result<void> replayRecording(const QString& path, sim::Scenario& scenario);

} // namespace trex
