// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/plotinput.h"

#include "protocol/telemetry/marktrack.h"
#include "widgets/common/plotoverlay.h"

#include <QCoreApplication>
#include <QGestureEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>

namespace trex {

namespace {

constexpr double kZoomStep = 0.8; ///< a wheel notch or a key press
constexpr double kPanStep = 0.1; ///< of what is visible, an arrow key
constexpr double kSmallestBox = 8.0; ///< pixels; a smaller drag was a click
constexpr double kFarStep = 10.0; ///< pixels that a cursor goes with Ctrl held

} // namespace

PlotInput::PlotInput(PlotView& view) : m_view(view)
{
    view.viewport()->setMouseTracking(true); // the pointer tells what it could take hold of
    view.viewport()->setAttribute(Qt::WA_AcceptTouchEvents);
    view.viewport()->grabGesture(Qt::PinchGesture);
}

QString PlotInput::help()
{
    return QCoreApplication::translate(
        "PlotView",
        "Arrow keys pan, plus and minus zoom, with Ctrl the values; Home shows the start, End "
        "follows the newest, F shows everything, P pauses. Alt with left and right goes back and "
        "forward through the views. 1 and 2 place the cursors, Shift with left and right moves "
        "one, "
        "Delete removes it. N and Shift N go to the next and the previous event.");
}

QPointF PlotInput::inScene(const QPointF& position) const
{
    return m_view.mapToScene(position.toPoint());
}

bool PlotInput::handle(QEvent* event)
{
    switch (event->type()) {
    case QEvent::Wheel:
        return wheel(*static_cast<QWheelEvent*>(event));
    case QEvent::MouseButtonPress:
        press(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseMove:
        move(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseButtonRelease:
        release(*static_cast<QMouseEvent*>(event));
        return true;
    case QEvent::MouseButtonDblClick:
        m_view.follow();
        return true;
    case QEvent::Gesture:
        return gesture(*static_cast<QGestureEvent*>(event));
    case QEvent::NativeGesture:
        return nativeGesture(*static_cast<QNativeGestureEvent*>(event));
    case QEvent::ToolTip:
        return toolTip(*static_cast<QHelpEvent*>(event));
    default:
        return false;
    }
}

bool PlotInput::wheel(const QWheelEvent& event)
{
    const QRectF& area = m_view.frame().area;
    const int delta = event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
    if (delta == 0 || area.isEmpty()) {
        return false;
    }
    constexpr double kNotch = 120.0; // an eighth of a degree times 15 degrees
    const double factor = std::pow(kZoomStep, delta / kNotch);
    const QPointF at = inScene(event.position());
    if (event.modifiers().testFlag(Qt::ControlModifier)) {
        m_view.zoomValues(factor, std::clamp((area.bottom() - at.y()) / area.height(), 0.0, 1.0));
    } else if (event.modifiers().testFlag(Qt::ShiftModifier)) {
        timeline().pan(-kPanStep * delta / kNotch);
    } else {
        timeline().zoom(factor, std::clamp((at.x() - area.left()) / area.width(), 0.0, 1.0));
    }
    return true;
}

void PlotInput::press(const QMouseEvent& event)
{
    m_from = inScene(event.position());
    if (event.button() == Qt::BackButton) {
        timeline().back();
    } else if (event.button() == Qt::ForwardButton) {
        timeline().forward();
    }
    const bool isLeft = event.button() == Qt::LeftButton;
    const bool isPan = event.button() == Qt::MiddleButton
        || (isLeft
            && (event.modifiers().testFlag(Qt::ShiftModifier) || m_tool == PlotView::Tool::Pan));
    const auto cursor = isLeft ? m_view.overlay().cursorAt(m_from) : std::nullopt;
    if (cursor) {
        m_drag = Drag::Cursor;
        m_cursor = *cursor;
        timeline().setActiveCursor(m_cursor);
    } else if (isLeft && m_view.overlay().isLevelAt(m_from)) {
        m_drag = Drag::Level;
    } else if (isPan) {
        m_drag = Drag::Pan;
        m_view.viewport()->setCursor(Qt::ClosedHandCursor);
    } else if (isLeft && m_view.frame().area.contains(m_from)) {
        m_drag = Drag::Box;
    }
}

void PlotInput::showPointer(const QPointF& scene)
{
    if (m_view.overlay().cursorAt(scene)) {
        m_view.viewport()->setCursor(Qt::SplitHCursor);
    } else if (m_view.overlay().isLevelAt(scene)) {
        m_view.viewport()->setCursor(Qt::SplitVCursor);
    } else if (m_tool == PlotView::Tool::Pan && m_view.frame().area.contains(scene)) {
        m_view.viewport()->setCursor(Qt::OpenHandCursor);
    } else {
        m_view.viewport()->unsetCursor();
    }
}

void PlotInput::move(const QMouseEvent& event)
{
    const QPointF at = inScene(event.position());
    const PlotFrame& frame = m_view.frame();
    const QRectF& area = frame.area;
    switch (m_drag) {
    case Drag::None:
        showPointer(at);
        break;
    case Drag::Pan: {
        const QPointF moved = at - std::exchange(m_from, at);
        // Values that fit themselves stay fitted: a hand is never quite level.
        if (m_view.areValuesByHand() && moved.y() != 0.0) {
            m_view.panValues(moved.y() / area.height());
        }
        timeline().pan(-moved.x() / area.width());
        break;
    }
    case Drag::Box: {
        QRectF box = QRectF(m_from, at).normalized().intersected(area);
        if (box.height() < kSmallestBox) { // a flat drag means a part of time, at full height
            box.setTop(area.top());
            box.setBottom(area.bottom());
        }
        m_view.setRubberBand(box);
        break;
    }
    case Drag::Cursor:
        timeline().setCursor(m_cursor, frame.timeAt(std::clamp(at.x(), area.left(), area.right())));
        break;
    case Drag::Level:
        emit m_view.levelDragged(frame.physicalAt(std::clamp(at.y(), area.top(), area.bottom())));
        break;
    }
}

void PlotInput::release(const QMouseEvent& event)
{
    const Drag drag = std::exchange(m_drag, Drag::None);
    const QPointF at = inScene(event.position());
    if (drag == Drag::Box) {
        m_view.setRubberBand({});
        const QRectF box = QRectF(m_from, at).normalized().intersected(m_view.frame().area);
        if (box.width() >= kSmallestBox || box.height() >= kSmallestBox) {
            m_view.zoomInto(box);
        }
    }
    showPointer(at);
}

void PlotInput::pinch(double factor, const QPointF& scene)
{
    const QRectF& area = m_view.frame().area;
    if (factor > 0.0 && factor != 1.0 && !area.isEmpty()) {
        timeline().zoom(1.0 / factor,
                        std::clamp((scene.x() - area.left()) / area.width(), 0.0, 1.0));
    }
}

bool PlotInput::gesture(QGestureEvent& event)
{
    auto* fingers = dynamic_cast<QPinchGesture*>(event.gesture(Qt::PinchGesture));
    if (fingers == nullptr) {
        return false;
    }
    if (m_drag == Drag::Box) { // the first finger had begun a box
        m_drag = Drag::None;
        m_view.setRubberBand({});
    }
    const QPointF centre = m_view.viewport()->mapFromGlobal(fingers->centerPoint());
    pinch(fingers->scaleFactor(), inScene(centre));
    const double moved = fingers->centerPoint().x() - fingers->lastCenterPoint().x();
    if (moved != 0.0 && fingers->state() == Qt::GestureUpdated) {
        timeline().pan(-moved / m_view.frame().area.width());
    }
    event.accept(fingers);
    return true;
}

bool PlotInput::nativeGesture(const QNativeGestureEvent& event)
{
    if (event.gestureType() != Qt::ZoomNativeGesture) {
        return false;
    }
    pinch(1.0 + event.value(), inScene(event.position()));
    return true;
}

bool PlotInput::toolTip(const QHelpEvent& event)
{
    const auto [begin, end] = m_view.overlay().marksAt(inScene(event.pos()));
    if (begin == end || timeline().marks() == nullptr) {
        QToolTip::hideText();
        return true;
    }
    constexpr std::size_t kMost = 12;
    QStringList lines;
    for (std::size_t i = begin; i < std::min(end, begin + kMost); ++i) {
        const Mark& mark = timeline().marks()->marks()[i];
        const std::chrono::duration<double> since = mark.time - timeline().origin();
        lines +=
            QStringLiteral("%1  %2").arg(ticks::timeLabel(since.count(), 0.001), markText(mark));
    }
    if (end - begin > kMost) {
        lines += QCoreApplication::translate("PlotView", "and %n more", nullptr,
                                             static_cast<int>(end - begin - kMost));
    }
    QToolTip::showText(event.globalPos(), lines.join(u'\n'), m_view.viewport());
    return true;
}

void PlotInput::placeCursor(int index)
{
    timeline().setActiveCursor(index);
    const TimeRange range = timeline().range();
    const auto present = timeline().cursor(index);
    if (!present || *present < range.from || *present > range.to) {
        timeline().setCursor(index, range.from + (range.to - range.from) * (index + 1) / 3);
    }
}

void PlotInput::stepCursor(double pixels)
{
    const int index = timeline().activeCursor();
    const auto present = timeline().cursor(index);
    if (!present) {
        placeCursor(index);
        return;
    }
    const PlotFrame& frame = m_view.frame();
    const Instant next = frame.timeAt(frame.xOf(*present) + pixels);
    timeline().setCursor(index, next);
}

bool PlotInput::pressCursorKey(const QKeyEvent& event)
{
    const bool isFar = event.modifiers().testFlag(Qt::ControlModifier);
    switch (event.key()) {
    case Qt::Key_1:
        placeCursor(0);
        return true;
    case Qt::Key_2:
        if (!timeline().cursor(0)) {
            placeCursor(0);
        }
        placeCursor(1);
        return true;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        timeline().setCursor(timeline().activeCursor(), std::nullopt);
        timeline().setActiveCursor(timeline().cursor(1) ? 1 : 0);
        return true;
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (event.modifiers().testFlag(Qt::ShiftModifier)) {
            const double step = isFar ? kFarStep : 1.0;
            stepCursor(event.key() == Qt::Key_Left ? -step : step);
            return true;
        }
        return false;
    case Qt::Key_N:
        if (event.modifiers().testFlag(Qt::ShiftModifier)) {
            timeline().showPreviousMark();
        } else {
            timeline().showNextMark();
        }
        return true;
    default:
        return false;
    }
}

bool PlotInput::pressPanKey(const QKeyEvent& event)
{
    const bool isAlt = event.modifiers().testFlag(Qt::AltModifier);
    switch (event.key()) {
    case Qt::Key_Left:
        isAlt ? timeline().back() : timeline().pan(-kPanStep);
        return true;
    case Qt::Key_Right:
        isAlt ? timeline().forward() : timeline().pan(kPanStep);
        return true;
    case Qt::Key_Up:
        m_view.panValues(kPanStep);
        return true;
    case Qt::Key_Down:
        m_view.panValues(-kPanStep);
        return true;
    case Qt::Key_Home:
        timeline().showStart();
        return true;
    case Qt::Key_End:
        m_view.follow();
        return true;
    default:
        return false;
    }
}

bool PlotInput::pressKey(const QKeyEvent& event)
{
    if (pressCursorKey(event) || pressPanKey(event)) {
        return true;
    }
    const bool byValues = event.modifiers().testFlag(Qt::ControlModifier);
    const auto zoom = [&](double factor) {
        byValues ? m_view.zoomValues(factor) : timeline().zoom(factor, 0.5);
    };
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoom(kZoomStep);
        return true;
    case Qt::Key_Minus:
        zoom(1.0 / kZoomStep);
        return true;
    case Qt::Key_F:
        m_view.fit();
        return true;
    case Qt::Key_P:
        m_view.setPaused(!m_view.isPaused());
        return true;
    default:
        return false;
    }
}

} // namespace trex
