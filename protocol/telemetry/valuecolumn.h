// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/timeaxis.h"

#include <bit>
#include <limits>
#include <type_traits>

namespace trex {

/// Lowest and highest value of some samples. Empty (no valid sample among them): low > high.
struct Extent {
    int low = std::numeric_limits<int>::max();
    int high = std::numeric_limits<int>::min();
    [[nodiscard]] constexpr bool isEmpty() const { return low > high; }
    constexpr void add(const Extent& other)
    {
        low = other.low < low ? other.low : low;
        high = other.high > high ? other.high : high;
    }
    bool operator==(const Extent&) const = default;
};

/// Values of one stream, as small as they are (T is 8 or 16 bits wide), in chunks, with a min/max
/// pyramid of factor 8 beside them and running sums for means. Append-only; constant time each.
/// Whole chunks may leave at the front; what is asked of them then is empty.
template <class T>
class ValueColumn {
    static_assert(std::is_unsigned_v<T> && sizeof(T) <= 2);

public:
    static constexpr std::size_t kFactor = 8;
    static constexpr int kLevels = 4; ///< 8, 64, 512 and 4096 samples
    static_assert(kChunkSize == kFactor * kFactor * kFactor * kFactor);

    static constexpr int kNone = -1;
    /// `invalid`: a value that means "nothing known" and stays out of extents and sums, or kNone.
    explicit ValueColumn(int invalid) : m_invalid(invalid) { }

    void append(T value)
    {
        const std::size_t place = m_size % kChunkSize;
        if (place == 0) {
            m_chunks.push_back(std::make_unique_for_overwrite<Chunk>());
            const Total before = m_totals.empty() ? m_before : m_totals.back();
            m_totals.push_back(
                {std::numeric_limits<T>::max(), 0, before.sum, before.squares, before.valid});
        }
        Chunk& chunk = *m_chunks.back();
        chunk.values[place] = value;
        const bool isValid = value != m_invalid;
        // An invalid value is the neutral element of both minimum and maximum.
        const T low = isValid ? value : std::numeric_limits<T>::max();
        const T high = isValid ? value : T(0);
        for (int level = 1; level < kLevels; ++level) {
            const unsigned shift = 3U * unsigned(level);
            const std::size_t entry = kLevelStart[std::size_t(level)] + (place >> shift);
            const bool isFirst = (place & ((std::size_t(1) << shift) - 1)) == 0;
            chunk.low[entry] = isFirst || low < chunk.low[entry] ? low : chunk.low[entry];
            chunk.high[entry] = isFirst || high > chunk.high[entry] ? high : chunk.high[entry];
        }
        Total& total = m_totals.back();
        total.low = low < total.low ? low : total.low;
        total.high = high > total.high ? high : total.high;
        total.sum += isValid ? value : 0U;
        total.squares += isValid ? std::uint64_t(value) * value : 0U;
        total.valid += isValid ? 1U : 0U;
        ++m_size;
    }

    void dropChunk() ///< the oldest one; indices stay what they were
    {
        m_before = m_totals.front();
        m_chunks.erase(m_chunks.begin());
        m_totals.erase(m_totals.begin());
        m_first += kChunkSize;
    }

    void clear()
    {
        m_chunks.clear();
        m_totals.clear();
        m_before = {};
        m_size = 0;
        m_first = 0;
    }

    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] T at(std::size_t index) const
    {
        return m_chunks[(index - m_first) / kChunkSize]->values[index % kChunkSize];
    }
    [[nodiscard]] bool isValid(std::size_t index) const { return at(index) != m_invalid; }

    /// Exact extent of [begin, end): climbs the pyramid as far as the borders allow.
    [[nodiscard]] Extent extent(std::size_t begin, std::size_t end) const
    {
        Extent result;
        begin = begin < m_first ? m_first : begin;
        while (begin < end) {
            int level = begin == 0 ? kLevels : std::countr_zero(begin) / 3;
            level = level > kLevels ? kLevels : level;
            while (level > 0 && begin + (std::size_t(1) << (3 * level)) > end) {
                --level;
            }
            addEntry(result, level, begin);
            begin += std::size_t(1) << (3 * level);
        }
        return result;
    }

    struct Sum {
        std::uint64_t sum = 0;
        std::uint64_t squares = 0;
        std::size_t valid = 0;
    };
    /// Sum, sum of squares and number of the valid samples of [begin, end): at most one chunk at
    /// each end is walked.
    [[nodiscard]] Sum sum(std::size_t begin, std::size_t end) const
    {
        begin = begin < m_first ? m_first : begin;
        if (begin >= end) {
            return {};
        }
        const Sum upTo = sumBefore(end);
        const Sum from = sumBefore(begin);
        return {upTo.sum - from.sum, upTo.squares - from.squares, upTo.valid - from.valid};
    }

    [[nodiscard]] std::size_t memoryBytes() const
    {
        return m_chunks.size() * sizeof(Chunk) + m_chunks.capacity() * sizeof(m_chunks[0])
            + m_totals.capacity() * sizeof(Total);
    }

private:
    /// Start of each level within a chunk's pyramid; level 4 is the chunk itself (Total).
    static constexpr std::array<std::size_t, kLevels> kLevelStart{0, 0, 512, 576};
    struct Chunk {
        std::array<T, kChunkSize> values;
        std::array<T, 584> low;
        std::array<T, 584> high;
    };
    /// A chunk as a whole, kept side by side so that a glance over hours touches little memory.
    struct Total {
        T low = std::numeric_limits<T>::max();
        T high = 0;
        std::uint64_t sum = 0; ///< of all samples up to and with this chunk, as the next two
        std::uint64_t squares = 0;
        std::uint64_t valid = 0;
    };

    void addEntry(Extent& result, int level, std::size_t begin) const
    {
        const std::size_t chunkIndex = (begin - m_first) / kChunkSize;
        if (level == kLevels) {
            const Total& total = m_totals[chunkIndex];
            addPair(result, total.low, total.high);
            return;
        }
        const Chunk& chunk = *m_chunks[chunkIndex];
        const std::size_t place = begin % kChunkSize;
        if (level == 0) {
            if (chunk.values[place] != m_invalid) {
                addPair(result, chunk.values[place], chunk.values[place]);
            }
            return;
        }
        const std::size_t entry = kLevelStart[std::size_t(level)] + (place >> (3 * level));
        addPair(result, chunk.low[entry], chunk.high[entry]);
    }
    static void addPair(Extent& result, T low, T high)
    {
        if (low <= high) { // else: only invalid samples
            result.add({int(low), int(high)});
        }
    }
    [[nodiscard]] Sum sumBefore(std::size_t end) const
    {
        const std::size_t chunkIndex = (end - m_first) / kChunkSize;
        const Total& before = chunkIndex > 0 ? m_totals[chunkIndex - 1] : m_before;
        Sum result{before.sum, before.squares, before.valid};
        for (std::size_t i = m_first + chunkIndex * kChunkSize; i < end; ++i) {
            const T value = at(i);
            const bool counts = value != m_invalid;
            result.sum += counts ? value : 0U;
            result.squares += counts ? std::uint64_t(value) * value : 0U;
            result.valid += counts ? 1U : 0U;
        }
        return result;
    }

    int m_invalid;
    std::vector<std::unique_ptr<Chunk>> m_chunks;
    std::vector<Total> m_totals;
    Total m_before; ///< of the chunk that was dropped last; its sums go on
    std::size_t m_size = 0;
    std::size_t m_first = 0; ///< of the first chunk
};

} // namespace trex
