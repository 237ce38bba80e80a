// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/panel.h"
#include "widgets/common/stateshape.h"

#include <QStatusBar>

class QLabel;

namespace trex {

/// What the line does: state, transactions a second, round trip, errors, and when it is too slow.
/// GUI thread.
class LinkStatusBar : public QStatusBar {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(LinkStatusBar)

public:
    LinkStatusBar(PanelContext& context, QWidget* parent = nullptr);

private:
    class StateLamp;
    void onTick();
    void refresh();
    [[nodiscard]] QString tooSlowText() const;

    const Controller& m_controller;
    StateLamp* m_lamp;
    QLabel* m_state;
    QLabel* m_rate;
    QLabel* m_roundTrip;
    QLabel* m_errors;
    QLabel* m_tooSlow;
    int m_ticks = 0;
};

} // namespace trex
