// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/packetmodel.h"

#include "protocol/errortext.h"
#include "widgets/common/theme.h"

namespace trex {

using namespace Qt::Literals::StringLiterals;

PacketModel::PacketModel(QObject* parent) : QAbstractTableModel(parent) { }

void PacketModel::startConnection(const LineSettings& line, std::optional<Instant> opened)
{
    m_opened = opened;
    m_line = line;
}

void PacketModel::add(const std::vector<TransactionRecord>& records)
{
    for (const TransactionRecord& record : records) {
        m_opened = m_opened.value_or(record.sent);
        const std::chrono::duration<double> since = record.sent - *m_opened;
        m_waiting.emplace_back(record, m_line, since.count());
    }
    while (m_waiting.size() > kMostRecords) {
        m_waiting.pop_front();
        ++m_dropped;
    }
}

void PacketModel::flush()
{
    if (m_paused || m_waiting.empty()) {
        return;
    }
    m_digits = theme::font(1.0, true); // measured once a frame, not once a cell
    dropOldest(m_waiting.size());
    const quint64 next = m_first + m_entries.size();
    std::vector<quint64> passing;
    for (std::size_t i = 0; i < m_waiting.size(); ++i) {
        if (passes(m_waiting[i])) {
            passing.push_back(next + i);
        }
    }
    const auto addEntries = [this] {
        m_entries.insert(m_entries.end(), std::make_move_iterator(m_waiting.begin()),
                         std::make_move_iterator(m_waiting.end()));
        m_waiting.clear();
    };
    if (passing.empty()) {
        addEntries();
        return;
    }
    const int row = rowCount();
    beginInsertRows({}, row, row + static_cast<int>(passing.size()) - 1);
    addEntries();
    m_shown.insert(m_shown.end(), passing.begin(), passing.end());
    endInsertRows();
}

/// Makes room for what arrives, in bulk.
void PacketModel::dropOldest(std::size_t arriving)
{
    const std::size_t total = m_entries.size() + arriving;
    if (total <= kMostRecords) {
        return;
    }
    const std::size_t due = total - kMostRecords;
    const std::size_t count =
        std::min(m_entries.size(), std::max<std::size_t>(due, kRemovedAtOnce));
    const quint64 firstKept = m_first + count;
    const auto shown = std::lower_bound(m_shown.begin(), m_shown.end(), firstKept);
    const auto removedRows = static_cast<int>(shown - m_shown.begin());
    if (removedRows > 0) {
        beginRemoveRows({}, 0, removedRows - 1);
    }
    m_shown.erase(m_shown.begin(), shown);
    m_entries.erase(m_entries.begin(), m_entries.begin() + static_cast<std::ptrdiff_t>(count));
    m_first = firstKept;
    m_dropped += count;
    if (removedRows > 0) {
        endRemoveRows();
    }
}

void PacketModel::setPaused(bool paused)
{
    m_paused = paused;
    flush();
}

void PacketModel::setFilter(const QString& text, PacketClass kind)
{
    const QString needle = text.trimmed().toLower();
    if (needle == m_filter && kind == m_class) {
        return;
    }
    beginResetModel();
    m_filter = needle;
    m_class = kind;
    m_shown.clear();
    for (std::size_t i = 0; i < m_entries.size(); ++i) {
        if (passes(m_entries[i])) {
            m_shown.push_back(m_first + i);
        }
    }
    endResetModel();
}

void PacketModel::clear()
{
    beginResetModel();
    m_entries.clear();
    m_waiting.clear();
    m_shown.clear();
    m_dropped = 0;
    endResetModel();
}

bool PacketModel::passes(const PacketEntry& entry) const
{
    return entry.isOf(m_class) && (m_filter.isEmpty() || entry.contains(m_filter));
}

const PacketEntry& PacketModel::at(int row) const
{
    const quint64 number = m_shown.at(static_cast<std::size_t>(row));
    return m_entries.at(static_cast<std::size_t>(number - m_first));
}

int PacketModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

int PacketModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString PacketModel::text(const PacketEntry& entry, int column) const
{
    switch (column) {
    case TimeColumn:
        return QString::number(entry.seconds, 'f', 3);
    case SentColumn:
        return entry.sentHex();
    case ReceivedColumn:
        return entry.receivedHex();
    case MeaningColumn:
        return entry.meaning();
    case RoundTripColumn:
        return entry.roundTrip();
    case NoteColumn:
        return entry.note();
    default:
        return {};
    }
}

QVariant PacketModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid)) {
        return {};
    }
    const PacketEntry& entry = at(index.row());
    const bool isNumber = index.column() == TimeColumn || index.column() == RoundTripColumn;
    const bool isHex = index.column() == SentColumn || index.column() == ReceivedColumn;
    switch (role) {
    case Qt::DisplayRole:
        return text(entry, index.column());
    case Qt::ToolTipRole:
        if (index.column() == NoteColumn && entry.record.error) {
            return errorText({*entry.record.error, {}});
        }
        return text(entry, index.column());
    case Qt::TextAlignmentRole:
        return QVariant::fromValue((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::FontRole:
        return isNumber || isHex ? QVariant(m_digits) : QVariant();
    case Qt::DecorationRole:
        return index.column() == NoteColumn && entry.record.error
            ? QVariant(theme::icon(u"warning"_s, ColourRole::Fault))
            : QVariant();
    case Qt::ForegroundRole:
        return index.column() == NoteColumn && entry.record.error
            ? QVariant(theme::colour(ColourRole::Fault))
            : QVariant();
    default:
        return {};
    }
}

QVariant PacketModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        const bool isNumber = section == TimeColumn || section == RoundTripColumn;
        return QVariant::fromValue((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case TimeColumn:
        return tr("Time (s)");
    case SentColumn:
        return tr("Sent");
    case ReceivedColumn:
        return tr("Received");
    case MeaningColumn:
        return tr("Meaning");
    case RoundTripColumn:
        return tr("Round trip (ms)");
    case NoteColumn:
        return tr("Note");
    default:
        return {};
    }
}

} // namespace trex
