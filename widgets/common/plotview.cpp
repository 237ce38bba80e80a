// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/plotview.h"

#include "protocol/telemetry/streamtable.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/plottrace.h"

#include <QChart>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QGraphicsLayout>
#include <QLegend>
#include <QLineSeries>
#include <QValueAxis>

#include <cmath>

namespace trex {

using namespace std::chrono_literals;

namespace {

constexpr auto kStaleAfter = 500ms; ///< without a sample this long, the plot says so
constexpr auto kIdleRefresh = 200ms; ///< while nothing comes, time goes on in such steps
constexpr double kTraceZ = 20.0; ///< above the grid of the chart
constexpr Duration kShortestSession = 10s; ///< "whole session" shows at least this much

double seconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

} // namespace

PlotView::PlotView(const TelemetryStore& store, FrameTicker& ticker, QWidget* parent)
    : QChartView(new QChart, parent)
    , m_store(store)
    , m_ticker(ticker)
    , m_clock([] { return std::chrono::steady_clock::now(); })
    , m_valueAxis(new QValueAxis(this))
    , m_timeAxis(new QValueAxis(this))
    , m_trace(new PlotTrace(chart()))
    , m_frame(std::make_unique<PlotFrame>())
{
    buildChart();
    applyColours();
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(240, 140);
    setAccessibleDescription(
        tr("Arrow keys pan, plus and minus zoom, with Ctrl the values; Home shows the start, End "
           "follows the newest, F shows everything, P pauses."));
    connect(&ticker, &FrameTicker::tick, this, &PlotView::refresh);
    connect(chart(), &QChart::plotAreaChanged, this, &PlotView::redraw);
}

PlotView::~PlotView() = default;

void PlotView::buildChart()
{
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing, false);
    setViewportUpdateMode(QGraphicsView::MinimalViewportUpdate);
    chart()->setAnimationOptions(QChart::NoAnimation);
    chart()->setBackgroundRoundness(0);
    m_trace->setZValue(kTraceZ);
    chart()->setMargins({4, 0, 12, static_cast<int>(PlotTrace::kLabelStrip) + 2});
    chart()->layout()->setContentsMargins(0, 0, 0, 0);
    chart()->legend()->setAlignment(Qt::AlignTop);
    chart()->legend()->setContentsMargins(0, 0, 0, 0);
    chart()->legend()->layout()->setContentsMargins(0, 0, 0, 0);
    chart()->legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
    m_valueAxis->setTickType(QValueAxis::TicksDynamic);
    m_valueAxis->setTickAnchor(0.0);
    m_timeAxis->setRange(0.0, 1.0);
    m_timeAxis->setVisible(false);
    chart()->addAxis(m_timeAxis, Qt::AlignBottom);
    chart()->addAxis(m_valueAxis, Qt::AlignLeft);
    applyValueAxis();
}

int PlotView::addCurve(std::string_view streamKey, ColourRole colour)
{
    const int index = streamIndex(streamKey);
    const StreamRow& row = streams()[static_cast<std::size_t>(index)];
    // The legend asks for a series; ours stays empty, the trace draws the samples.
    auto* marker = new QLineSeries(chart());
    marker->setName(QCoreApplication::translate("Streams", row.title));
    chart()->addSeries(marker);
    marker->attachAxis(m_timeAxis);
    marker->attachAxis(m_valueAxis);
    m_frame->curves.push_back({&m_store.series(index), {}, row.scale, row.offset, true});
    m_colours.push_back(colour);
    applyColours();
    return static_cast<int>(m_frame->curves.size()) - 1;
}

void PlotView::setCurveScale(int curve, double scale)
{
    m_frame->curves.at(static_cast<std::size_t>(curve)).scale = scale;
    redraw();
}

void PlotView::setCurveVisible(int curve, bool visible)
{
    m_frame->curves.at(static_cast<std::size_t>(curve)).isVisible = visible;
    chart()->series().at(curve)->setVisible(visible);
    redraw();
}

bool PlotView::isCurveVisible(int curve) const
{
    return m_frame->curves.at(static_cast<std::size_t>(curve)).isVisible;
}

void PlotView::setUnit(const QString& unit)
{
    m_unit = unit;
    applyValueAxis();
}

void PlotView::setSmallestTop(double physical)
{
    m_top = ticks::AxisTop(physical);
    redraw();
}

void PlotView::applyColours()
{
    const QColor text = theme::colour(ColourRole::DimText);
    chart()->setBackgroundBrush(theme::colour(ColourRole::Panel));
    chart()->setBackgroundPen(Qt::NoPen);
    setBackgroundBrush(theme::colour(ColourRole::Panel));
    m_valueAxis->setLabelsBrush(text);
    m_valueAxis->setLabelsFont(theme::font(1.0, true));
    m_valueAxis->setGridLinePen(QPen(theme::colour(ColourRole::Grid), 1.0));
    m_valueAxis->setLinePen(QPen(theme::colour(ColourRole::Border), 1.0));
    chart()->legend()->setLabelBrush(theme::colour(ColourRole::Text));
    chart()->legend()->setFont(theme::font(1.0));
    m_frame->colours = {theme::colour(ColourRole::Grid), text, theme::colour(ColourRole::Stale),
                        theme::colour(ColourRole::Accent)};
    m_frame->font = theme::font(1.0, true);
    for (std::size_t i = 0; i < m_frame->curves.size(); ++i) {
        m_frame->curves[i].colour = theme::colour(m_colours[i]);
        const auto series = chart()->series().at(static_cast<qsizetype>(i));
        qobject_cast<QLineSeries*>(series)->setPen(QPen(theme::colour(m_colours[i]), 3.0));
    }
    redraw();
}

void PlotView::applyValueAxis()
{
    const double step = ticks::niceStep(m_frame->high - m_frame->low, 5);
    const QString format = QStringLiteral("%.%1f%2").arg(std::max(ticks::decimalsFor(step), 1));
    m_valueAxis->setLabelFormat(format.arg(m_unit.isEmpty() ? QString() : u' ' + m_unit));
    m_valueAxis->setTickInterval(step);
    m_valueAxis->setRange(m_frame->low, m_frame->high);
}

void PlotView::setWindowSeconds(int windowSeconds)
{
    m_windowSeconds = windowSeconds;
    if (m_paused) { // the right edge stays, so that what was paused at is still seen
        const Instant right = m_frame->from + m_frame->span;
        if (windowSeconds == kWholeSession) {
            const Instant from = m_store.start().value_or(right - kShortestSession);
            m_frame->span = std::max<Duration>(rightEdge() - from, kShortestSession);
            m_frame->from = from;
        } else {
            m_frame->span = std::chrono::seconds(windowSeconds);
            m_frame->from = right - m_frame->span;
        }
    }
    fitValues(true);
    redraw();
    emit viewChanged();
}

void PlotView::setPaused(bool paused)
{
    if (m_paused == paused) {
        return;
    }
    place();
    m_paused = paused;
    redraw();
    emit pausedChanged(paused);
    emit viewChanged();
}

void PlotView::setLive(bool live)
{
    m_live = live;
    redraw();
}

void PlotView::setMessage(const QString& message)
{
    if (m_frame->message != message) {
        m_frame->message = message;
        redraw();
    }
}

std::optional<Instant> PlotView::lastSample() const
{
    std::optional<Instant> last;
    for (const PlotFrame::Curve& curve : m_frame->curves) {
        if (!curve.series->isEmpty()) {
            const Instant time = TimeAxis::instantOf(curve.series->axis().lastTick());
            last = std::max(last.value_or(time), time);
        }
    }
    return last;
}

Instant PlotView::rightEdge() const
{
    const Instant now = m_clock();
    return m_live ? now : lastSample().value_or(now);
}

void PlotView::place()
{
    m_frame->origin = m_store.start().value_or(rightEdge());
    if (!m_paused) {
        const Instant right = rightEdge();
        m_frame->span = std::chrono::seconds(m_windowSeconds);
        if (m_windowSeconds == kWholeSession) {
            m_frame->span = std::max<Duration>(right - m_frame->origin, kShortestSession);
        }
        m_frame->from = right - m_frame->span;
        if (m_windowSeconds == kWholeSession && m_frame->from < m_frame->origin) {
            m_frame->from = m_frame->origin;
        }
    }
    const auto last = lastSample();
    m_frame->staleFrom.reset();
    if (m_live && last && m_clock() - *last > kStaleAfter) {
        m_frame->staleFrom = last;
    }
}

void PlotView::fitValues(bool atOnce)
{
    if (m_valuesByHand) {
        return;
    }
    double highest = 0.0;
    for (const PlotFrame::Curve& curve : m_frame->curves) {
        if (curve.isVisible) {
            const auto [begin, end] =
                curve.series->range(m_frame->from, m_frame->from + m_frame->span);
            const Extent extent = curve.series->extent(begin, end);
            if (!extent.isEmpty()) {
                highest = std::max(highest, (extent.high + curve.offset) * curve.scale);
            }
        }
    }
    const bool moved = atOnce ? m_top.fit(highest) : m_top.update(highest, m_clock());
    if (moved || m_frame->low != 0.0 || m_frame->high != m_top.top()) {
        m_frame->low = 0.0;
        m_frame->high = m_top.top();
        applyValueAxis();
    }
}

void PlotView::refresh()
{
    if (!isVisible() || viewport()->visibleRegion().isEmpty()) {
        return;
    }
    const bool isNew = m_store.revision() != m_drawnRevision;
    const bool isTimeDue =
        m_live && !m_paused && m_drawnAt && m_clock() - *m_drawnAt >= kIdleRefresh;
    if (isNew || isTimeDue) {
        redraw();
    }
}

void PlotView::redraw()
{
    m_drawnRevision = m_store.revision();
    m_drawnAt = m_clock();
    m_frame->area = chart()->plotArea();
    place();
    fitValues(false);
    m_trace->setFrame(*m_frame);
}

void PlotView::paintEvent(QPaintEvent* event)
{
    QElapsedTimer timer;
    timer.start();
    QChartView::paintEvent(event);
    constexpr double kNanosecondsPerMs = 1e6;
    m_ticker.framePainted(static_cast<double>(timer.nsecsElapsed()) / kNanosecondsPerMs);
}

void PlotView::resizeEvent(QResizeEvent* event)
{
    QChartView::resizeEvent(event);
    redraw();
}

void PlotView::showEvent(QShowEvent* event)
{
    QChartView::showEvent(event);
    redraw();
}

void PlotView::changeEvent(QEvent* event)
{
    QChartView::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        applyColours();
    }
}

TimeRange PlotView::visibleRange() const
{
    return {m_frame->from, m_frame->from + m_frame->span};
}

double PlotView::fromSeconds() const
{
    return seconds(m_frame->from - m_frame->origin);
}

double PlotView::toSeconds() const
{
    return fromSeconds() + seconds(m_frame->span);
}

double PlotView::top() const
{
    return m_frame->high;
}

double PlotView::bottom() const
{
    return m_frame->low;
}

void PlotView::setClock(Clock clock)
{
    m_clock = std::move(clock);
    redraw();
}

QImage PlotView::picture(double scale)
{
    redraw();
    QImage image(size() * scale, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(theme::colour(ColourRole::Panel));
    QPainter painter(&image);
    render(&painter, QRectF(QPointF(), QSizeF(size())), viewport()->rect());
    return image;
}

} // namespace trex
