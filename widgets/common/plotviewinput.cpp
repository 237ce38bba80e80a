// SPDX-License-Identifier: GPL-3.0-or-later
// The part of PlotView that answers mouse, wheel and keys.
#include "widgets/common/plotview.h"

#include "widgets/common/plottrace.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace trex {

using namespace std::chrono_literals;

namespace {

constexpr double kZoomStep = 0.8; ///< a wheel notch or a key press
constexpr double kPanStep = 0.1; ///< of what is visible, an arrow key
constexpr double kSmallestBox = 8.0; ///< pixels; a smaller drag was a click
constexpr Duration kShortestSpan = 20ms;
constexpr Duration kLongestSpan = std::chrono::hours(24 * 400);
constexpr double kSmallestValueSpan = 0.02;
constexpr double kLargestValueSpan = 1e6;

Duration scaled(Duration duration, double factor)
{
    return std::chrono::duration_cast<Duration>(
        std::chrono::duration<double, std::nano>(static_cast<double>(duration.count()) * factor));
}

} // namespace

void PlotView::stand(Instant from, Duration span)
{
    m_frame->from = from;
    m_frame->span = std::clamp(span, kShortestSpan, kLongestSpan);
    const bool wasPaused = std::exchange(m_paused, true);
    fitValues(true);
    redraw();
    if (!wasPaused) {
        emit pausedChanged(true);
    }
    emit viewChanged();
}

void PlotView::zoomTime(double factor, double about)
{
    place();
    const Duration span = std::clamp(scaled(m_frame->span, factor), kShortestSpan, kLongestSpan);
    const Instant pivot = m_frame->from + scaled(m_frame->span, about);
    stand(pivot - scaled(span, about), span);
}

void PlotView::zoomValues(double factor, double about)
{
    const double span = m_frame->high - m_frame->low;
    const double wanted = std::clamp(span * factor, kSmallestValueSpan, kLargestValueSpan);
    const double pivot = m_frame->low + about * span;
    m_valuesByHand = true;
    m_frame->low = pivot - about * wanted;
    m_frame->high = m_frame->low + wanted;
    applyValueAxis();
    redraw();
    emit viewChanged();
}

void PlotView::pan(double timePart, double valuePart)
{
    if (valuePart != 0.0) {
        const double shift = (m_frame->high - m_frame->low) * valuePart;
        m_valuesByHand = true;
        m_frame->low += shift;
        m_frame->high += shift;
        applyValueAxis();
    }
    if (timePart != 0.0) {
        place();
        stand(m_frame->from + scaled(m_frame->span, timePart), m_frame->span);
    } else {
        redraw();
        emit viewChanged();
    }
}

void PlotView::fit()
{
    m_valuesByHand = false;
    const Instant right = rightEdge();
    const Instant from = m_store.start().value_or(right);
    stand(from, std::max<Duration>(right - from, 1s));
}

void PlotView::follow()
{
    m_valuesByHand = false;
    setPaused(false);
    place();
    fitValues(true);
    redraw();
    emit viewChanged();
}

void PlotView::showStart()
{
    place();
    stand(m_store.start().value_or(m_frame->from), m_frame->span);
}

void PlotView::zoomInto(const QRectF& box)
{
    if (box.height() >= kSmallestBox) {
        const double high = m_frame->physicalAt(box.top());
        const double low = m_frame->physicalAt(box.bottom());
        m_valuesByHand = true;
        m_frame->low = low;
        m_frame->high = std::max(high, low + kSmallestValueSpan);
        applyValueAxis();
    }
    if (box.width() >= kSmallestBox) {
        const Instant from = m_frame->timeAt(box.left());
        stand(from, m_frame->timeAt(box.right()) - from);
    } else {
        redraw();
        emit viewChanged();
    }
}

QPointF PlotView::inScene(const QPointF& position) const
{
    return mapToScene(position.toPoint());
}

void PlotView::wheelEvent(QWheelEvent* event)
{
    const QRectF& area = m_frame->area;
    const int delta =
        event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
    if (delta == 0 || area.isEmpty()) {
        event->ignore();
        return;
    }
    constexpr double kNotch = 120.0; // an eighth of a degree times 15 degrees
    const double factor = std::pow(kZoomStep, delta / kNotch);
    const QPointF at = inScene(event->position());
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        zoomValues(factor, std::clamp((area.bottom() - at.y()) / area.height(), 0.0, 1.0));
    } else {
        zoomTime(factor, std::clamp((at.x() - area.left()) / area.width(), 0.0, 1.0));
    }
    event->accept();
}

bool PlotView::panByKey(const QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_Left:
        pan(-kPanStep, 0.0);
        return true;
    case Qt::Key_Right:
        pan(kPanStep, 0.0);
        return true;
    case Qt::Key_Up:
        pan(0.0, kPanStep);
        return true;
    case Qt::Key_Down:
        pan(0.0, -kPanStep);
        return true;
    case Qt::Key_Home:
        showStart();
        return true;
    case Qt::Key_End:
        follow();
        return true;
    default:
        return false;
    }
}

void PlotView::keyPressEvent(QKeyEvent* event)
{
    const bool byValues = event->modifiers().testFlag(Qt::ControlModifier);
    const auto zoom = [&](double factor) { byValues ? zoomValues(factor) : zoomTime(factor); };
    if (panByKey(*event)) {
        return;
    }
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoom(kZoomStep);
        break;
    case Qt::Key_Minus:
        zoom(1.0 / kZoomStep);
        break;
    case Qt::Key_F:
        fit();
        break;
    case Qt::Key_P:
        setPaused(!m_paused);
        break;
    default:
        QChartView::keyPressEvent(event); // Escape must reach the stop action
    }
}

void PlotView::mousePressEvent(QMouseEvent* event)
{
    const bool isPan = event->button() == Qt::MiddleButton
        || (event->button() == Qt::LeftButton && event->modifiers().testFlag(Qt::ShiftModifier));
    m_dragFrom = inScene(event->position());
    if (isPan) {
        m_drag = Drag::Pan;
        viewport()->setCursor(Qt::ClosedHandCursor);
    } else if (event->button() == Qt::LeftButton && m_frame->area.contains(m_dragFrom)) {
        m_drag = Drag::Box;
    }
    event->accept();
}

void PlotView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF at = inScene(event->position());
    const QRectF& area = m_frame->area;
    if (m_drag == Drag::Pan) {
        const QPointF moved = at - std::exchange(m_dragFrom, at);
        // Values that fit themselves stay fitted: a hand is never quite level.
        pan(-moved.x() / area.width(), m_valuesByHand ? moved.y() / area.height() : 0.0);
    } else if (m_drag == Drag::Box) {
        QRectF box = QRectF(m_dragFrom, at).normalized().intersected(area);
        if (box.height() < kSmallestBox) { // a flat drag means a part of time, at full height
            box.setTop(area.top());
            box.setBottom(area.bottom());
        }
        m_frame->rubberBand = box;
        redraw();
    }
}

void PlotView::mouseReleaseEvent(QMouseEvent* event)
{
    const Drag drag = std::exchange(m_drag, Drag::None);
    viewport()->unsetCursor();
    m_frame->rubberBand = {};
    if (drag == Drag::Box) {
        const QRectF box = QRectF(m_dragFrom, inScene(event->position())).normalized();
        const QRectF inside = box.intersected(m_frame->area);
        if (inside.width() >= kSmallestBox || inside.height() >= kSmallestBox) {
            zoomInto(inside);
        } else {
            redraw();
        }
    }
}

void PlotView::mouseDoubleClickEvent(QMouseEvent* event)
{
    follow();
    event->accept();
}

} // namespace trex
