// SPDX-License-Identifier: GPL-3.0-or-later
// Opening the journal, and all that writes to it.
#include "protocol/storage/journal.h"

#include "protocol/storage/journalsql.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QLockFile>
#include <QUuid>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

using namespace journalsql;

struct JournalText {
    Q_DECLARE_TR_FUNCTIONS(JournalText)
};

constexpr qint64 kLargestChecked = qint64{64} * 1024 * 1024;

constexpr auto kSchema = std::to_array<const char*>({
    "CREATE TABLE controller(id INTEGER PRIMARY KEY, port TEXT NOT NULL, signature TEXT NOT NULL,"
    " device INTEGER NOT NULL, UNIQUE(port, signature, device))",
    "CREATE TABLE entry(id INTEGER PRIMARY KEY AUTOINCREMENT, time TEXT NOT NULL,"
    " controller INTEGER NOT NULL REFERENCES controller(id), program TEXT NOT NULL,"
    " setting TEXT NOT NULL, old_value TEXT, new_value TEXT, found_value TEXT,"
    " packet TEXT NOT NULL, result TEXT, detail TEXT, resolved TEXT)",
    "CREATE INDEX entry_setting ON entry(setting)",
    "CREATE TABLE configuration(id INTEGER PRIMARY KEY, hash TEXT NOT NULL UNIQUE,"
    " json TEXT NOT NULL)",
    "CREATE TABLE checkpoint(id INTEGER PRIMARY KEY AUTOINCREMENT, time TEXT NOT NULL,"
    " controller INTEGER NOT NULL REFERENCES controller(id), name TEXT NOT NULL,"
    " last_entry INTEGER NOT NULL, configuration INTEGER NOT NULL REFERENCES configuration(id))",
});

/// A null string would be NULL.
QVariant stored(const QString& text)
{
    return text.isNull() ? u""_s : text;
}

} // namespace

Journal::Journal(const QString& path) : m_path(path) { }

Journal::~Journal()
{
    close();
}

void Journal::close()
{
    if (!m_connection.isEmpty()) {
        QSqlDatabase::database(m_connection, false).close();
        QSqlDatabase::removeDatabase(m_connection);
        m_connection.clear();
    }
}

QString Journal::takeRemark()
{
    return std::exchange(m_remark, {});
}

bool Journal::isThere() const
{
    return !m_connection.isEmpty() || QFileInfo::exists(m_path);
}

Result<void> Journal::ready()
{
    if (!m_connection.isEmpty()) {
        return {};
    }
    auto opened = open();
    if (!opened && opened.error().code == ErrorCode::FileMalformed && keepAside(m_path)) {
        m_remark = JournalText::tr("The journal %1 is damaged: it is kept as %1.damaged, and a new "
                                   "one is begun.")
                       .arg(m_path);
        opened = open();
    }
    return opened;
}

Result<void> Journal::open()
{
    const QFileInfo info(m_path);
    const auto unusable = [this](ErrorCode code, const QString& why) {
        return fail(code, JournalText::tr("the journal %1 (%2)").arg(m_path, why));
    };
    if (!QSqlDatabase::isDriverAvailable(u"QSQLITE"_s)) {
        return unusable(ErrorCode::FileUnreadable,
                        JournalText::tr("Qt's driver for SQLite is not installed"));
    }
    if (info.exists() && !info.isFile()) { // a pipe could be read for ever
        return unusable(ErrorCode::FileUnreadable, JournalText::tr("it is no file"));
    }
    if (!QDir().mkpath(info.absolutePath())) {
        return unusable(ErrorCode::FileUnwritable, JournalText::tr("its folder cannot be made"));
    }
    // Two programs may begin the file at the same moment. Where no lock can be made, no file can
    // either, and that is said below.
    QLockFile lock(m_path + u".lock"_s);
    if (!lock.tryLock(kBusyMs) && lock.error() == QLockFile::LockFailedError) {
        return unusable(ErrorCode::FileUnwritable, JournalText::tr("another program holds it"));
    }
    m_connection = u"journal-"_s + QUuid::createUuid().toString(QUuid::WithoutBraces);
    auto verdict = [this]() -> Result<void> {
        auto database = QSqlDatabase::addDatabase(u"QSQLITE"_s, m_connection);
        database.setConnectOptions(u"QSQLITE_BUSY_TIMEOUT=%1"_s.arg(kShortWaitMs));
        database.setDatabaseName(m_path);
        if (!database.open()) {
            return tl::make_unexpected(errorOf(database.lastError(), m_path));
        }
        return prepareSchema();
    }();
    if (!verdict) {
        close();
    }
    return verdict;
}

Result<void> Journal::prepareSchema()
{
    const auto database = QSqlDatabase::database(m_connection, false);
    const auto versionOf = [&database]() -> Result<int> {
        return run(database, u"PRAGMA user_version"_s).map([](QSqlQuery query) {
            return query.next() ? query.value(0).toInt() : 0;
        });
    };
    const auto version = versionOf();
    if (!version) {
        return tl::make_unexpected(version.error());
    }
    if (*version > kVersion) {
        return fail(ErrorCode::FileUnreadable,
                    JournalText::tr("the journal %1 (it belongs to a newer version of this "
                                    "program and stays as it is)")
                        .arg(m_path));
    }
    QStringList statements{u"PRAGMA synchronous = FULL"_s, u"PRAGMA foreign_keys = ON"_s};
    if (*version == 0) {
        statements << u"PRAGMA journal_mode = WAL"_s << u"BEGIN IMMEDIATE"_s;
        for (const char* const statement : kSchema) {
            statements << QString::fromLatin1(statement);
        }
        statements << u"PRAGMA user_version = %1"_s.arg(kVersion) << u"COMMIT"_s;
    }
    for (const QString& statement : std::as_const(statements)) {
        if (const auto done = run(database, statement); !done) {
            return tl::make_unexpected(done.error());
        }
    }
    if (QFileInfo(m_path).size() > kLargestChecked) {
        return {};
    }
    return run(database, u"PRAGMA quick_check(1)"_s).and_then([this](QSqlQuery query) {
        const bool isSound = query.next() && query.value(0).toString() == "ok"_L1;
        return isSound ? Result<void>()
                       : fail(ErrorCode::FileMalformed,
                              JournalText::tr("the journal %1 (it is damaged)").arg(m_path));
    });
}

Result<qint64> Journal::controllerId(const ControllerIdentity& controller)
{
    const auto database = QSqlDatabase::database(m_connection, false);
    const QVariantList values{stored(controller.port), stored(controller.signature),
                              controller.device};
    if (const auto added = run(
            database,
            u"INSERT OR IGNORE INTO controller(port, signature, device) VALUES(?, ?, ?)"_s, values);
        !added) {
        return tl::make_unexpected(added.error());
    }
    return run(database,
               u"SELECT id FROM controller WHERE port = ? AND signature = ? AND device = ?"_s,
               values)
        .map([](QSqlQuery query) { return query.next() ? query.value(0).toLongLong() : 0; });
}

Result<qint64> Journal::intend(const ControllerIdentity& controller, const WriteIntent& intent)
{
    return ready()
        .and_then([&] { return controllerId(controller); })
        .and_then([&](qint64 id) {
            return run(
                QSqlDatabase::database(m_connection, false),
                u"INSERT INTO entry(time, controller, program, setting, old_value, new_value,"
                " packet) VALUES(?, ?, ?, ?, ?, ?, ?)"_s,
                {nowText(), id, stored(QCoreApplication::applicationName()), keyOf(intent.setting),
                 textOf(intent.before), textOf(intent.after),
                 stored(QString::fromLatin1(intent.packet.toHex().toUpper()))});
        })
        .map([](const QSqlQuery& query) { return query.lastInsertId().toLongLong(); });
}

Result<void> Journal::conclude(qint64 number, const WriteConclusion& conclusion)
{
    return ready()
        .and_then([&] {
            return run(
                QSqlDatabase::database(m_connection, false),
                u"UPDATE entry SET result = ?, found_value = ?, detail = ? WHERE id = ?"_s,
                {keyOf(conclusion.result), textOf(conclusion.found), conclusion.detail, number});
        })
        .map([](const QSqlQuery&) {});
}

Result<void> Journal::resolve(qint64 number, const WriteConclusion& conclusion)
{
    return ready()
        .and_then([&] {
            return run(QSqlDatabase::database(m_connection, false),
                       u"UPDATE entry SET result = ?, found_value = ?, resolved = ? WHERE id = ?"_s,
                       {keyOf(conclusion.result), textOf(conclusion.found), nowText(), number});
        })
        .map([](const QSqlQuery&) {});
}

Result<qint64> Journal::saveCheckpoint(const ControllerIdentity& controller, const QString& name,
                                       const Configuration& configuration)
{
    if (!name.isEmpty()) {
        if (const auto there = checkpoint(controller, name)) {
            return fail(ErrorCode::OutOfRange,
                        JournalText::tr("a checkpoint named %1 is there already").arg(name));
        }
    }
    Configuration content = configuration;
    content.saved = {}; // so that the same settings are stored once
    const QString json = QString::fromUtf8(writeConfiguration(content));
    const QString hash = QString::fromLatin1(
        QCryptographicHash::hash(json.toUtf8(), QCryptographicHash::Sha256).toHex());
    return ready()
        .and_then([&] { return controllerId(controller); })
        .and_then([&](qint64 id) {
            const auto database = QSqlDatabase::database(m_connection, false);
            return run(database, u"INSERT OR IGNORE INTO configuration(hash, json) VALUES(?, ?)"_s,
                       {hash, json})
                .and_then([&](const QSqlQuery&) {
                    return run(database,
                               u"INSERT INTO checkpoint(time, controller, name, last_entry,"
                               " configuration) SELECT ?, ?, ?,"
                               " (SELECT COALESCE(MAX(id), 0) FROM entry), id"
                               " FROM configuration WHERE hash = ?"_s,
                               {nowText(), id, stored(name), hash});
                });
        })
        .map([](const QSqlQuery& query) { return query.lastInsertId().toLongLong(); });
}

Result<void> Journal::removeCheckpoint(qint64 number)
{
    return ready()
        .and_then([&] {
            return run(QSqlDatabase::database(m_connection, false),
                       u"DELETE FROM checkpoint WHERE id = ?"_s, {number});
        })
        .map([](const QSqlQuery&) {});
}

} // namespace trex
