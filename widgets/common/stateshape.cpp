// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/stateshape.h"

#include "widgets/common/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

#include <cmath>
#include <numbers>

namespace trex {

namespace {

QPolygonF octagon(const QRectF& rect)
{
    QPolygonF polygon;
    const double radius = rect.width() / 2.0;
    for (int i = 0; i < 8; ++i) {
        const double angle = (2 * i + 1) * std::numbers::pi / 8.0;
        polygon << rect.center() + QPointF(radius * std::cos(angle), radius * std::sin(angle));
    }
    return polygon;
}

QPolygonF triangle(const QRectF& rect)
{
    return {{QPointF(rect.center().x(), rect.top()), rect.bottomRight(), rect.bottomLeft()}};
}

/// Drawn, not a brush pattern: patterns do not scale with the screen.
void drawHatched(QPainter& painter, const QRectF& rect, const QColor& colour)
{
    QPainterPath disc;
    disc.addEllipse(rect);
    painter.save();
    painter.setClipPath(disc, Qt::IntersectClip);
    painter.setPen(QPen(colour, 1.2));
    const double step = rect.width() / 4.0;
    for (double x = -rect.width(); x < rect.width(); x += step) {
        painter.drawLine(QPointF(rect.left() + x, rect.bottom()),
                         QPointF(rect.left() + x + rect.height(), rect.top()));
    }
    painter.restore();
    painter.setPen(QPen(colour, 1.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(rect);
}

} // namespace

void drawStateShape(QPainter& painter, const QRectF& rect, StateShape shape)
{
    const QRectF inner = rect.adjusted(1, 1, -1, -1);
    painter.save();
    painter.setPen(Qt::NoPen);
    switch (shape) {
    case StateShape::Ok:
        painter.setBrush(theme::colour(ColourRole::Ok));
        painter.drawEllipse(inner);
        break;
    case StateShape::Warning:
        painter.setBrush(theme::colour(ColourRole::Warning));
        painter.drawPolygon(triangle(inner));
        break;
    case StateShape::Fault:
        painter.setBrush(theme::colour(ColourRole::Fault));
        painter.drawPolygon(octagon(rect));
        break;
    case StateShape::Off:
        painter.setPen(QPen(theme::colour(ColourRole::DimText), 1.4));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(inner.adjusted(1, 1, -1, -1));
        break;
    case StateShape::Stale:
        drawHatched(painter, inner, theme::colour(ColourRole::Stale));
        break;
    }
    painter.restore();
}

} // namespace trex
