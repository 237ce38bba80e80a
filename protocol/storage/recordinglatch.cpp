// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recordinglatch.h"

namespace trex {
namespace {

constexpr std::array<std::string_view, 2> kStreams{"status", "uart-errors"};

} // namespace

void RecordingLatch::follow(const TelemetryStore& store)
{
    for (std::size_t byte = 0; byte < kStreams.size(); ++byte) {
        const TimeSeries& series = store.series(kStreams[byte]);
        for (; m_next[byte] < series.size(); ++m_next[byte]) {
            const auto bits = static_cast<unsigned>(series.value(m_next[byte]));
            for (std::size_t bit = 0; bits != 0 && bit < m_seen[byte].size(); ++bit) {
                if ((bits >> bit & 1U) != 0U) {
                    m_seen[byte][bit].push_back(series.axis().tick(m_next[byte]));
                }
            }
        }
    }
}

StatusLatch::Shown RecordingLatch::shownAt(const TelemetryStore& store, Tick playhead,
                                           const QDateTime& wallClock) const
{
    constexpr qint64 kTicksPerMs = std::chrono::milliseconds(1) / TimeAxis::kTick;
    const auto wallClockOf = [&](Tick tick) {
        return wallClock.addMSecs((tick - playhead) / kTicksPerMs);
    };
    StatusLatch::Shown shown;
    shown.now = wallClock;
    for (std::size_t byte = 0; byte < kStreams.size(); ++byte) {
        const auto poll = byte == 0 ? PollId::Status : PollId::UartErrors;
        const PollSample* latest = store.latest(poll);
        if (latest != nullptr) {
            shown.lastRead[byte] = latest->time;
        }
        for (std::size_t bit = 0; bit < m_seen[byte].size(); ++bit) {
            const std::vector<Tick>& seen = m_seen[byte][bit];
            const auto end = std::upper_bound(seen.begin(), seen.end(), playhead);
            StatusLatch::Entry& entry = shown.entries[byte][bit];
            entry.lit = latest != nullptr && (latest->raw.front() >> bit & 1U) != 0U;
            entry.count = static_cast<int>(end - seen.begin());
            if (entry.count > 0) {
                entry.firstSeen = wallClockOf(seen.front());
                entry.lastSeen = wallClockOf(*(end - 1));
            }
        }
    }
    return shown;
}

} // namespace trex
