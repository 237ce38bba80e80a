// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/panel.h"

#include <QMainWindow>

namespace trex {

class CommandBar;
class PanelDocks;
class RecordingActions;
class Recordings;

/// The window: the row with STOP, the why-line, one dock for each row of the panel registry, menus
/// and the status bar. Knows no panel by name. GUI thread.
class MainWindow : public QMainWindow {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(MainWindow)

public:
    /// `theme` and `language` are the keys in force, ticked in their menus.
    MainWindow(PanelContext& context, Recordings& recordings, const QString& theme,
               const QString& language);
    void saveLayout();
    void bringForward(const QString& panelId);

signals:
    void closeRequested(); ///< the program stops the motors, closes the line and quits
    void themeChosen(const QString& key);
    void languageChosen(const QString& code);
    void firstFramePainted();
    void recordingChosen(const QString& path); ///< to be opened
    void comparisonChosen(const QString& path); ///< a recording to be drawn behind the curves

protected:
    void closeEvent(QCloseEvent* event) override;
    bool event(QEvent* event) override;
    QMenu* createPopupMenu() override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void makeTop();
    void makeMenus(const QString& theme, const QString& language);
    void makeRecordings(Recordings& recordings);

    PanelContext& m_context;
    CommandBar* m_commandBar = nullptr;
    PanelDocks* m_docks = nullptr;
    RecordingActions* m_recording = nullptr;
    bool m_wasPainted = false;
};

} // namespace trex
