// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/parametersbench.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTranslator>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using Bench = trex::test::ParametersBench;

class TestParameterEditors : public QObject {
    Q_OBJECT

private slots:
    void model_passesItsTester();
    void model_keepsThreeValues();
    void editors_followTheirOwnControls();
    void typed_isTakenInItsUnit_data();
    void typed_isTakenInItsUnit();
    void prescaler_saysTheFrequencyItGives();
    void trexAmperes_areMarkedAsAGuess();
    void channels_areNamed();
    void rows_sayHowSureTheyAre();
    void columns_fitIntoTheWindow_data();
    void columns_fitIntoTheWindow();
    void columns_takeTheLeastFirst();
};

void TestParameterEditors::model_passesItsTester()
{
    ParameterModel model;
    const QAbstractItemModelTester tester(&model,
                                          QAbstractItemModelTester::FailureReportingMode::QtTest);
    model.setDevice(0x07, 5);
    QVERIFY(model.edit(0x07, 9).has_value());
    model.setPending(0x7E, true);
    model.setRefusal(0x07, u"no"_s);
    model.setAdvice({{0x09, u"careful"_s, false}});
    model.revert();
    model.setDevice(0x07, std::nullopt);
    int rows = 0;
    for (int group = 0; group < model.rowCount(); ++group) {
        rows += model.rowCount(model.index(group, 0));
    }
    QCOMPARE(rows, 28);
}

void TestParameterEditors::model_keepsThreeValues()
{
    ParameterModel model;
    const auto text = [&model](int column) {
        return model.indexOf(0x07, column).data().toString();
    };
    QCOMPARE(text(ParameterModel::DeviceColumn), u"–"_s); // never a default as if it were read
    QCOMPARE(text(ParameterModel::DefaultColumn), u"≈ off (0)"_s);
    QCOMPARE(text(ParameterModel::StateColumn), u"not read"_s);
    model.setDevice(0x07, 5);
    QCOMPARE(text(ParameterModel::DeviceColumn), u"0.5 s (5)"_s);
    QCOMPARE(text(ParameterModel::StateColumn), u"not default"_s);
    QVERIFY(model.setData(model.indexOf(0x07, ParameterModel::ValueColumn), 9, Qt::EditRole));
    QCOMPARE(text(ParameterModel::StateColumn), u"edited"_s);
    QCOMPARE(model.wanted().at(0x07), 9);
    QVERIFY(!model.setData(model.indexOf(0x07, ParameterModel::ValueColumn), 128, Qt::EditRole));
    model.setDevice(0x07, 9); // the edit has arrived
    QVERIFY(model.edits().empty());
    QVERIFY(model.edit(0x07, 5).has_value());
    QVERIFY(model.edit(0x07, 9).has_value()); // back to what the controller holds: no edit
    QVERIFY(model.edits().empty());
}

void TestParameterEditors::editors_followTheirOwnControls()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    const auto inner = [&bench](const QString& key, auto* kind, int which = 0) {
        return bench.editor(key)->findChildren<std::remove_pointer_t<decltype(kind)>*>().at(which);
    };
    // Typed in its unit, rounded to what can be stored.
    auto* const timeout = inner(u"serial-timeout"_s, static_cast<QSpinBox*>(nullptr));
    timeout->setFocus();
    timeout->selectAll();
    QTest::keyClicks(timeout, u"1.23"_s);
    QTest::keyClick(timeout, Qt::Key_Return);
    QCOMPARE(bench.editor(u"serial-timeout"_s)->raw(), 12);
    QCOMPARE(timeout->text(), u"1.2 s"_s);
    timeout->stepUp();
    QCOMPARE(bench.editor(u"serial-timeout"_s)->raw(), 13);
    // Bits, one box a channel.
    QTest::mouseClick(inner(u"ignored-channels"_s, static_cast<QCheckBox*>(nullptr), 4),
                      Qt::LeftButton, {}, {8, 8});
    QCOMPARE(bench.editor(u"ignored-channels"_s)->raw(), 16);
    // The UART byte from its parts.
    bench.editor(u"uart-settings"_s)->setRaw(0x2A);
    QCOMPARE(inner(u"uart-settings"_s, static_cast<QComboBox*>(nullptr), 0)->currentText(),
             u"115200"_s);
    QCOMPARE(inner(u"uart-settings"_s, static_cast<QComboBox*>(nullptr), 1)->currentText(),
             u"CRC-7"_s);
    auto* const stops = inner(u"uart-settings"_s, static_cast<QComboBox*>(nullptr), 2);
    stops->setFocus();
    QTest::keyClick(stops, Qt::Key_Down);
    QCOMPARE(bench.editor(u"uart-settings"_s)->raw(), 0x3A);
    // The polynomial in hex, its top bit always there.
    auto* const polynomial = inner(u"crc7-polynomial"_s, static_cast<QSpinBox*>(nullptr));
    QCOMPARE(polynomial->text(), u"0x89"_s);
    polynomial->setFocus();
    polynomial->selectAll();
    QTest::keyClicks(polynomial, u"0x8B"_s);
    QCOMPARE(bench.editor(u"crc7-polynomial"_s)->raw(), 0x0B);
    QVERIFY(bench.pending().contains(u"Needs a power cycle afterwards"_s));
    QCOMPARE(bench.writes, 0);
}

void TestParameterEditors::typed_isTakenInItsUnit_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("typed");
    QTest::addColumn<int>("raw");
    QTest::addColumn<QString>("shown");
    QTest::addColumn<QString>("said");
    QTest::newRow("seconds") << u"serial-timeout"_s << u"2.5"_s << 25 << u"2.5 s"_s << QString();
    QTest::newRow("seconds with unit")
        << u"serial-timeout"_s << u"2.5 s"_s << 25 << u"2.5 s"_s << QString();
    QTest::newRow("milliseconds") << u"serial-timeout"_s << u"300 ms"_s << 3 << u"0.3 s"_s
                                  << QString();
    QTest::newRow("off") << u"serial-timeout"_s << u"off"_s << 0 << u"off"_s << QString();
    QTest::newRow("zero is off") << u"serial-timeout"_s << u"0"_s << 0 << u"off"_s << QString();
    QTest::newRow("too long") << u"serial-timeout"_s << u"13"_s << 4 << u"0.4 s"_s
                              << u"13 is outside of what can be stored, 0.0 to 12.7 s"_s;
    QTest::newRow("no number") << u"serial-timeout"_s << u"soon"_s << 4 << u"0.4 s"_s
                               << u"\"soon\" is no number"_s;
    QTest::newRow("amperes") << u"motor1-current-limit"_s << u"2.43"_s << 30 << u"2.40 A"_s
                             << QString();
    QTest::newRow("too many amperes")
        << u"motor1-current-limit"_s << u"12"_s << 4 << u"0.32 A"_s << u"0.00 to 10.16 A"_s;
    QTest::newRow("brake in ms") << u"motor1-brake-duration"_s << u"120"_s << 12 << u"120 ms"_s
                                 << QString();
    QTest::newRow("acceleration") << u"aux-acceleration"_s << u"0"_s << 0 << u"unlimited"_s
                                  << QString();
    QTest::newRow("polynomial in full")
        << u"crc7-polynomial"_s << u"0x91"_s << 0x11 << u"0x91"_s << QString();
    QTest::newRow("top bit clear") << u"crc7-polynomial"_s << u"0x11"_s << 0x11 << u"0x91"_s
                                   << u"the polynomial in full is 0x91"_s;
    QTest::newRow("nine bits") << u"crc7-polynomial"_s << u"0x189"_s << 4 << u"0x84"_s
                               << u"outside of what can be stored, 0x80 to 0xFF"_s;
}

void TestParameterEditors::typed_isTakenInItsUnit()
{
    QFETCH(QString, key);
    QFETCH(QString, typed);
    QFETCH(int, raw);
    QFETCH(QString, shown);
    QFETCH(QString, said);
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=%1=4"_s.arg(key)));
    auto* const box = bench.editor(key)->findChild<QSpinBox*>();
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, typed);
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(box->text(), shown);
    QCOMPARE(bench.editor(key)->raw(), raw);
    QVERIFY2(bench.text(u"message"_s).contains(said), qPrintable(bench.text(u"message"_s)));
    QCOMPARE(bench.text(u"message"_s).isEmpty(), said.isEmpty());
}

void TestParameterEditors::prescaler_saysTheFrequencyItGives()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    auto* const box = bench.editor(u"motor1-pwm-prescaler"_s)->findChild<QComboBox*>();
    QCOMPARE(box->itemText(0), u"0: 19.53 kHz"_s);
    QCOMPARE(box->currentText(), u"1: 2.44 kHz"_s);
    QCOMPARE(box->itemText(2), u"2: ≈ 610 Hz"_s); // inferred, and marked so
    bench.editor(u"motor1-pwm-maximum"_s)->setRaw(99);
    QCOMPARE(box->currentText(), u"1: 3.13 kHz"_s);
    QCOMPARE(bench.editor(u"motor2-pwm-prescaler"_s)->findChild<QComboBox*>()->currentText(),
             u"1: 2.44 kHz"_s);
    QCOMPARE(bench.cell(u"motor1-pwm-prescaler"_s, ParameterModel::DeviceColumn),
             u"1: 2.44 kHz"_s); // the controller's maximum is the old one
    bench.editor(u"motor1-pwm-prescaler"_s)->setRaw(0);
    QVERIFY(bench.pending().contains(u"Motor 1 PWM prescaler: 1: 2.44 kHz → 0: 25.00 kHz"_s));
    QVERIFY(bench.pending().contains(u"rated for 10 kHz"_s));
    QVERIFY(bench.pending().contains(u"2 settings (▲ "_s)); // where it may lie below the edge
    QCOMPARE(bench.cell(u"motor1-pwm-prescaler"_s, ParameterModel::StateColumn), u"edited ▲"_s);
}

void TestParameterEditors::trexAmperes_areMarkedAsAGuess()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?model=trex&param=motor1-current-limit=30"_s));
    QCOMPARE(bench.cell(u"motor1-current-limit"_s, ParameterModel::DeviceColumn),
             u"≈ 9.00 A (30)"_s);
    auto* const box = bench.editor(u"motor1-current-limit"_s)->findChild<QSpinBox*>();
    QCOMPARE(box->text(), u"≈ 9.00 A"_s);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, u"6"_s);
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(bench.editor(u"motor1-current-limit"_s)->raw(), 20);
}

void TestParameterEditors::channels_areNamed()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    const auto boxes = bench.editor(u"reversed-channels"_s)->findChildren<QCheckBox*>();
    QCOMPARE(boxes.size(), 5);
    QVERIFY(boxes[0]->text().startsWith(u"1 M1"_s));
    QVERIFY(boxes[4]->accessibleName().contains(u"Channel 5: serial override"_s));
    QVERIFY(boxes[3]->toolTip().contains(u"flip switch"_s));
    bench.panel.resize(1800, 500);
    QTRY_COMPARE(boxes[0]->text(), u"1 motor 1 / turn"_s);
}

void TestParameterEditors::rows_sayHowSureTheyAre()
{
    const Bench bench;
    QCOMPARE(bench.cell(u"device-number"_s, ParameterModel::SourceColumn), u"✓ documented"_s);
    QVERIFY(bench.cell(u"motor1-current-limit-p"_s, ParameterModel::TitleColumn).endsWith(u'≈'));
    QCOMPARE(bench.cell(u"motor1-current-limit-p"_s, ParameterModel::SourceColumn), u"≈ a guess"_s);
    for (const auto& row : kParameters) {
        if (!row.isTrigger) {
            const QString sure = bench.cell(keyText(row), ParameterModel::SourceColumn);
            QCOMPARE(sure.startsWith(u'≈'), isGuess(row.meaningGrade) || isGuess(row.defaultGrade));
        }
    }
}

void TestParameterEditors::columns_fitIntoTheWindow_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<int>("width"); // of the panel in a window of 1440 pixels
    QTest::addRow("English") << u"en"_s << 776;
    QTest::addRow("German") << u"de"_s << 758;
}

void TestParameterEditors::columns_fitIntoTheWindow()
{
    QFETCH(const QString, language);
    QFETCH(const int, width);
    QTranslator translator;
    QVERIFY(language == u"en"_s || translator.load(u":/i18n/trex_"_s + language));
    QCoreApplication::installTranslator(&translator);
    theme::apply(theme::Choice::Light);
    Bench bench;
    bench.panel.resize(width, 500);
    auto* const table = bench.part<ParameterTable>(u"table"_s);
    for (const int column :
         {ParameterModel::TitleColumn, ParameterModel::ValueColumn, ParameterModel::DeviceColumn,
          ParameterModel::DefaultColumn, ParameterModel::SourceColumn}) {
        QVERIFY(!table->isColumnHidden(column));
        QVERIFY(table->columnWidth(column) > 60);
    }
    QVERIFY(table->header()->length() <= table->viewport()->width());
    for (const auto& row : kParameters) {
        if (!row.isTrigger) {
            QVERIFY2(bench.editor(keyText(row))->widestHint()
                         <= table->columnWidth(ParameterModel::ValueColumn),
                     row.key.data());
        }
    }
    // What may be cut stands whole in the tool tip.
    const auto* const model = qobject_cast<ParameterModel*>(table->model());
    const QModelIndex cell = model->indexOf(0x7E, ParameterModel::DefaultColumn);
    QVERIFY(cell.data(Qt::ToolTipRole).toString().contains(cell.data().toString()));
    bench.panel.resize(1800, 500); // and where there is room, all is shown
    QVERIFY(!table->isColumnHidden(ParameterModel::StateColumn));
    QVERIFY(!table->isColumnHidden(ParameterModel::RangeColumn));
}

void TestParameterEditors::columns_takeTheLeastFirst()
{
    using Widths = std::vector<int>;
    const std::vector<ColumnNeed> needs{{100, 200}, {50, 50}, {80, 180}};
    QCOMPARE(fittedWidths(needs, 1000), (Widths{200, 50, 180}));
    QCOMPARE(fittedWidths(needs, 330), (Widths{150, 50, 130}));
    QCOMPARE(fittedWidths(needs, 100), (Widths{100, 50, 80}));
}

QTEST_MAIN(TestParameterEditors)
#include "tst_parametereditors.moc"
