// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/benchsections.h"

#include "app/script/processclock.h"
#include "widgets/panelregistry.h"

#include <QApplication>
#include <QChart>
#include <QChartView>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineSeries>
#include <QProcess>
#include <QTemporaryDir>

#include <cmath>
#include <cstdio>

#include <sys/resource.h>

namespace trex::bench {

using namespace Qt::Literals::StringLiterals;

namespace {

/// Paints once, says how long that took since the process began, and ends.
class BareChart : public QChartView {
public:
    using QChartView::QChartView;

protected:
    void paintEvent(QPaintEvent* event) override
    {
        QChartView::paintEvent(event);
        std::printf("%.3f\n", processclock::sinceStartMs());
        std::fflush(stdout);
        QCoreApplication::quit();
    }
};

double seconds(const timeval& time)
{
    return double(time.tv_sec) + double(time.tv_usec) * 1e-6;
}

/// Processor time of all children that have ended.
double childSeconds()
{
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double bareChartMs()
{
    QProcess process;
    process.start(QCoreApplication::applicationFilePath(), {u"--bare-chart"_s});
    process.waitForFinished(-1);
    return process.readAllStandardOutput().trimmed().toDouble();
}

struct PanelRun {
    bool passed = false;
    double startupMs = 0.0;
    double peakMiB = 0.0;
    double frameMs = 0.0;
    double frames = 0.0;
    double transactions = 0.0;
    double processorSeconds = 0.0;
};

/// trexpanel with these options, plays these steps once it is connected.
PanelRun runPanel(const QStringList& line, const QJsonArray& steps)
{
    const QTemporaryDir folder;
    const auto path = [&folder](const QString& name) { return folder.filePath(name); };
    QFile script(path(u"script.json"_s));
    if (script.open(QIODevice::WriteOnly)) {
        QJsonArray all{QJsonObject{{u"waitFor"_s,
                                    QJsonObject{{u"object"_s, u"connection.state"_s},
                                                {u"property"_s, u"state"_s},
                                                {u"equals"_s, u"connected"_s}}}}};
        for (const QJsonValue& step : steps) {
            all.append(step);
        }
        script.write(QJsonDocument(QJsonObject{{u"steps"_s, all}}).toJson());
        script.close();
    }
    const double before = childSeconds();
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start(QStringLiteral(TREX_PANEL_PROGRAM),
                  QStringList{u"--offscreen"_s, u"--script"_s, script.fileName(), u"--report"_s,
                              path(u"report.json"_s), u"--screenshots"_s, path(u"pictures"_s),
                              u"--settings"_s, path(u"settings.ini"_s)}
                      + line);
    process.waitForFinished(-1);
    PanelRun run;
    run.processorSeconds = childSeconds() - before;
    QFile report(path(u"report.json"_s));
    if (report.open(QIODevice::ReadOnly)) {
        const QJsonObject root = QJsonDocument::fromJson(report.readAll()).object();
        const QJsonObject metrics = root.value(u"metrics"_s).toObject();
        run.passed = root.value(u"passed"_s).toBool();
        run.startupMs = metrics.value(u"startupMs"_s).toDouble();
        run.peakMiB = metrics.value(u"peakRssMiB"_s).toDouble();
        run.frameMs = metrics.value(u"frameMsMedian"_s).toDouble();
        run.frames = metrics.value(u"framesPainted"_s).toDouble();
        run.transactions = metrics.value(u"transactions"_s).toDouble();
    }
    return run;
}

QJsonObject sleepStep(int ms)
{
    return {{u"sleepMs"_s, ms}};
}

/// Panels that share a place with others get windows of their own, so that all are seen.
QJsonArray stepsToShowAll()
{
    QJsonArray steps;
    for (const PanelRow& panel : panels()) {
        if (panel.area == Qt::BottomDockWidgetArea) {
            const QString dock =
                u"dock."_s + QLatin1StringView(panel.id.data(), qsizetype(panel.id.size()));
            steps.append(QJsonObject{{u"set"_s,
                                      QJsonObject{{u"object"_s, dock},
                                                  {u"property"_s, u"floating"_s},
                                                  {u"value"_s, true}}}});
        }
    }
    return steps;
}

/// Processor time at work, start and end left out: the difference of a long and a short run.
struct Work {
    std::vector<double> percent{};
    std::vector<double> perSecond{}; ///< transactions
    std::vector<double> framesPerSecond{};
    std::vector<double> frameMs{};
    std::vector<double> memory{};

    void measure(const QStringList& line, const QJsonArray& steps)
    {
        constexpr int kShortMs = 2000;
        constexpr int kLongMs = 10'000;
        const auto run = [&](int ms) {
            QJsonArray all = steps;
            all.append(sleepStep(ms));
            return runPanel(line, all);
        };
        const PanelRun brief = run(kShortMs);
        const PanelRun full = run(kLongMs);
        if (!brief.passed || !full.passed) {
            qWarning("trexpanel did not play its script");
            return;
        }
        constexpr double kSeconds = (kLongMs - kShortMs) / 1000.0;
        percent.push_back(100.0 * (full.processorSeconds - brief.processorSeconds) / kSeconds);
        perSecond.push_back((full.transactions - brief.transactions) / kSeconds);
        framesPerSecond.push_back((full.frames - brief.frames) / kSeconds);
        frameMs.push_back(full.frameMs);
        memory.push_back(full.peakMiB);
    }
};

} // namespace

int runBareChart()
{
    BareChart view;
    auto* series = new QLineSeries(view.chart());
    series->append(0.0, 0.0);
    series->append(1.0, 1.0);
    view.chart()->addSeries(series);
    view.chart()->createDefaultAxes();
    view.resize(1000, 400);
    view.show();
    return QCoreApplication::exec();
}

void measureStart(Results& results)
{
    constexpr int kRuns = 7;
    std::vector<double> panelMs;
    std::vector<double> bareMs;
    for (int run = 0; run < kRuns; ++run) {
        bareMs.push_back(bareChartMs());
        if (const PanelRun panel = runPanel({u"--simulate"_s}, {}); panel.passed) {
            panelMs.push_back(panel.startupMs);
        }
    }
    results.add(u"start.panel"_s, u"start: trexpanel to its first full window"_s, median(panelMs),
                u"ms"_s);
    results.add(u"start.bare"_s, u"start: a bare QChartView window"_s, median(bareMs), u"ms"_s);
    results.add(u"start.ratio"_s, u"start: trexpanel / bare"_s, median(panelMs) / median(bareMs),
                {});
}

void measureOpening(const QString& recording, Results& results)
{
    constexpr int kRuns = 3;
    const auto wait = [](const QString& object, const QString& property, const QJsonObject& what) {
        QJsonObject condition = what;
        condition[u"object"_s] = object;
        condition[u"property"_s] = property;
        return QJsonObject{{u"waitFor"_s, condition}};
    };
    const auto window = wait(u"recordingWindow"_s, u"visible"_s, {{u"equals"_s, true}});
    // While it loads, the time says so, in percent.
    const auto loaded =
        wait(u"recordingWindow/recording.time"_s, u"text"_s, {{u"matches"_s, u"^[^%]+$"_s}});
    const auto elapsedMs = [](const QStringList& line, const QJsonArray& steps) {
        QElapsedTimer timer;
        timer.start();
        return runPanel(line, steps).passed ? double(timer.nsecsElapsed()) / 1e6 : std::nan("");
    };
    std::vector<double> openMs;
    std::vector<double> loadMs;
    for (int run = 0; run < kRuns; ++run) {
        const double without = elapsedMs({u"--simulate"_s}, {});
        openMs.push_back(elapsedMs({u"--simulate"_s, recording}, {window}) - without);
        loadMs.push_back(elapsedMs({u"--simulate"_s, recording}, {window, loaded}) - without);
    }
    results.add(u"record.day.window"_s, u"record: the day in its window"_s, median(openMs),
                u"ms"_s);
    results.add(u"record.day.loaded"_s, u"record: the day in its window, every sample"_s,
                median(loadMs), u"ms"_s);
}

void measureProcessor(Results& results)
{
    constexpr int kRounds = 3;
    const QTemporaryDir folder;
    const QString link = folder.filePath(u"line"_s);
    QProcess simulator; // a process of its own: its time is not the program's
    simulator.start(QStringLiteral(TREX_CTL_PROGRAM),
                    {u"simulate"_s, u"--pty"_s, link, u"--pace"_s});
    if (!simulator.waitForReadyRead(5000)) {
        qWarning("trexctl simulate does not start");
        return;
    }
    const QStringList line{u"--port"_s, link};
    const QJsonArray seen = stepsToShowAll();
    QJsonArray minimised = seen;
    minimised.append(QJsonObject{{u"window"_s, u"minimise"_s}});
    Work visible;
    Work hidden;
    for (int round = 0; round < kRounds; ++round) {
        visible.measure(line, seen);
        hidden.measure(line, minimised);
    }
    simulator.terminate();
    simulator.waitForFinished(5000);
    const QString all = u"live: all panels seen, 19200 baud: "_s;
    const QString none = u"live: minimised, 19200 baud: "_s;
    results.add(u"live.cpu"_s, all + u"processor"_s, median(visible.percent), u"% of a core"_s);
    results.add(u"live.frames"_s, all + u"frames of the currents"_s,
                median(visible.framesPerSecond), u"a second"_s);
    results.add(u"live.frame"_s, all + u"a frame of the currents"_s, median(visible.frameMs),
                u"ms"_s);
    results.add(u"live.transactions"_s, all + u"transactions"_s, median(visible.perSecond),
                u"a second"_s);
    results.add(u"live.memory"_s, all + u"peak memory (VmHWM)"_s, median(visible.memory), u"MiB"_s);
    results.add(u"live.minimised.cpu"_s, none + u"processor"_s, median(hidden.percent),
                u"% of a core"_s);
    results.add(u"live.minimised.transactions"_s, none + u"transactions"_s,
                median(hidden.perSecond), u"a second"_s);
}

} // namespace trex::bench
