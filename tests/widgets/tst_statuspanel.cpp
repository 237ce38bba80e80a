// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/panelbench.h"
#include "widgets/common/indicator.h"
#include "widgets/log/logpanel.h"
#include "widgets/status/statuspanel.h"

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

class TestStatusPanel : public QObject {
    Q_OBJECT

private slots:
    void unconnected_showsDashesAndStaleLamps()
    {
        test::PanelBench<StatusPanel> bench;
        for (const QString& name : {u"status.signature"_s, u"status.firmware"_s, u"status.mode"_s,
                                    u"status.serialControls"_s, u"status.calibrated"_s}) {
            QCOMPARE(bench.part<QLabel>(name)->text(), u"–"_s);
        }
        QVERIFY(bench.part<Indicator>(u"status.motor1Fault"_s)->isStale());
    }

    void mode_isShown_data()
    {
        QTest::addColumn<QString>("port");
        QTest::addColumn<QString>("mode");
        QTest::addColumn<QString>("control");
        QTest::newRow("serial") << u"sim:"_s << u"Serial (RC)"_s
                                << u"serial orders (serial mode)"_s;
        QTest::newRow("analog inputs") << u"sim:?param=channel-input-source=1"_s
                                       << u"Serial (analog)"_s << u"serial orders (serial mode)"_s;
        QTest::newRow("rc") << u"sim:?mode=rc"_s << u"RC"_s << u"the RC channels (mode jumper)"_s;
        QTest::newRow("analog") << u"sim:?mode=analog"_s << u"Analog"_s
                                << u"the analog channels (mode jumper)"_s;
    }
    void mode_isShown()
    {
        QFETCH(QString, port);
        QFETCH(QString, mode);
        QFETCH(QString, control);
        test::PanelBench<StatusPanel> bench;
        QVERIFY(bench.connectTo(port));
        QTRY_COMPARE(bench.part<QLabel>(u"status.mode"_s)->text(), mode);
        QTRY_COMPARE(bench.part<QLabel>(u"status.serialControls"_s)->text(), control);
        QCOMPARE(bench.part<QLabel>(u"status.signature"_s)->text(), u"TReXJr1.2"_s);
        QCOMPARE(bench.part<QLabel>(u"status.firmware"_s)->text(), u"1.2"_s);
        QTRY_VERIFY(!bench.part<Indicator>(u"status.motor1Fault"_s)->isStale());
        bench.controller.close();
        QTRY_COMPARE(bench.part<QLabel>(u"status.mode"_s)->text(), u"–"_s);
        QVERIFY(bench.part<Indicator>(u"status.motor1Fault"_s)->isStale());
    }

    void latchedBit_isCountedAndKept() // C-22
    {
        test::PanelBench<StatusPanel> bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        auto* format = bench.part<Indicator>(u"status.uart.format"_s);
        QTRY_VERIFY(!format->isStale());
        QCOMPARE(format->count(), 0);
        bench.controller.requestRaw(QByteArray::fromHex("b5"), 0, this, {}); // no such command
        QTRY_COMPARE(format->count(), 1);
        QVERIFY(format->isActive());
        QTRY_VERIFY(bench.part<Indicator>(u"status.uartError"_s)->count() >= 1);
        QTRY_VERIFY(!format->isActive()); // cleared by the read; the count stays
        QCOMPARE(format->count(), 1);
        QVERIFY(format->toolTip().contains(u"first"_s));
        bench.part<QPushButton>(u"status.clear"_s)->click();
        QCOMPARE(format->count(), 0);
    }

    void log_copiesAndSaves()
    {
        test::PanelBench<LogPanel> bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        auto* view = bench.part<QTableView>(u"log.view"_s);
        QTRY_VERIFY(view->model()->rowCount() >= 2);
        bench.part<QPushButton>(u"log.copy"_s)->click();
        QVERIFY(QGuiApplication::clipboard()->text().contains(u"Connected to a TReX Jr"_s));
        const QString path = bench.folder.filePath(u"log.txt"_s);
        bench.dialogs.answerNext(path);
        bench.part<QPushButton>(u"log.save"_s)->click();
        QFile file(path);
        QTRY_VERIFY(file.exists());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("Connected to a TReX Jr"));
        bench.dialogs.answerNext(u"/nonexistent/log.txt"_s);
        bench.part<QPushButton>(u"log.save"_s)->click();
        QTRY_VERIFY(bench.log.toText().contains(u"could not be saved"_s));
    }
};

QTEST_MAIN(TestStatusPanel)
#include "tst_statuspanel.moc"
