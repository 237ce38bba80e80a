// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;

namespace trex {

class FrameTicker;
class Recordings;

/// In the status bar: whether it is recorded, for how long, and how much is on the disk; or why a
/// recording ended before its time, until the next one begins. GUI thread.
class RecordingLamp : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RecordingLamp)

public:
    RecordingLamp(const Recordings& recordings, FrameTicker& ticker, QWidget* parent = nullptr);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void onTick();
    void refresh();

    const Recordings& m_recordings;
    QLabel* m_text;
    int m_ticks = 0;
};

} // namespace trex
