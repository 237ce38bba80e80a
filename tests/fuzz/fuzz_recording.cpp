// SPDX-License-Identifier: GPL-3.0-or-later
// Whole recordings: a good file with other bytes in it, cut off, or with rows that no writer of
// ours makes, whose checks are right all the same; or any bytes for a file. What can be read of it
// is read by everything that reads recordings, and the file is left as it is.
#include "protocol/storage/recordingcsv.h"
#include "protocol/storage/recordingreader.h"
#include "protocol/storage/recordingwriter.h"
#include "tests/fuzz/sentence.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTemporaryDir>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;
using fuzz::holds;

namespace {

/// In memory where there is such a folder: no disk is worn out by this.
QTemporaryDir& folder()
{
    static QTemporaryDir dir(QDir(u"/dev/shm"_s).exists()
                                 ? u"/dev/shm/trex-fuzz-XXXXXX"_s
                                 : QDir::tempPath() + u"/trex-fuzz-XXXXXX"_s);
    return dir;
}
QString path()
{
    return folder().filePath(fuzz::fileName());
}

QByteArray contents()
{
    QFile file(path());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeFile(const QByteArray& bytes)
{
    QFile file(path());
    holds(file.open(QIODevice::WriteOnly | QIODevice::Truncate), "the file can be written");
    file.write(bytes);
}

/// A few samples of every source, an event, a packet, a configuration.
RecordingBatch someOfEverything()
{
    RecordingBatch batch;
    for (const SourceRow& row : kSources) {
        SampleRun& run = batch.runs[row.source.index()];
        for (int i = 0; i < 40; ++i) {
            run.ticks.push_back(1000 + i * 1250);
            for (std::size_t column = 0; column < streamsOf(row.source).size(); ++column) {
                run.values.push_back(static_cast<std::uint16_t>(i * 3 + int(column)));
            }
        }
        run.gaps = {7};
    }
    batch.events = {{10, 1, u"log"_s, u"something"_s}, {90, 0, u"stop"_s, u"Stopped"_s}};
    batch.packets = {{20, 60, 3, 1, -1, "\x8F", "\x01\x02"}, {70, 90, 1, 1, 4, "\xC2\x10", {}}};
    batch.health = {{100, 12, 1, 1, 0, 0, 0, 0, 30, 40, 1.5, 80.0}};
    Configuration configuration;
    configuration.signature = u"TReXJr1.2"_s;
    configuration.parameters = {{7, 5}};
    batch.configurations = {{0, configuration}};
    return batch;
}

QByteArray goodRecording()
{
    auto writer = RecordingWriter::create(path(),
                                          {{u"program"_s, u"fuzz"_s},
                                           {u"started-utc"_s, u"2026-11-22T14:00:00.000Z"_s},
                                           {u"signature"_s, u"TReXJr1.2"_s},
                                           {u"mode"_s, u"serial-rc"_s}});
    holds(writer && (*writer)->write(someOfEverything()) && (*writer)->finish(),
          "a recording can be written");
    return contents();
}

const QByteArray& good()
{
    static const QByteArray bytes = goodRecording();
    return bytes;
}

QVariant anyValue(fuzz::Input& input)
{
    switch (input.below(6)) {
    case 0:
        return qlonglong(input.byte());
    case 1:
        return qlonglong(input.word()) - 0x8000;
    case 2: {
        qint64 number = 0;
        for (int i = 0; i < 8; ++i) {
            number = qint64(quint64(number) << 8 | input.byte());
        }
        return number;
    }
    case 3:
        return QString::fromUtf8(input.bytes(input.byte() & 0x3F));
    case 4:
        return input.bytes(input.byte());
    default:
        return {};
    }
}

/// Rows of others, put there by SQLite itself: the pages are right, what they hold need not be.
void changeRows(fuzz::Input& input)
{
    struct Column {
        const char* table;
        const char* names;
    };
    static constexpr auto kColumns = std::to_array<Column>({
        {"fact", "name value"},
        {"stream", "id key poll position unit scale offset bytes invalid"},
        {"block", "id poll samples first last gaps crc"},
        {"summary", "block stream low high total valid"},
        {"data", "block samples"},
        {"event", "id tick severity kind text"},
        {"packet", "id sent ended priority attempt error sent_bytes received_bytes"},
        {"health", "id tick transactions retries bytes_sent round_trip_ms transactions_per_second"},
        {"configuration", "id tick json"},
        {"setting", "configuration key raw"},
    });
    writeFile(good());
    {
        QSqlDatabase database = QSqlDatabase::addDatabase(u"QSQLITE"_s, u"fuzz"_s);
        database.setDatabaseName(path());
        holds(database.open(), "the good file is a database");
        QSqlQuery query(database);
        query.exec(u"PRAGMA journal_mode=OFF"_s);
        query.exec(u"PRAGMA synchronous=OFF"_s);
        for (int i = 0; i < 6 && !input.isAtEnd(); ++i) {
            const Column& column = kColumns[std::size_t(input.below(int(kColumns.size())))];
            const QStringList names = QString::fromLatin1(column.names).split(u' ');
            const QString& name = names[input.below(int(names.size()))];
            // UPDATE OR REPLACE: a row whose key is taken takes its place.
            query.prepare(u"UPDATE OR REPLACE %1 SET %2=? WHERE rowid%3"_s.arg(
                QLatin1StringView(column.table), name,
                input.flag() ? u">0"_s : u"=%1"_s.arg(1 + input.below(8))));
            query.addBindValue(anyValue(input));
            query.exec();
        }
        // What was put into a block counts as what was written.
        QSqlQuery rows(database);
        rows.exec(u"SELECT block, samples FROM data"_s);
        std::vector<std::pair<qint64, quint32>> checks;
        while (rows.next()) {
            checks.emplace_back(rows.value(0).toLongLong(), crc32(rows.value(1).toByteArray()));
        }
        rows.finish();
        for (const auto& [id, crc] : checks) {
            query.prepare(u"UPDATE block SET crc=? WHERE id=? AND crc<>1"_s);
            query.addBindValue(qlonglong(crc));
            query.addBindValue(id);
            query.exec();
        }
    }
    QSqlDatabase::removeDatabase(u"fuzz"_s);
}

void changeBytes(fuzz::Input& input)
{
    QByteArray bytes = good();
    while (!input.isAtEnd()) {
        const qsizetype at =
            (qsizetype(input.word()) | qsizetype(input.byte()) << 16) % bytes.size();
        const int length = input.byte();
        if (length == 0xFF) {
            bytes.truncate(std::max<qsizetype>(at, 1));
        } else {
            const QByteArray piece = input.bytes(1 + (length & 0x0F));
            bytes.replace(at, std::min(piece.size(), bytes.size() - at), piece);
        }
    }
    writeFile(bytes);
}

void readAll(RecordingReader& reader)
{
    for (std::size_t i = 0; i < streams().size(); ++i) {
        for (const RecordingSpan& span : reader.overview(static_cast<int>(i))) {
            holds(span.last >= span.first && span.samples > 0, "a span is one");
        }
    }
    (void)reader.range();
    (void)reader.started();
    (void)reader.model();
    (void)reader.input();
    (void)reader.events();
    (void)reader.health();
    for (const RecordedConfiguration& each : reader.configurations()) {
        holds(!writeConfiguration(each.configuration).isEmpty(), "a configuration is one");
    }
    holds(reader.packets(0, 100).size() <= 100, "as many packets as were asked for");
    (void)reader.packetsUpTo(1000);
    TelemetryStore store;
    reader.loadAll(store, Instant(1h));
    for (const SourceRow& row : kSources) {
        for (const int stream : streamsOf(row.source)) {
            holds(store.series(stream).size() <= reader.samples(row.source),
                  "no more samples than were recorded");
        }
    }
    CsvOptions options;
    options.polls.fill(true);
    options.model = reader.model();
    options.input = reader.input();
    (void)samplesCsvHeader(store, options);
    holds(reader.remark().size() < 400, "a remark is short");
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    static QCoreApplication application(*argc, *argv);
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    switch (input.byte()) {
    case 'R':
        changeRows(input);
        break;
    case 'F':
        writeFile(input.rest());
        break;
    default:
        changeBytes(input);
        break;
    }
    const QByteArray before = contents();
    {
        auto reader = RecordingReader::open(path());
        if (reader) {
            readAll(**reader);
        } else {
            fuzz::holdsSentence(reader.error());
        }
    }
    holds(contents() == before, "a recording is left as it is");
    const QStringList left = QDir(folder().path()).entryList(QDir::Files);
    holds(left == QStringList{fuzz::fileName()}, "nothing is left beside a recording");
    return 0;
}
