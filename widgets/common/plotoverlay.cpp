// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/plotoverlay.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace trex {

namespace {

constexpr double kSign = 15.0; ///< side of a mark's sign
constexpr double kSignTop = 2.0; ///< below the upper edge of the area
constexpr double kReach = 5.0; ///< a line can be taken hold of this far beside it
constexpr double kTagPadding = 4.0;
constexpr double kStrip = 20.0; ///< below the area, as PlotTrace::kLabelStrip

} // namespace

void PlotOverlay::setFrame(const PlotFrame& frame)
{
    if (frame.area != m_frame.area) {
        prepareGeometryChange();
    }
    m_frame = frame;
    update();
}

QRectF PlotOverlay::boundingRect() const
{
    return m_frame.area.adjusted(-kSign, -1.0, kSign, kStrip);
}

void PlotOverlay::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*)
{
    if (m_frame.area.isEmpty()) {
        return;
    }
    painter->save();
    painter->setFont(m_frame.font);
    painter->setClipRect(boundingRect());
    paintLimits(*painter);
    paintRuns(*painter);
    paintMarks(*painter);
    paintLevel(*painter);
    paintCursors(*painter);
    painter->restore();
}

void PlotOverlay::paintTag(QPainter& painter, const QRectF& rect, const QString& text,
                           const QColor& ink, const QColor& fill) const
{
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawRoundedRect(rect, 3.0, 3.0);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(ink);
    painter.drawText(rect, Qt::AlignCenter, text);
}

void PlotOverlay::paintLimits(QPainter& painter) const
{
    const QRectF& area = m_frame.area;
    const QFontMetricsF metrics(m_frame.font);
    const auto isInSight = [&](const PlotFrame::Limit& limit) {
        return limit.physical >= m_frame.low && limit.physical <= m_frame.high;
    };
    for (const PlotFrame::Limit& limit : m_frame.limits) {
        if (isInSight(limit)) {
            const double y = std::round(m_frame.yOf(limit.physical));
            QPen pen(limit.colour, 1.2, Qt::CustomDashLine);
            pen.setDashPattern({8.0, 4.0});
            painter.setPen(pen);
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        }
    }
    QColor fill = m_frame.colours.panel;
    fill.setAlpha(225);
    double left = area.left() + 8.0;
    for (const PlotFrame::Limit& limit : m_frame.limits) { // names over all lines
        if (!isInSight(limit)) {
            continue;
        }
        const double y = std::round(m_frame.yOf(limit.physical));
        const double width = metrics.horizontalAdvance(limit.text) + 2 * kTagPadding;
        const double height = metrics.height();
        // Above its line, unless the sky is too low; one limit's name beside the other's.
        const double top = y - height - 1.0 < area.top() ? y + 1.0 : y - height - 1.0;
        paintTag(painter, QRectF(left, top, width, height), limit.text, limit.colour, fill);
        left += width + 8.0;
    }
}

/// The runs that are compared with, by their dashes, at the top right of the topmost plot.
void PlotOverlay::paintRuns(QPainter& painter) const
{
    if (!m_frame.showsMarkSigns) {
        return;
    }
    constexpr double kLine = 30.0;
    const QFontMetricsF metrics(m_frame.font);
    const double height = metrics.height() + 2.0;
    double top = m_frame.area.top() + kSignTop + kSign + 4.0;
    QColor fill = m_frame.colours.panel;
    fill.setAlpha(225);
    for (const PlotFrame::Run& run : m_frame.runs) {
        const QString text = metrics.elidedText(run.name, Qt::ElideRight, m_frame.area.width() / 2);
        const double width = metrics.horizontalAdvance(text) + kLine + 4 * kTagPadding;
        const QRectF box(m_frame.area.right() - width - 4.0, top, width, height);
        paintTag(painter, box, {}, m_frame.colours.text, fill);
        QPen pen(m_frame.colours.text, 1.6, Qt::CustomDashLine, Qt::FlatCap);
        const auto& pattern = dashPattern(run.dash);
        QList<qreal> dashes;
        for (const double length : pattern) {
            dashes.append(length / pen.widthF());
        }
        pen.setDashPattern(dashes);
        painter.setPen(pen);
        const double y = std::round(box.center().y());
        painter.drawLine(QPointF(box.left() + kTagPadding, y),
                         QPointF(box.left() + kTagPadding + kLine, y));
        painter.setPen(m_frame.colours.text);
        painter.drawText(box.adjusted(0, 0, -kTagPadding, 0), Qt::AlignRight | Qt::AlignVCenter,
                         text);
        top += height + 1.0;
    }
}

QColor PlotOverlay::colourOf(MarkWeight weight) const
{
    switch (weight) {
    case MarkWeight::Quiet:
        return m_frame.colours.dim;
    case MarkWeight::Action:
        return m_frame.colours.action;
    case MarkWeight::Warning:
        return m_frame.colours.warning;
    case MarkWeight::Fault:
        return m_frame.colours.fault;
    }
    return m_frame.colours.dim;
}

QRectF PlotOverlay::signAt(double x) const
{
    return {x - kSign / 2, m_frame.area.top() + kSignTop, kSign, kSign};
}

std::vector<PlotOverlay::Group> PlotOverlay::groups() const
{
    std::vector<Group> found;
    if (m_frame.marks == nullptr) {
        return found;
    }
    const std::vector<Mark>& marks = m_frame.marks->marks();
    const std::size_t end = m_frame.marks->lowerBound(m_frame.from + m_frame.span);
    for (std::size_t i = m_frame.marks->lowerBound(m_frame.from); i < end;) {
        Group group{i, i, m_frame.xOf(marks[i].time), marks[i].kind};
        // Straight to the first mark that has room for a sign of its own.
        const Instant next = m_frame.timeAt(group.x + kSign + 1.0);
        group.end = std::clamp(m_frame.marks->lowerBound(next), i + 1, end);
        constexpr std::size_t kMostLookedAt = 64;
        for (std::size_t k = i; k < std::min(group.end, i + kMostLookedAt); ++k) {
            if (markRow(marks[k].kind).weight > markRow(group.kind).weight) {
                group.kind = marks[k].kind;
            }
        }
        i = group.end;
        found.push_back(group);
    }
    return found;
}

/// Each weight has a shape of its own: circle, square, triangle, octagon.
void PlotOverlay::paintSign(QPainter& painter, const Group& group) const
{
    const MarkRow& row = markRow(group.kind);
    const QColor colour = colourOf(row.weight);
    const QRectF rect = signAt(group.x);
    QPainterPath path;
    switch (row.weight) {
    case MarkWeight::Quiet:
        path.addEllipse(rect.adjusted(0.5, 0.5, -0.5, -0.5));
        break;
    case MarkWeight::Action:
        path.addRoundedRect(rect.adjusted(0.5, 0.5, -0.5, -0.5), 2.0, 2.0);
        break;
    case MarkWeight::Warning:
        path.moveTo(rect.center().x(), rect.top() - 1.0);
        path.lineTo(rect.right() + 1.0, rect.bottom());
        path.lineTo(rect.left() - 1.0, rect.bottom());
        path.closeSubpath();
        break;
    case MarkWeight::Fault: {
        const double cut = rect.width() * 0.29;
        path.addPolygon(QPolygonF{{rect.left() + cut, rect.top()},
                                  {rect.right() - cut, rect.top()},
                                  {rect.right(), rect.top() + cut},
                                  {rect.right(), rect.bottom() - cut},
                                  {rect.right() - cut, rect.bottom()},
                                  {rect.left() + cut, rect.bottom()},
                                  {rect.left(), rect.bottom() - cut},
                                  {rect.left(), rect.top() + cut}});
        path.closeSubpath();
        break;
    }
    }
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPath(path);
    painter.setRenderHint(QPainter::Antialiasing, false);
    QFont font = m_frame.font;
    font.setBold(true);
    font.setPixelSize(row.weight == MarkWeight::Warning ? 9 : 10);
    painter.setFont(font);
    painter.setPen(m_frame.colours.panel);
    const QString sign = group.end - group.begin > 1
        ? QString::number(std::min<std::size_t>(group.end - group.begin, 99))
        : QString::fromUtf8(row.sign);
    painter.drawText(row.weight == MarkWeight::Warning ? rect.adjusted(0, 4, 0, 1) : rect,
                     Qt::AlignCenter, sign);
    painter.setFont(m_frame.font);
}

void PlotOverlay::paintMarks(QPainter& painter) const
{
    const QRectF& area = m_frame.area;
    for (const Group& group : groups()) {
        const double x = std::round(group.x);
        QColor colour = colourOf(markRow(group.kind).weight);
        colour.setAlpha(130);
        QPen pen(colour, 1.0, Qt::CustomDashLine);
        pen.setDashPattern({2.0, 3.0});
        painter.setPen(pen);
        const double top = area.top() + (m_frame.showsMarkSigns ? kSignTop + kSign : 0.0);
        painter.drawLine(QPointF(x, top), QPointF(x, area.bottom()));
        if (m_frame.showsMarkSigns) {
            paintSign(painter, group);
        }
    }
    if (m_frame.shownMark && m_frame.showsMarkSigns) {
        const double x = m_frame.xOf(*m_frame.shownMark);
        if (x >= area.left() && x <= area.right()) {
            painter.setRenderHint(QPainter::Antialiasing, true);
            painter.setPen(QPen(m_frame.colours.accent, 2.0));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(signAt(x).adjusted(-2.5, -2.5, 2.5, 2.5));
            painter.setRenderHint(QPainter::Antialiasing, false);
        }
    }
}

void PlotOverlay::paintLevel(QPainter& painter) const
{
    if (!m_frame.level) {
        return;
    }
    const QRectF& area = m_frame.area;
    const double y = std::clamp(std::round(m_frame.yOf(*m_frame.level)), area.top(), area.bottom());
    QPen pen(m_frame.colours.accent, 1.0, Qt::CustomDashLine);
    pen.setDashPattern({3.0, 3.0});
    painter.setPen(pen);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setRenderHint(QPainter::Antialiasing, true);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_frame.colours.accent);
    // A handle at the right edge, and an arrow where it was crossed.
    painter.drawPolygon(
        QPolygonF{{area.right() + 1, y}, {area.right() + 9, y - 5}, {area.right() + 9, y + 5}});
    if (m_frame.crossing) {
        const double x = m_frame.xOf(*m_frame.crossing);
        if (x >= area.left() && x <= area.right()) {
            painter.drawPolygon(QPolygonF{
                {x, area.bottom() - 1}, {x - 5, area.bottom() + 7}, {x + 5, area.bottom() + 7}});
            painter.setPen(QPen(m_frame.colours.accent, 1.5));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(QPointF(x, y), 4.0, 4.0);
        }
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

std::optional<int> PlotOverlay::cursorAt(const QPointF& position) const
{
    std::optional<int> nearest;
    double best = kReach;
    for (std::size_t i = 0; i < m_frame.cursors.size(); ++i) {
        if (!m_frame.cursors[i]) {
            continue;
        }
        const double distance = std::abs(m_frame.xOf(*m_frame.cursors[i]) - position.x());
        const bool isPreferred =
            nearest && distance == best && static_cast<int>(i) == m_frame.activeCursor;
        if (distance < best || isPreferred || (!nearest && distance <= best)) {
            best = distance;
            nearest = static_cast<int>(i);
        }
    }
    const QRectF reach = m_frame.area.adjusted(-kReach, 0.0, kReach, kStrip);
    return reach.contains(position) ? nearest : std::nullopt;
}

bool PlotOverlay::isLevelAt(const QPointF& position) const
{
    return m_frame.level && std::abs(m_frame.yOf(*m_frame.level) - position.y()) <= kReach
        && m_frame.area.adjusted(0.0, -kReach, 12.0, kReach).contains(position);
}

std::pair<std::size_t, std::size_t> PlotOverlay::marksAt(const QPointF& position) const
{
    if (m_frame.showsMarkSigns) {
        for (const Group& group : groups()) {
            if (signAt(group.x).adjusted(-1, -2, 1, 2).contains(position)) {
                return {group.begin, group.end};
            }
        }
    }
    return {0, 0};
}

} // namespace trex
