// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as people type them: decimal, or hexadecimal with 0x.
#pragma once

#include "protocol/result.h"

#include <optional>
#include <string_view>

namespace trex {

/// "-12", "0x1F"; none for anything else (a leading zero does not make it octal).
[[nodiscard]] std::optional<qint64> numberFromText(QStringView text);

/// A number within its range. Errors: OutOfRange, naming `what` and the range.
[[nodiscard]] Result<int> numberInRange(std::string_view what, const QString& text, int minimum,
                                        int maximum);

/// A number of seconds or the like, above `above` up to `maximum`. Errors: OutOfRange.
[[nodiscard]] Result<double> positiveNumber(std::string_view what, const QString& text,
                                            double maximum);

} // namespace trex
