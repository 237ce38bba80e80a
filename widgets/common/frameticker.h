// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBasicTimer>
#include <QObject>

namespace trex {

/// Ticks 30 times a second while somebody listens, twice while all windows are minimised (files are
/// written on a tick too); views pull what is new then, instead of getting
/// a signal for each sample. GUI thread.
class FrameTicker : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(FrameTicker)

public:
    explicit FrameTicker(QObject* parent = nullptr);
    static constexpr int kIntervalMs = 33;
    [[nodiscard]] static bool isEverythingMinimised();

    /// Views report the time that painting a frame took, for the metrics of the report.
    void framePainted(double milliseconds);
    [[nodiscard]] quint64 framesPainted() const { return m_frames; }
    [[nodiscard]] double medianMs() const;
    [[nodiscard]] double percentile95Ms() const;

signals:
    void tick();

protected:
    void timerEvent(QTimerEvent* event) override;

private:
    QBasicTimer m_timer;
    int m_untold = 0; ///< ticks that were left out in a row
    quint64 m_frames = 0;
    QList<float> m_durations; ///< the latest frames, bounded
};

} // namespace trex
