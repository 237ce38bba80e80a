// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/linesettings.h"
#include "protocol/session/transaction.h"

#include <QCoreApplication>

namespace trex {

/// Kinds of transactions that the packet view can be narrowed to.
enum class PacketClass : std::uint8_t { All, Motors, Settings, Queries, Polls, Errors };

/// One row of the packet view: an attempt on the wire, and what is needed to explain it.
struct PacketEntry {
    Q_DECLARE_TR_FUNCTIONS(trex::PacketEntry)

public:
    TransactionRecord record;
    double seconds = 0.0; ///< since the connection was opened
    bool hasCrc = false; ///< the reply's last byte is its CRC-7
    bool isDecoded = true; ///< false: raw bytes that are no packet of this line

    PacketEntry() = default;
    PacketEntry(TransactionRecord taken, const LineSettings& line, double secondsSinceOpened);

    [[nodiscard]] const CommandRow* row() const; ///< null: raw bytes that are no packet
    [[nodiscard]] QString sentHex() const; ///< "86 1F"
    [[nodiscard]] QString receivedHex() const; ///< "–" where nothing came
    [[nodiscard]] QString meaning() const; ///< "Get mode: r (serial mode, RC inputs)"
    [[nodiscard]] QString roundTrip() const; ///< "3.1"; "–" where no reply was due or none came
    [[nodiscard]] QString note() const; ///< what went wrong, which attempt; "" when nothing
    [[nodiscard]] bool isOf(PacketClass kind) const;
    /// Anywhere in meaning, hex (with or without spaces) or the command's key; `needle` in lower
    /// case.
    [[nodiscard]] bool contains(const QString& needle) const;
};

[[nodiscard]] QString spacedHex(const QByteArray& bytes); ///< "86 1F"

} // namespace trex
