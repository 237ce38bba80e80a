// SPDX-License-Identifier: GPL-3.0-or-later
// The journal's SQL, shared by the files of journal.h and by nobody else.
#pragma once

#include "protocol/storage/journal.h"

#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QVariant>

namespace trex::journalsql {

// A commit of the other program takes milliseconds; only one that hangs in its midst takes longer,
// and the window must not stand still for it. SQLite waits ever longer between its looks, and so
// may never see the gap between two commits: it is asked for short waits, again and again.
inline constexpr int kBusyMs = 2000;
inline constexpr int kShortWaitMs = 20;

[[nodiscard]] Error errorOf(const QSqlError& error, const QString& path);
[[nodiscard]] Result<QSqlQuery> run(const QSqlDatabase& database, const QString& sql,
                                    const QVariantList& values = {});

[[nodiscard]] QString nowText(); ///< UTC, milliseconds
[[nodiscard]] QDateTime timeFrom(const QVariant& stored);
/// NULL for what is not known.
[[nodiscard]] QVariant textOf(const std::optional<SettingValue>& value);
[[nodiscard]] std::optional<SettingValue> valueFrom(const QVariant& stored);
[[nodiscard]] std::optional<WriteResult> resultFrom(const QString& key);

/// A stretch of entries that a controller made under one device number.
struct Span {
    int device = -1;
    qint64 first = 0;
    qint64 last = 0;
};
/// All stretches of the controller that has this number now, newest first.
[[nodiscard]] Result<std::vector<Span>> spansOf(const QSqlDatabase& database,
                                                const ControllerIdentity& controller);
/// Moves the file and what belongs to it out of the way; false when it cannot.
[[nodiscard]] bool keepAside(const QString& path);

} // namespace trex::journalsql
