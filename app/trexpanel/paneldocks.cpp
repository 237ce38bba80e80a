// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/paneldocks.h"

#include "app/trexpanel/docktitle.h"
#include "widgets/common/fitting.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr QSize kUsualSize{1440, 900};
constexpr QSize kLeastForColumns{1120, 700}; ///< of a screen; what is smaller gets one panel a time
constexpr int kSideWidth = 320;
constexpr int kLayoutVersion = 1; ///< a stored layout of another version is not restored

bool isScreenSmall()
{
    const QSize available = QApplication::primaryScreen()->availableSize();
    return hasScreen() && available.boundedTo(kLeastForColumns) != kLeastForColumns;
}

/// A panel that need not fit: what does not is scrolled to.
QScrollArea* scrolled(Panel* panel, QWidget* parent)
{
    auto* area = new QScrollArea(parent);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setWidget(panel);
    return area;
}

} // namespace

QString idOf(const PanelRow& row)
{
    return QString::fromUtf8(row.id.data(), static_cast<qsizetype>(row.id.size()));
}

PanelDocks::PanelDocks(QMainWindow& window, PanelContext& context, const Filter& isShown)
    : QObject(&window), m_window(window)
{
    window.setDockOptions(QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks
                          | QMainWindow::GroupedDragging);
    window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    window.setCorner(Qt::TopLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window.setCorner(Qt::TopRightCorner, Qt::RightDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    // Without a centre, Qt shares a window's width between the columns; with one, even this flat,
    // the middle column takes what there is to spare.
    auto* centre = new QWidget(&window);
    centre->setMaximumHeight(0);
    window.setCentralWidget(centre);
    for (const PanelRow& row : panels()) {
        if (isShown(row)) {
            addDock(row, context);
        }
    }
}

void PanelDocks::addDock(const PanelRow& row, PanelContext& context)
{
    auto* dock = new QDockWidget(QCoreApplication::translate("Panels", row.title), &m_window);
    dock->setObjectName(u"dock."_s + idOf(row));
    Panel* panel = named(row.make(context, dock), idOf(row), dock->windowTitle());
    panel->setAutoFillBackground(true);
    panel->setBackgroundRole(QPalette::Base);
    isScreenSmall() ? dock->setWidget(scrolled(panel, dock)) : dock->setWidget(panel);
    connect(panel, &Panel::panelRequested, this, &PanelDocks::bringForward);
    auto* title = new DockTitle(*dock);
    dock->setTitleBarWidget(title);
    dock->toggleViewAction()->setObjectName(u"action.view."_s + idOf(row));
    m_rows.push_back(&row);
    m_docks << dock;
    m_titles.insert(dock, title);
    connect(dock, &QDockWidget::visibilityChanged, this, &PanelDocks::refreshTitles);
    connect(dock, &QDockWidget::topLevelChanged, this, &PanelDocks::refreshTitles);
    connect(dock, &QDockWidget::dockLocationChanged, this, &PanelDocks::refreshTitles);
}

void PanelDocks::addToMenu(QMenu& menu) const
{
    for (const QDockWidget* dock : std::as_const(m_docks)) {
        menu.addAction(dock->toggleViewAction());
    }
}

void PanelDocks::applyDefaultLayout()
{
    const bool isSmall = isScreenSmall();
    QHash<int, QDockWidget*> firstAt; // by area and order: the dock that the others are tabbed with
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const PanelRow& row = *m_rows[i];
        QDockWidget* dock = m_docks.at(static_cast<qsizetype>(i));
        dock->setFloating(false);
        dock->show();
        // On a small screen all are tabs of one place: side by side they would be wider than it.
        const auto area = isSmall ? Qt::BottomDockWidgetArea : row.area;
        const int place = isSmall ? 0 : static_cast<int>(row.area) * 100 + row.order;
        if (QDockWidget* first = firstAt.value(place)) {
            m_window.tabifyDockWidget(first, dock);
        } else {
            m_window.addDockWidget(area, dock, Qt::Vertical);
            firstAt.insert(place, dock);
        }
    }
    for (QDockWidget* first : std::as_const(firstAt)) {
        first->raise();
    }
    // Later: before the window is laid out nothing has a size to change.
    QMetaObject::invokeMethod(this, &PanelDocks::fitColumns, Qt::QueuedConnection);
    refreshTitles();
}

/// The side columns as wide as they need; the middle takes the rest.
void PanelDocks::fitColumns()
{
    for (QDockWidget* dock : std::as_const(m_docks)) {
        const Qt::DockWidgetArea area = m_window.dockWidgetArea(dock);
        if (area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea) {
            m_window.resizeDocks({dock}, {kSideWidth}, Qt::Horizontal);
        }
    }
}

void PanelDocks::restore(const QByteArray& geometry, const QByteArray& layout)
{
    m_window.resize(hasScreen()
                        ? kUsualSize.boundedTo(QApplication::primaryScreen()->availableSize())
                        : kUsualSize);
    applyDefaultLayout();
    m_window.restoreGeometry(geometry);
    if (!layout.isEmpty()) { // queued behind fitColumns()
        QMetaObject::invokeMethod(
            this, [this, layout] { m_window.restoreState(layout, kLayoutVersion); },
            Qt::QueuedConnection);
    }
}

QByteArray PanelDocks::layout() const
{
    return m_window.saveState(kLayoutVersion);
}

void PanelDocks::bringForward(const QString& panelId)
{
    auto* dock = m_window.findChild<QDockWidget*>(u"dock."_s + panelId.section(u'/', 0, 0));
    if (dock == nullptr) {
        return;
    }
    dock->show();
    dock->raise();
    const QString control = panelId.section(u'/', 1);
    auto* wanted = control.isEmpty() ? nullptr : dock->findChild<QWidget*>(control);
    if (wanted != nullptr) {
        wanted->setFocus(Qt::OtherFocusReason);
        dock->window()->activateWindow();
    }
}

void PanelDocks::refreshTitles()
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

} // namespace trex
