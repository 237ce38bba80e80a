// SPDX-License-Identifier: GPL-3.0-or-later
// A command as a value: opcode and data bytes, before it is framed for a line. The builders here
// are the only code that puts a command together.
#pragma once

#include "protocol/codec/commandtable.h"
#include "protocol/codec/quantities.h"
#include "protocol/result.h"

#include <QByteArray>

namespace trex {

struct Command {
    std::uint8_t opcode = 0;
    QByteArray data;
    [[nodiscard]] const CommandRow& row() const { return *findCommand(opcode); }
    bool operator==(const Command&) const = default;
};

/// minimum ≤ neutral ≤ maximum, minimum < maximum, in raw units of the input set in force
/// (0.4 µs or 10-bit counts).
struct Calibration {
    int minimum = 0;
    int neutral = 0;
    int maximum = 0;
    int deadband = 0;
    bool operator==(const Calibration&) const = default;
};
inline constexpr int kLargestCalibrationValue = 16383; // two 7-bit halves (conformance C-35)

/// What a motor is to do. `amount` is a signed speed, or a braking duty 0 (coast) to 127 (full).
struct MotorOrder {
    enum class Action : std::uint8_t { Set, Accelerate, Brake };
    Action action = Action::Set;
    int amount = 0;
    bool operator==(const MotorOrder&) const = default;
};

[[nodiscard]] Command query(std::string_view key, int channel = 1); ///< no data bytes
[[nodiscard]] Command channelsQuery(std::string_view key, std::uint8_t mask);
[[nodiscard]] Command readParameter(std::uint8_t number);
[[nodiscard]] Command writeParameter(std::uint8_t number, std::uint8_t value);
[[nodiscard]] Command readCalibration(int channel);
/// The one function that decides how a 14-bit value travels in two 7-bit data bytes: low = value
/// & 0x7F, high = value >> 7. The document does not say so in words (conformance C-35); a
/// controller that reads low + 256 × high is recognised by reading back.
[[nodiscard]] Command writeCalibration(int channel, const Calibration& calibration);
/// Errors: OutOfRange for a speed beyond ±127 (aux 0 to 127), a duty beyond 0 to 127, aux brake.
[[nodiscard]] Result<Command> driveMotor(MotorId motor, const MotorOrder& order);
/// Both motors in one packet; the two orders must agree in set or accelerate (brake counts as set).
[[nodiscard]] Result<Command> driveBoth(const MotorOrder& motor1, const MotorOrder& motor2);

/// Checks opcode and data against the command's row: known, length, ranges, format bytes.
/// Errors: BadCommand, OutOfRange. Whether the controller takes the values is not its business.
[[nodiscard]] Result<void> validate(const Command& command);
/// The document's rule for a calibration (conformance C-36) and that each value can be sent.
/// Errors: OutOfRange, with the first value that is wrong.
[[nodiscard]] Result<void> validate(const Calibration& calibration);

/// "Set motor 1 forward 64": a command in words, for the packet view and the log.
[[nodiscard]] QString describe(const Command& command);
/// "motor 1: 55, motor 2: 22": a reply in words. Numbers are raw: model and input kind, which
/// give them a unit, are not known here.
[[nodiscard]] QString describeReply(const Command& command, QByteArrayView payload);

} // namespace trex
