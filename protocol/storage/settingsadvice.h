// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/linesettings.h"
#include "protocol/storage/configfile.h"

#include <set>
#include <vector>

namespace trex {

/// A sentence about a value that is legal, but that a person should know the meaning of.
struct Advice {
    std::uint8_t parameter = 0; ///< the row it belongs to
    QString text;
    bool isAboutChange = false; ///< about changing it; else about the value, whoever set it
    bool operator==(const Advice&) const = default;
};

/// Looks at the parameters together: `wanted` as they would be after writing, `present` as they are
/// in the controller (either may lack some). `line` is the line in use, `numbersInUse` the device
/// numbers that are known to answer on it.
[[nodiscard]] std::vector<Advice> adviceOn(const ParameterValues& present,
                                           const ParameterValues& wanted, const LineSettings& line,
                                           Model model, const std::set<int>& numbersInUse = {});

} // namespace trex
