// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/command.h"
#include "protocol/codec/linesettings.h"

namespace trex {

/// Length of the reply to a command, without CRC byte; 0: no reply at all (not even a CRC byte,
/// conformance C-69). For 0x81 the longest (9): the parser finds out by prefix.
[[nodiscard]] int replyLength(const Command& command);

/// Collects the reply to one command. Pure: bytes in, verdict out. Echo is taken off before.
class ReplyParser {
public:
    enum class Verdict : std::uint8_t { NeedMore, Complete, BadCrc };
    ReplyParser() = default;
    ReplyParser(const Command& command, const LineSettings& settings);

    /// Takes bytes up to the reply's end and says how many it used; the rest is surplus.
    int feed(QByteArrayView bytes);
    [[nodiscard]] Verdict verdict() const { return m_verdict; }
    /// Reply bytes without the CRC byte; whole only when complete.
    [[nodiscard]] QByteArray payload() const;
    [[nodiscard]] const QByteArray& received() const { return m_received; } ///< with CRC byte
    [[nodiscard]] int expectedBytes() const { return m_expected; } ///< with CRC byte

private:
    void judge();
    QByteArray m_received;
    std::uint8_t m_opcode = 0;
    std::uint8_t m_polynomial = kDefaultPolynomial;
    bool m_hasCrc = false;
    int m_expected = 0;
    Verdict m_verdict = Verdict::Complete;
};

} // namespace trex
