// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/packets/packetentry.h"

#include <QAbstractTableModel>
#include <QFont>

#include <deque>
#include <optional>

namespace trex {

/// The transactions of the session, newest last: a bounded ring, narrowed to what the filter lets
/// through. Records are taken in at once and shown by flush(), so that a view is told once a frame;
/// while paused the rows stand still and what comes is kept behind. GUI thread.
class PacketModel : public QAbstractTableModel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(PacketModel)

public:
    enum Column {
        TimeColumn,
        SentColumn,
        ReceivedColumn,
        MeaningColumn,
        RoundTripColumn,
        NoteColumn,
        ColumnCount
    };
    static constexpr int kMostRecords = 50'000;
    static constexpr int kRemovedAtOnce = 1'000; ///< the oldest go in bulk: cheaper, fewer jumps

    explicit PacketModel(QObject* parent = nullptr);

    /// Time 0 and the line of what follows; without `opened`, time 0 is the next record's.
    void startConnection(const LineSettings& line, std::optional<Instant> opened);
    void add(const std::vector<TransactionRecord>& records);
    void flush(); ///< shows what was added since, unless paused
    void setPaused(bool paused);
    [[nodiscard]] bool isPaused() const { return m_paused; }
    /// `text` is looked for in meaning, hex and key, upper and lower case alike; "" for all.
    void setFilter(const QString& text, PacketClass kind);
    void clear(); ///< forgets everything, the count of dropped ones too

    [[nodiscard]] const PacketEntry& at(int row) const; ///< of a shown row
    [[nodiscard]] int recordCount() const { return static_cast<int>(m_entries.size()); }
    [[nodiscard]] int waitingCount() const { return static_cast<int>(m_waiting.size()); }
    [[nodiscard]] quint64 droppedCount() const { return m_dropped; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation,
                        int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] bool passes(const PacketEntry& entry) const;
    [[nodiscard]] QString text(const PacketEntry& entry, int column) const;
    void dropOldest(std::size_t arriving);

    std::deque<PacketEntry> m_entries;
    std::deque<PacketEntry> m_waiting; ///< added and not shown yet
    std::deque<quint64> m_shown; ///< numbers of the entries that pass, oldest first
    quint64 m_first = 0; ///< number of m_entries.front()
    quint64 m_dropped = 0;
    std::optional<Instant> m_opened;
    LineSettings m_line;
    bool m_paused = false;
    QString m_filter;
    QFont m_digits;
    PacketClass m_class = PacketClass::All;
};

} // namespace trex
