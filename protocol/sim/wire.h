// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as levels on a wire: what a receiver makes of them that listens at another speed or parity.
#pragma once

#include "protocol/codec/linesettings.h"

#include <deque>
#include <vector>

namespace trex::sim {

/// One side's UART. CRC-7 is no matter of the wire: eight bits, no parity (guide 5.a).
struct UartFormat {
    int baud = 19200;
    ErrorDetection detection = ErrorDetection::None;
    int stopBits = 1;
    [[nodiscard]] bool hasCrc() const { return detection == ErrorDetection::Crc7; }
    [[nodiscard]] bool hasParity() const;
    [[nodiscard]] int bits() const { return 9 + (hasParity() ? 1 : 0) + stopBits; }
    [[nodiscard]] Duration timeOf(int bitCount) const;
    [[nodiscard]] Duration byteTime() const { return timeOf(bits()); }
    bool operator==(const UartFormat&) const = default;
};

struct ReceivedByte {
    std::uint8_t value = 0;
    bool frameError = false; ///< no stop bit where one was due
    bool parityError = false;
};

/// A received byte with its times: start of the start bit, and when the UART hands it over.
struct SampledByte {
    ReceivedByte byte;
    Instant begin;
    Instant end;
};

/// Plays a sender's frames on a wire that rests high, and samples them as a receiver does: start
/// at a falling edge, then each bit in its middle, one stop bit looked at.
class WireSampler {
public:
    WireSampler() = default;
    WireSampler(const UartFormat& sender, const UartFormat& receiver);

    /// Speeds within 3 % and the same parity: bytes pass unchanged.
    [[nodiscard]] bool isTransparent() const { return m_transparent; }
    /// A byte whose start bit begins then; appends what the receiver has finished.
    void feed(std::uint8_t value, Instant begin, std::vector<SampledByte>& out);
    /// The wire is known to rest until `until` unless fed bytes say otherwise.
    void settle(Instant until, std::vector<SampledByte>& out);

private:
    struct Frame {
        Instant begin;
        std::uint16_t levels; ///< bit 0 is the start bit
    };
    [[nodiscard]] bool level(Instant at) const;
    [[nodiscard]] std::optional<Instant> fallingEdge(Instant from) const;
    [[nodiscard]] SampledByte sample(Instant begin) const;

    UartFormat m_sender;
    UartFormat m_receiver;
    bool m_transparent = true;
    std::deque<Frame> m_frames;
    Instant m_from; ///< the receiver looks for its next start bit from here
};

} // namespace trex::sim
