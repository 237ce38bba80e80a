// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/sampletap.h"

#include <limits>
#include <utility>

namespace trex {

SampleTap::SampleTap(const TelemetryStore& store) : m_store(store), m_clears(store.clears()) { }

SampleTap::~SampleTap()
{
    stop();
}

void SampleTap::stop()
{
    if (std::exchange(m_isHolding, false)) {
        m_store.removeHolder(*this);
    }
}

std::size_t SampleTap::firstNeeded(Source source) const
{
    if (m_clears != m_store.clears()) {
        return 0; // cleared since: all is new
    }
    const auto id = source.index();
    return m_wanted[id] ? m_next[id] : std::numeric_limits<std::size_t>::max();
}

void SampleTap::startNow()
{
    startAt(Instant::max());
}

void SampleTap::startAt(Instant from)
{
    m_clears = m_store.clears();
    m_wanted.fill(true);
    if (!std::exchange(m_isHolding, true)) {
        m_store.addHolder(*this);
    }
    for (const SourceRow& row : kSources) {
        const auto& columns = streamsOf(row.source);
        if (columns.empty()) {
            continue;
        }
        const TimeAxis& axis = m_store.series(columns.front()).axis();
        m_next[row.source.index()] = axis.lowerBound(TimeAxis::ticksOf(from));
    }
}

std::size_t SampleTap::take(const Wanted& wanted, Tick origin, std::size_t most,
                            std::array<SampleRun, kSourceCount>& runs)
{
    if (m_clears != m_store.clears()) {
        m_clears = m_store.clears();
        m_next = {};
    }
    m_wanted = wanted;
    std::size_t taken = 0;
    for (const SourceRow& row : kSources) {
        const auto id = row.source.index();
        const auto& columns = streamsOf(row.source);
        if (!wanted[id] || columns.empty()) {
            continue;
        }
        const TimeAxis& axis = m_store.series(columns.front()).axis();
        const std::size_t begin = std::max(m_next[id], axis.first());
        const std::size_t end = std::min(axis.size(), begin + most);
        SampleRun& run = runs[id];
        const auto& gaps = axis.gaps();
        auto gap = std::lower_bound(gaps.begin(), gaps.end(), begin);
        for (std::size_t i = begin; i < end; ++i) {
            if (gap != gaps.end() && *gap == i) {
                run.gaps.push_back(run.size());
                ++gap;
            }
            run.ticks.push_back(axis.tick(i) - origin);
            for (const int column : columns) {
                run.values.push_back(static_cast<std::uint16_t>(m_store.series(column).value(i)));
            }
        }
        m_next[id] = std::max(begin, end);
        taken += end > begin ? end - begin : 0;
    }
    return taken;
}

} // namespace trex
