// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingblock.h"
#include "protocol/telemetry/telemetrystore.h"

namespace trex {

/// Takes out of a store what came since the last time, source by source. Main thread, like the
/// store.
class SampleTap {
public:
    using Wanted = std::array<bool, kSourceCount>; ///< by Source

    explicit SampleTap(const TelemetryStore& store);

    void startNow(); ///< what is there already is left out
    void startAt(Instant from);
    /// Appends the new samples of the wanted sources, at most `most` of each; ticks are counted
    /// from `origin`. Gives how many.
    std::size_t take(const Wanted& wanted, Tick origin, std::size_t most,
                     std::array<SampleRun, kSourceCount>& runs);

private:
    const TelemetryStore& m_store;
    std::array<std::size_t, kSourceCount> m_next{}; ///< first sample not yet taken
    int m_clears; ///< of the store, when m_next was right
};

} // namespace trex
