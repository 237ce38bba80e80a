// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/telemetrystore.h"

#include "protocol/telemetry/streamtable.h"

namespace trex {

namespace {

/// A poll that misses this much of its turns was interrupted: hidden panel, lost line.
Duration longestStep(const PollRow& poll)
{
    constexpr double kMissedTurns = 5.0;
    const std::chrono::duration<double> turns(kMissedTurns / poll.hertz);
    return std::max<Duration>(std::chrono::seconds(1), std::chrono::duration_cast<Duration>(turns));
}

} // namespace

TelemetryStore::TelemetryStore()
{
    for (const PollRow& poll : kPolls) {
        m_axes[std::size_t(poll.id)] = std::make_unique<TimeAxis>(longestStep(poll));
    }
    int index = 0;
    for (const StreamRow& row : streams()) {
        m_series.push_back(
            std::make_unique<TimeSeries>(*m_axes[std::size_t(row.poll)], row.width, row.invalid));
        m_streamsOf[std::size_t(row.poll)].push_back(index++);
    }
}

TelemetryStore::~TelemetryStore() = default;

void TelemetryStore::append(const PollSample& sample)
{
    const auto poll = std::size_t(sample.poll);
    if (!m_start) {
        m_start = sample.time;
    }
    m_latest[poll] = sample;
    ++m_revision;
    if (m_streamsOf[poll].empty()) {
        return; // a state (mode, who controls): its latest value is all there is to it
    }
    m_axes[poll]->append(sample.time);
    for (const int index : m_streamsOf[poll]) {
        const StreamRow& row = streams()[std::size_t(index)];
        m_series[std::size_t(index)]->append(
            storedFromRaw(row, sample.raw[std::size_t(row.field)]));
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

void TelemetryStore::markGap(PollId poll)
{
    m_axes.at(std::size_t(poll))->markGap();
    m_latest.at(std::size_t(poll)).reset();
    ++m_revision;
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
