// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/eventlog.h"

#include "widgets/common/theme.h"

#include <algorithm>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

QString severityText(int severity)
{
    switch (severity) {
    case EventLog::Warning:
        return EventLog::tr("Warning");
    case EventLog::Failure:
        return EventLog::tr("Error");
    default:
        return EventLog::tr("Information");
    }
}

QString timeText(const QDateTime& time)
{
    return time.toString(u"yyyy-MM-dd HH:mm:ss.zzz"_s);
}

} // namespace

EventLog::EventLog(QObject* parent) : QAbstractTableModel(parent) { }

void EventLog::add(int severity, const QString& text)
{
    addEntry({.time = QDateTime::currentDateTime(), .severity = severity, .text = text});
}

void EventLog::clear()
{
    beginResetModel();
    m_entries.clear();
    endResetModel();
}

void EventLog::addEntry(const Entry& entry)
{
    if (m_entries.size() >= static_cast<std::size_t>(kMostEntries)) {
        beginRemoveRows({}, 0, 0);
        m_entries.pop_front();
        endRemoveRows();
    }
    const int row = rowCount();
    beginInsertRows({}, row, row);
    m_entries.push_back(entry);
    m_entries.back().severity = std::clamp(entry.severity, int{Information}, int{Failure});
    endInsertRows();
}

QString EventLog::toText() const
{
    QString text;
    for (const Entry& entry : m_entries) {
        text +=
            u"%1\t%2\t%3\n"_s.arg(timeText(entry.time), severityText(entry.severity), entry.text);
    }
    return text;
}

int EventLog::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

int EventLog::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int{ColumnCount};
}

QVariant EventLog::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Entry& entry = at(index.row());
    if (role == Qt::UserRole) {
        return entry.severity;
    }
    if (role == Qt::ToolTipRole) {
        return entry.text;
    }
    if (role == Qt::ForegroundRole && index.column() == SeverityColumn) {
        return theme::colour(entry.severity == Failure       ? ColourRole::Fault
                                 : entry.severity == Warning ? ColourRole::Warning
                                                             : ColourRole::DimText);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (index.column()) {
    case TimeColumn:
        return entry.time.toString(u"HH:mm:ss.zzz"_s);
    case SeverityColumn:
        return severityText(entry.severity);
    default:
        return entry.text;
    }
}

QVariant EventLog::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return QAbstractTableModel::headerData(section, orientation, role);
    }
    switch (section) {
    case TimeColumn:
        return tr("Time");
    case SeverityColumn:
        return tr("Kind");
    case TextColumn:
        return tr("Event");
    default:
        return {};
    }
}

} // namespace trex
