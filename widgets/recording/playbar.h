// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;
class QComboBox;
class QHBoxLayout;
class QLabel;

namespace trex {

class FrameTicker;
class RecordingPlayer;
class RecordingTimeline;

/// Play, pause, steps, speed and the strip of a recording, with the time at the playhead. Runs the
/// player from the frame ticker. GUI thread.
class PlayBar : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(PlayBar)

public:
    PlayBar(RecordingPlayer& player, FrameTicker& ticker, QWidget* parent = nullptr);
    [[nodiscard]] QList<QAction*> actionsForMenu() const { return m_actions; }

private:
    void makeActions();
    void addSpeeds();
    QAction* addAction(QHBoxLayout& row, const QString& part, const QString& text,
                       const QString& icon, const QKeySequence& key,
                       const std::function<void()>& triggered);
    void togglePlay();
    void refresh();
    void refreshTime();

    RecordingPlayer& m_player;
    QList<QAction*> m_actions;
    QAction* m_play = nullptr;
    QComboBox* m_speed;
    QLabel* m_time;
    QLabel* m_clock;
    RecordingTimeline* m_timeline;
};

} // namespace trex
