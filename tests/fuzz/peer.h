// SPDX-License-Identifier: GPL-3.0-or-later
// The controller's side for targets that need one, apart from the product's codec and simulator.
#pragma once

#include "protocol/codec/command.h"
#include "protocol/codec/linesettings.h"
#include "protocol/codec/replyparser.h"
#include "tests/fuzz/fuzzing.h"

namespace trex::fuzz {

/// CRC-7 by long division, bit by bit, apart from the product's tables.
inline int slowCrc(QByteArrayView bytes, int polynomial)
{
    int remainder = 0;
    for (qsizetype i = 0; i <= bytes.size(); ++i) { // seven bits of zero at the end
        const bool isEnd = i == bytes.size();
        const int byte = isEnd ? 0 : static_cast<std::uint8_t>(bytes[i]);
        for (int bit = 7; bit >= (isEnd ? 1 : 0); --bit) {
            remainder = remainder << 1 | (byte >> bit & 1);
            remainder ^= (remainder & 0x80) != 0 ? polynomial : 0;
        }
    }
    return remainder;
}

inline QByteArray withCrc(QByteArray payload, const LineSettings& line)
{
    if (line.hasCrc() && !payload.isEmpty()) {
        payload += static_cast<char>(slowCrc(payload, line.polynomial));
    }
    return payload;
}

/// What a controller in serial mode says, more or less, as it is on the wire.
inline QByteArray honestReply(const Command& command, const LineSettings& line)
{
    QByteArray payload(replyLength(command), '\0');
    if (command.opcode == 0x81) {
        payload = "TReXJr1.2";
    } else if (command.opcode == 0x82) {
        payload = "r";
    } else if (command.opcode == 0x83) {
        payload = "\1";
    } else if (command.opcode == 0x86) {
        payload = QByteArray("\xA6\x0E", 2).repeated(5).left(payload.size());
    }
    return withCrc(payload, line);
}

inline LineSettings anyLine(Input& input)
{
    LineSettings line;
    const int bits = input.byte();
    line.errorDetection = static_cast<ErrorDetection>(bits & 3);
    line.form = static_cast<PacketForm>(bits >> 2 & 1);
    line.echo = static_cast<EchoMode>((bits >> 3 & 3) % 3);
    line.polynomial = (bits & 0x20) != 0 ? std::uint8_t(input.byte() | 0x80) : kDefaultPolynomial;
    line.device = (bits & 0x40) != 0 ? std::uint8_t(input.byte() & 0x7F) : kDefaultDeviceNumber;
    line.baud = (bits & 0x80) != 0 ? kBaudRates[std::size_t(input.below(11))] : 19200;
    line.timeout = std::chrono::milliseconds(10 + input.byte());
    return line;
}

} // namespace trex::fuzz
