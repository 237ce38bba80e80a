// SPDX-License-Identifier: GPL-3.0-or-later
// RecordingReader's second half: the rows of the tables.
#include "protocol/storage/recordingdatabase.h"
#include "protocol/storage/recordingreader.h"

#include <QVariant>

#include <unordered_map>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr std::size_t kMostBlocks = 8'000'000; // more than a year of everything
constexpr std::size_t kMostEntries = 2'000'000;
constexpr std::size_t kMostPackets = std::size_t(1) << 40U;
constexpr int kLongestText = 4096;
constexpr int kLongestBlock = 200'000;
constexpr int kLongestJson = kLargestConfigurationBytes;

bool isTick(const QVariant& value)
{
    const qint64 tick = value.toLongLong();
    return value.typeId() == QMetaType::LongLong && tick >= -kLargestTick && tick <= kLargestTick;
}

quint64 counter(const QVariant& value)
{
    return static_cast<quint64>(std::max<qint64>(0, value.toLongLong()));
}

/// Errors of a newer program are still errors.
int errorOf(const QVariant& value)
{
    constexpr int kLast = static_cast<int>(ErrorCode::FileUnwritable);
    return value.isNull() ? -1 : std::clamp(value.toInt(), 0, kLast);
}

QString textOf(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

} // namespace

template <class F>
void RecordingReader::eachRow(const QString& sql, const QVariantList& values, F&& take)
{
    const auto rows = m_database->rows(sql, values);
    if (!rows) {
        ++m_damaged;
        return;
    }
    while ((*rows)->next()) {
        if (!take(**rows)) {
            ++m_damaged;
        }
    }
    if (!m_database->checkEnd(**rows)) {
        ++m_damaged;
    }
    (*rows)->finish();
}

void RecordingReader::readBlocks()
{
    std::map<QString, Source> sources;
    for (const SourceRow& row : kSources) {
        if (m_isKnown[row.source.index()]) {
            sources.emplace(textOf(row.key), row.source);
        }
    }
    eachRow(
        u"SELECT id, poll, samples, first, last, gaps, crc FROM block LIMIT %1"_s.arg(kMostBlocks),
        {}, [&](const QSqlQuery& row) {
            const auto source = sources.find(row.value(1).toString());
            if (source == sources.end()) {
                return m_isForeign;
            }
            const qint64 samples = row.value(2).toLongLong();
            const Block block{.id = row.value(0).toLongLong(),
                              .first = row.value(3).toLongLong(),
                              .last = row.value(4).toLongLong(),
                              .samples = static_cast<std::size_t>(samples),
                              .crc = static_cast<quint32>(row.value(6).toLongLong()),
                              .source = source->second,
                              .hasGap = row.value(5).toLongLong() != 0};
            if (samples < 1 || samples > qint64(kBlockSamples) || !isTick(row.value(3))
                || !isTick(row.value(4)) || block.last < block.first) {
                return false;
            }
            m_blocks.push_back(block);
            return true;
        });
    std::stable_sort(m_blocks.begin(), m_blocks.end(),
                     [](const Block& a, const Block& b) { return a.first < b.first; });
}

void RecordingReader::readSummaries()
{
    std::unordered_map<qint64, std::size_t> indexOf;
    indexOf.reserve(m_blocks.size());
    for (std::size_t i = 0; i < m_blocks.size(); ++i) {
        indexOf[m_blocks[i].id] = i;
    }
    m_summaries.resize(streams().size());
    eachRow(u"SELECT block, stream, low, high, total, valid FROM summary LIMIT %1"_s.arg(kMostBlocks
                                                                                         * 8),
            {}, [&](const QSqlQuery& row) {
                const auto block = indexOf.find(row.value(0).toLongLong());
                const auto stream = row.value(1).toULongLong();
                if (block == indexOf.end() || stream >= m_summaries.size()) {
                    return m_isForeign;
                }
                const StreamRow& ours = streams()[stream];
                Summary summary{block->second, {}};
                summary.values.sum = counter(row.value(4));
                summary.values.valid = counter(row.value(5));
                if (ours.source != m_blocks[block->second].source
                    || summary.values.valid > m_blocks[block->second].samples) {
                    return false;
                }
                if (!row.value(2).isNull() && !row.value(3).isNull()) {
                    summary.values.extent = {row.value(2).toInt(), row.value(3).toInt()};
                }
                m_summaries[stream].push_back(summary);
                return true;
            });
    for (auto& list : m_summaries) {
        std::stable_sort(list.begin(), list.end(),
                         [](const Summary& a, const Summary& b) { return a.block < b.block; });
    }
}

std::size_t RecordingReader::samples(Source source) const
{
    std::size_t count = 0;
    for (const Block& block : m_blocks) {
        count += block.source == source ? block.samples : 0;
    }
    return count;
}

std::optional<std::pair<Tick, Tick>> RecordingReader::range() const
{
    if (m_blocks.empty()) {
        return std::nullopt;
    }
    Tick last = m_blocks.front().last;
    for (const Block& block : m_blocks) {
        last = std::max(last, block.last);
    }
    return std::pair(m_blocks.front().first, last);
}

std::vector<RecordingSpan> RecordingReader::overview(int streamIndex) const
{
    const auto& summaries = m_summaries.at(std::size_t(streamIndex));
    std::vector<RecordingSpan> spans;
    spans.reserve(summaries.size());
    for (const Summary& summary : summaries) {
        const Block& block = m_blocks[summary.block];
        RecordingSpan span{block.first, block.last,    summary.values.extent,
                           0.0,         block.samples, block.hasGap};
        if (summary.values.valid > 0) {
            span.mean =
                static_cast<double>(summary.values.sum) / static_cast<double>(summary.values.valid);
        }
        spans.push_back(span);
    }
    return spans;
}

Result<SampleRun> RecordingReader::readBlock(const Block& block)
{
    QByteArray data;
    bool isThere = false;
    const auto rows = m_database->rows(
        u"SELECT samples FROM data WHERE block=? AND length(samples)<=%1"_s.arg(kLongestBlock),
        {block.id});
    if (rows) {
        isThere = (*rows)->next();
        data = isThere ? (*rows)->value(0).toByteArray() : QByteArray();
        (*rows)->finish();
    }
    if (!isThere || crc32(data) != block.crc) {
        return fail(ErrorCode::FileMalformed);
    }
    auto run = decodeBlock(block.source, data, block.samples);
    if (run && (run->ticks.front() != block.first || run->ticks.back() != block.last)) {
        return fail(ErrorCode::FileMalformed);
    }
    return run;
}

bool RecordingReader::loadSome(TelemetryStore& store, Instant origin, std::size_t blocks)
{
    const Tick offset = TimeAxis::ticksOf(origin);
    for (std::size_t i = 0; i < blocks && m_nextBlock < m_blocks.size(); ++i, ++m_nextBlock) {
        const Block& block = m_blocks[m_nextBlock];
        const auto run = readBlock(block);
        if (!run) {
            ++m_damaged;
            store.markGap(block.source);
            continue;
        }
        const auto& columns = streamsOf(block.source);
        auto gap = run->gaps.begin();
        std::array<std::uint16_t, kMostValues> raw{};
        for (std::size_t s = 0; s < run->size(); ++s) {
            if (gap != run->gaps.end() && *gap == s) {
                store.markGap(block.source);
                ++gap;
            }
            for (std::size_t c = 0; c < columns.size(); ++c) {
                const StreamRow& row = streams()[std::size_t(columns[c])];
                raw[std::size_t(row.field)] =
                    rawFromStored(row, run->values[s * columns.size() + c]);
            }
            store.append(block.source, raw, TimeAxis::instantOf(run->ticks[s] + offset));
        }
    }
    return m_nextBlock < m_blocks.size();
}

void RecordingReader::loadAll(TelemetryStore& store, Instant origin)
{
    while (loadSome(store, origin, kBlockSamples)) { }
}

double RecordingReader::progress() const
{
    return m_blocks.empty()
        ? 1.0
        : static_cast<double>(m_nextBlock) / static_cast<double>(m_blocks.size());
}

std::vector<RecordedEvent> RecordingReader::events()
{
    std::vector<RecordedEvent> events;
    eachRow(u"SELECT tick, severity, substr(kind,1,64), substr(text,1,%1) FROM event LIMIT %2"_s
                .arg(kLongestText)
                .arg(kMostEntries),
            {}, [&](const QSqlQuery& row) {
                events.push_back({row.value(0).toLongLong(), std::clamp(row.value(1).toInt(), 0, 2),
                                  row.value(2).toString(), row.value(3).toString()});
                return isTick(row.value(0));
            });
    std::erase_if(events, [](const RecordedEvent& event) {
        return event.tick < -kLargestTick || event.tick > kLargestTick;
    });
    std::stable_sort(events.begin(), events.end(),
                     [](const auto& a, const auto& b) { return a.tick < b.tick; });
    return events;
}

std::vector<RecordedHealth> RecordingReader::health()
{
    std::vector<RecordedHealth> list;
    eachRow(u"SELECT tick, transactions, retries, timeouts, crc_errors, bad_replies, "
            "surplus_bytes, resyncs, bytes_sent, bytes_received, round_trip_ms, "
            "transactions_per_second FROM health LIMIT %1"_s.arg(kMostEntries),
            {}, [&](const QSqlQuery& row) {
                if (!isTick(row.value(0))) {
                    return false;
                }
                RecordedHealth& health = list.emplace_back();
                health.tick = row.value(0).toLongLong();
                int column = 1;
                for (auto* field : {&health.transactions, &health.retries, &health.timeouts,
                                    &health.crcErrors, &health.badReplies, &health.surplusBytes,
                                    &health.resyncs, &health.bytesSent, &health.bytesReceived}) {
                    *field = counter(row.value(column++));
                }
                health.roundTripMs = row.value(10).toDouble();
                health.transactionsPerSecond = row.value(11).toDouble();
                return true;
            });
    return list;
}

std::vector<RecordedConfiguration> RecordingReader::configurations()
{
    std::vector<RecordedConfiguration> list;
    eachRow(u"SELECT tick, json FROM configuration WHERE length(json)<=%1 LIMIT 1000"_s.arg(
                kLongestJson),
            {}, [&](const QSqlQuery& row) {
                const auto parsed = parseConfiguration(row.value(1).toString().toUtf8(), m_path);
                if (!parsed || !isTick(row.value(0))) {
                    return false;
                }
                list.push_back({row.value(0).toLongLong(), *parsed});
                return true;
            });
    return list;
}

/// Their ids run from 1 without a hole: nothing has to be counted or skipped row by row.
std::size_t RecordingReader::packetCount()
{
    if (!m_packetCount) {
        m_packetCount = 0;
        eachRow(u"SELECT max(id) FROM packet"_s, {}, [&](const QSqlQuery& row) {
            m_packetCount = std::min<std::size_t>(counter(row.value(0)), kMostPackets);
            return true;
        });
    }
    return *m_packetCount;
}

std::size_t RecordingReader::packetsUpTo(Tick tick)
{
    std::size_t low = 0;
    std::size_t high = packetCount();
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2; // packet middle + 1 by its id
        std::optional<Tick> sent;
        eachRow(u"SELECT sent FROM packet WHERE id=?"_s, {static_cast<qint64>(middle + 1)},
                [&](const QSqlQuery& row) {
                    sent = row.value(0).toLongLong();
                    return true;
                });
        if (sent && *sent <= tick) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

std::vector<RecordedPacket> RecordingReader::packets(std::size_t from, std::size_t most)
{
    std::vector<RecordedPacket> list;
    const std::size_t begin = std::min(from, kMostPackets);
    eachRow(u"SELECT sent, ended, priority, attempt, error, substr(sent_bytes,1,%1), "
            "substr(received_bytes,1,%1) FROM packet WHERE id>? AND id<=? ORDER BY id LIMIT %2"_s
                .arg(kLongestText)
                .arg(kMostEntries),
            {static_cast<qint64>(begin), static_cast<qint64>(begin + std::min(most, kMostEntries))},
            [&](const QSqlQuery& row) {
                if (!isTick(row.value(0)) || !isTick(row.value(1))) {
                    return false;
                }
                list.push_back({.sent = row.value(0).toLongLong(),
                                .ended = row.value(1).toLongLong(),
                                .priority = std::clamp(row.value(2).toInt(), 0, 3),
                                .attempt = row.value(3).toInt(),
                                .error = errorOf(row.value(4)),
                                .sentBytes = row.value(5).toByteArray(),
                                .receivedBytes = row.value(6).toByteArray()});
                return true;
            });
    return list;
}

} // namespace trex
