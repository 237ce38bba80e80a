// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/benchsections.h"

#include "protocol/telemetry/telemetrystore.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/plotview.h"

#include <QApplication>
#include <QChart>
#include <QElapsedTimer>
#include <QLineSeries>
#include <QValueAxis>

#include <cmath>

namespace trex::bench {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr auto kStep = 12'500us; // 80 Hz
constexpr double kNsPerMs = 1e6;
constexpr int kWidth = 1000;
constexpr int kHeight = 400;

std::uint16_t current(std::size_t i, int motor)
{
    const double wave = std::sin(double(i) * (motor == 0 ? 0.01 : 0.013));
    return static_cast<std::uint16_t>(60.0 + 40.0 * wave + double((i * 2654435761U) >> 28 & 7U));
}

void fill(TelemetryStore& store, std::size_t count, Instant end)
{
    constexpr std::size_t kPeriod = 8192; // made before, so that only the store is measured
    static const auto kValues = [] {
        std::vector<std::array<std::uint16_t, kChannelCount>> values(kPeriod);
        for (std::size_t i = 0; i < kPeriod; ++i) {
            values[i] = {current(i, 0), current(i, 1)};
        }
        return values;
    }();
    for (std::size_t i = 0; i < count; ++i) {
        const Instant time = end - static_cast<std::int64_t>(count - i) * kStep;
        store.append({PollId::Currents, kValues[i % kPeriod], time});
    }
}

double milliseconds(const QElapsedTimer& timer)
{
    return static_cast<double>(timer.nsecsElapsed()) / kNsPerMs;
}

/// A frame: some samples more, the window slides, everything is painted.
class OurPlot {
public:
    explicit OurPlot(std::size_t count)
    {
        fill(m_store, count, m_now);
        m_plot.setClock([this] { return m_now; });
        m_plot.addCurve("motor1-current", ColourRole::Motor1);
        m_plot.addCurve("motor2-current", ColourRole::Motor2);
        m_plot.setWindowSeconds(PlotView::kWholeSession);
        m_plot.resize(kWidth, kHeight);
        m_plot.show();
        QApplication::processEvents();
    }
    double frame()
    {
        QElapsedTimer timer;
        timer.start();
        for (int i = 0; i < 64; ++i) {
            m_now += kStep;
            m_store.append({PollId::Currents, {current(std::size_t(i), 0), 30}, m_now});
        }
        m_plot.refresh();
        m_plot.viewport()->repaint();
        return milliseconds(timer);
    }

private:
    TelemetryStore m_store;
    FrameTicker m_ticker;
    Instant m_now{1'000'000s};
    PlotView m_plot{m_store, m_ticker};
};

/// The same with Qt Charts' own line series, given all points.
class ChartsPlot {
public:
    explicit ChartsPlot(std::size_t count)
    {
        auto* chart = m_view.chart();
        chart->addAxis(m_time, Qt::AlignBottom);
        chart->addAxis(m_value, Qt::AlignLeft);
        m_value->setRange(0.0, 5.0);
        for (int motor = 0; motor < 2; ++motor) {
            auto* series = new QLineSeries(chart);
            chart->addSeries(series);
            series->attachAxis(m_time);
            series->attachAxis(m_value);
            for (std::size_t i = 0; i < count; ++i) {
                m_points[std::size_t(motor)].append({double(i) * 0.0125, current(i, motor) * 0.04});
            }
            m_series[std::size_t(motor)] = series;
        }
        m_view.resize(kWidth, kHeight);
        m_view.show();
        QApplication::processEvents();
    }
    double frame()
    {
        QElapsedTimer timer;
        timer.start();
        for (std::size_t motor = 0; motor < m_series.size(); ++motor) {
            for (int i = 0; i < 64; ++i) {
                m_points[motor].append({m_points[motor].last().x() + 0.0125, 1.0});
            }
            m_series[motor]->replace(m_points[motor]);
        }
        m_time->setRange(0.0, m_points[0].last().x());
        m_view.viewport()->repaint();
        return milliseconds(timer);
    }

private:
    QChartView m_view;
    QValueAxis* m_time = new QValueAxis(&m_view);
    QValueAxis* m_value = new QValueAxis(&m_view);
    std::array<QLineSeries*, 2> m_series{};
    std::array<QList<QPointF>, 2> m_points;
};

} // namespace

void measureStore(Results& results)
{
    for (const std::size_t count :
         {std::size_t(1'000), std::size_t(100'000), std::size_t(10'000'000)}) {
        std::vector<double> append;
        std::vector<double> query;
        double bytes = 0.0;
        for (int run = 0; run < (count > 1'000'000 ? 3 : 7); ++run) {
            TelemetryStore store;
            const std::size_t empty = store.memoryBytes();
            QElapsedTimer timer;
            timer.start();
            fill(store, count, Instant(1'000'000s));
            append.push_back(double(timer.nsecsElapsed()) / double(2 * count));
            bytes = double(store.memoryBytes() - empty) / double(2 * count);
            std::vector<PlotColumn> columns;
            const TimeSeries& series = store.series("motor1-current");
            constexpr int kColumns = 900;
            const ColumnGrid grid{series.time(0), std::int64_t(count) * kStep / kColumns, kColumns};
            for (int i = 0; i < 20; ++i) {
                timer.restart();
                series.columns(grid, columns);
                query.push_back(double(timer.nsecsElapsed()) / 1000.0);
            }
        }
        const QString n = u"%1"_s.arg(double(count), 0, 'g', 1);
        results.add(u"store.append.%1"_s.arg(n), u"store: append at %1 samples a motor"_s.arg(n),
                    median(append), u"ns a sample"_s);
        results.add(u"store.bytes.%1"_s.arg(n), u"store: memory at %1 samples a motor"_s.arg(n),
                    bytes, u"bytes a sample"_s);
        results.add(u"store.query.%1"_s.arg(n),
                    u"store: a row of 900 pixels at %1 samples"_s.arg(n), median(query), u"us"_s);
    }
}

void measurePlot(Results& results)
{
    constexpr std::size_t kSamples = 100'000;
    OurPlot ours(kSamples);
    ChartsPlot charts(kSamples);
    OurPlot day(6'912'000); // 24 h at 80 Hz
    std::vector<double> oursMs;
    std::vector<double> chartsMs;
    std::vector<double> dayMs;
    for (int run = 0; run < 5; ++run) {
        chartsMs.push_back(charts.frame());
        for (int i = 0; i < 15; ++i) {
            oursMs.push_back(ours.frame());
            dayMs.push_back(day.frame());
        }
    }
    results.add(u"plot.frame.1e5"_s, u"plot: frame with 1e5 samples a motor, two motors"_s,
                median(oursMs), u"ms"_s);
    results.add(u"plot.frame.day"_s, u"plot: frame with 24 h at 80 Hz, two motors"_s, median(dayMs),
                u"ms"_s);
    results.add(u"plot.charts.1e5"_s, u"plot: the same 1e5 in Qt Charts' own line series"_s,
                median(chartsMs), u"ms"_s);
    results.add(u"plot.ratio"_s, u"plot: ours / Qt Charts"_s, median(oursMs) / median(chartsMs),
                {});
}

} // namespace trex::bench
