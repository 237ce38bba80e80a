// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/linechange.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace trex {

class Panel;

/// What a change of the line settings waits for, and what the person can do meanwhile. Hidden when
/// there is nothing to say. GUI thread.
class LineChangeBox : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(LineChangeBox)
    Q_PROPERTY(QString phase READ phase)

public:
    explicit LineChangeBox(LineChange& change, Panel& panel, QWidget* parent = nullptr);
    /// "none", "waiting", "reconnecting", "recovering"; never translated.
    [[nodiscard]] QString phase() const;

private:
    void refresh();
    void bringForward();

    LineChange& m_change;
    Panel& m_panel; ///< that it stands in
    LineChange::Phase m_shown = LineChange::Phase::None;
    QLabel* m_text;
    QPushButton* m_reconnect;
    QPushButton* m_recover;
    QPushButton* m_cancel;
};

} // namespace trex
