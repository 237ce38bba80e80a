// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingblock.h"

#include <QWidget>

#include <array>

namespace trex {

class RecordingPlayer;

/// A whole recording in one strip: the motor currents (from the file's summaries, before a sample
/// is loaded), what happened, how far it is loaded, and the playhead, which the mouse and the keys
/// move. GUI thread.
class RecordingTimeline : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RecordingTimeline)
    /// Where the playhead is, in seconds since the start; scripts set it, too.
    Q_PROPERTY(double seconds READ seconds WRITE setSeconds)
    Q_PROPERTY(double length READ length)

public:
    explicit RecordingTimeline(RecordingPlayer& player, QWidget* parent = nullptr);
    [[nodiscard]] double seconds() const;
    void setSeconds(double seconds);
    [[nodiscard]] double length() const;
    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    void collect();
    void collectEvents();
    void collectFromStore(int curve);
    void collectFromSummaries(int curve);
    void drawCurves(QPainter& painter) const;
    void drawEvents(QPainter& painter) const;
    void drawPlayhead(QPainter& painter) const;
    [[nodiscard]] QRectF strip() const; ///< where time runs
    [[nodiscard]] double xOf(Tick tick) const;
    [[nodiscard]] Tick tickAt(double x) const;
    [[nodiscard]] QString textAt(double x) const; ///< what happened near there

    RecordingPlayer& m_player;
    std::array<std::vector<Extent>, 2> m_columns; ///< by motor, a pixel each
    std::array<std::vector<int>, 2> m_joined; ///< a column that the line comes to this one from; −1
    std::vector<int> m_worst; ///< severity of what happened, a pixel each; −1: nothing
    int m_highest = 1;
};

} // namespace trex
