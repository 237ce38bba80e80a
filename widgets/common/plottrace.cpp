// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/plottrace.h"

#include "widgets/common/plotticks.h"

#include <QCoreApplication>
#include <QPainter>

#include <cmath>

namespace trex {

namespace {

constexpr double kTraceWidth = 1.6;
constexpr double kDotRadius = 1.8;
constexpr int kColumnAlpha = 190; ///< columns cover each other; the curve behind shows through
/// Up to so many samples a column they are joined by a line; above, columns show their extremes.
constexpr double kMostJoined = 2.5;
constexpr double kLabelSpacing = 84.0; ///< at least, between two time labels
constexpr double kTickLength = 4.0;

double secondsOf(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

} // namespace

double PlotFrame::xOf(Instant time) const
{
    return area.left() + area.width() * (secondsOf(time - from) / secondsOf(span));
}

double PlotFrame::yOf(double physical) const
{
    return area.bottom() - area.height() * ((physical - low) / (high - low));
}

Instant PlotFrame::timeAt(double x) const
{
    const double seconds = (x - area.left()) / area.width() * secondsOf(span);
    return from + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

double PlotFrame::physicalAt(double y) const
{
    return low + (area.bottom() - y) / area.height() * (high - low);
}

void PlotTrace::setFrame(const PlotFrame& frame)
{
    if (frame.area != m_frame.area) {
        prepareGeometryChange();
    }
    m_frame = frame;
    update();
}

QRectF PlotTrace::boundingRect() const
{
    return m_frame.area.adjusted(-kLabelSpacing / 2, -1.0, kLabelSpacing / 2, kLabelStrip);
}

void PlotTrace::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*)
{
    if (m_frame.area.isEmpty()) {
        return;
    }
    paintTimeAxis(*painter);
    painter->save();
    painter->setClipRect(m_frame.area.adjusted(0.0, -1.0, 0.0, 1.0));
    paintStale(*painter);
    const double pixelRatio = painter->device()->devicePixelRatioF();
    for (const PlotFrame::Curve& curve : m_frame.curves) {
        if (curve.isVisible && !curve.series->isEmpty()) {
            paintCurve(*painter, curve, pixelRatio);
        }
    }
    if (!m_frame.rubberBand.isEmpty()) {
        QColor fill = m_frame.colours.accent;
        fill.setAlpha(40);
        painter->setPen(QPen(m_frame.colours.accent, 1.0));
        painter->setBrush(fill);
        painter->drawRect(m_frame.rubberBand);
    }
    painter->restore();
    paintMessage(*painter);
}

void PlotTrace::paintTimeAxis(QPainter& painter) const
{
    const QRectF& area = m_frame.area;
    const int most = std::max(1, static_cast<int>(area.width() / kLabelSpacing));
    const double step = ticks::timeStep(secondsOf(m_frame.span), most);
    const double first = secondsOf(m_frame.from - m_frame.origin);
    const double last = first + secondsOf(m_frame.span);
    painter.setFont(m_frame.font);
    const QFontMetricsF metrics(m_frame.font);
    for (double k = std::ceil(first / step); k * step <= last; k += 1.0) {
        const double x =
            std::round(area.left() + area.width() * (k * step - first) / (last - first));
        painter.setPen(QPen(m_frame.colours.grid, 1.0));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom() + kTickLength));
        if (k < 0.0) {
            continue; // before the session: a line, but no time
        }
        const QString label = ticks::timeLabel(k * step, step);
        const double width = metrics.horizontalAdvance(label);
        if (x - width / 2 >= area.left() - kLabelSpacing / 2
            && x + width / 2 <= area.right() + 8.0) {
            painter.setPen(m_frame.colours.text);
            painter.drawText(QPointF(x - width / 2, area.bottom() + kTickLength + metrics.ascent()),
                             label);
        }
    }
}

void PlotTrace::paintStale(QPainter& painter) const
{
    if (!m_frame.staleFrom) {
        return;
    }
    const double x = std::max(m_frame.xOf(*m_frame.staleFrom), m_frame.area.left());
    const QRectF region(QPointF(x, m_frame.area.top()), m_frame.area.bottomRight());
    if (region.width() < 1.0) {
        return;
    }
    QColor tint = m_frame.colours.stale;
    tint.setAlpha(24);
    painter.fillRect(region, tint);
    tint.setAlpha(90);
    painter.fillRect(region, QBrush(tint, Qt::BDiagPattern));
    const QString text = QCoreApplication::translate("PlotView", "no data");
    if (QFontMetricsF(m_frame.font).horizontalAdvance(text) + 16.0 < region.width()) {
        painter.setFont(m_frame.font);
        painter.setPen(m_frame.colours.text);
        painter.drawText(region, Qt::AlignCenter, text);
    }
}

void PlotTrace::paintCurve(QPainter& painter, const PlotFrame::Curve& curve, double pixelRatio)
{
    const auto [begin, end] = curve.series->range(m_frame.from, m_frame.from + m_frame.span);
    const double columns = m_frame.area.width() * pixelRatio;
    if (static_cast<double>(end - begin) <= kMostJoined * columns) {
        paintSamples(painter, curve, begin, end);
    } else {
        paintColumns(painter, curve, pixelRatio);
    }
}

void PlotTrace::paintSamples(QPainter& painter, const PlotFrame::Curve& curve, std::size_t begin,
                             std::size_t end)
{
    const TimeSeries& series = *curve.series;
    begin -= begin > series.first()
        ? 1
        : 0; // one more at each side, so that the line leaves through the edge
    end += end < series.size() ? 1 : 0;
    m_lines.clear();
    QList<QPointF> lonely; ///< samples with nothing known on either side
    std::optional<QPointF> previous;
    bool isJoined = false;
    const auto endRun = [&] {
        if (previous && !isJoined) {
            lonely.append(*previous);
        }
        previous.reset();
        isJoined = false;
    };
    for (std::size_t i = begin; i < end; ++i) {
        if (!series.isValid(i) || (i > begin && series.axis().hasGapBetween(i - 1, i))) {
            endRun();
        }
        if (series.isValid(i)) {
            const double physical = (series.value(i) + curve.offset) * curve.scale;
            const QPointF point(m_frame.xOf(series.time(i)), m_frame.yOf(physical));
            if (previous) {
                m_lines.append(QLineF(*previous, point));
                isJoined = true;
            }
            previous = point;
        }
    }
    endRun();
    painter.setRenderHint(QPainter::Antialiasing, true);
    // Lines by themselves with square caps: Qt has a short way for these, a polyline takes ten
    // times as long.
    painter.setPen(QPen(curve.colour, kTraceWidth, Qt::SolidLine, Qt::SquareCap));
    painter.drawLines(m_lines);
    painter.setPen(Qt::NoPen);
    painter.setBrush(curve.colour);
    for (const QPointF& point : lonely) {
        painter.drawEllipse(point, kDotRadius, kDotRadius);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void PlotTrace::paintColumns(QPainter& painter, const PlotFrame::Curve& curve, double pixelRatio)
{
    // Columns stand on multiples of their width in time, so that a sliding trace keeps its shape.
    const auto count = static_cast<int>(m_frame.area.width() * pixelRatio) + 2;
    const Duration width = std::max<Duration>(m_frame.span / (count - 2), TimeAxis::kTick);
    const Duration sinceEpoch = m_frame.from.time_since_epoch();
    const Instant from(sinceEpoch - sinceEpoch % width);
    const TimeSeries& series = *curve.series;
    series.columns({from, width, count}, m_columns);

    const double pixel = 1.0 / pixelRatio;
    const double left = m_frame.xOf(from) + pixel / 2;
    const double half = kTraceWidth / 2;
    m_lines.clear();
    const PlotColumn* previous = nullptr;
    std::size_t previousIndex = 0;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const PlotColumn& column = m_columns[i];
        if (column.begin == column.end) {
            continue;
        }
        if (column.extent.isEmpty()) { // only invalid samples: the line breaks
            previous = nullptr;
            continue;
        }
        Extent bar = column.extent;
        if (previous != nullptr && !series.axis().hasGapBetween(previous->end - 1, column.begin)) {
            if (previousIndex + 1 == i) { // the bars of neighbours touch
                bar.low = std::min(bar.low, previous->extent.high);
                bar.high = std::max(bar.high, previous->extent.low);
            } else {
                const auto y = [&](std::size_t sample) {
                    return m_frame.yOf((series.value(sample) + curve.offset) * curve.scale);
                };
                m_lines.append(QLineF(left + double(previousIndex) * pixel, y(previous->end - 1),
                                      left + double(i) * pixel, y(column.begin)));
            }
        }
        const double x = left + double(i) * pixel;
        m_lines.append(QLineF(x, m_frame.yOf((bar.high + curve.offset) * curve.scale) - half, x,
                              m_frame.yOf((bar.low + curve.offset) * curve.scale) + half));
        previous = &column;
        previousIndex = i;
    }
    QColor colour = curve.colour;
    colour.setAlpha(kColumnAlpha);
    QPen pen(colour, 1.0);
    pen.setCosmetic(true);
    pen.setCapStyle(Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLines(m_lines);
}

void PlotTrace::paintMessage(QPainter& painter) const
{
    if (m_frame.message.isEmpty()) {
        return;
    }
    painter.setFont(m_frame.font);
    painter.setPen(m_frame.colours.text);
    painter.drawText(m_frame.area.adjusted(16, 8, -16, -8), Qt::AlignCenter | Qt::TextWordWrap,
                     m_frame.message);
}

} // namespace trex
