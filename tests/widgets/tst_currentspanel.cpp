// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/panelbench.h"
#include "widgets/common/plotview.h"
#include "widgets/common/timewindowbox.h"
#include "widgets/currents/currentreadout.h"
#include "widgets/currents/currentspanel.h"

#include <QComboBox>
#include <QTest>
#include <QToolButton>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kLongMs = 30'000;

struct Bench : test::PanelBench<CurrentsPanel> {
    [[nodiscard]] QLabel* value(int motor) const
    {
        return part<QLabel>(u"currents.motor%1.value"_s.arg(motor));
    }
    [[nodiscard]] PlotView* plot() const { return part<PlotView>(u"currents.plot"_s); }
    void click(const QString& name) const
    {
        QTest::mouseClick(part<QToolButton>(u"currents."_s + name), Qt::LeftButton, {}, {10, 10});
    }
    void feed(int count, std::uint16_t motor1, std::uint16_t motor2)
    {
        const Instant now = std::chrono::steady_clock::now();
        for (int i = 0; i < count; ++i) {
            store.append({PollId::Currents, {motor1, motor2}, now - (count - 1 - i) * 12'500us});
        }
    }
};

} // namespace

class TestCurrentsPanel : public QObject {
    Q_OBJECT

private slots:
    void parts_haveTheirNames();
    void value_isAbsentBeforeTheFirstSample();
    void value_isShownInAmperes();
    void value_isStaleAfterALoss();
    void pause_keepsRecordingBehind();
    void window_isKept();
    void window_tellsTheLengthOfAZoomedView();
    void window_writesLengthsForPeople();
    void clear_forgetsTheSession();
    void export_writesCsvOrPicture();
    void export_toNowhereIsLogged();
    void record_writesWhatComes();
    void record_isOffWhenTheFileCannotBe();
    void polling_followsVisibility();
    void jointMode_showsNoNumber();
    void trex_isMarkedAsInferred();
};

void TestCurrentsPanel::parts_haveTheirNames()
{
    const Bench bench;
    for (const char* name :
         {"plot", "motor1.value", "motor2.value", "pause", "window", "clear", "export", "record"}) {
        const auto* part = bench.part<QWidget>(u"currents."_s + QLatin1StringView(name));
        QVERIFY2(part != nullptr, name);
        QVERIFY2(!part->accessibleName().isEmpty(), name);
    }
}

void TestCurrentsPanel::value_isAbsentBeforeTheFirstSample()
{
    const Bench bench;
    QCOMPARE(bench.value(1)->text(), u"–"_s);
    QVERIFY(!bench.value(1)->property("amperes").isValid());
    QCOMPARE(bench.value(1)->property("stale").toBool(), true);
}

void TestCurrentsPanel::value_isShownInAmperes()
{
    // C-30: 55 counts are 2.2 A
    Bench bench;
    bench.feed(100, 55, 0);
    QTRY_COMPARE(bench.value(1)->text(), u"2.20 A"_s);
    QCOMPARE(bench.value(1)->property("amperes").toDouble(), 2.2);
    QCOMPARE(bench.value(1)->property("stale").toBool(), false);
    QCOMPARE(bench.value(2)->text(), u"0.00 A"_s); // zero is not absent
}

void TestCurrentsPanel::value_isStaleAfterALoss()
{
    Bench bench;
    bench.feed(10, 55, 22);
    QTRY_COMPARE(bench.value(1)->property("stale").toBool(), false);
    bench.store.markGap(std::chrono::steady_clock::now());
    QTRY_COMPARE(bench.value(1)->property("stale").toBool(), true);
    QCOMPARE(bench.value(1)->text(), u"2.20 A"_s); // old, and looks it
    bench.panel.setBackgroundRole(QPalette::Base); // as the main window does
    QCOMPARE(bench.value(1)->palette().color(bench.value(1)->foregroundRole()),
             theme::colour(ColourRole::Stale));
}

void TestCurrentsPanel::pause_keepsRecordingBehind()
{
    Bench bench;
    bench.feed(100, 55, 22);
    bench.click(u"pause"_s);
    QVERIFY(bench.plot()->isPaused());
    QVERIFY(bench.part<QToolButton>(u"currents.pause"_s)->isChecked());
    bench.feed(100, 10, 10);
    QCOMPARE(bench.store.series("motor1-current").size(), std::size_t(200));
    QTRY_COMPARE(bench.value(1)->text(), u"0.40 A"_s); // the present goes on
    bench.click(u"pause"_s);
    QVERIFY(!bench.plot()->isPaused());
    bench.plot()->zoomTime(0.5); // zooming stands still, and the button says so
    QVERIFY(bench.part<QToolButton>(u"currents.pause"_s)->isChecked());
}

void TestCurrentsPanel::window_isKept()
{
    Bench bench;
    auto* window = bench.part<QComboBox>(u"currents.window"_s);
    QCOMPARE(window->currentData().toInt(), 10);
    window->setCurrentIndex(window->findData(60));
    QCOMPARE(bench.plot()->windowSeconds(), 60);
    const CurrentsPanel next(bench.context);
    QCOMPARE(next.findChild<PlotView*>()->windowSeconds(), 60);
}

void TestCurrentsPanel::window_tellsTheLengthOfAZoomedView()
{
    Bench bench;
    bench.feed(100, 55, 22);
    auto* window = bench.part<QComboBox>(u"currents.window"_s);
    bench.click(u"pause"_s);
    QCOMPARE(window->currentData().toInt(), 10); // still ten seconds
    bench.plot()->zoomTime(0.25);
    QCOMPARE(window->currentIndex(), -1);
    QCOMPARE(window->placeholderText(), u"2.5 s"_s);
    QCOMPARE(bench.context.settings.value(settings::kPlotWindowSeconds), 10);
    window->setCurrentIndex(window->findData(10)); // leads back, though it was the choice before
    QCOMPARE(bench.plot()->timeline().span(), Duration(std::chrono::seconds(10)));
    bench.plot()->zoomTime(0.25);
    bench.click(u"pause"_s);
    QCOMPARE(window->currentData().toInt(), 10);
}

void TestCurrentsPanel::window_writesLengthsForPeople()
{
    QCOMPARE(TimeWindowBox::lengthText(0.02), u"20 ms"_s);
    QCOMPARE(TimeWindowBox::lengthText(2.5), u"2.5 s"_s);
    QCOMPARE(TimeWindowBox::lengthText(59.96), u"60 s"_s);
    QCOMPARE(TimeWindowBox::lengthText(3750.0), u"1:02:30"_s);
}

void TestCurrentsPanel::clear_forgetsTheSession()
{
    Bench bench;
    bench.feed(100, 55, 22);
    QTRY_COMPARE(bench.value(1)->text(), u"2.20 A"_s);
    bench.click(u"clear"_s);
    QVERIFY(bench.store.series("motor1-current").isEmpty());
    QVERIFY(!bench.plot()->isPaused());
    QVERIFY(bench.log.rowCount() > 0);
}

void TestCurrentsPanel::export_writesCsvOrPicture()
{
    Bench bench;
    bench.feed(500, 55, 22);
    bench.dialogs.answerNext(bench.folder.filePath(u"out.csv"_s));
    bench.click(u"export"_s);
    QTRY_COMPARE(bench.contents(u"out.csv"_s).count('\n'), 501);
    QVERIFY(
        bench.contents(u"out.csv"_s).startsWith("t_s,motor1_raw,motor2_raw,motor1_A,motor2_A\n"));
    QVERIFY(bench.contents(u"out.csv"_s).endsWith(",55,22,2.200,0.880\n"));
    bench.dialogs.answerNext(bench.folder.filePath(u"out.png"_s));
    bench.click(u"export"_s);
    QTRY_VERIFY(!bench.contents(u"out.png"_s).isEmpty());
    const QImage picture(bench.folder.filePath(u"out.png"_s));
    QCOMPARE(picture.size(), bench.plot()->size() * 2);
}

void TestCurrentsPanel::export_toNowhereIsLogged()
{
    Bench bench;
    bench.dialogs.answerNext(bench.folder.filePath(u"no/such/folder/out.csv"_s));
    bench.click(u"export"_s);
    QTRY_VERIFY(bench.log.rowCount() > 0);
    QCOMPARE(bench.log.at(bench.log.rowCount() - 1).severity, int(EventLog::Failure));
}

void TestCurrentsPanel::record_writesWhatComes()
{
    Bench bench;
    bench.feed(10, 1, 1);
    bench.dialogs.answerNext(bench.folder.filePath(u"rec.csv"_s));
    bench.click(u"record"_s);
    auto* record = bench.part<QToolButton>(u"currents.record"_s);
    QTRY_VERIFY(record->isChecked());
    bench.feed(40, 55, 22);
    QTRY_COMPARE(bench.contents(u"rec.csv"_s).count('\n'), 41); // on disk while it runs
    bench.feed(1, 60, 22);
    bench.click(u"record"_s);
    QVERIFY(!record->isChecked());
    QCOMPARE(bench.contents(u"rec.csv"_s).count('\n'), 42);
}

void TestCurrentsPanel::record_isOffWhenTheFileCannotBe()
{
    Bench bench;
    bench.dialogs.answerNext(bench.folder.filePath(u"no/folder/rec.csv"_s));
    bench.click(u"record"_s);
    QTRY_VERIFY(bench.log.rowCount() > 0);
    QVERIFY(!bench.part<QToolButton>(u"currents.record"_s)->isChecked());
}

void TestCurrentsPanel::polling_followsVisibility()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    constexpr auto kCurrents = std::size_t(PollId::Currents);
    QTRY_COMPARE_WITH_TIMEOUT(bench.controller.stats().askedHertz.at(kCurrents),
                              CurrentsPanel::kHertz, kLongMs);
    QTRY_VERIFY_WITH_TIMEOUT(bench.value(1)->property("amperes").isValid(), kLongMs);
    bench.panel.hide();
    QTRY_COMPARE_WITH_TIMEOUT(bench.controller.stats().askedHertz.at(kCurrents), 0.0, kLongMs);
}

void TestCurrentsPanel::jointMode_showsNoNumber()
{
    // C-31
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?mode=serial"_s));
    QTRY_VERIFY_WITH_TIMEOUT(bench.value(1)->property("amperes").isValid(), kLongMs);
    bool isWritten = false;
    bench.settings.writeParameter(parameterRow("motor-mode"), 1, true, &bench.panel,
                                  [&](const Result<DeviceSettings::ParameterWrite>& written) {
                                      isWritten = written.has_value();
                                  });
    QTRY_VERIFY_WITH_TIMEOUT(isWritten, kLongMs);
    QVERIFY(bench.settings.isPending(parameterRow("motor-mode").number));
    QTest::qWait(200);
    QVERIFY(bench.value(1)->property("amperes").isValid()); // not in force before a power cycle
    bench.controller.powerCycleSimulator();
    QTRY_COMPARE_WITH_TIMEOUT(bench.value(1)->text(), u"–"_s, kLongMs);
    QVERIFY(!bench.value(2)->property("amperes").isValid());
    const auto labels = bench.panel.findChildren<QLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(),
                        [](const QLabel* label) { return label->text().contains(u"joint mode"); }));
}

void TestCurrentsPanel::trex_isMarkedAsInferred()
{
    // C-70
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?model=trex"_s));
    QTRY_VERIFY_WITH_TIMEOUT(bench.value(1)->text().startsWith(u"≈"), kLongMs);
    QCOMPARE(bench.controller.model(), Model::Trex);
}

QTEST_MAIN(TestCurrentsPanel)
#include "tst_currentspanel.moc"
