// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/frameticker.h"
#include "widgets/common/plotview.h"

#include <QChart>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

using namespace trex;
using namespace std::chrono_literals;

namespace {

const Instant kStart{100'000s};

/// A plot of one second of data after another, on a clock of its own.
struct PlotBench {
    TelemetryStore store;
    FrameTicker ticker;
    PlotView plot{store, ticker};
    Instant now = kStart;

    PlotBench()
    {
        theme::apply(theme::Choice::Light);
        plot.setClock([this] { return now; });
        plot.addCurve("motor1-current", ColourRole::Motor1);
        plot.addCurve("motor2-current", ColourRole::Motor2);
        plot.setUnit(QStringLiteral("A"));
        plot.setSmallestTop(0.9);
        plot.resize(800, 400);
        plot.show();
        settle();
    }
    void feed(Duration time, std::uint16_t motor1, std::uint16_t motor2, Duration step = 12'500us)
    {
        for (const Instant end = now + time; now < end; now += step) {
            store.append({PollId::Currents, {motor1, motor2}, now});
        }
    }
    void settle()
    {
        plot.refresh();
        QCoreApplication::processEvents();
    }
    /// Pixels of a curve's colour (or near it: lines are smoothed) in a part of the plot's width.
    [[nodiscard]] int inked(ColourRole role, double fromPart, double toPart)
    {
        const QImage image = plot.picture(1.0);
        const QRectF area = plot.chart()->plotArea();
        const QColor wanted = theme::colour(role);
        int count = 0;
        for (int y = int(area.top()); y <= int(area.bottom()); ++y) {
            for (int x = int(area.left() + fromPart * area.width());
                 x < int(area.left() + toPart * area.width()); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                const int off = qAbs(pixel.red() - wanted.red())
                    + qAbs(pixel.green() - wanted.green()) + qAbs(pixel.blue() - wanted.blue());
                count += off < 200 && qAbs(pixel.red() - pixel.blue()) > 60 ? 1 : 0;
            }
        }
        return count;
    }
    void wheel(double partX, int angle, Qt::KeyboardModifiers modifiers = {})
    {
        const QRectF area = plot.chart()->plotArea();
        const QPointF at(area.left() + partX * area.width(), area.center().y());
        QWheelEvent event(at, plot.mapToGlobal(at), {}, {0, angle}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(plot.viewport(), &event);
    }
    void drag(QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton)
    {
        const QRectF area = plot.chart()->plotArea();
        const auto place = [&area](QPointF part) {
            return QPoint(int(area.left() + part.x() * area.width()),
                          int(area.top() + part.y() * area.height()));
        };
        QTest::mousePress(plot.viewport(), button, {}, place(from));
        QTest::mouseMove(plot.viewport(), place(to));
        QTest::mouseRelease(plot.viewport(), button, {}, place(to));
    }
    [[nodiscard]] double span() const { return plot.toSeconds() - plot.fromSeconds(); }
};

} // namespace

class TestPlotView : public QObject {
    Q_OBJECT

private slots:
    void follow_showsTheNewestInItsWindow();
    void pause_holdsThePictureWhileDataGoesOn();
    void wholeSession_growsWithIt();
    void wheel_zoomsTimeAboutTheCursor();
    void wheelWithControl_zoomsValuesOnly();
    void box_zoomsIntoIt();
    void click_zoomsNothing();
    void middleDrag_pansTime();
    void doubleClick_followsAgain();
    void keys_doAllThatTheMouseDoes();
    void escape_isLeftToTheWindow();
    void traces_arePainted_data();
    void traces_arePainted();
    void gap_isNotBridged_data();
    void gap_isNotBridged();
    void silence_isShown();
    void valueAxis_growsAtOnceAndShrinksSlowly();
    void hiddenCurve_isNotPainted();
    void repaint_onlyWhenThereIsSomethingNew();
    void paused_repaintsNothingThatIsOutOfSight();
    void theme_changesTheColours();
    void ticks_areNice();
};

void TestPlotView::follow_showsTheNewestInItsWindow()
{
    PlotBench bench;
    bench.feed(30s, 25, 10);
    bench.settle();
    QVERIFY(!bench.plot.isPaused());
    QCOMPARE(qRound(bench.span()), 10);
    QVERIFY(qAbs(bench.plot.toSeconds() - 30.0) < 0.1);
    bench.plot.setWindowSeconds(60);
    QCOMPARE(qRound(bench.span()), 60);
    QVERIFY(qAbs(bench.plot.toSeconds() - 30.0) < 0.1);
}

void TestPlotView::pause_holdsThePictureWhileDataGoesOn()
{
    PlotBench bench;
    bench.feed(20s, 25, 10);
    QSignalSpy spy(&bench.plot, &PlotView::pausedChanged);
    bench.plot.setPaused(true);
    QCOMPARE(spy.size(), 1);
    const double from = bench.plot.fromSeconds();
    const int before = bench.inked(ColourRole::Motor1, 0.0, 1.0);
    bench.feed(30s, 100, 10);
    bench.settle();
    QCOMPARE(bench.plot.fromSeconds(), from);
    QCOMPARE(bench.inked(ColourRole::Motor1, 0.0, 1.0), before);
    QCOMPARE(bench.store.series("motor1-current").size(), std::size_t(4000)); // recorded behind
    bench.plot.setPaused(false);
    QVERIFY(qAbs(bench.plot.toSeconds() - 50.0) < 0.1);
}

void TestPlotView::wholeSession_growsWithIt()
{
    PlotBench bench;
    bench.plot.setWindowSeconds(PlotView::kWholeSession);
    bench.feed(100s, 25, 10);
    bench.settle();
    QVERIFY(qAbs(bench.plot.fromSeconds()) < 0.01);
    QVERIFY(qAbs(bench.span() - 100.0) < 0.1);
    bench.feed(100s, 25, 10);
    bench.settle();
    QVERIFY(qAbs(bench.span() - 200.0) < 0.1);
}

void TestPlotView::wheel_zoomsTimeAboutTheCursor()
{
    PlotBench bench;
    bench.feed(60s, 25, 10);
    bench.settle();
    const double under = bench.plot.fromSeconds() + 0.25 * bench.span();
    bench.wheel(0.25, 120);
    QVERIFY(bench.plot.isPaused());
    QVERIFY(bench.span() < 9.0);
    QVERIFY(qAbs(bench.plot.fromSeconds() + 0.25 * bench.span() - under) < 0.1);
    bench.wheel(0.25, -240);
    QVERIFY(bench.span() > 11.0);
}

void TestPlotView::wheelWithControl_zoomsValuesOnly()
{
    PlotBench bench;
    bench.feed(30s, 25, 10);
    bench.settle();
    const double top = bench.plot.top();
    const double span = bench.span();
    bench.wheel(0.5, 120, Qt::ControlModifier);
    QVERIFY(bench.plot.top() - bench.plot.bottom() < 0.9 * top);
    QVERIFY(!bench.plot.isPaused());
    QCOMPARE(bench.span(), span);
}

void TestPlotView::box_zoomsIntoIt()
{
    PlotBench bench;
    bench.feed(30s, 25, 10);
    bench.settle();
    const double from = bench.plot.fromSeconds();
    const double top = bench.plot.top();
    bench.drag({0.5, 0.0}, {0.75, 0.5});
    QVERIFY(bench.plot.isPaused());
    QVERIFY(qAbs(bench.plot.fromSeconds() - (from + 5.0)) < 0.1);
    QVERIFY(qAbs(bench.span() - 2.5) < 0.1);
    QVERIFY(qAbs(bench.plot.top() - top) < 0.05);
    QVERIFY(qAbs(bench.plot.bottom() - top / 2) < 0.05);
}

void TestPlotView::click_zoomsNothing()
{
    PlotBench bench;
    bench.feed(30s, 25, 10);
    bench.settle();
    const double span = bench.span();
    QTest::mouseClick(bench.plot.viewport(), Qt::LeftButton, {}, bench.plot.rect().center());
    QCOMPARE(bench.span(), span);
    QVERIFY(!bench.plot.isPaused());
}

void TestPlotView::middleDrag_pansTime()
{
    PlotBench bench;
    bench.feed(60s, 25, 10);
    bench.settle();
    const double from = bench.plot.fromSeconds();
    const double top = bench.plot.top();
    bench.drag({0.2, 0.5}, {0.7, 0.4}, Qt::MiddleButton);
    QVERIFY(bench.plot.isPaused());
    QVERIFY(qAbs(bench.plot.fromSeconds() - (from - 5.0)) < 0.1);
    QCOMPARE(bench.plot.top(), top); // values that fit themselves stay
}

void TestPlotView::doubleClick_followsAgain()
{
    PlotBench bench;
    bench.feed(60s, 25, 10);
    bench.settle();
    bench.drag({0.1, 0.1}, {0.2, 0.3});
    QVERIFY(bench.plot.isPaused());
    QTest::mouseDClick(bench.plot.viewport(), Qt::LeftButton, {}, bench.plot.rect().center());
    QVERIFY(!bench.plot.isPaused());
    QCOMPARE(qRound(bench.span()), 10);
    QCOMPARE(bench.plot.bottom(), 0.0);
}

void TestPlotView::keys_doAllThatTheMouseDoes()
{
    PlotBench bench;
    bench.feed(60s, 25, 10);
    bench.settle();
    QTest::keyClick(&bench.plot, Qt::Key_Left);
    QVERIFY(bench.plot.isPaused());
    QVERIFY(qAbs(bench.plot.toSeconds() - 59.0) < 0.1);
    QTest::keyClick(&bench.plot, Qt::Key_Plus);
    QVERIFY(qAbs(bench.span() - 8.0) < 0.1);
    QTest::keyClick(&bench.plot, Qt::Key_Minus);
    QVERIFY(qAbs(bench.span() - 10.0) < 0.1);
    QTest::keyClick(&bench.plot, Qt::Key_Home);
    QVERIFY(qAbs(bench.plot.fromSeconds()) < 0.1);
    const double top = bench.plot.top();
    QTest::keyClick(&bench.plot, Qt::Key_Plus, Qt::ControlModifier);
    QVERIFY(bench.plot.top() < top);
    QTest::keyClick(&bench.plot, Qt::Key_Up);
    QVERIFY(bench.plot.bottom() > 0.0);
    QTest::keyClick(&bench.plot, Qt::Key_F);
    QVERIFY(qAbs(bench.span() - 60.0) < 0.1);
    QCOMPARE(bench.plot.bottom(), 0.0);
    QTest::keyClick(&bench.plot, Qt::Key_End);
    QVERIFY(!bench.plot.isPaused());
    QTest::keyClick(&bench.plot, Qt::Key_P);
    QVERIFY(bench.plot.isPaused());
}

void TestPlotView::escape_isLeftToTheWindow()
{
    PlotBench bench;
    QKeyEvent event(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    event.accept();
    QCoreApplication::sendEvent(&bench.plot, &event);
    QVERIFY(!event.isAccepted());
}

void TestPlotView::traces_arePainted_data()
{
    QTest::addColumn<int>("window");
    QTest::addColumn<int>("fed");
    QTest::newRow("samples joined") << 10 << 30;
    QTest::newRow("columns") << 300 << 400;
    QTest::newRow("columns, whole session") << PlotView::kWholeSession << 3000;
}

void TestPlotView::traces_arePainted()
{
    QFETCH(int, window);
    QFETCH(int, fed);
    PlotBench bench;
    QCOMPARE(bench.inked(ColourRole::Motor1, 0.0, 1.0), 0);
    bench.plot.setWindowSeconds(window);
    bench.feed(std::chrono::seconds(fed), 50, 10);
    bench.settle();
    for (const ColourRole role : {ColourRole::Motor1, ColourRole::Motor2}) {
        for (double part = 0.02; part < 0.95; part += 0.1) {
            QVERIFY(bench.inked(role, part, part + 0.02) > 5);
        }
    }
}

void TestPlotView::gap_isNotBridged_data()
{
    QTest::addColumn<bool>("linkWasLost");
    QTest::addColumn<int>("window");
    QTest::newRow("link lost") << true << 10;
    QTest::newRow("not asked for a while") << false << 10;
    QTest::newRow("link lost, columns") << true << 200;
}

void TestPlotView::gap_isNotBridged()
{
    QFETCH(bool, linkWasLost);
    QFETCH(int, window);
    PlotBench bench;
    bench.plot.setWindowSeconds(window);
    const std::chrono::milliseconds part(window * 400);
    bench.feed(part, 50, 10); // 40 % data, 20 % nothing, 40 % data
    if (linkWasLost) {
        bench.store.markGap(bench.now);
    }
    bench.now += part / 2;
    bench.feed(part, 50, 10);
    bench.settle();
    QVERIFY(bench.inked(ColourRole::Motor1, 0.1, 0.35) > 20);
    QCOMPARE(bench.inked(ColourRole::Motor1, 0.42, 0.58), 0);
    QCOMPARE(bench.inked(ColourRole::Motor2, 0.42, 0.58), 0);
    QVERIFY(bench.inked(ColourRole::Motor1, 0.65, 0.9) > 20);
}

void TestPlotView::silence_isShown()
{
    PlotBench bench;
    bench.plot.setLive(true);
    bench.feed(10s, 50, 10);
    bench.settle();
    const QImage before = bench.plot.picture(1.0);
    bench.now += 5s; // nothing comes any more, and time goes on
    bench.settle();
    QVERIFY(qAbs(bench.plot.toSeconds() - 15.0) < 0.1);
    QCOMPARE(bench.inked(ColourRole::Motor1, 0.55, 1.0), 0);
    const QRectF area = bench.plot.chart()->plotArea();
    const QImage after = bench.plot.picture(1.0);
    int changed = 0; // hatched
    for (int x = int(area.center().x()) + 20; x < int(area.right()) - 2; ++x) {
        changed +=
            after.pixelColor(x, int(area.top()) + 30) != before.pixelColor(x, int(area.top()) + 30);
    }
    QVERIFY(changed > 50);
}

void TestPlotView::valueAxis_growsAtOnceAndShrinksSlowly()
{
    PlotBench bench;
    bench.feed(10s, 10, 10); // 0.4 A
    bench.settle();
    QCOMPARE(bench.plot.top(), 1.0);
    bench.feed(100ms, 100, 10); // 4 A
    bench.settle();
    QVERIFY(bench.plot.top() > 4.0);
    const double high = bench.plot.top();
    bench.feed(10'500ms, 10, 10); // the spike has left the window
    bench.settle();
    QCOMPARE(bench.plot.top(), high);
    bench.feed(3s, 10, 10);
    bench.settle();
    QCOMPARE(bench.plot.top(), 1.0);
}

void TestPlotView::hiddenCurve_isNotPainted()
{
    PlotBench bench;
    bench.feed(20s, 50, 10);
    bench.plot.setCurveVisible(0, false);
    QVERIFY(!bench.plot.isCurveVisible(0));
    QCOMPARE(bench.inked(ColourRole::Motor1, 0.0, 1.0), 0);
    QVERIFY(bench.inked(ColourRole::Motor2, 0.0, 1.0) > 100);
}

void TestPlotView::repaint_onlyWhenThereIsSomethingNew()
{
    PlotBench bench;
    bench.feed(5s, 50, 10);
    bench.settle();
    QTRY_VERIFY(bench.ticker.framesPainted() > 0);
    QCoreApplication::processEvents();
    const quint64 before = bench.ticker.framesPainted();
    for (int i = 0; i < 20; ++i) {
        bench.settle();
    }
    QCOMPARE(bench.ticker.framesPainted(), before);
    bench.feed(20ms, 50, 10);
    bench.settle();
    QTRY_VERIFY(bench.ticker.framesPainted() > before);
}

void TestPlotView::paused_repaintsNothingThatIsOutOfSight()
{
    PlotBench bench;
    bench.feed(20s, 50, 10);
    bench.plot.setPaused(true);
    bench.settle();
    QTRY_VERIFY(bench.ticker.framesPainted() > 0);
    QCoreApplication::processEvents();
    bench.feed(1s, 50, 10); // behind the right edge
    bench.settle();
    const quint64 before = bench.ticker.framesPainted();
    for (int i = 0; i < 20; ++i) {
        bench.feed(50ms, 50, 10);
        bench.settle();
    }
    QCOMPARE(bench.ticker.framesPainted(), before);
    bench.store.clear(); // that is to be seen
    bench.settle();
    QTRY_VERIFY(bench.ticker.framesPainted() > before);
}

void TestPlotView::theme_changesTheColours()
{
    PlotBench bench;
    bench.feed(20s, 50, 10);
    theme::apply(theme::Choice::Dark);
    bench.settle();
    QVERIFY(bench.inked(ColourRole::Motor1, 0.0, 1.0) > 100);
    const QImage image = bench.plot.picture(1.0);
    QCOMPARE(image.pixelColor(2, 2), theme::colour(ColourRole::Panel));
    theme::apply(theme::Choice::Light);
}

void TestPlotView::ticks_areNice()
{
    QCOMPARE(ticks::niceStep(5.0, 5), 1.0);
    QCOMPARE(ticks::niceStep(5.1, 5), 2.0);
    QCOMPARE(ticks::niceStep(0.7, 5), 0.2);
    QCOMPARE(ticks::timeStep(10.0, 8), 2.0);
    QCOMPARE(ticks::timeStep(86'400.0, 8), 14'400.0);
    QCOMPARE(ticks::timeLabel(5.0, 1.0), QStringLiteral("0:05"));
    QCOMPARE(ticks::timeLabel(3725.0, 1.0), QStringLiteral("1:02:05"));
    QCOMPARE(ticks::timeLabel(59.95, 0.05), QStringLiteral("0:59.95"));
    QCOMPARE(ticks::timeLabel(-5.0, 1.0), QStringLiteral("−0:05"));
}

QTEST_MAIN(TestPlotView)
#include "tst_plotview.moc"
