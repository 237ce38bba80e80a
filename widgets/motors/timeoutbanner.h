// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/panel.h"

class QLabel;
class QPushButton;

namespace trex {

/// Says plainly when nothing would stop the motors if this program died, and offers to set it.
/// Hidden while that is not so. GUI thread.
class TimeoutBanner : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(TimeoutBanner)

public:
    explicit TimeoutBanner(PanelContext& context, QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void refresh();
    PanelContext& m_context;
    QLabel* m_text;
    QPushButton* m_set;
};

} // namespace trex
