// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/journal/journalmodel.h"

#include "protocol/codec/replies.h"
#include "protocol/procedures/writeaudit.h"
#include "widgets/common/theme.h"

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct ResultLook {
    QChar sign; ///< beside the colour
    ColourRole role;
};

ResultLook lookOf(const JournalEntry& entry)
{
    switch (entry.conclusion.result) {
    case WriteResult::New:
        return {u'✓', ColourRole::Ok};
    case WriteResult::Answered:
        return {u'✓', ColourRole::Text};
    case WriteResult::Old:
        return {u'○', ColourRole::Warning};
    case WriteResult::Refused:
        return {u'✕', ColourRole::Fault};
    case WriteResult::Other:
        return {u'▲', ColourRole::Fault};
    case WriteResult::Unknown:
        break;
    }
    return {u'▲', ColourRole::Warning};
}

QString textOf(const JournalEntry& entry, int column)
{
    switch (column) {
    case JournalModel::TimeColumn:
        return timeText(entry.time);
    case JournalModel::ControllerColumn:
        return controllerText(entry.controller);
    case JournalModel::SettingColumn:
        return titleOf(entry.intent.setting);
    case JournalModel::ChangeColumn:
        return changeText(entry);
    case JournalModel::ResultColumn:
        return u"%1 %2"_s.arg(lookOf(entry).sign).arg(resultText(entry));
    default:
        return {};
    }
}

QString toolTipOf(const JournalEntry& entry)
{
    QStringList lines{JournalModel::tr("Entry %1, written by %2 to %3")
                          .arg(entry.number)
                          .arg(entry.program, controllerText(entry.controller)),
                      u"%1: %2"_s.arg(titleOf(entry.intent.setting), changeText(entry)),
                      JournalModel::tr("Packet %1")
                          .arg(QString::fromLatin1(entry.intent.packet.toHex(' ').toUpper())),
                      resultText(entry)};
    if (entry.resolved.isValid()) {
        lines << JournalModel::tr("Found out %1").arg(timeText(entry.resolved));
    }
    if (!entry.conclusion.detail.isEmpty() && entry.conclusion.result != WriteResult::Refused) {
        lines << entry.conclusion.detail;
    }
    return lines.join(u'\n');
}

} // namespace

QString controllerText(const ControllerIdentity& controller)
{
    const auto signature = parseSignature(controller.signature.toLatin1());
    QStringList parts;
    parts << (signature ? u"%1 %2"_s.arg(signature->modelName(), signature->firmware())
                        : JournalModel::tr("not asked who it is"));
    if (controller.device >= 0) {
        parts << JournalModel::tr("number %1").arg(controller.device);
    }
    return (parts << controller.port).join(u", "_s);
}

QString timeText(const QDateTime& utc)
{
    return utc.toLocalTime().toString(u"yyyy-MM-dd HH:mm:ss"_s);
}

void JournalModel::show(std::vector<JournalEntry> entries)
{
    beginResetModel();
    m_entries = std::move(entries);
    endResetModel();
}

int JournalModel::rowOf(qint64 number) const
{
    const auto found = std::ranges::find(m_entries, number, &JournalEntry::number);
    return found == m_entries.end() ? -1 : static_cast<int>(found - m_entries.begin());
}

int JournalModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

int JournalModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant JournalModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const JournalEntry& entry = at(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return textOf(entry, index.column());
    case Qt::ToolTipRole:
        return toolTipOf(entry);
    case Qt::ForegroundRole:
        return index.column() == ResultColumn ? QVariant(theme::colour(lookOf(entry).role))
                                              : QVariant();
    default:
        return {};
    }
}

QVariant JournalModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case TimeColumn:
        return tr("Time");
    case ControllerColumn:
        return tr("Controller");
    case SettingColumn:
        return tr("Setting");
    case ChangeColumn:
        return tr("Old → new");
    case ResultColumn:
        return tr("Result");
    default:
        return {};
    }
}

} // namespace trex
