// SPDX-License-Identifier: GPL-3.0-or-later
// All streams of a store as CSV (contracts/cli.md, `export`).
#pragma once

#include "protocol/storage/csvexport.h"

#include <array>

namespace trex {

struct CsvOptions {
    /// Which sources; those without samples are left out.
    std::array<bool, kSourceCount> polls{};
    Model model = Model::TrexJr;
    std::optional<InputKind> input{}; ///< none: channels without a physical column
    std::optional<TimeRange> range{};
};

/// The header: `t_s`, then for each source its columns, raw first, then physical with the unit in
/// the name:
/// motor1_raw,motor2_raw,motor1_A,motor2_A,channel1_raw,…,channel1_us,…,channel1_remapped,…,
/// status_raw,uart_errors_raw; then, as plain numbers, motor1_command,motor2_command,aux_command,
/// link_rate_per_s,link_latency_ms,link_errors_per_s.
[[nodiscard]] QByteArray samplesCsvHeader(const TelemetryStore& store, const CsvOptions& options);

/// Every sample once, in rows by time. A row is a sample of the first source that has any, with
/// what the other sources gave until the next one, at most 100 ms later; t_s is its first sample's
/// time, in seconds since the first of all. A source that gave nothing meanwhile, or an invalid
/// pulse's physical value, is an empty cell. Gives the number of rows. The file is written whole or
/// not at all. Error: FileUnwritable.
[[nodiscard]] Result<std::size_t> exportSamplesCsv(const QString& path, const TelemetryStore& store,
                                                   const CsvOptions& options);

} // namespace trex
