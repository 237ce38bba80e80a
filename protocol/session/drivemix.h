// SPDX-License-Identifier: GPL-3.0-or-later
// Forward and turn, as of one stick, for two wheels. The controller's own mixing acts on its
// channels only, never on serial orders (facts.md 4, F-9053).
#pragma once

#include "protocol/codec/quantities.h"

#include <utility>

namespace trex {

/// Speeds of motors 1 and 2 (conformance C-65: motor 1 = forward + turn, motor 2 = forward − turn).
/// What is beyond full speed is taken from both alike, so that a sharp turn stays as sharp.
[[nodiscard]] constexpr std::pair<int, int> mixed(int forward, int turn)
{
    const int first = forward + turn;
    const int second = forward - turn;
    const int largest = std::max(first < 0 ? -first : first, second < 0 ? -second : second);
    if (largest <= kFullSpeed) {
        return {first, second};
    }
    return {first * kFullSpeed / largest, second * kFullSpeed / largest};
}

} // namespace trex
