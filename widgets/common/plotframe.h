// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/measurement.h"
#include "widgets/common/theme.h"

#include <QFont>
#include <QRectF>

#include <array>
#include <vector>

namespace trex {

class MarkTrack;

/// What one frame of a plot shows: a part of time by a part of values, in a rectangle. Filled by
/// PlotView, drawn by PlotTrace and PlotOverlay.
struct PlotFrame {
    /// How a line is told from others beside its colour.
    enum class Dash : std::uint8_t { Solid, Dashed, Dotted, DashDotted };
    struct Curve {
        const TimeSeries* series = nullptr;
        int stream = 0; ///< index into streams()
        QColor colour;
        ValueScale scale;
        double width = 1.6;
        bool isVisible = true;
        Dash dash = Dash::Solid;
        Duration shift{0}; ///< of a reference: drawn so much later than it was
        QString unit;
        int decimals = 0; ///< of the values beside a cursor
    };
    /// A dashed line across the plot with its name: a limit that was read.
    struct Limit {
        double physical = 0.0;
        QString text;
        QColor colour;
    };
    /// A run that is compared with, for the legend.
    struct Run {
        QString name;
        Dash dash = Dash::Dashed;
    };
    struct Colours {
        QColor panel;
        QColor grid;
        QColor text;
        QColor dim;
        QColor stale;
        QColor accent;
        QColor action;
        QColor warning;
        QColor fault;
    };
    QRectF area; ///< of the plot, in scene coordinates
    Instant from;
    Duration span{std::chrono::seconds(10)};
    Instant origin; ///< second 0 of the time axis
    double low = 0.0; ///< physical values at the lower and upper edge
    double high = 1.0;
    bool showsTimes = true; ///< labels at the time axis; in a stack only the lowest has them
    bool showsMarkSigns = true; ///< in a stack only the topmost has them; the lines all have
    bool showsCursorTimes = true;
    std::optional<Instant> staleFrom; ///< nothing is known from here to the right edge
    QString message; ///< said in the middle of the plot, instead of a trace that is not there
    QRectF rubberBand; ///< box zoom in progress
    Colours colours;
    QFont font;
    std::vector<Curve> curves;
    std::vector<Curve> references; ///< behind the curves
    std::vector<Run> runs; ///< whose curves the references are
    std::vector<Limit> limits;
    const MarkTrack* marks = nullptr;
    std::optional<Instant> shownMark; ///< jumped to: it is pointed out
    std::vector<std::optional<Instant>> cursors;
    int activeCursor = 0;
    std::optional<double> level; ///< the trigger's, where its source is drawn here
    std::optional<Instant> crossing; ///< the trigger's latest

    [[nodiscard]] double xOf(Instant time) const;
    [[nodiscard]] double yOf(double physical) const;
    [[nodiscard]] Instant timeAt(double x) const;
    [[nodiscard]] double physicalAt(double y) const;
};

/// Lengths drawn and left out, in turn, in pixels.
[[nodiscard]] const std::array<double, 4>& dashPattern(PlotFrame::Dash dash);

/// "2.20 A": a physical value with its decimals and unit.
[[nodiscard]] QString valueText(double physical, int decimals, const QString& unit);

} // namespace trex
