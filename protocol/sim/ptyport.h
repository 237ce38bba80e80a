// SPDX-License-Identifier: GPL-3.0-or-later
// A pseudo-terminal whose far end any program can open like a serial port. Linux only; elsewhere
// open() says so.
#pragma once

#include "protocol/result.h"

#include <QByteArray>
#include <QString>

#include <optional>

namespace trex::sim {

class PtyPort {
public:
    PtyPort() = default;
    ~PtyPort();
    PtyPort(const PtyPort&) = delete;
    PtyPort& operator=(const PtyPort&) = delete;

    /// Makes the pair, raw from the start, and a symbolic link to its far end (no link when the
    /// name is empty). A link of that name is replaced, anything else is left alone: PortFailed.
    [[nodiscard]] Result<void> open(const QString& link);
    /// The far end hangs up for whoever has it open; the link is removed.
    void close();
    [[nodiscard]] bool isOpen() const { return m_master >= 0; }
    [[nodiscard]] int descriptor() const { return m_master; } ///< for a notifier
    [[nodiscard]] QString name() const; ///< what to open: the link, or the device

    [[nodiscard]] QByteArray read();
    /// Bytes that find no room (nobody reads) are lost, as on a wire.
    void write(QByteArrayView bytes);

    struct Speed {
        int baud = 0;
        int stopBits = 1;
        bool operator==(const Speed&) const = default;
    };
    /// What the program at the far end has set; none: it has set nothing. The parity never shows:
    /// the kernel strips it from pseudo-terminals.
    [[nodiscard]] std::optional<Speed> speed() const;

private:
    int m_master = -1;
    int m_slave = -1; ///< kept open, so that a program that closes does not end the pair
    QString m_device;
    QString m_link;
};

} // namespace trex::sim
