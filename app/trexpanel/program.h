// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/trexpanel/languages.h"
#include "app/trexpanel/paneloptions.h"
#include "app/trexpanel/recordingfiles.h"
#include "app/trexpanel/safetywatch.h"
#include "protocol/procedures/markkeeper.h"
#include "protocol/procedures/writeaudit.h"
#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "protocol/session/serialtimeoutwatch.h"
#include "protocol/telemetry/plotreferences.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/filedialogs.h"
#include "widgets/common/frameticker.h"
#include "widgets/common/panel.h"
#include "widgets/common/uisettings.h"
#include "widgets/recording/recordings.h"

#include <QTimer>

#include <memory>

namespace trex {

class MainWindow;
class Metrics;
class ScriptPlayer;

/// Everything that lives as long as the program: the façade and its stores, the window over them,
/// the script that is played, and the one way out, which stops the motors first. GUI thread.
class Program : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Program)

public:
    explicit Program(PanelOptions options);
    ~Program() override;

    /// Shows the window and connects as told. Errors, before anything is shown: what is wrong with
    /// an option, the script or the settings file.
    [[nodiscard]] Result<void> start();
    void quit(); ///< stops the motors, closes the line (bounded), writes the report, exits
    void suspend(); ///< Ctrl+Z in the terminal: stops the motors, then the program stands still

private:
    [[nodiscard]] Result<void> prepareScript();
    [[nodiscard]] Result<OpenOptions> lineAtStart();
    void logEvents();
    void limitHistory();
    void makeWindow();
    void chooseTheme(const QString& key);
    void chooseLanguage(const QString& code);
    void onStateChanged(LinkState state);
    void finish();
    void printPictures() const;

    PanelOptions m_options;
    SettingsFile m_file;
    UiSettings m_settings;
    Languages m_languages;
    TelemetryStore m_store;
    StatusLatch m_latch;
    Controller m_controller;
    DeviceSettings m_deviceSettings;
    SerialTimeoutWatch m_timeoutWatch;
    SafetyWatch m_safety;
    Journal m_journal;
    WriteAudit m_audit;
    MarkTrack m_marks;
    MarkKeeper m_markKeeper;
    PlotReferences m_references;
    EventLog m_log;
    FrameTicker m_ticker;
    FileDialogs m_fileDialogs;
    PanelContext m_context;
    Recordings m_recordings;
    std::unique_ptr<Metrics> m_metrics;
    std::unique_ptr<ScriptPlayer> m_player;
    RecordingFiles m_recordingFiles;
    std::unique_ptr<MainWindow> m_window; ///< last: its panels use all of the above
    QTimer m_patience; ///< how long closing the line may take
    QString m_theme; ///< key in force
    bool m_isDropTold = false; ///< that the oldest samples have left the memory
    bool m_isQuitting = false;
};

} // namespace trex
