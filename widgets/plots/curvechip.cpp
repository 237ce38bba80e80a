// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/curvechip.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>

namespace trex {

namespace {

constexpr int kSwatch = 16;
constexpr int kGap = 5;
constexpr int kPadding = 6;
constexpr int kHeight = 20;
constexpr double kDraggedOpacity = 0.85;

} // namespace

CurveChip::CurveChip(QWidget* parent) : QToolButton(parent)
{
    setCheckable(true);
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void CurveChip::setCurve(const CurveSpec& curve)
{
    m_curve = curve;
    const int index = streamIndex(curve.key.toStdString());
    m_title = index < 0 ? curve.key : titleOf(streams()[static_cast<std::size_t>(index)]);
    setChecked(curve.isVisible);
    setAccessibleName(m_title);
    setToolTip(m_title + u'\n'
               + tr("Click to show or hide, drag to another plot, right button for colour, width "
                    "and more"));
    updateGeometry();
    update();
}

void CurveChip::setValue(const QString& value)
{
    if (m_value == value) {
        return;
    }
    m_value = value;
    if (value.size() > m_widest.size()) {
        m_widest = value;
        updateGeometry();
    }
    setAccessibleDescription(value);
    update();
}

QSize CurveChip::sizeHint() const
{
    const QFontMetrics name(theme::font(1.0));
    const QFontMetrics number(theme::font(1.0, true));
    const int value = m_widest.isEmpty() ? 0 : kGap + number.horizontalAdvance(m_widest);
    return {2 * kPadding + kSwatch + kGap + name.horizontalAdvance(m_title) + value + 2,
            std::max(kHeight, name.height() + 4)};
}

QSize CurveChip::minimumSizeHint() const
{
    constexpr int kLetters = 24;
    return {2 * kPadding + kSwatch + kGap + kLetters, sizeHint().height()};
}

void CurveChip::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse() || hasFocus()) {
        painter.setPen(hasFocus() ? QPen(theme::colour(ColourRole::Accent), 1.5) : QPen(Qt::NoPen));
        painter.setBrush(theme::colour(ColourRole::Grid));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    }
    paintTo(painter);
}

void CurveChip::paintTo(QPainter& painter) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    const bool isShown = m_curve.isVisible;
    const double middle = box.center().y();
    const QColor colour = theme::colour(m_curve.colour);
    painter.setPen(isShown ? QPen(colour, m_curve.width + 1.4, Qt::SolidLine, Qt::RoundCap)
                           : QPen(theme::colour(ColourRole::Stale), 1.0, Qt::DotLine));
    painter.drawLine(QPointF(kPadding + 1, middle), QPointF(kPadding + kSwatch - 1, middle));
    // Where there is little room the value goes first, then the end of the name.
    QFont font = theme::font(1.0);
    font.setStrikeOut(!isShown);
    const QFont digits = theme::font(1.0, true);
    const QFontMetricsF metrics(font);
    const QRectF room = box.adjusted(kPadding + kSwatch + kGap, 0, -kPadding, 0);
    const double value = kGap + QFontMetricsF(digits).horizontalAdvance(m_widest);
    const bool showsValue = isShown && !m_value.isEmpty()
        && metrics.horizontalAdvance(m_title) + value <= room.width() + 2.0;
    painter.setFont(font);
    painter.setPen(theme::colour(isShown ? ColourRole::Text : ColourRole::Stale));
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(m_title, Qt::ElideRight, room.width() + 2.0));
    if (showsValue) {
        painter.setFont(digits);
        painter.setPen(colour);
        painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, m_value);
    }
}

void CurveChip::mousePressEvent(QMouseEvent* event)
{
    m_pressed = event->pos();
    QToolButton::mousePressEvent(event);
}

void CurveChip::mouseMoveEvent(QMouseEvent* event)
{
    const bool isFar =
        (event->pos() - m_pressed).manhattanLength() >= QApplication::startDragDistance();
    if (m_dragged == nullptr && event->buttons().testFlag(Qt::LeftButton) && isFar) {
        m_dragged = new QLabel(this, Qt::ToolTip | Qt::WindowTransparentForInput);
        m_dragged->setPixmap(grab());
        m_dragged->setWindowOpacity(kDraggedOpacity);
        m_dragged->show();
        setDown(false); // no click when it is let go
    }
    if (m_dragged == nullptr) {
        QToolButton::mouseMoveEvent(event);
        return;
    }
    const QPoint global = event->globalPosition().toPoint();
    m_dragged->move(global - m_pressed);
    emit draggedTo(global);
}

void CurveChip::mouseReleaseEvent(QMouseEvent* event)
{
    if (m_dragged == nullptr) {
        QToolButton::mouseReleaseEvent(event);
        return;
    }
    m_dragged->deleteLater();
    m_dragged = nullptr;
    emit droppedAt(event->globalPosition().toPoint());
}

void CurveChip::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) {
        emit removalRequested();
        return;
    }
    QToolButton::keyPressEvent(event);
}

void CurveChip::contextMenuEvent(QContextMenuEvent* event)
{
    emit menuRequested(event->reason() == QContextMenuEvent::Keyboard
                           ? mapToGlobal(rect().bottomLeft())
                           : event->globalPos());
}

} // namespace trex
