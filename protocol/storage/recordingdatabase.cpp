// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recordingdatabase.h"

#include <QCoreApplication>
#include <QSqlError>
#include <QUuid>
#include <QVariant>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kFull = 13; // SQLITE_FULL

QString optionsFor(RecordingDatabase::Access access)
{
    const QString wait = u"QSQLITE_BUSY_TIMEOUT=2000"_s;
    return access == RecordingDatabase::Access::ReadOnly ? wait + u";QSQLITE_OPEN_READONLY"_s
                                                         : wait;
}

} // namespace

RecordingDatabase::RecordingDatabase(const QString& path, Access access)
    : m_path(path)
    , m_name(u"recording-"_s + QUuid::createUuid().toString(QUuid::WithoutBraces))
    , m_access(access)
    , m_database(QSqlDatabase::addDatabase(u"QSQLITE"_s, m_name))
{
    m_database.setDatabaseName(path);
    m_database.setConnectOptions(optionsFor(access));
}

RecordingDatabase::~RecordingDatabase()
{
    m_statements.clear();
    m_database.close();
    m_database = QSqlDatabase();
    QSqlDatabase::removeDatabase(m_name);
}

Result<std::unique_ptr<RecordingDatabase>> RecordingDatabase::open(const QString& path,
                                                                   Access access)
{
    std::unique_ptr<RecordingDatabase> database(new RecordingDatabase(path, access));
    if (!database->m_database.open()) {
        return database->failure(database->m_database.lastError());
    }
    return database;
}

tl::unexpected<Error> RecordingDatabase::failure(const QSqlError& error) const
{
    const auto code =
        m_access == Access::Create ? ErrorCode::FileUnwritable : ErrorCode::FileUnreadable;
    m_lastCode = error.nativeErrorCode().toInt();
    QString cause = error.driverText();
    if (m_lastCode == kFull) {
        cause = QCoreApplication::translate("Recording", "the disk is full");
    } else if (!error.databaseText().isEmpty()) {
        cause = error.databaseText();
    }
    return fail(code, u"%1: %2"_s.arg(m_path, cause));
}

Result<QSqlQuery*> RecordingDatabase::rows(const QString& sql, const QVariantList& values)
{
    auto found = m_statements.find(sql);
    if (found == m_statements.end()) {
        found = m_statements.emplace(sql, QSqlQuery(m_database)).first;
        found->second.setForwardOnly(true);
        if (!found->second.prepare(sql)) {
            const QSqlError error = found->second.lastError();
            m_statements.erase(found);
            return failure(error);
        }
    }
    QSqlQuery& query = found->second;
    for (qsizetype i = 0; i < values.size(); ++i) {
        query.bindValue(static_cast<int>(i), values[i]);
    }
    if (!query.exec()) {
        return failure(query.lastError());
    }
    return &query;
}

Result<void> RecordingDatabase::run(const QString& sql, const QVariantList& values)
{
    const auto query = rows(sql, values);
    if (!query) {
        return tl::make_unexpected(query.error());
    }
    (*query)->finish();
    return {};
}

Result<void> RecordingDatabase::checkEnd(const QSqlQuery& query) const
{
    if (query.lastError().type() == QSqlError::NoError) {
        return {};
    }
    return failure(query.lastError());
}

} // namespace trex
