// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/benchprofile.h"

#include <QAbstractTableModel>

namespace trex {

/// The steps of a profile as a table, repetitions opened: what they repeat stands below them,
/// indented. GUI thread.
class BenchStepModel : public QAbstractTableModel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(BenchStepModel)

public:
    enum Column { NumberColumn, StepColumn, MotorColumn, WhatColumn, TimeColumn, ColumnCount };
    explicit BenchStepModel(QObject* parent = nullptr);

    void setSteps(const std::vector<BenchStep>& steps);
    [[nodiscard]] const std::vector<BenchStep>& steps() const { return m_steps; }
    [[nodiscard]] const BenchStep& step(int row) const;
    void replace(int row, const BenchStep& step); ///< keeps what a repetition repeats
    /// Behind this row's step, or into it when it repeats nothing yet; −1: at the end. Returns the
    /// row of the new step.
    int insert(int row, const BenchStep& step);
    void remove(int row);
    int move(int row, int by); ///< within its list; returns the new row

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

signals:
    void edited();

private:
    using Path = std::vector<std::size_t>; ///< index in each list, outermost first
    void enlist(const std::vector<BenchStep>& steps, const Path& before);
    void rebuild();
    [[nodiscard]] std::vector<BenchStep>& listOf(const Path& path);
    [[nodiscard]] int rowOf(const Path& path) const;

    std::vector<BenchStep> m_steps;
    std::vector<Path> m_rows;
};

/// "Ramp", "Set" …: what a step does, for people.
[[nodiscard]] QString titleOf(BenchAction action);
[[nodiscard]] QString titleOf(BenchMotor motor);
[[nodiscard]] QString titleOf(BenchCondition condition);
/// "to 60", "until the current is above 1.2 A": what it does it with.
[[nodiscard]] QString textOf(const BenchStep& step);

} // namespace trex
