// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/marktrack.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace trex {

namespace {

// clang-format off
constexpr std::array kRows{
    MarkRow{MarkKind::Connected,    "connected",    QT_TRANSLATE_NOOP("Marks", "Connected"),        "↑", MarkWeight::Quiet},
    MarkRow{MarkKind::LinkLost,     "link-lost",    QT_TRANSLATE_NOOP("Marks", "Link lost"),        "×", MarkWeight::Fault},
    MarkRow{MarkKind::Disconnected, "disconnected", QT_TRANSLATE_NOOP("Marks", "Disconnected"),     "↓", MarkWeight::Quiet},
    MarkRow{MarkKind::Armed,        "armed",        QT_TRANSLATE_NOOP("Marks", "Armed"),            "A", MarkWeight::Action},
    MarkRow{MarkKind::Disarmed,     "disarmed",     QT_TRANSLATE_NOOP("Marks", "Disarmed"),         "D", MarkWeight::Action},
    MarkRow{MarkKind::Stop,         "stop",         QT_TRANSLATE_NOOP("Marks", "Stop"),             "S", MarkWeight::Fault},
    MarkRow{MarkKind::Written,      "written",      QT_TRANSLATE_NOOP("Marks", "Setting written"),  "W", MarkWeight::Action},
    MarkRow{MarkKind::OverCurrent,  "over-current", QT_TRANSLATE_NOOP("Marks", "Over current"),     "I", MarkWeight::Warning},
    MarkRow{MarkKind::Fault,        "fault",        QT_TRANSLATE_NOOP("Marks", "Motor fault"),      "F", MarkWeight::Fault},
    MarkRow{MarkKind::Timeout,      "timeout",      QT_TRANSLATE_NOOP("Marks", "Serial timeout"),   "T", MarkWeight::Fault},
    MarkRow{MarkKind::LineError,    "line-error",   QT_TRANSLATE_NOOP("Marks", "Line error"),       "E", MarkWeight::Warning},
    MarkRow{MarkKind::Restarted,    "restarted",    QT_TRANSLATE_NOOP("Marks", "Restarted"),        "R", MarkWeight::Warning},
    MarkRow{MarkKind::Trigger,      "trigger",      QT_TRANSLATE_NOOP("Marks", "Trigger"),          "▸", MarkWeight::Quiet},
    MarkRow{MarkKind::Note,         "note",         QT_TRANSLATE_NOOP("Marks", "Note"),             "N", MarkWeight::Action},
};
// clang-format on

static_assert([] {
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        if (static_cast<std::size_t>(kRows.at(i).kind) != i) {
            return false;
        }
    }
    return kRows.size() == static_cast<std::size_t>(MarkKind::Note) + 1;
}());

} // namespace

std::span<const MarkRow> markRows()
{
    return kRows;
}

const MarkRow& markRow(MarkKind kind)
{
    return kRows.at(static_cast<std::size_t>(kind));
}

std::optional<MarkKind> markKind(std::string_view key)
{
    for (const MarkRow& row : kRows) {
        if (row.key == key) {
            return row.kind;
        }
    }
    return std::nullopt;
}

QString markText(const Mark& mark)
{
    return mark.text.isEmpty() ? QCoreApplication::translate("Marks", markRow(mark.kind).title)
                               : mark.text;
}

void MarkTrack::append(const Mark& mark)
{
    const auto later =
        std::upper_bound(m_marks.begin(), m_marks.end(), mark.time,
                         [](Instant time, const Mark& other) { return time < other.time; });
    m_marks.insert(later, mark);
    ++m_revision;
}

void MarkTrack::clear()
{
    m_marks.clear();
    ++m_revision;
}

std::size_t MarkTrack::lowerBound(Instant time) const
{
    const auto found =
        std::lower_bound(m_marks.begin(), m_marks.end(), time,
                         [](const Mark& mark, Instant wanted) { return mark.time < wanted; });
    return static_cast<std::size_t>(found - m_marks.begin());
}

const Mark* MarkTrack::after(Instant time) const
{
    const auto found =
        std::upper_bound(m_marks.begin(), m_marks.end(), time,
                         [](Instant wanted, const Mark& mark) { return wanted < mark.time; });
    return found == m_marks.end() ? nullptr : &*found;
}

const Mark* MarkTrack::before(Instant time) const
{
    const std::size_t index = lowerBound(time);
    return index == 0 ? nullptr : &m_marks[index - 1];
}

} // namespace trex
