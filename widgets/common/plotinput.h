// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/plotview.h"

class QGestureEvent;
class QHelpEvent;
class QKeyEvent;
class QMouseEvent;
class QNativeGestureEvent;
class QWheelEvent;

namespace trex {

/// What mouse, wheel, fingers and keys do in a plot; a private part of PlotView. Wheel zooms time
/// about the pointer (Ctrl: values); dragging zooms into a box, or pans with the middle button,
/// Shift or the Pan tool; cursors and the trigger's level are dragged by their lines; double click
/// follows again. Keys do all of it: help().
class PlotInput {
public:
    explicit PlotInput(PlotView& view);
    Q_DISABLE_COPY_MOVE(PlotInput)

    void setTool(PlotView::Tool tool) { m_tool = tool; }
    [[nodiscard]] bool handle(QEvent* event); ///< the viewport's; true: nothing more to do
    [[nodiscard]] bool pressKey(const QKeyEvent& event); ///< true: it was for the plot
    [[nodiscard]] static QString help(); ///< the keys, in a sentence or two

private:
    enum class Drag { None, Box, Pan, Cursor, Level };
    bool wheel(const QWheelEvent& event);
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    bool gesture(QGestureEvent& event);
    bool nativeGesture(const QNativeGestureEvent& event);
    bool toolTip(const QHelpEvent& event);
    void pinch(double factor, const QPointF& scene);
    void showPointer(const QPointF& scene);
    [[nodiscard]] bool pressPanKey(const QKeyEvent& event);
    [[nodiscard]] bool pressCursorKey(const QKeyEvent& event);
    void placeCursor(int index);
    void stepCursor(double pixels);
    [[nodiscard]] QPointF inScene(const QPointF& position) const;
    [[nodiscard]] PlotTimeline& timeline() const { return m_view.timeline(); }

    PlotView& m_view;
    PlotView::Tool m_tool = PlotView::Tool::Zoom;
    Drag m_drag = Drag::None;
    QPointF m_from; ///< of the drag, in the scene
    int m_cursor = 0; ///< that is dragged
};

} // namespace trex
