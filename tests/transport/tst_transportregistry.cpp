// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/serialtransport.h"
#include "protocol/transport/simtransport.h"
#include "protocol/transport/tcptransport.h"
#include "protocol/transport/transportregistry.h"

#include <QTest>

using namespace trex;

class TestTransportRegistry : public QObject {
    Q_OBJECT

private slots:
    void address_makesItsTransport_data()
    {
        QTest::addColumn<QString>("address");
        QTest::addColumn<QByteArray>("type");
        const auto add = [](const char* address, const QMetaObject& type) {
            QTest::newRow(address) << QString::fromLatin1(address) << QByteArray(type.className());
        };
        add("/dev/ttyUSB0", SerialTransport::staticMetaObject);
        add("COM3", SerialTransport::staticMetaObject);
        add("ttyS0", SerialTransport::staticMetaObject);
        add("tcp://127.0.0.1:7000", TcpTransport::staticMetaObject);
        add("tcp://host.example:65535", TcpTransport::staticMetaObject);
        add("tcp://[::1]:7000", TcpTransport::staticMetaObject);
        add("sim:", SimTransport::staticMetaObject);
        add("sim:?mode=rc&seed=3&fault=drop=0.1&quirk=calibration-bytes=8",
            SimTransport::staticMetaObject);
    }
    void address_makesItsTransport()
    {
        QFETCH(QString, address);
        QFETCH(QByteArray, type);
        QVERIFY(checkAddress(address).has_value());
        const auto transport = makeTransport(address);
        QVERIFY(transport.has_value());
        QCOMPARE(QByteArray((*transport)->metaObject()->className()), type);
    }

    void badAddress_isRefused_data()
    {
        QTest::addColumn<QString>("address");
        for (const char* address :
             {"", "tcp:", "tcp://", "tcp://host", "tcp://host:", "tcp://host:0", "tcp://host:65536",
              "tcp://:7000", "tcp://host:7000/path", "tcp://host:7000?x=1", "sim:rc", "sim:?mode",
              "sim:?mode=fast", "sim:?colour=red", "sim:?seed=x", "sim:?fault=drop=2",
              "sim:?device=200"}) {
            QTest::addRow("\"%s\"", address) << QString::fromLatin1(address);
        }
    }
    void badAddress_isRefused()
    {
        QFETCH(QString, address);
        const auto check = checkAddress(address);
        QVERIFY(!check);
        const auto made = makeTransport(address);
        QVERIFY(!made);
        QCOMPARE(made.error(), check.error());
        QVERIFY(made.error().code == ErrorCode::PortAddress
                || made.error().code == ErrorCode::OutOfRange);
        QVERIFY(address.isEmpty() || !made.error().context.isEmpty());
    }

    void availablePorts_areInNaturalOrderAndCanBeMade()
    {
        for (const PortInfo& info : availablePorts()) {
            QVERIFY(!info.port.isEmpty());
            QVERIFY(makeTransport(info.port).has_value());
        }
    }
};

QTEST_APPLESS_MAIN(TestTransportRegistry)
#include "tst_transportregistry.moc"
