// SPDX-License-Identifier: GPL-3.0-or-later
// What happens around a simulated line: the scenario's events, faults, and the hands of a test.
#include "protocol/sim/simulatedline.h"

#include <algorithm>

namespace trex::sim {
namespace {

Duration fromSeconds(double seconds)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

} // namespace

std::optional<Instant> SimulatedLine::nextEventAt() const
{
    std::optional<Instant> next;
    if (m_nextEvent < m_options.scenario.events.size()) {
        next = m_start + fromSeconds(m_options.scenario.events[m_nextEvent].at);
    }
    if (m_resetAt) {
        next = next ? std::min(*next, *m_resetAt) : *m_resetAt;
    }
    return next;
}

void SimulatedLine::runEvent()
{
    if (m_resetAt && *m_resetAt <= m_now) {
        m_resetAt.reset();
        resetControllers();
        return;
    }
    apply(m_options.scenario.events[m_nextEvent++]);
}

void SimulatedLine::apply(const ScenarioEvent& event)
{
    for (const auto& device : m_devices) {
        device->advance(m_now);
        for (int motor = 1; motor <= 2; ++motor) {
            const auto i = static_cast<std::size_t>(motor - 1);
            if (event.load[i]) {
                device->setLoad(motor, *event.load[i]);
            }
            if (event.stall[i]) {
                device->setStall(motor, *event.stall[i]);
            }
            if (event.driverFault[i]) {
                device->setDriverFault(motor, *event.driverFault[i]);
            }
        }
        if (event.mode) {
            device->setMode(*event.mode);
        }
        if (event.mix) {
            device->setMix(*event.mix);
        }
        for (const auto& [number, raw] : event.parameters) {
            device->setParameter(number, raw);
        }
    }
    applyFaults(event);
    if (event.powerCycle) {
        resetControllers();
    }
}

// Windows of time that the event does not mention go on as they were.
void SimulatedLine::applyFaults(const ScenarioEvent& event)
{
    Faults fresh;
    for (const auto& [name, value] : event.faults) {
        std::ignore = m_faults.apply(name, value); // checked when the scenario was read
        std::ignore = fresh.apply(name, value);
    }
    if (fresh.silentAfter || fresh.silentFor) {
        m_silence = silence(fresh, seconds(m_now));
    }
    if (fresh.hangupAfter || fresh.hangupFor) {
        m_hangUp = hangUp(fresh, seconds(m_now));
    }
    if (fresh.resetAfter) {
        m_resetAt = m_now + fromSeconds(*fresh.resetAfter);
    }
}

void SimulatedLine::setFaults(const Faults& faults, Instant now)
{
    m_faults = faults;
    m_silence = silence(faults, seconds(now));
    m_hangUp = hangUp(faults, seconds(now));
    m_resetAt =
        faults.resetAfter ? std::optional(now + fromSeconds(*faults.resetAfter)) : std::nullopt;
}

void SimulatedLine::setMode(JumperMode mode)
{
    for (const auto& device : m_devices) {
        device->setMode(mode);
    }
}

void SimulatedLine::setMix(bool on)
{
    for (const auto& device : m_devices) {
        device->setMix(on);
    }
}

void SimulatedLine::setLoad(int motor, double load)
{
    for (const auto& device : m_devices) {
        device->setLoad(motor, load);
    }
}

void SimulatedLine::setStall(int motor, bool held)
{
    for (const auto& device : m_devices) {
        device->setStall(motor, held);
    }
}

void SimulatedLine::setInput(const ChannelWave& wave)
{
    for (const auto& device : m_devices) {
        device->setInput(wave);
    }
}

} // namespace trex::sim
