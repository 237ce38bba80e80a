// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/devicesettings.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/theme.h"
#include "widgets/common/uisettings.h"
#include "widgets/parameters/parameterfield.h"
#include "widgets/parameters/parameterspanel.h"
#include "widgets/parameters/parametertable.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

constexpr int kLongMs = 20'000;
constexpr std::uint8_t kSetParameter = 0xAF;

/// The panel with everything behind it, and a controller of the simulator to connect to.
class Bench : public QObject {
public:
    Bench()
        : file(folder.filePath(u"settings.ini"_s))
        , uiSettings(file)
        , controller(&store, &latch)
        , settings(controller)
        , context{controller, settings, store, latch, log, uiSettings, ticker, dialogs}
        , panel(context)
    {
        connect(&controller, &Controller::recordsArrived, this,
                [this](const std::vector<TransactionRecord>& records) {
                    for (const auto& record : records) {
                        writes += record.command.opcode == kSetParameter ? 1 : 0;
                    }
                });
        panel.resize(1000, 500);
        panel.show();
    }

    bool connectTo(const QString& port)
    {
        OpenOptions options;
        options.port = port;
        controller.open(options);
        return QTest::qWaitFor([this] { return text(u"banner"_s).isEmpty(); }, kLongMs);
    }
    template <class T>
    T* part(const QString& name) const
    {
        return panel.findChild<T*>(u"parameters."_s + name);
    }
    ParameterField* editor(const QString& key) const
    {
        return part<ParameterField>(key + u".editor"_s);
    }
    QString text(const QString& name) const { return part<QLabel>(name)->text(); }
    QString pending() const { return text(u"pending"_s); }
    QString cell(const QString& key, int column) const
    {
        const auto* const table = part<ParameterTable>(u"table"_s);
        const auto* const model = qobject_cast<ParameterModel*>(table->model());
        return model->indexOf(findParameter(key)->number, column).data().toString();
    }
    void click(const QString& name) const
    {
        auto* const button = part<QPushButton>(name);
        QVERIFY2(button->isEnabled(), qPrintable(name));
        QTest::mouseClick(button, Qt::LeftButton);
    }
    bool waitForMessage(const QString& words)
    {
        return QTest::qWaitFor([&] { return text(u"message"_s).contains(words); }, kLongMs);
    }
    QStringList backups() const
    {
        return QDir(folder.filePath(u"backups"_s)).entryList(QDir::Files);
    }

    QTemporaryDir folder;
    SettingsFile file;
    UiSettings uiSettings;
    TelemetryStore store;
    StatusLatch latch;
    EventLog log;
    FrameTicker ticker;
    FileDialogs dialogs;
    Controller controller;
    DeviceSettings settings;
    PanelContext context;
    ParametersPanel panel;
    int writes = 0;
};

} // namespace

class TestParametersPanel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void model_passesItsTester();
    void model_keepsThreeValues();
    void everyParameter_hasItsEditor();
    void unconnected_showsNoValueAndAllowsNothing();
    void connected_showsWhatWasRead();
    void edit_isPendingThenAppliedAndReadBack();
    void editors_followTheirOwnControls();
    void outOfRange_isRejectedWithASentence();
    void apply_writesOnlyWhatDiffers();
    void revert_dropsEdits();
    void search_hidesTheOthers_data();
    void search_hidesTheOthers();
    void outsideSerialMode_nothingCanBeChanged();
    void refusal_standsAtItsRow();
    void powerCycle_isAskedForUntilItHappened();
    void lostLink_keepsEdits();
    void defaults_tellWhichAreGuesses();
    void saveAndLoad_goThroughAFile();
    void badFile_changesNothing();
    void backupThatFails_stopsTheFirstApply();
};

void TestParametersPanel::initTestCase()
{
    theme::apply(theme::Choice::Light);
}

void TestParametersPanel::model_passesItsTester()
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

void TestParametersPanel::model_keepsThreeValues()
{
    ParameterModel model;
    const auto text = [&model](int column) {
        return model.indexOf(0x07, column).data().toString();
    };
    QCOMPARE(text(ParameterModel::DeviceColumn), u"–"_s); // never a default as if it were read
    QCOMPARE(text(ParameterModel::DefaultColumn), u"≈ 0 ms (0)"_s);
    QCOMPARE(text(ParameterModel::StateColumn), u"not read"_s);
    model.setDevice(0x07, 5);
    QCOMPARE(text(ParameterModel::DeviceColumn), u"500 ms (5)"_s);
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

void TestParametersPanel::everyParameter_hasItsEditor()
{
    const Bench bench;
    for (const auto& row : kParameters) {
        QCOMPARE(bench.editor(keyText(row)) != nullptr, !row.isTrigger);
    }
    for (const auto& name : {u"apply"_s, u"revert"_s, u"reload"_s, u"save"_s, u"load"_s,
                             u"defaults"_s, u"search"_s, u"pending"_s, u"table"_s}) {
        QVERIFY2(bench.part<QWidget>(name) != nullptr, qPrintable(name));
    }
}

void TestParametersPanel::unconnected_showsNoValueAndAllowsNothing()
{
    const Bench bench;
    QVERIFY(bench.text(u"banner"_s).startsWith(u"Not connected"_s));
    for (const auto& row : kParameters) {
        if (!row.isTrigger) {
            QCOMPARE(bench.editor(keyText(row))->raw(), -1);
            QVERIFY(!bench.editor(keyText(row))->isEnabled());
            QCOMPARE(bench.cell(keyText(row), ParameterModel::DeviceColumn), u"–"_s);
        }
    }
    for (const auto& name :
         {u"apply"_s, u"revert"_s, u"reload"_s, u"save"_s, u"load"_s, u"defaults"_s}) {
        QVERIFY2(!bench.part<QPushButton>(name)->isEnabled(), qPrintable(name));
    }
}

void TestParametersPanel::connected_showsWhatWasRead()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5&param=motor1-current-limit=30"_s));
    QCOMPARE(bench.editor(u"serial-timeout"_s)->raw(), 5);
    QCOMPARE(bench.cell(u"serial-timeout"_s, ParameterModel::DeviceColumn), u"500 ms (5)"_s);
    QCOMPARE(bench.cell(u"motor1-current-limit"_s, ParameterModel::DeviceColumn), u"2.40 A (30)"_s);
    QCOMPARE(bench.cell(u"uart-settings"_s, ParameterModel::DeviceColumn),
             u"19200 baud, no error detection, 1 stop bit (5)"_s);
    QVERIFY(bench.editor(u"serial-timeout"_s)->isEnabled());
    QVERIFY(!bench.part<QPushButton>(u"apply"_s)->isEnabled());
    QCOMPARE(bench.pending(), u"Nothing to write."_s);
    QCOMPARE(bench.writes, 0);
}

void TestParametersPanel::edit_isPendingThenAppliedAndReadBack()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    auto* const editor = bench.editor(u"serial-timeout"_s);
    const QSignalSpy changed(editor, &ParameterField::rawChanged);
    QVERIFY(editor->setProperty("raw", 5)); // as a script does
    QCOMPARE(editor->property("raw").toInt(), 5);
    QCOMPARE(changed.count(), 1);
    QVERIFY2(bench.pending().contains(u"Serial timeout: 0 → 500 ms"_s),
             qPrintable(bench.pending()));
    QCOMPARE(bench.writes, 0);
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"Written and read back: Serial timeout."_s));
    QCOMPARE(bench.writes, 1);
    QCOMPARE(bench.settings.parameter(0x07), 5);
    QCOMPARE(bench.cell(u"serial-timeout"_s, ParameterModel::DeviceColumn), u"500 ms (5)"_s);
    QCOMPARE(bench.pending(), u"Nothing to write."_s);
    QCOMPARE(bench.backups().size(), 1); // as it was before, once
    QCOMPARE(loadConfiguration(bench.folder.filePath(u"backups/"_s + bench.backups().at(0)))
                 ->parameters.at(0x07),
             0);
    editor->setRaw(0);
    QVERIFY2(bench.pending().contains(u"500 → 0 ms"_s), qPrintable(bench.pending()));
    QVERIFY(bench.pending().contains(u"keep running if the line is lost"_s));
    bench.click(u"apply"_s);
    QTRY_COMPARE_WITH_TIMEOUT(bench.settings.parameter(0x07), 0, kLongMs);
    QCOMPARE(bench.backups().size(), 1);
}

void TestParametersPanel::editors_followTheirOwnControls()
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
    QTest::keyClicks(timeout, u"1230"_s);
    QTest::keyClick(timeout, Qt::Key_Return);
    QCOMPARE(bench.editor(u"serial-timeout"_s)->raw(), 12);
    QCOMPARE(timeout->text(), u"1200 ms"_s);
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

void TestParametersPanel::outOfRange_isRejectedWithASentence()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.editor(u"motor1-pwm-prescaler"_s)->setRaw(4);
    QCOMPARE(bench.editor(u"motor1-pwm-prescaler"_s)->raw(), 1);
    QVERIFY(bench.text(u"message"_s).contains(u"motor1-pwm-prescaler 4 (0…3)"_s));
    QCOMPARE(bench.pending(), u"Nothing to write."_s);
}

void TestParametersPanel::apply_writesOnlyWhatDiffers()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.editor(u"motor1-acceleration"_s)->setRaw(10);
    bench.editor(u"motor2-acceleration"_s)->setRaw(10);
    bench.editor(u"serial-timeout"_s)->setRaw(5);
    bench.editor(u"serial-timeout"_s)->setRaw(0); // back again: no edit
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"Written and read back"_s));
    QCOMPARE(bench.writes, 2);
}

void TestParametersPanel::revert_dropsEdits()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.editor(u"serial-timeout"_s)->setRaw(5);
    bench.editor(u"reversed-channels"_s)->setRaw(3);
    bench.click(u"revert"_s);
    QCOMPARE(bench.editor(u"serial-timeout"_s)->raw(), 0);
    QCOMPARE(bench.editor(u"reversed-channels"_s)->raw(), 0);
    QCOMPARE(bench.pending(), u"Nothing to write."_s);
    QVERIFY(!bench.part<QPushButton>(u"revert"_s)->isEnabled());
    QCOMPARE(bench.writes, 0);
}

void TestParametersPanel::search_hidesTheOthers_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("rows");
    QTest::newRow("nothing typed") << QString() << 28;
    QTest::newRow("name") << u"serial timeout"_s << 1;
    QTest::newRow("key") << u"uart-error-shutdown"_s << 1;
    QTest::newRow("number") << u"0x7e"_s << 1;
    QTest::newRow("two words") << u"prescaler motor 2"_s << 1;
    QTest::newRow("group") << u"current limits"_s << 4;
    QTest::newRow("no match") << u"hovercraft"_s << 0;
}

void TestParametersPanel::search_hidesTheOthers()
{
    QFETCH(QString, text);
    QFETCH(int, rows);
    const Bench bench;
    bench.part<QLineEdit>(u"search"_s)->setText(text);
    QCOMPARE(bench.part<ParameterTable>(u"table"_s)->shownRows(), rows);
    bench.part<QLineEdit>(u"search"_s)->clear();
    QCOMPARE(bench.part<ParameterTable>(u"table"_s)->shownRows(), 28);
    QVERIFY(bench.editor(u"serial-timeout"_s) != nullptr);
}

void TestParametersPanel::outsideSerialMode_nothingCanBeChanged()
{
    Bench bench;
    OpenOptions options;
    options.port = u"sim:?mode=rc"_s;
    bench.controller.open(options);
    QTRY_VERIFY_WITH_TIMEOUT(bench.text(u"banner"_s).contains(u"in RC mode"_s), kLongMs);
    QVERIFY(bench.text(u"banner"_s).contains(u"take the mode jumper off"_s));
    QCOMPARE(bench.editor(u"device-number"_s)->raw(), 7);
    QVERIFY(!bench.editor(u"device-number"_s)->isEnabled());
    QVERIFY(!bench.part<QPushButton>(u"apply"_s)->isEnabled());
    QVERIFY(bench.part<QPushButton>(u"save"_s)->isEnabled()); // reading is always allowed
}

void TestParametersPanel::refusal_standsAtItsRow()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?firmware=1.0&quirk=unknown-parameter=ff"_s));
    bench.editor(u"serial-timeout"_s)->setRaw(5);
    bench.editor(u"uart-response-delay"_s)->setRaw(1);
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"no such parameter"_s));
    QCOMPARE(bench.cell(u"uart-response-delay"_s, ParameterModel::StateColumn), u"refused"_s);
    QVERIFY(bench.text(u"message"_s).contains(u"Put back as before: Serial timeout."_s));
    QCOMPARE(bench.settings.parameter(0x07), 0);
    QCOMPARE(bench.editor(u"serial-timeout"_s)->raw(), 5); // still wanted
    bench.editor(u"uart-response-delay"_s)->setRaw(0); // another try clears the refusal
    QCOMPARE(bench.cell(u"uart-response-delay"_s, ParameterModel::StateColumn), u"edited"_s);
}

void TestParametersPanel::powerCycle_isAskedForUntilItHappened()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.editor(u"motor-mode"_s)->setRaw(1);
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"Motor mode"_s));
    QTRY_VERIFY(bench.text(u"banner"_s).contains(u"Needs a power cycle"_s));
    QCOMPARE(bench.cell(u"motor-mode"_s, ParameterModel::StateColumn), u"power cycle"_s);
    bench.controller.powerCycleSimulator();
    QTRY_VERIFY_WITH_TIMEOUT(bench.text(u"banner"_s).isEmpty(), kLongMs);
    QCOMPARE(bench.editor(u"motor-mode"_s)->raw(), 1);
}

void TestParametersPanel::lostLink_keepsEdits()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.editor(u"serial-timeout"_s)->setRaw(5);
    bench.controller.close();
    QTRY_VERIFY_WITH_TIMEOUT(bench.text(u"banner"_s).startsWith(u"Not connected"_s), kLongMs);
    QCOMPARE(bench.cell(u"serial-timeout"_s, ParameterModel::DeviceColumn), u"–"_s);
    QCOMPARE(bench.editor(u"serial-timeout"_s)->raw(), 5);
    QCOMPARE(bench.editor(u"device-number"_s)->raw(), -1);
    QVERIFY(!bench.part<QPushButton>(u"apply"_s)->isEnabled());
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.pending().contains(u"0 → 500 ms"_s));
    QVERIFY(bench.part<QPushButton>(u"apply"_s)->isEnabled());
}

void TestParametersPanel::defaults_tellWhichAreGuesses()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5&param=motor1-pwm-prescaler=2"_s));
    bench.click(u"defaults"_s);
    QVERIFY(bench.pending().contains(u"Serial timeout: 500 → 0 ms"_s));
    QVERIFY(bench.pending().contains(u"Motor 1 PWM prescaler"_s));
    QVERIFY(bench.text(u"message"_s).contains(u"1 are marked ≈"_s)
            || bench.text(u"message"_s).contains(u"1 is marked ≈"_s));
    QCOMPARE(bench.writes, 0);
}

void TestParametersPanel::saveAndLoad_goThroughAFile()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5"_s));
    const QString path = bench.folder.filePath(u"mine.json"_s);
    bench.dialogs.answerNext(path);
    bench.click(u"save"_s);
    QTRY_VERIFY(QFile::exists(path));
    auto saved = loadConfiguration(path);
    QVERIFY(saved && isComplete(*saved));
    saved->parameters[0x07] = 9;
    saved->calibrations[InputKind::Rc][2].deadband = 77;
    QVERIFY(saveConfiguration(*saved, path).has_value());
    bench.dialogs.answerNext(path);
    bench.click(u"load"_s);
    QTRY_VERIFY(bench.pending().contains(u"Serial timeout: 500 → 900 ms"_s));
    QVERIFY(bench.pending().contains(u"Calibration of channel 2 (RC)"_s));
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"Written and read back"_s));
    QCOMPARE(bench.settings.parameter(0x07), 9);
    QCOMPARE(bench.settings.calibration(InputKind::Rc, 2)->deadband, 77);
    QCOMPARE(bench.pending(), u"Nothing to write."_s);
}

void TestParametersPanel::badFile_changesNothing()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.editor(u"serial-timeout"_s)->setRaw(5);
    QFile bad(bench.folder.filePath(u"bad.json"_s));
    QVERIFY(bad.open(QIODevice::WriteOnly));
    bad.write(R"({"format":"trexpanel-configuration","version":1,"parameters":{
        "device-number":{"raw":8}, "serial-timeout":{"raw":5,"physical":400,"unit":"ms"}}})");
    bad.close();
    bench.dialogs.answerNext(bad.fileName());
    bench.click(u"load"_s);
    QVERIFY(bench.waitForMessage(u"line 2, parameters.serial-timeout.physical"_s));
    QCOMPARE(bench.editor(u"device-number"_s)->raw(), 7);
    QCOMPARE(bench.editor(u"serial-timeout"_s)->raw(), 5); // the edit from before stays
}

void TestParametersPanel::backupThatFails_stopsTheFirstApply()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QFile inTheWay(bench.folder.filePath(u"backups"_s)); // a file where the folder should be
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    bench.editor(u"serial-timeout"_s)->setRaw(5);
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"Nothing is written to the controller"_s));
    QCOMPARE(bench.writes, 0);
    bench.click(u"apply"_s); // told, and asked again
    QVERIFY(bench.waitForMessage(u"Written and read back"_s));
    QCOMPARE(bench.writes, 1);
}

QTEST_MAIN(TestParametersPanel)
#include "tst_parameterspanel.moc"
