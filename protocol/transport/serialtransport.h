// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/transport/transport.h"

#include <QSerialPort>

namespace trex {

/// A serial port of the system, or a pseudo-terminal that knows neither modem lines nor parity.
class SerialTransport : public Transport {
    Q_OBJECT

public:
    explicit SerialTransport(const QString& port, QObject* parent = nullptr);

    void open(const LineSettings& settings) override;
    void close() override;
    bool setLine(const LineSettings& settings) override;
    [[nodiscard]] bool canSetLine() const override { return true; }
    void write(const QByteArray& bytes) override;
    bool waitForBytes(Duration longest) override;
    [[nodiscard]] int descriptor() const override;
    [[nodiscard]] AdapterFacts adapter() const override { return m_adapter; }

private:
    void onReadyRead();
    void onError(QSerialPort::SerialPortError error);
    [[nodiscard]] bool isTaken() const;
    void noteAdapter(const QString& path);
    [[nodiscard]] AdapterFacts::LowLatency askForLowLatency() const;

    QString m_name;
    QSerialPort m_port;
    bool m_isOpen = false;
    AdapterFacts m_adapter;
    quint64 m_reads = 0; ///< tells waitForBytes() that something came
};

} // namespace trex
