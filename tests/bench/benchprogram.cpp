// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/benchsections.h"

#include "app/script/processclock.h"

#include <QApplication>
#include <QChart>
#include <QChartView>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineSeries>
#include <QProcess>
#include <QTemporaryDir>

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
    double processorSeconds = 0.0;
};

/// trexpanel on the simulator, everything live, for so long.
PanelRun runPanel(int liveMs)
{
    const QTemporaryDir folder;
    const auto path = [&folder](const QString& name) { return folder.filePath(name); };
    QFile script(path(u"script.json"_s));
    if (script.open(QIODevice::WriteOnly)) {
        script.write(
            QStringLiteral("{\"steps\":[{\"waitFor\":{\"object\":\"connection.state\",\"property\":"
                           "\"state\",\"equals\":\"connected\"}},{\"sleepMs\":%1}]}")
                .arg(liveMs)
                .toUtf8());
        script.close();
    }
    const double before = childSeconds();
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    process.start(QStringLiteral(TREX_PANEL_PROGRAM),
                  {u"--offscreen"_s, u"--simulate"_s, u"--script"_s, script.fileName(),
                   u"--report"_s, path(u"report.json"_s), u"--screenshots"_s, path(u"pictures"_s),
                   u"--settings"_s, path(u"settings.ini"_s)});
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
    }
    return run;
}

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

void measurePrograms(Results& results)
{
    constexpr int kRuns = 7;
    std::vector<double> panelMs;
    std::vector<double> bareMs;
    for (int run = 0; run < kRuns; ++run) {
        bareMs.push_back(bareChartMs());
        if (const PanelRun panel = runPanel(0); panel.passed) {
            panelMs.push_back(panel.startupMs);
        }
    }
    results.add(u"start.panel"_s, u"start: trexpanel to its first full window"_s, median(panelMs),
                u"ms"_s);
    results.add(u"start.bare"_s, u"start: a bare QChartView window"_s, median(bareMs), u"ms"_s);
    results.add(u"start.ratio"_s, u"start: trexpanel / bare"_s, median(panelMs) / median(bareMs),
                {});

    constexpr int kShortMs = 2000;
    constexpr int kLongMs = 8000;
    std::vector<double> load;
    std::vector<double> memory;
    std::vector<double> frame;
    for (int run = 0; run < 3; ++run) { // the difference of two lengths leaves the start out
        const PanelRun brief = runPanel(kShortMs);
        const PanelRun full = runPanel(kLongMs);
        if (brief.passed && full.passed) {
            const double span = (kLongMs - kShortMs) / 1000.0;
            load.push_back(100.0 * (full.processorSeconds - brief.processorSeconds) / span);
            memory.push_back(full.peakMiB);
            frame.push_back(full.frameMs);
        }
    }
    results.add(u"live.cpu"_s, u"live: processor time, all panels, simulator in process"_s,
                median(load), u"% of a core"_s);
    results.add(u"live.frame"_s, u"live: frame of the currents plot"_s, median(frame), u"ms"_s);
    results.add(u"live.memory"_s, u"live: peak memory (VmHWM)"_s, median(memory), u"MiB"_s);
}

} // namespace trex::bench
