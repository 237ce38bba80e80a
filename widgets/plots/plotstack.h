// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plots/plotpane.h"

#include <QScrollArea>

class QPainter;
class QSplitter;

namespace trex {

/// Plots over each other with one time axis: added, removed, put in another order, made higher or
/// lower; curves go from one to another. Their plot areas line up. GUI thread.
class PlotStack : public QScrollArea {
    Q_OBJECT

public:
    PlotStack(PanelContext& context, PlotTimeline& timeline, QWidget* parent = nullptr);
    ~PlotStack() override;
    Q_DISABLE_COPY_MOVE(PlotStack)

    void setLayoutOf(const PlotLayout& layout); ///< replaces all plots
    [[nodiscard]] PlotLayout layoutOf() const;
    [[nodiscard]] const std::vector<PlotPane*>& panes() const { return m_panes; } ///< from the top
    [[nodiscard]] std::vector<CurveSpec> visibleCurves() const; ///< each once, in order
    [[nodiscard]] PlotPane* activePane() const { return m_active; } ///< that had the focus last

    PlotPane* addPlot(const PlotSpec& spec = {}); ///< at the bottom
    void removePlot(PlotPane* pane); ///< the last one is emptied instead
    void movePlot(PlotPane* pane, int by); ///< −1: up
    void resizePlot(PlotPane* pane, int by); ///< pixels, taken from the others
    void moveCurve(const QString& key, PlotPane* from, PlotPane* to); ///< null `to`: a new plot
    void addCurve(const QString& key, PlotPane* to);
    [[nodiscard]] PlotPane* paneAt(const QPoint& globalPosition) const;
    void markPaneAt(const QPoint& globalPosition); ///< where a dragged curve would land

    void setAmperesPerCount(double amperes);
    void setLimits(const std::vector<PlotView::Limit>& limits);
    void setReferences(const PlotReferences* references);
    void setTool(PlotView::Tool tool);
    /// The trigger's level is drawn where its source is.
    void setTrigger(const QString& source, std::optional<double> level,
                    std::optional<Instant> crossing);
    void showValues();

    /// All plots as shown, over each other: for pictures.
    void renderTo(QPainter& painter);
    [[nodiscard]] QSize pictureSize() const;

signals:
    void layoutChanged();
    void levelDragged(double physical);

private:
    void wire(PlotPane* pane);
    void renumber();
    void lineUp();
    void showCurveMenu(PlotPane* pane, const QString& key, const QPoint& at);
    void showPaneMenu(PlotPane* pane, const QPoint& at);

    PanelContext& m_context;
    PlotTimeline& m_timeline;
    QSplitter* m_splitter;
    std::vector<PlotPane*> m_panes;
    PlotPane* m_active = nullptr;
    const PlotReferences* m_references = nullptr;
    std::vector<PlotView::Limit> m_limits;
    double m_amperesPerCount;
    PlotView::Tool m_tool = PlotView::Tool::Zoom;
    bool m_isLiningUp = false;
    bool m_isBuilding = false;
};

} // namespace trex
