// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recordingreader.h"

#include "protocol/codec/replies.h"
#include "protocol/storage/recordingdatabase.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QtEndian>

#include <set>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct Recording {
    Q_DECLARE_TR_FUNCTIONS(Recording)
};

// SQLite's file format: the places in the first page that say what it is.
constexpr qsizetype kHeaderBytes = 100;
constexpr qsizetype kFormatOffset = 18; // two bytes, for writing and reading: 1, with a WAL 2
constexpr qsizetype kVersionOffset = 60;
constexpr qsizetype kApplicationOffset = 68;

// SQLite's result codes (the lowest byte of an extended one).
constexpr int kCodeMask = 0xFF;
constexpr int kReadOnly = 8;
constexpr int kIoError = 10;
constexpr int kCorrupt = 11;
constexpr int kCannotOpen = 14;
constexpr int kNotADatabase = 26;

constexpr std::size_t kMostFacts = 1000;

QString textOf(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

} // namespace

RecordingReader::RecordingReader(const QString& path) : m_path(path) { }

RecordingReader::~RecordingReader() = default;

Error RecordingReader::malformed(const QString& why) const
{
    return {ErrorCode::FileMalformed, u"%1: %2"_s.arg(m_path, why)};
}

Result<std::unique_ptr<RecordingReader>> RecordingReader::open(const QString& path)
{
    std::unique_ptr<RecordingReader> reader(new RecordingReader(path));
    auto done = reader->connect().and_then([&] { return reader->readFacts(); }).and_then([&] {
        return reader->checkStreams();
    });
    if (!done) {
        return tl::make_unexpected(done.error());
    }
    reader->readBlocks();
    reader->readSummaries();
    return reader;
}

/// Looks at the header before SQLite does: what is something else is told in words.
Result<void> RecordingReader::connect()
{
    QFile file(m_path);
    if (!QFileInfo(m_path).isFile()) {
        const QString cause = QFileInfo::exists(m_path) ? Recording::tr("not a plain file")
                                                        : Recording::tr("there is no such file");
        return fail(ErrorCode::FileUnreadable, u"%1: %2"_s.arg(m_path, cause));
    }
    if (!file.open(QIODevice::ReadOnly)) {
        return fail(ErrorCode::FileUnreadable, u"%1: %2"_s.arg(m_path, file.errorString()));
    }
    const QByteArray header = file.read(kHeaderBytes);
    file.close();
    if (header.size() < kHeaderBytes || !header.startsWith("SQLite format 3")
        || qFromBigEndian<qint32>(header.constData() + kApplicationOffset)
            != kRecordingApplicationId) {
        return tl::make_unexpected(malformed(Recording::tr("not a recording")));
    }
    if (qFromBigEndian<qint32>(header.constData() + kVersionOffset) != kRecordingVersion) {
        return tl::make_unexpected(malformed(
            Recording::tr("a recording of another version; a newer program may read it")));
    }
    const bool isInWalMode = header[kFormatOffset] > 1 || header[kFormatOffset + 1] > 1;
    if (isInWalMode
        && !(QFileInfo(m_path + u"-wal"_s).isFile() && QFileInfo(m_path + u"-shm"_s).isFile())) {
        return copyAside(); // SQLite would leave what is missing beside it
    }
    auto connected = connectTo(m_path, false);
    const int code = connected || !m_database ? 0 : m_database->lastCode() & kCodeMask;
    if (code == kReadOnly || code == kIoError || code == kCannotOpen) {
        // A crash left it with its WAL, and SQLite may not write what it needs beside it.
        return copyAside();
    }
    return connected;
}

Result<void> RecordingReader::connectTo(const QString& path, bool isCopy)
{
    using Access = RecordingDatabase::Access;
    auto database = RecordingDatabase::open(path, isCopy ? Access::Repair : Access::ReadOnly);
    if (!database) {
        return tl::make_unexpected(database.error());
    }
    m_database = std::move(*database);
    auto done = Result<void>();
    // A recording of others is a stranger: nothing in it is run, pages are checked as they are
    // read.
    for (const auto& pragma : {u"PRAGMA trusted_schema=OFF"_s, u"PRAGMA cell_size_check=ON"_s,
                               u"PRAGMA mmap_size=0"_s, u"PRAGMA cache_size=-4096"_s}) {
        done = done.and_then([&] { return m_database->run(pragma); });
    }
    done = done.and_then([this] { return checkSchema(); });
    const int code = m_database->lastCode() & kCodeMask;
    if (!done && (code == kCorrupt || code == kNotADatabase)) {
        return tl::make_unexpected(malformed(Recording::tr("too damaged to be opened")));
    }
    return done;
}

/// Its rollback journal, if it has one, stays behind: SQLite removes the file that a journal names
/// as its superior, and a stranger may name any. A recording of ours is in WAL mode until it is
/// whole.
Result<void> RecordingReader::copyAside()
{
    m_database.reset();
    m_copy = std::make_unique<QTemporaryDir>();
    const QString target = m_copy->filePath(u"recording"_s);
    for (const QString& suffix : {u""_s, u"-wal"_s}) {
        if (QFileInfo(m_path + suffix).isFile() && !QFile::copy(m_path + suffix, target + suffix)) {
            return fail(ErrorCode::FileUnreadable,
                        u"%1: %2"_s.arg(m_path, Recording::tr("no room for a copy to repair")));
        }
    }
    for (const QString& suffix : {u""_s, u"-wal"_s}) {
        QFile::setPermissions(target + suffix, QFile::ReadOwner | QFile::WriteOwner);
    }
    return connectTo(target, true);
}

/// Every table of ours is there exactly as we make it: no view, no trigger, no expression of
/// others can hide behind its name.
Result<void> RecordingReader::checkSchema()
{
    const auto rows = m_database->rows(u"SELECT type, name, sql FROM sqlite_master"_s);
    if (!rows) {
        return tl::make_unexpected(rows.error());
    }
    std::set<QString> found;
    while ((*rows)->next()) {
        const QString name = (*rows)->value(1).toString();
        for (const RecordingTable& table : kRecordingTables) {
            if (name == QLatin1StringView(table.name) && (*rows)->value(0).toString() == u"table"_s
                && (*rows)->value(2).toString() == QLatin1StringView(table.sql)) {
                found.insert(name);
            }
        }
    }
    auto ended = m_database->checkEnd(**rows);
    (*rows)->finish();
    if (!ended) {
        return ended;
    }
    if (found.size() != kRecordingTables.size()) {
        return tl::make_unexpected(malformed(Recording::tr("its tables are not a recording's")));
    }
    return {};
}

Result<void> RecordingReader::readFacts()
{
    const auto rows =
        m_database->rows(u"SELECT name, substr(value,1,4096) FROM fact LIMIT %1"_s.arg(kMostFacts));
    if (!rows) {
        return tl::make_unexpected(malformed(Recording::tr("too damaged to be opened")));
    }
    while ((*rows)->next()) {
        m_facts[(*rows)->value(0).toString()] = (*rows)->value(1).toString();
    }
    (*rows)->finish();
    return {};
}

/// A source counts as known when its columns are ours, in our order.
Result<void> RecordingReader::checkStreams()
{
    const auto rows = m_database->rows(
        u"SELECT id, key, poll, position, bytes, offset, invalid FROM stream LIMIT 1000"_s);
    if (!rows) {
        return tl::make_unexpected(malformed(Recording::tr("too damaged to be opened")));
    }
    std::array<std::size_t, kSourceCount> agreeing{};
    std::array<std::size_t, kSourceCount> all{};
    while ((*rows)->next()) {
        const QSqlQuery& row = **rows;
        const QString key = row.value(2).toString();
        const auto* known =
            std::find_if(kSources.begin(), kSources.end(),
                         [&](const SourceRow& each) { return key == textOf(each.key); });
        if (known == kSources.end()) {
            m_isForeign = true;
            continue;
        }
        const auto id = known->source.index();
        const auto& columns = streamsOf(known->source);
        const auto position = row.value(3).toULongLong();
        ++all[id];
        if (position >= columns.size()) {
            continue;
        }
        const int column = columns[position];
        const StreamRow& ours = streams()[std::size_t(column)];
        const QVariant invalid = row.value(6);
        const bool isSameInvalid =
            ours.invalid ? invalid.toLongLong() == *ours.invalid : invalid.isNull();
        if (row.value(1).toString() == textOf(ours.key) && row.value(0).toLongLong() == column
            && row.value(4).toInt() == static_cast<int>(ours.width)
            && row.value(5).toInt() == ours.offset && isSameInvalid) {
            ++agreeing[id];
        }
    }
    (*rows)->finish();
    for (const SourceRow& source : kSources) {
        const auto id = source.source.index();
        const std::size_t columns = streamsOf(source.source).size();
        m_isKnown[id] = columns > 0 && agreeing[id] == columns && all[id] == columns;
        m_isForeign = m_isForeign || (columns > 0 && all[id] > 0 && !m_isKnown[id]);
    }
    return {};
}

QString RecordingReader::fact(const char* name) const
{
    const auto found = m_facts.find(QString::fromLatin1(name));
    return found == m_facts.end() ? QString() : found->second;
}

bool RecordingReader::isFinished() const
{
    return !fact(recordingfact::kEndedTick).isEmpty();
}

QDateTime RecordingReader::started() const
{
    return QDateTime::fromString(fact(recordingfact::kStartedUtc), Qt::ISODateWithMs);
}

Model RecordingReader::model() const
{
    const auto signature = parseSignature(fact(recordingfact::kSignature).toLatin1());
    return signature ? signature->model : Model::TrexJr;
}

std::optional<InputKind> RecordingReader::input() const
{
    const QString mode = fact(recordingfact::kMode);
    for (const Mode each : {Mode::Rc, Mode::Analog, Mode::SerialRc, Mode::SerialAnalog}) {
        if (mode == textOf(keyOf(each))) {
            return inputOf(each);
        }
    }
    return std::nullopt;
}

QString RecordingReader::remark() const
{
    QStringList sentences;
    if (m_damaged > 0) {
        sentences << Recording::tr("The recording is damaged: %n parts are left out.", nullptr,
                                   static_cast<int>(std::min<std::size_t>(m_damaged, 1'000'000)));
    }
    if (m_isForeign) {
        sentences << Recording::tr("The recording holds streams that this program does not know.");
    }
    if (!isFinished()) {
        sentences << Recording::tr("The recording was not ended: its last moments may be missing.");
    }
    const QString dropped = fact(recordingfact::kDropped);
    if (!dropped.isEmpty()) {
        sentences << Recording::tr("The disk was too slow: %1 events or packets are missing.")
                         .arg(dropped.left(20));
    }
    return sentences.join(u' ');
}

} // namespace trex
