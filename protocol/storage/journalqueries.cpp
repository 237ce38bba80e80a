// SPDX-License-Identifier: GPL-3.0-or-later
// What the journal answers.
#include "protocol/storage/journalsql.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <limits>
#include <set>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

using namespace journalsql;

struct JournalText {
    Q_DECLARE_TR_FUNCTIONS(JournalText)
};

constexpr auto kColumns =
    "e.id, e.time, c.port, c.signature, c.device, e.program, e.setting, e.old_value, e.new_value, "
    "e.found_value, e.packet, e.result, e.detail, e.resolved"_L1;

JournalEntry entryFrom(const QSqlQuery& row)
{
    JournalEntry entry;
    entry.number = row.value(0).toLongLong();
    entry.time = timeFrom(row.value(1));
    entry.controller = {row.value(2).toString(), row.value(3).toString(), row.value(4).toInt()};
    entry.program = row.value(5).toString();
    entry.intent.setting = settingFromKey(row.value(6).toString()).value_or(SettingId{});
    entry.intent.before = valueFrom(row.value(7));
    entry.intent.after = valueFrom(row.value(8));
    entry.conclusion.found = valueFrom(row.value(9));
    entry.intent.packet = QByteArray::fromHex(row.value(10).toString().toLatin1());
    const auto result = resultFrom(row.value(11).toString());
    entry.isConcluded = result.has_value();
    entry.conclusion.result = result.value_or(WriteResult::Unknown);
    entry.conclusion.detail = row.value(12).toString();
    entry.resolved = timeFrom(row.value(13));
    return entry;
}

/// Rows of this controller: WHERE text and its values. What was written without asking who was
/// there (raw bytes) counts as anybody's on that port.
Result<std::pair<QString, QVariantList>>
isOf(const QSqlDatabase& database, const ControllerIdentity& controller, const QString& number)
{
    return spansOf(database, controller).map([&](const std::vector<Span>& spans) {
        QStringList parts;
        QVariantList values{controller.port, controller.signature};
        for (const Span& span : spans) {
            parts << u"(c.device IN (?, -1) AND %1 BETWEEN ? AND ?)"_s.arg(number);
            values << span.device << span.first << span.last;
        }
        return std::pair(
            u"c.port = ? AND c.signature IN (?, '') AND (%1)"_s.arg(parts.join(u" OR "_s)), values);
    });
}

} // namespace

std::optional<SettingValue> JournalEntry::valueAfter() const
{
    switch (conclusion.result) {
    case WriteResult::New:
    case WriteResult::Answered:
        return intent.after;
    case WriteResult::Old:
    case WriteResult::Refused:
        return conclusion.found ? conclusion.found : intent.before;
    case WriteResult::Other:
        return conclusion.found;
    case WriteResult::Unknown:
        break;
    }
    return std::nullopt;
}

bool JournalEntry::isOpen() const
{
    return conclusion.result == WriteResult::Unknown && resolved.isNull();
}

QString keyOf(const SettingId& setting)
{
    return setting.row != nullptr
        ? keyText(*setting.row)
        : u"calibration.%1.%2"_s.arg(keyOf(setting.input)).arg(setting.channel);
}

std::optional<SettingId> settingFromKey(const QString& key)
{
    if (const auto* const row = findParameter(QStringView(key))) {
        return SettingId{.row = row};
    }
    const QStringList parts = key.split(u'.');
    if (parts.size() != 3 || parts.at(0) != "calibration"_L1) {
        return std::nullopt;
    }
    const int channel = parts.at(2).toInt();
    for (const auto input : {InputKind::Rc, InputKind::Analog}) {
        if (parts.at(1) == keyOf(input) && channel >= 1 && channel <= kChannelCount) {
            return SettingId{.row = nullptr, .input = input, .channel = channel};
        }
    }
    return std::nullopt;
}

Result<std::vector<JournalEntry>> Journal::entries(const Filter& filter)
{
    if (!isThere()) {
        return std::vector<JournalEntry>();
    }
    if (const auto open = ready(); !open) {
        return tl::make_unexpected(open.error());
    }
    const auto database = QSqlDatabase::database(m_connection, false);
    QString where = u"e.id >= ?"_s;
    QVariantList values{filter.from};
    if (filter.controller) {
        const auto mine = isOf(database, *filter.controller, u"e.id"_s);
        if (!mine) {
            return tl::make_unexpected(mine.error());
        }
        QString of = mine->first;
        values += mine->second;
        if (filter.onlyOpen) { // it may answer under the number that an unfinished write gave it
            of = u"(%1) OR (c.port = ? AND e.setting = ? AND e.new_value = ?)"_s.arg(of);
            values << filter.controller->port << keyText(parameterRow("device-number"))
                   << QString::number(filter.controller->device);
        }
        where += u" AND (%1)"_s.arg(of);
    }
    if (filter.setting) {
        where += u" AND e.setting = ?"_s;
        values << keyOf(*filter.setting);
    }
    if (filter.onlyOpen) {
        where += u" AND (e.result IS NULL OR e.result = 'unknown') AND e.resolved IS NULL"_s;
    }
    const QString limit = filter.limit > 0 ? u" LIMIT %1"_s.arg(filter.limit) : QString();
    return run(database,
               u"SELECT %1 FROM entry e JOIN controller c ON c.id = e.controller WHERE %2"
               " ORDER BY e.id DESC%3"_s.arg(kColumns, where, limit),
               values)
        .map([](QSqlQuery query) {
            std::vector<JournalEntry> all;
            while (query.next()) {
                all.push_back(entryFrom(query));
            }
            return all;
        });
}

Result<JournalEntry> Journal::entry(qint64 number)
{
    const auto missing = [number] {
        return fail(ErrorCode::OutOfRange, JournalText::tr("journal entry %1").arg(number));
    };
    if (!isThere()) {
        return missing();
    }
    return ready()
        .and_then([&] {
            return run(QSqlDatabase::database(m_connection, false),
                       u"SELECT %1 FROM entry e JOIN controller c ON c.id = e.controller"
                       " WHERE e.id = ?"_s.arg(kColumns),
                       {number});
        })
        .and_then([&](QSqlQuery query) -> Result<JournalEntry> {
            if (!query.next()) {
                return missing();
            }
            return entryFrom(query);
        });
}

Result<std::vector<JournalEntry>> Journal::calibrationHistory(const ControllerIdentity& controller,
                                                              InputKind input, int channel)
{
    Filter filter;
    filter.controller = controller;
    filter.setting = SettingId{.row = nullptr, .input = input, .channel = channel};
    return entries(filter);
}

Result<std::vector<Checkpoint>>
Journal::checkpoints(const std::optional<ControllerIdentity>& controller)
{
    if (!isThere()) {
        return std::vector<Checkpoint>();
    }
    if (const auto open = ready(); !open) {
        return tl::make_unexpected(open.error());
    }
    const auto database = QSqlDatabase::database(m_connection, false);
    QString where = u"1"_s;
    QVariantList values;
    if (controller) {
        const auto mine = isOf(database, *controller, u"p.last_entry + 1"_s);
        if (!mine) {
            return tl::make_unexpected(mine.error());
        }
        std::tie(where, values) = *mine;
    }
    return run(database,
               u"SELECT p.id, p.time, c.port, c.signature, c.device, p.name, p.last_entry, f.json"
               " FROM checkpoint p JOIN controller c ON c.id = p.controller"
               " JOIN configuration f ON f.id = p.configuration WHERE %1 ORDER BY p.id DESC"_s.arg(
                   where),
               values)
        .and_then([this](QSqlQuery query) -> Result<std::vector<Checkpoint>> {
            std::vector<Checkpoint> all;
            while (query.next()) {
                auto configuration = parseConfiguration(query.value(7).toByteArray(), m_path);
                if (!configuration) {
                    return tl::make_unexpected(configuration.error());
                }
                configuration->saved = timeFrom(query.value(1));
                all.push_back(
                    {query.value(0).toLongLong(),
                     timeFrom(query.value(1)),
                     {query.value(2).toString(), query.value(3).toString(), query.value(4).toInt()},
                     query.value(5).toString(),
                     query.value(6).toLongLong(),
                     *configuration});
            }
            return all;
        });
}

Result<Checkpoint> Journal::checkpoint(const ControllerIdentity& controller, const QString& name)
{
    return checkpoints(controller)
        .and_then([&](const std::vector<Checkpoint>& all) -> Result<Checkpoint> {
            const auto found = std::ranges::find(all, name, &Checkpoint::name);
            if (found == all.end()) {
                return fail(ErrorCode::OutOfRange,
                            JournalText::tr("no checkpoint is named %1").arg(name));
            }
            return *found;
        });
}

namespace {

void put(Configuration& state, const SettingId& setting, const std::optional<SettingValue>& value)
{
    if (setting.row != nullptr) {
        if (value) {
            state.parameters[setting.row->number] = std::get<int>(*value);
        } else {
            state.parameters.erase(setting.row->number);
        }
    } else if (value) {
        state.calibrations[setting.input][setting.channel] = std::get<Calibration>(*value);
    } else {
        state.calibrations[setting.input].erase(setting.channel);
    }
}

bool holds(const Configuration& state, const SettingId& setting)
{
    if (setting.row != nullptr) {
        return state.parameters.contains(setting.row->number);
    }
    const auto set = state.calibrations.find(setting.input);
    return set != state.calibrations.end() && set->second.contains(setting.channel);
}

bool isReset(const JournalEntry& entry)
{
    return entry.intent.setting.row != nullptr && entry.intent.setting.row->isTrigger;
}

bool mayHaveHappened(const JournalEntry& entry)
{
    return entry.conclusion.result != WriteResult::Refused
        && entry.conclusion.result != WriteResult::Old;
}

} // namespace

Result<Configuration> Journal::stateBefore(const JournalEntry& entry)
{
    const auto saved = checkpoints(entry.controller);
    if (!saved) {
        return tl::make_unexpected(saved.error());
    }
    Configuration state;
    qint64 last = 0;
    const auto found = std::ranges::find_if(
        *saved, [&](const Checkpoint& each) { return each.lastEntry < entry.number; });
    if (found != saved->end()) {
        state = found->configuration;
        last = found->lastEntry;
    }
    auto written = entries({.controller = entry.controller, .setting = {}, .from = last + 1});
    if (!written) {
        return tl::make_unexpected(written.error());
    }
    std::ranges::reverse(*written);
    for (const JournalEntry& each : *written) {
        if (isReset(each) && mayHaveHappened(each)) {
            if (each.number >= entry.number) {
                break; // what is read after a reset says nothing of before
            }
            state.parameters.clear();
        } else if (each.number < entry.number) {
            put(state, each.intent.setting, each.valueAfter());
        } else if (each.intent.before
                   && (each.number == entry.number || !holds(state, each.intent.setting))) {
            put(state, each.intent.setting, each.intent.before);
        }
    }
    state.signature = entry.controller.signature;
    state.saved = entry.time;
    return state;
}

} // namespace trex
