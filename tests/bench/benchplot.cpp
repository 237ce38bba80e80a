// SPDX-License-Identifier: GPL-3.0-or-later
// Frame times of the live plot at any length, against QCustomPlot fed all points and against the
// bare floor: image columns of the same pyramid in a widget that does nothing else.
#include "tests/bench/benchsamples.h"
#include "tests/bench/benchsections.h"

#include "widgets/common/frameticker.h"
#include "widgets/common/plotview.h"

#include <QApplication>
#include <QImage>
#include <QPainter>

#include <functional>
#include <memory>

#ifdef TREX_HAS_QCUSTOMPLOT
#include <qcustomplot.h>
#endif

namespace trex::bench {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double kNsPerMs = 1e6;
constexpr int kWidth = 1000;
constexpr int kHeight = 400;
constexpr int kNewSamples = 64; ///< of each motor, each frame
constexpr double kTop = 5.0; ///< amperes at the upper edge
constexpr double kAmperes = 0.04;

/// One way to draw a frame: some samples more, the window slides, everything is painted.
class Way {
public:
    virtual ~Way() = default;
    double frameMs()
    {
        const ThreadTimer timer;
        frame();
        return timer.ns() / kNsPerMs;
    }

protected:
    virtual void frame() = 0;
};

class StoreWay : public Way {
protected:
    explicit StoreWay(std::size_t count) { fillCurrents(m_store, count, m_now); }
    void appendNew()
    {
        for (int i = 0; i < kNewSamples; ++i) {
            m_now += kSampleStep;
            m_store.append({PollId::Currents, {currentAt(std::size_t(i), 0), 30}, m_now});
        }
    }
    TelemetryStore m_store;
    Instant m_now{1'000'000s};
};

class OurPlot : public StoreWay {
public:
    explicit OurPlot(std::size_t count) : StoreWay(count)
    {
        m_plot.setClock([this] { return m_now; });
        m_plot.addCurve("motor1-current", ColourRole::Motor1);
        m_plot.addCurve("motor2-current", ColourRole::Motor2);
        m_plot.setWindowSeconds(PlotView::kWholeSession);
        m_plot.resize(kWidth, kHeight);
        m_plot.show();
        QApplication::processEvents();
    }

protected:
    void frame() override
    {
        appendNew();
        m_plot.refresh();
        m_plot.viewport()->repaint();
    }

private:
    FrameTicker m_ticker;
    PlotView m_plot{m_store, m_ticker};
};

/// No axes, no text, no lines: columns of pixels in an image, and the image in a widget.
class Floor : public StoreWay {
public:
    explicit Floor(std::size_t count) : StoreWay(count), m_widget(*this)
    {
        m_widget.resize(kWidth, kHeight);
        m_widget.show();
        QApplication::processEvents();
    }

protected:
    void frame() override
    {
        appendNew();
        m_widget.repaint();
    }

private:
    class Widget : public QWidget {
    public:
        explicit Widget(Floor& floor) : m_floor(floor) { }

    protected:
        void paintEvent(QPaintEvent*) override
        {
            m_floor.drawColumns();
            QPainter(this).drawImage(0, 0, m_floor.m_image);
        }

    private:
        Floor& m_floor;
    };
    void drawColumns()
    {
        constexpr std::array kColours{0xFFE06020U, 0xFF2060E0U};
        constexpr double kPixelsPerCount = kHeight * kAmperes / kTop;
        m_image.fill(0xFFFFFFFFU);
        const qsizetype stride = m_image.bytesPerLine() / qsizetype(sizeof(quint32));
        auto* const pixels = reinterpret_cast<quint32*>(m_image.bits());
        const std::array keys{"motor1-current", "motor2-current"};
        for (std::size_t motor = 0; motor < keys.size(); ++motor) {
            const TimeSeries& series = m_store.series(keys[motor]);
            const Duration span = m_now - series.time(0);
            series.columns({series.time(0), span / kWidth, kWidth}, m_columns);
            for (int x = 0; x < kWidth; ++x) {
                const Extent& extent = m_columns[std::size_t(x)].extent;
                if (extent.isEmpty()) {
                    continue;
                }
                const auto row = [](int raw) {
                    return std::clamp(kHeight - 1 - int(raw * kPixelsPerCount), 0, kHeight - 1);
                };
                for (int y = row(extent.high); y <= row(extent.low); ++y) {
                    pixels[y * stride + x] = kColours[motor];
                }
            }
        }
    }

    QImage m_image{kWidth, kHeight, QImage::Format_RGB32};
    std::vector<PlotColumn> m_columns;
    Widget m_widget;
};

#ifdef TREX_HAS_QCUSTOMPLOT
/// All points, as its users do it; adaptive sampling is on, as it is by default.
class CustomPlot : public Way {
public:
    explicit CustomPlot(std::size_t count)
    {
        m_plot.legend->setVisible(true);
        for (int motor = 0; motor < 2; ++motor) {
            QCPGraph* graph = m_plot.addGraph();
            graph->setPen(QPen(motor == 0 ? QColor(224, 96, 32) : QColor(32, 96, 224)));
            QVector<QCPGraphData> points;
            points.reserve(qsizetype(count));
            for (std::size_t i = 0; i < count; ++i) {
                points.append({double(i) * kSeconds, currentAt(i, motor) * kAmperes});
            }
            graph->data()->set(points, true);
        }
        m_last = double(count - 1) * kSeconds;
        m_plot.yAxis->setRange(0.0, kTop);
        m_plot.resize(kWidth, kHeight);
        m_plot.show();
        QApplication::processEvents();
    }

protected:
    void frame() override
    {
        for (int i = 0; i < kNewSamples; ++i) {
            m_last += kSeconds;
            m_plot.graph(0)->addData(m_last, currentAt(std::size_t(i), 0) * kAmperes);
            m_plot.graph(1)->addData(m_last, 1.2);
        }
        m_plot.xAxis->setRange(0.0, m_last);
        m_plot.replot(QCustomPlot::rpImmediateRefresh);
    }

private:
    static constexpr double kSeconds = std::chrono::duration<double>(kSampleStep).count();
    QCustomPlot m_plot;
    double m_last = 0.0;
};
#endif

std::unique_ptr<Way> makeCustomPlot(std::size_t count)
{
#ifdef TREX_HAS_QCUSTOMPLOT
    return std::make_unique<CustomPlot>(count);
#else
    Q_UNUSED(count);
    return nullptr;
#endif
}

/// The three ways at one length, and what was measured of each.
struct Length {
    QString name;
    std::size_t count = 0;
    std::unique_ptr<Way> ours;
    std::unique_ptr<Way> floor;
    std::unique_ptr<Way> custom;
    std::vector<double> oursMs{};
    std::vector<double> floorMs{};
    std::vector<double> customMs{};
    std::vector<double> ofFloor{}; ///< ratios of what was measured side by side
    std::vector<double> ofCustom{};
};

/// Median of some frames of one way.
double burst(Way& way)
{
    std::vector<double> frames;
    for (int i = 0; i < 5; ++i) {
        frames.push_back(way.frameMs());
    }
    return median(frames);
}

void measureOnce(Length& length)
{
    const double ours = burst(*length.ours);
    const double floor = burst(*length.floor);
    length.oursMs.push_back(ours);
    length.floorMs.push_back(floor);
    length.ofFloor.push_back(ours / floor);
    if (length.custom) {
        const double custom = burst(*length.custom);
        length.customMs.push_back(custom);
        length.ofCustom.push_back(ours / custom);
    }
}

} // namespace

void measurePlot(Results& results)
{
    constexpr int kRounds = 21;
    std::vector<Length> lengths;
    for (const auto& [name, count] : {std::pair{u"1e3"_s, std::size_t(1'000)},
                                      {u"1e4"_s, 10'000},
                                      {u"1e5"_s, 100'000},
                                      {u"1e6"_s, 1'000'000},
                                      {u"1e7"_s, 10'000'000},
                                      {u"day"_s, kSamplesOfADay}}) {
        lengths.push_back({.name = name,
                           .count = count,
                           .ours = std::make_unique<OurPlot>(count),
                           .floor = std::make_unique<Floor>(count),
                           .custom = makeCustomPlot(count)});
    }
    std::vector<double> growth;
    for (int round = 0; round < kRounds; ++round) {
        for (Length& length : lengths) {
            measureOnce(length);
        }
        growth.push_back(lengths[4].oursMs.back() / lengths[1].oursMs.back());
    }
    for (const Length& length : lengths) {
        const QString key = u"plot.%1."_s.arg(length.name);
        const QString title = length.name == u"day"_s
            ? u"plot: two motors, 24 h at 80 Hz, "_s
            : u"plot: two motors, %1 points each, "_s.arg(length.name);
        results.add(key + u"ours"_s, title + u"ours"_s, median(length.oursMs), u"ms a frame"_s);
        results.add(key + u"floor"_s, title + u"the floor"_s, median(length.floorMs),
                    u"ms a frame"_s);
        results.add(key + u"ofFloor"_s, title + u"ours / floor"_s, median(length.ofFloor), {});
        if (length.custom) {
            results.add(key + u"custom"_s, title + u"QCustomPlot"_s, median(length.customMs),
                        u"ms a frame"_s);
            results.add(key + u"ofCustom"_s, title + u"ours / QCustomPlot"_s,
                        median(length.ofCustom), {});
        }
    }
    results.add(u"plot.growth"_s, u"plot: ours at 1e7 / at 1e4"_s, median(growth), {});
    if (!lengths.front().custom) {
        results.note(
            u"plot: QCustomPlot was not there when this was built; no comparison with it"_s);
    }
}

} // namespace trex::bench
