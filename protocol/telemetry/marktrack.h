// SPDX-License-Identifier: GPL-3.0-or-later
// What happened beside the samples, on the same clock: plots draw it as marks on the time axis.
#pragma once

#include "protocol/codec/quantities.h"

#include <QString>

#include <span>
#include <string_view>
#include <vector>

namespace trex {

enum class MarkKind : std::uint8_t {
    Connected, ///< also the link that came back
    LinkLost,
    Disconnected,
    Armed,
    Disarmed,
    Stop,
    Written, ///< a setting, as read back
    OverCurrent,
    Fault,
    Timeout, ///< the controller heard nothing for its serial timeout
    LineError, ///< any other bit of its UART error byte
    Restarted,
    Trigger,
    Note, ///< the person's own
};

/// How much it asks for attention; a plot gives each its shape and colour.
enum class MarkWeight : std::uint8_t { Quiet, Action, Warning, Fault };

struct MarkRow {
    MarkKind kind;
    std::string_view key; ///< in files: never changed
    const char* title; ///< QT_TRANSLATE_NOOP("Marks", …)
    const char* sign; ///< one or two characters that stand in its shape
    MarkWeight weight;
};
[[nodiscard]] std::span<const MarkRow> markRows();
[[nodiscard]] const MarkRow& markRow(MarkKind kind);
[[nodiscard]] std::optional<MarkKind> markKind(std::string_view key); ///< none: no such key

struct Mark {
    Instant time; ///< steady clock, as the samples
    MarkKind kind = MarkKind::Note;
    QString text; ///< a plain sentence or less; "": its kind says all
};
/// Its text, or its kind's title where it has none.
[[nodiscard]] QString markText(const Mark& mark);

/// Marks in the order of their times. Append-only but for clear(); main thread. Views look at the
/// revision.
class MarkTrack {
public:
    /// Usually the latest; one that comes late is put where its time belongs.
    void append(const Mark& mark);
    void clear();
    [[nodiscard]] const std::vector<Mark>& marks() const { return m_marks; }
    [[nodiscard]] quint64 revision() const { return m_revision; }
    /// Index of the first mark at or after `time`; marks().size(): none.
    [[nodiscard]] std::size_t lowerBound(Instant time) const;
    [[nodiscard]] const Mark* after(Instant time) const; ///< first later than; null: none
    [[nodiscard]] const Mark* before(Instant time) const; ///< last earlier than; null: none

private:
    std::vector<Mark> m_marks;
    quint64 m_revision = 0;
};

} // namespace trex
