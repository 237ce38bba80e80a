// SPDX-License-Identifier: GPL-3.0-or-later
// Commands and replies in words. Everything that a row tells is read from the row; only commands
// whose opcode or data mean more than their fields say have words of their own.
#include "protocol/codec/command.h"
#include "protocol/codec/packet.h"
#include "protocol/codec/parametertable.h"
#include "protocol/codec/replies.h"
#include "protocol/codec/replyparser.h"

#include <QCoreApplication>
#include <QStringList>

namespace trex {
namespace {

std::uint8_t byteAt(QByteArrayView bytes, qsizetype index)
{
    return static_cast<std::uint8_t>(bytes[index]);
}

QString titleOf(const CommandRow& row)
{
    return QCoreApplication::translate("Commands", row.title);
}

bool isRow(const CommandRow& row, const CommandRow& other)
{
    return &row == &other;
}

QString channelList(int mask)
{
    QStringList numbers;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if ((mask >> (channel - 1) & 1) != 0) {
            numbers << QString::number(channel);
        }
    }
    return numbers.isEmpty() ? QCoreApplication::translate("Packets", "none")
                             : numbers.join(QStringLiteral(", "));
}

QString parameterName(int number)
{
    const ParameterRow* const row = findParameter(number);
    return row != nullptr
        ? QString::fromLatin1(row->key)
        : QStringLiteral("0x%1").arg(QString::number(number, 16).toUpper(), 2, QLatin1Char('0'));
}

/// "5 (500 ms)", or the bare number where the words say no more.
QString parameterValue(int number, int raw)
{
    const QString plain = QString::number(raw);
    const ParameterRow* const row = findParameter(number);
    const QString text = row != nullptr ? parameterText(*row, raw) : plain;
    return text == plain ? plain : QStringLiteral("%1 (%2)").arg(plain, text);
}

/// "1 forward 64" or "Set motor 1 forward 64": who, then what it is told.
QString directionText(const QString& who, int bits, int amount)
{
    switch (static_cast<MotorDirection>(bits & 3)) {
    case MotorDirection::Reverse:
        return QCoreApplication::translate("Packets", "%1 reverse %2").arg(who).arg(amount);
    case MotorDirection::Forward:
        return QCoreApplication::translate("Packets", "%1 forward %2").arg(who).arg(amount);
    case MotorDirection::Brake:
    case MotorDirection::BrakeAlternate:
        break;
    }
    return QCoreApplication::translate("Packets", "%1 brake %2").arg(who).arg(amount);
}

QString describeMotor(const CommandRow& row, const Command& command)
{
    const int amount = byteAt(command.data, 0);
    if (row.opcodeBits == OpcodeBits::DirectionPair) {
        const QString first = directionText(QStringLiteral("1"), command.opcode, amount);
        const QString second =
            directionText(QStringLiteral("2"), command.opcode >> 2, byteAt(command.data, 1));
        return (isRow(row, commandRow("set-motors"))
                    ? QCoreApplication::translate("Packets", "Set motors %1, %2")
                    : QCoreApplication::translate("Packets", "Accelerate motors %1, %2"))
            .arg(first, second);
    }
    if (row.opcodeBits != OpcodeBits::Direction) {
        return QStringLiteral("%1 %2").arg(titleOf(row)).arg(amount);
    }
    const auto direction = static_cast<MotorDirection>(command.opcode & 3);
    const bool isBrake =
        direction == MotorDirection::Brake || direction == MotorDirection::BrakeAlternate;
    if (isBrake && isRow(row, commandRow("set-motor1"))) {
        return QCoreApplication::translate("Packets", "Brake motor 1, duty %1").arg(amount);
    }
    if (isBrake && isRow(row, commandRow("set-motor2"))) {
        return QCoreApplication::translate("Packets", "Brake motor 2, duty %1").arg(amount);
    }
    return directionText(titleOf(row), command.opcode, amount);
}

/// "minimum: 2500, neutral: 3750", without format bytes.
QString fieldsText(std::span<const FieldSpec> fields, QByteArrayView bytes)
{
    QStringList parts;
    const auto decoded = decodeFields(fields, bytes);
    for (std::size_t i = 0; i < decoded.size(); ++i) {
        if (fields[i].kind != FieldKind::Constant) {
            parts << QStringLiteral("%1: %2").arg(labelOf(decoded[i].key), decoded[i].text);
        }
    }
    return parts.join(QStringLiteral(", "));
}

QString describeQuery(const CommandRow& row, const Command& command)
{
    if (row.replyRule == ReplyRule::PerMaskBit) {
        return QStringLiteral("%1: %2").arg(titleOf(row), channelList(byteAt(command.data, 0)));
    }
    if (isRow(row, commandRow("get-parameter"))) {
        return QCoreApplication::translate("Packets", "Get parameter %1")
            .arg(parameterName(byteAt(command.data, 0)));
    }
    if (isRow(row, commandRow("get-calibration"))) {
        return QCoreApplication::translate("Packets", "Get calibration of channel %1")
            .arg(command.opcode - row.first + 1);
    }
    const QString arguments = fieldsText(row.arguments, command.data);
    return arguments.isEmpty() ? titleOf(row)
                               : QStringLiteral("%1: %2").arg(titleOf(row), arguments);
}

QString describeSetting(const CommandRow& row, const Command& command)
{
    if (isRow(row, commandRow("set-parameter"))) {
        const int number = byteAt(command.data, 0);
        return QCoreApplication::translate("Packets", "Set parameter %1 to %2")
            .arg(parameterName(number), parameterValue(number, byteAt(command.data, 1)));
    }
    const QString arguments = fieldsText(row.arguments, command.data);
    if (row.opcodeBits == OpcodeBits::Channel) {
        return QCoreApplication::translate("Packets", "Set calibration of channel %1: %2")
            .arg(QString::number(command.opcode - row.first + 1), arguments);
    }
    return QStringLiteral("%1: %2").arg(titleOf(row), arguments);
}

/// One value for each channel asked for: "1: 3637, 2: invalid, 5: 2715".
QString describeChannels(const CommandRow& row, int mask, QByteArrayView payload)
{
    const auto& field = row.reply.front();
    QStringList parts;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if ((mask >> (channel - 1) & 1) == 0) {
            continue;
        }
        const int raw = rawOf(field, payload.data());
        // A command of 0x86 kind: 0xFFFF is no pulse and never a number (conformance C-24).
        const bool isInvalid = field.kind == FieldKind::Word && raw == kInvalidPulse;
        parts << QStringLiteral("%1: %2").arg(
            QString::number(channel),
            isInvalid ? QCoreApplication::translate("Packets", "invalid") : textOf(field, raw));
        payload = payload.sliced(field.width());
    }
    return parts.join(QStringLiteral(", "));
}

QString modeText(QByteArrayView payload)
{
    const auto mode = parseMode(payload);
    if (!mode) {
        return QCoreApplication::translate("Packets", "unknown mode");
    }
    switch (*mode) {
    case Mode::Rc:
        return QCoreApplication::translate("Packets", "RC mode");
    case Mode::Analog:
        return QCoreApplication::translate("Packets", "analog mode");
    case Mode::SerialRc:
        return QCoreApplication::translate("Packets", "serial mode, RC inputs");
    case Mode::SerialAnalog:
        break;
    }
    return QCoreApplication::translate("Packets", "serial mode, analog inputs");
}

/// A reply of one field needs no label: the command has named it.
QString describeSingle(const Command& command, const CommandRow& row, QByteArrayView payload)
{
    const auto& field = row.reply.front();
    const auto decoded = decodeFields(row.reply, payload);
    const int raw = decoded.front().raw;
    if (isRow(row, commandRow("get-parameter"))) {
        return parameterValue(byteAt(command.data, 0), raw);
    }
    if (isRow(row, commandRow("get-mode"))) {
        return QStringLiteral("%1 (%2)").arg(decoded.front().text, modeText(payload));
    }
    if (field.kind == FieldKind::Byte && field.maximum == 1 && raw <= 1) {
        return raw == 0 ? QCoreApplication::translate("Packets", "no")
                        : QCoreApplication::translate("Packets", "yes");
    }
    return decoded.front().text;
}

} // namespace

QString describe(const Command& command)
{
    const CommandRow* const row = findCommand(command.opcode);
    if (row == nullptr) {
        return QCoreApplication::translate("Packets", "Unknown command %1")
            .arg(QString::number(command.opcode, 16).toUpper());
    }
    if (command.data.size() != argumentBytes(*row)) {
        return QCoreApplication::translate("Packets", "%1, malformed: %2")
            .arg(titleOf(*row), toHex(command.data));
    }
    switch (row->kind) {
    case CommandKind::Motor:
        return describeMotor(*row, command);
    case CommandKind::Setting:
        return describeSetting(*row, command);
    case CommandKind::Framing:
    case CommandKind::Query:
        break;
    }
    return describeQuery(*row, command);
}

QString describeReply(const Command& command, QByteArrayView payload)
{
    const CommandRow* const row = findCommand(command.opcode);
    const bool isSignature = row != nullptr && row->replyRule == ReplyRule::Signature;
    if (row == nullptr || payload.isEmpty() || command.data.size() != argumentBytes(*row)
        || (!isSignature && payload.size() != replyLength(command))) {
        return toHex(payload);
    }
    if (row->replyRule == ReplyRule::PerMaskBit) {
        return describeChannels(*row, byteAt(command.data, 0), payload);
    }
    return row->reply.size() == 1 ? describeSingle(command, *row, payload)
                                  : fieldsText(row->reply, payload);
}

} // namespace trex
