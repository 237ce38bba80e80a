// SPDX-License-Identifier: GPL-3.0-or-later
// How well the line does: what LinkEngine counts for the Link health panel and `trexctl health`.
// Plain values of fixed size.
#pragma once

#include "protocol/codec/quantities.h"
#include "protocol/result.h"
#include "protocol/transport/adapterfacts.h"

namespace trex {

/// Durations by size, in bins that grow with them: eight to a doubling, from 64 µs to a second.
class LatencyHistogram {
public:
    static constexpr int kPerOctave = 8;
    static constexpr int kOctaves = 14;
    static constexpr int kBins = kPerOctave * kOctaves; ///< the outer two hold what lies beyond

    void add(Duration duration);
    LatencyHistogram& operator+=(const LatencyHistogram& other);
    [[nodiscard]] quint64 total() const { return m_total; }
    [[nodiscard]] quint32 count(int bin) const
    {
        return m_counts.at(static_cast<std::size_t>(bin));
    }
    /// Where a bin begins; kBins: where the last one ends.
    [[nodiscard]] static Duration edge(int bin);
    [[nodiscard]] static int binOf(Duration duration);
    /// 0 to 1; in proportion within its bin, which is at most 12.5 % wide. None: nothing was added.
    [[nodiscard]] std::optional<Duration> quantile(double part) const;
    [[nodiscard]] Duration longest() const { return m_longest; } ///< exactly
    [[nodiscard]] Duration shortest() const { return m_shortest; } ///< exactly
    [[nodiscard]] Duration mean() const; ///< exactly; zero: nothing was added

private:
    std::array<quint32, kBins> m_counts{};
    quint64 m_total = 0;
    Duration m_sum{0};
    Duration m_longest{0};
    Duration m_shortest{0};
};

/// Counted over one stretch of time.
struct HealthCounts {
    Duration covered{0}; ///< time in which the port was open
    quint64 transactions = 0; ///< packets sent, retries and stops included
    quint64 replies = 0; ///< complete and valid
    quint64 retries = 0;
    quint64 timeouts = 0; ///< not a byte came in time
    quint64 shortReplies = 0; ///< some bytes came, then silence
    quint64 crcErrors = 0;
    quint64 badReplies = 0; ///< complete, but implausible or with bytes too many
    quint64 lateReplies = 0; ///< came after we had given up waiting
    quint64 lateBytes = 0; ///< dropped after something had failed
    quint64 unaskedBytes = 0; ///< came while nothing was asked and nothing had failed
    quint64 unaskedBursts = 0; ///< times that such bytes came
    quint64 resyncs = 0;
    quint64 losses = 0; ///< times that the line was lost
    quint64 bytes = 0; ///< both ways, echo left out
    Duration wire{0}; ///< their time at the line's speed
    std::array<quint32, 8> uart{}; ///< times each bit of the UART error byte was read as set
    LatencyHistogram trips; ///< of polled and asked questions: sent to completely answered
    LatencyHistogram ideal; ///< the same on the wire alone, as the line's speed has it
    LatencyHistogram extra; ///< the difference: adapter, system and controller

    HealthCounts& operator+=(const HealthCounts& other);
    void addSent(Duration onTheWire, int count); ///< one packet of so many bytes
    void addBytes(Duration onTheWire, int count);
    void addReply(Duration trip, Duration onTheWire); ///< of a question answered as it should
    void addFailure(ErrorCode code);
    void addUartErrors(std::uint8_t byte);
    /// Bytes that nothing waits for: late ones, or of somebody else.
    void addUnasked(QByteArrayView bytesDropped, bool afterFailure, bool beginsBurst);
    [[nodiscard]] quint64 damaged() const { return shortReplies + crcErrors + badReplies; }
    [[nodiscard]] quint64 answersDue() const { return replies + timeouts + damaged(); }
    [[nodiscard]] double bytesPerSecond() const;
    [[nodiscard]] double wireShare() const; ///< of what the wire carries one way at a time, 0 to 1
};

struct LinkHealth {
    HealthCounts total{}; ///< since the line was opened, or since the figures were reset
    HealthCounts recent{}; ///< of the last half to whole minute
    HealthCounts now{}; ///< of the last second or so
    Duration patience{0}; ///< waited beyond the timeout, since replies were seen to come later
    AdapterFacts adapter{};
};

/// Keeps LinkHealth: a few counters for each transaction, and slices that are thrown away whole.
class LinkHealthMeter {
public:
    /// What happens is counted here; `now` moves the slices on.
    [[nodiscard]] HealthCounts& at(Instant now);
    void opened(Instant now, const AdapterFacts& adapter);
    void closed(Instant now);
    void reset(Instant now); ///< the person's: counts from now
    /// At most four times a second.
    [[nodiscard]] std::optional<LinkHealth> take(Instant now);

    static constexpr std::chrono::seconds kSlice{30};
    static constexpr std::chrono::seconds kSecond{1};
    static constexpr std::chrono::milliseconds kTold{250};

private:
    void cover(Instant now);
    void turn(Instant now);

    HealthCounts m_total; ///< up to m_second
    HealthCounts m_before; ///< the slice before
    HealthCounts m_slice; ///< up to m_second
    HealthCounts m_second; ///< what is counted now
    HealthCounts m_lastSecond;
    AdapterFacts m_adapter; ///< of the line as it was last opened
    Instant m_sliceStart{};
    Instant m_secondStart{};
    std::optional<Instant> m_coveredTo; ///< none: the port is closed
    Instant m_told{};
    bool m_hasTold = false;
};

} // namespace trex
