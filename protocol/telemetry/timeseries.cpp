// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/timeseries.h"

namespace trex {

namespace {

using Values = std::variant<ValueColumn<std::uint8_t>, ValueColumn<std::uint16_t>>;

Values makeValues(ValueWidth width, std::optional<std::uint16_t> invalid)
{
    const int marker = invalid ? int(*invalid) : ValueColumn<std::uint8_t>::kNone;
    if (width == ValueWidth::Word) {
        return Values(std::in_place_index<1>, marker);
    }
    return Values(std::in_place_index<0>, marker);
}

/// Borders of a column with so many samples may move to multiples of this: an eighth of it or less.
std::size_t snapOf(std::size_t samples)
{
    std::size_t snap = 1;
    while (snap < kChunkSize && snap * 64 <= samples) {
        snap *= 8;
    }
    return snap;
}

} // namespace

TimeSeries::TimeSeries(const TimeAxis& axis, ValueWidth width, std::optional<std::uint16_t> invalid)
    : m_axis(axis), m_values(makeValues(width, invalid))
{
}

void TimeSeries::append(std::uint16_t value)
{
    if (auto* bytes = std::get_if<0>(&m_values)) {
        bytes->append(static_cast<std::uint8_t>(value));
    } else {
        std::get_if<1>(&m_values)->append(value);
    }
}

void TimeSeries::dropChunk()
{
    std::visit([](auto& values) { values.dropChunk(); }, m_values);
}

void TimeSeries::clear()
{
    std::visit([](auto& values) { values.clear(); }, m_values);
}

std::size_t TimeSeries::size() const
{
    return std::visit([](const auto& values) { return values.size(); }, m_values);
}

int TimeSeries::value(std::size_t index) const
{
    return std::visit([index](const auto& values) { return int(values.at(index)); }, m_values);
}

bool TimeSeries::isValid(std::size_t index) const
{
    return std::visit([index](const auto& values) { return values.isValid(index); }, m_values);
}

Extent TimeSeries::extent(std::size_t begin, std::size_t end) const
{
    return std::visit([&](const auto& values) { return values.extent(begin, end); }, m_values);
}

std::optional<double> TimeSeries::mean(std::size_t begin, std::size_t end) const
{
    return std::visit(
        [&](const auto& values) -> std::optional<double> {
            const auto sum = values.sum(begin, end);
            if (sum.valid == 0) {
                return std::nullopt;
            }
            return double(sum.sum) / double(sum.valid);
        },
        m_values);
}

std::pair<std::size_t, std::size_t> TimeSeries::range(Instant from, Instant to) const
{
    const std::size_t begin = m_axis.lowerBound(TimeAxis::ticksOf(from));
    const std::size_t end = m_axis.lowerBound(TimeAxis::ticksOf(to), begin);
    return {begin, std::max(begin, end)};
}

void TimeSeries::columns(const ColumnGrid& grid, std::vector<PlotColumn>& columns) const
{
    const auto count = static_cast<std::size_t>(std::max(grid.count, 0));
    columns.resize(count);
    // Pass 1: the true borders, as indices.
    std::size_t border = m_axis.lowerBound(TimeAxis::ticksOf(grid.from));
    for (std::size_t i = 0; i < count; ++i) {
        columns[i].begin = border;
        const Instant next = grid.from + (static_cast<std::int64_t>(i) + 1) * grid.width;
        border = m_axis.lowerBound(TimeAxis::ticksOf(next), border);
        columns[i].end = border;
    }
    // Pass 2: between two full columns the border snaps to the pyramid; then the extremes.
    std::visit(
        [&](const auto& values) {
            for (std::size_t i = 0; i < count; ++i) {
                PlotColumn& column = columns[i];
                if (i + 1 < count) {
                    PlotColumn& right = columns[i + 1];
                    const std::size_t fewer =
                        std::min(column.end - column.begin, right.end - right.begin);
                    const std::size_t snap = snapOf(fewer);
                    column.end -= column.end % snap;
                    right.begin = column.end;
                }
                column.extent = values.extent(column.begin, column.end);
            }
        },
        m_values);
}

std::size_t TimeSeries::memoryBytes() const
{
    return std::visit([](const auto& values) { return values.memoryBytes(); }, m_values);
}

} // namespace trex
