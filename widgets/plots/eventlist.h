// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/marktrack.h"

#include <QAbstractTableModel>
#include <QWidget>

class QTableView;

namespace trex {

class FrameTicker;
class PlotTimeline;

/// The marks of a track, in the order of their times. GUI thread.
class EventModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Time, Event, Columns };

    /// `track` may be null: there are none.
    EventModel(const MarkTrack* track, const PlotTimeline& timeline, QObject* parent = nullptr);
    void refresh(); ///< takes in what is new
    [[nodiscard]] const Mark& mark(int row) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    const MarkTrack* m_track;
    const PlotTimeline& m_timeline;
    std::vector<Mark> m_marks; ///< as shown
    quint64 m_revision = 0;
};

/// All events of the session; choosing one shows its moment in the plots. GUI thread.
class EventList : public QWidget {
    Q_OBJECT

public:
    EventList(const MarkTrack* track, PlotTimeline& timeline, FrameTicker& ticker,
              QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;

private:
    PlotTimeline& m_timeline;
    EventModel* m_model;
    QTableView* m_view;
};

} // namespace trex
