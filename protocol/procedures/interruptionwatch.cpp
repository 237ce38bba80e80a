// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/interruptionwatch.h"

#include <QDateTime>

using namespace std::chrono_literals;

namespace trex {
namespace {

constexpr auto kTick = 250ms;
constexpr qint64 kStarvedMs = 1000;
// Far above the interval of 20 ms, and above what a slow line or a busy computer takes.
constexpr qint64 kLostMs = 5000;
constexpr auto kLongestGap = std::chrono::milliseconds(kLostMs);
constexpr qint64 kSleptMs = 3000;

} // namespace

InterruptionWatch::InterruptionWatch(QObject* parent)
    : QObject(parent), m_wallClock(&QDateTime::currentMSecsSinceEpoch), m_timer(this)
{
    m_timer.setInterval(kTick);
    connect(&m_timer, &QTimer::timeout, this, &InterruptionWatch::onTick);
}

void InterruptionWatch::start()
{
    m_sinceSample.start();
    m_sinceTick.start();
    m_wallAtTick = m_wallClock();
    if (!m_timer.isActive()) {
        m_latest.reset();
        m_timer.start();
    }
}

void InterruptionWatch::stop()
{
    m_timer.stop();
    m_latest.reset();
}

void InterruptionWatch::sampleCame(Instant time)
{
    const auto before = std::exchange(m_latest, time);
    m_sinceSample.start();
    if (before && time - *before > kLongestGap) {
        const double seconds = std::chrono::duration<double>(time - *before).count();
        interruptBy(tr("No reading came for %1 s.").arg(seconds, 0, 'f', 0));
    }
}

bool InterruptionWatch::isStarved() const
{
    return m_timer.isActive() && m_sinceSample.hasExpired(kStarvedMs);
}

void InterruptionWatch::onTick()
{
    // The steady clock stands still while a Linux computer sleeps; the wall clock does not.
    const qint64 wall = m_wallClock();
    const qint64 steadyMs = m_sinceTick.restart();
    const qint64 sleptMs = wall - std::exchange(m_wallAtTick, wall) - steadyMs;
    if (sleptMs > kSleptMs || steadyMs > kLostMs) {
        interruptBy(tr("The computer was asleep, or this program stood still."));
    } else if (m_sinceSample.hasExpired(kLostMs)) {
        interruptBy(tr("No fresh readings came from the controller for %1 s.").arg(kLostMs / 1000));
    } else {
        emit ticked();
    }
}

void InterruptionWatch::interruptBy(const QString& sentence)
{
    stop();
    emit interrupted(sentence);
}

} // namespace trex
