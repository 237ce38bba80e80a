// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/health/latencyview.h"

#include "widgets/common/theme.h"

#include <QHelpEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <cmath>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double kGap = 4.0;
constexpr double kLabelStep = 0.85; ///< of the body font
constexpr std::array<double, 13> kTicksMs{0.1,  0.2,  0.5,   1.0,   2.0,   5.0,   10.0,
                                          20.0, 50.0, 100.0, 200.0, 500.0, 1000.0};

double msOf(Duration duration)
{
    return std::chrono::duration<double, std::milli>(duration).count();
}

QString msText(double ms)
{
    const int decimals = ms < 9.95 ? 1 : 0;
    return QString::number(ms, 'f', decimals);
}

} // namespace

/// Where bins and counts lie in the widget.
struct LatencyView::Scale {
    QRectF area;
    int first = 0; ///< bins shown
    int last = 0;
    double decades = 1.0; ///< of the counts

    [[nodiscard]] double x(Duration duration) const
    {
        const double from = std::log2(msOf(LatencyHistogram::edge(first)));
        const double to = std::log2(msOf(LatencyHistogram::edge(last + 1)));
        const double at = std::log2(std::max(msOf(duration), 1e-3));
        return area.left() + area.width() * std::clamp((at - from) / (to - from), 0.0, 1.0);
    }
    /// A single answer has a height of its own; none has none.
    [[nodiscard]] double y(double count) const
    {
        const double part = count < 1.0 ? 0.0 : (std::log10(count) + 0.3) / (decades + 0.3);
        return area.bottom() - area.height() * part;
    }
};

LatencyView::LatencyView(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("How long answers took"));
    setFocusPolicy(Qt::TabFocus); // its description is read there
}

void LatencyView::show(const HealthCounts& counts)
{
    m_trips = counts.trips;
    m_wire = counts.ideal;
    const auto text = [](const std::optional<Duration>& value) {
        return value ? msText(msOf(*value)) : u"–"_s;
    };
    setAccessibleDescription(
        tr("%1 answers: half within %2 ms, 99 of 100 within %3 ms, the longest %4 ms; the wire "
           "alone %5 ms.")
            .arg(m_trips.total())
            .arg(text(m_trips.quantile(0.5)), text(m_trips.quantile(0.99)),
                 text(m_trips.quantile(1.0)), text(m_wire.quantile(0.5))));
    update();
}

double LatencyView::medianMs() const
{
    const auto median = m_trips.quantile(0.5);
    return median ? msOf(*median) : 0.0;
}

LatencyView::Scale LatencyView::scale() const
{
    const QFontMetricsF metrics(theme::font(kLabelStep, true));
    Scale scale;
    const double left = metrics.horizontalAdvance(u"10000"_s) + kGap;
    // Above: the legend, and three rows of marks; below: the ticks' labels.
    const double top = 4.0 * metrics.height() + 2.0 * kGap;
    scale.area = QRectF(rect()).adjusted(left, top, -2.0 * kGap, -metrics.height() - kGap);
    int first = LatencyHistogram::kBins;
    int last = 0;
    quint32 most = 10;
    for (int bin = 0; bin < LatencyHistogram::kBins; ++bin) {
        const quint32 count = std::max(m_trips.count(bin), m_wire.count(bin));
        if (count > 0) {
            first = std::min(first, bin);
            last = bin;
            most = std::max(most, count);
        }
    }
    if (first > last) { // nothing yet: what 19200 baud answers lie within
        first = LatencyHistogram::binOf(std::chrono::milliseconds(1));
        last = LatencyHistogram::binOf(std::chrono::milliseconds(30));
    }
    // Whole doublings, and room at the sides: the axis seldom moves.
    constexpr int kOctave = LatencyHistogram::kPerOctave;
    first = std::max(first / kOctave * kOctave - (first % kOctave < 2 ? kOctave : 0), 0);
    last = std::max(last / kOctave * kOctave + kOctave - 1, first + 4 * kOctave - 1);
    last += last % kOctave > kOctave - 2 ? kOctave : 0;
    scale.first = first;
    scale.last = std::min(last, LatencyHistogram::kBins - 1);
    scale.decades = std::ceil(std::log10(static_cast<double>(most)));
    return scale;
}

void LatencyView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(theme::font(kLabelStep, true));
    const Scale where = scale();
    if (m_trips.total() == 0) {
        painter.setPen(theme::colour(ColourRole::DimText));
        painter.setFont(theme::font(1.0));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("No answers yet. Connect, and every answer is counted here."));
        return;
    }
    paintAxes(painter, where);
    paintBars(painter, where);
    paintWire(painter, where);
    paintMarks(painter, where);
    paintLegend(painter, where);
}

void LatencyView::paintAxes(QPainter& painter, const Scale& scale) const
{
    const QFontMetricsF metrics(painter.font());
    const QColor grid = theme::colour(ColourRole::Grid);
    const QColor dim = theme::colour(ColourRole::DimText);
    const QRectF& area = scale.area;
    const double from = msOf(LatencyHistogram::edge(scale.first));
    const double to = msOf(LatencyHistogram::edge(scale.last + 1));
    for (int decade = 0; decade <= static_cast<int>(scale.decades); ++decade) {
        const double y = scale.y(std::pow(10.0, decade));
        painter.setPen(grid);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(dim);
        painter.drawText(
            QRectF(0, y - metrics.height() / 2.0, area.left() - kGap, metrics.height()),
            Qt::AlignRight | Qt::AlignVCenter, QString::number(std::pow(10.0, decade), 'f', 0));
    }
    const QString unit = tr("ms");
    const double baseline = area.bottom() + kGap / 2.0 + metrics.ascent();
    const double unitLeft = width() - metrics.horizontalAdvance(unit);
    painter.setPen(dim);
    painter.drawText(QPointF(unitLeft, baseline), unit);
    double lastRight = 0.0;
    for (const double tick : kTicksMs) {
        if (tick < from || tick > to) {
            continue;
        }
        const double x = scale.x(
            std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>(tick)));
        painter.setPen(grid);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        const QString label = QString::number(tick);
        const double extent = metrics.horizontalAdvance(label);
        const double left = x - extent / 2.0;
        if (left > lastRight + kGap && left + extent < unitLeft - kGap) {
            painter.setPen(dim);
            painter.drawText(QPointF(left, baseline), label);
            lastRight = left + extent;
        }
    }
    painter.setPen(theme::colour(ColourRole::Border));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
}

void LatencyView::paintBars(QPainter& painter, const Scale& scale) const
{
    const QColor colour = theme::colour(ColourRole::Motor1);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    for (int bin = scale.first; bin <= scale.last; ++bin) {
        if (m_trips.count(bin) > 0) {
            const double left = scale.x(LatencyHistogram::edge(bin));
            const double right = scale.x(LatencyHistogram::edge(bin + 1));
            const double top = scale.y(m_trips.count(bin));
            painter.drawRect(
                QRectF(QPointF(left + 0.5, top),
                       QPointF(std::max(right - 0.5, left + 1.5), scale.area.bottom())));
        }
    }
    painter.setBrush(Qt::NoBrush);
}

void LatencyView::paintWire(QPainter& painter, const Scale& scale) const
{
    QPainterPath path(QPointF(scale.area.left(), scale.area.bottom()));
    for (int bin = scale.first; bin <= scale.last; ++bin) {
        const double y = scale.y(m_wire.count(bin));
        path.lineTo(scale.x(LatencyHistogram::edge(bin)), y);
        path.lineTo(scale.x(LatencyHistogram::edge(bin + 1)), y);
    }
    path.lineTo(scale.area.bottomRight());
    painter.setPen(QPen(theme::colour(ColourRole::Motor2), 1.5));
    painter.drawPath(path);
}

void LatencyView::paintMarks(QPainter& painter, const Scale& scale) const
{
    struct Mark {
        QString text;
        std::optional<Duration> at;
        Qt::PenStyle style;
    };
    const std::array marks{
        Mark{tr("half within %1 ms"), m_trips.quantile(0.5), Qt::SolidLine},
        Mark{tr("99 % within %1 ms"), m_trips.quantile(0.99), Qt::DashLine},
        Mark{tr("longest %1 ms"), m_trips.longest(), Qt::DotLine},
    };
    const QFontMetricsF metrics(painter.font());
    const QColor text = theme::colour(ColourRole::Text);
    double row = metrics.height() + kGap;
    for (const Mark& mark : marks) {
        const double x = scale.x(*mark.at);
        painter.setPen(QPen(text, 1.0, mark.style));
        painter.drawLine(QPointF(x, row + 2.0), QPointF(x, scale.area.bottom()));
        const QString label = QString(mark.text).replace(u"%1"_s, msText(msOf(*mark.at)));
        const double width = metrics.horizontalAdvance(label);
        const double left = x + kGap + width < this->width() ? x + kGap : x - kGap - width;
        painter.fillRect(QRectF(left - 1.0, row, width + 2.0, metrics.height()),
                         theme::colour(ColourRole::Panel)); // other marks' lines pass behind it
        painter.drawText(QPointF(left, row + metrics.ascent()), label);
        row += metrics.height();
    }
}

void LatencyView::paintLegend(QPainter& painter, const Scale& scale) const
{
    const QFontMetricsF metrics(painter.font());
    const double middle = metrics.height() / 2.0;
    double x = scale.area.left();
    painter.fillRect(QRectF(x, middle - 4, 10, 8), theme::colour(ColourRole::Motor1));
    x += 10 + kGap;
    const QString measured = tr("answers");
    painter.setPen(theme::colour(ColourRole::Text));
    painter.drawText(QPointF(x, metrics.ascent()), measured);
    x += metrics.horizontalAdvance(measured) + 4.0 * kGap;
    painter.setPen(QPen(theme::colour(ColourRole::Motor2), 1.5));
    painter.drawLine(QPointF(x, middle), QPointF(x + 14, middle));
    x += 14 + kGap;
    painter.setPen(theme::colour(ColourRole::Text));
    painter.drawText(QPointF(x, metrics.ascent()), tr("wire alone"));
}

bool LatencyView::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip) {
        return QWidget::event(event);
    }
    const auto* help = static_cast<QHelpEvent*>(event);
    const Scale where = scale();
    for (int bin = where.first; bin <= where.last; ++bin) {
        const double left = where.x(LatencyHistogram::edge(bin));
        const double right = where.x(LatencyHistogram::edge(bin + 1));
        if (help->pos().x() >= left && help->pos().x() < right) {
            QToolTip::showText(help->globalPos(),
                               tr("%1 to %2 ms: %3 answers; the wire alone: %4")
                                   .arg(msOf(LatencyHistogram::edge(bin)), 0, 'f', 2)
                                   .arg(msOf(LatencyHistogram::edge(bin + 1)), 0, 'f', 2)
                                   .arg(m_trips.count(bin))
                                   .arg(m_wire.count(bin)),
                               this);
            return true;
        }
    }
    QToolTip::hideText();
    return true;
}

} // namespace trex
