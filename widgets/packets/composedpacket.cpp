// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/composedpacket.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cctype>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

int byteAt(const QByteArray& bytes, qsizetype index)
{
    return static_cast<std::uint8_t>(bytes.at(index));
}

/// Bits 1:0 say the direction (command documentation, 0xC0).
MotorOrder orderOf(int bits, int amount, bool isAccelerate)
{
    const auto action = isAccelerate ? MotorOrder::Action::Accelerate : MotorOrder::Action::Set;
    switch (static_cast<MotorDirection>(bits & 3)) {
    case MotorDirection::Forward:
        return {action, amount};
    case MotorDirection::Reverse:
        return {action, -amount};
    case MotorDirection::Brake:
    case MotorDirection::BrakeAlternate:
        break;
    }
    return {MotorOrder::Action::Brake, amount};
}

GateOrder candidateOf(const Command& command)
{
    const CommandRow& row = command.row();
    const auto is = [&row](const CommandRow& other) { return &row == &other; };
    const bool isAccelerate = is(commandRow("accelerate-motor1"))
        || is(commandRow("accelerate-motor2")) || is(commandRow("accelerate-motors"))
        || is(commandRow("accelerate-aux"));
    GateOrder order;
    if (row.opcodeBits == OpcodeBits::DirectionPair) {
        order.isBoth = true;
        order.first = orderOf(command.opcode, byteAt(command.data, 0), isAccelerate);
        order.second = orderOf(command.opcode >> 2, byteAt(command.data, 1), isAccelerate);
    } else if (row.opcodeBits == OpcodeBits::Direction) {
        const bool isSecond = is(commandRow("set-motor2")) || is(commandRow("accelerate-motor2"));
        order.motor = isSecond ? MotorId::Motor2 : MotorId::Motor1;
        order.first = orderOf(command.opcode, byteAt(command.data, 0), isAccelerate);
    } else {
        order.motor = MotorId::Aux;
        order.first = orderOf(static_cast<int>(MotorDirection::Forward), byteAt(command.data, 0),
                              isAccelerate);
    }
    return order;
}

} // namespace

Result<QByteArray> bytesFromHex(const QString& text)
{
    static const QRegularExpression kSeparators(u"[\\s,;]+"_s);
    QByteArray bytes;
    const QStringList groups = text.split(kSeparators, Qt::SkipEmptyParts);
    for (const QString& group : groups) {
        QString digits = group.startsWith("0x"_L1, Qt::CaseInsensitive) ? group.mid(2) : group;
        if (digits.size() == 1) {
            digits.prepend(u'0');
        }
        const auto isHex = [](QChar c) {
            return c.unicode() < 0x80
                && std::isxdigit(static_cast<unsigned char>(c.toLatin1())) != 0;
        };
        if (digits.isEmpty() || digits.size() % 2 != 0
            || !std::all_of(digits.cbegin(), digits.cend(), isHex)) {
            return fail(ErrorCode::BadCommand, group);
        }
        bytes.append(QByteArray::fromHex(digits.toLatin1()));
    }
    return bytes.isEmpty() ? Result<QByteArray>(fail(ErrorCode::BadCommand))
                           : Result<QByteArray>(bytes);
}

std::optional<GateOrder> gateOrderOf(const Command& command)
{
    if (!validate(command) || command.row().kind != CommandKind::Motor) {
        return std::nullopt;
    }
    const GateOrder order = candidateOf(command);
    const Result<Command> again =
        order.isBoth ? driveBoth(order.first, order.second) : driveMotor(order.motor, order.first);
    return again && *again == command ? std::optional(order) : std::nullopt;
}

} // namespace trex
