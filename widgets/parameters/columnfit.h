// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace trex {

/// What one column of a table needs, in pixels.
struct ColumnNeed {
    int least = 0; ///< below, it says nothing
    int wanted = 0; ///< everything in it is seen
};

/// The columns' widths in a table that has `room` pixels for them: what is missing is taken from
/// those that want more than the least, in proportion; none gets less than its least.
[[nodiscard]] std::vector<int> fittedWidths(const std::vector<ColumnNeed>& needs, int room);

} // namespace trex
