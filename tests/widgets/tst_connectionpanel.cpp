// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/lineprobe.h"
#include "protocol/procedures/linetext.h"
#include "protocol/storage/linesettingsstore.h"
#include "tests/support/panelbench.h"
#include "widgets/connection/connectionpanel.h"
#include "widgets/connection/lineform.h"
#include "widgets/connection/portbox.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

using Bench = test::PanelBench<ConnectionPanel>;

const PortInfo kAdapter{u"/dev/ttyUSB0"_s, u"FT232R"_s, u"FTDI"_s, {}, 0x0403, 0x6001};
const PortInfo kBoard{u"/dev/ttyS0"_s, {}, {}, {}, 0, 0};

template <class T>
T* in(const QWidget& panel, const QString& part)
{
    return panel.findChild<T*>(u"connection.%1"_s.arg(part));
}

PortBox* port(const QWidget& panel)
{
    return in<PortBox>(panel, u"port"_s);
}

/// As a person types it.
void typeAddress(const QWidget& panel, const QString& address)
{
    QLineEdit* edit = port(panel)->lineEdit();
    edit->selectAll();
    QTest::keyClicks(edit, address);
}

QString state(const QWidget& panel)
{
    return in<QLabel>(panel, u"state"_s)->property("state").toString();
}

QString advice(const QWidget& panel)
{
    return in<QLabel>(panel, u"advice"_s)->text();
}

void click(const QWidget& panel, const QString& part)
{
    auto* button = in<QPushButton>(panel, part);
    QVERIFY2(button->isEnabled(), qPrintable(part));
    button->click();
}

} // namespace

class TestConnectionPanel : public QObject {
    Q_OBJECT

private slots:
    void start_offersTheSimulator_whenThereIsNoAdapter()
    {
        Bench bench;
        port(bench.panel)->setLister([] { return QList<PortInfo>{}; });
        QCOMPARE(port(bench.panel)->itemData(0).toString(), u"sim:?scenario=:/stick.json"_s);
        QCOMPARE(state(bench.panel), u"disconnected"_s);
        QVERIFY(in<QLabel>(bench.panel, u"state"_s)->text().startsWith(u"disconnected"_s));
        port(bench.panel)->setAddress(simulatorAddress());
        bench.panel.hide();
        bench.panel.show();
        QVERIFY(!in<QPushButton>(bench.panel, u"powerCycle"_s)->isVisible());
        QVERIFY(!in<QPushButton>(bench.panel, u"disconnect"_s)->isEnabled());
    }

    void portList_followsThePlug_andKeepsTheChoice()
    {
        PortBox box;
        QList<PortInfo> present{kBoard};
        box.setLister([&present] { return present; });
        QCOMPARE(box.count(), 2);
        QCOMPARE(box.firstAdapter(), QString());
        present.prepend(kAdapter);
        box.refresh();
        QCOMPARE(box.itemText(1), u"ttyUSB0 — FT232R (FTDI)"_s);
        QCOMPARE(box.itemData(1).toString(), u"/dev/ttyUSB0"_s);
        box.setCurrentIndex(1);
        QCOMPARE(box.address(), u"/dev/ttyUSB0"_s);
        present.removeFirst();
        box.refresh();
        QCOMPARE(box.address(), u"/dev/ttyUSB0"_s); // chosen, though unplugged
        QCOMPARE(box.count(), 2);
        present.prepend(kAdapter);
        box.refresh();
        QCOMPARE(box.address(), u"/dev/ttyUSB0"_s);
    }

    void portList_holdsHundreds_andOddNames()
    {
        PortBox box;
        QList<PortInfo> present;
        for (int i = 0; i < 300; ++i) {
            present.append({u"/dev/rack%1/tty <b>ü “%2”"_s.arg(i / 2).arg(i / 2),
                            QString(i % 7 * 40, u'x'),
                            u"Ä & <i>"_s,
                            {},
                            0x1234,
                            1});
        }
        box.setLister([&present] { return present; });
        QCOMPARE(box.count(), 301);
        for (int i = 0; i < 300; ++i) {
            box.setCurrentIndex(i + 1);
            QCOMPARE(box.address(), present[i].port);
        }
        // Two of one name: the one that was chosen is meant.
        present = {kAdapter, kAdapter};
        present[1].port = u"/dev/other/ttyUSB0"_s;
        box.refresh();
        box.setCurrentIndex(2);
        QCOMPARE(box.address(), u"/dev/other/ttyUSB0"_s);
        QVERIFY(box.sizeHint().width() < 600); // however long a name is
    }

    void portList_looksByItself_whileVisible()
    {
        PortBox box;
        QList<PortInfo> present;
        box.setLister([&present] { return present; });
        box.show();
        present.append(kAdapter);
        QTRY_COMPARE(box.count(), 2);
    }

    void typedText_staysWhileTheListChanges()
    {
        PortBox box;
        QList<PortInfo> present;
        box.setLister([&present] { return present; });
        box.lineEdit()->selectAll();
        QTest::keyClicks(box.lineEdit(), u"tcp://ho"_s);
        box.lineEdit()->setCursorPosition(3);
        present.append(kAdapter);
        box.refresh();
        QCOMPARE(box.currentText(), u"tcp://ho"_s);
        QCOMPARE(box.address(), u"tcp://ho"_s);
        QCOMPARE(box.lineEdit()->cursorPosition(), 3);
    }

    void initialValues_areThoseThatLastWorked()
    {
        Bench bench;
        LineSettings line;
        line.baud = 57600;
        line.errorDetection = ErrorDetection::Crc7;
        line.polynomial = 0x91;
        LineSettingsStore(bench.file).remember(u"tcp://bench:2000"_s, line);
        const ConnectionPanel panel(bench.context);
        QCOMPARE(port(panel)->address(), u"tcp://bench:2000"_s);
        QVERIFY(port(panel)->findData(u"tcp://bench:2000"_s) > 0);
        QCOMPARE(in<QComboBox>(panel, u"baud"_s)->currentData().toInt(), 57600);
        QCOMPARE(in<QComboBox>(panel, u"errorDetection"_s)->currentData().toString(), u"crc7"_s);
        QCOMPARE(in<QSpinBox>(panel, u"polynomial"_s)->text(), u"0x91"_s);
    }

    void chosenPort_fillsInWhatWorkedThere()
    {
        Bench bench;
        LineSettings line;
        line.baud = 2400;
        LineSettingsStore(bench.file).remember(u"sim:?baud=2400"_s, line);
        typeAddress(bench.panel, u"sim:?baud=2400"_s);
        QCOMPARE(in<QComboBox>(bench.panel, u"baud"_s)->currentData().toInt(), 2400);
    }

    void lineForm_roundTripsEverySetting()
    {
        LineForm form;
        QCOMPARE(form.settings(), LineSettings{});
        const LineSettings line{.baud = 1200,
                                .errorDetection = ErrorDetection::Odd,
                                .polynomial = 0xFF,
                                .stopBits = 2,
                                .form = PacketForm::Pololu,
                                .device = 127,
                                .echo = EchoMode::Off,
                                .timeout = std::chrono::milliseconds(2500)};
        form.setSettings(line);
        QCOMPARE(form.settings(), line);
        QCOMPARE(in<QComboBox>(form, u"baud"_s)->count(), 11); // C-53
    }

    void fields_areEnabledWhereTheyMatter()
    {
        LineForm form;
        QVERIFY(!in<QSpinBox>(form, u"device"_s)->isEnabled());
        QVERIFY(!in<QSpinBox>(form, u"polynomial"_s)->isEnabled());
        auto* protocol = in<QComboBox>(form, u"protocol"_s);
        protocol->setCurrentIndex(protocol->findData(u"pololu"_s));
        auto* detection = in<QComboBox>(form, u"errorDetection"_s);
        detection->setCurrentIndex(detection->findData(u"crc7"_s));
        QVERIFY(in<QSpinBox>(form, u"device"_s)->isEnabled());
        QVERIFY(in<QSpinBox>(form, u"polynomial"_s)->isEnabled());
    }

    void connect_opensWithTheFields_andDisconnectCloses()
    {
        Bench bench;
        typeAddress(bench.panel, u"sim:?baud=9600&error-detection=crc7"_s);
        auto* baud = in<QComboBox>(bench.panel, u"baud"_s);
        baud->setCurrentIndex(baud->findData(9600));
        auto* detection = in<QComboBox>(bench.panel, u"errorDetection"_s);
        detection->setCurrentIndex(detection->findData(u"crc7"_s));
        click(bench.panel, u"connect"_s);
        QCOMPARE(state(bench.panel), u"connecting"_s);
        QVERIFY(in<QLabel>(bench.panel, u"state"_s)->text().startsWith(u"connecting"_s));
        QTRY_COMPARE(state(bench.panel), u"connected"_s);
        QTRY_COMPARE(in<QLabel>(bench.panel, u"state"_s)->text(),
                     u"connected to a TReX Jr, firmware 1.2, on simulated controller"_s);
        QVERIFY(!port(bench.panel)->isEnabled());
        QVERIFY(!baud->isEnabled());
        QVERIFY(in<QPushButton>(bench.panel, u"powerCycle"_s)->isVisible());
        click(bench.panel, u"disconnect"_s);
        QTRY_COMPARE(state(bench.panel), u"disconnected"_s);
        QVERIFY(port(bench.panel)->isEnabled());
        QCOMPARE(port(bench.panel)->address(), u"sim:?baud=9600&error-detection=crc7"_s);
    }

    void wrongAddress_getsOneSentence_andNothingIsOpened_data()
    {
        QTest::addColumn<QString>("address");
        QTest::addColumn<QString>("says");
        QTest::newRow("tcp") << u"tcp://host:99999"_s << u"address"_s;
        QTest::newRow("sim") << u"sim:?mode=banana"_s << u"banana"_s;
        QTest::newRow("blank") << u" "_s << u"address"_s;
    }

    void wrongAddress_getsOneSentence_andNothingIsOpened()
    {
        QFETCH(QString, address);
        QFETCH(QString, says);
        Bench bench;
        typeAddress(bench.panel, address);
        click(bench.panel, u"connect"_s);
        const QString before = advice(bench.panel);
        QVERIFY2(before.contains(says), qPrintable(before));
        QCOMPARE(bench.controller.state(), LinkState::Disconnected);
        QVERIFY(bench.controller.options().port.isEmpty());
        typeAddress(bench.panel, u"sim:"_s);
        QVERIFY(advice(bench.panel) != before); // out of date, so gone
    }

    void missingPort_saysWhatToTry()
    {
        Bench bench;
        typeAddress(bench.panel, u"/dev/ttyNONE7"_s);
        click(bench.panel, u"connect"_s);
        QTRY_VERIFY2(advice(bench.panel).contains(u"no port /dev/ttyNONE7"_s),
                     qPrintable(advice(bench.panel)));
    }

    void wrongSpeed_saysWhatToTry()
    {
        Bench bench;
        typeAddress(bench.panel, u"sim:?baud=9600"_s);
        click(bench.panel, u"connect"_s);
        QTRY_VERIFY2(advice(bench.panel).contains(u"Scan"_s), qPrintable(advice(bench.panel)));
        QVERIFY(state(bench.panel) != u"connected"_s);
    }

    void somebodyElseConnects_fieldsFollow()
    {
        Bench bench;
        LineSettings line;
        line.form = PacketForm::Pololu;
        line.device = 9;
        bench.controller.open({.port = u"sim:?device=9"_s, .line = line});
        QTRY_COMPARE(state(bench.panel), u"connected"_s);
        QCOMPARE(port(bench.panel)->address(), u"sim:?device=9"_s);
        QCOMPARE(in<QComboBox>(bench.panel, u"protocol"_s)->currentData().toString(), u"pololu"_s);
        QCOMPARE(in<QSpinBox>(bench.panel, u"device"_s)->value(), 9);
    }

    void scan_findsTheLine_andFillsTheFields()
    {
        Bench bench;
        typeAddress(bench.panel, u"sim:?baud=115200"_s);
        click(bench.panel, u"scan"_s);
        QVERIFY(!in<QPushButton>(bench.panel, u"connect"_s)->isEnabled());
        QTRY_VERIFY2_WITH_TIMEOUT(advice(bench.panel).startsWith(u"Found a TReX Jr"_s),
                                  qPrintable(advice(bench.panel)), 20'000);
        QCOMPARE(in<QComboBox>(bench.panel, u"baud"_s)->currentData().toInt(), 115200);
        click(bench.panel, u"connect"_s);
        QTRY_COMPARE(state(bench.panel), u"connected"_s);
    }

    void scan_isCancelledByTheSameButton()
    {
        Bench bench;
        typeAddress(bench.panel, u"sim:?fault=drop=1"_s);
        click(bench.panel, u"scan"_s);
        auto* scan = in<QPushButton>(bench.panel, u"scan"_s);
        QTRY_VERIFY2(advice(bench.panel).contains(u"Trying"_s), qPrintable(advice(bench.panel)));
        QVERIFY(scan->text().contains(u"Cancel"_s));
        scan->click();
        QTRY_VERIFY(advice(bench.panel).contains(u"cancelled"_s));
        QVERIFY(!scan->text().contains(u"Cancel"_s));
        QVERIFY(in<QPushButton>(bench.panel, u"connect"_s)->isEnabled());
    }

    void recover_findsTheLostController_andConnects()
    {
        Bench bench;
        typeAddress(bench.panel, u"sim:?baud=9600&error-detection=even"_s);
        click(bench.panel, u"connect"_s); // at 19200: nothing answers
        QTRY_COMPARE(state(bench.panel), u"retrying"_s);
        QVERIFY2(advice(bench.panel).contains(u"Recover"_s), qPrintable(advice(bench.panel)));
        click(bench.panel, u"recover"_s);
        QTRY_VERIFY2(advice(bench.panel).contains(u"Trying"_s), qPrintable(advice(bench.panel)));
        QVERIFY(in<QPushButton>(bench.panel, u"recover"_s)->text().contains(u"Cancel"_s));
        QVERIFY(!in<QPushButton>(bench.panel, u"scan"_s)->isEnabled());
        QTRY_COMPARE_WITH_TIMEOUT(state(bench.panel), u"connected"_s, 30'000);
        QCOMPARE(bench.controller.options().line.baud, 9600);
        QCOMPARE(in<QComboBox>(bench.panel, u"errorDetection"_s)->currentData().toString(),
                 u"even"_s);
        QVERIFY(bench.motorPackets.isEmpty());
        QVERIFY(!bench.controller.isArmed());
        QVERIFY(!in<QPushButton>(bench.panel, u"recover"_s)->isEnabled());
    }

    void recover_triesFirstWhatWorkedLast()
    {
        Bench bench;
        const QString address = u"sim:?baud=2400&error-detection=crc7&crc-polynomial=145"_s;
        LineSettings line;
        line.baud = 2400;
        line.errorDetection = ErrorDetection::Crc7;
        line.polynomial = 0x91;
        LineSettingsStore(bench.file).remember(address, line);
        typeAddress(bench.panel, address);
        auto* baud = in<QComboBox>(bench.panel, u"baud"_s);
        baud->setCurrentIndex(baud->findData(115200));
        QStringList seen;
        click(bench.panel, u"recover"_s);
        seen << advice(bench.panel);
        QVERIFY2(seen.front().contains(u"2400 baud"_s), qPrintable(seen.front()));
        QTRY_COMPARE_WITH_TIMEOUT(state(bench.panel), u"connected"_s, 30'000);
        QCOMPARE(int(bench.controller.options().line.polynomial), 0x91);
    }

    void recover_findsNothing_andSaysWhatIsLeft()
    {
        Bench bench;
        typeAddress(bench.panel, u"sim:?fault=drop=1"_s);
        click(bench.panel, u"recover"_s);
        QTRY_VERIFY2_WITH_TIMEOUT(advice(bench.panel).contains(u"No controller answered"_s),
                                  qPrintable(advice(bench.panel)), 60'000);
        QVERIFY(advice(bench.panel).contains(u"Nothing at all came back"_s));
        QVERIFY(advice(bench.panel).contains(u"inferred"_s)); // the vendor's reset, facts.md 6
        QVERIFY(!advice(bench.panel).contains(u"Not tried"_s));
        QVERIFY(in<QPushButton>(bench.panel, u"recover"_s)->isEnabled());
    }

    void recover_saysWhatItCouldNotTrySafely()
    {
        Bench bench;
        LineSettings line{.baud = 14400, .errorDetection = ErrorDetection::Crc7};
        while (lineProbe(line).isClean) {
            QVERIFY(line.polynomial < 0xFF); // else all are clean now, and the sentence can go
            ++line.polynomial;
        }
        typeAddress(bench.panel, u"sim:?fault=drop=1"_s);
        in<QSpinBox>(bench.panel, u"polynomial"_s)->setValue(line.polynomial);
        click(bench.panel, u"recover"_s);
        QTRY_VERIFY2_WITH_TIMEOUT(advice(bench.panel).contains(u"No controller answered"_s),
                                  qPrintable(advice(bench.panel)), 60'000);
        QVERIFY2(advice(bench.panel).contains(leftOutText({line})),
                 qPrintable(advice(bench.panel)));
    }

    void lineChange_isFollowed_andTold()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        auto* box = in<QWidget>(bench.panel, u"lineChange"_s);
        QVERIFY(!box->isVisible());
        const QSignalSpy forward(&bench.panel, &Panel::panelRequested);
        bool isWritten = false;
        bench.settings.writeParameter(parameterRow("uart-settings"), 10, true, &bench.panel,
                                      [&isWritten](const auto& written) { isWritten = !!written; });
        QTRY_VERIFY(isWritten);
        QTRY_COMPARE(box->property("phase").toString(), u"waiting"_s);
        QVERIFY(box->isVisible());
        QCOMPARE(forward.size(), 1); // it may stand behind another panel's tab
        QCOMPARE(forward.first().first().toString(), u"connection"_s);
        const auto* text = in<QLabel>(bench.panel, u"lineChange.text"_s);
        QVERIFY2(text->text().startsWith(u"Waiting for the power cycle"_s),
                 qPrintable(text->text()));
        QVERIFY(in<QPushButton>(bench.panel, u"lineChange.cancel"_s)->isVisible());
        click(bench.panel, u"powerCycle"_s);
        QTRY_COMPARE_WITH_TIMEOUT(text->text(),
                                  u"The controller answers with 115200 baud, no error detection."_s,
                                  20'000);
        QCOMPARE(state(bench.panel), u"connected"_s);
        QCOMPARE(in<QComboBox>(bench.panel, u"baud"_s)->currentData().toInt(), 115200);
        QVERIFY(!in<QPushButton>(bench.panel, u"lineChange.cancel"_s)->isVisible());
        QVERIFY(forward.size() > 1); // so is how it ended
        QVERIFY(bench.log.toText().contains(u"answers with 115200 baud"_s));
    }

    void lineChange_isCancelled()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        bench.settings.writeParameter(parameterRow("uart-settings"), 3, true, &bench.panel,
                                      [](const auto&) {});
        auto* box = in<QWidget>(bench.panel, u"lineChange"_s);
        QTRY_COMPARE(box->property("phase").toString(), u"waiting"_s);
        click(bench.panel, u"lineChange.cancel"_s);
        QCOMPARE(box->property("phase").toString(), u"none"_s);
        QVERIFY(!box->isVisible());
        QCOMPARE(state(bench.panel), u"connected"_s);
    }

    void powerCycle_restartsTheSimulator()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        bool restarted = false;
        QObject::connect(&bench.controller, &Controller::restarted, &bench.panel,
                         [&restarted] { restarted = true; });
        click(bench.panel, u"powerCycle"_s);
        QTRY_VERIFY(restarted);
    }

    void narrowDock_holdsItAll()
    {
        Bench bench;
        bench.panel.resize(300, 600);
        QVERIFY2(bench.panel.minimumSizeHint().width() <= 300,
                 qPrintable(QString::number(bench.panel.minimumSizeHint().width())));
    }
};

QTEST_MAIN(TestConnectionPanel)
#include "tst_connectionpanel.moc"
