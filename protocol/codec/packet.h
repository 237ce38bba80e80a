// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/command.h"
#include "protocol/codec/linesettings.h"

namespace trex {

/// A command framed for the line: compact `opcode data…` or Pololu `0x80 device opcode&0x7F
/// data…`, and with CRC-7 on, one more byte over all of it (serial protocols; conformance C-02,
/// C-03, C-13).
[[nodiscard]] QByteArray encode(const Command& command, const LineSettings& settings);

struct DecodedPacket {
    Command command;
    PacketForm form = PacketForm::Compact;
    std::uint8_t device = kDefaultDeviceNumber;
};
/// The command in a framed packet (for the packet view and tests). Errors: BadCommand, BadReplyCrc.
[[nodiscard]] Result<DecodedPacket> decodePacket(QByteArrayView packet,
                                                 const LineSettings& settings);

/// Upper-case hex without spaces, as `trexctl` prints what it sent.
[[nodiscard]] QString toHex(QByteArrayView bytes);

} // namespace trex
