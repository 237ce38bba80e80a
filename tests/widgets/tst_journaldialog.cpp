// SPDX-License-Identifier: GPL-3.0-or-later
// The journal's window over the real façade and a simulated controller.
#include "tests/support/panelbench.h"
#include "widgets/journal/journaldialog.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr const ParameterRow& kTimeout = parameterRow("serial-timeout");

/// A bare panel: only its context is used.
class NoPanel : public Panel {
public:
    using Panel::Panel;
};

class Bench : public test::PanelBench<NoPanel> {
public:
    Bench()
        : journal(folder.filePath(u"journal.sqlite"_s))
        , audit(controller, settings, journal, WriteAudit::WhenUnsaved::RefuseOnce)
    {
        context.audit = &audit;
    }
    [[nodiscard]] bool open(const QString& query = {})
    {
        return connectTo(u"sim:?pace=0"_s + query);
    }
    [[nodiscard]] bool write(int raw)
    {
        std::optional<bool> isWritten;
        settings.writeParameter(kTimeout, raw, true, this,
                                [&](const auto& result) { isWritten = result.has_value(); });
        return QTest::qWaitFor([&] { return isWritten.has_value(); }) && *isWritten;
    }

    Journal journal;
    WriteAudit audit;
};

template <class T>
T* part(JournalDialog& dialog, const char* name)
{
    return dialog.findChild<T*>(u"journal."_s + QLatin1StringView(name));
}

void choose(QTableView* table, int row)
{
    table->setCurrentIndex(table->model()->index(row, 0));
}

QString cell(QTableView* table, int row, int column)
{
    return table->model()->index(row, column).data().toString();
}

} // namespace

class TestJournalDialog : public QObject {
    Q_OBJECT

private slots:
    void models_areSound();
    void writes_areListedNewestFirstInWords();
    void search_leavesWhatFits();
    void revert_listsThenWritesThenReadsBack();
    void revert_nothingIsWrittenWithoutTheSecondClick();
    void checkpoint_isKeptAndRestored();
    void checkpoint_isExportedAsAFile();
    void automaticCheckpoint_cannotBeDeleted();
    void withoutController_itCanBeRead();
    void outsideSerialMode_itSaysWhy();
    void lostLine_dropsThePlan();
    void otherControllersEntry_cannotBeRevertedTo();
    void isOpenedOnce();
};

void TestJournalDialog::models_areSound()
{
    JournalModel entries;
    CheckpointModel checkpoints;
    QAbstractItemModelTester testEntries(&entries,
                                         QAbstractItemModelTester::FailureReportingMode::QtTest);
    QAbstractItemModelTester testCheckpoints(
        &checkpoints, QAbstractItemModelTester::FailureReportingMode::QtTest);
    JournalEntry entry;
    entry.number = 3;
    entry.intent.setting.row = &kTimeout;
    entries.show({entry, entry});
    checkpoints.show({Checkpoint{}});
    QCOMPARE(entries.rowCount(), 2);
    QCOMPARE(entries.rowOf(3), 0);
    QCOMPARE(entries.rowOf(4), -1);
    entries.show({});
}

void TestJournalDialog::writes_areListedNewestFirstInWords()
{
    Bench bench;
    QVERIFY(bench.open());
    QVERIFY(bench.write(5) && bench.write(20));
    JournalDialog dialog(bench.context);
    auto* const table = part<QTableView>(dialog, "table");
    QCOMPARE(table->model()->rowCount(), 2);
    QCOMPARE(cell(table, 0, JournalModel::SettingColumn), u"Serial timeout"_s);
    QVERIFY(cell(table, 0, JournalModel::ChangeColumn).contains(u"2000 ms"_s));
    QVERIFY(cell(table, 0, JournalModel::ResultColumn).startsWith(u'✓'));
    QVERIFY(table->isColumnHidden(JournalModel::ControllerColumn));
    part<QComboBox>(dialog, "which")->setCurrentIndex(1);
    QVERIFY(!table->isColumnHidden(JournalModel::ControllerColumn));
    QVERIFY(cell(table, 0, JournalModel::ControllerColumn).contains(u"TReX Jr 1.2"_s));
    QVERIFY(bench.write(30)); // appears by itself
    QCOMPARE(table->model()->rowCount(), 3);
}

void TestJournalDialog::search_leavesWhatFits()
{
    Bench bench;
    QVERIFY(bench.open());
    QVERIFY(bench.write(5) && bench.write(20));
    JournalDialog dialog(bench.context);
    auto* const table = part<QTableView>(dialog, "table");
    QTest::keyClicks(part<QLineEdit>(dialog, "search"), u"2000 MS"_s);
    QCOMPARE(table->model()->rowCount(), 1);
    QTest::keyClicks(part<QLineEdit>(dialog, "search"), u"x"_s);
    QCOMPARE(table->model()->rowCount(), 0);
}

void TestJournalDialog::revert_listsThenWritesThenReadsBack()
{
    Bench bench;
    QVERIFY(bench.open());
    QVERIFY(bench.write(5) && bench.write(20));
    JournalDialog dialog(bench.context);
    dialog.show();
    auto* const revert = part<QPushButton>(dialog, "revert");
    QVERIFY(!revert->isEnabled()); // nothing is chosen
    choose(part<QTableView>(dialog, "table"), 1);
    QVERIFY(revert->isEnabled());
    revert->click();
    auto* const plan = part<QPlainTextEdit>(dialog, "plan");
    QTRY_VERIFY_WITH_TIMEOUT(plan->isVisible(), 5000);
    QVERIFY2(plan->toPlainText().startsWith(u"Serial timeout: 2000"_s),
             qPrintable(plan->toPlainText()));
    QCOMPARE(plan->toPlainText().count(u'\n'), 0); // only what differs
    part<QPushButton>(dialog, "write")->click();
    QTRY_COMPARE_WITH_TIMEOUT(bench.settings.parameter(kTimeout.number), std::optional(0), 5000);
    QTRY_VERIFY_WITH_TIMEOUT(!plan->isVisible(), 5000);
    QCOMPARE(part<QTableView>(dialog, "table")->model()->rowCount(), 3);
    QVERIFY(part<QLabel>(dialog, "message")->text().contains(u"read back"_s));
}

void TestJournalDialog::revert_nothingIsWrittenWithoutTheSecondClick()
{
    Bench bench;
    QVERIFY(bench.open());
    QVERIFY(bench.write(5));
    JournalDialog dialog(bench.context);
    dialog.show();
    choose(part<QTableView>(dialog, "table"), 0);
    part<QPushButton>(dialog, "revert")->click();
    auto* const plan = part<QPlainTextEdit>(dialog, "plan");
    QTRY_VERIFY_WITH_TIMEOUT(plan->isVisible(), 5000);
    part<QPushButton>(dialog, "dismiss")->click();
    QVERIFY(!plan->isVisible());
    QVERIFY(!part<QPushButton>(dialog, "write")->isEnabled());
    QCOMPARE(bench.journal.entries({})->size(), std::size_t{1});
}

void TestJournalDialog::checkpoint_isKeptAndRestored()
{
    Bench bench;
    QVERIFY(bench.open());
    JournalDialog dialog(bench.context);
    dialog.show();
    auto* const keep = part<QPushButton>(dialog, "checkpoint");
    auto* const table = part<QTableView>(dialog, "checkpoints");
    QVERIFY(!keep->isEnabled()); // it needs a name
    QTest::keyClicks(part<QLineEdit>(dialog, "checkpointName"), u"race"_s);
    QVERIFY(keep->isEnabled());
    keep->click();
    QTRY_COMPARE_WITH_TIMEOUT(table->model()->rowCount(), 1, 5000);
    QCOMPARE(cell(table, 0, CheckpointModel::NameColumn), u"race"_s);
    QVERIFY(bench.write(5)); // and with it the automatic one
    QCOMPARE(table->model()->rowCount(), 2);
    choose(table, 1);
    part<QPushButton>(dialog, "restore")->click();
    QTRY_VERIFY_WITH_TIMEOUT(part<QPushButton>(dialog, "write")->isEnabled(), 5000);
    part<QPushButton>(dialog, "write")->click();
    QTRY_COMPARE_WITH_TIMEOUT(bench.settings.parameter(kTimeout.number), std::optional(0), 5000);
}

void TestJournalDialog::checkpoint_isExportedAsAFile()
{
    Bench bench;
    QVERIFY(bench.open());
    QVERIFY(bench.write(5));
    JournalDialog dialog(bench.context);
    choose(part<QTableView>(dialog, "checkpoints"), 0);
    const QString path = bench.folder.filePath(u"export.json"_s);
    bench.dialogs.answerNext(path);
    part<QPushButton>(dialog, "export")->click();
    QTRY_VERIFY(QFile::exists(path));
    const auto loaded = loadConfiguration(path);
    QVERIFY2(loaded, loaded ? "" : qPrintable(loaded.error().context));
    QCOMPARE(loaded->parameters.at(kTimeout.number), 0);
}

void TestJournalDialog::automaticCheckpoint_cannotBeDeleted()
{
    Bench bench;
    QVERIFY(bench.open());
    QVERIFY(bench.write(5));
    QVERIFY(bench.journal.saveCheckpoint(bench.audit.controller(), u"mine"_s, {}));
    JournalDialog dialog(bench.context);
    auto* const table = part<QTableView>(dialog, "checkpoints");
    auto* const remove = part<QPushButton>(dialog, "delete");
    choose(table, 1);
    QVERIFY(!remove->isEnabled());
    choose(table, 0);
    QVERIFY(remove->isEnabled());
    remove->click();
    QCOMPARE(table->model()->rowCount(), 1);
}

void TestJournalDialog::withoutController_itCanBeRead()
{
    Bench bench;
    QVERIFY(bench.journal.intend({u"/dev/ttyUSB0"_s, u"TReXJr1.2"_s, 7},
                                 {{.row = &kTimeout}, 0, 5, {}}));
    JournalDialog dialog(bench.context);
    dialog.show();
    QCOMPARE(part<QTableView>(dialog, "table")->model()->rowCount(), 1);
    choose(part<QTableView>(dialog, "table"), 0);
    QVERIFY(!part<QPushButton>(dialog, "revert")->isEnabled());
    QVERIFY(part<QLabel>(dialog, "reason")->text().contains(u"Not connected"_s));
}

void TestJournalDialog::outsideSerialMode_itSaysWhy()
{
    Bench bench;
    QVERIFY(bench.open(u"&mode=rc"_s));
    QVERIFY(!bench.write(5)); // refused, and in the journal
    JournalDialog dialog(bench.context);
    auto* const table = part<QTableView>(dialog, "table");
    QVERIFY(cell(table, 0, JournalModel::ResultColumn).startsWith(u'✕'));
    choose(table, 0);
    QVERIFY(!part<QPushButton>(dialog, "revert")->isEnabled());
    QVERIFY(part<QLabel>(dialog, "reason")->text().contains(u"RC mode"_s));
}

void TestJournalDialog::lostLine_dropsThePlan()
{
    Bench bench;
    QVERIFY(bench.open());
    QVERIFY(bench.write(5));
    JournalDialog dialog(bench.context);
    dialog.show();
    choose(part<QTableView>(dialog, "table"), 0);
    part<QPushButton>(dialog, "revert")->click();
    auto* const plan = part<QPlainTextEdit>(dialog, "plan");
    QTRY_VERIFY_WITH_TIMEOUT(plan->isVisible(), 5000);
    bench.controller.close();
    QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Disconnected, 5000);
    QVERIFY(!plan->isVisible());
}

void TestJournalDialog::otherControllersEntry_cannotBeRevertedTo()
{
    Bench bench;
    QVERIFY(bench.open());
    QVERIFY(bench.journal.intend({u"/dev/ttyUSB0"_s, u"TReXJr1.2"_s, 7},
                                 {{.row = &kTimeout}, 0, 5, {}}));
    JournalDialog dialog(bench.context);
    QCOMPARE(part<QTableView>(dialog, "table")->model()->rowCount(), 0);
    part<QComboBox>(dialog, "which")->setCurrentIndex(1);
    choose(part<QTableView>(dialog, "table"), 0);
    QVERIFY(!part<QPushButton>(dialog, "revert")->isEnabled());
}

void TestJournalDialog::isOpenedOnce()
{
    Bench bench;
    JournalDialog::bringForward(bench.context, &bench.panel);
    JournalDialog::bringForward(bench.context, &bench.panel);
    const auto dialogs = bench.panel.findChildren<JournalDialog*>();
    QCOMPARE(dialogs.size(), 1);
    QVERIFY(!dialogs.front()->isModal());
    QVERIFY(dialogs.front()->findChild<QPushButton*>(u"journal.stop"_s)->isEnabled());
}

QTEST_MAIN(TestJournalDialog)
#include "tst_journaldialog.moc"
