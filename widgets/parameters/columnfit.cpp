// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/columnfit.h"

#include <algorithm>

namespace trex {

std::vector<int> fittedWidths(const std::vector<ColumnNeed>& needs, int room)
{
    int least = 0;
    int wanted = 0;
    for (const auto& need : needs) {
        least += need.least;
        wanted += std::max(need.least, need.wanted);
    }
    const int flexible = wanted - least;
    const int given = std::clamp(room - least, 0, flexible);
    std::vector<int> widths;
    for (const auto& need : needs) {
        const int more = std::max(need.wanted - need.least, 0);
        widths.push_back(need.least + (flexible > 0 ? more * given / flexible : 0));
    }
    return widths;
}

} // namespace trex
