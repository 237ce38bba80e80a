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

private:
    void onReadyRead();
    void onError(QSerialPort::SerialPortError error);
    void askForLowLatency();

    QString m_name;
    QSerialPort m_port;
    bool m_isOpen = false;
    quint64 m_reads = 0; ///< tells waitForBytes() that something came
};

} // namespace trex
