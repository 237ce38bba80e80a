// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/telemetrystore.h"

#include <QColor>
#include <QFont>
#include <QGraphicsItem>

namespace trex {

/// What one frame of a plot shows: a part of time by a part of values, in a rectangle.
struct PlotFrame {
    struct Curve {
        const TimeSeries* series = nullptr;
        QColor colour;
        double scale = 1.0; ///< physical = (stored + offset) × scale
        int offset = 0;
        bool isVisible = true;
    };
    struct Colours {
        QColor grid;
        QColor text;
        QColor stale;
        QColor accent;
    };
    QRectF area; ///< of the plot, in scene coordinates
    Instant from;
    Duration span{std::chrono::seconds(10)};
    Instant origin; ///< second 0 of the time axis
    double low = 0.0; ///< physical values at the lower and upper edge
    double high = 1.0;
    std::optional<Instant> staleFrom; ///< nothing is known from here to the right edge
    QString message; ///< said in the middle of the plot, instead of a trace that is not there
    QRectF rubberBand; ///< box zoom in progress
    Colours colours;
    QFont font;
    std::vector<Curve> curves;

    [[nodiscard]] double xOf(Instant time) const;
    [[nodiscard]] double yOf(double physical) const;
    [[nodiscard]] Instant timeAt(double x) const;
    [[nodiscard]] double physicalAt(double y) const;
};

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

    PlotFrame m_frame;
    std::vector<PlotColumn> m_columns; ///< kept for its memory only
    QList<QLineF> m_lines;
};

} // namespace trex
