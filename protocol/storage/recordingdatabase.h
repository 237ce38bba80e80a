// SPDX-License-Identifier: GPL-3.0-or-later
// The SQLite file of a recording. Only recordingwriter.cpp and recordingreader*.cpp read this
// header.
//
// A recording is an SQLite 3 database: application_id 0x54525852 ("TRXR"), user_version 1. Every
// `tick` counts 10 µs from the recording's origin, whose wall-clock time is the fact `started-utc`.
// protocol/storage/recording.md says the same for people, with examples.
#pragma once

#include "protocol/result.h"

#include <QSqlDatabase>
#include <QSqlQuery>

#include <array>
#include <map>
#include <memory>

namespace trex {

inline constexpr int kRecordingApplicationId = 0x54525852;
inline constexpr int kRecordingVersion = 1;

struct RecordingTable {
    const char* name;
    const char* sql; ///< stands in the file character by character; a reader accepts nothing else
};
// clang-format off
inline constexpr auto kRecordingTables = std::to_array<RecordingTable>({
    {"fact", "CREATE TABLE fact(name TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID"},
    // Which numbers the columns of a poll's blocks are: physical = (stored + offset) * scale.
    {"stream", "CREATE TABLE stream(id INTEGER PRIMARY KEY, key TEXT, poll TEXT, position INTEGER, unit TEXT, scale REAL, offset INTEGER, bytes INTEGER, invalid INTEGER)"},
    {"block", "CREATE TABLE block(id INTEGER PRIMARY KEY, poll TEXT, samples INTEGER, first INTEGER, last INTEGER, gaps INTEGER, crc INTEGER)"},
    {"summary", "CREATE TABLE summary(block INTEGER, stream INTEGER, low INTEGER, high INTEGER, total INTEGER, valid INTEGER, PRIMARY KEY(block, stream)) WITHOUT ROWID"},
    {"data", "CREATE TABLE data(block INTEGER PRIMARY KEY, samples BLOB)"},
    {"event", "CREATE TABLE event(id INTEGER PRIMARY KEY, tick INTEGER, severity INTEGER, kind TEXT, text TEXT)"},
    {"packet", "CREATE TABLE packet(id INTEGER PRIMARY KEY, sent INTEGER, ended INTEGER, priority INTEGER, attempt INTEGER, error INTEGER, sent_bytes BLOB, received_bytes BLOB)"},
    {"health", "CREATE TABLE health(id INTEGER PRIMARY KEY, tick INTEGER, transactions INTEGER, retries INTEGER, timeouts INTEGER, crc_errors INTEGER, bad_replies INTEGER, surplus_bytes INTEGER, resyncs INTEGER, bytes_sent INTEGER, bytes_received INTEGER, round_trip_ms REAL, transactions_per_second REAL)"},
    {"configuration", "CREATE TABLE configuration(id INTEGER PRIMARY KEY, tick INTEGER, json TEXT)"},
    {"setting", "CREATE TABLE setting(configuration INTEGER, key TEXT, raw INTEGER, PRIMARY KEY(configuration, key)) WITHOUT ROWID"},
});
// clang-format on

/// One connection, for the thread that made it. Every statement is prepared once.
class RecordingDatabase {
public:
    enum class Access { Create, ReadOnly, Repair };
    /// Opens, and reads or writes nothing yet. Errors: FileUnwritable (Create), else
    /// FileUnreadable.
    [[nodiscard]] static Result<std::unique_ptr<RecordingDatabase>> open(const QString& path,
                                                                         Access access);
    ~RecordingDatabase();
    Q_DISABLE_COPY_MOVE(RecordingDatabase)

    /// Runs a statement with its values; what it yields is left unread.
    [[nodiscard]] Result<void> run(const QString& sql, const QVariantList& values = {});
    /// The statement, run and ready for next(); its forward-only rows are read once. The pointer
    /// holds until the same statement is run again.
    [[nodiscard]] Result<QSqlQuery*> rows(const QString& sql, const QVariantList& values = {});
    /// Whether reading rows ended because there were no more.
    [[nodiscard]] Result<void> checkEnd(const QSqlQuery& query) const;
    /// All prepared statements go: locks are given back.
    void release() { m_statements.clear(); }
    /// SQLite's own number of the last failure: 13 full disk, 14 cannot open, …; 0: none.
    [[nodiscard]] int lastCode() const { return m_lastCode; }

private:
    RecordingDatabase(const QString& path, Access access);
    [[nodiscard]] tl::unexpected<Error> failure(const QSqlError& error) const;

    QString m_path;
    QString m_name; ///< of the connection
    Access m_access;
    QSqlDatabase m_database;
    std::map<QString, QSqlQuery> m_statements;
    mutable int m_lastCode = 0;
};

} // namespace trex
