// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/panel.h"
#include "widgets/plots/plotlayout.h"

#include <QTimer>

#include <memory>

class QHBoxLayout;
class QTabWidget;
class QToolButton;

namespace trex {

class MeasurementView;
class PlotReferences;
class PlotStack;
class PlotTimeline;
class TriggerBar;

/// Plots of any streams over each other, with one time axis: cursors, events, trigger, runs to
/// compare with, export. Remembers its plots. Asks for what it shows while it is visible. GUI
/// thread.
class PlotsPanel : public Panel {
    Q_OBJECT

public:
    explicit PlotsPanel(PanelContext& panelContext, QWidget* parent = nullptr);
    ~PlotsPanel() override;
    Q_DISABLE_COPY_MOVE(PlotsPanel)

    [[nodiscard]] PlotTimeline& timeline() const { return *m_timeline; }
    [[nodiscard]] PlotStack& stack() const { return *m_stack; }
    [[nodiscard]] TriggerBar& trigger() const { return *m_trigger; }
    [[nodiscard]] PlotReferences& references() const { return *m_references; }
    void showSide(int tab); ///< kCurvesTab … ; −1: hides it
    static constexpr int kCurvesTab = 0;
    static constexpr int kEventsTab = 1;
    static constexpr int kCompareTab = 2;
    void freeze(); ///< what is visible becomes a reference

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    [[nodiscard]] QWidget* makeToolRow();
    void addMoveButtons(QHBoxLayout* row);
    void makeExportMenu(QToolButton* button);
    void makePlotMenu(QToolButton* button);
    [[nodiscard]] QWidget* makeCurveList();
    void makeSide();
    QToolButton* addButton(QHBoxLayout* row, const QString& objectName, const QString& icon,
                           const QString& text, const QString& toolTip);
    void connectTimeline();
    void connectContext();
    void connectStack();

    void onTick();
    void updateDevice();
    void updateLimits();
    void updateWish();
    void updateTrigger();
    void updateAnchors();
    void alignRuns(); ///< finds each run's own crossing
    void onLayoutChanged();
    void toggleCursors(bool on);

    void askExport(bool isVisiblePartOnly);
    void writeExport(const QString& path, bool isVisiblePartOnly);
    void copyPicture();
    void copySamples();
    [[nodiscard]] Result<std::size_t> writeCsv(const QString& path, bool isVisiblePartOnly);

    PlotTimeline* m_timeline;
    PlotReferences* m_references; ///< the context's, or our own
    PlotStack* m_stack = nullptr;
    TriggerBar* m_trigger = nullptr;
    MeasurementView* m_measurement = nullptr;
    QTabWidget* m_side = nullptr;
    QToolButton* m_pause = nullptr;
    QToolButton* m_back = nullptr;
    QToolButton* m_forward = nullptr;
    QToolButton* m_cursors = nullptr;
    QToolButton* m_sideButton = nullptr;
    QTimer m_saveLayout; ///< a splitter that is dragged changes often
    std::optional<Instant> m_viewAnchor; ///< left edge that frozen views lie on
    std::optional<Instant> m_searchedTo; ///< for steps of the commands
    std::optional<Instant> m_lastStep;
    int m_clears = 0;
    int m_ticks = 0;
    int m_frozen = 0; ///< views frozen so far, for their names
};

} // namespace trex
