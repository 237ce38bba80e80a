// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/crc7.h"

#include "protocol/codec/linesettings.h"

#include <array>

namespace trex {
namespace {

/// The remainder of one byte with seven zero bits appended.
constexpr std::uint8_t remainderOf(unsigned byte, std::uint8_t polynomial)
{
    unsigned value = (byte & 0x80U) != 0U ? byte ^ polynomial : byte;
    for (int bit = 0; bit < 7; ++bit) {
        value <<= 1U;
        if ((value & 0x80U) != 0U) {
            value ^= polynomial;
        }
    }
    return static_cast<std::uint8_t>(value);
}

// User guide 5.f: a table built once makes a step of one look-up.
constexpr auto kDefaultTable = [] {
    std::array<std::uint8_t, 256> table{};
    for (unsigned byte = 0; byte < table.size(); ++byte) {
        table[byte] = remainderOf(byte, kDefaultPolynomial);
    }
    return table;
}();

} // namespace

std::uint8_t crc7(QByteArrayView bytes, std::uint8_t polynomial)
{
    std::uint8_t crc = 0;
    for (const char byte : bytes) {
        const auto index = static_cast<std::uint8_t>((crc << 1U) ^ static_cast<std::uint8_t>(byte));
        crc = polynomial == kDefaultPolynomial ? kDefaultTable[index]
                                               : remainderOf(index, polynomial);
    }
    return crc;
}

} // namespace trex
