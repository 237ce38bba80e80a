// SPDX-License-Identifier: GPL-3.0-or-later
// A parameter and its value as typed: key or number; raw or with a unit.
#pragma once

#include "app/trexctl/failure.h"
#include "protocol/codec/parametertable.h"

#include <QString>

namespace trex {

/// By key or number. 0x7F is refused: `param reset` is its command.
[[nodiscard]] tl::expected<const ParameterRow*, Failure> parameterFromText(const QString& text);

struct TypedValue {
    int raw = 0;
    bool isRounded = false; ///< the unit's number lies between two raw values
};
/// "5", "0x05", or with a unit that the row has: "500ms", "0.5 s", "2.4A", "2400mA".
[[nodiscard]] tl::expected<TypedValue, Failure> valueFromText(const ParameterRow& row,
                                                              const QString& text);

} // namespace trex
