// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/timeseries.h"

#include <algorithm>

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
    : m_axis(axis), m_values(makeValues(width, invalid)), m_invalid(invalid)
{
}

void TimeSeries::append(std::uint16_t value)
{
    const std::size_t index = size();
    const TimeAxis::Tick tick = m_axis.lastTick();
    const bool isValid = value != m_invalid;
    const bool hasGap = !m_axis.gaps().empty() && m_axis.gaps().back() == index;
    if (isValid && m_lastValue && !hasGap) {
        m_area +=
            static_cast<std::uint64_t>(tick - m_lastTick) * (std::uint64_t(value) + *m_lastValue);
    }
    if (index % kChunkSize == 0) {
        m_areas.push_back(m_area);
    }
    m_lastTick = tick;
    m_lastValue = isValid ? std::optional(value) : std::nullopt;
    if (auto* bytes = std::get_if<0>(&m_values)) {
        bytes->append(static_cast<std::uint8_t>(value));
    } else {
        std::get_if<1>(&m_values)->append(value);
    }
}

void TimeSeries::dropChunk()
{
    std::visit([](auto& values) { values.dropChunk(); }, m_values);
    m_areas.erase(m_areas.begin());
}

void TimeSeries::clear()
{
    std::visit([](auto& values) { values.clear(); }, m_values);
    m_areas.clear();
    m_area = 0;
    m_lastTick = 0;
    m_lastValue.reset();
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

TimeSeries::Sum TimeSeries::sum(std::size_t begin, std::size_t end) const
{
    return std::visit(
        [&](const auto& values) {
            const auto sum = values.sum(begin, end);
            return Sum{sum.sum, sum.squares, sum.valid};
        },
        m_values);
}

std::optional<double> TimeSeries::mean(std::size_t begin, std::size_t end) const
{
    const Sum all = sum(begin, end);
    return all.valid == 0 ? std::nullopt : std::optional(double(all.sum) / double(all.valid));
}

std::uint64_t TimeSeries::doubleArea(std::size_t begin, std::size_t end) const
{
    begin = std::max(begin, first());
    return begin + 1 < end ? doubleAreaTo(end - 1) - doubleAreaTo(begin) : 0;
}

/// Of all steps up to the one that ends at this sample.
std::uint64_t TimeSeries::doubleAreaTo(std::size_t sample) const
{
    if (sample + 1 >= size()) {
        return m_area;
    }
    const std::size_t chunk = (sample - first()) / kChunkSize;
    const std::size_t begin = first() + chunk * kChunkSize;
    std::uint64_t area = m_areas[chunk];
    const std::vector<std::size_t>& gaps = m_axis.gaps();
    auto gap = std::upper_bound(gaps.begin(), gaps.end(), begin);
    for (std::size_t i = begin + 1; i <= sample; ++i) {
        const bool hasGap = gap != gaps.end() && *gap == i;
        if (hasGap) {
            ++gap;
        } else if (isValid(i) && isValid(i - 1)) {
            const auto step = static_cast<std::uint64_t>(m_axis.tick(i) - m_axis.tick(i - 1));
            area += step * static_cast<std::uint64_t>(value(i) + value(i - 1));
        }
    }
    return area;
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
    return std::visit([](const auto& values) { return values.memoryBytes(); }, m_values)
        + m_areas.capacity() * sizeof(m_areas[0]);
}

} // namespace trex
