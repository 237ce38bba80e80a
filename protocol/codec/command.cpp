// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/command.h"

#include "protocol/errortext.h"

namespace trex {
namespace {

constexpr char kFormatByte1 = 0x55; // command documentation, 0xA0 and 0xAF
constexpr char kFormatByte2 = 0x2A;

struct MotorRows {
    std::uint8_t set;
    std::uint8_t accelerate;
};
constexpr MotorRows kMotor1{commandRow("set-motor1").first, commandRow("accelerate-motor1").first};
constexpr MotorRows kMotor2{commandRow("set-motor2").first, commandRow("accelerate-motor2").first};
constexpr MotorRows kBoth{commandRow("set-motors").first, commandRow("accelerate-motors").first};
constexpr MotorRows kAux{commandRow("set-aux").first, commandRow("accelerate-aux").first};

std::uint8_t opcodeOf(const MotorRows& rows, bool isAccelerate)
{
    return isAccelerate ? rows.accelerate : rows.set;
}

Command withByte(std::uint8_t opcode, std::uint8_t byte)
{
    return {opcode, QByteArray(1, static_cast<char>(byte))};
}

bool isChannel(int channel)
{
    return channel >= 1 && channel <= kChannelCount;
}

std::uint8_t channelOpcode(const CommandRow& row, int channel)
{
    return static_cast<std::uint8_t>(row.first + channel - 1);
}

void appendPair7(QByteArray& data, int value)
{
    if (value < 0 || value > kLargestCalibrationValue) {
        data.append(2, static_cast<char>(0xFF)); // no data byte: validate() refuses it
        return;
    }
    data.append(static_cast<char>(value & 0x7F));
    data.append(static_cast<char>(value >> 7));
}

/// Direction bits and data byte of one motor's order.
struct MotorBits {
    std::uint8_t direction;
    char data;
};

Result<MotorBits> motorBits(const MotorOrder& order)
{
    if (order.action == MotorOrder::Action::Brake) {
        if (order.amount < 0 || order.amount > kFullSpeed) {
            return outOfRange("duty", order.amount, 0, kFullSpeed);
        }
        return MotorBits{static_cast<std::uint8_t>(MotorDirection::Brake),
                         static_cast<char>(order.amount)};
    }
    const auto speed = MotorSpeed::from(order.amount);
    if (!speed) {
        return outOfRange("speed", order.amount, -kFullSpeed, kFullSpeed);
    }
    return MotorBits{static_cast<std::uint8_t>(speed->direction()),
                     static_cast<char>(speed->magnitude())};
}

QString hexOf(const Command& command)
{
    const QByteArray bytes = QByteArray(1, static_cast<char>(command.opcode)) + command.data;
    return QString::fromLatin1(bytes.toHex(' ').toUpper());
}

Result<void> validateField(const FieldSpec& field, QByteArrayView bytes)
{
    // conformance C-01: a data byte has its top bit clear, whatever the field means.
    const bool isData = std::ranges::all_of(
        bytes, [](char byte) { return static_cast<std::uint8_t>(byte) < 0x80; });
    const int raw = rawOf(field, bytes.data());
    if (isData && raw >= field.minimum && raw <= field.maximum) {
        return {};
    }
    return outOfRange(field.key, raw, field.minimum, field.maximum);
}

} // namespace

Command query(std::string_view key, int channel)
{
    const CommandRow* const row = findCommand(key);
    Q_ASSERT(row != nullptr && isChannel(channel));
    if (row == nullptr || !isChannel(channel)) {
        return {};
    }
    const bool hasChannel = row->opcodeBits == OpcodeBits::Channel;
    return {hasChannel ? channelOpcode(*row, channel) : row->first, {}};
}

Command channelsQuery(std::string_view key, std::uint8_t mask)
{
    return withByte(query(key).opcode, mask);
}

Command readParameter(std::uint8_t number)
{
    return withByte(commandRow("get-parameter").first, number);
}

Command writeParameter(std::uint8_t number, std::uint8_t value)
{
    Command command = withByte(commandRow("set-parameter").first, number);
    command.data.append(static_cast<char>(value)).append(kFormatByte1).append(kFormatByte2);
    return command;
}

Command readCalibration(int channel)
{
    return query("get-calibration", channel);
}

Command writeCalibration(int channel, const Calibration& calibration)
{
    Command command = query("set-calibration", channel);
    for (const int value :
         {calibration.minimum, calibration.neutral, calibration.maximum, calibration.deadband}) {
        appendPair7(command.data, value);
    }
    command.data.append(kFormatByte1).append(kFormatByte2);
    return command;
}

Result<Command> driveMotor(MotorId motor, const MotorOrder& order)
{
    const bool isAccelerate = order.action == MotorOrder::Action::Accelerate;
    if (motor == MotorId::Aux) {
        if (order.action == MotorOrder::Action::Brake) {
            return fail(ErrorCode::OutOfRange, QStringLiteral("aux brake"));
        }
        if (order.amount < 0 || order.amount > kFullSpeed) {
            return outOfRange("speed", order.amount, 0, kFullSpeed);
        }
        return withByte(opcodeOf(kAux, isAccelerate), static_cast<std::uint8_t>(order.amount));
    }
    const auto& rows = motor == MotorId::Motor1 ? kMotor1 : kMotor2;
    return motorBits(order).map([&](const MotorBits& bits) {
        return Command{static_cast<std::uint8_t>(opcodeOf(rows, isAccelerate) | bits.direction),
                       QByteArray(1, bits.data)};
    });
}

Result<Command> driveBoth(const MotorOrder& motor1, const MotorOrder& motor2)
{
    const bool isAccelerate = motor1.action == MotorOrder::Action::Accelerate;
    if (isAccelerate != (motor2.action == MotorOrder::Action::Accelerate)) {
        return fail(ErrorCode::BadCommand, QStringLiteral("set + accelerate"));
    }
    const auto bits1 = motorBits(motor1);
    const auto bits2 = motorBits(motor2);
    if (!bits1 || !bits2) {
        return tl::make_unexpected(bits1 ? bits2.error() : bits1.error());
    }
    const int opcode =
        opcodeOf(kBoth, isAccelerate) | bits2->direction << 2 | static_cast<int>(bits1->direction);
    return Command{static_cast<std::uint8_t>(opcode),
                   QByteArray(1, bits1->data).append(bits2->data)};
}

Result<void> validate(const Command& command)
{
    const CommandRow* const row = findCommand(command.opcode);
    if (row == nullptr || row->kind == CommandKind::Framing) {
        return fail(ErrorCode::BadCommand, hexOf(command));
    }
    QByteArrayView rest = command.data;
    for (const auto& field : row->arguments) {
        if (rest.size() < field.width()) {
            return fail(ErrorCode::BadCommand, hexOf(command));
        }
        const auto checked = validateField(field, rest.first(field.width()));
        if (!checked) {
            return field.kind == FieldKind::Constant ? fail(ErrorCode::BadCommand, hexOf(command))
                                                     : checked;
        }
        rest = rest.sliced(field.width());
    }
    if (!rest.isEmpty()) {
        return fail(ErrorCode::BadCommand, hexOf(command));
    }
    return {};
}

Result<void> validate(const Calibration& calibration)
{
    const auto& [minimum, neutral, maximum, deadband] = calibration;
    if (minimum < 0 || minimum >= kLargestCalibrationValue) {
        return outOfRange("minimum", minimum, 0, kLargestCalibrationValue - 1);
    }
    if (maximum <= minimum || maximum > kLargestCalibrationValue) {
        return outOfRange("maximum", maximum, minimum + 1, kLargestCalibrationValue);
    }
    if (neutral < minimum || neutral > maximum) {
        return outOfRange("neutral", neutral, minimum, maximum);
    }
    if (deadband < 0 || deadband > kLargestCalibrationValue) {
        return outOfRange("deadband", deadband, 0, kLargestCalibrationValue);
    }
    return {};
}

} // namespace trex
