// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recordingblock.h"

#include <QtEndian>

namespace trex {
namespace {

enum class Form : char { Plain = 1, Compressed = 2 };

constexpr qsizetype kLengthBytes = 4;
constexpr int kLargestNumberBytes = 10; // 64 bits, 7 a byte
// Every number of the largest block at its longest: times, gaps and five columns.
constexpr auto kLargestBody = (2 + kMostValues) * kBlockSamples * kLargestNumberBytes + 64;

class Packer {
public:
    void add(quint64 number)
    {
        while (number >= 0x80U) {
            m_bytes.append(static_cast<char>(number | 0x80U));
            number >>= 7U;
        }
        m_bytes.append(static_cast<char>(number));
    }
    void addSigned(qint64 number)
    {
        const auto bits = static_cast<quint64>(number);
        add((bits << 1U) ^ (number < 0 ? ~quint64(0) : 0U));
    }
    [[nodiscard]] const QByteArray& bytes() const { return m_bytes; }

private:
    QByteArray m_bytes;
};

class Unpacker {
public:
    explicit Unpacker(const QByteArray& bytes, qsizetype from)
        : m_next(bytes.constData() + from), m_end(bytes.constData() + bytes.size())
    {
    }
    [[nodiscard]] quint64 take()
    {
        quint64 number = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            if (m_next == m_end) {
                break;
            }
            const auto byte = static_cast<std::uint8_t>(*m_next++);
            number |= quint64(byte & 0x7FU) << shift;
            if ((byte & 0x80U) == 0U) {
                return number;
            }
        }
        m_isGood = false;
        return 0;
    }
    [[nodiscard]] qint64 takeSigned()
    {
        const quint64 number = take();
        return static_cast<qint64>(number >> 1U) ^ -static_cast<qint64>(number & 1U);
    }
    void refuse() { m_isGood = false; }
    [[nodiscard]] bool isGood() const { return m_isGood; }
    [[nodiscard]] bool isAtEnd() const { return m_next == m_end; }

private:
    const char* m_next;
    const char* m_end;
    bool m_isGood = true;
};

void takeTimes(Unpacker& body, std::size_t samples, SampleRun& run)
{
    const auto isTime = [](Tick tick) { return tick >= -kLargestTick && tick <= kLargestTick; };
    Tick tick = 0;
    Tick step = 0;
    for (std::size_t i = 0; i < samples && body.isGood(); ++i) {
        const Tick number = body.takeSigned();
        if (!isTime(number)) {
            body.refuse();
            break;
        }
        step = i == 0 ? 0 : step + number;
        tick = i == 0 ? number : tick + step;
        if (step < 0 || !isTime(step) || !isTime(tick)) {
            body.refuse();
            break;
        }
        run.ticks.push_back(tick);
    }
}

void takeGaps(Unpacker& body, std::size_t samples, SampleRun& run)
{
    const quint64 count = body.take();
    quint64 index = 0;
    for (quint64 i = 0; i < count && body.isGood(); ++i) {
        const quint64 step = body.take();
        if (step >= samples || (i > 0 && step == 0) || index + step >= samples) {
            body.refuse();
            break;
        }
        index += step;
        run.gaps.push_back(index);
    }
}

qint64 largestStored(const StreamRow& row)
{
    if (row.encoding == StreamEncoding::SignMagnitude) {
        return qint64(kFullSpeed) * 2;
    }
    return row.width == ValueWidth::Word ? 0xFFFF : 0xFF;
}

void takeColumns(Unpacker& body, Source source, SampleRun& run)
{
    const auto& columns = streamsOf(source);
    const std::size_t samples = run.size();
    run.values.resize(samples * columns.size());
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const StreamRow& row = streams()[std::size_t(columns[column])];
        const qint64 largest = largestStored(row);
        qint64 value = 0;
        for (std::size_t i = 0; i < samples && body.isGood(); ++i) {
            const qint64 difference = body.takeSigned();
            if (difference < -largest || difference > largest || value + difference < 0
                || value + difference > largest) {
                body.refuse();
                break;
            }
            value += difference;
            run.values[i * columns.size() + column] = static_cast<std::uint16_t>(value);
        }
    }
}

/// The body of a block without its form; none when there is none.
std::optional<QByteArray> bodyOf(const QByteArray& data)
{
    if (data.isEmpty() || data.size() > qsizetype(kLargestBody)) {
        return std::nullopt;
    }
    if (data.front() == char(Form::Plain)) {
        return data.sliced(1);
    }
    if (data.front() != char(Form::Compressed) || data.size() < 1 + kLengthBytes) {
        return std::nullopt;
    }
    // qUncompress() allocates what the length says.
    const auto length = qFromBigEndian<quint32>(data.constData() + 1);
    if (length == 0 || length > kLargestBody) {
        return std::nullopt;
    }
    QByteArray body = qUncompress(data.sliced(1));
    return body.size() == qsizetype(length) ? std::optional(std::move(body)) : std::nullopt;
}

constexpr std::array<quint32, 256> crcTable()
{
    constexpr quint32 kPolynomial = 0xEDB8'8320;
    std::array<quint32, 256> table{};
    for (quint32 i = 0; i < table.size(); ++i) {
        quint32 entry = i;
        for (int bit = 0; bit < 8; ++bit) {
            entry = (entry & 1U) != 0U ? kPolynomial ^ (entry >> 1U) : entry >> 1U;
        }
        table[i] = entry;
    }
    return table;
}

} // namespace

void SampleRun::clear()
{
    ticks.clear();
    values.clear();
    gaps.clear();
}

const std::vector<int>& streamsOf(Source source)
{
    static const auto kStreamsOf = [] {
        std::array<std::vector<int>, kSourceCount> all;
        int index = 0;
        for (const StreamRow& row : streams()) {
            all[row.source.index()].push_back(index++);
        }
        return all;
    }();
    return kStreamsOf[source.index()];
}

std::vector<ColumnSummary> summarise(Source source, const SampleRun& run)
{
    const auto& columns = streamsOf(source);
    std::vector<ColumnSummary> summaries(columns.size());
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const auto invalid = streams()[std::size_t(columns[column])].invalid;
        ColumnSummary& summary = summaries[column];
        for (std::size_t i = column; i < run.values.size(); i += columns.size()) {
            const std::uint16_t value = run.values[i];
            if (value != invalid) {
                summary.extent.add({value, value});
                summary.sum += value;
                ++summary.valid;
            }
        }
    }
    return summaries;
}

QByteArray encodeBlock(Source source, const SampleRun& run, bool isFinal)
{
    Packer body;
    Tick before = 0;
    Tick stepBefore = 0;
    for (std::size_t i = 0; i < run.size(); ++i) {
        const Tick step = i == 0 ? 0 : run.ticks[i] - before;
        body.addSigned(i == 0 ? run.ticks[i] : step - stepBefore);
        before = run.ticks[i];
        stepBefore = step;
    }
    body.add(run.gaps.size());
    std::size_t gapBefore = 0;
    for (const std::size_t gap : run.gaps) {
        body.add(gap - gapBefore);
        gapBefore = gap;
    }
    const std::size_t columns = streamsOf(source).size();
    for (std::size_t column = 0; column < columns; ++column) {
        int last = 0;
        for (std::size_t i = column; i < run.values.size(); i += columns) {
            body.addSigned(run.values[i] - last);
            last = run.values[i];
        }
    }
    if (isFinal) {
        const QByteArray compressed = qCompress(body.bytes());
        if (compressed.size() < body.bytes().size()) {
            return char(Form::Compressed) + compressed;
        }
    }
    return char(Form::Plain) + body.bytes();
}

Result<SampleRun> decodeBlock(Source source, const QByteArray& data, std::size_t samples)
{
    const auto body = bodyOf(data);
    if (!body || samples == 0 || samples > kBlockSamples) {
        return fail(ErrorCode::FileMalformed);
    }
    SampleRun run;
    run.ticks.reserve(samples);
    Unpacker unpacker(*body, 0);
    takeTimes(unpacker, samples, run);
    if (unpacker.isGood()) {
        takeGaps(unpacker, samples, run);
    }
    if (unpacker.isGood()) {
        takeColumns(unpacker, source, run);
    }
    if (!unpacker.isGood() || !unpacker.isAtEnd()) {
        return fail(ErrorCode::FileMalformed);
    }
    return run;
}

quint32 crc32(const QByteArray& data)
{
    static constexpr auto kTable = crcTable();
    quint32 crc = 0xFFFF'FFFF;
    for (const char byte : data) {
        crc = kTable[(crc ^ static_cast<std::uint8_t>(byte)) & 0xFFU] ^ (crc >> 8U);
    }
    return ~crc;
}

} // namespace trex
