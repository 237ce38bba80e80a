// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/plotview.h"
#include "widgets/plots/plotlayout.h"

#include <QWidget>

class QHBoxLayout;
class QMenu;
class QToolButton;

namespace trex {

class CurveChip;
struct PanelContext;

/// One plot of a stack: a head with its curves, and the plot under it. GUI thread.
class PlotPane : public QWidget {
    Q_OBJECT

public:
    PlotPane(PanelContext& context, PlotTimeline& timeline, QWidget* parent = nullptr);
    ~PlotPane() override;
    Q_DISABLE_COPY_MOVE(PlotPane)

    [[nodiscard]] PlotView& plot() const { return *m_plot; }
    [[nodiscard]] const std::vector<CurveSpec>& curves() const { return m_curves; }
    [[nodiscard]] bool has(const QString& key) const;
    void addCurve(const CurveSpec& curve); ///< nothing when it is there already
    std::optional<CurveSpec> takeCurve(const QString& key);
    void changeCurve(const CurveSpec& changed); ///< colour, width, visibility

    void setAmperesPerCount(double amperes);
    void setLimits(const std::vector<PlotView::Limit>& limits); ///< drawn beside currents only
    void setNumber(int number, int count); ///< from 1; for names and menus
    void setMarked(bool marked); ///< where a dragged curve would land
    void showValues(); ///< the latest of each curve, or those at the cursor

signals:
    void changed(); ///< curves or their looks
    void menuRequested(const QString& key, const QPoint& globalPosition); ///< of a curve
    void removalRequested(const QString& key);
    void curveDraggedTo(const QPoint& globalPosition);
    void curveDroppedAt(const QString& key, const QPoint& globalPosition);
    void paneMenuRequested(const QPoint& globalPosition);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] int indexOf(const QString& key) const;
    void addChip(const CurveSpec& curve);
    void refit(); ///< unit and foot of the value axis, by what is drawn
    void applyLimits();

    PanelContext& m_context;
    PlotView* m_plot;
    QHBoxLayout* m_head;
    QToolButton* m_menu;
    std::vector<CurveSpec> m_curves; ///< in the plot's order
    std::vector<CurveChip*> m_chips;
    std::vector<PlotView::Limit> m_limits;
    double m_amperesPerCount;
    bool m_isMarked = false;
};

} // namespace trex
