// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordinghistory.h"
#include "protocol/telemetry/marktrack.h"

namespace trex {

/// What happened during a recording as marks on its own clock (tick 0 is Instant()), as MarkKeeper
/// would have put them down: from its events, and from the latched bits in the store, which is
/// loaded to the end.
void fillMarks(MarkTrack& track, const RecordingHistory& history, const TelemetryStore& store);

} // namespace trex
