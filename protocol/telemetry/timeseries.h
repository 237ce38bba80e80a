// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/valuecolumn.h"

#include <variant>

namespace trex {

enum class ValueWidth : std::uint8_t { Byte = 1, Word = 2 };

/// A row of pixel columns over time, as a plot asks for it.
struct ColumnGrid {
    Instant from;
    Duration width{0}; ///< of one column; at least 10 µs
    int count = 0;
};

/// The samples that fall into one pixel column, and their extremes.
struct PlotColumn {
    std::size_t begin = 0;
    std::size_t end = 0;
    Extent extent;
};

/// The samples of one stream: raw values beside the times of its source. Append-only; what was
/// written never moves, so that readers on the same thread look without copying. Values are stored
/// numbers; the stream table says what they mean.
class TimeSeries {
public:
    /// `axis` outlives the series and is appended to first. `invalid`: the stored number that means
    /// "nothing known" (an invalid pulse).
    TimeSeries(const TimeAxis& axis, ValueWidth width, std::optional<std::uint16_t> invalid = {});

    void append(std::uint16_t value); ///< the value at the axis' latest time
    void dropChunk(); ///< the oldest one, with the axis'
    void clear();

    [[nodiscard]] const TimeAxis& axis() const { return m_axis; }
    /// One past the newest sample. Indices stay when the oldest samples leave: those of
    /// [first(), size()) are there.
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] std::size_t first() const { return m_axis.first(); }
    [[nodiscard]] bool isEmpty() const { return size() == 0; }
    [[nodiscard]] int value(std::size_t index) const;
    [[nodiscard]] bool isValid(std::size_t index) const;
    [[nodiscard]] Instant time(std::size_t index) const { return m_axis.time(index); }

    [[nodiscard]] Extent extent(std::size_t begin, std::size_t end) const;
    /// Mean of the valid samples of [begin, end); none when there is none.
    [[nodiscard]] std::optional<double> mean(std::size_t begin, std::size_t end) const;
    using Sum = ValueColumn<std::uint8_t>::Sum;
    /// Sum, sum of squares and number of the valid samples of [begin, end), all exact.
    [[nodiscard]] Sum sum(std::size_t begin, std::size_t end) const;
    /// Twice the area under the samples of [begin, end), joined by straight lines: stored units ×
    /// ticks. Gaps and invalid samples have none. At most a chunk at each end is walked.
    [[nodiscard]] std::uint64_t doubleArea(std::size_t begin, std::size_t end) const;
    /// Samples of [from, to) as indices.
    [[nodiscard]] std::pair<std::size_t, std::size_t> range(Instant from, Instant to) const;

    /// Fills `columns` with one entry a column of the grid. Every sample of the range is in exactly
    /// one column, and each column's extremes are exact for its samples. Where columns hold many
    /// samples, their borders are moved to the pyramid's (by at most an eighth of a column).
    void columns(const ColumnGrid& grid, std::vector<PlotColumn>& columns) const;

    /// Heap bytes of the values and their pyramid; the axis, shared, counts for itself.
    [[nodiscard]] std::size_t memoryBytes() const;

private:
    [[nodiscard]] std::uint64_t doubleAreaTo(std::size_t sample) const;

    const TimeAxis& m_axis;
    std::variant<ValueColumn<std::uint8_t>, ValueColumn<std::uint16_t>> m_values;
    std::optional<std::uint16_t> m_invalid;
    // Running areas, so that a charge over a day needs no walk over it: one number a chunk.
    std::vector<std::uint64_t>
        m_areas; ///< doubled, up to and with the step to the chunk's first sample
    std::uint64_t m_area = 0;
    TimeAxis::Tick m_lastTick = 0;
    std::optional<std::uint16_t> m_lastValue; ///< none: invalid, or there is none yet
};

} // namespace trex
