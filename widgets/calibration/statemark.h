// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/stateshape.h"

#include <QWidget>

namespace trex {

/// A state as a shape with its word beside it. GUI thread.
class StateMark : public QWidget {
    Q_OBJECT
    Q_PROPERTY(QString text READ text)

public:
    explicit StateMark(QWidget* parent = nullptr);
    /// So that nothing jumps while words change. (A minimum width would cut longer ones.)
    void setLeastWidth(int width);
    void setState(StateShape shape, const QString& text);
    [[nodiscard]] QString text() const { return m_text; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int m_least = 0;
    StateShape m_shape = StateShape::Off;
    QString m_text;
};

} // namespace trex
