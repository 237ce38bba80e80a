// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/transport/transport.h"

#include <QList>
#include <QString>

#include <memory>

namespace trex {

/// A port that is present now, for lists that people choose from.
struct PortInfo {
    QString port; ///< what --port takes: /dev/ttyUSB0, COM3
    QString description;
    QString manufacturer;
    QString serialNumber;
    int vendorId = 0; ///< 0: unknown
    int productId = 0;
    bool operator==(const PortInfo&) const = default;
};

/// The serial ports present now, in natural order.
[[nodiscard]] QList<PortInfo> availablePorts();

/// The transport for an address: `tcp://host:port`, `sim:` with options, or a serial device's name.
/// Errors: PortAddress with what is wrong with it.
[[nodiscard]] Result<std::unique_ptr<Transport>> makeTransport(const QString& address);

/// Only the check that makeTransport does, for options and editors.
[[nodiscard]] Result<void> checkAddress(const QString& address);

} // namespace trex
