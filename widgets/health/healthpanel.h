// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/linkfacts.h"
#include "widgets/common/panel.h"

class QGridLayout;
class QLabel;
class QScrollArea;
class QSplitter;

namespace trex {

class AdviceList;
class LatencyView;

/// How well the line does: advice, how long answers take, and every figure behind both. GUI thread.
class HealthPanel : public Panel {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(HealthPanel)

public:
    explicit HealthPanel(PanelContext& context, QWidget* parent = nullptr);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    struct FigureRow {
        QLabel* title;
        QLabel* recent;
        QLabel* total; ///< null: a figure of now
    };
    [[nodiscard]] QWidget* makeFigures();
    [[nodiscard]] QWidget* makeAdvice();
    [[nodiscard]] LinkFacts facts() const;
    FigureRow& rowOf(const QString& key, const QString& title, bool isCounted);
    void refresh();
    void refreshFigures(const LinkFacts& facts);
    void arrange();
    [[nodiscard]] int figuresWidth() const;

    QSplitter* m_splitter;
    AdviceList* m_advice;
    LatencyView* m_view;
    QScrollArea* m_figures = nullptr;
    QGridLayout* m_grid = nullptr;
    QLabel* m_since = nullptr;
    std::map<QString, FigureRow> m_rows;
    int m_ticks = 0;
    bool m_isArranged = false;
};

} // namespace trex
