// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/telemetrystore.h"

#include "protocol/telemetry/streamtable.h"

#include <algorithm>

namespace trex {

namespace {

/// A source that misses this much of its turns was interrupted: hidden panel, lost line.
Duration longestStep(const SourceRow& source)
{
    constexpr double kMissedTurns = 5.0;
    const std::chrono::duration<double> turns(kMissedTurns / source.hertz);
    return std::max<Duration>(std::chrono::seconds(1), std::chrono::duration_cast<Duration>(turns));
}

} // namespace

TelemetryStore::TelemetryStore()
{
    for (const SourceRow& row : kSources) {
        m_axes[row.source.index()] = std::make_unique<TimeAxis>(longestStep(row));
    }
    int index = 0;
    for (const StreamRow& row : streams()) {
        m_series.push_back(
            std::make_unique<TimeSeries>(*m_axes[row.source.index()], row.width, row.invalid));
        m_streamsOf[row.source.index()].push_back(index++);
    }
}

TelemetryStore::~TelemetryStore() = default;

void TelemetryStore::append(const PollSample& sample)
{
    m_latest[std::size_t(sample.poll)] = sample;
    append(sample.poll, sample.raw, sample.time);
}

void TelemetryStore::append(Source source, std::span<const std::uint16_t> raw, Instant time)
{
    if (!m_start) {
        m_start = time;
    }
    ++m_revision;
    const auto& columns = m_streamsOf[source.index()];
    if (columns.empty()) {
        return; // a state (mode, who controls): its latest value is all there is to it
    }
    m_axes[source.index()]->append(time);
    for (const int index : columns) {
        const StreamRow& row = streams()[std::size_t(index)];
        m_series[std::size_t(index)]->append(storedFromRaw(row, raw[std::size_t(row.field)]));
    }
    if (m_memoryLimit > 0 && m_axes[source.index()]->size() % kChunkSize == 1) {
        keepToLimit(); // memory grows with the first sample of a chunk only
    }
}

void TelemetryStore::markGap(Instant)
{
    for (const auto& axis : m_axes) {
        axis->markGap();
    }
    m_latest.fill(std::nullopt);
    ++m_revision;
}

void TelemetryStore::markGap(Source source)
{
    m_axes[source.index()]->markGap();
    if (const auto poll = source.poll()) {
        m_latest[std::size_t(*poll)].reset();
    }
    ++m_revision;
}

void TelemetryStore::setMemoryLimit(std::size_t bytes)
{
    m_memoryLimit = bytes;
    keepToLimit();
}

void TelemetryStore::addHolder(const SampleHolder& holder) const
{
    m_holders.push_back(&holder);
}

void TelemetryStore::removeHolder(const SampleHolder& holder) const
{
    std::erase(m_holders, &holder);
}

/// That whose oldest chunk ends first, so that all streams begin at about the same time; none while
/// a holder needs it.
std::optional<Source> TelemetryStore::sourceToDropFrom() const
{
    std::optional<Source> oldest;
    for (const SourceRow& row : kSources) {
        const TimeAxis& axis = *m_axes[row.source.index()];
        if (axis.chunks() > 1
            && (!oldest || axis.secondChunkTick() < m_axes[oldest->index()]->secondChunkTick())) {
            oldest = row.source;
        }
    }
    const auto needs = [&](const SampleHolder* holder) {
        return holder->firstNeeded(*oldest) < m_axes[oldest->index()]->first() + kChunkSize;
    };
    if (oldest && std::any_of(m_holders.begin(), m_holders.end(), needs)) {
        oldest.reset();
    }
    return oldest;
}

void TelemetryStore::keepToLimit()
{
    while (m_memoryLimit > 0 && memoryBytes() > m_memoryLimit) {
        const auto source = sourceToDropFrom();
        if (!source) {
            return;
        }
        for (const int index : m_streamsOf[source->index()]) {
            m_series[std::size_t(index)]->dropChunk();
        }
        m_axes[source->index()]->dropChunk();
        m_hasDropped = true;
        ++m_revision;
    }
}

void TelemetryStore::clear()
{
    for (const auto& axis : m_axes) {
        axis->clear();
    }
    for (const auto& series : m_series) {
        series->clear();
    }
    m_start.reset();
    m_hasDropped = false;
    ++m_clears;
    ++m_revision;
}

const TimeSeries& TelemetryStore::series(int streamIndex) const
{
    return *m_series.at(std::size_t(streamIndex));
}

const TimeSeries& TelemetryStore::series(std::string_view streamKey) const
{
    return series(streamIndex(streamKey));
}

const PollSample* TelemetryStore::latest(PollId poll) const
{
    const auto& sample = m_latest[std::size_t(poll)];
    return sample ? &*sample : nullptr;
}

std::optional<Instant> TelemetryStore::start() const
{
    return m_start;
}

void TelemetryStore::standAt(Instant playhead, Instant since)
{
    m_playhead = playhead;
    ++m_revision;
    for (const PollRow& poll : kPolls) {
        const auto id = std::size_t(poll.id);
        m_latest[id].reset();
        const std::size_t end = m_axes[id]->lowerBound(TimeAxis::ticksOf(playhead) + 1);
        if (end <= m_axes[id]->first() || m_streamsOf[id].empty()
            || m_axes[id]->time(end - 1) < since) {
            continue;
        }
        PollSample sample{poll.id, {}, m_axes[id]->time(end - 1)};
        for (const int index : m_streamsOf[id]) {
            const StreamRow& row = streams()[std::size_t(index)];
            const int stored = m_series[std::size_t(index)]->value(end - 1);
            sample.raw[std::size_t(row.field)] = rawFromStored(row, stored);
        }
        m_latest[id] = sample;
    }
}

std::optional<Instant> TelemetryStore::oldest() const
{
    if (!m_hasDropped) {
        return m_start;
    }
    std::optional<Instant> oldest;
    for (const auto& axis : m_axes) {
        if (axis->size() > 0) {
            const Instant time = axis->time(axis->first());
            oldest = std::min(oldest.value_or(time), time);
        }
    }
    return oldest;
}

std::size_t TelemetryStore::memoryBytes() const
{
    std::size_t bytes = 0;
    for (const auto& axis : m_axes) {
        bytes += axis->memoryBytes();
    }
    for (const auto& series : m_series) {
        bytes += series->memoryBytes();
    }
    return bytes;
}

} // namespace trex
