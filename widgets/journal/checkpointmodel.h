// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/journal.h"

#include <QAbstractTableModel>

namespace trex {

/// Whole configurations that were kept, the newest first. GUI thread.
class CheckpointModel : public QAbstractTableModel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(CheckpointModel)

public:
    enum Column { TimeColumn, NameColumn, ControllerColumn, ColumnCount };

    explicit CheckpointModel(QObject* parent = nullptr) : QAbstractTableModel(parent) { }
    void show(std::vector<Checkpoint> checkpoints);
    [[nodiscard]] const Checkpoint& at(int row) const
    {
        return m_checkpoints.at(static_cast<std::size_t>(row));
    }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;

private:
    std::vector<Checkpoint> m_checkpoints;
};

} // namespace trex
