// SPDX-License-Identifier: GPL-3.0-or-later
// The part of PlotOverlay that draws the measuring cursors.
#include "widgets/common/plotoverlay.h"
#include "widgets/common/plotticks.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace trex {

namespace {

constexpr double kSign = 15.0; ///< as the signs of the marks: tags may reach so far outside
constexpr double kTagPadding = 4.0;
constexpr double kTagGap = 6.0; ///< between a cursor and its values
constexpr double kStrip = 20.0; ///< below the area, as PlotTrace::kLabelStrip
constexpr double kRoom = 80.0; ///< for a value beside a cursor

double secondsOf(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

/// Of a time as long as this one is exact to be told from its neighbours on the screen.
QString timeText(const PlotFrame& frame, Duration time)
{
    const double pixel = secondsOf(frame.span) / std::max(frame.area.width(), 1.0);
    const double step = pixel < 0.002 ? 0.001 : pixel < 0.02 ? 0.01 : pixel < 0.2 ? 0.1 : 1.0;
    return ticks::timeLabel(std::round(secondsOf(time) / step) * step, step);
}

} // namespace

void PlotOverlay::paintValues(QPainter& painter, Instant time, double x, bool isLeft) const
{
    struct Tag {
        double dot;
        double top;
        QString text;
        QColor colour;
    };
    const QFontMetricsF metrics(m_frame.font);
    const QRectF& area = m_frame.area;
    std::vector<Tag> tags;
    for (const PlotFrame::Curve& curve : m_frame.curves) {
        const auto sample =
            curve.isVisible ? sampleAt(*curve.series, time) : std::optional<std::size_t>();
        if (!sample) {
            continue;
        }
        const double physical = curve.scale.physical(curve.series->value(*sample));
        const double y = m_frame.yOf(physical);
        if (y >= area.top() - 1.0 && y <= area.bottom() + 1.0) {
            tags.push_back({y, y - metrics.height() / 2,
                            valueText(physical, curve.decimals, curve.unit), curve.colour});
        }
    }
    std::sort(tags.begin(), tags.end(), [](const Tag& a, const Tag& b) { return a.dot < b.dot; });
    const double height = metrics.height();
    for (std::size_t i = 1; i < tags.size(); ++i) { // none over another
        tags[i].top = std::max(tags[i].top, tags[i - 1].top + height + 1.0);
    }
    double floor = area.bottom() - 1.0;
    for (std::size_t i = tags.size(); i-- > 0;) {
        tags[i].top = std::min(tags[i].top, floor - height);
        floor = tags[i].top - 1.0;
    }
    QColor fill = m_frame.colours.panel;
    fill.setAlpha(225);
    for (const Tag& tag : tags) {
        painter.setRenderHint(QPainter::Antialiasing, true);
        painter.setPen(QPen(m_frame.colours.panel, 1.5));
        painter.setBrush(tag.colour);
        painter.drawEllipse(QPointF(x, tag.dot), 4.0, 4.0);
        const double width = metrics.horizontalAdvance(tag.text) + 2 * kTagPadding;
        const double left = isLeft ? x - kTagGap - width : x + kTagGap;
        paintTag(painter, QRectF(left, tag.top, width, height), tag.text, tag.colour, fill);
    }
}

void PlotOverlay::paintCursor(QPainter& painter, int index, double x) const
{
    const QRectF& area = m_frame.area;
    const bool isActive = index == m_frame.activeCursor;
    const QColor colour = m_frame.colours.text;
    painter.setPen(QPen(colour, isActive ? 1.6 : 1.0));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    if (!m_frame.showsCursorTimes) {
        return;
    }
    const QFontMetricsF metrics(m_frame.font);
    const Instant time = *m_frame.cursors.at(static_cast<std::size_t>(index));
    const QString text = QStringLiteral("%1  %2")
                             .arg(index == 0 ? QStringLiteral("A") : QStringLiteral("B"))
                             .arg(timeText(m_frame, time - m_frame.origin));
    const double width = metrics.horizontalAdvance(text) + 2 * kTagPadding;
    const double left =
        std::clamp(x - width / 2, area.left() - kSign, area.right() + kSign - width);
    const QRectF tag(left, area.bottom() + 2.0, width, kStrip - 3.0);
    paintTag(painter, tag, text, isActive ? m_frame.colours.panel : colour,
             isActive ? colour : m_frame.colours.grid);
}

/// "Δ 1.250 s  0.80 Hz" on a line between both cursors, where there is room.
void PlotOverlay::paintDistance(QPainter& painter) const
{
    const Instant first = std::min(*m_frame.cursors.front(), *m_frame.cursors.back());
    const Instant second = std::max(*m_frame.cursors.front(), *m_frame.cursors.back());
    const QRectF& area = m_frame.area;
    const double left = std::max(m_frame.xOf(first), area.left());
    const double right = std::min(m_frame.xOf(second), area.right());
    if (right <= left) {
        return;
    }
    QColor shade = m_frame.colours.accent;
    shade.setAlpha(18);
    painter.fillRect(QRectF(left, area.top(), right - left, area.height()), shade);
    if (!m_frame.showsCursorTimes) {
        return;
    }
    const double seconds = secondsOf(second - first);
    constexpr double kLong = 120.0;
    const QString text = seconds < kLong
        ? QStringLiteral("Δ %1 s").arg(seconds, 0, 'f', seconds < 10.0 ? 3 : 2)
        : QStringLiteral("Δ %1").arg(ticks::timeLabel(seconds, 1.0));
    const QFontMetricsF metrics(m_frame.font);
    const double width = metrics.horizontalAdvance(text) + 2 * kTagPadding;
    if (width + 24.0 > right - left) {
        return;
    }
    const double y = area.bottom() - metrics.height() - 2.0;
    painter.setPen(QPen(m_frame.colours.dim, 1.0));
    painter.drawLine(QPointF(left + 1, y), QPointF(right - 1, y));
    for (const double end : {left, right}) {
        const double inward = end == left ? 5.0 : -5.0;
        painter.drawLine(QPointF(end, y), QPointF(end + inward, y - 3));
        painter.drawLine(QPointF(end, y), QPointF(end + inward, y + 3));
    }
    paintTag(painter,
             QRectF((left + right - width) / 2, y - metrics.height() / 2, width, metrics.height()),
             text, m_frame.colours.text, m_frame.colours.panel);
}

void PlotOverlay::paintCursors(QPainter& painter) const
{
    const auto inSight = [this](const std::optional<Instant>& cursor) {
        const double x = cursor ? m_frame.xOf(*cursor) : -1.0;
        return cursor && x >= m_frame.area.left() - 0.5 && x <= m_frame.area.right() + 0.5;
    };
    const bool areBoth = m_frame.cursors.size() == 2 && m_frame.cursors[0] && m_frame.cursors[1];
    if (areBoth) {
        paintDistance(painter);
    }
    for (std::size_t i = 0; i < m_frame.cursors.size(); ++i) {
        if (!inSight(m_frame.cursors[i])) {
            continue;
        }
        const double x = std::round(m_frame.xOf(*m_frame.cursors[i]));
        paintCursor(painter, static_cast<int>(i), x);
        const auto& other = m_frame.cursors[1 - i];
        const bool isLeft = (areBoth && *m_frame.cursors[i] < *other)
            || (!areBoth && x > m_frame.area.center().x());
        const bool hasRoom =
            isLeft ? x - m_frame.area.left() > kRoom : m_frame.area.right() - x > kRoom;
        paintValues(painter, *m_frame.cursors[i], x, hasRoom == isLeft);
    }
}

} // namespace trex
