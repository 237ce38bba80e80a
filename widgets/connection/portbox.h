// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/transport/transportregistry.h"

#include <QComboBox>
#include <QTimer>

#include <functional>

namespace trex {

/// Where to connect: the simulated controller, the serial ports that are there now, or an address
/// that the person types. While visible the list follows plugging and unplugging; what is chosen
/// or half typed stays. GUI thread.
class PortBox : public QComboBox {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(PortBox)

public:
    using Lister = std::function<QList<PortInfo>()>;

    explicit PortBox(QWidget* parent = nullptr);

    /// The data of the item whose text is shown, else the text as typed.
    [[nodiscard]] QString address() const;
    /// Shows the item that has the address, else the address itself.
    void setAddress(const QString& address);
    void setNetworkAddress(const QString& address); ///< listed too: the tcp:// one used last
    [[nodiscard]] bool hasSerialPort() const { return !m_ports.isEmpty(); }
    /// The first serial port at a USB adapter; "" when there is none.
    [[nodiscard]] QString firstAdapter() const;
    void setLister(Lister lister); ///< availablePorts() unless told otherwise (tests)

public slots:
    void refresh();

signals:
    void addressEdited(const QString& address); ///< by the person: chosen or typed
    void portsChanged();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void fill();

    Lister m_lister;
    QList<PortInfo> m_ports;
    QString m_network;
    QTimer m_timer;
};

/// The simulated controller of the list; its sticks rest and sweep, so that calibration finds what
/// it needs.
[[nodiscard]] QString simulatorAddress();
/// "ttyUSB0" of "/dev/ttyUSB0"; the simulator by its name; anything else as it is.
[[nodiscard]] QString shortPortName(const QString& address);

} // namespace trex
