// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/transportregistry.h"

#include "protocol/sim/simoptions.h"
#include "protocol/transport/serialtransport.h"
#include "protocol/transport/simtransport.h"
#include "protocol/transport/tcptransport.h"

#include <QCollator>
#include <QSerialPortInfo>
#include <QUrl>

#include <array>

namespace trex {

namespace {

using namespace Qt::Literals::StringLiterals;
using Made = Result<std::unique_ptr<Transport>>;

Result<QUrl> tcpUrl(const QString& address)
{
    const QUrl url(address, QUrl::StrictMode);
    if (!url.isValid() || url.host().isEmpty() || url.port() <= 0 || !url.path().isEmpty()
        || url.hasQuery()) {
        return fail(ErrorCode::PortAddress, address);
    }
    return url;
}

Result<sim::SimOptions> simOptions(const QString& address)
{
    auto options = sim::simOptionsFromUrl(address);
    if (options && !address.contains("pace="_L1)) {
        options->pace = true; // in process it is to behave like a wire
    }
    return options;
}

Made makeTcp(const QString& address)
{
    return tcpUrl(address).map([](const QUrl& url) -> std::unique_ptr<Transport> {
        return std::make_unique<TcpTransport>(url.host(), static_cast<quint16>(url.port()));
    });
}

Made makeSim(const QString& address)
{
    return simOptions(address).map(
        [](const sim::SimOptions& options) -> std::unique_ptr<Transport> {
            return std::make_unique<SimTransport>(options);
        });
}

struct TransportRow {
    QLatin1StringView scheme;
    Made (*make)(const QString& address);
    Result<void> (*check)(const QString& address);
};

const std::array kTransports{
    TransportRow{"tcp:"_L1, makeTcp, [](const QString& a) { return tcpUrl(a).map([](auto&&) {}); }},
    TransportRow{"sim:"_L1, makeSim,
                 [](const QString& a) { return simOptions(a).map([](auto&&) {}); }},
};

const TransportRow* rowOf(const QString& address)
{
    for (const TransportRow& row : kTransports) {
        if (address.startsWith(row.scheme)) {
            return &row;
        }
    }
    return nullptr;
}

} // namespace

QList<PortInfo> availablePorts()
{
    QList<PortInfo> ports;
    for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts()) {
        ports.append({info.systemLocation(), info.description(), info.manufacturer(),
                      info.serialNumber(), info.vendorIdentifier(), info.productIdentifier()});
    }
    QCollator collator;
    collator.setNumericMode(true);
    std::sort(ports.begin(), ports.end(), [&](const PortInfo& a, const PortInfo& b) {
        return collator.compare(a.port, b.port) < 0;
    });
    return ports;
}

Result<std::unique_ptr<Transport>> makeTransport(const QString& address)
{
    if (address.isEmpty()) {
        return fail(ErrorCode::PortAddress, address);
    }
    if (const TransportRow* row = rowOf(address)) {
        return row->make(address);
    }
    return std::make_unique<SerialTransport>(address);
}

Result<void> checkAddress(const QString& address)
{
    if (address.isEmpty()) {
        return fail(ErrorCode::PortAddress, address);
    }
    const TransportRow* row = rowOf(address);
    return row != nullptr ? row->check(address) : Result<void>{};
}

} // namespace trex
