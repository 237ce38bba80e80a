// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QDateTime>

#include <deque>

namespace trex {

/// Events in plain sentences with their times, the newest last; bounded. GUI thread.
class EventLog : public QAbstractTableModel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(EventLog)

public:
    enum Severity { Information = 0, Warning = 1, Failure = 2 };
    enum Column { TimeColumn, SeverityColumn, TextColumn, ColumnCount };
    struct Entry {
        QDateTime time;
        int severity = Information;
        QString text;
    };
    static constexpr int kMostEntries = 10'000;

    explicit EventLog(QObject* parent = nullptr);
    void add(int severity, const QString& text);
    void addEntry(const Entry& entry); ///< with a time of its own
    void clear();
    [[nodiscard]] QString toText() const; ///< for copy and save
    [[nodiscard]] const Entry& at(int row) const
    {
        return m_entries.at(static_cast<std::size_t>(row));
    }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::deque<Entry> m_entries;
};

} // namespace trex
