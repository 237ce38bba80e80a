// SPDX-License-Identifier: GPL-3.0-or-later
// The bench panel: nothing moves without the one confirmation, a dry run sends nothing, STOP ends
// it, results are judged as the person says, and what it writes can be read.
#include "tests/support/panelbench.h"
#include "widgets/bench/benchpanel.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableView>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kLongMs = 30'000;
constexpr int kLeftRight = 3;

struct Bench : test::PanelBench<BenchPanel> {
    [[nodiscard]] QPushButton* button(const QString& name) const
    {
        return part<QPushButton>(u"bench."_s + name);
    }
    /// And until the panel knows that it may start.
    [[nodiscard]] bool connectTo(const QString& port)
    {
        return PanelBench::connectTo(port)
            && QTest::qWaitFor([this] { return button(u"start"_s)->isEnabled(); }, kLongMs);
    }
    void click(const QString& name) const { button(name)->click(); }
    [[nodiscard]] QString text(const QString& name) const
    {
        return part<QLabel>(u"bench."_s + name)->text();
    }
    [[nodiscard]] QAbstractItemModel& steps() const
    {
        return *part<QTableView>(u"bench.steps"_s)->model();
    }
    [[nodiscard]] QAbstractItemModel& results() const
    {
        return *part<QTableView>(u"bench.results"_s)->model();
    }
    /// A test of a second of the person's own.
    void openShort()
    {
        QFile written(folder.filePath(u"short.json"_s));
        QVERIFY(written.open(QIODevice::WriteOnly));
        written.write(
            R"({"format":"trexpanel-bench-profile","version":1,"name":"Short","motor":"1","limits":{"staleSeconds":5},
            "expect":{"motor1.mean-current":{"maximum":4}},
            "steps":[{"do":"set","speed":50},{"do":"hold","seconds":0.8}]})");
        written.close();
        dialogs.answerNext(written.fileName());
        click(u"open"_s);
        QTRY_COMPARE(part<QListWidget>(u"bench.list"_s)->count(), 7);
    }
    [[nodiscard]] bool dryRun()
    {
        click(u"dryRun"_s);
        return QTest::qWaitFor([this] { return panel.state() == u"idle"_s; }, kLongMs);
    }
    [[nodiscard]] bool hasMoved() const
    {
        return std::ranges::any_of(motorPackets,
                                   [](const QString& hex) { return !hex.endsWith(u"00"_s); });
    }
};

} // namespace

class TestBenchPanel : public QObject {
    Q_OBJECT

private slots:
    void readyTests_areListed();
    void dryRun_sendsNothing();
    void start_needsAConfirmation();
    void run_endsStopped();
    void stop_endsTheTest();
    void leaving_stopsTheMotors();
    void notConnected_saysSo();
    void motionLimits_areNoticed();
    void jointMode_isRefused();
    void expectations_areEdited();
    void steps_areEdited();
    void badFile_isNamed();
    void files_canBeRead();
    void everyControl_hasAName();
};

void TestBenchPanel::readyTests_areListed()
{
    Bench bench;
    QCOMPARE(bench.part<QListWidget>(u"bench.list"_s)->count(), 6);
    QCOMPARE(bench.panel.state(), u"idle"_s);
    QVERIFY(bench.steps().rowCount() > 5);
    QVERIFY(!bench.button(u"html"_s)->isEnabled());
    new QAbstractItemModelTester(&bench.steps(), &bench.panel);
    new QAbstractItemModelTester(&bench.results(), &bench.panel);
    for (int row = 0; row < 6; ++row) {
        bench.part<QListWidget>(u"bench.list"_s)->setCurrentRow(row);
        QVERIFY(!bench.text(u"description"_s).isEmpty());
    }
}

void TestBenchPanel::dryRun_sendsNothing()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.part<QListWidget>(u"bench.list"_s)->setCurrentRow(kLeftRight);
    QVERIFY(bench.dryRun());
    QVERIFY(bench.text(u"verdict"_s).contains(u"Passed"_s));
    QVERIFY(bench.text(u"verdict"_s).contains(u"Dry run"_s));
    QVERIFY(bench.results().rowCount() > 3);
    QVERIFY(bench.motorPackets.isEmpty());
    QVERIFY(!bench.controller.isArmed());
}

void TestBenchPanel::start_needsAConfirmation()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.openShort();
    QVERIFY(bench.motorPackets.isEmpty());
    QTRY_VERIFY(bench.button(u"start"_s)->isEnabled());
    bench.click(u"start"_s);
    QCOMPARE(bench.panel.state(), u"confirm"_s);
    QVERIFY(bench.text(u"confirmText"_s).contains(u"Motor 1 up to speed 50 (39 %)"_s));
    QVERIFY(!bench.text(u"confirmText"_s).contains(u"Motor 2"_s));
    QVERIFY(!bench.controller.isArmed());
    bench.click(u"back"_s);
    QCOMPARE(bench.panel.state(), u"idle"_s);
    // Choosing another test, editing and STOP all take the question back.
    bench.click(u"start"_s);
    bench.part<QListWidget>(u"bench.list"_s)->setCurrentRow(0);
    QCOMPARE(bench.panel.state(), u"idle"_s);
    bench.click(u"start"_s);
    bench.controller.stop();
    QCOMPARE(bench.panel.state(), u"idle"_s);
    bench.click(u"confirm"_s); // hidden by now, and without effect
    QTest::qWait(100);
    QVERIFY(!bench.hasMoved());
}

void TestBenchPanel::run_endsStopped()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.openShort();
    bench.click(u"start"_s);
    bench.click(u"confirm"_s);
    QCOMPARE(bench.panel.state(), u"running"_s);
    QVERIFY(bench.controller.isArmed());
    QTRY_COMPARE_WITH_TIMEOUT(bench.panel.state(), u"idle"_s, kLongMs);
    QVERIFY2(bench.text(u"verdict"_s).contains(u"Passed"_s), qPrintable(bench.text(u"verdict"_s)));
    QVERIFY(!bench.text(u"verdict"_s).contains(u"Dry run"_s));
    QVERIFY(bench.hasMoved());
    QVERIFY(!bench.controller.isArmed());
    QTRY_COMPARE(bench.lastMotorPacket(), u"F000"_s);
}

void TestBenchPanel::stop_endsTheTest()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.click(u"start"_s);
    bench.click(u"confirm"_s);
    QTRY_VERIFY_WITH_TIMEOUT(bench.hasMoved(), kLongMs);
    QTest::mousePress(bench.button(u"stop"_s), Qt::LeftButton);
    QTRY_COMPARE(bench.panel.state(), u"idle"_s);
    QVERIFY(!bench.controller.isArmed());
    QVERIFY(bench.text(u"verdict"_s).contains(u"Not passed"_s));
    QTRY_COMPARE(bench.lastMotorPacket(), u"F000"_s);
    QTRY_VERIFY(bench.button(u"start"_s)->isEnabled()); // after the lock-out
}

void TestBenchPanel::leaving_stopsTheMotors()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.click(u"start"_s);
    bench.click(u"confirm"_s);
    QTRY_VERIFY_WITH_TIMEOUT(bench.hasMoved(), kLongMs);
    bench.controller.close();
    QTRY_COMPARE(bench.panel.state(), u"idle"_s);
    QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
    QCOMPARE(bench.lastMotorPacket(), u"F000"_s);
    QVERIFY(!bench.button(u"start"_s)->isEnabled());
}

void TestBenchPanel::notConnected_saysSo()
{
    Bench bench;
    QVERIFY(!bench.button(u"start"_s)->isEnabled());
    QCOMPARE(bench.text(u"status"_s), u"Not connected."_s);
    QVERIFY(bench.button(u"dryRun"_s)->isEnabled()); // needs nobody
}

void TestBenchPanel::motionLimits_areNoticed()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    MotionLimits limits;
    limits.softStart = 100;
    bench.controller.setMotionLimits(limits);
    bench.openShort();
    bench.click(u"start"_s);
    bench.click(u"confirm"_s);
    QTRY_COMPARE(bench.panel.state(), u"idle"_s);
    QTRY_VERIFY2(bench.text(u"status"_s).contains(u"motion limits"_s),
                 qPrintable(bench.text(u"status"_s)));
    QVERIFY(!bench.hasMoved());
    // And it stays, although the gate opens again half a second after the stop.
    QTRY_VERIFY(bench.button(u"start"_s)->isEnabled());
    QVERIFY(bench.text(u"status"_s).contains(u"motion limits"_s));
}

void TestBenchPanel::jointMode_isRefused()
{
    Bench bench;
    QVERIFY(bench.PanelBench::connectTo(u"sim:?param=motor-mode=1"_s)); // C-31
    QTRY_VERIFY(bench.text(u"status"_s).contains(u"joint mode"_s));
    QVERIFY(!bench.button(u"start"_s)->isEnabled());
}

void TestBenchPanel::expectations_areEdited()
{
    Bench bench;
    bench.part<QListWidget>(u"bench.list"_s)->setCurrentRow(kLeftRight);
    QVERIFY(bench.dryRun());
    auto& results = bench.results();
    const int maximum = BenchResultModel::MaximumColumn;
    QVERIFY(bench.text(u"verdict"_s).startsWith(u"✔"_s));
    QVERIFY(results.setData(results.index(2, maximum), u"50"_s, Qt::EditRole)); // the ratio: 100 %
    QVERIFY(bench.text(u"verdict"_s).startsWith(u"✖"_s));
    QVERIFY(
        results.index(2, BenchResultModel::VerdictColumn).data().toString().contains(u"failed"_s));
    QVERIFY(!results.setData(results.index(2, maximum), u"much"_s, Qt::EditRole));
    QVERIFY(results.setData(results.index(2, maximum), QString(), Qt::EditRole));
    QVERIFY(bench.text(u"verdict"_s).startsWith(u"✔"_s));
}

void TestBenchPanel::steps_areEdited()
{
    Bench bench;
    bench.openShort();
    QCOMPARE(bench.steps().rowCount(), 2);
    auto* view = bench.part<QTableView>(u"bench.steps"_s);
    view->selectRow(0);
    bench.part<QSpinBox>(u"bench.step.speed"_s)->setValue(77);
    QVERIFY(bench.steps().index(0, BenchStepModel::WhatColumn).data().toString().contains(u"77"_s));
    bench.click(u"add"_s); // a hold behind it
    QCOMPARE(bench.steps().rowCount(), 3);
    QCOMPARE(view->currentIndex().row(), 1);
    auto* action = bench.part<QComboBox>(u"bench.step.action"_s);
    action->setCurrentIndex(int(BenchAction::Repeat)); // which repeats something from the start
    QCOMPARE(bench.steps().rowCount(), 4);
    view->selectRow(2);
    bench.click(u"remove"_s); // the only one in it stays
    QCOMPARE(bench.steps().rowCount(), 4);
    view->selectRow(1);
    bench.click(u"up"_s);
    QCOMPARE(view->currentIndex().row(), 0);
    QVERIFY(bench.part<QListWidget>(u"bench.list"_s)->currentItem()->text().contains(u"edited"_s));
    bench.part<QDoubleSpinBox>(u"bench.amperes"_s)->setValue(1.5);
    const QString path = bench.folder.filePath(u"mine.json"_s);
    bench.dialogs.answerNext(path);
    bench.click(u"save"_s);
    QTRY_VERIFY(QFile::exists(path));
    const auto saved = loadBenchProfile(path);
    QVERIFY2(saved, saved ? "" : qPrintable(saved.error().context));
    QCOMPARE(saved->limits.amperes, std::optional(1.5));
    QCOMPARE(saved->steps.size(), std::size_t(3));
    QCOMPARE(saved->steps[0].action, BenchAction::Repeat);
    QCOMPARE(saved->steps[1].speed, 77);
    // The ready one that was chosen before, and the file that it was made from, are as they were.
    QCOMPARE(loadBenchProfile(bench.folder.filePath(u"short.json"_s))->steps.size(),
             std::size_t(2));
}

void TestBenchPanel::badFile_isNamed()
{
    Bench bench;
    QFile file(bench.folder.filePath(u"bad.json"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"format\":\"trexpanel-bench-profile\",\"version\":1,\"name\":\"x\",\n\"steps\":[{"
               "\"do\":\"fly\"}]}");
    file.close();
    bench.dialogs.answerNext(file.fileName());
    bench.click(u"open"_s);
    QTRY_VERIFY(bench.text(u"status"_s).contains(u"line 2"_s));
    QVERIFY(bench.text(u"status"_s).contains(u"fly"_s));
    QCOMPARE(bench.part<QListWidget>(u"bench.list"_s)->count(), 6);
}

void TestBenchPanel::files_canBeRead()
{
    Bench bench;
    bench.part<QListWidget>(u"bench.list"_s)->setCurrentRow(2); // current against speed
    QVERIFY(bench.dryRun());
    for (const QString& kind : {u"html"_s, u"pdf"_s}) {
        bench.dialogs.answerNext(bench.folder.filePath(u"report."_s + kind));
        bench.click(kind);
        QTRY_VERIFY(!bench.contents(u"report."_s + kind).isEmpty());
    }
    const QByteArray html = bench.contents(u"report.html"_s);
    QVERIFY(html.startsWith("<!DOCTYPE html>") && html.contains("<svg")
            && html.contains("Dry run"));
    QVERIFY(bench.contents(u"report.pdf"_s).startsWith("%PDF"));
    QVERIFY(bench.contents(u"report.pdf"_s).size() > 10'000);
    QSignalSpy asked(&bench.panel, &Panel::panelRequested);
    bench.dialogs.answerNext(bench.folder.filePath(u"proposals.json"_s));
    bench.click(u"saveProposals"_s);
    QTRY_COMPARE(asked.size(), 1);
    const auto proposals = loadConfiguration(bench.folder.filePath(u"proposals.json"_s));
    QVERIFY(proposals && proposals->parameters.size() == 2);
}

void TestBenchPanel::everyControl_hasAName()
{
    Bench bench;
    for (const QWidget* widget : bench.panel.findChildren<QWidget*>()) {
        const bool isOurs = widget->objectName().startsWith(u"bench."_s);
        const bool isControl = widget->focusPolicy() != Qt::NoFocus && isOurs;
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const bool isNamed =
            !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
        QVERIFY2(!isControl || isNamed, qPrintable(widget->objectName()));
    }
}

QTEST_MAIN(TestBenchPanel)
#include "tst_benchpanel.moc"
