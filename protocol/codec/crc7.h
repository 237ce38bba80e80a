// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArrayView>

#include <cstdint>

namespace trex {

/// CRC-7 as the TReX computes it: most significant bit first, start 0, seven zero bits appended,
/// remainder in bits 6:0 (user guide 5.e; conformance C-14). `polynomial` has eight bits with the
/// top one set; 0x89 is the controller's default.
[[nodiscard]] std::uint8_t crc7(QByteArrayView bytes, std::uint8_t polynomial);

} // namespace trex
