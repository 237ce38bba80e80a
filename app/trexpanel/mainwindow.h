// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/panel.h"

#include <QHash>
#include <QMainWindow>

class QDockWidget;

namespace trex {

class CommandBar;
class DockTitle;

/// The window: the row with STOP, the why-line, one dock for each row of the panel registry, menus
/// and the status bar. Knows no panel by name. GUI thread.
class MainWindow : public QMainWindow {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(MainWindow)

public:
    /// `theme` and `language` are the keys in force, ticked in their menus.
    MainWindow(PanelContext& context, const QString& theme, const QString& language);
    void saveLayout();
    void bringForward(const QString& panelId);

signals:
    void closeRequested(); ///< the program stops the motors, closes the line and quits
    void themeChosen(const QString& key);
    void languageChosen(const QString& code);
    void firstFramePainted();

protected:
    void closeEvent(QCloseEvent* event) override;
    bool event(QEvent* event) override;
    QMenu* createPopupMenu() override;

private:
    void makeTop();
    void makeDocks();
    void makeMenus(const QString& theme, const QString& language);
    void applyDefaultLayout();
    void fitColumns();
    void restoreLayout();
    void refreshTitles();

    PanelContext& m_context;
    CommandBar* m_commandBar = nullptr;
    QList<QDockWidget*> m_docks; ///< in the order of the registry
    QHash<QDockWidget*, DockTitle*> m_titles;
    bool m_wasPainted = false;
};

} // namespace trex
