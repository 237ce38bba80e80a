// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/wire.h"

#include <bit>
#include <cstdlib>

namespace trex::sim {
namespace {

constexpr int kDataBits = 8;

bool parityBit(std::uint8_t value, ErrorDetection detection)
{
    const bool isOdd = (std::popcount(value) % 2) != 0;
    return detection == ErrorDetection::Even ? isOdd : !isOdd;
}

bool wireParityEqual(const UartFormat& a, const UartFormat& b)
{
    return a.hasParity() == b.hasParity() && (!a.hasParity() || a.detection == b.detection);
}

} // namespace

bool UartFormat::hasParity() const
{
    return detection == ErrorDetection::Even || detection == ErrorDetection::Odd;
}

Duration UartFormat::timeOf(int bitCount) const
{
    return Duration(std::int64_t{1'000'000'000} * bitCount / baud);
}

WireSampler::WireSampler(const UartFormat& sender, const UartFormat& receiver)
    : m_sender(sender)
    , m_receiver(receiver)
    , m_transparent(std::abs(sender.baud - receiver.baud) * 100 <= receiver.baud * 3
                    && wireParityEqual(sender, receiver))
{
}

void WireSampler::feed(std::uint8_t value, Instant begin, std::vector<SampledByte>& out)
{
    unsigned levels = static_cast<unsigned>(value) << 1U; // start bit 0, least significant first
    int bits = 1 + kDataBits;
    if (m_sender.hasParity()) {
        levels |= (parityBit(value, m_sender.detection) ? 1U : 0U) << bits;
        ++bits;
    }
    levels |= ~0U << bits;
    m_frames.push_back({begin, static_cast<std::uint16_t>(levels)});
    settle(begin + m_sender.byteTime(), out);
}

void WireSampler::settle(Instant until, std::vector<SampledByte>& out)
{
    const Duration whole = m_receiver.timeOf(2 + kDataBits + (m_receiver.hasParity() ? 1 : 0));
    while (const auto edge = fallingEdge(m_from)) {
        if (*edge + whole > until) {
            break;
        }
        if (level(*edge + m_receiver.timeOf(1) / 2)) {
            m_from = *edge + m_receiver.timeOf(1) / 2; // too short for a start bit
            continue;
        }
        out.push_back(sample(*edge));
        // A UART is ready for the next start bit from the middle of the stop bit on.
        m_from = *edge + whole - m_receiver.timeOf(1) / 2;
    }
    const Duration frame = m_sender.timeOf(16);
    while (!m_frames.empty() && m_frames.front().begin + frame < m_from
           && m_frames.front().begin + frame < until) {
        m_frames.pop_front();
    }
    if (!fallingEdge(m_from)) {
        m_frames.clear();
    }
}

bool WireSampler::level(Instant at) const
{
    for (auto frame = m_frames.rbegin(); frame != m_frames.rend(); ++frame) {
        if (at >= frame->begin) {
            const auto bit = (at - frame->begin).count() * m_sender.baud / 1'000'000'000;
            return bit >= 16 || ((frame->levels >> bit) & 1U) != 0U;
        }
    }
    return true;
}

std::optional<Instant> WireSampler::fallingEdge(Instant from) const
{
    for (std::size_t i = 0; i < m_frames.size(); ++i) {
        bool before = true; // every frame ends in a stop bit
        for (int bit = 0; bit < 12; ++bit) {
            const bool now = ((m_frames[i].levels >> bit) & 1U) != 0U;
            const Instant at = m_frames[i].begin + m_sender.timeOf(bit);
            if (i + 1 < m_frames.size() && at >= m_frames[i + 1].begin) {
                break;
            }
            if (before && !now && at >= from) {
                return at;
            }
            before = now;
        }
    }
    return std::nullopt;
}

SampledByte WireSampler::sample(Instant begin) const
{
    const auto middle = [&](int bit) {
        return level(begin + (m_receiver.timeOf(bit) + m_receiver.timeOf(bit + 1)) / 2);
    };
    SampledByte result;
    for (int bit = 0; bit < kDataBits; ++bit) {
        if (middle(1 + bit)) {
            result.byte.value = static_cast<std::uint8_t>(result.byte.value | (1U << bit));
        }
    }
    int next = 1 + kDataBits;
    if (m_receiver.hasParity()) {
        result.byte.parityError =
            middle(next) != parityBit(result.byte.value, m_receiver.detection);
        ++next;
    }
    result.byte.frameError = !middle(next);
    result.begin = begin;
    result.end = begin + m_receiver.timeOf(next + 1);
    return result;
}

} // namespace trex::sim
