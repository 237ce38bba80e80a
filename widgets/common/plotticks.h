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

/// Upper end of an axis from 0 that gives the highest value some headroom and ends on a tick.
/// It grows at once and shrinks only when it was far too large for a while: nothing jumps.
class AxisTop {
public:
    explicit AxisTop(double smallest) : m_smallest(smallest), m_top(fitting(smallest)) { }
    /// Returns true when the top moved.
    bool update(double highest, Instant now);
    bool fit(double highest); ///< at once, both ways
    [[nodiscard]] double top() const { return m_top; }

private:
    [[nodiscard]] double fitting(double highest) const;
    double m_smallest;
    double m_top;
    std::optional<Instant> m_tooLargeSince;
};

} // namespace trex::ticks
