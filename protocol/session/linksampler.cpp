// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/linksampler.h"

#include "protocol/codec/packet.h"
#include "protocol/telemetry/telemetrystore.h"

#include <algorithm>
#include <cmath>

namespace trex {

namespace {

constexpr std::uint16_t kLargestWord = 0xFFFE; // the one above means "none"

/// Signed speed as it is stored. Braking and coasting are no speed.
std::uint16_t storedSpeed(unsigned direction, char amount)
{
    const int speed = static_cast<std::uint8_t>(amount) & 0x7F;
    switch (static_cast<MotorDirection>(direction & 3U)) {
    case MotorDirection::Forward:
        return static_cast<std::uint16_t>(kFullSpeed + speed);
    case MotorDirection::Reverse:
        return static_cast<std::uint16_t>(kFullSpeed - speed);
    case MotorDirection::Brake:
    case MotorDirection::BrakeAlternate:
        break;
    }
    return kFullSpeed;
}

/// What a motor command changes of the orders in force.
template <class Orders>
void applyOrder(const Command& command, Orders& orders)
{
    const CommandRow& row = command.row();
    const unsigned directions = command.opcode;
    if (row.opcodeBits == OpcodeBits::DirectionPair) {
        // Bits 3:2 are motor 2's direction, bits 1:0 motor 1's; motor 1's speed comes first.
        orders[0] = storedSpeed(directions, command.data[0]);
        orders[1] = storedSpeed(directions >> 2U, command.data[1]);
    } else if (row.opcodeBits == OpcodeBits::Direction) {
        orders[row.key.ends_with("motor1") ? 0 : 1] = storedSpeed(directions, command.data[0]);
    } else {
        orders[2] = storedSpeed(static_cast<unsigned>(MotorDirection::Forward), command.data[0]);
    }
}

template <class T>
std::uint16_t clampedWord(T value)
{
    return static_cast<std::uint16_t>(std::clamp<T>(value, 0, kLargestWord));
}

/// The newest moment that the batch tells of.
std::optional<Instant> newestOf(const LinkBatch& batch)
{
    std::optional<Instant> newest;
    const auto take = [&newest](Instant time) { newest = std::max(newest.value_or(time), time); };
    for (const PollSample& sample : batch.samples) {
        take(sample.time);
    }
    for (const TransactionRecord& record : batch.records) {
        take(record.ended);
    }
    return newest;
}

} // namespace

void LinkSampler::take(const LinkBatch& batch, const LineSettings& line)
{
    auto event = batch.events.begin();
    for (const TransactionRecord& record : batch.records) {
        for (; event != batch.events.end() && event->time <= record.sent; ++event) {
            onEvent(*event);
        }
        onRecord(record, line);
    }
    for (; event != batch.events.end(); ++event) {
        onEvent(*event);
    }
    const auto now = newestOf(batch);
    if (!now || !m_isConnected) {
        return;
    }
    if (m_lastOrder && *now - *m_lastOrder >= kHeartbeat) {
        m_store.append(Source::orders(), m_orders, *now);
        m_lastOrder = *now;
    }
    countHealth(batch.stats, *now);
}

void LinkSampler::onEvent(const LinkEvent& event)
{
    if (event.kind != LinkEvent::Kind::StateChanged) {
        return;
    }
    m_isConnected = event.state == LinkState::Connected;
    if (!m_isConnected) {
        forgetOrders();
        restartHealth();
    }
}

void LinkSampler::onRecord(const TransactionRecord& record, const LineSettings& line)
{
    if (!m_isConnected) {
        return; // on a silent line nobody has heard it
    }
    if (!record.error && !record.receivedBytes.isEmpty()) {
        m_latencies.push_back(clampedWord((record.ended - record.sent) / TimeAxis::kTick));
    }
    Command command = record.command;
    if (record.isRaw) {
        const auto packet = decodePacket(record.sentBytes, line);
        if (!packet) { // may have held an order
            if (m_lastOrder) {
                setOrders({kUnknown, kUnknown, kUnknown}, record.sent);
            }
            return;
        }
        command = packet->command;
    }
    if (!record.error && validate(command) && command.row().kind == CommandKind::Motor) {
        Orders orders = m_orders;
        applyOrder(command, orders);
        setOrders(orders, record.sent);
    }
}

void LinkSampler::setOrders(const Orders& orders, Instant time)
{
    if (m_lastOrder && orders == m_orders) {
        return;
    }
    if (m_lastOrder) {
        const Instant before = std::max(time - TimeAxis::kTick, *m_lastOrder);
        m_store.append(Source::orders(), m_orders, before);
    }
    m_store.append(Source::orders(), orders, time);
    m_orders = orders;
    m_lastOrder = time;
}

void LinkSampler::forgetOrders()
{
    m_orders.fill(kUnknown);
    if (m_lastOrder) {
        m_lastOrder.reset();
        m_store.markGap(Source::orders());
    }
}

void LinkSampler::restart()
{
    m_isConnected = false;
    forgetOrders();
    restartHealth();
}

void LinkSampler::restartHealth()
{
    m_healthStart.reset();
    m_latencies.clear();
    m_store.markGap(Source::linkHealth());
}

void LinkSampler::countHealth(const LinkStats& stats, Instant now)
{
    const auto errorsOf = [](const LinkStats& of) {
        return of.timeouts + of.crcErrors + of.badReplies;
    };
    if (m_healthStart && now - *m_healthStart < kHealthInterval) {
        return;
    }
    if (m_healthStart) {
        const double seconds = std::chrono::duration<double>(now - *m_healthStart).count();
        const auto perSecond = [seconds](quint64 before, quint64 after) {
            return static_cast<double>(after - before) / seconds;
        };
        constexpr double kRateScale = 10.0; // stored in tenths
        const double rate = perSecond(m_healthBefore.transactions, stats.transactions);
        const double errors = perSecond(errorsOf(m_healthBefore), errorsOf(stats));
        std::uint16_t latency = 0xFFFF;
        if (!m_latencies.empty()) {
            const auto middle = m_latencies.begin() + std::ssize(m_latencies) / 2;
            std::nth_element(m_latencies.begin(), middle, m_latencies.end());
            latency = *middle;
        }
        // Fewer errors than one a second are still errors.
        const std::array<std::uint16_t, 3> raw{
            clampedWord(std::round(rate * kRateScale)), latency,
            static_cast<std::uint16_t>(std::min(std::ceil(errors), 255.0))};
        m_store.append(Source::linkHealth(), raw, now);
    }
    m_healthStart = now;
    m_healthBefore = stats;
    m_latencies.clear();
}

} // namespace trex
