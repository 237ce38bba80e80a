// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/journalsql.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>

#include <limits>

using namespace Qt::Literals::StringLiterals;

namespace trex::journalsql {
namespace {

struct JournalText {
    Q_DECLARE_TR_FUNCTIONS(JournalText)
};

// Primary result codes of SQLite (sqlite.org/rescode.html); extended ones have them in their low
// byte.
constexpr int kBusy = 5, kLocked = 6, kReadOnly = 8, kCorrupt = 11, kFull = 13, kCannotOpen = 14,
              kNotADatabase = 26;

int codeOf(const QSqlError& error)
{
    return error.nativeErrorCode().toInt() & 0xFF;
}

bool isBusy(const QSqlError& error)
{
    return codeOf(error) == kBusy || codeOf(error) == kLocked;
}

constexpr std::array<std::pair<WriteResult, QLatin1StringView>, 6> kResults{
    {{WriteResult::Unknown, "unknown"_L1},
     {WriteResult::New, "new"_L1},
     {WriteResult::Old, "old"_L1},
     {WriteResult::Other, "other"_L1},
     {WriteResult::Answered, "answered"_L1},
     {WriteResult::Refused, "refused"_L1}}};

} // namespace

Error errorOf(const QSqlError& error, const QString& path)
{
    const auto place = [&path](const QString& why) {
        return JournalText::tr("the journal %1 (%2)").arg(path, why);
    };
    switch (codeOf(error)) {
    case kCorrupt:
    case kNotADatabase:
        return {ErrorCode::FileMalformed, place(JournalText::tr("it is damaged"))};
    case kBusy:
    case kLocked:
        return {ErrorCode::FileUnwritable, place(JournalText::tr("another program holds it"))};
    case kReadOnly:
        return {ErrorCode::FileUnwritable, place(JournalText::tr("it may not be written"))};
    case kFull:
        return {ErrorCode::FileUnwritable, place(JournalText::tr("the disk is full"))};
    case kCannotOpen:
        return {ErrorCode::FileUnwritable, place(JournalText::tr("it cannot be opened"))};
    default:
        return {ErrorCode::FileUnwritable, place(error.databaseText())};
    }
}

Result<QSqlQuery> run(const QSqlDatabase& database, const QString& sql, const QVariantList& values)
{
    QSqlQuery query(database);
    query.setForwardOnly(true);
    bool isDone = query.prepare(sql);
    for (const QVariant& value : values) {
        query.addBindValue(value);
    }
    QElapsedTimer timer;
    timer.start();
    isDone = isDone && query.exec();
    while (!isDone && isBusy(query.lastError()) && !timer.hasExpired(kBusyMs)) {
        isDone = query.exec();
    }
    if (!isDone) {
        const Error error = errorOf(query.lastError(), database.databaseName());
        return fail(error.code, error.context);
    }
    return query;
}

QString nowText()
{
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs);
}

QDateTime timeFrom(const QVariant& stored)
{
    return QDateTime::fromString(stored.toString(), Qt::ISODateWithMs);
}

QVariant textOf(const std::optional<SettingValue>& value)
{
    if (!value) {
        return {};
    }
    if (const auto* const raw = std::get_if<int>(&*value)) {
        return QString::number(*raw);
    }
    const auto& c = std::get<Calibration>(*value);
    return u"%1 %2 %3 %4"_s.arg(c.minimum).arg(c.neutral).arg(c.maximum).arg(c.deadband);
}

std::optional<SettingValue> valueFrom(const QVariant& stored)
{
    std::vector<int> numbers;
    const QStringList parts = stored.toString().split(u' ', Qt::SkipEmptyParts);
    for (const QString& part : parts) {
        bool isNumber = false;
        numbers.push_back(part.toInt(&isNumber));
        if (!isNumber) {
            return std::nullopt;
        }
    }
    if (numbers.size() == 1) {
        return numbers.front();
    }
    return numbers.size() == 4
        ? std::optional<SettingValue>(Calibration{numbers[0], numbers[1], numbers[2], numbers[3]})
        : std::nullopt;
}

std::optional<WriteResult> resultFrom(const QString& key)
{
    for (const auto& [result, text] : kResults) {
        if (key == text) {
            return result;
        }
    }
    return std::nullopt;
}

Result<std::vector<Span>> spansOf(const QSqlDatabase& database,
                                  const ControllerIdentity& controller)
{
    auto changes =
        run(database,
            u"SELECT e.id, c.device, e.new_value FROM entry e"
            " JOIN controller c ON c.id = e.controller"
            " WHERE e.setting = ? AND c.port = ? AND c.signature = ?"
            " AND e.result IN ('new', 'answered') ORDER BY e.id DESC"_s,
            {keyText(parameterRow("device-number")), controller.port, controller.signature});
    if (!changes) {
        return tl::make_unexpected(changes.error());
    }
    std::vector<Span> spans;
    Span span{controller.device, 0, std::numeric_limits<qint64>::max()};
    while (changes->next()) {
        const qint64 number = changes->value(0).toLongLong();
        const int from = changes->value(1).toInt();
        const int to = changes->value(2).toInt();
        if (to == span.device && from != to) { // it got this number here
            span.first = number + 1;
            spans.push_back(span);
            span = {from, 0, number};
        } else if (from == span.device) { // another controller gave the number up
            span.first = number + 1;
            break;
        }
    }
    spans.push_back(span);
    return spans;
}

bool keepAside(const QString& path)
{
    constexpr int kMostKept = 100;
    for (int number = 1; number <= kMostKept; ++number) {
        const QString name =
            number == 1 ? path + u".damaged"_s : path + u".damaged.%1"_s.arg(number);
        if (QFileInfo::exists(name)) {
            continue;
        }
        if (!QFile::rename(path, name)) {
            return false;
        }
        for (const auto& part : {u"-wal"_s, u"-shm"_s}) { // the log belongs to the file that goes
            QFile::rename(path + part, name + part);
        }
        return true;
    }
    return false;
}

} // namespace trex::journalsql

namespace trex {

QString keyOf(WriteResult result)
{
    return journalsql::kResults.at(static_cast<std::size_t>(result)).second;
}

} // namespace trex
