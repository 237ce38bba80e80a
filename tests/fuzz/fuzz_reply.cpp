// SPDX-License-Identifier: GPL-3.0-or-later
// The host's reading of single replies and packets: any bytes as the reply to any command, on any
// line, in any pieces; and any bytes as a packet.
#include "protocol/codec/packet.h"
#include "protocol/codec/polltable.h"
#include "protocol/codec/replies.h"
#include "protocol/codec/replyparser.h"
#include "protocol/session/transaction.h"
#include "tests/fuzz/peer.h"

using namespace trex;
using fuzz::holds;

namespace {

Command anyCommand(fuzz::Input& input)
{
    const auto choice = static_cast<std::size_t>(input.below(int(kCommands.size())));
    const CommandRow& row = kCommands[choice];
    Command command;
    command.opcode = static_cast<std::uint8_t>(row.first + input.below(row.last - row.first + 1));
    for (int i = 0; i < argumentBytes(row); ++i) {
        command.data.append(static_cast<char>(input.byte() & 0x7F));
    }
    return command;
}

LineSettings wireOf(fuzz::Input& input)
{
    LineSettings line;
    line.errorDetection = static_cast<ErrorDetection>(input.below(4));
    line.polynomial = static_cast<std::uint8_t>(input.byte() | 0x80);
    line.form = static_cast<PacketForm>(input.below(2));
    line.device = static_cast<std::uint8_t>(input.byte() & 0x7F);
    return line;
}

void checkPayload(const Command& command, const QByteArray& payload)
{
    const std::string_view key = command.row().key;
    (void)describeReply(command, payload);
    if (!isPlausible(command, payload)) {
        return;
    }
    if (key == "get-signature") {
        const auto signature = parseSignature(payload);
        holds(signature && signature->text().toLatin1() == payload,
              "a signature is read as it was sent");
    } else if (key == "get-mode") {
        const auto mode = parseMode(payload);
        holds(mode && letterOf(*mode) == payload[0], "a mode is read as it was sent");
    } else if (key == "get-calibration") {
        const Calibration read = parseCalibration(payload);
        holds(read.minimum <= read.neutral && read.neutral <= read.maximum,
              "a plausible calibration rises");
    } else if (key == "set-calibration" || key == "set-parameter") {
        holds(parseAnswer(payload).has_value() == (payload[0] == 0), "0 alone is success");
    }
    for (const PollRow& row : kPolls) {
        if (pollCommand(row.id) == command) {
            const PollSample sample = decodePoll(row.id, payload, Instant{});
            holds(row.commandKey != "get-raw-channels"
                      || sample.raw[4]
                          == (std::uint8_t(payload[8]) | std::uint8_t(payload[9]) << 8),
                  "low byte first");
        }
    }
}

void readAsReply(const Command& command, const LineSettings& line, const QByteArray& bytes,
                 int piece)
{
    ReplyParser whole(command, line);
    const int used = whole.feed(bytes);
    ReplyParser pieces(command, line);
    int usedInPieces = 0;
    for (qsizetype i = 0; i < bytes.size(); i += piece) {
        usedInPieces += pieces.feed(bytes.mid(i, piece));
    }
    holds(used <= bytes.size() && used == usedInPieces && whole.verdict() == pieces.verdict()
              && whole.payload() == pieces.payload(),
          "a reply is the same in whatever pieces it comes");
    if (whole.verdict() != ReplyParser::Verdict::Complete || whole.expectedBytes() == 0) {
        return;
    }
    const QByteArray payload = whole.payload();
    holds(payload == bytes.first(used - (line.hasCrc() ? 1 : 0)), "a payload is what came");
    holds(!line.hasCrc()
              || fuzz::slowCrc(payload, line.polynomial) == std::uint8_t(bytes[used - 1]),
          "no reply is complete with a wrong CRC");
    checkPayload(command, payload);
}

void readAsPacket(const LineSettings& line, const QByteArray& bytes)
{
    const auto packet = decodePacket(bytes, line);
    if (!packet) {
        return;
    }
    LineSettings same = line;
    same.form = packet->form;
    same.device = packet->device;
    holds(encode(packet->command, same) == bytes, "a packet is what its command is sent as");
    (void)describe(packet->command);
    if (validate(packet->command)) {
        holds(!describe(packet->command).isEmpty(), "a command has words");
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const LineSettings line = wireOf(input);
    const Command command = anyCommand(input);
    const int piece = 1 + input.below(4);
    const QByteArray bytes = input.rest();
    readAsReply(command, line, bytes, piece);
    readAsPacket(line, bytes);
    return 0;
}
