// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/panelregistry.h"

#include <QHash>
#include <QObject>

#include <functional>
#include <vector>

class QDockWidget;
class QMainWindow;
class QMenu;

namespace trex {

class DockTitle;

/// One dock for each row of the panel registry that a window shows: made, laid out, brought
/// forward. Knows no panel by name. GUI thread; a child of its window.
class PanelDocks : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(PanelDocks)

public:
    using Filter = std::function<bool(const PanelRow&)>;
    /// Docks of the rows that `isShown` takes, in `window`.
    PanelDocks(QMainWindow& window, PanelContext& context, const Filter& isShown);

    void addToMenu(QMenu& menu) const; ///< which panels are shown
    void applyDefaultLayout();
    void restore(const QByteArray& geometry, const QByteArray& layout);
    [[nodiscard]] QByteArray layout() const; ///< for restore()
    void bringForward(const QString& panelId);

private:
    void addDock(const PanelRow& row, PanelContext& context);
    void fitColumns();
    void refreshTitles();

    QMainWindow& m_window;
    std::vector<const PanelRow*> m_rows;
    QList<QDockWidget*> m_docks; ///< in the order of m_rows
    QHash<QDockWidget*, DockTitle*> m_titles;
};

[[nodiscard]] QString idOf(const PanelRow& row);

} // namespace trex
