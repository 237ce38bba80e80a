// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <optional>

namespace trex::sim {

/// "serial-timeout", "7" or "0x07" to 7; none: no such parameter (0x7F is a command, not one).
[[nodiscard]] std::optional<int> parameterNumber(const QString& keyOrNumber);

} // namespace trex::sim
