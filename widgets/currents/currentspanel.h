// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/csvrecorder.h"
#include "widgets/common/panel.h"

#include <QElapsedTimer>

#include <array>
#include <memory>

class QHBoxLayout;
class QToolButton;

namespace trex {

class CurrentReadOut;
class MeasurementView;
class PlotView;

/// Live plot of both motor currents with their present, peak and mean values, recording and export.
/// Asks for currents while it is visible or records. GUI thread.
class CurrentsPanel : public Panel {
    Q_OBJECT

public:
    static constexpr double kHertz =
        80.0; ///< the controller's own rate (command documentation, 0x8D)

    explicit CurrentsPanel(PanelContext& panelContext, QWidget* parent = nullptr);
    ~CurrentsPanel() override;
    Q_DISABLE_COPY_MOVE(CurrentsPanel)

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    [[nodiscard]] QWidget* makeToolRow();
    [[nodiscard]] QWidget* makeReadOutRow();
    QToolButton* addButton(QHBoxLayout* row, const QString& objectName, const QString& icon,
                           const QString& text, const QString& toolTip);
    void makeExportMenu();
    void connectPlot();
    void connectCursors();
    void connectContext();

    void onTick();
    void onStateChanged();
    void readMotorMode();
    void updateDevice(); ///< scale, joint mode, what the empty plot says
    void updateWish();
    void updateReadOuts();
    void clearSamples();
    void askExport(bool isVisiblePartOnly);
    void writeExport(const QString& path, bool isVisiblePartOnly);
    void toggleRecording();
    void startRecording(const QString& path);
    void showRecording();
    [[nodiscard]] bool isJoint() const;
    [[nodiscard]] double scale() const; ///< amperes a count, of the connected model

    CsvRecorder m_recorder;
    PlotView* m_plot;
    MeasurementView* m_measurement;
    QToolButton* m_pause = nullptr;
    QToolButton* m_cursors = nullptr;
    QToolButton* m_export = nullptr;
    QToolButton* m_record = nullptr;
    std::array<CurrentReadOut*, 2> m_readOuts{};
    std::optional<PollSample> m_latest; ///< kept when the link is lost: stale is not absent
    QElapsedTimer m_sinceReadOuts;
    QElapsedTimer m_sinceRecording;
    qint64 m_shownSecond = -1; ///< of the recording, on its button
    bool m_isReadingMode = false;
};

} // namespace trex
