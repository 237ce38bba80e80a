// SPDX-License-Identifier: GPL-3.0-or-later
// THE stream table: one row for each quantity that is recorded over time. Store, plots and exports
// loop over the rows; a new curve is one row in streamtable.cpp.
#pragma once

#include "protocol/telemetry/source.h"
#include "protocol/telemetry/timeseries.h"

#include <span>
#include <string_view>

namespace trex {

/// What a curve stands for, so that every plot gives it the same colour. (The core knows no
/// colours.)
enum class StreamColour : std::uint8_t {
    Motor1,
    Motor2,
    Channel1,
    Channel2,
    Channel3,
    Channel4,
    Channel5,
    Neutral,
    Aux
};

/// How a raw number of a reply is kept: as it is, or turned from sign and magnitude to a count
/// from −127 stored as 0, so that extremes are extremes.
enum class StreamEncoding : std::uint8_t { Plain, SignMagnitude };

inline constexpr std::uint16_t kUnknownOrder = 0xFF; ///< nobody knows what the motor was told
inline constexpr std::uint16_t kNoLatency = 0xFFFF; ///< no reply in that time

struct StreamRow {
    std::string_view key;
    const char* title = nullptr; ///< QT_TRANSLATE_NOOP("Streams", …)
    std::string_view unit{}; ///< of the physical value, "" for plain numbers
    double scale = 1.0; ///< physical = (stored + offset) × scale
    int offset = 0;
    int decimals = 0;
    Source source = PollId::Currents;
    int field = 0; ///< which number of the source's samples
    ValueWidth width = ValueWidth::Byte;
    StreamEncoding encoding = StreamEncoding::Plain;
    std::optional<std::uint16_t> invalid{}; ///< stored number that is no value
    StreamColour colour = StreamColour::Neutral;
};

[[nodiscard]] std::span<const StreamRow> streams();
[[nodiscard]] int streamIndex(std::string_view key); ///< −1: no such stream
[[nodiscard]] std::uint16_t storedFromRaw(const StreamRow& row, std::uint16_t raw);
[[nodiscard]] std::uint16_t rawFromStored(const StreamRow& row, int stored);
[[nodiscard]] constexpr double physicalFromStored(const StreamRow& row, int stored)
{
    return (stored + row.offset) * row.scale;
}

} // namespace trex
