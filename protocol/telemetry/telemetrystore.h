// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/polltable.h"
#include "protocol/telemetry/timeseries.h"

#include <array>
#include <memory>
#include <vector>

namespace trex {

/// Every sample of the session, one series a stream of streamtable.h; the streams of one poll share
/// their times. Main thread: one writer (the façade), readers without copying. A revision counter
/// tells views what is new; there is no signal a sample.
class TelemetryStore {
public:
    TelemetryStore();
    ~TelemetryStore();
    Q_DISABLE_COPY_MOVE(TelemetryStore)

    void append(const PollSample& sample);
    void markGap(Instant time); ///< the link was lost: series must not be bridged across it
    void markGap(PollId poll); ///< the same for what one poll fills
    void clear();
    [[nodiscard]] const TimeSeries& series(int streamIndex) const; ///< index into streams()
    [[nodiscard]] const TimeSeries& series(std::string_view streamKey) const; ///< a row's key
    [[nodiscard]] quint64 revision() const { return m_revision; } ///< grows with each append
    [[nodiscard]] int clears() const { return m_clears; } ///< indices of before are void after each
    /// The latest sample of a poll since the last gap; none: no fresh value (stale or never).
    [[nodiscard]] const PollSample* latest(PollId poll) const;
    [[nodiscard]] std::optional<Instant> start() const; ///< of the first sample since clear()
    [[nodiscard]] std::size_t memoryBytes() const; ///< of all samples, times and pyramids

private:
    std::array<std::unique_ptr<TimeAxis>, kPollCount> m_axes;
    std::vector<std::unique_ptr<TimeSeries>> m_series;
    std::array<std::vector<int>, kPollCount> m_streamsOf;
    std::array<std::optional<PollSample>, kPollCount> m_latest;
    std::optional<Instant> m_start;
    quint64 m_revision = 0;
    int m_clears = 0;
};

} // namespace trex
