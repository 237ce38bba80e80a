// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/linkadvice.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace trex {

/// The advice about the line, one under the other: its shape, its sentence, and a button to the
/// control that changes it. Rows are kept while the kinds stay, so that a button that has the focus
/// keeps it. GUI thread.
class AdviceList : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(AdviceList)
    Q_PROPERTY(QString kinds READ kinds)

public:
    explicit AdviceList(QWidget* parent = nullptr);
    void show(const std::vector<LinkAdvice>& advice);
    [[nodiscard]] QString kinds() const; ///< keys, with commas between; never translated

signals:
    void panelRequested(const QString& target); ///< as Panel::panelRequested()

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Row {
        LinkAdvice advice;
        QWidget* box;
        QLabel* text;
    };
    [[nodiscard]] Row makeRow(const LinkAdvice& advice, qsizetype number);
    [[nodiscard]] QPushButton* makeButton(const LinkAdvice& advice, const QString& name);
    QVBoxLayout* m_layout;
    std::vector<Row> m_rows;
};

} // namespace trex
