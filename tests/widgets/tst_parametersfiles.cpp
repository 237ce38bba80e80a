// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/configtransfer.h"
#include "tests/widgets/parametersbench.h"

#include <QCheckBox>
#include <QClipboard>
#include <QGuiApplication>
#include <QScrollBar>
#include <QTreeWidget>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using Bench = trex::test::ParametersBench;
using trex::test::kLongMs;

namespace {

/// What the controller holds, with some of it changed, as a file.
QString fileWith(Bench& bench, const ParameterValues& changes)
{
    auto configuration = presentConfiguration(bench.controller, bench.settings);
    for (const auto& [number, raw] : changes) {
        configuration.parameters[number] = raw;
    }
    configuration.calibrations[InputKind::Rc][2].deadband = 77;
    const QString path = bench.folder.filePath(u"changed.json"_s);
    return saveConfiguration(configuration, path) ? path : QString();
}

} // namespace

class TestParametersFiles : public QObject {
    Q_OBJECT

private slots:
    void defaults_tellWhichAreGuesses();
    void saveAndLoad_goThroughAFile();
    void badFile_changesNothing();
    void differences_areTakenOrLeft();
    void differences_noneAndAll();
    void fileOfAnotherController_isTold();
    void dialogs_areAsWideAsTheirColumns();
    void comparison_ofControllerFileAndDefaults();
    void factoryReset_isGuardedSavedAndDone();
    void factoryReset_isNotDoneUnsaved();
};

void TestParametersFiles::defaults_tellWhichAreGuesses()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5&param=motor1-pwm-prescaler=2"_s));
    bench.click(u"defaults"_s);
    QVERIFY(bench.pending().contains(u"Serial timeout: 0.5 s → off"_s));
    QVERIFY(bench.pending().contains(u"Motor 1 PWM prescaler"_s));
    QVERIFY(bench.text(u"message"_s).contains(u"1 are marked ≈"_s)
            || bench.text(u"message"_s).contains(u"1 is marked ≈"_s));
    QCOMPARE(bench.writes, 0);
}

void TestParametersFiles::saveAndLoad_goThroughAFile()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5"_s));
    const QString path = bench.folder.filePath(u"mine.json"_s);
    bench.dialogs.answerNext(path);
    bench.click(u"save"_s);
    QTRY_VERIFY(QFile::exists(path));
    auto saved = loadConfiguration(path);
    QVERIFY(saved && isComplete(*saved));
    QCOMPARE(saved->signature, u"TReXJr1.2"_s);
    QCOMPARE(saved->firmware, u"1.2"_s);
    saved->parameters[0x07] = 9;
    saved->calibrations[InputKind::Rc][2].deadband = 77;
    QVERIFY(saveConfiguration(*saved, path).has_value());
    bench.dialogs.answerNext(path);
    bench.click(u"load"_s);
    QTRY_VERIFY(bench.pending().contains(u"Serial timeout: 0.5 → 0.9 s"_s));
    QVERIFY(bench.pending().contains(u"Calibration of channel 2 (RC)"_s));
    bench.click(u"apply"_s);
    QVERIFY(bench.waitForMessage(u"Written and read back"_s));
    QCOMPARE(bench.settings.parameter(0x07), 9);
    QCOMPARE(bench.settings.calibration(InputKind::Rc, 2)->deadband, 77);
    QCOMPARE(bench.pending(), u"Nothing to write."_s);
}

void TestParametersFiles::badFile_changesNothing()
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

void TestParametersFiles::differences_areTakenOrLeft()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.dialogs.answerNext(fileWith(bench, {{0x07, 9}, {0x0E, 4}}));
    bench.click(u"load"_s);
    QTRY_VERIFY(bench.dialog(u"differences"_s) != nullptr);
    // All is filled in at once: nothing has to be answered before Apply.
    QVERIFY(bench.part<QPushButton>(u"apply"_s)->isEnabled());
    QVERIFY(bench.pending().contains(u"Will be written, 3 settings"_s));
    QVERIFY(!bench.dialog(u"differences"_s)->isModal());
    const auto box = [&bench](const QString& key) {
        return bench.dialog(u"differences"_s)
            ->findChild<QCheckBox*>(u"parameters.differences."_s + key);
    };
    QVERIFY(box(u"serial-timeout"_s)->isChecked());
    box(u"serial-timeout"_s)->click();
    QCOMPARE(bench.editor(u"serial-timeout"_s)->raw(), 0);
    box(u"calibration.rc.2"_s)->click();
    QVERIFY2(bench.pending().startsWith(u"Will be written: Motor 1 acceleration"_s),
             qPrintable(bench.pending()));
    box(u"calibration.rc.2"_s)->click();
    QVERIFY(bench.pending().contains(u"Calibration of channel 2"_s));
    bench.click(u"apply"_s);
    QTRY_VERIFY(bench.dialog(u"differences"_s) == nullptr);
    QVERIFY(bench.waitForMessage(u"Written and read back"_s));
    QCOMPARE(bench.settings.parameter(0x07), 0); // left
    QCOMPARE(bench.settings.parameter(0x0E), 4); // taken
    QCOMPARE(bench.settings.calibration(InputKind::Rc, 2)->deadband, 77);
}

void TestParametersFiles::differences_noneAndAll()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.dialogs.answerNext(fileWith(bench, {{0x07, 9}, {0x0E, 4}}));
    bench.click(u"load"_s);
    QTRY_VERIFY(bench.dialog(u"differences"_s) != nullptr);
    const auto press = [&bench](const QString& name) {
        bench.panel.findChild<QPushButton*>(u"parameters.differences."_s + name)->click();
    };
    press(u"none"_s);
    QCOMPARE(bench.pending(), u"Nothing to write."_s);
    press(u"all"_s);
    QVERIFY(bench.pending().contains(u"3 settings"_s));
    QTest::keyClick(bench.dialog(u"differences"_s), Qt::Key_Escape); // stops motors, loses nothing
    QTRY_VERIFY(bench.dialog(u"differences"_s) == nullptr);
    QVERIFY(bench.pending().contains(u"3 settings"_s));
    bench.click(u"revert"_s);
    QCOMPARE(bench.pending(), u"Nothing to write."_s);
    QCOMPARE(bench.writes, 0);
}

void TestParametersFiles::fileOfAnotherController_isTold()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    auto other = presentConfiguration(bench.controller, bench.settings);
    other.signature = u"TReX1.2"_s;
    other.parameters[0x07] = 9;
    other.parameters[0x13] = 10; // 10 × 2 × 150 mA there, 37.5 steps of 80 mA here
    const QString path = bench.folder.filePath(u"other.json"_s);
    QVERIFY(saveConfiguration(other, path).has_value());
    bench.dialogs.answerNext(path);
    bench.click(u"load"_s);
    QVERIFY(bench.waitForMessage(u"The file is of a TReX, the controller is a TReX Jr."_s));
    QVERIFY(bench.waitForMessage(u"(raw 38), since the two models count currents"_s));
    QCOMPARE(bench.editor(u"motor1-current-limit"_s)->raw(), 38);
    QVERIFY(bench.panel.findChild<QLabel*>(u"parameters.differences.remarks"_s)
                ->text()
                .contains(u"(raw 38)"_s));
}

void TestParametersFiles::dialogs_areAsWideAsTheirColumns()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    const QString path = fileWith(bench, {{0x7E, 0x1A}}); // the longest text of all
    const auto isAllSeen = [](const QDialog* dialog) {
        const auto* const bar = dialog->findChild<QTreeWidget*>()->horizontalScrollBar();
        return QTest::qWaitFor([bar] { return bar->maximum() == 0; });
    };
    bench.dialogs.answerNext(path);
    bench.click(u"load"_s);
    QTRY_VERIFY(bench.dialog(u"differences"_s) != nullptr);
    QVERIFY(isAllSeen(bench.dialog(u"differences"_s)));
    bench.dialog(u"differences"_s)->close();
    bench.trigger(u"compare"_s);
    bench.dialogs.answerNext(path);
    bench.dialog(u"comparison"_s)
        ->findChild<QPushButton*>(u"parameters.comparison.rightFile"_s)
        ->click();
    QTRY_COMPARE(bench.dialog(u"comparison"_s)->findChild<QTreeWidget*>()->topLevelItemCount(), 2);
    QVERIFY(isAllSeen(bench.dialog(u"comparison"_s)));
}

void TestParametersFiles::comparison_ofControllerFileAndDefaults()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5"_s));
    bench.trigger(u"compare"_s);
    auto* const dialog = bench.dialog(u"comparison"_s);
    QVERIFY(dialog != nullptr);
    const auto* const table = dialog->findChild<QTreeWidget*>(u"parameters.comparison.table"_s);
    const auto* const summary = dialog->findChild<QLabel*>(u"parameters.comparison.summary"_s);
    QCOMPARE(table->topLevelItemCount(), 1); // against the defaults
    QCOMPARE(table->topLevelItem(0)->text(0), u"serial-timeout"_s);
    QCOMPARE(table->topLevelItem(0)->text(2), u"0.5 s (5)"_s);
    QCOMPARE(table->topLevelItem(0)->text(3), u"≈ off (0)"_s); // a guess, and marked so
    QCOMPARE(summary->text().left(18), u"1 setting differs."_s);
    bench.dialogs.answerNext(fileWith(bench, {{0x0E, 4}}));
    dialog->findChild<QPushButton*>(u"parameters.comparison.rightFile"_s)->click();
    QTRY_COMPARE(table->topLevelItemCount(), 2);
    QCOMPARE(table->topLevelItem(0)->text(0), u"motor1-acceleration"_s);
    QCOMPARE(table->topLevelItem(1)->text(0), u"calibration.rc.2"_s);
    dialog->findChild<QPushButton*>(u"parameters.comparison.copy"_s)->click();
    QVERIFY(QGuiApplication::clipboard()->text().contains(
        u"motor1-acceleration\tMotor 1 acceleration\tunlimited (0)\t4\n"_s));
    // File against file, and what is read later is followed.
    bench.dialogs.answerNext(bench.folder.filePath(u"changed.json"_s));
    dialog->findChild<QPushButton*>(u"parameters.comparison.leftFile"_s)->click();
    QTRY_COMPARE(summary->text(), u"No differences."_s);
    bench.dialogs.answerNext(bench.folder.filePath(u"settings.ini"_s)); // is no configuration
    dialog->findChild<QPushButton*>(u"parameters.comparison.leftFile"_s)->click();
    QTRY_VERIFY(summary->text().startsWith(u'▲'));
    QCOMPARE(bench.writes, 0);
}

void TestParametersFiles::factoryReset_isGuardedSavedAndDone()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5&param=motor1-acceleration=7"_s));
    bench.trigger(u"factoryReset"_s);
    auto* dialog = bench.dialog(u"factoryResetDialog"_s);
    QVERIFY(dialog != nullptr);
    auto* reset = dialog->findChild<QPushButton*>(u"parameters.factoryReset.reset"_s);
    QVERIFY(!reset->isEnabled()); // before the box is ticked
    QVERIFY(dialog->findChild<QPushButton*>(u"parameters.factoryReset.cancel"_s)->isDefault());
    QVERIFY(dialog->findChild<QLabel*>(u"parameters.factoryReset.text"_s)->text().contains(u'≈'));
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY(bench.dialog(u"factoryResetDialog"_s) == nullptr);
    QCOMPARE(bench.writes, 0);

    bench.trigger(u"factoryReset"_s);
    dialog = bench.dialog(u"factoryResetDialog"_s);
    dialog->findChild<QCheckBox*>(u"parameters.factoryReset.confirm"_s)->click();
    reset = dialog->findChild<QPushButton*>(u"parameters.factoryReset.reset"_s);
    QVERIFY(reset->isEnabled());
    reset->click();
    QVERIFY(bench.waitForMessage(u"Switch its power off and on"_s));
    QCOMPARE(bench.writes, 1);
    QCOMPARE(bench.backups().size(), 1);
    QCOMPARE(loadConfiguration(bench.folder.filePath(u"backups/"_s + bench.backups().at(0)))
                 ->parameters.at(0x0E),
             7);
    bench.controller.powerCycleSimulator();
    QTRY_COMPARE_WITH_TIMEOUT(bench.settings.parameter(0x0E), 0, kLongMs);
    QTRY_COMPARE_WITH_TIMEOUT(bench.editor(u"serial-timeout"_s)->raw(), 0, kLongMs);
    // The power cycle has been: it is not asked for any more, and where the backup is stays.
    QVERIFY(!bench.text(u"message"_s).contains(u"Switch its power off and on"_s));
    QVERIFY(bench.text(u"message"_s).contains(bench.backups().at(0)));
    bench.controller.noteRestart(u"seen twice"_s);
    QVERIFY(bench.part<QLabel>(u"message"_s)->isVisible());
    QVERIFY(!bench.text(u"banner"_s).contains(u"power cycle"_s));
}

void TestParametersFiles::factoryReset_isNotDoneUnsaved()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5"_s));
    QFile inTheWay(bench.folder.filePath(u"backups"_s)); // a file where the folder should be
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    bench.trigger(u"factoryReset"_s);
    auto* const dialog = bench.dialog(u"factoryResetDialog"_s);
    dialog->findChild<QCheckBox*>(u"parameters.factoryReset.confirm"_s)->click();
    dialog->findChild<QPushButton*>(u"parameters.factoryReset.reset"_s)->click();
    QVERIFY(bench.waitForMessage(u"Nothing is reset"_s));
    bench.click(u"reload"_s); // what had been sent would have left before that
    QTRY_VERIFY_WITH_TIMEOUT(bench.text(u"banner"_s).isEmpty(), kLongMs);
    QCOMPARE(bench.writes, 0);
    QCOMPARE(bench.settings.parameter(0x07), 5);
}

QTEST_MAIN(TestParametersFiles)
#include "tst_parametersfiles.moc"
