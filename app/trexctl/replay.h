// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/result.h"
#include "protocol/sim/simoptions.h"

namespace trex {

/// Puts a recording's raw channels and currents into the scenario, so that the simulated controller
/// measures them again, and its parameters where none is given; time 0 is the first sample. Errors:
/// FileUnreadable, FileMalformed (also a recording with neither).
[[nodiscard]] Result<void> replayRecording(const QString& path, sim::SimOptions& options);

} // namespace trex
