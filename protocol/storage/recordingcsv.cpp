// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recordingcsv.h"

#include "protocol/savefile.h"
#include "protocol/storage/recordingblock.h"

#include <QCoreApplication>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kTimeDecimals = 5; // the store's tick is 10 µs
constexpr Tick kLongestRow = std::chrono::milliseconds(100) / TimeAxis::kTick;

/// A second number of a column: scaled, with a unit.
struct Physical {
    const char* unit = nullptr; ///< as in the column's name; none: no such column
    double scale = 1.0;
    int decimals = 0;
};

Physical physicalOf(Source source, const CsvOptions& options)
{
    if (source == PollId::Currents) {
        return {"A", amperesPerCount(options.model), 3};
    }
    if (source == PollId::RawChannels && options.input == InputKind::Rc) {
        return {"us", microsecondsFromRaw(1), 1};
    }
    if (source == PollId::RawChannels && options.input == InputKind::Analog) {
        return {"V", voltsFromRaw(1), 4};
    }
    return {};
}

/// "motor1" of "motor1-current", "channel3" of "channel3-raw", "uart_errors".
QByteArray nameOf(const StreamRow& row)
{
    QByteArray key(row.key.data(), static_cast<qsizetype>(row.key.size()));
    for (const auto* suffix : {"-current", "-raw", "-remapped"}) {
        if (key.endsWith(suffix)) {
            key.chop(static_cast<qsizetype>(qstrlen(suffix)));
        }
    }
    return key.replace('-', '_');
}

/// "link_latency_ms" of "link-latency": of what has one plain number a sample.
QByteArray plainNameOf(const StreamRow& row)
{
    const QByteArray unit(row.unit.data(), static_cast<qsizetype>(row.unit.size()));
    QByteArray name = nameOf(row);
    if (!unit.isEmpty()) {
        name += '_' + QByteArray(unit).replace("/", "per_");
    }
    return name;
}

/// One source's columns and where in its samples the rows are.
class Column {
public:
    Column(const TelemetryStore& store, Source source, const CsvOptions& options)
        : m_source(source), m_physical(physicalOf(source, options))
    {
        for (const int stream : streamsOf(source)) {
            m_series.push_back(&store.series(stream));
            m_rows.push_back(&streams()[std::size_t(stream)]);
        }
        if (!m_series.empty()) {
            m_next = m_series.front()->first();
            m_end = m_series.front()->size();
            if (options.range) {
                std::tie(m_next, m_end) =
                    m_series.front()->range(options.range->from, options.range->to);
            }
        }
    }
    [[nodiscard]] bool isEmpty() const { return m_next >= m_end; }
    [[nodiscard]] Tick tick() const { return m_series.front()->axis().tick(m_next); }
    void skip() { ++m_next; }

    void addNames(QByteArray& header) const
    {
        if (!m_source.poll()) {
            for (const StreamRow* row : m_rows) {
                header += ',' + plainNameOf(*row);
            }
            return;
        }
        const auto* kind = m_source == PollId::RemappedChannels ? "_remapped" : "_raw";
        for (const StreamRow* row : m_rows) {
            header += ',' + nameOf(*row) + kind;
        }
        for (const StreamRow* row : m_rows) {
            if (m_physical.unit != nullptr) {
                header += ',' + nameOf(*row) + '_' + m_physical.unit;
            }
        }
    }
    void addCells(QByteArray& line) const
    {
        if (!m_source.poll()) {
            addPlainCells(line);
            return;
        }
        for (std::size_t i = 0; i < m_series.size(); ++i) {
            line += ',' + QByteArray::number(m_series[i]->value(m_next) + m_rows[i]->offset);
        }
        for (std::size_t i = 0; i < m_series.size() && m_physical.unit != nullptr; ++i) {
            line += ',';
            if (m_series[i]->isValid(m_next)) {
                line += QByteArray::number(m_series[i]->value(m_next) * m_physical.scale, 'f',
                                           m_physical.decimals);
            }
        }
    }
    void addBlanks(QByteArray& line) const
    {
        line.append(qsizetype(m_series.size()) * (m_physical.unit == nullptr ? 1 : 2), ',');
    }

private:
    void addPlainCells(QByteArray& line) const
    {
        for (std::size_t i = 0; i < m_series.size(); ++i) {
            line += ',';
            if (m_series[i]->isValid(m_next)) {
                const double physical = physicalFromStored(*m_rows[i], m_series[i]->value(m_next));
                line += QByteArray::number(physical, 'f', m_rows[i]->decimals);
            }
        }
    }

    Source m_source;
    Physical m_physical;
    std::vector<const TimeSeries*> m_series;
    std::vector<const StreamRow*> m_rows;
    std::size_t m_next = 0;
    std::size_t m_end = 0;
};

std::vector<Column> columnsOf(const TelemetryStore& store, const CsvOptions& options)
{
    std::vector<Column> columns;
    for (const SourceRow& row : kSources) {
        if (options.polls[row.source.index()]) {
            Column column(store, row.source, options);
            if (!column.isEmpty()) {
                columns.push_back(std::move(column));
            }
        }
    }
    return columns;
}

/// The earliest sample that no row has; none: all are written.
std::optional<Tick> earliest(const std::vector<Column>& columns)
{
    std::optional<Tick> tick;
    for (const Column& column : columns) {
        if (!column.isEmpty()) {
            tick = std::min(tick.value_or(column.tick()), column.tick());
        }
    }
    return tick;
}

/// A row from the earliest sample up to the first source's next one (theirs begin rows, so that
/// their times are exact): each source's next sample, if it comes in that time.
QByteArray nextRow(std::vector<Column>& columns, Tick time, double seconds)
{
    Column& first = columns.front();
    const bool hasFirst = !first.isEmpty() && first.tick() == time;
    QByteArray line = QByteArray::number(seconds, 'f', kTimeDecimals);
    Tick end = time + kLongestRow;
    if (hasFirst) {
        first.addCells(line);
        first.skip();
    } else {
        first.addBlanks(line);
    }
    if (!first.isEmpty()) {
        end = std::min(end, first.tick());
    }
    for (std::size_t i = 1; i < columns.size(); ++i) {
        if (!columns[i].isEmpty() && (columns[i].tick() < end || columns[i].tick() == time)) {
            columns[i].addCells(line);
            columns[i].skip();
        } else {
            columns[i].addBlanks(line);
        }
    }
    return line + '\n';
}

} // namespace

QByteArray samplesCsvHeader(const TelemetryStore& store, const CsvOptions& options)
{
    QByteArray header("t_s");
    for (const Column& column : columnsOf(store, options)) {
        column.addNames(header);
    }
    return header + '\n';
}

Result<std::size_t> exportSamplesCsv(const QString& path, const TelemetryStore& store,
                                     const CsvOptions& options)
{
    const auto unwritable = [&path](const QString& cause) {
        return fail(ErrorCode::FileUnwritable, u"%1: %2"_s.arg(path, cause));
    };
    if (!isFileOrNew(path)) {
        return unwritable(QCoreApplication::translate("CsvExport", "not a plain file"));
    }
    SaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        return unwritable(file.errorString());
    }
    std::vector<Column> columns = columnsOf(store, options);
    file.write(samplesCsvHeader(store, options));
    const auto first = earliest(columns);
    std::size_t rows = 0;
    for (auto tick = first; tick; tick = earliest(columns)) {
        const std::chrono::duration<double> since = (*tick - *first) * TimeAxis::kTick;
        file.write(nextRow(columns, *tick, since.count()));
        ++rows;
    }
    if (!file.commit()) { // also tells of a write that failed on the way, a full disk
        return unwritable(file.errorString());
    }
    return rows;
}

} // namespace trex
