// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recordingwriter.h"

#include "protocol/storage/recordingdatabase.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

QString textOf(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// SQLite's integers are signed; the driver would bind others as text.
qint64 number(std::integral auto value)
{
    return static_cast<qint64>(value);
}

/// An older recording, and what a crash left beside it: its WAL would be taken for the new file's.
Result<void> makeRoom(const QString& path)
{
    if (path.isEmpty() || (QFileInfo::exists(path) && !QFileInfo(path).isFile())) {
        const QString cause = QCoreApplication::translate("Recording", "not a plain file");
        return fail(ErrorCode::FileUnwritable, u"%1: %2"_s.arg(path, cause));
    }
    for (const QString& suffix : {u""_s, u"-wal"_s, u"-shm"_s, u"-journal"_s}) {
        QFile file(path + suffix);
        if (file.exists() && !file.remove()) {
            return fail(ErrorCode::FileUnwritable,
                        u"%1: %2"_s.arg(file.fileName(), file.errorString()));
        }
    }
    return {};
}

} // namespace

RecordingWriter::RecordingWriter(std::unique_ptr<RecordingDatabase> database)
    : m_database(std::move(database))
{
}

RecordingWriter::~RecordingWriter() = default;

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const QString& path,
                                                                 const RecordingFacts& facts)
{
    if (const auto room = makeRoom(path); !room) {
        return tl::make_unexpected(room.error());
    }
    auto database = RecordingDatabase::open(path, RecordingDatabase::Access::Create);
    if (!database) {
        return tl::make_unexpected(database.error());
    }
    std::unique_ptr<RecordingWriter> writer(new RecordingWriter(std::move(*database)));
    if (const auto ready = writer->setUp(facts); !ready) {
        return tl::make_unexpected(ready.error());
    }
    return writer;
}

Result<void> RecordingWriter::run(const QString& sql, const QVariantList& values)
{
    return m_database->run(sql, values);
}

Result<void> RecordingWriter::setUp(const RecordingFacts& facts)
{
    // The tables are made without WAL, so that the file says what it is from its first moment on.
    QStringList statements{u"PRAGMA synchronous=FULL"_s, u"BEGIN IMMEDIATE"_s,
                           u"PRAGMA application_id=%1"_s.arg(kRecordingApplicationId),
                           u"PRAGMA user_version=%1"_s.arg(kRecordingVersion)};
    for (const RecordingTable& table : kRecordingTables) {
        statements << QString::fromLatin1(table.sql);
    }
    for (const QString& statement : std::as_const(statements)) {
        if (auto done = run(statement); !done) {
            return done;
        }
    }
    for (const SourceRow& source : kSources) {
        const auto& columns = streamsOf(source.source);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const StreamRow& row = streams()[std::size_t(columns[i])];
            auto done = run(u"INSERT INTO stream VALUES(?,?,?,?,?,?,?,?,?)"_s,
                            {columns[i], textOf(row.key), textOf(source.key), static_cast<int>(i),
                             textOf(row.unit), row.scale, row.offset, static_cast<int>(row.width),
                             row.invalid ? QVariant(*row.invalid) : QVariant()});
            if (!done) {
                return done;
            }
        }
    }
    if (auto done = writeFacts(facts); !done) {
        return done;
    }
    return run(u"COMMIT"_s).and_then([this] {
        m_database->release();
        return run(u"PRAGMA journal_mode=WAL"_s);
    });
}

Result<void> RecordingWriter::write(const RecordingBatch& batch)
{
    if (batch.isEmpty()) {
        return {};
    }
    auto done =
        run(u"BEGIN IMMEDIATE"_s).and_then([&] { return writeAll(batch); }).and_then([this] {
            return run(u"COMMIT"_s);
        });
    if (!done) {
        static_cast<void>(run(u"ROLLBACK"_s));
    }
    return done;
}

Result<void> RecordingWriter::writeAll(const RecordingBatch& batch)
{
    if (auto done = writeFacts(batch.facts); !done) {
        return done;
    }
    for (const SourceRow& row : kSources) {
        if (auto done = writeRun(row.source, batch.runs[row.source.index()]); !done) {
            return done;
        }
    }
    for (const RecordedEvent& event : batch.events) {
        auto done = run(u"INSERT INTO event VALUES(NULL,?,?,?,?)"_s,
                        {number(event.tick), event.severity, event.kind, event.text});
        if (!done) {
            return done;
        }
    }
    for (const RecordedPacket& packet : batch.packets) {
        auto done = run(u"INSERT INTO packet VALUES(NULL,?,?,?,?,?,?,?)"_s,
                        {number(packet.sent), number(packet.ended), packet.priority, packet.attempt,
                         packet.error < 0 ? QVariant() : QVariant(packet.error), packet.sentBytes,
                         packet.receivedBytes});
        if (!done) {
            return done;
        }
    }
    for (const RecordedHealth& health : batch.health) {
        auto done =
            run(u"INSERT INTO health VALUES(NULL,?,?,?,?,?,?,?,?,?,?,?,?)"_s,
                {number(health.tick), number(health.transactions), number(health.retries),
                 number(health.timeouts), number(health.crcErrors), number(health.badReplies),
                 number(health.surplusBytes), number(health.resyncs), number(health.bytesSent),
                 number(health.bytesReceived), health.roundTripMs, health.transactionsPerSecond});
        if (!done) {
            return done;
        }
    }
    for (const RecordedConfiguration& recorded : batch.configurations) {
        if (auto done = writeConfiguration(recorded); !done) {
            return done;
        }
    }
    return {};
}

Result<void> RecordingWriter::writeFacts(const RecordingFacts& facts)
{
    for (const auto& [name, value] : facts) {
        if (auto done = run(u"INSERT OR REPLACE INTO fact VALUES(?,?)"_s, {name, value}); !done) {
            return done;
        }
    }
    return {};
}

Result<void> RecordingWriter::writeRun(Source source, const SampleRun& run)
{
    const std::size_t columns = streamsOf(source).size();
    OpenBlock& open = m_open[source.index()];
    auto nextGap = run.gaps.begin();
    for (std::size_t i = 0; i < run.size(); ++i) {
        const bool isFull = open.run.size() == kBlockSamples
            || (!open.run.isEmpty() && run.ticks[i] - open.run.ticks.front() >= kBlockSpan);
        if (isFull) {
            if (auto done = writeBlock(source, true); !done) {
                return done;
            }
            open = {};
        }
        if (nextGap != run.gaps.end() && *nextGap == i) {
            open.run.gaps.push_back(open.run.size());
            ++nextGap;
        }
        open.run.ticks.push_back(run.ticks[i]);
        const auto values = run.values.begin() + static_cast<std::ptrdiff_t>(i * columns);
        open.run.values.insert(open.run.values.end(), values,
                               values + static_cast<std::ptrdiff_t>(columns));
    }
    return run.isEmpty() ? Result<void>() : writeBlock(source, false);
}

/// The growing block is written again with each batch; compressed when it is full.
Result<void> RecordingWriter::writeBlock(Source source, bool isFinal)
{
    OpenBlock& open = m_open[source.index()];
    if (open.id == 0) {
        open.id = m_nextBlock++;
    }
    const QByteArray data = encodeBlock(source, open.run, isFinal);
    auto done = run(u"INSERT OR REPLACE INTO block VALUES(?,?,?,?,?,?,?)"_s,
                    {open.id, textOf(sourceRow(source).key), number(open.run.size()),
                     number(open.run.ticks.front()), number(open.run.ticks.back()),
                     number(open.run.gaps.size()), number(crc32(data))})
                    .and_then([&] {
                        return run(u"INSERT OR REPLACE INTO data VALUES(?,?)"_s, {open.id, data});
                    });
    const auto summaries = summarise(source, open.run);
    const auto& columns = streamsOf(source);
    for (std::size_t i = 0; i < columns.size() && done; ++i) {
        const ColumnSummary& summary = summaries[i];
        const bool hasValid = !summary.extent.isEmpty();
        done = run(u"INSERT OR REPLACE INTO summary VALUES(?,?,?,?,?,?)"_s,
                   {open.id, columns[i], hasValid ? QVariant(summary.extent.low) : QVariant(),
                    hasValid ? QVariant(summary.extent.high) : QVariant(), number(summary.sum),
                    number(summary.valid)});
    }
    return done;
}

Result<void> RecordingWriter::writeConfiguration(const RecordedConfiguration& recorded)
{
    const qint64 id = m_nextConfiguration++;
    const Configuration& configuration = recorded.configuration;
    const QString json = QString::fromUtf8(trex::writeConfiguration(configuration));
    std::vector<std::pair<QString, int>> settings;
    for (const ParameterRow& row : kParameters) {
        const auto found = configuration.parameters.find(row.number);
        if (found != configuration.parameters.end()) {
            settings.emplace_back(keyText(row), found->second);
        }
    }
    for (const auto& [input, channels] : configuration.calibrations) {
        for (const auto& [channel, calibration] : channels) {
            const QString key = u"calibration.%1.%2."_s.arg(keyOf(input)).arg(channel);
            settings.emplace_back(key + u"minimum"_s, calibration.minimum);
            settings.emplace_back(key + u"neutral"_s, calibration.neutral);
            settings.emplace_back(key + u"maximum"_s, calibration.maximum);
            settings.emplace_back(key + u"deadband"_s, calibration.deadband);
        }
    }
    auto done =
        run(u"INSERT INTO configuration VALUES(?,?,?)"_s, {id, number(recorded.tick), json});
    for (const auto& [key, raw] : settings) {
        done = done.and_then([&, &key = key, &raw = raw] {
            return run(u"INSERT INTO setting VALUES(?,?,?)"_s, {id, key, raw});
        });
    }
    return done;
}

Result<void> RecordingWriter::finish()
{
    auto done = run(u"BEGIN IMMEDIATE"_s);
    for (const SourceRow& row : kSources) {
        if (done && !m_open[row.source.index()].run.isEmpty()) {
            done = writeBlock(row.source, true);
        }
    }
    done = done.and_then([this] { return run(u"COMMIT"_s); });
    if (done) {
        // All is on the disk now. While somebody reads the file the rest has to wait: it stays as
        // it is, with its WAL.
        static_cast<void>(run(u"PRAGMA wal_checkpoint(TRUNCATE)"_s));
        m_database->release();
        static_cast<void>(run(u"PRAGMA journal_mode=DELETE"_s));
    }
    return done;
}

} // namespace trex
