// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/recordingmarks.h"

#include "protocol/procedures/markkeeper.h"
#include "protocol/telemetry/telemetrystore.h"

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr std::size_t kMostMarks = 100'000; ///< beyond that nobody sees one for the others

/// Follows the events, since some are news only after what was before.
class EventMarks {
public:
    [[nodiscard]] std::optional<Mark> markOf(const RecordedEvent& event)
    {
        const Instant time = TimeAxis::instantOf(event.tick);
        if (event.kind == u"link"_s) {
            return markOfLink(event.text, time);
        }
        if (event.kind == u"armed"_s) {
            const bool isArmed = event.text == u"true"_s;
            if (std::exchange(m_isArmed, isArmed) == isArmed) {
                return std::nullopt; // what held at the start
            }
            return Mark{time, isArmed ? MarkKind::Armed : MarkKind::Disarmed, {}};
        }
        if (event.kind == u"stop"_s) {
            return Mark{time, MarkKind::Stop, {}};
        }
        if (event.kind == u"setting"_s) {
            return Mark{time, MarkKind::Written, event.text};
        }
        if (event.kind == u"restarted"_s) {
            return Mark{time, MarkKind::Restarted, {}};
        }
        if (event.kind == u"note"_s) {
            return Mark{time, MarkKind::Note, event.text};
        }
        return std::nullopt;
    }

private:
    std::optional<Mark> markOfLink(const QString& link, Instant time)
    {
        const QString before = std::exchange(m_link, link);
        if (before.isEmpty() || before == link) {
            return std::nullopt;
        }
        if (link == u"connected"_s) {
            return Mark{time, MarkKind::Connected, {}};
        }
        if (link == u"lost"_s) {
            return Mark{time, MarkKind::LinkLost, {}};
        }
        return link == u"disconnected"_s ? std::optional(Mark{time, MarkKind::Disconnected, {}})
                                         : std::nullopt;
    }

    QString m_link;
    bool m_isArmed = false;
};

/// A bit that stays set from read to read is one mark, where it was first seen.
void addBits(std::vector<Mark>& marks, StatusLatch::Byte byte, const TimeSeries& series)
{
    unsigned before = 0;
    for (std::size_t i = 0; i < series.size() && marks.size() < kMostMarks; ++i) {
        const auto bits = static_cast<unsigned>(series.value(i));
        const auto risen = static_cast<std::uint8_t>(bits & ~before);
        if (risen != 0) {
            const auto more = MarkKeeper::marksOf(byte, risen, series.time(i));
            marks.insert(marks.end(), more.begin(), more.end());
        }
        before = bits;
    }
}

} // namespace

void fillMarks(MarkTrack& track, const RecordingHistory& history, const TelemetryStore& store)
{
    std::vector<Mark> marks;
    EventMarks events;
    for (const RecordedEvent& event : history.events()) {
        const auto mark = events.markOf(event);
        if (mark && marks.size() < kMostMarks) {
            marks.push_back(*mark);
        }
    }
    addBits(marks, StatusLatch::Byte::Status, store.series("status"));
    addBits(marks, StatusLatch::Byte::Uart, store.series("uart-errors"));
    std::stable_sort(marks.begin(), marks.end(),
                     [](const Mark& a, const Mark& b) { return a.time < b.time; });
    for (const Mark& mark : marks) {
        track.append(mark);
    }
}

} // namespace trex
