// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingblock.h"
#include "protocol/telemetry/telemetrystore.h"

namespace trex {

/// Takes out of a store what came since the last time, source by source. Between start and stop
/// what is not taken yet stays in the store. Main thread, like the store.
class SampleTap : public SampleHolder {
public:
    using Wanted = std::array<bool, kSourceCount>; ///< by Source

    explicit SampleTap(const TelemetryStore& store);
    ~SampleTap() override;
    Q_DISABLE_COPY_MOVE(SampleTap)

    void startNow(); ///< what is there already is left out
    void startAt(Instant from);
    void stop(); ///< nothing more is needed
    /// Appends the new samples of the wanted sources, at most `most` of each; ticks are counted
    /// from `origin`. Gives how many.
    std::size_t take(const Wanted& wanted, Tick origin, std::size_t most,
                     std::array<SampleRun, kSourceCount>& runs);
    [[nodiscard]] std::size_t firstNeeded(Source source) const override;

private:
    const TelemetryStore& m_store;
    Wanted m_wanted{}; ///< by the latest take()
    bool m_isHolding = false;
    std::array<std::size_t, kSourceCount> m_next{}; ///< first sample not yet taken
    int m_clears; ///< of the store, when m_next was right
};

} // namespace trex
