// SPDX-License-Identifier: GPL-3.0-or-later
// How a recording packs samples: blocks of one source's samples, each with a summary beside it.
#pragma once

#include "protocol/result.h"
#include "protocol/telemetry/streamtable.h"
#include "protocol/telemetry/timeaxis.h"
#include "protocol/telemetry/valuecolumn.h"

#include <QByteArray>

#include <vector>

namespace trex {

using Tick = TimeAxis::Tick; ///< 10 µs

/// A block is full with so many samples, or when it spans so long.
inline constexpr std::size_t kBlockSamples = 1024;
inline constexpr Tick kBlockSpan = std::chrono::seconds(60) / TimeAxis::kTick;
/// Times beyond ± 89 years are no times: sums and differences of others do not overflow, not even
/// as nanoseconds.
inline constexpr Tick kLargestTick = Tick(1) << 48;

/// Indices into streams() of what one source fills, in the order of a block's columns. Empty for a
/// poll of a state (mode, who controls).
[[nodiscard]] const std::vector<int>& streamsOf(Source source);

/// Samples of one source in order of time. Values are stored numbers as in the stream table.
struct SampleRun {
    std::vector<Tick> ticks; ///< never falling
    std::vector<std::uint16_t> values; ///< sample by sample, all columns of each
    std::vector<std::size_t> gaps; ///< samples that have a gap before them, ascending

    [[nodiscard]] std::size_t size() const { return ticks.size(); }
    [[nodiscard]] bool isEmpty() const { return ticks.empty(); }
    void clear();
    bool operator==(const SampleRun&) const = default;
};

struct ColumnSummary {
    Extent extent; ///< empty: no valid sample
    quint64 sum = 0; ///< of the valid samples
    quint64 valid = 0;
    bool operator==(const ColumnSummary&) const = default;
};
[[nodiscard]] std::vector<ColumnSummary> summarise(Source source, const SampleRun& run);

/// Form byte, then the body. The body is made of LEB128 numbers; signed ones are zigzag coded.
///   times:   first tick; then, for each further sample, how much its distance to the one before
///            differs from the distance before that (which is 0 for the second sample)
///   gaps:    how many; then each index less the one before (the first less 0)
///   columns: one after another; each value less the one before (the first less 0)
/// Form 1: the body as it is. Form 2: the length of the body in four bytes, the highest first, and
/// the body as a zlib stream (qCompress). The smaller one is taken, form 1 without `isFinal`.
[[nodiscard]] QByteArray encodeBlock(Source source, const SampleRun& run, bool isFinal);
/// FileMalformed for whatever encodeBlock() never writes; allocates no more than a block needs.
[[nodiscard]] Result<SampleRun> decodeBlock(Source source, const QByteArray& data,
                                            std::size_t samples);
/// CRC-32 (the one of Ethernet, zlib and PNG).
[[nodiscard]] quint32 crc32(const QByteArray& data);

} // namespace trex
