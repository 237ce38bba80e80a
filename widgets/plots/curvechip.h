// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotlayout.h"

#include <QToolButton>

class QLabel;

namespace trex {

/// A curve in the head of its plot: a sample of its line, its name, its latest value. A click shows
/// or hides the curve; it is dragged to another plot; its menu (right button or menu key) does all
/// of that and more. GUI thread.
class CurveChip : public QToolButton {
    Q_OBJECT

public:
    explicit CurveChip(QWidget* parent = nullptr);
    void setCurve(const CurveSpec& curve);
    [[nodiscard]] const CurveSpec& curve() const { return m_curve; }
    void setValue(const QString& value); ///< "2.20 A"; "": none

    void paintTo(QPainter& painter) const; ///< as it looks at rest: for pictures
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override; ///< the line and a letter or two

signals:
    // Dragging is ours and not QDrag's, whose own event loop would keep Escape from stopping.
    void draggedTo(const QPoint& globalPosition);
    void droppedAt(const QPoint& globalPosition);
    void menuRequested(const QPoint& globalPosition);
    void removalRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    CurveSpec m_curve;
    QString m_title;
    QString m_value;
    QString m_widest; ///< the value never takes less room, so that nothing jumps
    QPoint m_pressed;
    QLabel* m_dragged = nullptr; ///< its picture under the pointer, while it is dragged
};

} // namespace trex
