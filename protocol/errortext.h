// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/result.h"

#include <string_view>

namespace trex {

/// The sentence a person reads: what failed, why, and what to do. The only place that makes one.
[[nodiscard]] QString errorText(const Error& error);

/// An OutOfRange error whose context reads in any language: "speed 200 (-127…127)".
[[nodiscard]] tl::unexpected<Error> outOfRange(std::string_view key, qint64 value, qint64 minimum,
                                               qint64 maximum);

/// True for errors that are a state of the line (no reply, unplugged), false for refusals.
[[nodiscard]] bool isLoss(ErrorCode code);

} // namespace trex
