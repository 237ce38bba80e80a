// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/source.h"
#include "protocol/telemetry/timeseries.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace trex {

/// Somebody who takes every sample out of the store: what is not taken yet stays.
class SampleHolder {
public:
    virtual ~SampleHolder() = default;
    /// Index of the first sample that is still needed; size_t's largest: none is.
    [[nodiscard]] virtual std::size_t firstNeeded(Source source) const = 0;
};

/// Every sample of the session, one series a stream of streamtable.h; the streams of one source
/// share their times. Main thread: one writer (the façade), readers without copying. A revision
/// counter tells views what is new; there is no signal a sample. With a ceiling the oldest samples
/// leave, whole chunks at a time, but none that a holder still needs.
class TelemetryStore {
public:
    TelemetryStore();
    ~TelemetryStore();
    Q_DISABLE_COPY_MOVE(TelemetryStore)

    void append(const PollSample& sample);
    /// Of any source; `raw` holds its SourceRow::values numbers.
    void append(Source source, std::span<const std::uint16_t> raw, Instant time);
    void markGap(Instant time); ///< the link was lost: series must not be bridged across it
    void markGap(Source source); ///< the same for what one source fills
    void clear();
    [[nodiscard]] const TimeSeries& series(int streamIndex) const; ///< index into streams()
    [[nodiscard]] const TimeSeries& series(std::string_view streamKey) const; ///< a row's key
    [[nodiscard]] quint64 revision() const { return m_revision; } ///< grows with each append
    [[nodiscard]] int clears() const { return m_clears; } ///< indices of before are void after each
    /// The latest sample of a poll since the last gap; none: no fresh value (stale or never).
    [[nodiscard]] const PollSample* latest(PollId poll) const;
    [[nodiscard]] std::optional<Instant> start() const; ///< of the first sample since clear()
    /// Where what is still there begins: the start, until samples have left. None: no samples.
    [[nodiscard]] std::optional<Instant> oldest() const;
    /// The present, for whoever asks how old a value is: the steady clock's, or the playhead of a
    /// recording.
    [[nodiscard]] Instant now() const
    {
        return m_playhead.value_or(std::chrono::steady_clock::now());
    }
    /// For a recording: now() is the playhead, and latest() what was the latest then, unless it is
    /// from before `since` (the link was lost there).
    void standAt(Instant playhead, Instant since = Instant::min());
    [[nodiscard]] std::size_t memoryBytes() const; ///< of all samples, times and pyramids

    void setMemoryLimit(std::size_t bytes); ///< 0: none, as at first
    [[nodiscard]] std::size_t memoryLimit() const { return m_memoryLimit; }
    [[nodiscard]] bool hasDropped() const { return m_hasDropped; } ///< samples, since clear()
    /// Holders are readers, and readers see a const store. Outlived by it, or removed before.
    void addHolder(const SampleHolder& holder) const;
    void removeHolder(const SampleHolder& holder) const;

private:
    void keepToLimit();
    [[nodiscard]] std::optional<Source> sourceToDropFrom() const;

    std::array<std::unique_ptr<TimeAxis>, kSourceCount> m_axes;
    std::vector<std::unique_ptr<TimeSeries>> m_series;
    std::array<std::vector<int>, kSourceCount> m_streamsOf;
    std::array<std::optional<PollSample>, kPollCount> m_latest;
    std::optional<Instant> m_start;
    std::optional<Instant> m_playhead;
    quint64 m_revision = 0;
    int m_clears = 0;
    std::size_t m_memoryLimit = 0;
    bool m_hasDropped = false;
    mutable std::vector<const SampleHolder*> m_holders;
};

} // namespace trex
