// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/linkhealth.h"

#include "protocol/session/linkrates.h"

#include <bit>

namespace trex {

namespace {

constexpr int kFirstWidth = 7; // 64 µs and more have so many binary digits
constexpr int kSubBits = 3; // eight bins to a doubling
static_assert(1 << kSubBits == LatencyHistogram::kPerOctave);

} // namespace

int LatencyHistogram::binOf(Duration duration)
{
    const auto microseconds = static_cast<quint64>(std::max<qint64>(
        std::chrono::duration_cast<std::chrono::microseconds>(duration).count(), 0));
    const auto width = static_cast<int>(std::bit_width(microseconds));
    if (width < kFirstWidth) {
        return 0;
    }
    const auto part = static_cast<int>(microseconds >> (width - 1 - kSubBits)) - kPerOctave;
    return std::min((width - kFirstWidth) * kPerOctave + part, kBins - 1);
}

Duration LatencyHistogram::edge(int bin)
{
    const qint64 octave = qint64{1} << (kFirstWidth - 1 + bin / kPerOctave);
    return std::chrono::microseconds(octave + octave * (bin % kPerOctave) / kPerOctave);
}

void LatencyHistogram::add(Duration duration)
{
    ++m_counts.at(static_cast<std::size_t>(binOf(duration)));
    m_shortest = m_total == 0 ? duration : std::min(m_shortest, duration);
    m_longest = std::max(m_longest, duration);
    m_sum += duration;
    ++m_total;
}

LatencyHistogram& LatencyHistogram::operator+=(const LatencyHistogram& other)
{
    if (other.m_total == 0) {
        return *this;
    }
    for (std::size_t i = 0; i < m_counts.size(); ++i) {
        m_counts[i] += other.m_counts[i];
    }
    m_shortest = m_total == 0 ? other.m_shortest : std::min(m_shortest, other.m_shortest);
    m_longest = std::max(m_longest, other.m_longest);
    m_sum += other.m_sum;
    m_total += other.m_total;
    return *this;
}

std::optional<Duration> LatencyHistogram::quantile(double part) const
{
    if (m_total == 0) {
        return std::nullopt;
    }
    const double wanted = part * static_cast<double>(m_total);
    double below = 0.0;
    for (int bin = 0; bin < kBins; ++bin) {
        const double here = count(bin);
        if (here > 0.0 && below + here >= wanted) {
            const Duration from = bin == 0 ? m_shortest : edge(bin);
            const Duration to = bin == kBins - 1 ? m_longest : edge(bin + 1);
            const double inside = std::clamp((wanted - below) / here, 0.0, 1.0);
            const auto width = static_cast<double>((to - from).count());
            const Duration value = from + Duration(static_cast<Duration::rep>(width * inside));
            return std::clamp(value, m_shortest, m_longest);
        }
        below += here;
    }
    return m_longest;
}

Duration LatencyHistogram::mean() const
{
    return m_total == 0 ? Duration(0) : m_sum / static_cast<Duration::rep>(m_total);
}

HealthCounts& HealthCounts::operator+=(const HealthCounts& other)
{
    covered += other.covered;
    for (const auto member :
         {&HealthCounts::transactions, &HealthCounts::replies, &HealthCounts::retries,
          &HealthCounts::timeouts, &HealthCounts::shortReplies, &HealthCounts::crcErrors,
          &HealthCounts::badReplies, &HealthCounts::lateReplies, &HealthCounts::lateBytes,
          &HealthCounts::unaskedBytes, &HealthCounts::unaskedBursts, &HealthCounts::resyncs,
          &HealthCounts::losses, &HealthCounts::bytes}) {
        this->*member += other.*member;
    }
    wire += other.wire;
    for (std::size_t i = 0; i < uart.size(); ++i) {
        uart[i] += other.uart[i];
    }
    trips += other.trips;
    ideal += other.ideal;
    extra += other.extra;
    return *this;
}

void HealthCounts::addSent(Duration onTheWire, int count)
{
    ++transactions;
    addBytes(onTheWire, count);
}

void HealthCounts::addBytes(Duration onTheWire, int count)
{
    bytes += static_cast<quint64>(count);
    wire += onTheWire;
}

void HealthCounts::addReply(Duration trip, Duration onTheWire)
{
    trips.add(trip);
    ideal.add(onTheWire);
    extra.add(std::max<Duration>(trip - onTheWire, Duration::zero()));
}

void HealthCounts::addUartErrors(std::uint8_t byte)
{
    for (std::size_t bit = 0; bit < uart.size(); ++bit) {
        uart[bit] += static_cast<quint32>(byte >> bit & 1U);
    }
}

void HealthCounts::addFailure(ErrorCode code)
{
    switch (code) {
    case ErrorCode::BadReplyCrc:
        ++crcErrors;
        break;
    case ErrorCode::BadReply:
        ++badReplies;
        break;
    case ErrorCode::ShortReply:
        ++shortReplies;
        break;
    default:
        ++timeouts;
        break;
    }
}

void HealthCounts::addUnasked(QByteArrayView bytesDropped, bool afterFailure, bool beginsBurst)
{
    // Some firmware is said to answer motor commands with 0xFF (facts 4, F-13311): nobody else.
    const bool isAnswerToMotor =
        std::all_of(bytesDropped.begin(), bytesDropped.end(), [](char c) { return c == '\xFF'; });
    if (afterFailure || isAnswerToMotor) {
        lateBytes += static_cast<quint64>(bytesDropped.size());
        return;
    }
    unaskedBytes += static_cast<quint64>(bytesDropped.size());
    unaskedBursts += beginsBurst ? 1 : 0;
}

double HealthCounts::bytesPerSecond() const
{
    const double seconds = std::chrono::duration<double>(covered).count();
    return seconds > 0.0 ? static_cast<double>(bytes) / seconds : 0.0;
}

double HealthCounts::wireShare() const
{
    return covered > Duration(0)
        ? std::min(static_cast<double>(wire.count()) / static_cast<double>(covered.count()), 1.0)
        : 0.0;
}

HealthCounts& LinkHealthMeter::at(Instant now)
{
    turn(now);
    return m_second;
}

void LinkHealthMeter::opened(Instant now, const AdapterFacts& adapter)
{
    m_adapter = adapter;
    turn(now);
    m_coveredTo = now;
}

void LinkHealthMeter::closed(Instant now)
{
    turn(now);
    m_coveredTo.reset();
}

void LinkHealthMeter::reset(Instant now)
{
    const bool isOpen = m_coveredTo.has_value();
    AdapterFacts adapter = std::move(m_adapter);
    *this = {};
    m_adapter = std::move(adapter);
    m_sliceStart = now;
    m_secondStart = now;
    m_coveredTo = isOpen ? std::optional(now) : std::nullopt;
}

void LinkHealthMeter::cover(Instant now)
{
    if (m_coveredTo && now > *m_coveredTo) {
        m_second.covered += now - *m_coveredTo;
        m_coveredTo = now;
    }
}

void LinkHealthMeter::turn(Instant now)
{
    cover(now);
    if (now - m_secondStart < kSecond) {
        return;
    }
    m_secondStart = now;
    m_lastSecond = m_second;
    m_total += m_second;
    m_slice += m_second;
    m_second = {};
    const Duration slice = now - m_sliceStart;
    if (slice >= kSlice) {
        m_before = slice < 2 * kSlice ? m_slice : HealthCounts{};
        m_slice = {};
        m_sliceStart = now;
    }
}

std::optional<LinkHealth> LinkHealthMeter::take(Instant now)
{
    if (m_hasTold && now - m_told < kTold) {
        return std::nullopt;
    }
    m_hasTold = true;
    m_told = now;
    turn(now);
    LinkHealth health;
    health.total = m_total;
    health.total += m_second;
    health.recent = m_before;
    health.recent += m_slice;
    health.recent += m_second;
    health.now = m_lastSecond;
    health.adapter = m_adapter;
    return health;
}

void LinkRates::into(LinkStats& stats, Instant now)
{
    const double seconds = std::chrono::duration<double>(now - start).count();
    if (seconds < 1.0) {
        return;
    }
    stats.transactionsPerSecond = static_cast<double>(transactions) / seconds;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        stats.achievedHertz.at(i) = static_cast<double>(samples.at(i)) / seconds;
    }
    start = now;
    transactions = 0;
    samples.fill(0);
}

} // namespace trex
