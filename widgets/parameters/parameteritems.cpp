// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters as rows and cells: what a view asks of parametermodel.h.
#include "widgets/common/theme.h"
#include "widgets/parameters/parametermodel.h"
#include "widgets/parameters/parametersign.h"

#include <QCoreApplication>
#include <QFontMetrics>
#include <QSize>

namespace trex {

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
        return index.column() == ValueColumn
            ? (value ? valueWithRaw(*row, *value, context(*row)) : tr("not read"))
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
    case SourceColumn:
        return tr("How sure");
    default:
        return {};
    }
}

} // namespace trex
