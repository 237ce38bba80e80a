// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/quantities.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace trex {

/// Samples a chunk of every column; a power of the pyramid's factor 8.
inline constexpr std::size_t kChunkSize = 4096;

/// The times of the samples of one source, shared by all series that it fills. Append-only,
/// chunked: nothing that was written moves; whole chunks may leave at the front, and indices stay
/// what they were. Four bytes a time: a count of 10 µs from the chunk's
/// first; a chunk that would overflow (12 h of silence in it) is counted in coarser steps. Not
/// thread-safe: one writer and its readers on one thread.
class TimeAxis {
public:
    using Tick = std::int64_t; ///< 10 µs on the steady clock
    static constexpr Duration kTick = std::chrono::microseconds(10);
    [[nodiscard]] static constexpr Tick ticksOf(Instant time)
    {
        return time.time_since_epoch() / kTick;
    }
    [[nodiscard]] static constexpr Instant instantOf(Tick tick)
    {
        return Instant(std::chrono::duration_cast<Instant::duration>(tick * kTick));
    }

    /// A pause between two samples of at least `longestStep` counts as a gap.
    explicit TimeAxis(Duration longestStep = std::chrono::seconds(1));

    /// Times never run backwards: an earlier one is taken as equal to the last.
    void append(Instant time);
    void markGap(); ///< the next sample starts anew: nothing is known between
    void dropChunk(); ///< the oldest one; only when there is a newer one
    void clear();

    /// One past the newest sample: all that were ever appended, since indices stay.
    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] std::size_t first() const { return m_first; } ///< the oldest that is still there
    [[nodiscard]] std::size_t chunks() const { return m_chunks.size(); }
    /// The time of the first sample that stays when the oldest chunk goes; chunks() > 1.
    [[nodiscard]] Tick secondChunkTick() const { return m_chunks[1].base; }
    [[nodiscard]] Tick tick(std::size_t index) const;
    [[nodiscard]] Instant time(std::size_t index) const { return instantOf(tick(index)); }
    [[nodiscard]] Tick lastTick() const { return m_last; } ///< only when size() > 0
    /// Index of the first sample at or after `wanted`, of those that are there. Gallops from
    /// `hint`, so that a row of pixel borders costs a step or two each.
    [[nodiscard]] std::size_t lowerBound(Tick wanted, std::size_t hint = 0) const;
    /// Indices of the samples that have a gap before them, ascending. The first sample has none.
    [[nodiscard]] const std::vector<std::size_t>& gaps() const { return m_gaps; }
    [[nodiscard]] bool hasGapBetween(std::size_t before,
                                     std::size_t after) const; ///< (before, after]
    [[nodiscard]] std::size_t memoryBytes() const;

private:
    struct Chunk {
        Tick base = 0;
        unsigned shift = 0;
        std::unique_ptr<std::array<std::uint32_t, kChunkSize>> deltas;
    };
    void coarsen(Chunk& chunk, std::size_t used);
    [[nodiscard]] std::size_t chunkOf(Tick wanted, std::size_t hint) const;

    std::vector<Chunk> m_chunks;
    std::vector<std::size_t> m_gaps;
    std::size_t m_size = 0;
    std::size_t m_first = 0; ///< of the first chunk
    Tick m_last = 0;
    Tick m_longestStep;
    bool m_gapPending = false;
};

} // namespace trex
