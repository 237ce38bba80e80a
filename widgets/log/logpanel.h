// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/panel.h"

class QTableView;

namespace trex {

/// Events in plain sentences, newest last; copy and save. GUI thread.
class LogPanel : public Panel {
    Q_OBJECT

public:
    explicit LogPanel(PanelContext& context, QWidget* parent = nullptr);

private:
    void copy();
    void save();
    QTableView* m_view;
};

} // namespace trex
