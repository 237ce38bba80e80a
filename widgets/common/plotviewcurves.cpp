// SPDX-License-Identifier: GPL-3.0-or-later
// The part of PlotView that keeps what is drawn: curves, limits, references, the trigger's level.
#include "protocol/telemetry/plotreferences.h"
#include "protocol/telemetry/streamtable.h"
#include "widgets/common/plotinput.h"
#include "widgets/common/plotoverlay.h"
#include "widgets/common/plottrace.h"
#include "widgets/common/plotview.h"

#include <QChart>
#include <QCoreApplication>
#include <QLegend>
#include <QLineSeries>
#include <QValueAxis>

#include <array>

namespace trex {

namespace {

constexpr int kReferenceAlpha = 150;
constexpr double kReferenceWidth = 0.8; ///< of its curve's

/// Runs are told apart by their dashes: the first, the second, the third and so on.
PlotFrame::Dash dashOf(std::size_t run)
{
    constexpr std::array kDashes{PlotFrame::Dash::Dashed, PlotFrame::Dash::Dotted,
                                 PlotFrame::Dash::DashDotted};
    return kDashes.at(run % kDashes.size());
}

} // namespace

int PlotView::addCurve(std::string_view streamKey, ColourRole colour)
{
    const int index = streamIndex(streamKey);
    const StreamRow& row = streams()[static_cast<std::size_t>(index)];
    // The legend asks for a series; ours stays empty, the trace draws the samples.
    auto* marker = new QLineSeries(chart());
    marker->setName(QCoreApplication::translate("Streams", row.title));
    chart()->addSeries(marker);
    marker->attachAxis(m_timeAxis);
    marker->attachAxis(m_valueAxis);
    PlotFrame::Curve curve;
    curve.series = &m_timeline->store().series(index);
    curve.stream = index;
    curve.scale = {row.scale, row.offset};
    curve.unit = QString::fromUtf8(row.unit.data(), static_cast<qsizetype>(row.unit.size()));
    curve.decimals = row.decimals;
    m_frame->curves.push_back(curve);
    m_colours.push_back(colour);
    applyColours();
    return static_cast<int>(m_frame->curves.size()) - 1;
}

void PlotView::removeCurve(int curve)
{
    QAbstractSeries* marker = chart()->series().at(curve);
    chart()->removeSeries(marker);
    marker->deleteLater();
    m_frame->curves.erase(m_frame->curves.begin() + curve);
    m_colours.erase(m_colours.begin() + curve);
    redraw();
}

void PlotView::setCurveScale(int curve, double scale)
{
    m_frame->curves.at(static_cast<std::size_t>(curve)).scale.scale = scale;
    redraw();
}

void PlotView::setCurveVisible(int curve, bool visible)
{
    m_frame->curves.at(static_cast<std::size_t>(curve)).isVisible = visible;
    chart()->series().at(curve)->setVisible(visible);
    redraw();
}

bool PlotView::isCurveVisible(int curve) const
{
    return m_frame->curves.at(static_cast<std::size_t>(curve)).isVisible;
}

void PlotView::setCurveColour(int curve, ColourRole colour)
{
    m_colours.at(static_cast<std::size_t>(curve)) = colour;
    applyColours();
}

void PlotView::setCurveWidth(int curve, double pixels)
{
    m_frame->curves.at(static_cast<std::size_t>(curve)).width = pixels;
    redraw();
}

void PlotView::setUnit(const QString& unit)
{
    m_unit = unit;
    applyValueAxis();
}

void PlotView::setSmallestTop(double physical)
{
    setFoot(ticks::AxisRange::Foot::Zero, physical);
}

void PlotView::setFoot(ticks::AxisRange::Foot foot, double smallest)
{
    m_range = ticks::AxisRange(smallest, foot);
    fitValues(true);
    redraw();
}

void PlotView::setLimits(const std::vector<Limit>& limits)
{
    m_limits = limits;
    m_frame->limits.clear();
    for (const Limit& limit : m_limits) {
        m_frame->limits.push_back({limit.physical, limit.text, theme::colour(limit.colour)});
    }
    redraw();
}

void PlotView::setReferences(const PlotReferences* references)
{
    m_references = references;
    if (references != nullptr) {
        connect(references, &PlotReferences::changed, this, &PlotView::redraw);
        connect(references, &PlotReferences::moved, this, &PlotView::redraw);
        connect(references, &QObject::destroyed, this, [this] { m_references = nullptr; });
    }
    redraw();
}

void PlotView::fillReferences()
{
    m_frame->references.clear();
    m_frame->runs.clear();
    if (m_references == nullptr) {
        return;
    }
    const auto& runs = m_references->runs();
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto shift =
            runs[i].isVisible ? m_references->shiftOf(runs[i]) : std::optional<Duration>();
        if (!shift) {
            continue;
        }
        m_frame->runs.push_back({runs[i].name, dashOf(i)});
        for (const PlotFrame::Curve& own : m_frame->curves) {
            if (!own.isVisible) {
                continue;
            }
            PlotFrame::Curve curve = own;
            curve.series = &runs[i].store->series(own.stream);
            curve.shift = *shift;
            curve.dash = dashOf(i);
            curve.width = own.width * kReferenceWidth;
            curve.colour.setAlpha(kReferenceAlpha);
            if (runs[i].amperesPerCount > 0.0 && own.unit == u'A') {
                curve.scale.scale = runs[i].amperesPerCount;
            }
            m_frame->references.push_back(curve);
        }
    }
}

/// Lowest and highest physical value in sight, references too; the first above the second: none.
PlotTimeline::ValueRange PlotView::valueExtent() const
{
    PlotTimeline::ValueRange all{1.0, 0.0};
    for (const auto* curves : {&m_frame->curves, &m_frame->references}) {
        for (const PlotFrame::Curve& curve : *curves) {
            if (!curve.isVisible) {
                continue;
            }
            const Instant from = m_frame->from - curve.shift;
            const auto [begin, end] = curve.series->range(from, from + m_frame->span);
            const Extent extent = curve.series->extent(begin, end);
            if (extent.isEmpty()) {
                continue;
            }
            const double low = curve.scale.physical(extent.low);
            const double high = curve.scale.physical(extent.high);
            const bool isFirst = all.first > all.second;
            all.first = isFirst ? low : std::min(all.first, low);
            all.second = isFirst ? high : std::max(all.second, high);
        }
    }
    return all;
}

void PlotView::setTrigger(std::optional<double> level, std::optional<Instant> crossing)
{
    if (m_frame->level != level || m_frame->crossing != crossing) {
        m_frame->level = level;
        m_frame->crossing = crossing;
        redraw();
    }
}

bool PlotView::areValuesByHand() const
{
    return m_timeline->values(m_number).has_value();
}

double PlotView::top() const
{
    return m_frame->high;
}

double PlotView::bottom() const
{
    return m_frame->low;
}

QImage PlotView::picture(double scale)
{
    redraw();
    QImage image(size() * scale, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(theme::colour(ColourRole::Panel));
    QPainter painter(&image);
    render(&painter, QRectF(QPointF(), QSizeF(size())), viewport()->rect());
    return image;
}

} // namespace trex
