// SPDX-License-Identifier: GPL-3.0-or-later
// LinkEngine's stop: before everything, past a reply that does not come, and again in doubt.
#include "protocol/session/linkengine.h"

#include <algorithm>

namespace trex {

namespace {

using namespace std::chrono_literals;

// No stop waits longer, whatever the timeout is.
constexpr auto kStopPatience = 100ms;
constexpr int kLongestPacket = 16; // of the document's, with header and CRC byte
// For the controller's own time and the way through the system, beyond what was measured.
constexpr auto kReplyMargin = 300us;
// So long after an error of the line a stop goes out twice.
constexpr auto kDoubtfulFor = 2s;
constexpr auto kRepeatAfter = 20ms;
constexpr auto kRepeatInterval = 1s;

} // namespace

void LinkEngine::stop(const std::vector<Transaction>& packets, Instant now)
{
    for (const std::size_t slot : m_motorOrder) {
        finish(Queued{*m_motors.at(slot)}, fail(ErrorCode::Cancelled));
        m_motors.at(slot).reset();
    }
    m_motorOrder.clear();
    // Raw bytes may hold a motor command: what waits behind the stop must not start it again.
    std::deque<Queued> kept;
    for (const Queued& queued : m_users) {
        if (queued.transaction.rawBytes.isEmpty()) {
            kept.push_back(queued);
        } else {
            finish(queued, fail(ErrorCode::Cancelled));
        }
    }
    m_users = std::move(kept);
    if (!m_open) {
        for (const Transaction& packet : packets) {
            finish(Queued{packet}, fail(ErrorCode::NotConnected));
        }
        return;
    }
    m_again = {.packets = packets, .lastFailure = m_again.lastFailure};
    for (const Transaction& packet : packets) {
        m_stops.push_back({packet});
    }
    if (m_flight && !packets.empty()) {
        m_flight->limit =
            std::min(m_flight->limit, now + kStopPatience + m_settings.timeOf(2 * kLongestPacket));
        m_flight->deadline = std::min(m_flight->deadline, m_flight->limit);
    }
    m_quietUntil = now;
}

/// Half as much again as the replies of late have taken beyond their time on the wire.
Duration LinkEngine::usualOverhead() const
{
    return Duration(static_cast<Duration::rep>(m_overheadNs * 1.5)) + kReplyMargin;
}

Instant LinkEngine::overdueAt() const
{
    const Flight& flight = *m_flight;
    // While its bytes keep coming, the controller sends and is deaf.
    const Instant quiet = flight.received.isEmpty()
        ? flight.expected
        : flight.lastByte + m_settings.timeOf(1) + kReplyMargin;
    return std::min(std::max(flight.expected, quiet), flight.deadline);
}

/// None: nothing stands in the way of what waits to be sent.
std::optional<LinkEngine::Action> LinkEngine::waitForFlight(Instant now)
{
    if (!m_flight) {
        return std::nullopt;
    }
    if (now >= m_flight->deadline || (m_flight->isComplete && !m_stops.empty())) {
        onDeadline(now);
    } else if (m_open && !m_stops.empty() && now >= overdueAt()) {
        overtake(now);
        return std::nullopt;
    }
    if (!m_flight) {
        return std::nullopt;
    }
    const Instant until = m_stops.empty() ? m_flight->deadline : overdueAt();
    return Action{Action::Kind::Wait, std::max(until, now), {}};
}

/// The reply is overdue: a part of it was lost, or all, or the request. If it should come all the
/// same, the controller may be deaf to this stop, so that another follows when it cannot be any
/// more. Until then nothing is asked, as if the reply were still waited for.
void LinkEngine::overtake(Instant now)
{
    m_again.latest = m_flight->deadline;
    m_again.at = m_again.latest;
    if (m_flight->queued.role == Role::Normal) {
        failFlight(m_flight->received.isEmpty() ? ErrorCode::NoReply : ErrorCode::ShortReply, now);
        m_quietUntil = std::max(m_quietUntil, m_again.latest);
    }
}

/// The last packet of a stop is on its way out.
void LinkEngine::doubtStop()
{
    const Duration clean = m_lineFreeAt - m_again.lastFailure;
    if (m_open && !m_again.at && clean < (m_again.isRepeating ? kRepeatInterval : kDoubtfulFor)) {
        m_again.latest = m_lineFreeAt + (m_again.isRepeating ? kRepeatInterval : kRepeatAfter);
        m_again.at = m_again.latest;
    }
}

void LinkEngine::stopOnceMore(Instant now)
{
    if (m_open && m_stops.empty() && m_again.at && now >= *m_again.at) {
        for (Transaction packet : m_again.packets) {
            packet.id = 0;
            m_stops.push_back({packet});
        }
        m_again.isRepeating = true;
        m_again.at.reset();
    }
}

} // namespace trex
