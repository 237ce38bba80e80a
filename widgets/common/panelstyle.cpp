// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/panelstyle.h"

#include "widgets/common/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QStyleOption>

namespace trex {

PanelStyle::PanelStyle() : QProxyStyle(QStringLiteral("Fusion")) { }

void PanelStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                               QPainter* painter, const QWidget* widget) const
{
    if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck) {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        return;
    }
    const bool isEnabled = option->state.testFlag(State_Enabled);
    const bool hasFocus = option->state.testFlag(State_HasFocus);
    const QColor line = theme::colour(!isEnabled     ? ColourRole::Border
                                          : hasFocus ? ColourRole::Accent
                                                     : ColourRole::DimText);
    const QColor tick = theme::colour(isEnabled ? ColourRole::Text : ColourRole::Stale);
    const QRectF box = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(line, 1.2));
    painter->setBrush(theme::colour(ColourRole::Panel));
    painter->drawRoundedRect(box, 2, 2);
    painter->setPen(QPen(tick, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->setBrush(Qt::NoBrush);
    const auto at = [&box](double x, double y) {
        return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
    };
    if (option->state.testFlag(State_On)) {
        QPainterPath path(at(0.22, 0.52));
        path.lineTo(at(0.43, 0.73));
        path.lineTo(at(0.78, 0.28));
        painter->drawPath(path);
    } else if (option->state.testFlag(State_NoChange)) {
        painter->drawLine(at(0.25, 0.5), at(0.75, 0.5));
    }
    painter->restore();
}

} // namespace trex
