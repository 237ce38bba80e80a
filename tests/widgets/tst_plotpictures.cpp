// SPDX-License-Identifier: GPL-3.0-or-later
// What the Plots panel looks like with data that took a day, or two runs, to come by. With
// TREX_PICTURES set to a folder the pictures are written there, light and dark:
//   TREX_PICTURES=out/plots ctest -R tst_plotpictures
#include "protocol/storage/comparisonrun.h"
#include "protocol/storage/recordingwriter.h"
#include "protocol/storage/sampletap.h"
#include "tests/widgets/plotsbench.h"
#include "widgets/plots/triggerbar.h"

#include <QDir>
#include <QSignalSpy>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>

using namespace trex;
using namespace trex::test;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

int steps(double time, double period, std::initializer_list<int> speeds)
{
    const auto index = std::size_t(time / period) % speeds.size();
    return speeds.begin()[index];
}

Profile drive(double load = 1.0)
{
    return {[](double time) {
                return steps(time, 2.0, {0, 60, 60, 110, -70, -70, 0, 90});
            },
            [](double time) {
                return steps(time, 2.5, {0, 0, -50, -50, 80, 40, 0});
            },
            load};
}

PlotLayout only(const std::vector<QString>& keys, int height = 100)
{
    PlotSpec plot;
    for (const QString& key : keys) {
        plot.curves.push_back(curveOf(streams()[std::size_t(streamIndex(key.toStdString()))]));
    }
    plot.height = height;
    return {plot};
}

PlotLayout currentsAndCommands()
{
    PlotLayout layout = only({u"motor1-current"_s, u"motor2-current"_s}, 300);
    layout.push_back(only({u"motor1-command"_s, u"motor2-command"_s}, 160).front());
    return layout;
}

const QString kCurrent1 = u"motor1-current"_s;

/// The session as a recording on the disk.
bool writeRecording(const QString& path, const TelemetryStore& store, Instant start)
{
    auto writer = RecordingWriter::create(path, {});
    if (!writer) {
        return false;
    }
    SampleTap::Wanted all;
    all.fill(true);
    SampleTap tap(store);
    tap.startAt(start);
    RecordingBatch batch;
    tap.take(all, TimeAxis::ticksOf(start), std::size_t(1) << 20U, batch.runs);
    return bool((*writer)->write(batch)) && bool((*writer)->finish());
}

/// Pixels around a point that differ between two pictures of twice the plot's size.
int differences(const QImage& one, const QImage& other, QPointF at)
{
    constexpr int kReach = 5;
    constexpr int kVisible = 60; // of the sum of the three colours
    const QPoint centre = (at * 2.0).toPoint();
    int count = 0;
    for (int x = centre.x() - kReach; x <= centre.x() + kReach; ++x) {
        for (int y = centre.y() - kReach; y <= centre.y() + kReach; ++y) {
            const QColor a = one.pixelColor(x, y);
            const QColor b = other.pixelColor(x, y);
            count += int(qAbs(a.red() - b.red()) + qAbs(a.green() - b.green())
                             + qAbs(a.blue() - b.blue())
                         > kVisible);
        }
    }
    return count;
}

} // namespace

class TestPlotPictures : public QObject {
    Q_OBJECT

private slots:
    void liveWithTwoCursors_data() { themes(); }
    void liveWithTwoCursors()
    {
        PlotsBench bench;
        begin();
        fillSession(bench.store, kPlotsStart, 60.0, drive());
        bench.now = kPlotsStart + 60s;
        bench.marks.append({kPlotsStart + 52s, MarkKind::Armed, {}});
        bench.marks.append(
            {kPlotsStart + 56'600ms, MarkKind::OverCurrent, u"Motor 1 over its current limit"_s});
        bench.make();
        bench.panel->stack().setLayoutOf(currentsAndCommands());
        limits(bench);
        bench.panel->timeline().setCursor(0, kPlotsStart + 54'020ms);
        bench.panel->timeline().setCursor(1, kPlotsStart + 57'400ms);
        bench.settle();
        write(bench, u"live-two-cursors"_s);
        QVERIFY(bench.part<QWidget>(u"plots.measurement"_s)->isVisible());
    }

    void dayAndItsSpike_data() { themes(); }
    void dayAndItsSpike()
    {
        PlotsBench bench;
        begin();
        fillDay(bench);
        bench.make();
        bench.panel->stack().setLayoutOf(only({u"motor1-current"_s, u"motor2-current"_s}));
        limits(bench);
        bench.panel->timeline().fit();
        bench.settle();
        write(bench, u"day"_s);
        const Instant spike = kPlotsStart + 15h + 42min + 17s;
        bench.panel->timeline().stand(spike - 1500ms, 4s);
        bench.panel->timeline().setCursor(0, spike - 20ms);
        bench.panel->timeline().setCursor(1, spike + 480ms);
        bench.settle();
        write(bench, u"day-spike"_s);
        QVERIFY(bench.plot(0).top() > 6.0);
    }

    void comparisonOfTwoRuns_data() { themes(); }
    void comparisonOfTwoRuns()
    {
        PlotsBench bench;
        begin();
        auto yesterday = std::make_unique<TelemetryStore>();
        const Instant before = kPlotsStart - 24h;
        fillSession(*yesterday, before, 30.0, drive(0.78), 11);
        fillSession(bench.store, kPlotsStart, 30.0, drive(1.1), 12);
        bench.now = kPlotsStart + 30s;
        bench.make();
        bench.panel->stack().setLayoutOf(currentsAndCommands());
        bench.references.add(std::move(yesterday), u"Yesterday, new brushes"_s, before);
        bench.references.setAlignment(Alignment::Start);
        bench.panel->showSide(PlotsPanel::kCompareTab);
        bench.panel->timeline().stand(kPlotsStart + 1s, 13s);
        bench.settle();
        write(bench, u"comparison"_s);
        QCOMPARE(bench.plot(0).frame().references.size(), std::size_t(2));
    }

    void comparisonWithARecording_data() { themes(); }
    void comparisonWithARecording()
    {
        PlotsBench bench;
        begin();
        const QString path = bench.folder.filePath(u"yesterday.trexrec"_s);
        TelemetryStore yesterday;
        const Instant before = kPlotsStart - 24h;
        fillSession(yesterday, before, 30.0, drive(0.5), 11);
        QVERIFY(writeRecording(path, yesterday, before));
        fillSession(bench.store, kPlotsStart, 30.0, drive(1.1), 12);
        bench.now = kPlotsStart + 30s;
        bench.make();
        bench.panel->stack().setLayoutOf(only({kCurrent1}, 300));
        bench.panel->timeline().stand(kPlotsStart + 1s, 13s);
        bench.settle();

        auto reader = RecordingReader::open(path);
        QVERIFY(reader);
        ComparisonRun run(std::move(*reader), path);
        QSignalSpy loaded(&run, &ComparisonRun::finished);
        run.start();
        QTRY_COMPARE(loaded.size(), 1);
        const int id = run.addTo(bench.references);
        bench.references.setAlignment(Alignment::Start);
        bench.panel->showSide(PlotsPanel::kCompareTab);
        bench.settle();
        write(bench, u"comparison-recording"_s);
        const QImage with = bench.plot(0).picture();
        bench.references.setVisible(id, false);
        bench.settle();
        const QImage without = bench.plot(0).picture();
        QCOMPARE(with.size(), without.size());

        // Its curve is there, with the values that were written, and nowhere else.
        const TimeSeries& then = yesterday.series("motor1-current");
        const PlotFrame& frame = bench.plot(0).frame();
        int drawn = 0;
        int seen = 0;
        for (const double second : {3.0, 5.5, 7.5, 9.6, 11.6, 13.5}) { // steady, away from steps
            const auto after =
                std::chrono::duration_cast<Duration>(std::chrono::duration<double>(second));
            const std::size_t index = then.axis().lowerBound(TimeAxis::ticksOf(before + after));
            const double amperes = then.value(index) * 0.04;
            const QPointF at(frame.xOf(kPlotsStart + after), frame.yOf(amperes));
            ++drawn;
            seen += int(differences(with, without, at) > 0);
            QCOMPARE(differences(with, without, at - QPointF(0.0, 60.0)), 0);
        }
        QVERIFY2(seen >= drawn - 1,
                 qPrintable(QString::number(seen))); // one may be in a dash's gap
    }

    void stackedPlotsWithEvents_data() { themes(); }
    void stackedPlotsWithEvents()
    {
        PlotsBench bench;
        begin();
        fillSession(bench.store, kPlotsStart, 24.0, drive());
        bench.store.markGap(kPlotsStart + 24s);
        fillSession(bench.store, kPlotsStart + 27s, 25.0, drive(), 5);
        bench.now = kPlotsStart + 52s;
        const auto mark = [&](Duration after, MarkKind kind, const QString& text = {}) {
            bench.marks.append({kPlotsStart + after, kind, text});
        };
        mark(0s, MarkKind::Connected);
        mark(1s, MarkKind::Armed);
        mark(6'100ms, MarkKind::OverCurrent, u"Motor 1 over its current limit"_s);
        mark(9s, MarkKind::Written, u"Motor 1 current limit: 2.00 A → 3.04 A"_s);
        mark(16'500ms, MarkKind::Fault, u"Motor 2 fault"_s);
        mark(16'600ms, MarkKind::Disarmed);
        mark(16'610ms, MarkKind::Stop);
        mark(19s, MarkKind::Armed);
        mark(24s, MarkKind::LinkLost, u"Link lost: the controller does not answer"_s);
        mark(27s, MarkKind::Connected, u"Link back"_s);
        mark(29s, MarkKind::Armed);
        mark(41s, MarkKind::Timeout, u"Serial timeout in the controller"_s);
        bench.make({1280, 860});
        limits(bench);
        bench.panel->timeline().stand(kPlotsStart - 500ms, 46s);
        bench.panel->showSide(PlotsPanel::kEventsTab);
        bench.panel->timeline().showMark(kPlotsStart + 16'500ms);
        bench.settle();
        write(bench, u"stacked-events"_s);
        QCOMPARE(bench.panel->stack().panes().size(), std::size_t(4));
    }

    void trigger_data() { themes(); }
    void trigger()
    {
        PlotsBench bench;
        begin();
        bench.now = kPlotsStart;
        bench.make();
        bench.panel->stack().setLayoutOf(currentsAndCommands());
        bench.part<QToolButton>(u"plots.showTrigger"_s)->click();
        bench.panel->trigger().setLevel(2.2);
        fillSession(bench.store, kPlotsStart + 1s, 15.0, drive());
        bench.now = kPlotsStart + 16s;
        bench.settle();
        QVERIFY(bench.panel->trigger().crossing().has_value());
        write(bench, u"trigger"_s);
    }

private:
    static void themes()
    {
        QTest::addColumn<bool>("isDark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    static bool isDark()
    {
        QFETCH(bool, isDark);
        return isDark;
    }
    static void begin() { theme::apply(isDark() ? theme::Choice::Dark : theme::Choice::Light); }
    static void limits(PlotsBench& bench)
    {
        bench.panel->stack().setLimits({{2.0, u"limit 1: 2.00 A"_s, ColourRole::Motor1},
                                        {2.4, u"limit 2: 2.40 A"_s, ColourRole::Motor2}});
    }
    static void write(PlotsBench& bench, const QString& name)
    {
        const QString wanted = qEnvironmentVariable("TREX_PICTURES");
        const QPixmap picture = bench.panel->grab();
        QVERIFY(!picture.isNull());
        if (!wanted.isEmpty()) {
            const QString path =
                QDir(wanted).filePath(name + (isDark() ? u"-dark.png"_s : u"-light.png"_s));
            QVERIFY2(QDir().mkpath(wanted) && picture.save(path), qPrintable(path));
        }
    }
    /// 24 hours at 80 Hz with work by day, quiet by night, and one spike at 15:42:17. A few minutes
    /// of it without a picture, where nobody looks at it.
    static void fillDay(PlotsBench& bench)
    {
        const bool isWhole = qEnvironmentVariableIsSet("TREX_PICTURES");
        const auto step = isWhole ? Duration(12'500us) : Duration(500ms);
        std::mt19937 random(9);
        const auto spike = kPlotsStart + 15h + 42min + 17s;
        double drift = 0.0;
        for (Instant time = kPlotsStart; time < kPlotsStart + 24h; time += step) {
            const double hours =
                std::chrono::duration<double, std::ratio<3600>>(time - kPlotsStart).count();
            const bool isNear = time >= spike - 2s && time < spike + 3s;
            const bool works = (hours > 1.0 && hours < 5.5) || (hours > 6.2 && hours < 11.8)
                || (hours > 13.0 && hours < 20.5);
            drift += (double(random() % 1000) - 499.5) * 2e-5;
            drift *= 0.9999;
            const double base = works ? 28.0 + 9.0 * std::sin(hours * 2.3) + 8.0 * drift : 2.0;
            double one = base + double(random() % 9) - 4.0;
            const double two = base * 0.55 + double(random() % 7) - 3.0;
            const double since = std::chrono::duration<double>(time - spike).count();
            if (since >= 0.0 && since < 0.45) {
                one += 150.0 * std::exp(-since * 9.0);
            }
            const auto count = [](double value) {
                return std::uint16_t(std::clamp(std::lround(value), 0L, 255L));
            };
            bench.store.append({PollId::Currents, {count(one), count(two)}, time});
            if (!isWhole && isNear) {
                for (int i = 1; i < 40; ++i) {
                    const double later = since + i * 0.0125;
                    const double more =
                        later >= 0.0 && later < 0.45 ? 150.0 * std::exp(-later * 9.0) : 0.0;
                    bench.store.append(
                        {PollId::Currents, {count(base + more), count(two)}, time + i * 12'500us});
                }
            }
        }
        bench.marks.append({kPlotsStart + 1h, MarkKind::Armed, {}});
        bench.marks.append(
            {spike + 60ms, MarkKind::OverCurrent, u"Motor 1 over its current limit"_s});
        bench.marks.append({kPlotsStart + 20h + 30min, MarkKind::Stop, {}});
        bench.now = kPlotsStart + 24h;
    }
};

QTEST_MAIN(TestPlotPictures)
#include "tst_plotpictures.moc"
