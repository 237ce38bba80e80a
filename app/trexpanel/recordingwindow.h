// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "protocol/storage/recordingplayer.h"
#include "protocol/telemetry/marktrack.h"
#include "protocol/telemetry/plotreferences.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/panel.h"

#include <QMainWindow>
#include <QTimer>

class QLabel;

namespace trex {

class PanelDocks;
class PlayBar;

/// A recording in the same panels as the live window, over a façade and stores of its own that the
/// player fills. Says all over that it is not live; its STOP is the live one's. GUI thread.
class RecordingWindow : public QMainWindow {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RecordingWindow)

public:
    /// `live`: what the program has once: settings, ticker, dialogs, and the controller that STOP
    /// stops.
    RecordingWindow(PanelContext& live, std::unique_ptr<RecordingReader> reader,
                    const QString& path);
    ~RecordingWindow() override;
    [[nodiscard]] PlotReferences& references() { return m_references; }

signals:
    void closed();
    void recordingChosen(const QString& path);
    void comparisonChosen(const QString& path);

protected:
    void closeEvent(QCloseEvent* event) override;
    QMenu* createPopupMenu() override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeTop(const QString& path);
    [[nodiscard]] QWidget* makeBanner(const QString& path);
    void makeMenus();
    void connectPlayer();
    void tellEvents(std::size_t begin, std::size_t end, bool isAnew);
    void askOpen(const QString& title, void (RecordingWindow::*chosen)(const QString&));
    void exportCsv(const QString& path);
    [[nodiscard]] QString dateText() const;

    PanelContext& m_live;
    TelemetryStore m_store;
    StatusLatch m_latch;
    Controller m_controller;
    DeviceSettings m_settings;
    EventLog m_log;
    MarkTrack m_marks;
    PlotReferences m_references;
    PanelContext m_context;
    std::unique_ptr<RecordingPlayer> m_player;
    PlayBar* m_playBar = nullptr;
    PanelDocks* m_docks = nullptr;
    QLabel* m_message = nullptr;
    QTimer m_messageTime; ///< how long it is shown
    bool m_isTelling = false; ///< what the log gets is the recording's
};

} // namespace trex
