// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/journal.h"

#include <QAbstractTableModel>

namespace trex {

/// Journal entries in words, the newest first. GUI thread.
class JournalModel : public QAbstractTableModel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(JournalModel)

public:
    enum Column {
        TimeColumn,
        ControllerColumn,
        SettingColumn,
        ChangeColumn,
        ResultColumn,
        ColumnCount
    };

    explicit JournalModel(QObject* parent = nullptr) : QAbstractTableModel(parent) { }
    void show(std::vector<JournalEntry> entries);
    [[nodiscard]] const JournalEntry& at(int row) const
    {
        return m_entries.at(static_cast<std::size_t>(row));
    }
    [[nodiscard]] int rowOf(qint64 number) const; ///< −1: not shown

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;

private:
    std::vector<JournalEntry> m_entries;
};

/// "TReX Jr 1.2, number 7, /dev/ttyUSB0"
[[nodiscard]] QString controllerText(const ControllerIdentity& controller);
/// In the person's time zone, to the second: "2026-11-22 15:04:05".
[[nodiscard]] QString timeText(const QDateTime& utc);

} // namespace trex
