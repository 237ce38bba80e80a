// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QLineF>
#include <QList>

#include <cstdint>
#include <vector>

class QPainter;

namespace trex {

/// Draws the bars of a trace's columns: upright lines of one pixel's width, side by side. On a
/// raster image they are filled row by row, since a column of pixels costs a cache line each, and
/// bars as high as the plot make up most of a frame's time at 10⁶ samples and more. Other devices
/// (SVG, PDF) and short bars get plain lines.
class PlotBars {
public:
    /// Lines that are not upright are drawn as such. Clipped by whoever made them.
    void draw(QPainter& painter, const QList<QLineF>& lines, const QColor& colour);

private:
    struct Raster { ///< where the bars lie, in device pixels
        int left = 0;
        int top = 0;
        int columns = 0;
        int rows = 0;
        double ratio = 1.0; ///< device pixels a unit
    };
    [[nodiscard]] bool collect(const QPainter& painter, const QList<QLineF>& lines);
    void fill(std::uint32_t pixel);

    Raster m_raster;
    QImage m_image;
    std::vector<std::int32_t> m_tops; ///< of each column, rows of the image; bottoms are excluded
    std::vector<std::int32_t> m_bottoms;
    QList<QLineF> m_others;
};

} // namespace trex
