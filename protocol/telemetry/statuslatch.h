// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/quantities.h"

#include <QDateTime>
#include <QObject>

#include <array>

namespace trex {

/// Own history of the latched bits of the status byte (0x84) and the UART error byte (0x85).
/// Reading clears them in the controller, so that what was read is kept here and never lost
/// (conformance C-22). Main thread.
class StatusLatch : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(StatusLatch)

public:
    enum class Byte : std::uint8_t { Status, Uart };
    struct Entry {
        bool lit = false; ///< set in the latest read
        int count = 0; ///< reads in which it was set
        QDateTime firstSeen;
        QDateTime lastSeen;
    };
    explicit StatusLatch(QObject* parent = nullptr) : QObject(parent) { }

    void record(Byte byte, std::uint8_t bits, Instant time);
    [[nodiscard]] const Entry& entry(Byte byte, int bit) const;
    [[nodiscard]] std::optional<Instant> lastRead(Byte byte) const; ///< none: never
    void clear(); ///< forgets counts and times (the person's "clear"), not the controller's bits
    /// For a recording: what was known at `now`, on the wall clock of then.
    struct Shown {
        std::array<std::array<Entry, 8>, 2> entries; ///< by Byte and bit
        std::array<std::optional<Instant>, 2> lastRead;
        QDateTime now;
    };
    void show(const Shown& shown);
    [[nodiscard]] QDateTime now() const; ///< on the clock of firstSeen and lastSeen
    void linkLost(); ///< lit is no longer known: lastRead() becomes none, counts stay

signals:
    void changed();

private:
    std::array<std::array<Entry, 8>, 2> m_entries;
    std::array<std::optional<Instant>, 2> m_lastRead;
    QDateTime m_now; ///< invalid: the wall clock's
};

} // namespace trex
