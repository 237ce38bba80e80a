// SPDX-License-Identifier: GPL-3.0-or-later
// A single-shot timer for moments of the steady clock. QTimer counts whole milliseconds, which is
// a dozen bytes at 115200 baud; this one is right to some tens of microseconds on Linux.
#pragma once

#include "protocol/codec/quantities.h"

#include <QObject>
#include <QTimer>

class QSocketNotifier;

namespace trex::sim {

class PreciseTimer : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(PreciseTimer)
public:
    explicit PreciseTimer(QObject* parent = nullptr);
    ~PreciseTimer() override;
    void startAt(Instant moment); ///< replaces an earlier moment; a past one is now
    void stop();

signals:
    void timedOut();

private:
    int m_descriptor = -1;
    QSocketNotifier* m_notifier = nullptr;
    QTimer m_fallback; ///< where there is no timerfd
};

} // namespace trex::sim
