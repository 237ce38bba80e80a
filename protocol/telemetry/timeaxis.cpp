// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/timeaxis.h"

#include <algorithm>
#include <limits>

namespace trex {

TimeAxis::TimeAxis(Duration longestStep) : m_longestStep(longestStep / kTick) { }

void TimeAxis::append(Instant time)
{
    const std::size_t place = m_size % kChunkSize;
    const Tick now = m_size == 0 ? ticksOf(time) : std::max(ticksOf(time), m_last);
    if (m_size > 0 && (m_gapPending || now - m_last >= m_longestStep)) {
        m_gaps.push_back(m_size);
    }
    m_gapPending = false;
    if (place == 0) {
        m_chunks.push_back(
            {now, 0, std::make_unique_for_overwrite<std::array<std::uint32_t, kChunkSize>>()});
    }
    Chunk& chunk = m_chunks.back();
    while (((now - chunk.base) >> chunk.shift) > std::numeric_limits<std::uint32_t>::max()) {
        coarsen(chunk, place);
    }
    (*chunk.deltas)[place] = static_cast<std::uint32_t>((now - chunk.base) >> chunk.shift);
    m_last = now;
    ++m_size;
}

void TimeAxis::coarsen(Chunk& chunk, std::size_t used)
{
    ++chunk.shift;
    for (std::size_t i = 0; i < used; ++i) {
        (*chunk.deltas)[i] >>= 1U;
    }
}

void TimeAxis::markGap()
{
    m_gapPending = true;
}

void TimeAxis::dropChunk()
{
    m_chunks.erase(m_chunks.begin());
    m_first += kChunkSize;
    m_gaps.erase(m_gaps.begin(), std::lower_bound(m_gaps.begin(), m_gaps.end(), m_first));
}

void TimeAxis::clear()
{
    m_chunks.clear();
    m_gaps.clear();
    m_size = 0;
    m_first = 0;
    m_last = 0;
    m_gapPending = false;
}

TimeAxis::Tick TimeAxis::tick(std::size_t index) const
{
    const Chunk& chunk = m_chunks[(index - m_first) / kChunkSize];
    return chunk.base + (Tick((*chunk.deltas)[index % kChunkSize]) << chunk.shift);
}

std::size_t TimeAxis::chunkOf(Tick wanted, std::size_t hint) const
{
    // The last chunk that begins before `wanted` holds the answer or ends right before it.
    std::size_t low = std::min(hint, m_chunks.size() - 1);
    if (m_chunks[low].base >= wanted) {
        low = 0;
    }
    std::size_t step = 1;
    while (low + step < m_chunks.size() && m_chunks[low + step].base < wanted) {
        low += step;
        step *= 2;
    }
    std::size_t high = std::min(low + step, m_chunks.size());
    while (high - low > 1) {
        const std::size_t middle = low + (high - low) / 2;
        (m_chunks[middle].base < wanted ? low : high) = middle;
    }
    return low;
}

std::size_t TimeAxis::lowerBound(Tick wanted, std::size_t hint) const
{
    if (m_chunks.empty() || wanted <= m_chunks.front().base) {
        return m_first;
    }
    if (wanted > m_last) {
        return m_size;
    }
    const std::size_t index = chunkOf(wanted, (std::max(hint, m_first) - m_first) / kChunkSize);
    const Chunk& chunk = m_chunks[index];
    const auto& deltas = *chunk.deltas;
    const std::size_t before = m_first + index * kChunkSize;
    const std::size_t used = std::min(kChunkSize, m_size - before);
    const Tick offset = wanted - chunk.base; // > 0
    const Tick rounded = (offset + (Tick(1) << chunk.shift) - 1) >> chunk.shift;
    const Tick span = deltas[used - 1];
    if (rounded > span) {
        return before + used;
    }
    const auto target = static_cast<std::uint32_t>(rounded);
    // Polls are nearly regular: guess by proportion, then gallop from there.
    std::size_t low = 0;
    std::size_t high = used - 1; // deltas[high] >= target
    const auto guess = static_cast<std::size_t>(double(target) / double(span) * double(used - 1));
    std::size_t step = 4;
    if (deltas[guess] >= target) {
        high = guess;
        while (high >= step && deltas[high - step] >= target) {
            high -= step;
            step *= 2;
        }
        low = high >= step ? high - step : 0;
    } else {
        low = guess;
        while (low + step < used && deltas[low + step] < target) {
            low += step;
            step *= 2;
        }
        high = std::min(low + step, used - 1);
    }
    const auto begin = deltas.begin();
    const auto found = std::lower_bound(begin + static_cast<std::ptrdiff_t>(low),
                                        begin + static_cast<std::ptrdiff_t>(high), target);
    return before + static_cast<std::size_t>(found - begin);
}

bool TimeAxis::hasGapBetween(std::size_t before, std::size_t after) const
{
    const auto next = std::upper_bound(m_gaps.begin(), m_gaps.end(), before);
    return next != m_gaps.end() && *next <= after;
}

std::size_t TimeAxis::memoryBytes() const
{
    return m_chunks.size() * sizeof(std::uint32_t) * kChunkSize
        + m_chunks.capacity() * sizeof(Chunk) + m_gaps.capacity() * sizeof(std::size_t);
}

} // namespace trex
