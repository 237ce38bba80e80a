// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/plotview.h"

#include "protocol/telemetry/marktrack.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/plotinput.h"
#include "widgets/common/plotoverlay.h"
#include "widgets/common/plottrace.h"

#include <QChart>
#include <QElapsedTimer>
#include <QGraphicsLayout>
#include <QHelpEvent>
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
constexpr double kOverlayZ = 21.0;
constexpr int kLeftMargin = 4;
constexpr int kRightMargin = 14;
constexpr int kSmallestHeight = 64;

double seconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

} // namespace

PlotView::PlotView(const TelemetryStore& store, FrameTicker& ticker, QWidget* parent,
                   PlotTimeline* shared)
    : QChartView(new QChart, parent)
    , m_timeline(shared != nullptr ? shared : new PlotTimeline(store, this))
    , m_ticker(ticker)
    , m_valueAxis(new QValueAxis(this))
    , m_timeAxis(new QValueAxis(this))
    , m_trace(new PlotTrace(chart()))
    , m_overlay(new PlotOverlay(chart()))
    , m_frame(std::make_unique<PlotFrame>())
    , m_input(std::make_unique<PlotInput>(*this))
    , m_number(m_timeline->newPlot())
{
    buildChart();
    applyColours();
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(240, shared != nullptr ? kSmallestHeight : 140);
    setAccessibleDescription(PlotInput::help());
    connect(&ticker, &FrameTicker::tick, this, &PlotView::refresh);
    connect(chart(), &QChart::plotAreaChanged, this, [this] {
        redraw();
        noteAxisExtent();
    });
    connect(m_timeline, &PlotTimeline::pausedChanged, this, &PlotView::pausedChanged);
    connect(m_timeline, &PlotTimeline::cursorsChanged, this, &PlotView::redraw);
    connect(m_timeline, &PlotTimeline::viewChanged, this, [this] {
        place();
        fitValues(true);
        redraw();
        emit viewChanged();
    });
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
    m_overlay->setZValue(kOverlayZ);
    applyMargins();
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
    m_frame->colours = {.panel = theme::colour(ColourRole::Panel),
                        .grid = theme::colour(ColourRole::Grid),
                        .text = theme::colour(ColourRole::Text),
                        .dim = text,
                        .stale = theme::colour(ColourRole::Stale),
                        .accent = theme::colour(ColourRole::Accent),
                        .action = theme::colour(ColourRole::Accent),
                        .warning = theme::colour(ColourRole::Warning),
                        .fault = theme::colour(ColourRole::Fault)};
    m_frame->font = theme::font(1.0, true);
    for (std::size_t i = 0; i < m_colours.size(); ++i) {
        m_frame->curves[i].colour = theme::colour(m_colours[i]);
        const auto series = chart()->series().at(static_cast<qsizetype>(i));
        qobject_cast<QLineSeries*>(series)->setPen(QPen(theme::colour(m_colours[i]), 3.0));
    }
    setLimits(m_limits);
}

void PlotView::applyValueAxis()
{
    // A low plot has room for fewer labels.
    const double height = m_frame->area.height();
    const int most = height <= 0.0 ? 5 : std::clamp(static_cast<int>(height / 30.0), 2, 5);
    const double step = ticks::niceStep(m_frame->high - m_frame->low, most);
    const int decimals = std::max(ticks::decimalsFor(step), m_unit == u'A' ? 1 : 0);
    const QString format = QStringLiteral("%.%1f%2").arg(decimals);
    m_valueAxis->setLabelFormat(format.arg(m_unit.isEmpty() ? QString() : u' ' + m_unit));
    m_valueAxis->setTickInterval(step);
    m_valueAxis->setRange(m_frame->low, m_frame->high);
}

void PlotView::applyMargins()
{
    const int room = static_cast<int>(std::max(m_axisExtent - m_ownExtent, 0.0));
    const int below = m_frame->showsTimes ? static_cast<int>(PlotTrace::kLabelStrip) + 2 : 4;
    const int above = chart()->legend()->isVisible() ? 0 : 4;
    const QMargins margins(kLeftMargin + room, above, kRightMargin, below);
    if (chart()->margins() != margins) {
        chart()->setMargins(margins);
    }
}

/// Right after a layout only: later the margins may be newer than the area.
void PlotView::noteAxisExtent()
{
    const double extent =
        std::ceil(std::max(chart()->plotArea().left() - chart()->margins().left(), 0.0));
    if (extent != m_ownExtent) {
        m_ownExtent = extent;
        emit axisExtentChanged();
    }
}

void PlotView::setAxisExtent(double pixels)
{
    m_axisExtent = pixels;
    applyMargins();
}

void PlotView::setPlaceInStack(bool isTop, bool isBottom)
{
    m_frame->showsTimes = isBottom;
    m_frame->showsCursorTimes = isBottom;
    m_frame->showsMarkSigns = isTop;
    applyMargins();
    redraw();
}

void PlotView::setLegendShown(bool shown)
{
    chart()->legend()->setVisible(shown);
    applyMargins();
}

void PlotView::setLive(bool live)
{
    m_timeline->setLive(live);
    redraw();
}

void PlotView::setMessage(const QString& message)
{
    if (m_frame->message != message) {
        m_frame->message = message;
        redraw();
    }
}

void PlotView::setTool(Tool tool)
{
    m_input->setTool(tool);
}

void PlotView::place()
{
    m_timeline->place();
    m_frame->origin = m_timeline->origin();
    m_frame->from = m_timeline->from();
    m_frame->span = m_timeline->span();
    m_frame->marks = m_timeline->marks();
    m_frame->shownMark = m_timeline->shownMark();
    m_frame->cursors.clear();
    for (int i = 0; i < PlotTimeline::kCursors; ++i) {
        m_frame->cursors.push_back(m_timeline->cursor(i));
    }
    m_frame->activeCursor = m_timeline->activeCursor();
    std::optional<Instant> last;
    for (const PlotFrame::Curve& curve : m_frame->curves) {
        if (!curve.series->isEmpty()) {
            const Instant time = TimeAxis::instantOf(curve.series->axis().lastTick());
            last = std::max(last.value_or(time), time);
        }
    }
    m_drawnTo = last;
    m_frame->staleFrom.reset();
    if (m_timeline->isLive() && last && m_timeline->now() - *last > kStaleAfter) {
        m_frame->staleFrom = last;
    }
}

void PlotView::fitValues(bool atOnce)
{
    double low = 0.0;
    double high = 0.0;
    if (const auto byHand = m_timeline->values(m_number)) {
        std::tie(low, high) = *byHand;
    } else {
        const auto [lowest, highest] = valueExtent();
        if (atOnce) {
            m_range.fit(lowest, highest);
        } else {
            m_range.update(lowest, highest, m_timeline->now());
        }
        low = m_range.low();
        high = m_range.high();
    }
    if (m_frame->low != low || m_frame->high != high) {
        m_frame->low = low;
        m_frame->high = high;
        applyValueAxis();
    }
}

void PlotView::zoomValues(double factor, double about)
{
    constexpr double kSmallestSpan = 0.02;
    constexpr double kLargestSpan = 1e6;
    const double span = m_frame->high - m_frame->low;
    const double wanted = std::clamp(span * factor, kSmallestSpan, kLargestSpan);
    const double low = m_frame->low + about * (span - wanted);
    m_timeline->setValues(m_number, {low, low + wanted});
}

void PlotView::panValues(double part)
{
    const double shift = (m_frame->high - m_frame->low) * part;
    m_timeline->setValues(m_number, {m_frame->low + shift, m_frame->high + shift});
}

void PlotView::zoomInto(const QRectF& box)
{
    constexpr double kSmallestBox = 8.0; // pixels
    constexpr double kSmallestSpan = 0.02;
    const double low = m_frame->physicalAt(box.bottom());
    const double high = std::max(m_frame->physicalAt(box.top()), low + kSmallestSpan);
    const Instant from = m_frame->timeAt(box.left());
    const Duration span = m_frame->timeAt(box.right()) - from;
    if (box.width() < kSmallestBox) {
        m_timeline->setValues(m_number, {low, high});
    } else if (box.height() < kSmallestBox) {
        m_timeline->stand(from, span);
    } else {
        m_timeline->setView(m_number, {low, high}, from, span);
    }
}

void PlotView::refresh()
{
    if (!isVisible() || viewport()->visibleRegion().isEmpty()) {
        return;
    }
    const quint64 marks = m_timeline->marks() != nullptr ? m_timeline->marks()->revision() : 0;
    bool isNew = m_timeline->store().revision() != m_drawnRevision;
    bool isTimeDue = false;
    if (m_timeline->isStanding()) { // what comes behind is not in sight
        m_timeline->place();
        isNew = isNew
            && (m_timeline->store().clears() != m_drawnClears || !m_drawnTo
                || *m_drawnTo < m_frame->from + m_frame->span);
        isTimeDue = m_timeline->from() != m_frame->from || m_timeline->span() != m_frame->span;
    } else {
        isTimeDue =
            m_timeline->isLive() && m_drawnAt && m_timeline->now() - *m_drawnAt >= kIdleRefresh;
    }
    if (isNew || isTimeDue || marks != m_drawnMarks) {
        redraw();
    }
}

void PlotView::redraw()
{
    m_drawnRevision = m_timeline->store().revision();
    m_drawnClears = m_timeline->store().clears();
    m_drawnMarks = m_timeline->marks() != nullptr ? m_timeline->marks()->revision() : 0;
    m_drawnAt = m_timeline->now();
    m_frame->area = chart()->plotArea();
    place();
    fillReferences();
    fitValues(false);
    m_trace->setFrame(*m_frame);
    m_overlay->setFrame(*m_frame);
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
    m_frame->area = chart()->plotArea();
    applyValueAxis();
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

bool PlotView::viewportEvent(QEvent* event)
{
    return (m_input && m_input->handle(event)) || QChartView::viewportEvent(event);
}

void PlotView::keyPressEvent(QKeyEvent* event)
{
    if (!m_input->pressKey(*event)) {
        QChartView::keyPressEvent(event); // Escape must reach the stop action
    }
}

void PlotView::focusInEvent(QFocusEvent* event)
{
    QChartView::focusInEvent(event);
    emit focused();
}

double PlotView::fromSeconds() const
{
    return seconds(m_timeline->from() - m_timeline->origin());
}

double PlotView::toSeconds() const
{
    return fromSeconds() + seconds(m_timeline->span());
}

void PlotView::setClock(Clock clock)
{
    m_timeline->setClock(std::move(clock));
    redraw();
}

void PlotView::setRubberBand(const QRectF& box)
{
    m_frame->rubberBand = box;
    redraw();
}

} // namespace trex
