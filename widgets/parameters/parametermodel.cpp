// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametermodel.h"

#include "protocol/errortext.h"
#include "widgets/common/theme.h"
#include "widgets/parameters/parametersign.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <QSize>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr quintptr kGroupId = 0; ///< internal id of a group; a parameter has its group's row + 1

} // namespace

ParameterModel::ParameterModel(QObject* parent) : QAbstractItemModel(parent)
{
    for (const auto& row : kParameters) {
        if (row.isTrigger) {
            continue;
        }
        auto found = std::ranges::find_if(m_groups, [&row](const Group& group) {
            return QLatin1StringView(group.title) == QLatin1StringView(row.group);
        });
        if (found == m_groups.end()) {
            found = m_groups.insert(m_groups.end(), {row.group, {}});
        }
        found->rows.push_back(&row);
    }
}

const ParameterRow* ParameterModel::rowAt(const QModelIndex& index)
{
    if (!index.isValid() || index.internalId() == kGroupId) {
        return nullptr;
    }
    const auto* const model = qobject_cast<const ParameterModel*>(index.model());
    return model == nullptr
        ? nullptr
        : model->m_groups.at(index.internalId() - 1).rows.at(static_cast<std::size_t>(index.row()));
}

QModelIndex ParameterModel::indexOf(std::uint8_t number, int column) const
{
    for (std::size_t group = 0; group < m_groups.size(); ++group) {
        const auto& rows = m_groups[group].rows;
        const auto found = std::ranges::find(rows, number, &ParameterRow::number);
        if (found != rows.end()) {
            return createIndex(static_cast<int>(found - rows.begin()), column, group + 1);
        }
    }
    return {};
}

std::optional<int> ParameterModel::device(std::uint8_t number) const
{
    const auto found = m_device.find(number);
    return found == m_device.end() ? std::nullopt : std::optional(found->second);
}

std::optional<int> ParameterModel::shown(std::uint8_t number) const
{
    const auto found = m_edits.find(number);
    return found == m_edits.end() ? device(number) : std::optional(found->second);
}

bool ParameterModel::isEdited(std::uint8_t number) const
{
    return m_edits.contains(number);
}

ParameterModel::State ParameterModel::state(std::uint8_t number) const
{
    if (m_refusals.contains(number)) {
        return State::Refused;
    }
    if (isEdited(number)) {
        return State::Edited;
    }
    if (!device(number)) {
        return State::Unread;
    }
    if (m_pending.contains(number)) {
        return State::Pending;
    }
    if (std::ranges::any_of(m_advice, [number](const Advice& advice) {
            return advice.parameter == number && !advice.isAboutChange;
        })) {
        return State::Advised;
    }
    return *device(number) == findParameter(int{number})->defaultRaw ? State::AtDefault
                                                                     : State::Differs;
}

QStringList ParameterModel::advice(std::uint8_t number) const
{
    QStringList sentences;
    for (const auto& each : m_advice) {
        if (each.parameter == number) {
            sentences << each.text;
        }
    }
    return sentences;
}

QStringList ParameterModel::remarks(std::uint8_t number) const
{
    QStringList remarks;
    if (const auto refusal = m_refusals.find(number); refusal != m_refusals.end()) {
        remarks << refusal->second;
    }
    if (m_pending.contains(number)) {
        remarks << tr("Stored, but not in force before the controller's power is switched off and "
                      "on.");
    }
    remarks += advice(number);
    return remarks;
}

ParameterValues ParameterModel::wanted() const
{
    ParameterValues values = m_edits;
    values.insert(m_device.begin(), m_device.end()); // keeps the edits
    return values;
}

Result<void> ParameterModel::edit(std::uint8_t number, int raw)
{
    const auto* const row = findParameter(int{number});
    if (row == nullptr || row->isTrigger || !accepts(*row, raw)) {
        return row == nullptr ? fail(ErrorCode::BadParameterNumber)
                              : outOfRange(row->key, raw, row->minimum, row->maximum);
    }
    const bool same = device(number) == raw;
    if (same ? m_edits.erase(number) == 0 : shown(number) == raw && isEdited(number)) {
        rowChanged(number);
        return {};
    }
    if (!same) {
        m_edits[number] = raw;
    }
    m_refusals.erase(number);
    rowChanged(number);
    emit editsChanged();
    return {};
}

void ParameterModel::revert()
{
    const auto edits = std::exchange(m_edits, {});
    const auto refusals = std::exchange(m_refusals, {});
    for (const auto& [number, raw] : edits) {
        rowChanged(number);
    }
    for (const auto& [number, sentence] : refusals) {
        rowChanged(number);
    }
    emit editsChanged();
}

void ParameterModel::setDevice(std::uint8_t number, std::optional<int> raw)
{
    const auto before = device(number);
    if (raw) {
        m_device[number] = *raw;
    } else {
        m_device.erase(number);
    }
    const auto edit = m_edits.find(number);
    if (edit != m_edits.end() && raw == edit->second) {
        m_edits.erase(edit); // it has arrived
        m_refusals.erase(number);
        emit editsChanged();
    }
    if (before != raw || raw) {
        rowChanged(number);
    }
}

void ParameterModel::setPending(std::uint8_t number, bool pending)
{
    if (pending ? m_pending.insert(number).second : m_pending.erase(number) > 0) {
        rowChanged(number);
    }
}

void ParameterModel::setAdvice(const std::vector<Advice>& advice)
{
    if (m_advice == advice) {
        return;
    }
    const auto before = std::exchange(m_advice, advice);
    for (const auto& each : before) {
        rowChanged(each.parameter);
    }
    for (const auto& each : advice) {
        rowChanged(each.parameter);
    }
}

void ParameterModel::setRefusal(std::uint8_t number, const QString& sentence)
{
    m_refusals[number] = sentence;
    rowChanged(number);
}

void ParameterModel::clearRefusals()
{
    for (const auto& [number, sentence] : std::exchange(m_refusals, {})) {
        rowChanged(number);
    }
}

void ParameterModel::refreshAll()
{
    for (const auto& row : kParameters) {
        rowChanged(row.number);
    }
}

void ParameterModel::rowChanged(std::uint8_t number)
{
    const QModelIndex first = indexOf(number, 0);
    if (first.isValid()) {
        emit dataChanged(first, first.siblingAtColumn(ColumnCount - 1));
        emit shownChanged(number);
    }
}

QModelIndex ParameterModel::index(int row, int column, const QModelIndex& parent) const
{
    if (!hasIndex(row, column, parent)) {
        return {};
    }
    return createIndex(row, column,
                       parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : kGroupId);
}

QModelIndex ParameterModel::parent(const QModelIndex& child) const
{
    if (!child.isValid() || child.internalId() == kGroupId) {
        return {};
    }
    return createIndex(static_cast<int>(child.internalId()) - 1, 0, kGroupId);
}

int ParameterModel::rowCount(const QModelIndex& parent) const
{
    if (!parent.isValid()) {
        return static_cast<int>(m_groups.size());
    }
    return parent.internalId() == kGroupId && parent.column() == 0
        ? static_cast<int>(m_groups.at(static_cast<std::size_t>(parent.row())).rows.size())
        : 0;
}

int ParameterModel::columnCount(const QModelIndex& /*parent*/) const
{
    return ColumnCount;
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex& index) const
{
    const auto* const row = rowAt(index);
    if (row == nullptr) {
        return index.isValid() ? Qt::ItemIsEnabled : Qt::NoItemFlags;
    }
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
}

QVariant ParameterModel::data(const QModelIndex& index, int role) const
{
    const auto* const row = rowAt(index);
    if (row == nullptr) {
        const bool isTitle = index.isValid() && index.column() == 0;
        if (isTitle && role == Qt::DisplayRole) {
            const auto& group = m_groups.at(static_cast<std::size_t>(index.row()));
            return QCoreApplication::translate("Parameters", group.title);
        }
        if (isTitle && role == Qt::SizeHintRole) {
            constexpr int kRoomAbove = 12;
            return QSize(0, QFontMetrics(boldFont()).height() + kRoomAbove);
        }
        return isTitle && role == Qt::FontRole ? QVariant(boldFont()) : QVariant();
    }
    const auto value = shown(row->number);
    switch (role) {
    case Qt::DisplayRole:
        return text(*row, index.column());
    case Qt::AccessibleTextRole:
        return index.column() == ValueColumn ? (value ? valueWithRaw(*row, *value) : tr("not read"))
                                             : text(*row, index.column());
    case Qt::EditRole:
        return index.column() == ValueColumn && value ? QVariant(*value) : QVariant();
    case Qt::ToolTipRole:
        return toolTip(*row);
    case Qt::DecorationRole:
        return index.column() == TitleColumn ? QVariant(parameterSign(state(row->number)))
                                             : QVariant();
    case Qt::FontRole:
        return index.column() == TitleColumn && isEdited(row->number) ? QVariant(boldFont())
                                                                      : QVariant();
    case Qt::ForegroundRole:
        return parameterColour(state(row->number), index.column());
    default:
        return {};
    }
}

bool ParameterModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const auto* const row = rowAt(index);
    bool isNumber = false;
    const int raw = value.toInt(&isNumber);
    return row != nullptr && index.column() == ValueColumn && role == Qt::EditRole && isNumber
        && edit(row->number, raw).has_value();
}

QVariant ParameterModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case TitleColumn:
        return tr("Parameter");
    case ValueColumn:
        return tr("Value");
    case DeviceColumn:
        return tr("In controller");
    case DefaultColumn:
        return tr("Default");
    case RangeColumn:
        return tr("Range");
    case StateColumn:
        return tr("State");
    default:
        return {};
    }
}

} // namespace trex
