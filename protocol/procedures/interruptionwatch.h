// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/quantities.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>

namespace trex {

/// Notices, while samples are collected, that they stop coming or that the computer slept in
/// between: what was measured before and after does not belong together. Main thread.
class InterruptionWatch : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(InterruptionWatch)

public:
    using Clock = std::function<qint64()>; ///< milliseconds

    explicit InterruptionWatch(QObject* parent = nullptr);
    void setWallClock(Clock clock) { m_wallClock = std::move(clock); } ///< the system's otherwise

    void start(); ///< collecting begins, or goes on with another step
    void stop();
    void sampleCame(Instant time); ///< of its read
    /// Running, but no sample came for a second.
    [[nodiscard]] bool isStarved() const;

signals:
    void ticked(); ///< a few times a second while it runs
    void interrupted(const QString& sentence); ///< once; it is stopped then

private:
    void onTick();
    void interruptBy(const QString& sentence);

    Clock m_wallClock;
    QTimer m_timer;
    QElapsedTimer m_sinceSample;
    QElapsedTimer m_sinceTick;
    qint64 m_wallAtTick = 0;
    std::optional<Instant> m_latest;
};

} // namespace trex
