// SPDX-License-Identifier: GPL-3.0-or-later
// Which curves stand in which plot, and how: what the Plots panel remembers.
#pragma once

#include "protocol/telemetry/streamtable.h"
#include "widgets/common/theme.h"

#include <QByteArray>
#include <QString>

#include <span>
#include <vector>

namespace trex {

struct CurveSpec {
    QString key; ///< of streamtable.h
    ColourRole colour = ColourRole::Motor1;
    double width = 1.6; ///< pixels
    bool isVisible = true;
    bool operator==(const CurveSpec&) const = default;
};

struct PlotSpec {
    std::vector<CurveSpec> curves;
    int height = 100; ///< its share of the stack
    bool operator==(const PlotSpec&) const = default;
};
using PlotLayout = std::vector<PlotSpec>;

/// The colours that a curve can have; each works on light and dark.
struct CurveColourRow {
    ColourRole role;
    const char* key; ///< in the stored layout
    const char* title; ///< QT_TRANSLATE_NOOP("Plots", …)
};
[[nodiscard]] std::span<const CurveColourRow> curveColours();

struct CurveWidthRow {
    double pixels;
    const char* title; ///< QT_TRANSLATE_NOOP("Plots", …)
};
[[nodiscard]] std::span<const CurveWidthRow> curveWidths();

[[nodiscard]] QString keyOf(const StreamRow& row);
[[nodiscard]] QString titleOf(const StreamRow& row); ///< translated, as a list of curves says it
[[nodiscard]] QString unitOf(const StreamRow& row);
/// The curve as it comes: in its stream's own colour.
[[nodiscard]] CurveSpec curveOf(const StreamRow& row);

/// Currents; commanded speeds; raw channels; remapped channels.
[[nodiscard]] PlotLayout defaultLayout();
[[nodiscard]] QByteArray toJson(const PlotLayout& layout);
/// Curves that no longer exist are left out; none when nothing of use is in it.
[[nodiscard]] std::optional<PlotLayout> layoutFromJson(const QByteArray& json);

} // namespace trex
