// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/transport/transport.h"

#include <QTcpSocket>
#include <QTimer>

namespace trex {

/// Raw TCP to a serial server (ser2net, socat) that has the port; baud and parity are set there.
class TcpTransport : public Transport {
    Q_OBJECT

public:
    TcpTransport(const QString& host, quint16 port, QObject* parent = nullptr);
    ~TcpTransport() override;

    void open(const LineSettings& settings) override;
    void close() override;
    void write(const QByteArray& bytes) override;
    bool waitForBytes(Duration longest) override;
    [[nodiscard]] int descriptor() const override;
    [[nodiscard]] AdapterFacts adapter() const override
    {
        return {.kind = AdapterFacts::Kind::Network};
    }

    /// Tried again half a second later: a peer that comes back is found within two seconds, since
    /// the system asks at once and after one second.
    static constexpr std::chrono::milliseconds kConnectTimeout{2000};
    static constexpr std::chrono::milliseconds kLongestUnheard{2000};

private:
    void onReadyRead();
    void onGone(ErrorCode code);

    QString m_host;
    quint16 m_port;
    QTcpSocket m_socket;
    QTimer m_connectTimer;
    bool m_isOpening = false;
    bool m_isOpen = false;
    quint64 m_reads = 0;
};

} // namespace trex
