// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/plotbars.h"

#include <QPaintEngine>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace trex {

namespace {

constexpr int kBlock = 16; ///< columns that are filled at once: a length that compilers unroll
constexpr int kMostColumns = 16'384;
/// A pixel of a line costs as much as so many of a row.
constexpr std::int64_t kLineCost = 3;

bool isUpright(const QLineF& line)
{
    return line.x1() == line.x2();
}

bool canBeRaster(const QPainter& painter)
{
    const QPaintEngine* engine = painter.paintEngine();
    return engine != nullptr && engine->type() == QPaintEngine::Raster
        && painter.deviceTransform().type() <= QTransform::TxScale && painter.opacity() == 1.0
        && painter.compositionMode() == QPainter::CompositionMode_SourceOver;
}

void drawLines(QPainter& painter, const QList<QLineF>& lines, const QColor& colour)
{
    QPen pen(colour, 1.0);
    pen.setCosmetic(true);
    pen.setCapStyle(Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLines(lines);
}

} // namespace

void PlotBars::draw(QPainter& painter, const QList<QLineF>& lines, const QColor& colour)
{
    if (!canBeRaster(painter) || !collect(painter, lines)) {
        drawLines(painter, lines, colour);
        return;
    }
    fill(qPremultiply(colour.rgba()));
    const QTransform back = painter.deviceTransform().inverted();
    const QRectF target =
        back.mapRect(QRectF(m_raster.left, m_raster.top, m_raster.columns, m_raster.rows));
    painter.drawImage(target, m_image, QRectF(0.0, 0.0, m_raster.columns, m_raster.rows));
    drawLines(painter, m_others, colour);
}

/// False when lines are quicker, or there are none.
bool PlotBars::collect(const QPainter& painter, const QList<QLineF>& lines)
{
    m_others.clear();
    const QTransform transform = painter.deviceTransform();
    double left = 0.0;
    double right = 0.0;
    double top = 0.0;
    double bottom = 0.0;
    std::int64_t pixels = 0;
    bool isFirst = true;
    for (const QLineF& line : lines) {
        if (!isUpright(line)) {
            m_others.append(line);
            continue;
        }
        const double low = std::min(line.y1(), line.y2());
        const double high = std::max(line.y1(), line.y2());
        left = isFirst ? line.x1() : std::min(left, line.x1());
        right = isFirst ? line.x1() : std::max(right, line.x1());
        top = isFirst ? low : std::min(top, low);
        bottom = isFirst ? high : std::max(bottom, high);
        pixels += static_cast<std::int64_t>((high - low) * transform.m22()) + 1;
        isFirst = false;
    }
    if (isFirst) {
        return false;
    }
    // All bars have the same fraction of a pixel: rounded once, so that none falls on another.
    const double originX = transform.map(QPointF(left, top)).x();
    const double originY = transform.map(QPointF(left, top)).y();
    m_raster.left = static_cast<int>(std::floor(originX));
    m_raster.top = static_cast<int>(std::lround(originY));
    m_raster.columns = static_cast<int>(std::lround((right - left) * transform.m11())) + 1;
    m_raster.rows = static_cast<int>(std::lround((bottom - top) * transform.m22())) + 1;
    const auto box = static_cast<std::int64_t>(m_raster.columns) * m_raster.rows;
    if (m_raster.columns > kMostColumns || pixels * kLineCost < box) {
        return false;
    }
    const auto padded = static_cast<std::size_t>((m_raster.columns + kBlock - 1) / kBlock * kBlock);
    m_tops.assign(padded, m_raster.rows);
    m_bottoms.assign(padded, 0);
    for (const QLineF& line : lines) {
        if (isUpright(line)) {
            const double low = std::min(line.y1(), line.y2());
            const double high = std::max(line.y1(), line.y2());
            const auto column =
                static_cast<std::size_t>(std::lround((line.x1() - left) * transform.m11()));
            const auto first = static_cast<int>(std::lround((low - top) * transform.m22()));
            const auto last = static_cast<int>(std::lround((high - top) * transform.m22()));
            m_tops[column] = std::min(m_tops[column], first);
            m_bottoms[column] = std::max(m_bottoms[column], std::max(last, first + 1));
        }
    }
    return true;
}

void PlotBars::fill(std::uint32_t pixel)
{
    const auto padded = static_cast<int>(m_tops.size());
    if (m_image.width() < padded || m_image.height() < m_raster.rows) {
        m_image =
            QImage(std::max(padded, m_image.width()), std::max(m_raster.rows, m_image.height()),
                   QImage::Format_ARGB32_Premultiplied);
    }
    for (int row = 0; row < m_raster.rows; ++row) {
        auto* out = reinterpret_cast<std::uint32_t*>(m_image.scanLine(row));
        for (int block = 0; block < padded; block += kBlock) {
            const std::int32_t* const tops = m_tops.data() + block;
            const std::int32_t* const bottoms = m_bottoms.data() + block;
            for (int i = 0; i < kBlock; ++i) { // no branch: eight at once on any processor
                const bool isInside = static_cast<bool>(static_cast<int>(tops[i] <= row)
                                                        & static_cast<int>(row < bottoms[i]));
                out[block + i] = isInside ? pixel : 0U;
            }
        }
    }
}

} // namespace trex
