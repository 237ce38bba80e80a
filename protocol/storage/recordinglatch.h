// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingblock.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"

namespace trex {

/// The latched bits of a recording as they had been counted at any moment of it, without counting
/// again: for each bit, the moments at which it was seen. Main thread.
class RecordingLatch {
public:
    /// Takes in what is new in the store.
    void follow(const TelemetryStore& store);
    /// What StatusLatch would have known at `playhead`; `wallClock` is that moment's.
    [[nodiscard]] StatusLatch::Shown shownAt(const TelemetryStore& store, Tick playhead,
                                             const QDateTime& wallClock) const;

private:
    std::array<std::array<std::vector<Tick>, 8>, 2> m_seen; ///< by byte and bit, ascending
    std::array<std::size_t, 2> m_next{}; ///< samples looked at
};

} // namespace trex
