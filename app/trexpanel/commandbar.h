// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/panel.h"

#include <QTimer>

class QAction;
class QHBoxLayout;
class QLabel;

namespace trex {

/// The row that is always there: connect or disconnect, what is connected, arm, STOP. Owns the
/// actions that the menus share. GUI thread.
class CommandBar : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(CommandBar)

public:
    CommandBar(PanelContext& context, QWidget* parent = nullptr);
    [[nodiscard]] QList<QAction*> actionsForMenu() const;
    void addAction(QAction* action); ///< one more button, before Arm
    void connectToLast(); ///< the line used before; connectionWanted() when there is none

signals:
    void connectionWanted(); ///< nothing is known to connect to: the person has to choose

private:
    void makeActions();
    void makeRow();
    void refresh();
    void refreshIdentity();
    void onArmTriggered(bool armed);

    PanelContext& m_context;
    QAction* m_connect = nullptr;
    QAction* m_disconnect = nullptr;
    QAction* m_arm = nullptr;
    QAction* m_stop = nullptr;
    QHBoxLayout* m_row = nullptr;
    QLabel* m_identity = nullptr;
    QWidget* m_connectButton = nullptr;
    QWidget* m_disconnectButton = nullptr;
    QTimer m_lockout; ///< runs while arming would be refused
};

} // namespace trex
