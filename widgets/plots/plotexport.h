// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves the plots: the samples as CSV, the picture as PNG or SVG. Files are written whole or
// not at all. Errors: FileUnwritable, with the path and the cause.
#pragma once

#include "protocol/storage/recordingcsv.h"

#include <QImage>
#include <QString>

#include <span>

namespace trex {

class PlotStack;

/// Every sample of the streams' sources that the range holds (none: all): never what was drawn.
/// Gives the number of rows.
[[nodiscard]] Result<std::size_t> exportPlotsCsv(const QString& path, const TelemetryStore& store,
                                                 std::span<const QString> keys, Model model,
                                                 std::optional<InputKind> input,
                                                 std::optional<TimeRange> range);
[[nodiscard]] Result<void> exportPlotsPng(const QString& path, PlotStack& stack);
[[nodiscard]] Result<void> exportPlotsSvg(const QString& path, PlotStack& stack);
[[nodiscard]] QImage pictureOf(PlotStack& stack, double scale = 2.0);

} // namespace trex
