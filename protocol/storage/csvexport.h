// SPDX-License-Identifier: GPL-3.0-or-later
// Motor currents as CSV (contracts/cli.md, `currents --csv`): a header, one row a sample, seconds
// since the start. The rows are the samples themselves, never a plot's decimation of them.
#pragma once

#include "protocol/result.h"
#include "protocol/telemetry/telemetrystore.h"

#include <optional>

namespace trex {

struct TimeRange {
    Instant from; ///< first moment that belongs to it
    Instant to; ///< first moment after it
};

/// "t_s,motor1_raw,motor2_raw,motor1_A,motor2_A" and a line feed.
[[nodiscard]] QByteArray currentsCsvHeader();
/// One row with its line feed: seconds to 10 µs, raw counts, amperes to 1 mA; always with a point.
[[nodiscard]] QByteArray currentsCsvRow(double seconds, int raw1, int raw2, double amperesPerCount);

/// False for what exists and is no plain file: replacing a device or waiting on a pipe helps
/// nobody.
[[nodiscard]] bool isFileOrNew(const QString& path);

/// Writes the samples of the range (none: all) to the file, whole or not at all. Seconds count from
/// the store's start. Gives the number of rows. Error: FileUnwritable, with the path and the cause;
/// an older file of that name is then as it was.
[[nodiscard]] Result<std::size_t> exportCurrentsCsv(const QString& path,
                                                    const TelemetryStore& store,
                                                    double amperesPerCount,
                                                    std::optional<TimeRange> range = {});

} // namespace trex
