// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/plotbars.h"
#include "widgets/common/plotframe.h"

#include <QGraphicsItem>

namespace trex {

/// Draws the traces, the moving time axis and the stale region of a plot; a private part of
/// PlotView. Qt Charts rebuilds its own series and axes on each change of range, which costs 5 to
/// 15 ms a frame; this costs 1 to 3 ms at any length of the history (design, plots.md).
class PlotTrace : public QGraphicsItem {
public:
    static constexpr double kLabelStrip = 20.0; ///< below the area, for the time labels

    explicit PlotTrace(QGraphicsItem* parent) : QGraphicsItem(parent) { }

    [[nodiscard]] const PlotFrame& frame() const { return m_frame; }
    void setFrame(const PlotFrame& frame); ///< repaints
    [[nodiscard]] QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    void paintTimeAxis(QPainter& painter) const;
    void paintStale(QPainter& painter) const;
    void paintCurve(QPainter& painter, const PlotFrame::Curve& curve, double pixelRatio);
    void paintSamples(QPainter& painter, const PlotFrame::Curve& curve, std::size_t begin,
                      std::size_t end);
    void paintColumns(QPainter& painter, const PlotFrame::Curve& curve, double pixelRatio);
    void paintMessage(QPainter& painter) const;
    [[nodiscard]] double xOf(const PlotFrame::Curve& curve, std::size_t sample) const;
    [[nodiscard]] double yOf(const PlotFrame::Curve& curve, int stored) const;
    void addLine(const QPointF& from, const QPointF& to, PlotFrame::Dash dash);
    void addClipped(const QLineF& line);

    PlotFrame m_frame;
    std::vector<PlotColumn> m_columns; ///< of the curve that was painted last
    const TimeAxis* m_columnsAxis = nullptr; ///< whose samples they are; none: of an earlier frame
    ColumnGrid m_grid;
    QList<QLineF> m_lines;
    PlotBars m_bars;
    double m_dashPlace = 0.0; ///< along the dashed line that is being made
};

} // namespace trex
