// SPDX-License-Identifier: GPL-3.0-or-later
// Two motors' currents as the benchmarks want them: at 80 Hz, slow waves with some noise.
#pragma once

#include "protocol/telemetry/telemetrystore.h"

namespace trex::bench {

inline constexpr Duration kSampleStep = std::chrono::microseconds(12'500);
inline constexpr std::size_t kSamplesOfADay = 24 * 3600 * 80;

[[nodiscard]] std::uint16_t currentAt(std::size_t sample, int motor); ///< raw counts
/// Samples of both motors, the last one a step before `end`.
void fillCurrents(TelemetryStore& store, std::size_t count, Instant end);

} // namespace trex::bench
