// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/plotsbench.h"

#include "widgets/common/measurementview.h"
#include "widgets/plots/curvechip.h"
#include "widgets/plots/eventlist.h"
#include "widgets/plots/plotexport.h"
#include "widgets/plots/triggerbar.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QSvgRenderer>
#include <QToolButton>
#include <QXmlStreamReader>

using namespace trex;
using namespace trex::test;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

const QString kCurrent1 = u"motor1-current"_s;
const QString kCommand1 = u"motor1-command"_s;

/// One current per 12.5 ms: counts that a test can reckon with.
void feed(PlotsBench& bench, Duration time, std::uint16_t motor1, std::uint16_t motor2)
{
    for (const Instant end = bench.now + time; bench.now < end; bench.now += 12'500us) {
        bench.store.append({PollId::Currents, {motor1, motor2}, bench.now});
    }
}

QStringList keysOf(const PlotPane& pane)
{
    QStringList keys;
    for (const CurveSpec& curve : pane.curves()) {
        keys += curve.key;
    }
    return keys;
}

QAction* entry(const QMenu& menu, const QString& text)
{
    for (QAction* action : menu.actions()) {
        if (action->text() == text) {
            return action;
        }
    }
    return nullptr;
}

} // namespace

class TestPlotsPanel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { theme::apply(theme::Choice::Light); }

    void atFirst_thereIsAPlotForEachKindOfStream()
    {
        PlotsBench bench;
        bench.make();
        QCOMPARE(bench.panel->stack().panes().size(), std::size_t(4));
        QCOMPARE(keysOf(bench.pane(0)), (QStringList{kCurrent1, u"motor2-current"_s}));
        QVERIFY(bench.pane(1).has(kCommand1));
        QVERIFY(bench.pane(2).has(u"channel5-raw"_s));
        QVERIFY(bench.pane(3).has(u"channel1-remapped"_s));
    }

    void plotAreas_lineUpAndShowTheSameTime()
    {
        PlotsBench bench;
        fillSession(bench.store, kPlotsStart, 20.0,
                    {[](double t) { return t > 3 ? 100 : 0; }, [](double) { return 0; }});
        bench.now = kPlotsStart + 20s;
        bench.make();
        const double left = bench.plot(0).frame().area.left();
        QVERIFY(left > 20.0);
        for (std::size_t i = 1; i < 4; ++i) {
            QVERIFY(qAbs(bench.plot(i).frame().area.left() - left) <= 1.0);
            QVERIFY(qAbs(bench.plot(i).frame().area.right() - bench.plot(0).frame().area.right())
                    <= 1.0);
        }
        QTest::keyClick(&bench.plot(2), Qt::Key_Plus);
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(bench.plot(i).isPaused());
            QVERIFY(qAbs(bench.plot(i).toSeconds() - bench.plot(i).fromSeconds() - 8.0) < 0.1);
        }
        QVERIFY(bench.plot(1).bottom() < 0.0 || bench.plot(1).top() >= 100.0);
        QVERIFY(bench.plot(2).bottom() > 1000.0); // raw channels do not begin at zero
        QCOMPARE(bench.plot(0).bottom(), 0.0); // currents do
    }

    void curve_isDraggedToAnotherPlot()
    {
        PlotsBench bench;
        bench.make();
        auto* chip = bench.part<CurveChip>(u"plots.plot1."_s + kCurrent1);
        QVERIFY(chip != nullptr);
        const QPoint target =
            chip->mapFromGlobal(bench.plot(1).mapToGlobal(bench.plot(1).rect().center()));
        QTest::mousePress(chip, Qt::LeftButton, {}, {8, 8});
        QMouseEvent move(QEvent::MouseMove, target, chip->mapToGlobal(target), Qt::NoButton,
                         Qt::LeftButton, {});
        QCoreApplication::sendEvent(chip, &move);
        QTest::mouseRelease(chip, Qt::LeftButton, {}, target);
        QCOMPARE(keysOf(bench.pane(0)), QStringList{u"motor2-current"_s});
        QVERIFY(bench.pane(1).has(kCurrent1));
        QVERIFY(bench.pane(1).curves().back().isVisible); // it was no click
    }

    void curve_isClickedAway()
    {
        PlotsBench bench;
        bench.make();
        auto* chip = bench.part<CurveChip>(u"plots.plot1."_s + kCurrent1);
        QTest::mouseClick(chip, Qt::LeftButton);
        QVERIFY(!bench.plot(0).isCurveVisible(0));
        QTest::keyClick(chip, Qt::Key_Space);
        QVERIFY(bench.plot(0).isCurveVisible(0));
        QTest::keyClick(chip, Qt::Key_Delete);
        QCOMPARE(keysOf(bench.pane(0)), QStringList{u"motor2-current"_s});
    }

    void curve_isMovedAndColouredByItsMenu()
    {
        PlotsBench bench;
        bench.make();
        auto* chip = bench.part<CurveChip>(u"plots.plot1."_s + kCurrent1);
        const auto menuOf = [&] {
            QContextMenuEvent event(QContextMenuEvent::Keyboard, QPoint(),
                                    chip->mapToGlobal(QPoint()));
            QCoreApplication::sendEvent(chip, &event);
            return bench.panel->findChild<QMenu*>(u"plots.curveMenu"_s);
        };
        QMenu* menu = menuOf();
        QVERIFY(menu != nullptr);
        entry(*entry(*menu, u"Colour"_s)->menu(), u"Red"_s)->trigger();
        entry(*entry(*menu, u"Width"_s)->menu(), u"Thick"_s)->trigger();
        QCOMPARE(bench.pane(0).curves().front().width, 2.6);
        menu->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        menu = menuOf();
        entry(*entry(*menu, u"Move to"_s)->menu(), u"A new plot"_s)->trigger();
        QCOMPARE(bench.panel->stack().panes().size(), std::size_t(5));
        QCOMPARE(keysOf(bench.pane(4)), QStringList{kCurrent1});
    }

    void layout_isRememberedAndRestored()
    {
        PlotsBench bench;
        bench.make();
        CurveSpec changed = bench.pane(0).curves()[0];
        changed.colour = ColourRole::Fault;
        changed.width = 2.6;
        changed.isVisible = false;
        bench.pane(0).changeCurve(changed);
        bench.panel->stack().movePlot(&bench.pane(3), -1);
        bench.panel->stack().removePlot(&bench.pane(1));
        PlotPane* extra = bench.panel->stack().addPlot();
        bench.panel->stack().addCurve(u"link-latency"_s, extra);
        const QStringList third = keysOf(bench.pane(2));
        bench.panel.reset(); // the program ends
        bench.make();
        QCOMPARE(bench.panel->stack().panes().size(), std::size_t(4));
        QCOMPARE(bench.pane(0).curves()[0], changed);
        QCOMPARE(keysOf(bench.pane(2)), third);
        QCOMPARE(keysOf(bench.pane(3)), QStringList{u"link-latency"_s});
        bench.part<QAction>(u"plots.defaultPlots"_s)->trigger();
        QCOMPARE(bench.panel->stack().layoutOf()[0].curves, defaultLayout()[0].curves);
    }

    void layout_thatIsDamagedIsTheFirstOne_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("no JSON") << QByteArray("{[");
        QTest::newRow("no plots") << QByteArray("[]");
        QTest::newRow("curves of another time")
            << QByteArray(R"([{"curves":[{"stream":"gone"}]}])");
        QTest::newRow("another shape") << QByteArray(R"([1,"x",null])");
    }
    void layout_thatIsDamagedIsTheFirstOne()
    {
        QFETCH(QByteArray, json);
        PlotsBench bench;
        bench.uiSettings.set(settings::kPlotsLayout, json);
        bench.make();
        QCOMPARE(bench.panel->stack().panes().size(), std::size_t(4));
    }

    void plots_areMadeHigherByTheirMenu()
    {
        PlotsBench bench;
        bench.make();
        const int before = bench.pane(1).height();
        bench.part<QToolButton>(u"plots.plot2.menu"_s)->click();
        QMenu* menu = bench.panel->findChild<QMenu*>(u"plots.plotMenu"_s);
        QVERIFY(menu != nullptr);
        entry(*menu, u"Higher"_s)->trigger();
        bench.settle();
        QVERIFY(bench.pane(1).height() > before + 20);
        entry(*menu, u"Move up"_s)->trigger();
        QVERIFY(bench.pane(0).has(kCommand1));
    }

    void lastPlot_isEmptiedInsteadOfRemoved()
    {
        PlotsBench bench;
        bench.make();
        while (bench.panel->stack().panes().size() > 1) {
            bench.panel->stack().removePlot(bench.panel->stack().panes().back());
        }
        bench.panel->stack().removePlot(&bench.pane(0));
        QCOMPARE(bench.panel->stack().panes().size(), std::size_t(1));
        QVERIFY(bench.pane(0).curves().empty());
        bench.settle(); // an empty plot draws, too
    }

    void cursors_measureWhatLiesBetween()
    {
        PlotsBench bench;
        feed(bench, 5s, 50, 25);
        feed(bench, 5s, 100, 25);
        bench.make();
        bench.panel->timeline().setPaused(true);
        bench.part<QToolButton>(u"plots.cursors"_s)->click();
        auto* view = bench.part<MeasurementView>(u"plots.measurement"_s);
        QVERIFY(view->isVisible());
        QAbstractItemModelTester tester(&const_cast<MeasurementModel&>(view->model()));
        bench.panel->timeline().setCursor(0, kPlotsStart + 4s);
        bench.panel->timeline().setCursor(1, kPlotsStart + 6s);
        const auto text = [&](MeasurementModel::Column column) {
            return view->model().index(0, column).data().toString();
        };
        QCOMPARE(text(MeasurementModel::AtA), u"2.00 A"_s);
        QCOMPARE(text(MeasurementModel::AtB), u"4.00 A"_s);
        QCOMPARE(text(MeasurementModel::Difference), u"2.00 A"_s);
        QCOMPARE(text(MeasurementModel::Minimum), u"2.00 A"_s);
        QCOMPARE(text(MeasurementModel::Mean), u"3.000 A"_s);
        QCOMPARE(text(MeasurementModel::Rms), u"3.162 A"_s); // √10
        QCOMPARE(text(MeasurementModel::Maximum), u"4.00 A"_s);
        QCOMPARE(text(MeasurementModel::Samples), u"160"_s);
        // From the first to the last sample: 79 steps of 2 A, one of 3 A, 79 of 4 A.
        const double expected = (79 * 2.0 + 3.0 + 79 * 4.0) * 0.0125 / 3.6;
        QCOMPARE(text(MeasurementModel::Charge), u"%1 mAh"_s.arg(expected, 0, 'f', 3));
        QCOMPARE(bench.part<QLabel>(u"plots.measurement.times"_s)->text(),
                 u"A 0:04.000    B 0:06.000    Δt 2.000 s    1/Δt 0.5000 Hz"_s);
        view->copy();
        QVERIFY(QGuiApplication::clipboard()->text().contains(u"3.000 A\t3.162 A"_s));
        bench.part<QToolButton>(u"plots.cursors"_s)->click();
        QVERIFY(!view->isVisible());
    }

    void trigger_holdsTheFirstCrossing()
    {
        PlotsBench bench;
        bench.make();
        feed(bench, 1s, 10, 10);
        bench.part<QToolButton>(u"plots.showTrigger"_s)->click();
        auto* mode = bench.part<QComboBox>(u"plots.trigger.mode"_s);
        mode->setCurrentIndex(mode->findText(u"Single"_s));
        bench.part<QDoubleSpinBox>(u"plots.trigger.level"_s)->setValue(2.0);
        feed(bench, 1s, 10, 10);
        const Instant crossing = bench.now;
        feed(bench, 30s, 100, 10);
        bench.settle();
        QCOMPARE(bench.panel->trigger().crossing(), std::optional(crossing));
        // A quarter of the window lies before it.
        const std::chrono::duration<double> before = crossing - bench.panel->timeline().from();
        QVERIFY(qAbs(before.count() - 2.5) < 0.001);
        QVERIFY(bench.plot(0).frame().level == 2.0);
        QVERIFY(!bench.plot(1).frame().level); // its source is not there
        QVERIFY(bench.part<QLabel>(u"plots.trigger.state"_s)->text().startsWith(u"Holding"_s));
        emit bench.plot(0).levelDragged(3.0);
        QCOMPARE(bench.panel->trigger().settings().level, 3.0);
        bench.part<QToolButton>(u"plots.showTrigger"_s)->click(); // off: on with the newest
        bench.settle();
        QVERIFY(bench.panel->timeline().from() > crossing);
    }

    void trigger_goesOnWhileNobodyLooks()
    {
        PlotsBench bench;
        bench.make();
        bench.part<QToolButton>(u"plots.showTrigger"_s)->click();
        feed(bench, 1s, 10, 10);
        emit bench.ticker.tick();
        bench.panel->hide();
        const Instant crossing = bench.now;
        feed(bench, 3s, 100, 10);
        emit bench.ticker.tick();
        QCOMPARE(bench.panel->trigger().crossing(), std::optional(crossing));
    }

    void frozenView_isDrawnBehind()
    {
        PlotsBench bench;
        feed(bench, 20s, 50, 25);
        bench.make();
        bench.part<QToolButton>(u"plots.compare.freeze"_s)->click();
        QCOMPARE(bench.references.runs().size(), std::size_t(1));
        feed(bench, 5s, 100, 25);
        bench.settle();
        const auto& references = bench.plot(0).frame().references;
        QCOMPARE(references.size(), std::size_t(2));
        // It stands where it was seen, while the curve has moved on.
        QCOMPARE(references[0].shift, Duration(5s));
        bench.panel->timeline().setPaused(true);
        bench.panel->timeline().zoom(0.5, 0.3); // looking closer moves nothing against the curve
        QCOMPARE(bench.plot(0).frame().references[0].shift, Duration(5s));
        bench.part<QDoubleSpinBox>(u"plots.compare.run1.offset"_s)->setValue(0.25);
        bench.settle();
        QCOMPARE(bench.plot(0).frame().references[0].shift, Duration(5'250ms));
        bench.part<QToolButton>(u"plots.compare.run1.remove"_s)->click();
        QCOMPARE(bench.references.runs().size(), std::size_t(0));
        QVERIFY(bench.plot(0).frame().references.empty());
    }

    void runs_areAlignedByTheirTrigger()
    {
        PlotsBench bench;
        feed(bench, 8s, 10, 10);
        feed(bench, 4s, 100, 10);
        bench.make();
        auto other = std::make_unique<TelemetryStore>();
        const Instant start{100s};
        for (int i = 0; i < 800; ++i) {
            other->append(
                {PollId::Currents, {std::uint16_t(i < 240 ? 10 : 100), 0}, start + i * 12'500us});
        }
        bench.references.setAlignment(Alignment::Trigger);
        bench.part<QDoubleSpinBox>(u"plots.trigger.level"_s)->setValue(2.0);
        bench.references.add(std::move(other), u"Other"_s, start);
        bench.settle();
        const auto& references = bench.plot(0).frame().references;
        QCOMPARE(references.size(), std::size_t(2));
        QCOMPARE(start + 3s + references[0].shift, kPlotsStart + 8s);
    }

    void events_areListedAndGoneTo()
    {
        PlotsBench bench;
        feed(bench, 100s, 10, 10);
        bench.marks.append({kPlotsStart + 20s, MarkKind::Armed, {}});
        bench.make();
        EventModel model(&bench.marks, bench.panel->timeline());
        QAbstractItemModelTester tester(&model);
        QCOMPARE(model.rowCount(), 1);
        bench.marks.append({kPlotsStart + 60s, MarkKind::Fault, u"Motor 1 fault"_s});
        bench.marks.append({kPlotsStart + 40s, MarkKind::Stop, {}}); // told late
        model.refresh();
        QCOMPARE(model.rowCount(), 3);
        QCOMPARE(model.index(0, 0).data().toString(), u"0:20.00"_s);
        QVERIFY(model.index(1, 1).data().toString().endsWith(u"Stop"_s));
        QTest::keyClick(&bench.plot(0), Qt::Key_N, Qt::ShiftModifier);
        PlotTimeline& timeline = bench.panel->timeline();
        QCOMPARE(timeline.shownMark(), std::optional(kPlotsStart + 60s));
        QVERIFY(timeline.from() < kPlotsStart + 60s
                && timeline.from() + timeline.span() > kPlotsStart + 60s);
        QTest::keyClick(&bench.plot(0), Qt::Key_N, Qt::ShiftModifier);
        QCOMPARE(timeline.shownMark(), std::optional(kPlotsStart + 40s));
        QTest::keyClick(&bench.plot(0), Qt::Key_N);
        QCOMPARE(timeline.shownMark(), std::optional(kPlotsStart + 60s));
    }

    void exportedSamples_areTheSamples()
    {
        PlotsBench bench;
        feed(bench, 2s, 50, 25);
        feed(bench, 1s, 60, 25);
        bench.make();
        const QString path = bench.folder.filePath(u"all.csv"_s);
        bench.dialogs.answerNext(path);
        bench.part<QToolButton>(u"plots.export"_s)->click();
        QCoreApplication::processEvents();
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArrayList lines = file.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), 1 + 240);
        QVERIFY(lines[0].startsWith("t_s,motor1_raw,motor2_raw"));
        QVERIFY(lines[1].startsWith("0.00000,50,25"));
        QVERIFY(lines[240].startsWith("2.98750,60,25"));
        // The visible part only, with the first and the last sample that are seen.
        bench.panel->timeline().stand(kPlotsStart + 1s, 500ms);
        const QString part = bench.folder.filePath(u"part.csv"_s);
        const QString keys[] = {kCurrent1};
        const auto rows = exportPlotsCsv(part, bench.store, keys, Model::TrexJr, {},
                                         bench.panel->timeline().range());
        QVERIFY(rows.has_value());
        QCOMPARE(*rows, std::size_t(40));
    }

    void pictures_areWritten()
    {
        PlotsBench bench;
        feed(bench, 12s, 50, 25);
        bench.make();
        const QString svg = bench.folder.filePath(u"plots.svg"_s);
        const QString png = bench.folder.filePath(u"plots.png"_s);
        QVERIFY(exportPlotsSvg(svg, bench.panel->stack()).has_value());
        QVERIFY(exportPlotsPng(png, bench.panel->stack()).has_value());
        QFile file(svg);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QXmlStreamReader xml(&file);
        int texts = 0;
        while (!xml.atEnd()) {
            texts += xml.readNext() == QXmlStreamReader::StartElement && xml.name() == u"text"_s;
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QVERIFY(texts > 10); // names, values, times
        QVERIFY(QSvgRenderer(svg).isValid());
        QCOMPARE(QImage(png).size(), bench.panel->stack().pictureSize() * 2);
        const auto refused = exportPlotsPng(bench.folder.path(), bench.panel->stack());
        QVERIFY(!refused && refused.error().code == ErrorCode::FileUnwritable);
        bench.part<QAction>(u"plots.copyPicture"_s)->trigger();
        QVERIFY(!QGuiApplication::clipboard()->image().isNull());
        bench.part<QAction>(u"plots.copySamples"_s)->trigger();
        QVERIFY(QGuiApplication::clipboard()->text().startsWith(u"t_s,motor1_raw"_s));
    }

    void onlyWhatIsShown_isAskedFor()
    {
        PlotsBench bench;
        bench.make();
        bench.controller.open({.port = u"sim:?pace=0"_s, .line = {}});
        QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Connected, 10'000);
        const auto asked = [&](PollId poll) {
            return bench.controller.stats().askedHertz.at(std::size_t(poll));
        };
        QTRY_VERIFY(asked(PollId::Currents) > 0.0 && asked(PollId::RawChannels) > 0.0);
        bench.panel->stack().removePlot(&bench.pane(2)); // raw channels
        QTRY_COMPARE(asked(PollId::RawChannels), 0.0);
        QVERIFY(asked(PollId::Currents) > 0.0);
        bench.panel->hide();
        QTRY_COMPARE(asked(PollId::Currents), 0.0);
    }
};

QTEST_MAIN(TestPlotsPanel)
#include "tst_plotspanel.moc"
