// SPDX-License-Identifier: GPL-3.0-or-later
// The controller's end of the packet forms: bytes in, whole packets and errors out. Read from the
// vendor's documents on its own; shares nothing with the host's codec.
#pragma once

#include "protocol/codec/quantities.h"

#include <array>
#include <cstdint>

namespace trex::sim {

/// CRC-7 by table, as guide 5.f builds it: step is table[(crc << 1) ^ byte], from 0.
class CrcTable {
public:
    explicit CrcTable(std::uint8_t polynomial = 0x89);
    [[nodiscard]] std::uint8_t step(std::uint8_t crc, std::uint8_t byte) const
    {
        return m_table[static_cast<std::uint8_t>((crc << 1) ^ byte)];
    }

private:
    std::array<std::uint8_t, 256> m_table{};
};

/// How many data bytes follow a command; −1: there is no such command.
[[nodiscard]] int dataBytesOf(std::uint8_t command);

class PacketReader {
public:
    static constexpr std::size_t kLargest = 16;
    struct Outcome {
        bool formatError = false;
        bool crcError = false;
        bool isNull = false; ///< 0xFF, in either form
        bool isComplete = false; ///< command(), data() and bytes() hold a packet to obey
    };

    void configure(bool withCrc, std::uint8_t polynomial);
    void setDevice(std::uint8_t number) { m_device = number; }
    Outcome feed(std::uint8_t byte);
    /// Forgets an open packet (a byte of it was unreadable). True when there was one.
    bool abandon();

    [[nodiscard]] std::uint8_t command() const { return m_command; }
    [[nodiscard]] std::uint8_t data(std::size_t i) const { return m_bytes[m_header + i]; }
    /// As received, with header and CRC byte: the last packet, good or bad.
    [[nodiscard]] const std::uint8_t* bytes() const { return m_bytes.data(); }
    [[nodiscard]] std::size_t size() const { return m_size; }

private:
    enum class State : std::uint8_t { Idle, Number, Command, Data, Foreign };
    Outcome begin(std::uint8_t byte);
    Outcome take(std::uint8_t command);
    Outcome finish();
    void append(std::uint8_t byte);

    CrcTable m_crc;
    bool m_withCrc = false;
    std::uint8_t m_device = 7;
    State m_state = State::Idle;
    std::uint8_t m_command = 0;
    std::size_t m_header = 0; ///< bytes up to and with the command
    std::size_t m_wanted = 0; ///< bytes of the whole packet
    std::size_t m_size = 0;
    std::array<std::uint8_t, kLargest> m_bytes{};
};

} // namespace trex::sim
