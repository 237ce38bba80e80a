// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/plottrace.h"

#include "widgets/common/plotticks.h"

#include <QCoreApplication>
#include <QPainter>

#include <array>
#include <cmath>
#include <numeric>

namespace trex {

namespace {

constexpr double kTraceWidth = 1.6;
constexpr double kDotRadius = 1.8;
constexpr int kColumnAlpha = 210; ///< columns cover each other; the curve behind shows through
/// Up to so many samples a column they are joined by a line; above, columns show their extremes.
constexpr double kMostJoined = 2.5;
constexpr double kLabelSpacing = 84.0; ///< at least, between two time labels
constexpr double kTickLength = 4.0;

using Pattern = std::array<double, 4>; ///< pixels drawn and left out, in turn
constexpr std::array<Pattern, 4> kPatterns{Pattern{1.0, 0.0, 0.0, 0.0}, Pattern{7.0, 4.0, 7.0, 4.0},
                                           Pattern{2.0, 3.0, 2.0, 3.0},
                                           Pattern{9.0, 3.0, 2.0, 3.0}};
constexpr double kLongestDashed = 20'000.0;

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

const std::array<double, 4>& dashPattern(PlotFrame::Dash dash)
{
    return kPatterns.at(static_cast<std::size_t>(dash));
}

QString valueText(double physical, int decimals, const QString& unit)
{
    // A rounded nought has no sign.
    const double step = std::pow(10.0, -decimals);
    const double shown = std::abs(physical) < step / 2 ? 0.0 : physical;
    QString text = QString::number(shown, 'f', decimals);
    text.replace(u'-', QStringLiteral("−"));
    return unit.isEmpty() ? text : text + u' ' + unit;
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
    for (const auto* curves : {&m_frame.references, &m_frame.curves}) {
        for (const PlotFrame::Curve& curve : *curves) {
            if (curve.isVisible && !curve.series->isEmpty()) {
                paintCurve(*painter, curve, pixelRatio);
            }
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
        painter.drawLine(QPointF(x, area.top()),
                         QPointF(x, area.bottom() + (m_frame.showsTimes ? kTickLength : 0.0)));
        if (k < 0.0 || !m_frame.showsTimes) {
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
    const Instant from = m_frame.from - curve.shift;
    const auto [begin, end] = curve.series->range(from, from + m_frame.span);
    const double columns = m_frame.area.width() * pixelRatio;
    m_lines.clear();
    if (static_cast<double>(end - begin) <= kMostJoined * columns) {
        paintSamples(painter, curve, begin, end);
    } else {
        paintColumns(painter, curve, pixelRatio);
    }
}

double PlotTrace::xOf(const PlotFrame::Curve& curve, std::size_t sample) const
{
    return m_frame.xOf(curve.series->time(sample) + curve.shift);
}

double PlotTrace::yOf(const PlotFrame::Curve& curve, int stored) const
{
    return m_frame.yOf(curve.scale.physical(stored));
}

/// What of the line lies in the plot: not every paint engine clips (SVG's does not).
void PlotTrace::addClipped(const QLineF& line)
{
    const QRectF& area = m_frame.area;
    const QPointF p1 = line.p1();
    const QPointF p2 = line.p2();
    if (area.contains(p1) && area.contains(p2)) {
        m_lines.append(line);
        return;
    }
    double first = 0.0; // parts of the line, after Liang and Barsky
    double last = 1.0;
    const auto cut = [&](double step, double room) {
        if (step == 0.0) {
            return room >= 0.0;
        }
        const double part = room / step;
        if (step < 0.0) {
            first = std::max(first, part);
        } else {
            last = std::min(last, part);
        }
        return first <= last;
    };
    if (cut(-line.dx(), p1.x() - area.left()) && cut(line.dx(), area.right() - p1.x())
        && cut(-line.dy(), p1.y() - area.top()) && cut(line.dy(), area.bottom() - p1.y())) {
        m_lines.append(QLineF(line.pointAt(first), line.pointAt(last)));
    }
}

/// Adds a line, or its dashes. Qt draws dashed lines ten times as slowly as solid ones, so that the
/// dashes are made here.
void PlotTrace::addLine(const QPointF& from, const QPointF& to, PlotFrame::Dash dash)
{
    const QLineF line(from, to);
    if (from == to) {
        return; // its caps would be a dot
    }
    const auto& pattern = dashPattern(dash);
    const double length = line.length();
    if (dash == PlotFrame::Dash::Solid) {
        const bool goesOn = !m_lines.isEmpty() && m_lines.last().p2() == from
            && m_lines.last().y1() == to.y() && from.y() == to.y();
        if (goesOn && m_frame.area.contains(to)) {
            m_lines.last().setP2(to); // level stretches are one line: no caps within
        } else {
            addClipped(line);
        }
        return;
    }
    const double period = std::accumulate(pattern.begin(), pattern.end(), 0.0);
    if (length > kLongestDashed) { // a jump far outside: nobody sees its dashes
        addClipped(line);
        return;
    }
    for (double done = 0.0; done < length;) {
        double place = std::fmod(m_dashPlace, period);
        std::size_t part = 0;
        while (part + 1 < pattern.size() && place >= pattern.at(part)) {
            place -= pattern.at(part++);
        }
        const double step = std::min(std::max(pattern.at(part) - place, 0.01), length - done);
        if (part % 2 == 0) {
            addClipped(QLineF(line.pointAt(done / length), line.pointAt((done + step) / length)));
        }
        done += step;
        m_dashPlace += step;
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
    QList<QPointF> lonely; ///< samples with nothing known on either side
    std::optional<QPointF> previous;
    bool isJoined = false;
    m_dashPlace = 0.0;
    const auto endRun = [&] {
        if (previous && !isJoined && m_frame.area.contains(*previous)) {
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
            const QPointF point(xOf(curve, i), yOf(curve, series.value(i)));
            if (previous) {
                addLine(*previous, point, curve.dash);
                isJoined = true;
            }
            previous = point;
        }
    }
    endRun();
    painter.setRenderHint(QPainter::Antialiasing, true);
    // Lines by themselves with square caps: Qt has a short way for these, a polyline takes ten
    // times as long.
    const bool isSolid = curve.dash == PlotFrame::Dash::Solid;
    painter.setPen(
        QPen(curve.colour, curve.width, Qt::SolidLine, isSolid ? Qt::SquareCap : Qt::FlatCap));
    painter.drawLines(m_lines);
    painter.setPen(Qt::NoPen);
    painter.setBrush(curve.colour);
    const double radius = kDotRadius * std::max(curve.width / kTraceWidth, 1.0);
    for (const QPointF& point : lonely) {
        painter.drawEllipse(point, radius, radius);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void PlotTrace::paintColumns(QPainter& painter, const PlotFrame::Curve& curve, double pixelRatio)
{
    // Columns stand on multiples of their width in time, so that a sliding trace keeps its shape.
    const auto count = static_cast<int>(m_frame.area.width() * pixelRatio) + 2;
    const Duration width = std::max<Duration>(m_frame.span / (count - 2), TimeAxis::kTick);
    const Duration sinceEpoch = (m_frame.from - curve.shift).time_since_epoch();
    const Instant from(sinceEpoch - sinceEpoch % width);
    const TimeSeries& series = *curve.series;
    series.columns({from, width, count}, m_columns);

    const double pixel = 1.0 / pixelRatio;
    const double left = m_frame.xOf(from + curve.shift) + pixel / 2;
    const double half = curve.width / 2;
    const auto add = [&](const QPointF& top, const QPointF& bottom) {
        addClipped(QLineF(top, bottom));
    };
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
        const bool isJoined = previous != nullptr && series.isValid(previous->end - 1)
            && series.isValid(column.begin)
            && !series.axis().hasGapBetween(previous->end - 1, column.begin);
        if (isJoined && previousIndex + 1 == i) { // the bars of neighbours touch
            bar.low = std::min(bar.low, previous->extent.high);
            bar.high = std::max(bar.high, previous->extent.low);
        } else if (isJoined) {
            add({left + double(previousIndex) * pixel, yOf(curve, series.value(previous->end - 1))},
                {left + double(i) * pixel, yOf(curve, series.value(column.begin))});
        }
        const double x = left + double(i) * pixel;
        add({x, yOf(curve, bar.high) - half}, {x, yOf(curve, bar.low) + half});
        previous = &column;
        previousIndex = i;
    }
    QColor colour = curve.colour;
    colour.setAlpha(colour.alpha() * kColumnAlpha / 255);
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
