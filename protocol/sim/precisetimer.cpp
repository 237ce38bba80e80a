// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/precisetimer.h"

#include <QSocketNotifier>

#ifdef Q_OS_LINUX
#include <sys/timerfd.h>
#include <unistd.h>
#endif

namespace trex::sim {

PreciseTimer::PreciseTimer(QObject* parent) : QObject(parent), m_fallback(this)
{
    m_fallback.setSingleShot(true);
    m_fallback.setTimerType(Qt::PreciseTimer);
    connect(&m_fallback, &QTimer::timeout, this, &PreciseTimer::timedOut);
#ifdef Q_OS_LINUX
    m_descriptor = ::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC);
    if (m_descriptor >= 0) {
        m_notifier = new QSocketNotifier(m_descriptor, QSocketNotifier::Read, this);
        connect(m_notifier, &QSocketNotifier::activated, this, [this] {
            quint64 expirations = 0;
            if (::read(m_descriptor, &expirations, sizeof expirations) > 0) {
                emit timedOut();
            }
        });
    }
#endif
}

PreciseTimer::~PreciseTimer()
{
#ifdef Q_OS_LINUX
    if (m_descriptor >= 0) {
        m_notifier->setEnabled(false);
        ::close(m_descriptor);
    }
#endif
}

void PreciseTimer::startAt(Instant moment)
{
    using namespace std::chrono;
#ifdef Q_OS_LINUX
    if (m_descriptor >= 0) {
        // steady_clock is CLOCK_MONOTONIC; all zeros would disarm.
        const auto since = std::max<Duration>(moment.time_since_epoch(), nanoseconds(1));
        itimerspec spec{};
        spec.it_value.tv_sec = duration_cast<std::chrono::seconds>(since).count();
        spec.it_value.tv_nsec = (since % std::chrono::seconds(1)).count();
        ::timerfd_settime(m_descriptor, TFD_TIMER_ABSTIME, &spec, nullptr);
        return;
    }
#endif
    m_fallback.start(std::max(milliseconds(0), ceil<milliseconds>(moment - steady_clock::now())));
}

void PreciseTimer::stop()
{
    m_fallback.stop();
#ifdef Q_OS_LINUX
    if (m_descriptor >= 0) {
        const itimerspec disarmed{};
        ::timerfd_settime(m_descriptor, 0, &disarmed, nullptr);
    }
#endif
}

} // namespace trex::sim
