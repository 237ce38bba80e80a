// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/mainwindow.h"

#include "app/trexpanel/aboutdialog.h"
#include "app/trexpanel/commandbar.h"
#include "app/trexpanel/docktitle.h"
#include "app/trexpanel/languages.h"
#include "app/trexpanel/linkstatusbar.h"
#include "app/trexpanel/menus.h"
#include "app/trexpanel/stopkey.h"
#include "protocol/session/controller.h"
#include "widgets/common/uisettings.h"
#include "widgets/common/whyline.h"
#include "widgets/panelregistry.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMenuBar>
#include <QScreen>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr QSize kUsualSize{1440, 900};
constexpr int kSideWidth = 320;
constexpr int kLayoutVersion = 1; ///< a stored layout of another version is not restored

QString idOf(const PanelRow& row)
{
    return QString::fromUtf8(row.id.data(), static_cast<qsizetype>(row.id.size()));
}

} // namespace

MainWindow::MainWindow(PanelContext& context, const QString& theme, const QString& language)
    : m_context(context)
{
    setObjectName(u"mainWindow"_s);
    setWindowTitle(tr("TReX Panel"));
    setDockOptions(AllowNestedDocks | AllowTabbedDocks | GroupedDragging);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setCorner(Qt::TopLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::TopRightCorner, Qt::RightDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    // Without a centre, Qt shares a window's width between the columns; with one, even this flat,
    // the middle column takes what there is to spare.
    auto* centre = new QWidget(this);
    centre->setMaximumHeight(0);
    setCentralWidget(centre);
    makeTop();
    makeDocks();
    makeMenus(theme, language);
    setStatusBar(new LinkStatusBar(context, this));
    restoreLayout();
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

void MainWindow::makeDocks()
{
    for (const PanelRow& row : panels()) {
        auto* dock = new QDockWidget(QCoreApplication::translate("Panels", row.title), this);
        dock->setObjectName(u"dock."_s + idOf(row));
        Panel* panel = named(row.make(m_context, dock), idOf(row), dock->windowTitle());
        panel->setAutoFillBackground(true);
        panel->setBackgroundRole(QPalette::Base);
        dock->setWidget(panel);
        connect(panel, &Panel::panelRequested, this, &MainWindow::bringForward);
        auto* title = new DockTitle(*dock);
        dock->setTitleBarWidget(title);
        dock->toggleViewAction()->setObjectName(u"action.view."_s + idOf(row));
        m_docks << dock;
        m_titles.insert(dock, title);
        connect(dock, &QDockWidget::visibilityChanged, this, &MainWindow::refreshTitles);
        connect(dock, &QDockWidget::topLevelChanged, this, &MainWindow::refreshTitles);
        connect(dock, &QDockWidget::dockLocationChanged, this, &MainWindow::refreshTitles);
    }
}

void MainWindow::makeMenus(const QString& theme, const QString& language)
{
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addActions(m_commandBar->actionsForMenu());
    file->addSeparator();
    addJournal(*file, m_context, *this);
    auto* quit = addEntry(*file, u"quit"_s, tr("&Quit"), u"quit"_s, [this] { close(); });
    quit->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Q));

    QMenu* view = menuBar()->addMenu(tr("&View"));
    for (const QDockWidget* dock : std::as_const(m_docks)) {
        view->addAction(dock->toggleViewAction());
    }
    view->addSeparator();
    addEntry(*view, u"resetLayout"_s, tr("Put all panels back"), u"window"_s,
             [this] { applyDefaultLayout(); });

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

void MainWindow::applyDefaultLayout()
{
    QHash<int, QDockWidget*> firstAt; // by area and order: the dock that the others are tabbed with
    for (std::size_t i = 0; i < panels().size(); ++i) {
        const PanelRow& row = panels()[i];
        QDockWidget* dock = m_docks.at(static_cast<qsizetype>(i));
        dock->setFloating(false);
        dock->show();
        const int place = static_cast<int>(row.area) * 100 + row.order;
        if (QDockWidget* first = firstAt.value(place)) {
            tabifyDockWidget(first, dock);
        } else {
            addDockWidget(row.area, dock, Qt::Vertical);
            firstAt.insert(place, dock);
        }
    }
    for (QDockWidget* first : std::as_const(firstAt)) {
        first->raise();
    }
    // Later: before the window is laid out nothing has a size to change.
    QMetaObject::invokeMethod(this, &MainWindow::fitColumns, Qt::QueuedConnection);
    refreshTitles();
}

/// The side columns as wide as they need; the middle takes the rest.
void MainWindow::fitColumns()
{
    for (QDockWidget* dock : std::as_const(m_docks)) {
        const Qt::DockWidgetArea area = dockWidgetArea(dock);
        if (area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea) {
            resizeDocks({dock}, {kSideWidth}, Qt::Horizontal);
        }
    }
}

void MainWindow::restoreLayout()
{
    // The offscreen platform's screen is none that a window would have to fit.
    const bool hasScreen = QGuiApplication::platformName() != "offscreen"_L1;
    resize(hasScreen ? kUsualSize.boundedTo(QApplication::primaryScreen()->availableSize())
                     : kUsualSize);
    applyDefaultLayout();
    restoreGeometry(m_context.settings.value(settings::kGeometry));
    const QByteArray stored = m_context.settings.value(settings::kLayout);
    if (!stored.isEmpty()) { // queued behind fitColumns()
        QMetaObject::invokeMethod(
            this, [this, stored] { restoreState(stored, kLayoutVersion); }, Qt::QueuedConnection);
    }
}

void MainWindow::saveLayout()
{
    m_context.settings.set(settings::kGeometry, saveGeometry());
    m_context.settings.set(settings::kLayout, saveState(kLayoutVersion));
}

void MainWindow::bringForward(const QString& panelId)
{
    if (auto* dock = findChild<QDockWidget*>(u"dock."_s + panelId)) {
        dock->show();
        dock->raise();
    }
}

void MainWindow::refreshTitles()
{
    // Later: the tabs are not yet as they will be when a dock tells of its move.
    QMetaObject::invokeMethod(
        this,
        [this] {
            for (DockTitle* title : std::as_const(m_titles)) {
                title->refresh();
            }
        },
        Qt::QueuedConnection);
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

QMenu* MainWindow::createPopupMenu()
{
    return nullptr; // Qt's own would offer to hide the row with STOP
}

} // namespace trex
