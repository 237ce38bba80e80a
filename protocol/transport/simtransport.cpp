// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/simtransport.h"

#include <thread>

namespace trex {

namespace {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

// The plant runs on, and a hang-up is noticed, also while nobody polls.
constexpr auto kIdleStep = 50ms;
constexpr auto kShortestWait = 20us;

} // namespace

SimTransport::SimTransport(const sim::SimOptions& options, QObject* parent)
    : Transport(parent)
    , m_virtualNow(options.jumpsInTime ? std::optional(Transport::now()) : std::nullopt)
    , m_line(options, now())
    , m_timer(this)
{
    m_timer.setSingleShot(true);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        const Instant now = this->now();
        take(now);
        schedule(now);
    });
}

void SimTransport::open(const LineSettings& settings)
{
    const Instant now = this->now();
    if (m_line.isHungUp(now)) {
        emit failed({ErrorCode::PortMissing, u"sim:"_s});
        return;
    }
    if (const auto& problem = m_line.stateError()) {
        emit failed(*problem);
        return;
    }
    m_line.setHostLine(sim::HostLine{settings.baud, settings.errorDetection, settings.stopBits});
    static_cast<void>(m_line.read(now)); // what came before we were here is nobody's reply
    m_isOpen = true;
    schedule(now);
    emit opened();
}

bool SimTransport::setLine(const LineSettings& settings)
{
    m_line.advance(now());
    m_line.setHostLine(sim::HostLine{settings.baud, settings.errorDetection, settings.stopBits});
    return true;
}

void SimTransport::close()
{
    m_isOpen = false;
    m_timer.stop();
    m_line.advance(now());
    static_cast<void>(m_line.saveState()); // a failure is told by the next opening
}

void SimTransport::write(const QByteArray& bytes)
{
    if (m_isOpen) {
        const Instant now = this->now();
        m_line.write(bytes, now);
        schedule(now);
    }
}

bool SimTransport::waitForBytes(Duration longest)
{
    const Instant end = now() + longest;
    while (m_isOpen) {
        const Instant now = this->now();
        if (take(now)) {
            return m_isOpen;
        }
        if (now >= end) {
            break;
        }
        const auto next = m_line.nextByteAt();
        const Instant until = next && *next < end ? std::max(*next, now + kShortestWait) : end;
        const Instant then = std::min(until, now + kIdleStep);
        if (m_virtualNow) {
            m_virtualNow = then;
        } else {
            std::this_thread::sleep_until(then);
        }
    }
    if (m_virtualNow) {
        m_virtualNow = std::max(*m_virtualNow, end); // also while the port is gone
    }
    return false;
}

Instant SimTransport::now() const
{
    return m_virtualNow.value_or(Transport::now());
}

bool SimTransport::powerCycle()
{
    m_line.powerCycle(now());
    return true;
}

bool SimTransport::take(Instant now)
{
    const QByteArray bytes = m_line.read(now);
    if (m_line.isHungUp(now)) {
        m_isOpen = false;
        m_timer.stop();
        emit failed({ErrorCode::LineLost, u"sim:"_s});
        return true;
    }
    if (bytes.isEmpty()) {
        return false;
    }
    emit received(bytes, now);
    return true;
}

void SimTransport::schedule(Instant now)
{
    if (!m_isOpen || m_virtualNow) {
        return;
    }
    Duration wait = kIdleStep;
    if (const auto next = m_line.nextByteAt()) {
        wait = std::clamp<Duration>(*next - now, 1ms, kIdleStep);
    }
    m_timer.start(std::chrono::ceil<std::chrono::milliseconds>(wait));
}

} // namespace trex
