// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of the way between this computer and the line. Plain values.
#pragma once

#include <QString>

#include <optional>

namespace trex {

struct AdapterFacts {
    enum class Kind : std::uint8_t { Unknown, Serial, PseudoTerminal, Network, Simulator };
    /// Whether the driver hands bytes on at once (ASYNC_LOW_LATENCY), as it was asked to.
    enum class LowLatency : std::uint8_t {
        NotAsked, ///< nothing to ask: no serial port, or another system than Linux
        Granted, ///< asked for, and read back as set
        Refused, ///< the system did not allow it
        Unknown, ///< the driver knows nothing of it
    };
    Kind kind = Kind::Unknown;
    LowLatency lowLatency = LowLatency::NotAsked;
    QString port{}; ///< the device's own name ("ttyUSB0"), links followed; empty: none
    QString driver{}; ///< "ftdi_sio"; empty: not known
    std::optional<int> latencyTimerMs{}; ///< how long the adapter gathers bytes, where it tells
    QString timerFile{}; ///< where that is set, by the superuser; empty: nowhere
    bool operator==(const AdapterFacts&) const = default;
};

/// Driver and latency timer of an open port, as the system tells (`system`: where sysfs is). What
/// cannot be read stays unknown.
[[nodiscard]] AdapterFacts readAdapterFacts(const QString& port,
                                            const QString& system = QStringLiteral("/sys"));
/// Which program has this device open: "minicom, process 1234"; empty when the system does not tell
/// (another person's program). `processes`: where procfs is. Leaves this process out.
[[nodiscard]] QString portHolder(const QString& port,
                                 const QString& processes = QStringLiteral("/proc"));

} // namespace trex
