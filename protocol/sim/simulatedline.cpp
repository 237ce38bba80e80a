// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/simulatedline.h"

#include <algorithm>

namespace trex::sim {

using namespace std::chrono_literals;

namespace {

constexpr auto kRestAfterReply = 20ms; // time for a slow host's UART to see the wire rest

} // namespace

SimulatedLine::SimulatedLine(const SimOptions& options, Instant start)
    : m_options(options), m_start(start), m_now(start), m_hostFree(start), m_random(options.seed)
{
    std::vector<Eeprom> stored;
    if (!options.stateFile.isEmpty()) {
        if (auto loaded = loadEeproms(options.stateFile)) {
            stored = std::move(*loaded);
        } else {
            m_stateError = loaded.error();
        }
    }
    for (std::size_t i = 0; i < options.devices.size(); ++i) {
        const Eeprom* eeprom = i < stored.size() ? &stored[i] : nullptr;
        m_devices.push_back(std::make_unique<Device>(options, i, eeprom, start));
    }
    setFaults(options.faults, start);
    refreshFormats();
}

SimulatedLine::~SimulatedLine()
{
    std::ignore = saveState();
}

void SimulatedLine::setHostLine(std::optional<HostLine> host)
{
    m_host = host;
    refreshFormats();
}

void SimulatedLine::refreshFormats()
{
    m_toDevice.clear();
    m_toHost.clear();
    m_isPaced = m_options.pace;
    for (const auto& device : m_devices) {
        const UartFormat host = m_host
            ? UartFormat{m_host->baud, m_host->errorDetection, m_host->stopBits}
            : device->uart();
        m_toDevice.emplace_back(host, device->uart());
        m_toHost.emplace_back(device->uart(), host);
        m_isPaced = m_isPaced || !m_toDevice.back().isTransparent();
    }
    for (const auto& device : m_devices) {
        device->setPaced(m_isPaced);
    }
    const UartFormat first = m_devices.front()->uart();
    const UartFormat host =
        m_host ? UartFormat{m_host->baud, m_host->errorDetection, m_host->stopBits} : first;
    m_hostByte = host.byteTime();
}

void SimulatedLine::write(QByteArrayView bytes, Instant now)
{
    advance(now);
    if (isHungUp(m_now)) {
        return;
    }
    for (const char each : bytes) {
        const auto value = static_cast<std::uint8_t>(each);
        const Instant begin = m_isPaced ? std::max(m_now, m_hostFree) : m_now;
        const Instant end = m_isPaced ? begin + m_hostByte : begin;
        m_hostFree = end;
        m_incoming.push_back({begin, end, value});
        if (m_options.echo) {
            addOutgoing({end, value, -1, 0});
        }
    }
    if (!m_isPaced) {
        advance(m_now);
    }
}

QByteArray SimulatedLine::read(Instant now)
{
    advance(now);
    QByteArray bytes;
    while (!m_outgoing.empty() && m_outgoing.front().at <= m_now) {
        if (!m_hangUp.contains(seconds(m_outgoing.front().at))) {
            bytes.append(static_cast<char>(m_outgoing.front().value));
        }
        m_outgoing.pop_front();
    }
    return bytes;
}

std::optional<Instant> SimulatedLine::nextByteAt() const
{
    std::optional<Instant> next;
    const auto consider = [&next](Instant at) { next = next ? std::min(*next, at) : at; };
    if (!m_outgoing.empty()) {
        consider(m_outgoing.front().at);
    }
    if (!m_incoming.empty()) {
        consider(m_incoming.front().end);
    }
    for (const auto& device : m_devices) {
        if (const auto wake = device->nextWakeAt()) {
            consider(*wake);
        }
    }
    return next;
}

void SimulatedLine::advance(Instant now)
{
    now = std::max(now, m_now);
    while (true) {
        const std::optional<Instant> event = nextEventAt();
        const bool isByteNext = !m_incoming.empty() && (!event || m_incoming.front().end <= *event);
        if (isByteNext && m_incoming.front().end <= now) {
            m_now = std::max(m_now, m_incoming.front().end);
            const Incoming byte = m_incoming.front();
            m_incoming.pop_front();
            deliver(byte);
        } else if (!isByteNext && event && *event <= now) {
            m_now = std::max(m_now, *event);
            runEvent();
        } else {
            break;
        }
    }
    m_now = now;
    for (std::size_t i = 0; i < m_devices.size(); ++i) {
        settle(i);
        m_devices[i]->advance(now);
        collectReplies(i);
    }
}

void SimulatedLine::deliver(const Incoming& byte)
{
    std::uint8_t value = byte.value;
    if (m_hangUp.contains(seconds(byte.end)) || !crosses(value, byte.end)) {
        return;
    }
    for (int count = arrivals(value, m_faults, m_random); count > 0; --count) {
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            if (isPlugged(i)) {
                deliverTo(i, value, byte);
            }
        }
    }
}

void SimulatedLine::deliverTo(std::size_t device, std::uint8_t value, const Incoming& byte)
{
    if (m_toDevice[device].isTransparent()) {
        m_devices[device]->receive({value}, byte.begin, byte.end);
    } else {
        m_sampled.clear();
        m_toDevice[device].feed(value, byte.begin, m_sampled);
        hear(device);
    }
    collectReplies(device);
}

bool SimulatedLine::isPlugged(std::size_t device) const
{
    return std::ssize(m_devices) - static_cast<std::ptrdiff_t>(device) > m_faults.unplugged;
}

// A receiver at another speed may still be in the middle of what it takes for a byte.
void SimulatedLine::settle(std::size_t device)
{
    if (m_toDevice[device].isTransparent()) {
        return;
    }
    m_sampled.clear();
    const Instant until = m_incoming.empty() ? m_now : std::min(m_now, m_incoming.front().begin);
    m_toDevice[device].settle(until, m_sampled);
    hear(device);
}

void SimulatedLine::hear(std::size_t device)
{
    for (const SampledByte& sampled : m_sampled) {
        m_devices[device]->receive(sampled.byte, sampled.begin, sampled.end);
    }
}

/// Counts a byte that crosses the wire then; false when it does not reach the other side.
bool SimulatedLine::crosses(std::uint8_t& value, Instant at)
{
    switch (fateOf(m_faults, ++m_wireBytes, value)) {
    case ByteFate::Passes:
        return true;
    case ByteFate::Dropped:
        return false;
    case ByteFate::HangsUp:
        m_hangUp = {seconds(at), seconds(at) + m_faults.hangupFor.value_or(Faults::kNever)};
        return false;
    case ByteFate::Resets:
        m_resetAt = at;
        return false;
    }
    return true;
}

void SimulatedLine::collectReplies(std::size_t device)
{
    for (const Reply& reply : m_devices[device]->replies()) {
        sendReply(device, reply);
    }
    m_devices[device]->clearReplies();
}

void SimulatedLine::sendReply(std::size_t device, const Reply& reply)
{
    if (m_silence.contains(seconds(reply.begin))) {
        return;
    }
    Instant at = reply.begin
        + std::chrono::duration_cast<Duration>(
                     std::chrono::duration<double, std::milli>(m_faults.delayMs));
    QByteArray worse;
    QByteArrayView bytes = reply.view();
    if (damages(m_faults)) {
        worse = damaged(bytes, m_faults, m_random);
        bytes = worse;
    }
    const Duration byteTime = m_isPaced ? m_devices[device]->uart().byteTime() : Duration{0};
    std::int16_t index = 0;
    m_sampled.clear();
    for (const char each : bytes) {
        auto value = static_cast<std::uint8_t>(each);
        if (!crosses(value, at + byteTime)) {
            if (m_resetAt) {
                break; // cut off in the middle of the reply
            }
        } else if (m_toHost[device].isTransparent()) {
            addOutgoing({at + byteTime, value, static_cast<std::int8_t>(device), index++});
        } else {
            m_toHost[device].feed(value, at, m_sampled);
        }
        at += byteTime;
    }
    if (!m_toHost[device].isTransparent()) {
        m_toHost[device].settle(at + kRestAfterReply, m_sampled);
        for (const SampledByte& sampled : m_sampled) {
            addOutgoing(
                {sampled.end, sampled.byte.value, static_cast<std::int8_t>(device), index++});
        }
    }
}

void SimulatedLine::addOutgoing(const Outgoing& byte)
{
    auto place = m_outgoing.end();
    while (place != m_outgoing.begin() && std::prev(place)->at > byte.at) {
        --place;
    }
    if (byte.device >= 0 && m_devices.size() > 1) {
        const Duration near = m_hostByte / 2;
        for (auto& other : m_outgoing) {
            if (other.device >= 0 && other.device != byte.device && other.index == byte.index
                && std::chrono::abs(other.at - byte.at) < near) {
                other.value &= byte.value; // outputs joined by AND
                return;
            }
        }
    }
    m_outgoing.insert(place, byte);
}

bool SimulatedLine::isHungUp(Instant now) const
{
    return m_hangUp.contains(seconds(now));
}

void SimulatedLine::powerCycle(Instant now)
{
    advance(now);
    resetControllers();
}

void SimulatedLine::resetControllers()
{
    for (const auto& device : m_devices) {
        device->powerCycle(m_now);
    }
    std::erase_if(m_outgoing, [this](const Outgoing& byte) {
        return byte.device >= 0 && byte.at > m_now; // cut off in the middle of a reply
    });
    refreshFormats();
}

Result<void> SimulatedLine::saveState()
{
    const bool isDirty = std::any_of(m_devices.begin(), m_devices.end(),
                                     [](const auto& device) { return device->eeprom().isDirty(); });
    if (m_options.stateFile.isEmpty() || !isDirty || m_stateError) {
        return {};
    }
    std::vector<Eeprom> eeproms;
    for (const auto& device : m_devices) {
        eeproms.push_back(device->eeprom());
        device->eeprom().setClean();
    }
    return saveEeproms(m_options.stateFile, eeproms);
}

double SimulatedLine::seconds(Instant now) const
{
    return std::chrono::duration<double>(now - m_start).count();
}

} // namespace trex::sim
