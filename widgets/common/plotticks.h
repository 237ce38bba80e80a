// SPDX-License-Identifier: GPL-3.0-or-later
// Where a plot puts its ticks, and what it writes beside them. Pure.
#pragma once

#include "protocol/codec/quantities.h"

#include <QString>

#include <optional>

namespace trex::ticks {

/// The smallest of 1, 2 or 5 × 10ⁿ that gives at most `most` steps over the span.
[[nodiscard]] double niceStep(double span, int most);
/// The same for clocks: steps that people count in (1 s, 15 s, 1 min, 6 h …).
[[nodiscard]] double timeStep(double spanSeconds, int most);
/// "0:05", "1:02:30"; with as many decimals as the step asks for ("0:05.25").
[[nodiscard]] QString timeLabel(double seconds, double step);
[[nodiscard]] int decimalsFor(double step);

/// The ends of a value axis: on ticks, with some headroom for what is drawn. It grows at once and
/// shrinks only when it was far too large for a while: nothing jumps.
class AxisRange {
public:
    enum class Foot : std::uint8_t {
        Zero, ///< begins at 0
        Free, ///< begins and ends where the values do
    };
    /// `smallest`: the axis spans at least this much, from 0 where nothing else is known.
    explicit AxisRange(double smallest, Foot foot = Foot::Zero);
    /// `lowest` > `highest`: there are no values. Returns true when an end moved.
    bool update(double lowest, double highest, Instant now);
    bool fit(double lowest, double highest); ///< at once, both ways
    [[nodiscard]] double low() const { return m_ends.first; }
    [[nodiscard]] double high() const { return m_ends.second; }

private:
    using Ends = std::pair<double, double>;
    [[nodiscard]] Ends fitting(double lowest, double highest) const;
    double m_smallest;
    Foot m_foot;
    Ends m_ends;
    std::optional<Instant> m_tooLargeSince;
};

} // namespace trex::ticks
