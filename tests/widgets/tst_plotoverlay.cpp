// SPDX-License-Identifier: GPL-3.0-or-later
// What lies over a plot's traces, and the views of its timeline.
#include "protocol/telemetry/marktrack.h"
#include "protocol/telemetry/plotreferences.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/plotframe.h"
#include "widgets/common/plotoverlay.h"
#include "widgets/common/plotview.h"

#include <QChart>
#include <QSignalSpy>
#include <QTest>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

const Instant kStart{100'000s};

struct Bench {
    TelemetryStore store;
    FrameTicker ticker;
    MarkTrack marks;
    PlotView plot{store, ticker};
    Instant now = kStart;

    Bench()
    {
        theme::apply(theme::Choice::Light);
        plot.setClock([this] { return now; });
        plot.timeline().setMarks(&marks);
        plot.resize(800, 400);
        plot.show();
    }
    void feedCurrents(Duration time, std::uint16_t motor1)
    {
        for (const Instant end = now + time; now < end; now += 12'500us) {
            store.append({PollId::Currents, {motor1, 0}, now});
        }
    }
    void settle()
    {
        plot.refresh();
        QCoreApplication::processEvents();
    }
    [[nodiscard]] QPoint at(double partX, double partY) const
    {
        const QRectF area = plot.frame().area;
        return {int(area.left() + partX * area.width()), int(area.top() + partY * area.height())};
    }
    [[nodiscard]] QPoint at(Instant time, double partY) const
    {
        return {int(std::lround(plot.frame().xOf(time))), at(0.0, partY).y()};
    }
    void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton)
    {
        QTest::mousePress(plot.viewport(), button, {}, from);
        QTest::mouseMove(plot.viewport(), to);
        QTest::mouseRelease(plot.viewport(), button, {}, to);
    }
    /// Pixels of about this colour in a part of the plot.
    [[nodiscard]] int inked(const QColor& wanted, double fromPart, double toPart,
                            int tolerance = 90)
    {
        const QImage image = plot.picture(1.0);
        int count = 0;
        for (int y = at(0, 0).y(); y <= at(0, 1.0).y(); ++y) {
            for (int x = at(fromPart, 0).x(); x < at(toPart, 0).x(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                count += qAbs(pixel.red() - wanted.red()) + qAbs(pixel.green() - wanted.green())
                        + qAbs(pixel.blue() - wanted.blue())
                    < tolerance;
            }
        }
        return count;
    }
    [[nodiscard]] double span() const { return plot.toSeconds() - plot.fromSeconds(); }
};

} // namespace

class TestPlotOverlay : public QObject {
    Q_OBJECT

private slots:
    void views_goBackAndForward()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.settle();
        PlotTimeline& timeline = bench.plot.timeline();
        QVERIFY(!timeline.canGoBack());
        bench.drag(bench.at(0.5, 0.0), bench.at(0.75, 0.5)); // a box: time and values
        const double from = bench.plot.fromSeconds();
        const double low = bench.plot.bottom();
        QVERIFY(low > 0.0);
        bench.now += 5s;
        bench.plot.fit();
        QVERIFY(bench.span() > 50.0);
        QTest::keyClick(&bench.plot, Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(bench.plot.fromSeconds(), from);
        QCOMPARE(bench.plot.bottom(), low);
        QTest::keyClick(&bench.plot, Qt::Key_Left, Qt::AltModifier);
        QVERIFY(!bench.plot.isPaused()); // it followed before
        QCOMPARE(bench.plot.bottom(), 0.0);
        QVERIFY(!timeline.canGoBack());
        QTest::keyClick(&bench.plot, Qt::Key_Right, Qt::AltModifier);
        QCOMPARE(bench.plot.fromSeconds(), from);
        QVERIFY(timeline.canGoForward());
        QTest::keyClick(&bench.plot, Qt::Key_Home); // another way: forward is gone
        QVERIFY(!timeline.canGoForward());
    }

    void aRowOfSmallSteps_isOneView()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.settle();
        for (int i = 0; i < 5; ++i) {
            bench.plot.timeline().zoom(0.8, 0.5);
            bench.now += 100ms;
        }
        bench.plot.timeline().back();
        QCOMPARE(qRound(bench.span()), 10);
        QVERIFY(!bench.plot.timeline().canGoBack());
    }

    void cursors_arePlacedMovedAndRemovedByKeys()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.plot.setPaused(true);
        bench.settle();
        PlotTimeline& timeline = bench.plot.timeline();
        QSignalSpy changed(&timeline, &PlotTimeline::cursorsChanged);
        QTest::keyClick(&bench.plot, Qt::Key_2); // both, since B alone measures nothing
        QVERIFY(timeline.cursor(0) && timeline.cursor(1));
        QCOMPARE(timeline.activeCursor(), 1);
        const Instant before = *timeline.cursor(1);
        QTest::keyClick(&bench.plot, Qt::Key_Right, Qt::ShiftModifier);
        const Duration pixel = *timeline.cursor(1) - before;
        QVERIFY(pixel > 5ms && pixel < 30ms);
        QTest::keyClick(&bench.plot, Qt::Key_Left, Qt::ShiftModifier | Qt::ControlModifier);
        QVERIFY(qAbs(double((*timeline.cursor(1) - before + 9 * pixel).count())) < 2e6);
        QTest::keyClick(&bench.plot, Qt::Key_1);
        QCOMPARE(timeline.activeCursor(), 0);
        QTest::keyClick(&bench.plot, Qt::Key_Delete);
        QVERIFY(!timeline.cursor(0) && timeline.cursor(1));
        QCOMPARE(timeline.activeCursor(), 1);
        QVERIFY(!timeline.measured());
        QVERIFY(changed.size() > 4);
    }

    void cursor_isDraggedByItsLine()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.plot.setPaused(true);
        PlotTimeline& timeline = bench.plot.timeline();
        timeline.setCursor(0, kStart + 55s);
        bench.settle();
        const double from = bench.plot.fromSeconds();
        bench.drag(bench.at(kStart + 55s, 0.5), bench.at(kStart + 57s, 0.6));
        const std::chrono::duration<double> since = *timeline.cursor(0) - kStart;
        QVERIFY(qAbs(since.count() - 57.0) < 0.03);
        QCOMPARE(bench.plot.fromSeconds(), from); // and nothing was zoomed
    }

    void level_isDraggedByItsLine()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.plot.setTrigger(0.5, {});
        bench.settle();
        QSignalSpy dragged(&bench.plot, &PlotView::levelDragged);
        const QPoint line(bench.at(0.5, 0).x(), int(bench.plot.frame().yOf(0.5)));
        bench.drag(line, QPoint(line.x(), int(bench.plot.frame().yOf(0.8))));
        QVERIFY(!dragged.isEmpty());
        QVERIFY(qAbs(dragged.last().first().toDouble() - 0.8) < 0.02);
        QVERIFY(!bench.plot.isPaused());
    }

    void panTool_pansWithTheLeftButton()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.settle();
        bench.plot.setTool(PlotView::Tool::Pan);
        const double from = bench.plot.fromSeconds();
        bench.drag(bench.at(0.2, 0.5), bench.at(0.7, 0.5));
        QVERIFY(qAbs(bench.plot.fromSeconds() - (from - 5.0)) < 0.1);
        QCOMPARE(qRound(bench.span()), 10);
    }

    void mouseButtons_goBackAndForward()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.settle();
        bench.plot.fit();
        QTest::mouseClick(bench.plot.viewport(), Qt::BackButton, {}, bench.at(0.5, 0.5));
        QCOMPARE(qRound(bench.span()), 10);
        QTest::mouseClick(bench.plot.viewport(), Qt::ForwardButton, {}, bench.at(0.5, 0.5));
        QVERIFY(bench.span() > 50.0);
    }

    void marks_thatAreCloseShareASign()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        for (int i = 0; i < 50'000; ++i) { // none of which costs a sign of its own
            bench.marks.append({kStart + 54s + i * 1us, MarkKind::Armed, {}});
        }
        bench.marks.append({kStart + 54s + 1ms, MarkKind::Fault, u"fault"_s});
        bench.marks.append({kStart + 58s, MarkKind::Stop, {}});
        bench.settle();
        const QPointF sign(bench.at(kStart + 54s, 0.0).x(), bench.plot.frame().area.top() + 9);
        const auto [begin, end] = bench.plot.overlay().marksAt(sign);
        QCOMPARE(end - begin, std::size_t(50'001));
        const QPointF stop(bench.at(kStart + 58s, 0.0).x(), sign.y());
        const auto [first, last] = bench.plot.overlay().marksAt(stop);
        QCOMPARE(last - first, std::size_t(1));
        QCOMPARE(bench.marks.marks()[first].kind, MarkKind::Stop);
        const auto none = bench.plot.overlay().marksAt({stop.x() - 60, stop.y()});
        QCOMPARE(none.first, none.second);
    }

    void newMark_isDrawnWithoutASample()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.settle();
        const int before = bench.inked(theme::colour(ColourRole::Fault), 0.0, 1.0);
        bench.marks.append({kStart + 55s, MarkKind::Stop, {}});
        bench.settle();
        QVERIFY(bench.inked(theme::colour(ColourRole::Fault), 0.0, 1.0) > before + 50);
    }

    void limit_isALineOnlyWhereItIsInSight()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.settle();
        const QColor fault = theme::colour(ColourRole::Fault);
        QCOMPARE(bench.inked(fault, 0.3, 0.9), 0);
        bench.plot.setLimits({{0.8, u"limit"_s, ColourRole::Fault}});
        QVERIFY(bench.inked(fault, 0.3, 0.9) > 100);
        bench.plot.setLimits({{80.0, u"limit"_s, ColourRole::Fault}});
        QCOMPARE(bench.inked(fault, 0.3, 0.9), 0);
    }

    void reference_isDrawnWithGapsBetweenItsDashes()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(10s, 0);
        auto other = std::make_unique<TelemetryStore>();
        for (int i = 0; i < 800; ++i) {
            other->append({PollId::Currents, {20, 0}, Instant(50s) + i * 12'500us});
        }
        PlotReferences references;
        bench.plot.setReferences(&references);
        // In the middle of the plot there is nothing else: columns with and without ink.
        const auto inkedColumns = [&] {
            const QImage image = bench.plot.picture(1.0);
            const int y = int(bench.plot.frame().yOf(0.8));
            int count = 0;
            for (int x = bench.at(0.1, 0).x(); x < bench.at(0.9, 0).x(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                count += pixel.blue() - pixel.red() > 40;
            }
            return count;
        };
        QCOMPARE(inkedColumns(), 0);
        const int id = references.add(std::move(other), u"Other"_s, Instant(50s));
        references.setAlignment(Alignment::Start);
        references.setAnchor(Alignment::Start, kStart);
        const int width = bench.at(0.9, 0).x() - bench.at(0.1, 0).x();
        QVERIFY(inkedColumns() > width / 2 && inkedColumns() < 3 * width / 4);
        references.setVisible(id, false);
        QCOMPARE(inkedColumns(), 0);
    }

    void gap_isOpenAtEveryZoom_data()
    {
        QTest::addColumn<int>("window");
        for (const int window : {1, 5, 20, 100, 500, 3000}) {
            QTest::addRow("%d s", window) << window;
        }
    }
    /// Pulses that are invalid for a twentieth of what is visible: nothing is drawn there.
    void gap_isOpenAtEveryZoom()
    {
        QFETCH(int, window);
        Bench bench;
        bench.plot.addCurve("channel1-raw", ColourRole::Motor1);
        bench.plot.setFoot(ticks::AxisRange::Foot::Free, 10.0);
        bench.plot.setWindowSeconds(window);
        const auto step = std::max<Duration>(Duration(std::chrono::seconds(window)) / 40'000, 1ms);
        const double seconds = window;
        for (double time = 0.0; time < seconds;
             time += std::chrono::duration<double>(step).count()) {
            const double part = time / seconds;
            const bool isInvalid = part > 0.5 && part < 0.55;
            const bool isLost = part > 0.2 && part < 0.25;
            if (isLost) {
                bench.store.markGap(bench.now);
            } else {
                const auto pulse =
                    std::uint16_t(isInvalid ? kInvalidPulse : 3000 + int(time * 100) % 40);
                bench.store.append({PollId::RawChannels, {pulse, 0, 0, 0, 0}, bench.now});
            }
            bench.now += step;
        }
        bench.settle();
        const QColor colour = theme::colour(ColourRole::Motor1);
        QVERIFY(bench.inked(colour, 0.3, 0.45, 240) > 50);
        QVERIFY(bench.inked(colour, 0.6, 0.9, 240) > 50);
        QCOMPARE(bench.inked(colour, 0.51, 0.54, 240), 0);
        QCOMPARE(bench.inked(colour, 0.21, 0.24, 240), 0);
    }

    void columnThatEndsInvalid_isNotJoinedFromThere()
    {
        // Columns of many samples, each ending in an invalid one, and then none for a while: a line
        // from an invalid number would leave the plot.
        Bench bench;
        bench.plot.addCurve("channel1-raw", ColourRole::Motor1);
        bench.plot.setFoot(ticks::AxisRange::Foot::Free, 10.0);
        bench.plot.setWindowSeconds(100);
        for (int burst = 0; burst < 100; ++burst) {
            for (int i = 0; i < 100; ++i) {
                const std::uint16_t pulse = i == 99 ? kInvalidPulse : std::uint16_t(3000 + i % 5);
                bench.store.append(
                    {PollId::RawChannels, {pulse, 0, 0, 0, 0}, bench.now + i * 100us});
            }
            bench.now += 990ms;
        }
        bench.settle();
        const QColor colour = theme::colour(ColourRole::Motor1);
        const int before = bench.inked(colour, 0.0, 1.0, 240);
        QVERIFY(before > 100);
        bench.plot.zoomValues(50.0, 0.5); // all of it is within a few pixels of the middle now
        const QImage image = bench.plot.picture(1.0);
        const int high = bench.at(0, 0.2).y();
        for (int x = bench.at(0.01, 0).x(); x < bench.at(0.99, 0).x(); ++x) {
            const QColor pixel = image.pixelColor(x, high);
            QVERIFY(qAbs(pixel.red() - colour.red()) + qAbs(pixel.green() - colour.green())
                        + qAbs(pixel.blue() - colour.blue())
                    > 150);
        }
    }

    void pinch_zoomsAboutTheFingers()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.settle();
        const QPointF at = bench.at(0.25, 0.5);
        const double under = bench.plot.fromSeconds() + 0.25 * bench.span();
        QNativeGestureEvent event(Qt::ZoomNativeGesture, QPointingDevice::primaryPointingDevice(),
                                  2, at, at, bench.plot.viewport()->mapToGlobal(at), 0.5, {});
        QCoreApplication::sendEvent(bench.plot.viewport(), &event);
        QVERIFY(qAbs(bench.span() - 10.0 / 1.5) < 0.01);
        QVERIFY(qAbs(bench.plot.fromSeconds() + 0.25 * bench.span() - under) < 0.05);
    }

    void twoFingers_zoomAboutTheMiddleBetweenThem()
    {
        Bench bench;
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        bench.feedCurrents(60s, 25);
        bench.settle();
        const double under = bench.plot.fromSeconds() + 0.5 * bench.span();
        const QPoint middle = bench.at(0.5, 0.5);
        const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        constexpr int kNear = 40; // pixels from the middle at first, and twice as far in the end
        constexpr int kSteps = 20;
        const auto reach = [](int step) { return QPoint(kNear + step * kNear / kSteps, 0); };
        QTest::touchEvent(bench.plot.viewport(), screen.get())
            .press(0, middle - reach(0))
            .press(1, middle + reach(0));
        for (int step = 1; step <= kSteps; ++step) {
            QTest::touchEvent(bench.plot.viewport(), screen.get())
                .move(0, middle - reach(step))
                .move(1, middle + reach(step));
        }
        QTest::touchEvent(bench.plot.viewport(), screen.get())
            .release(0, middle - reach(kSteps))
            .release(1, middle + reach(kSteps));
        QVERIFY2(qAbs(bench.span() - 5.0) < 0.6, qPrintable(QString::number(bench.span())));
        QVERIFY(qAbs(bench.plot.fromSeconds() + 0.5 * bench.span() - under) < 0.3);
        QVERIFY(bench.plot.isPaused());
    }

    void sharedTimeline_movesAllItsPlots()
    {
        Bench bench;
        PlotView second(bench.store, bench.ticker, nullptr, &bench.plot.timeline());
        second.resize(800, 200);
        second.show();
        bench.plot.addCurve("motor1-current", ColourRole::Motor1);
        second.addCurve("motor2-current", ColourRole::Motor2);
        bench.feedCurrents(60s, 25);
        bench.settle();
        bench.plot.zoomTime(0.5);
        QCOMPARE(second.fromSeconds(), bench.plot.fromSeconds());
        QCOMPARE(second.frame().from, bench.plot.frame().from);
        second.zoomValues(0.5);
        QVERIFY(second.top() < bench.plot.top()); // values are each plot's own
        QVERIFY(!bench.plot.areValuesByHand());
    }
};

QTEST_MAIN(TestPlotOverlay)
#include "tst_plotoverlay.moc"
