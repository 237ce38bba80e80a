// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/mainwindow.h"

#include "app/trexpanel/aboutdialog.h"
#include "app/trexpanel/commandbar.h"
#include "app/trexpanel/languages.h"
#include "app/trexpanel/linkstatusbar.h"
#include "app/trexpanel/menus.h"
#include "app/trexpanel/paneldocks.h"
#include "app/trexpanel/stopkey.h"
#include "protocol/session/controller.h"
#include "widgets/common/uisettings.h"
#include "widgets/common/whyline.h"
#include "widgets/recording/recordinglamp.h"
#include "widgets/recording/recordingmenu.h"
#include "widgets/recording/recordings.h"

#include <QApplication>
#include <QCloseEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

MainWindow::MainWindow(PanelContext& context, Recordings& recordings, const QString& theme,
                       const QString& language)
    : m_context(context)
{
    setObjectName(u"mainWindow"_s);
    setWindowTitle(tr("TReX Panel"));
    makeTop();
    m_docks = new PanelDocks(*this, context, [](const PanelRow&) { return true; });
    setStatusBar(new LinkStatusBar(context, this));
    makeRecordings(recordings);
    makeMenus(theme, language);
    m_docks->restore(context.settings.value(settings::kGeometry),
                     context.settings.value(settings::kLayout));
    new StopKey(context.controller, this); // Esc, from anywhere
}

void MainWindow::makeTop()
{
    auto* top = new QWidget(this);
    auto* layout = new QVBoxLayout(top);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    m_commandBar = new CommandBar(m_context, top);
    auto* why = named(new WhyLine(m_context, top), u"why"_s);
    layout->addWidget(m_commandBar);
    layout->addWidget(why);
    connect(why, &WhyLine::connectRequested, m_commandBar, &CommandBar::connectToLast);
    connect(why, &WhyLine::panelRequested, this, &MainWindow::bringForward);
    connect(m_commandBar, &CommandBar::connectionWanted, this,
            [this] { bringForward(idOf(panels().front())); });

    // One widget in a tool bar that cannot be moved or hidden: STOP is always there.
    auto* bar = named(new QToolBar(tr("Commands"), this), u"toolbar"_s);
    bar->setMovable(false);
    bar->toggleViewAction()->setVisible(false);
    bar->layout()->setContentsMargins(0, 0, 0, 0);
    top->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    bar->addWidget(top);
    addToolBar(bar);
}

void MainWindow::makeRecordings(Recordings& recordings)
{
    m_recording = new RecordingActions(m_context, recordings, this);
    connect(m_recording, &RecordingActions::openRequested, this, &MainWindow::recordingChosen);
    connect(m_recording, &RecordingActions::compareRequested, this, &MainWindow::comparisonChosen);
    m_commandBar->addAction(m_recording->record());
    statusBar()->addPermanentWidget(new RecordingLamp(recordings, m_context.ticker, this));
    setAcceptDrops(true);
}

void MainWindow::makeMenus(const QString& theme, const QString& language)
{
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addActions(m_commandBar->actionsForMenu());
    file->addSeparator();
    m_recording->addTo(*file);
    file->addSeparator();
    addJournal(*file, m_context, *this);
    auto* quit = addEntry(*file, u"quit"_s, tr("&Quit"), u"quit"_s, [this] { close(); });
    quit->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Q));

    QMenu* view = menuBar()->addMenu(tr("&View"));
    m_docks->addToMenu(*view);
    view->addSeparator();
    addEntry(*view, u"resetLayout"_s, tr("Put all panels back"), u"window"_s,
             [this] { m_docks->applyDefaultLayout(); });

    addChoices(
        *menuBar()->addMenu(tr("&Theme")), u"action.theme."_s,
        {{u"system"_s, tr("As the system")}, {u"light"_s, tr("Light")}, {u"dark"_s, tr("Dark")}},
        theme, [this](const QString& key) { emit themeChosen(key); });

    addChoices(*menuBar()->addMenu(tr("&Language")), u"action.language."_s, Languages::available(),
               language, [this](const QString& code) { emit languageChosen(code); });

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    addEntry(*help, u"about"_s, tr("About and licences"), u"info"_s,
             [this] { (new AboutDialog(m_context.controller, this))->show(); });
}

void MainWindow::saveLayout()
{
    m_context.settings.set(settings::kGeometry, saveGeometry());
    m_context.settings.set(settings::kLayout, m_docks->layout());
}

void MainWindow::bringForward(const QString& panelId)
{
    m_docks->bringForward(panelId);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    event->ignore(); // the window stays until the motors have been told to stop
    emit closeRequested();
}

bool MainWindow::event(QEvent* event)
{
    const bool handled = QMainWindow::event(event);
    if (event->type() == QEvent::Paint && !m_wasPainted) {
        m_wasPainted = true;
        QTimer::singleShot(0, this, &MainWindow::firstFramePainted); // after the panels' own
    }
    return handled;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!filesIn(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event)
{
    for (const QString& path : filesIn(*event->mimeData())) {
        emit recordingChosen(path);
    }
    event->acceptProposedAction();
}

QMenu* MainWindow::createPopupMenu()
{
    return nullptr; // Qt's own would offer to hide the row with STOP
}

} // namespace trex
