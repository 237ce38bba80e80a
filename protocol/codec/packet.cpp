// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/packet.h"

#include "protocol/codec/crc7.h"

namespace trex {
namespace {

constexpr std::uint8_t kStartByte = commandRow("pololu-packet").first;
constexpr std::uint8_t kCommandBit = 0x80;

std::uint8_t byteAt(QByteArrayView bytes, qsizetype index)
{
    return static_cast<std::uint8_t>(bytes[index]);
}

} // namespace

QByteArray encode(const Command& command, const LineSettings& settings)
{
    QByteArray packet;
    packet.reserve(command.data.size() + 4);
    if (settings.form == PacketForm::Pololu) {
        packet.append(static_cast<char>(kStartByte));
        packet.append(static_cast<char>(settings.device));
        packet.append(static_cast<char>(command.opcode & ~kCommandBit));
    } else {
        packet.append(static_cast<char>(command.opcode));
    }
    packet.append(command.data);
    if (settings.hasCrc()) {
        packet.append(static_cast<char>(crc7(packet, settings.polynomial)));
    }
    return packet;
}

Result<DecodedPacket> decodePacket(QByteArrayView packet, const LineSettings& settings)
{
    QByteArrayView rest = packet;
    if (settings.hasCrc()) {
        if (rest.size() < 2) {
            return fail(ErrorCode::BadCommand, toHex(packet));
        }
        rest.chop(1);
        if (crc7(rest, settings.polynomial) != byteAt(packet, packet.size() - 1)) {
            return fail(ErrorCode::BadReplyCrc, toHex(packet));
        }
    }
    DecodedPacket decoded;
    decoded.device = settings.device;
    if (rest.isEmpty()) {
        return fail(ErrorCode::BadCommand, toHex(packet));
    }
    if (byteAt(rest, 0) == kStartByte) {
        if (rest.size() < 3 || byteAt(rest, 1) >= kCommandBit || byteAt(rest, 2) >= kCommandBit) {
            return fail(ErrorCode::BadCommand, toHex(packet));
        }
        decoded.form = PacketForm::Pololu;
        decoded.device = byteAt(rest, 1);
        decoded.command.opcode = byteAt(rest, 2) | kCommandBit;
        rest = rest.sliced(3);
    } else {
        decoded.command.opcode = byteAt(rest, 0);
        rest = rest.sliced(1);
    }
    const CommandRow* const row = findCommand(decoded.command.opcode);
    const bool isData = std::ranges::none_of(
        rest, [](char byte) { return static_cast<std::uint8_t>(byte) >= kCommandBit; });
    if (row == nullptr || row->kind == CommandKind::Framing || !isData
        || rest.size() != argumentBytes(*row)) {
        return fail(ErrorCode::BadCommand, toHex(packet));
    }
    decoded.command.data = rest.toByteArray();
    return decoded;
}

QString toHex(QByteArrayView bytes)
{
    return QString::fromLatin1(bytes.toByteArray().toHex().toUpper());
}

} // namespace trex
