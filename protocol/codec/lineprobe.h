// SPDX-License-Identifier: GPL-3.0-or-later
// What may be asked on a line of which nobody knows that it is set right, and what is sent after
// it.
#pragma once

#include "protocol/codec/command.h"
#include "protocol/codec/linesettings.h"

#include <vector>

namespace trex {

/// Bytes that go out on a line set in their own way. Between two of them the line rests.
struct WirePiece {
    LineSettings line; ///< speed, parity and stop bits
    QByteArray bytes;
};

/// A controller at another speed hears a question as other bytes, and some of them are motor
/// commands: 0x81 at 19200 baud is 0xE0 at 115200, and `81 48` at 9600 is a complete order at 4800.
/// What is asked here was chosen with a model of the wire, bit by bit, for all pairs of speeds,
/// parities, tolerable clock errors, and whether a receiver takes, skips or stops at a byte that
/// failed its check (tests/procedures/tst_linebits.cpp shows that none hears a motor command):
/// - The question is get-mode (0x82), in the compact form: nothing in the controller changes by it,
///   no wrong speed makes a query of it, so that nobody else answers, and the answer is a letter.
///   An odd parity bit of it is 1, as a stop bit is: without parity it asks both.
/// - With CRC-7 its second byte may be readable as data. Where it is, get-status takes its place,
///   and at 14400 baud a calibration query with a null command (0xFF), too short for the controller
///   that is asked, between its bytes.
/// - What a question may leave open at other speeds is closed by lineClearing(): null commands and
///   get-serial-control. Without CRC-7 and even parity a question may be asked again before.
struct LineProbe {
    Command query;
    std::vector<WirePiece> pieces; ///< the question, the last of them ends it; the reply follows
    bool isClean = true; ///< false: with this polynomial none at this speed is free of orders
    bool mayRepeat = true; ///< before the line was cleared
};
[[nodiscard]] LineProbe lineProbe(const LineSettings& line);

/// What is sent, in this order and with rests, before a question at other settings, and when
/// nobody has answered. After it no receiver has a packet open that later questions could complete.
[[nodiscard]] std::vector<WirePiece> lineClearing();

/// After each piece, beyond its time on the wire, so that the slowest receiver is done with it:
/// eleven bits at 1200 baud take 9.2 ms.
inline constexpr std::chrono::milliseconds kWireRest{12};

} // namespace trex
