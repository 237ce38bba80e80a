// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/packetreader.h"

namespace trex::sim {
namespace {

constexpr std::uint8_t kExpanded = 0x80;
constexpr std::uint8_t kNull = 0xFF; // facts.md 4: used to find out about echo
constexpr std::uint8_t kCommandBit = 0x80;

} // namespace

CrcTable::CrcTable(std::uint8_t polynomial)
{
    for (unsigned i = 0; i < m_table.size(); ++i) {
        unsigned remainder = (i & 0x80U) != 0U ? i ^ polynomial : i;
        for (int bit = 1; bit < 8; ++bit) {
            remainder <<= 1U;
            if ((remainder & 0x80U) != 0U) {
                remainder ^= polynomial;
            }
        }
        m_table[i] = static_cast<std::uint8_t>(remainder & 0x7FU);
    }
}

// The quick command list of the command documentation, and the texts below it.
int dataBytesOf(std::uint8_t command)
{
    if ((command >= 0x81 && command <= 0x85) || (command >= 0x8D && command <= 0x95)) {
        return 0;
    }
    if (command == 0x86 || command == 0x87 || command == 0x9F) {
        return 1;
    }
    if (command >= 0xA0 && command <= 0xA4) {
        return 10;
    }
    if (command == 0xAF) {
        return 4;
    }
    if (command >= 0xC0 && command <= 0xCF) {
        return 1;
    }
    if (command >= 0xD0 && command <= 0xEF) {
        return 2;
    }
    return command == 0xF0 || command == 0xF1 ? 1 : -1;
}

void PacketReader::configure(bool withCrc, std::uint8_t polynomial)
{
    m_withCrc = withCrc;
    m_crc = CrcTable(polynomial);
    m_state = State::Idle;
    m_size = 0;
}

bool PacketReader::abandon()
{
    const bool wasOpen = m_state != State::Idle && m_state != State::Foreign;
    m_state = State::Idle;
    return wasOpen;
}

PacketReader::Outcome PacketReader::feed(std::uint8_t byte)
{
    if ((byte & kCommandBit) != 0) {
        // A command byte inside a packet is a format error and starts a new one (C-08); after
        // another device's packet it is no error (C-05).
        const bool inside = m_state != State::Idle && m_state != State::Foreign;
        Outcome outcome = begin(byte);
        outcome.formatError = outcome.formatError || inside;
        return outcome;
    }
    switch (m_state) {
    case State::Idle: // C-54: ignored
    case State::Foreign:
        return {};
    case State::Number:
        append(byte);
        m_state = byte == m_device ? State::Command : State::Foreign;
        return {};
    case State::Command:
        append(byte);
        return take(byte | kCommandBit);
    case State::Data:
        append(byte);
        return m_size == m_wanted ? finish() : Outcome{};
    }
    return {};
}

PacketReader::Outcome PacketReader::begin(std::uint8_t byte)
{
    m_size = 0;
    append(byte);
    if (byte == kExpanded) {
        m_state = State::Number;
        return {};
    }
    return take(byte);
}

PacketReader::Outcome PacketReader::take(std::uint8_t command)
{
    m_command = command;
    m_header = m_size;
    m_state = State::Idle;
    if (command == kNull) {
        return {.isNull = true}; // a CRC byte that may follow has no open packet (C-54)
    }
    const int dataBytes = dataBytesOf(command);
    if (dataBytes < 0) {
        return {.formatError = true}; // C-07
    }
    m_wanted = m_header + static_cast<std::size_t>(dataBytes) + (m_withCrc ? 1 : 0);
    if (m_wanted == m_size) {
        return {.isComplete = true};
    }
    m_state = State::Data;
    return {};
}

PacketReader::Outcome PacketReader::finish()
{
    m_state = State::Idle;
    if (m_withCrc) {
        std::uint8_t crc = 0;
        for (std::size_t i = 0; i + 1 < m_size; ++i) {
            crc = m_crc.step(crc, m_bytes[i]);
        }
        if (crc != m_bytes[m_size - 1]) {
            return {.crcError = true}; // C-15
        }
    }
    return {.isComplete = true};
}

void PacketReader::append(std::uint8_t byte)
{
    if (m_size < kLargest) {
        m_bytes[m_size++] = byte;
    }
}

} // namespace trex::sim
