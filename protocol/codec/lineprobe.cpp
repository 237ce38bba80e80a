// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/lineprobe.h"

#include "protocol/codec/packet.h"

#include <algorithm>

namespace trex {
namespace {

/// CRC bytes after which a query is no motor command at any other speed, as a set of 128 bits; by
/// the model of tst_linebits.cpp.
struct CleanCrc {
    int baud;
    std::string_view query;
    int guard; ///< speed of a null command between query and CRC byte; 0: none
    std::array<std::uint64_t, 2> bytes;
};
constexpr std::uint64_t kEvery = ~std::uint64_t{0};
// At each speed the most harmless first: get-status clears what it reads.
constexpr std::array kCleanCrc = std::to_array<CleanCrc>({
    {1200, "get-mode", 0, {kEvery, kEvery}},
    {2400, "get-mode", 0, {0xFDF5'FF55'FDF5'FDFF, 0xFFFF'FFFF'FFFF'FDFF}},
    {2400, "get-status", 0, {0xFDF5'FF55'FDF5'FDFF, 0xFFFF'FFFF'FFFF'FDFF}},
    {4800, "get-mode", 0, {0xFDF5'CC55'CCC4'CCCF, 0xFFFF'FFFF'CCCC'FDCF}},
    {4800, "get-status", 0, {0xFDF5'FF55'FDF5'FDFF, 0xFFFF'FFFF'FFFF'FDFF}},
    {9600, "get-mode", 0, {0xFDF5'CC55'CCC4'CCCF, 0xFFFF'FFFF'CCCC'FDCF}},
    {9600, "get-status", 0, {0xFDF5'FF55'FDF5'FDFF, 0xFFFF'FFFF'FFFF'FDFF}},
    {14400, "get-mode", 0, {0x5105'0015'5105'1115, 0xFDF5'BD55'FDF5'1155}},
    {14400, "get-calibration", 57600, {0x5105'0015'5105'1115, 0xFDF5'BD55'FDF5'1155}},
    {14400, "get-status", 0, {0x5105'0015'5105'1115, 0xFDF5'B955'FDF5'1155}},
    {19200, "get-mode", 0, {0xFDF5'CC55'CCC4'CCCF, 0xFFFF'FFFF'CCCC'FDCF}},
    {19200, "get-status", 0, {0xFDF5'FF55'FDF5'FDFF, 0xFFFF'FFFF'FFFF'FDFF}},
    {28800, "get-mode", 0, {0xFFBF'BFBF'FFBF'BFBF, 0xFFFF'BFFF'FFFF'BFFF}},
    {28800, "get-status", 0, {0xFFBF'BBBF'FFBF'BBBF, 0xFFFF'BBFF'FFFF'BBFF}},
    {38400, "get-mode", 0, {0xFFFF'CCFF'CCCC'CCCF, 0xFFFF'FFFF'CCCC'FFCF}},
    {38400, "get-status", 0, {kEvery, kEvery}},
    {57600, "get-mode", 0, {kEvery, kEvery}},
    {76800, "get-mode", 0, {kEvery, kEvery}},
    {115200, "get-mode", 0, {kEvery, kEvery}},
});

constexpr char kNullCommand = '\xFF'; // conformance C-56

/// As questions go out: one form, whatever the line is used for later.
LineSettings compact(LineSettings line)
{
    line.form = PacketForm::Compact;
    return line;
}

bool isIn(const std::array<std::uint64_t, 2>& set, std::uint8_t byte)
{
    return byte < 128 && (set.at(byte / 64) >> (byte % 64) & 1U) != 0U;
}

WirePiece at(int baud, char byte)
{
    LineSettings line;
    line.baud = baud;
    line.stopBits = 2;
    return {line, QByteArray(1, byte)};
}

LineProbe crcProbe(const LineSettings& line)
{
    for (const CleanCrc& row : kCleanCrc) {
        if (row.baud != line.baud) {
            continue;
        }
        const Command asked = query(row.query);
        const QByteArray packet = encode(asked, line);
        if (!isIn(row.bytes, static_cast<std::uint8_t>(packet.back()))) {
            continue;
        }
        LineProbe probe{asked, {{line, packet}}, true, false};
        if (row.guard != 0) {
            probe.pieces = {
                {line, packet.first(1)}, at(row.guard, kNullCommand), {line, packet.sliced(1)}};
        }
        return probe;
    }
    const Command asked = query("get-mode");
    return {asked, {{line, encode(asked, line)}}, false, false};
}

} // namespace

LineProbe lineProbe(const LineSettings& line)
{
    const LineSettings wired = compact(line);
    if (wired.hasCrc()) {
        return crcProbe(wired);
    }
    const Command asked = query("get-mode");
    return {
        asked, {{wired, encode(asked, wired)}}, true, line.errorDetection != ErrorDetection::Even};
}

std::vector<WirePiece> lineClearing()
{
    const Command asked = query("get-serial-control");
    const char control = encode(asked, {}).front();
    const char mode = encode(query("get-mode"), {}).front();
    // Found by search over all sequences of these bytes (see tst_linebits.cpp).
    return {at(57600, kNullCommand), at(28800, mode),         at(9600, kNullCommand),
            at(1200, kNullCommand),  at(14400, kNullCommand), at(115200, kNullCommand),
            at(1200, control)};
}

} // namespace trex
