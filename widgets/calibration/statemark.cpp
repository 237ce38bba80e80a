// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibration/statemark.h"

#include <QPainter>

#include <algorithm>
#include <utility>

namespace trex {
namespace {

constexpr int kShape = 12;
constexpr int kGap = 6;

} // namespace

StateMark::StateMark(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
}

void StateMark::setState(StateShape shape, const QString& text)
{
    if (m_shape == shape && m_text == text) {
        return;
    }
    m_shape = shape;
    m_text = text;
    setAccessibleDescription(text);
    updateGeometry();
    update();
}

void StateMark::setLeastWidth(int width)
{
    if (std::exchange(m_least, width) != width) {
        updateGeometry();
    }
}

QSize StateMark::sizeHint() const
{
    const QFontMetrics metrics = fontMetrics();
    return {std::max(m_least, kShape + kGap + metrics.horizontalAdvance(m_text) + 2),
            std::max(kShape, metrics.height()) + 2};
}

void StateMark::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF shape(1.0, (height() - kShape) / 2.0, kShape, kShape);
    drawStateShape(painter, shape, m_shape);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(kShape + kGap, 0, 0, 0), Qt::AlignVCenter, m_text);
}

} // namespace trex
