// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/marktrack.h"
#include "widgets/common/plotframe.h"

#include <QGraphicsItem>

namespace trex {

/// Draws what lies over the traces of a plot: limits, marks of events, cursors with the curves'
/// values, the trigger's level; a private part of PlotView. Its cost grows with the width of the
/// plot, never with the number of marks.
class PlotOverlay : public QGraphicsItem {
public:
    explicit PlotOverlay(QGraphicsItem* parent) : QGraphicsItem(parent) { }

    void setFrame(const PlotFrame& frame); ///< repaints
    [[nodiscard]] QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

    // What the pointer is at, in scene coordinates.
    [[nodiscard]] std::optional<int> cursorAt(const QPointF& position) const;
    [[nodiscard]] bool isLevelAt(const QPointF& position) const;
    /// The marks whose sign is there; first and one past the last index.
    [[nodiscard]] std::pair<std::size_t, std::size_t> marksAt(const QPointF& position) const;

private:
    /// Marks too close to each other to be told apart share one sign.
    struct Group {
        std::size_t begin = 0;
        std::size_t end = 0;
        double x = 0.0;
        MarkKind kind = MarkKind::Note; ///< the weightiest
    };
    [[nodiscard]] std::vector<Group> groups() const;
    [[nodiscard]] QColor colourOf(MarkWeight weight) const;
    [[nodiscard]] QRectF signAt(double x) const;
    void paintRuns(QPainter& painter) const;
    void paintLimits(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintSign(QPainter& painter, const Group& group) const;
    void paintLevel(QPainter& painter) const;
    void paintCursors(QPainter& painter) const;
    void paintCursor(QPainter& painter, int index, double x) const;
    void paintValues(QPainter& painter, Instant time, double x, bool isLeft) const;
    void paintDistance(QPainter& painter) const;
    void paintTag(QPainter& painter, const QRectF& rect, const QString& text, const QColor& ink,
                  const QColor& fill) const;

    PlotFrame m_frame;
};

} // namespace trex
