// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/journal/checkpointmodel.h"

#include "widgets/journal/journalmodel.h"

namespace trex {

void CheckpointModel::show(std::vector<Checkpoint> checkpoints)
{
    beginResetModel();
    m_checkpoints = std::move(checkpoints);
    endResetModel();
}

int CheckpointModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_checkpoints.size());
}

int CheckpointModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant CheckpointModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || role != Qt::DisplayRole) {
        return {};
    }
    const Checkpoint& checkpoint = at(index.row());
    switch (index.column()) {
    case TimeColumn:
        return timeText(checkpoint.time);
    case NameColumn:
        return checkpoint.name.isEmpty() ? tr("(saved before a first write)") : checkpoint.name;
    default:
        return controllerText(checkpoint.controller);
    }
}

QVariant CheckpointModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    return section == TimeColumn ? tr("Time")
        : section == NameColumn  ? tr("Name")
                                 : tr("Controller");
}

} // namespace trex
