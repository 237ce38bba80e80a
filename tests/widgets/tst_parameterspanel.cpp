// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/linesettingsstore.h"
#include "tests/widgets/parametersbench.h"
#include "widgets/parameters/restartline.h"

#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>

#include <memory>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using Bench = trex::test::ParametersBench;
using trex::test::kLongMs;

class TestParametersPanel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void everyParameter_hasItsEditor();
    void unconnected_showsNoValueAndAllowsNothing();
    void connected_showsWhatWasRead();
    void edit_isPendingThenAppliedAndReadBack();
    void outOfRange_isRejectedWithASentence();
    void apply_writesOnlyWhatDiffers();
    void revert_dropsEdits();
    void search_hidesTheOthers_data();
    void search_hidesTheOthers();
    void outsideSerialMode_nothingCanBeChanged();
    void powerCycle_isAskedForUntilItHappened();
    void restart_seenTwiceIsOne();
    void silence_isToldAsAPossibleRestart();
    void lostLink_keepsEdits();
    void backupThatFails_stopsTheFirstApply();
    void filter_showsWhatItIsFor_data();
    void filter_showsWhatItIsFor();
    void preview_isWhatIsSent();
    void refusal_stopsAndOffersToPutBack();
    void refusal_mayKeepWhatWasWritten();
    void cancel_stopsBetweenWrites();
    void numberInUse_isToldBeforeWriting();
    void newPanel_takesTheEditsOver();
};

void TestParametersPanel::initTestCase()
{
    theme::apply(theme::Choice::Light);
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
    QCOMPARE(bench.cell(u"serial-timeout"_s, ParameterModel::DeviceColumn), u"0.5 s (5)"_s);
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
    QVERIFY2(bench.pending().contains(u"Serial timeout: off → 0.5 s  [AF 07 05 55 2A]"_s),
             qPrintable(bench.pending()));
    QCOMPARE(bench.writes, 0);
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"Written and read back: Serial timeout."_s));
    QCOMPARE(bench.writes, 1);
    QCOMPARE(bench.settings.parameter(0x07), 5);
    QCOMPARE(bench.cell(u"serial-timeout"_s, ParameterModel::DeviceColumn), u"0.5 s (5)"_s);
    QCOMPARE(bench.pending(), u"Nothing to write."_s);
    QCOMPARE(bench.backups().size(), 1); // as it was before, once
    QCOMPARE(loadConfiguration(bench.folder.filePath(u"backups/"_s + bench.backups().at(0)))
                 ->parameters.at(0x07),
             0);
    editor->setRaw(0);
    QVERIFY2(bench.pending().contains(u"0.5 s → off"_s), qPrintable(bench.pending()));
    QVERIFY(bench.pending().contains(u"keep running if the line is lost"_s));
    bench.click(u"apply"_s);
    QTRY_COMPARE_WITH_TIMEOUT(bench.settings.parameter(0x07), 0, kLongMs);
    QCOMPARE(bench.backups().size(), 1);
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
    QTest::newRow("short hex number") << u"0x7"_s << 5; // serial timeout and 0x7B to 0x7E
    QTest::newRow("hex of two digits") << u"0x07"_s << 1;
    QTest::newRow("decimal number") << u"19 motor"_s << 1; // 0x13, and no text with 19
    QTest::newRow("help") << u"square-law"_s << 1;
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
    bench.controller.noteRestart(u"seen once more"_s);
    QTRY_VERIFY_WITH_TIMEOUT(bench.text(u"banner"_s).isEmpty(), kLongMs);
    QVERIFY(!bench.part<QLabel>(u"message"_s)->isVisible()); // nor by what was said of the write
    QCOMPARE(bench.editor(u"motor-mode"_s)->raw(), 1);
    // It is told here, until the person has seen it.
    QVERIFY(bench.part<QLabel>(u"restarted"_s)->isVisible());
    QTRY_VERIFY(bench.text(u"restarted"_s).contains(u"Everything was read again."_s));
    QVERIFY2(bench.text(u"restarted"_s).contains(u"The controller was restarted at "_s),
             qPrintable(bench.text(u"restarted"_s)));
    QVERIFY(bench.text(u"restarted"_s).endsWith(u"In force since then: Motor mode."_s));
    bench.click(u"reload"_s);
    QTRY_VERIFY_WITH_TIMEOUT(bench.text(u"banner"_s).isEmpty(), kLongMs);
    QVERIFY(bench.part<QLabel>(u"restarted"_s)->isVisible());
    bench.click(u"restarted.dismiss"_s);
    QVERIFY(!bench.part<QLabel>(u"restarted"_s)->isVisible());
}

void TestParametersPanel::restart_seenTwiceIsOne()
{
    RestartLine line(nullptr);
    const auto* const text = line.findChild<QLabel*>(u"parameters.restarted"_s);
    line.tell(RestartLine::Kind::Sure, {12, 3}, {u"Motor mode"_s, u"UART settings"_s});
    line.setReading(RestartLine::Reading::Failed); // the line has other settings now
    line.tell(RestartLine::Kind::Sure, {12, 4}, {u"UART settings"_s});
    line.setReading(RestartLine::Reading::Done);
    QVERIFY2(text->text().endsWith(u"12:04:00. Everything was read again. In force since then: "
                                   "Motor mode, UART settings."_s),
             qPrintable(text->text()));
    line.tell(RestartLine::Kind::Sure, {12, 9}, {});
    QVERIFY(!text->text().contains(u"Motor mode"_s)); // another one
}

void TestParametersPanel::silence_isToldAsAPossibleRestart()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?fault=silent-after=2&fault=silent-for=1.5"_s));
    QTRY_VERIFY_WITH_TIMEOUT(bench.text(u"restarted"_s).contains(u"Everything was read again."_s),
                             kLongMs);
    QVERIFY(bench.text(u"restarted"_s).contains(u"it may have been restarted"_s));
    QVERIFY(!bench.text(u"restarted"_s).contains(u"was restarted"_s));
    bench.controller.close();
    QTRY_VERIFY(!bench.part<QLabel>(u"restarted"_s)->isVisible());
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
    QVERIFY(bench.pending().contains(u"off → 0.5 s"_s));
    QVERIFY(bench.part<QPushButton>(u"apply"_s)->isEnabled());
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

void TestParametersPanel::filter_showsWhatItIsFor_data()
{
    QTest::addColumn<QString>("filter");
    QTest::addColumn<QStringList>("keys");
    QTest::newRow("changed") << u"changed"_s << QStringList{u"aux-acceleration"_s};
    QTest::newRow("not default") << u"notDefault"_s
                                 << QStringList{u"serial-timeout"_s, u"aux-acceleration"_s};
    QTest::newRow("needs power cycle") << u"powerCycle"_s
                                       << QStringList{u"motor-mode"_s, u"channel-input-source"_s,
                                                      u"crc7-polynomial"_s, u"uart-settings"_s};
}

void TestParametersPanel::filter_showsWhatItIsFor()
{
    QFETCH(QString, filter);
    QFETCH(QStringList, keys);
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5"_s));
    bench.editor(u"aux-acceleration"_s)->setRaw(3);
    auto* const box = bench.part<QComboBox>(u"filter"_s);
    box->setCurrentIndex(box->findData(filter));
    QCOMPARE(bench.part<ParameterTable>(u"table"_s)->shownRows(), keys.size());
    for (const auto& key : keys) {
        QVERIFY2(bench.editor(key)->isVisibleTo(&bench.panel), qPrintable(key));
    }
    // Together with the search, and as values change.
    bench.part<QLineEdit>(u"search"_s)->setText(u"hovercraft"_s);
    QCOMPARE(bench.part<ParameterTable>(u"table"_s)->shownRows(), 0);
    QVERIFY(bench.part<QLabel>(u"noRows"_s)->isVisible());
    bench.part<QLineEdit>(u"search"_s)->clear();
    bench.editor(u"device-number"_s)->setRaw(9);
    const int more = filter == u"powerCycle"_s ? 0 : 1;
    QCOMPARE(bench.part<ParameterTable>(u"table"_s)->shownRows(), keys.size() + more);
    bench.editor(u"device-number"_s)->setRaw(7);
    QCOMPARE(bench.part<ParameterTable>(u"table"_s)->shownRows(), keys.size());
}

void TestParametersPanel::preview_isWhatIsSent()
{
    Bench bench;
    LineSettings line;
    line.form = PacketForm::Pololu;
    QVERIFY(bench.connectTo(u"sim:"_s, line));
    bench.editor(u"motor1-current-limit"_s)->setRaw(30);
    bench.editor(u"motor-mode"_s)->setRaw(1);
    QVERIFY2(bench.pending().contains(u"Will be written, 2 settings"_s),
             qPrintable(bench.pending()));
    QVERIFY(bench.pending().contains(
        u"Motor 1 current limit: no limit (unsure) → 2.40 A  [80 07 2F 13 1E 55 2A]"_s));
    QVERIFY(bench.pending().contains(u"[80 07 2F 7B 01 55 2A]"_s));
    QVERIFY(bench.pending().contains(u"Needs a power cycle afterwards: Motor mode."_s));
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"Written and read back"_s));
    QCOMPARE(bench.sentSettings, (QStringList{u"80072F131E552A"_s, u"80072F7B01552A"_s}));
}

void TestParametersPanel::refusal_stopsAndOffersToPutBack()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?firmware=1.0&quirk=unknown-parameter=ff"_s));
    bench.editor(u"serial-timeout"_s)->setRaw(5);
    bench.editor(u"uart-response-delay"_s)->setRaw(1);
    bench.editor(u"motor-mode"_s)->setRaw(1); // comes after the refused one
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"no such parameter"_s));
    QCOMPARE(bench.cell(u"uart-response-delay"_s, ParameterModel::StateColumn), u"refused"_s);
    QVERIFY(bench.text(u"message"_s)
                .contains(u"Written before that, and in the controller now: Serial timeout."_s));
    QCOMPARE(bench.settings.parameter(0x07), 5); // stays until the person says
    QCOMPARE(bench.settings.parameter(0x7B), 0);
    QVERIFY(bench.part<QPushButton>(u"rollback"_s)->text().contains(u"1 value"_s));
    QVERIFY(bench.part<QPushButton>(u"keep"_s)->isVisible());
    bench.click(u"rollback"_s);
    QVERIFY(bench.waitForMessage(u"Put back as before: Serial timeout."_s));
    QCOMPARE(bench.settings.parameter(0x07), 0);
    QCOMPARE(bench.editor(u"serial-timeout"_s)->raw(), 5); // still wanted
    QVERIFY(!bench.part<QPushButton>(u"rollback"_s)->isVisible());
    bench.editor(u"uart-response-delay"_s)->setRaw(0); // another try clears the refusal
    QCOMPARE(bench.cell(u"uart-response-delay"_s, ParameterModel::StateColumn), u"edited"_s);
}

void TestParametersPanel::refusal_mayKeepWhatWasWritten()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?firmware=1.0&quirk=unknown-parameter=ff"_s));
    bench.editor(u"serial-timeout"_s)->setRaw(5);
    bench.editor(u"uart-response-delay"_s)->setRaw(1);
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"no such parameter"_s));
    const int before = bench.writes;
    bench.click(u"keep"_s);
    QVERIFY(!bench.part<QPushButton>(u"rollback"_s)->isVisible());
    QVERIFY(!bench.part<QPushButton>(u"keep"_s)->isVisible());
    QCOMPARE(bench.settings.parameter(0x07), 5);
    QCOMPARE(bench.writes, before);
}

void TestParametersPanel::cancel_stopsBetweenWrites()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    for (const auto& key : {u"serial-timeout"_s, u"motor1-acceleration"_s, u"motor2-acceleration"_s,
                            u"aux-acceleration"_s, u"motor1-brake-duration"_s}) {
        bench.editor(key)->setRaw(4);
    }
    bench.click(u"apply"_s);
    QVERIFY(bench.part<QPushButton>(u"cancel"_s)->isVisible());
    bench.click(u"cancel"_s);
    QVERIFY(bench.waitForMessage(u"Put it back, or keep it?"_s));
    QVERIFY2(bench.writes < 5, qPrintable(QString::number(bench.writes)));
    QVERIFY(bench.part<QPushButton>(u"apply"_s)->isEnabled()); // the rest is still to be written
    bench.click(u"rollback"_s);
    QVERIFY(bench.waitForMessage(u"Put back as before"_s));
    for (const int number : {0x07, 0x0E, 0x0F, 0x10, 0x11}) {
        QCOMPARE(bench.settings.parameter(static_cast<std::uint8_t>(number)), 0);
    }
}

void TestParametersPanel::numberInUse_isToldBeforeWriting()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    LineSettingsStore(bench.file).rememberNumbers(bench.controller.options().port, {7, 9});
    bench.editor(u"device-number"_s)->setRaw(9);
    QVERIFY(bench.pending().contains(u"has device number 9 already"_s));
    bench.editor(u"device-number"_s)->setRaw(10);
    QVERIFY(!bench.pending().contains(u"already"_s));
}

void TestParametersPanel::newPanel_takesTheEditsOver()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.editor(u"serial-timeout"_s)->setRaw(5);
    auto first = std::make_unique<ParametersPanel>(bench.context);
    QTRY_VERIFY_WITH_TIMEOUT(bench.text(u"banner"_s).isEmpty(), kLongMs);
    first->findChild<ParameterField*>(u"parameters.motor-mode.editor"_s)->setRaw(1);
    const ParametersPanel second(bench.context);
    first.reset(); // a change of language makes the new window before the old one goes
    QCOMPARE(second.findChild<ParameterField*>(u"parameters.motor-mode.editor"_s)->raw(), 1);
}

QTEST_MAIN(TestParametersPanel)
#include "tst_parameterspanel.moc"
