// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametersign.h"

#include "widgets/common/stateshape.h"
#include "widgets/common/theme.h"

#include <QApplication>
#include <QPainter>

namespace trex {
namespace {

using State = ParameterModel::State;

/// Edited: a filled lozenge. Not default: a small dot; default: a small ring. Waits for a power
/// cycle: a broken ring.
void drawOwnShape(QPainter& painter, const QRectF& rect, State state)
{
    const QPointF centre = rect.center();
    const double half = rect.width() / 2.0 - 1.0;
    if (state == State::Edited) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme::colour(ColourRole::Accent));
        painter.drawPolygon(QPolygonF{{centre.x(), centre.y() - half},
                                      {centre.x() + half, centre.y()},
                                      {centre.x(), centre.y() + half},
                                      {centre.x() - half, centre.y()}});
    } else if (state == State::Differs) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme::colour(ColourRole::DimText));
        painter.drawEllipse(centre, 2.5, 2.5);
    } else if (state == State::AtDefault) {
        painter.setPen(QPen(theme::colour(ColourRole::Stale), 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, 2.0, 2.0);
    } else if (state == State::Pending) {
        constexpr int kSixteenths = 16; // QPainter counts angles so
        painter.setPen(QPen(theme::colour(ColourRole::Warning), 1.8));
        painter.setBrush(Qt::NoBrush);
        const QRectF ring(centre.x() - half + 1, centre.y() - half + 1, 2 * half - 2, 2 * half - 2);
        painter.drawArc(ring, 125 * kSixteenths, 290 * kSixteenths);
        painter.drawLine(QPointF(centre.x(), rect.top()), centre);
    }
}

} // namespace

QPixmap parameterSign(State state)
{
    constexpr int kSize = 14;
    const double ratio = qApp->devicePixelRatio();
    QPixmap pixmap(qRound(kSize * ratio), qRound(kSize * ratio));
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF rect(1, 1, kSize - 2, kSize - 2);
    switch (state) {
    case State::Unread:
        drawStateShape(painter, rect, StateShape::Stale);
        break;
    case State::Advised:
        drawStateShape(painter, rect, StateShape::Warning);
        break;
    case State::Refused:
        drawStateShape(painter, rect, StateShape::Fault);
        break;
    case State::AtDefault:
    case State::Differs:
    case State::Pending:
    case State::Edited:
        drawOwnShape(painter, rect, state);
        break;
    }
    return pixmap;
}

QVariant parameterColour(State state, int column)
{
    if (column == ParameterModel::DefaultColumn || column == ParameterModel::RangeColumn
        || column == ParameterModel::SourceColumn) {
        return theme::colour(ColourRole::DimText);
    }
    if (column != ParameterModel::StateColumn) {
        return state == State::Unread && column == ParameterModel::DeviceColumn
            ? QVariant(theme::colour(ColourRole::Stale))
            : QVariant();
    }
    switch (state) {
    case State::Refused:
        return theme::colour(ColourRole::Fault);
    case State::Advised:
    case State::Pending:
        return theme::colour(ColourRole::Warning);
    case State::Edited:
        return theme::colour(ColourRole::Accent);
    case State::AtDefault:
    case State::Unread:
    case State::Differs:
        break;
    }
    return theme::colour(ColourRole::DimText);
}

QFont boldFont()
{
    QFont font = theme::font(1.0);
    font.setBold(true);
    return font;
}

} // namespace trex
