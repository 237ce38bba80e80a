// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QDockWidget;
class QLabel;

namespace trex {

/// Title of a panel with its float and close buttons. Behind a tab, which bears the title already,
/// it shows nothing. GUI thread.
class DockTitle : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(DockTitle)

public:
    explicit DockTitle(QDockWidget& dock);
    void refresh(); ///< the dock was moved, tabbed, or torn off
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

private:
    QDockWidget& m_dock;
    QWidget* m_row;
    QLabel* m_text;
    bool m_isTabbed = false;
};

} // namespace trex
