// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/plotframe.h"

#include <QAbstractTableModel>
#include <QWidget>

class QLabel;
class QTableView;

namespace trex {

class FrameTicker;
class PlotTimeline;
class PlotView;

/// What the curves of some plots are at the cursors and between them; a row a curve. GUI thread.
class MeasurementModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        Curve,
        AtA,
        AtB,
        Difference,
        Minimum,
        Mean,
        Rms,
        Maximum,
        Charge,
        Samples,
        Columns
    };

    explicit MeasurementModel(QObject* parent = nullptr) : QAbstractTableModel(parent) { }
    /// Works all figures out anew. Curves that several plots show have one row.
    void measure(const PlotTimeline& timeline, const std::vector<const PlotView*>& plots);
    [[nodiscard]] QString asText() const; ///< tab separated, with the header: for a spreadsheet

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

private:
    struct Row {
        int stream = 0;
        QColor colour;
        std::array<QString, Columns> texts;
        bool operator==(const Row&) const = default;
    };
    [[nodiscard]] static Row rowOf(const PlotFrame::Curve& curve, const PlotTimeline& timeline);
    std::vector<Row> m_rows;
};

/// The table under plots: there while a cursor is set. Figures come from the samples themselves.
class MeasurementView : public QWidget {
    Q_OBJECT

public:
    /// `name`: object name, "panel.measurement".
    MeasurementView(PlotTimeline& timeline, FrameTicker& ticker, const QString& name,
                    QWidget* parent = nullptr);
    void setPlots(std::vector<const PlotView*> plots);
    [[nodiscard]] const MeasurementModel& model() const { return *m_model; }
    void copy() const; ///< the table to the clipboard

private:
    void update();
    void applyTheme();

    PlotTimeline& m_timeline;
    MeasurementModel* m_model;
    QLabel* m_times;
    QTableView* m_table;
    std::vector<const PlotView*> m_plots;
    quint64 m_revision = 0;
    int m_ticks = 0;
};

} // namespace trex
