// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/plotreferences.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace trex {

/// The runs that plots are compared with: shown or hidden, renamed, shifted, removed; how they are
/// aligned; and a button that freezes what is seen now. GUI thread.
class CompareList : public QWidget {
    Q_OBJECT

public:
    explicit CompareList(PlotReferences& references, QWidget* parent = nullptr);

signals:
    void freezeRequested();

private:
    void rebuild();
    void refresh(); ///< what each row says
    [[nodiscard]] QWidget* makeRow(std::size_t index);

    struct Row {
        int id = 0;
        QWidget* widget = nullptr;
        QLabel* note = nullptr;
    };
    PlotReferences& m_references;
    QComboBox* m_alignment;
    QLabel* m_empty;
    QVBoxLayout* m_list;
    std::vector<Row> m_rows;
};

} // namespace trex
