// SPDX-License-Identifier: GPL-3.0-or-later
// What a person composed, on its way to the line.
#pragma once

#include "protocol/codec/command.h"

#include <optional>

namespace trex {

/// Bytes from hex digits as people write them: "86 1F", "861f", "0x86, 0x1F". Errors: BadCommand,
/// with what is no hex.
[[nodiscard]] Result<QByteArray> bytesFromHex(const QString& text);
/// The order that a motor command carries, when the motor gate knows it in these very bytes.
struct GateOrder {
    bool isBoth = false;
    MotorId motor = MotorId::Motor1;
    MotorOrder first{};
    MotorOrder second{}; ///< of motor 2, when both
};
[[nodiscard]] std::optional<GateOrder> gateOrderOf(const Command& command);

} // namespace trex
