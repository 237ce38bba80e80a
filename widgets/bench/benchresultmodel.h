// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/benchanalysis.h"

#include <QAbstractTableModel>

namespace trex {

/// The results of a bench test with what the person expects of them, which is edited here. GUI
/// thread.
class BenchResultModel : public QAbstractTableModel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(BenchResultModel)

public:
    enum Column {
        TitleColumn,
        ValueColumn,
        MinimumColumn,
        MaximumColumn,
        VerdictColumn,
        ColumnCount
    };
    explicit BenchResultModel(QObject* parent = nullptr);

    void setOutcome(const std::optional<BenchOutcome>& outcome);
    [[nodiscard]] const std::optional<BenchOutcome>& outcome() const { return m_outcome; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    void expectationChanged(const QString& key, const trex::BenchExpectation& expectation);

private:
    [[nodiscard]] QVariant textOf(const BenchResult& result, int column) const;
    std::optional<BenchOutcome> m_outcome;
};

} // namespace trex
