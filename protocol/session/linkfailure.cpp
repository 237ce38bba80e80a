// SPDX-License-Identifier: GPL-3.0-or-later
// LinkEngine's states, and what follows from a transaction that failed.
#include "protocol/codec/packet.h"
#include "protocol/session/linkengine.h"

#include <algorithm>

namespace trex {

namespace {

using namespace std::chrono_literals;

constexpr int kIdentifyTriesBeforeTold = 3;
// Silence is noticed within a second, yet a few corrupted replies in a row on a noisy line are not
// taken for it.
constexpr int kFailuresOfLoss = 3;
constexpr auto kSilenceOfLoss = 500ms;

} // namespace

void LinkEngine::setState(LinkState state, const std::optional<Error>& error, Instant now)
{
    if (state == m_state && !error) {
        return;
    }
    m_state = state;
    m_batch.events.push_back({LinkEvent::Kind::StateChanged, state, error, std::nullopt, now});
}

void LinkEngine::queueStopForLoss()
{
    // Motors may still run by our last order: the first thing a regained (or half-dead) line hears
    // is stop.
    if (!m_motionSent || !m_open || !m_stops.empty()) {
        return;
    }
    m_again = {.lastFailure = m_again.lastFailure};
    for (const Command& command : stopCommands(false)) {
        m_again.packets.push_back({.command = command, .priority = Priority::Stop});
        m_stops.push_back({m_again.packets.back()});
    }
}

/// A damaged byte of a setting may have begun a motor command, with what followed for its speed
/// (and, one time in 128, for its CRC byte). Where the answer is not the one of a setting that was
/// taken, stop is sent: at once, or as soon as the line is back. With CRC-7 it is so unlikely that
/// motors which somebody has set going are left alone, here or by another program.
void LinkEngine::stopAfterWrite()
{
    const bool isUnlikely = m_settings.hasCrc() && (m_motionSent || !m_stopsInDoubt);
    if (m_identify && m_state == LinkState::Connected && !isUnlikely) {
        m_motionSent = true;
        queueStopForLoss();
    }
}

void LinkEngine::loseLink(const Error& error, Instant now)
{
    for (const std::size_t slot : std::exchange(m_motorOrder, {})) {
        finish(Queued{*m_motors.at(slot)}, tl::make_unexpected(error));
        m_motors.at(slot).reset();
    }
    if (m_retry) {
        finish(*m_retry, tl::make_unexpected(error));
        m_retry.reset();
    }
    for (const Queued& queued : std::exchange(m_users, {})) {
        finish(queued, tl::make_unexpected(error));
    }
    ++m_rates.health.at(now).losses;
    setState(LinkState::Lost, error, now);
    queueStopForLoss(); // and again when the link is back: this one may not be heard
    m_guard.nextIdentify = now;
    m_guard.tries = 0;
    m_guard.isAnswered = false; // it may come back with other settings
    m_guard.asked = 1; // what was lost may still be answered
    m_needsSync = false;
}

void LinkEngine::failFlight(ErrorCode code, Instant now)
{
    Flight flight = std::move(*m_flight);
    m_flight.reset();
    record(flight, now, code);
    if (!flight.queued.transaction.rawBytes.isEmpty()
        || flight.queued.transaction.command.row().needsSerialMode) {
        stopAfterWrite();
    }
    if (m_stopsInDoubt && code == ErrorCode::NoReply && flight.sentBytes.size() > 1
        && flight.queued.role == Role::Normal) {
        // Without CRC-7 one bit makes "accelerate motor 1" of the raw channels' query; at another
        // speed of a controller that has restarted, more do so. One byte alone is no order.
        m_maybeMisheard = true;
    }
    ++m_failures;
    m_again.lastFailure = now;
    LinkStats& stats = m_batch.stats;
    if (code == ErrorCode::BadReplyCrc) {
        ++stats.crcErrors;
    } else if (code == ErrorCode::BadReply) {
        ++stats.badReplies;
    } else {
        ++stats.timeouts;
    }
    if (m_state == LinkState::Connected) { // else it is only looked for
        m_rates.health.at(now).addFailure(code);
    }
    if (code != ErrorCode::BadReplyCrc) {
        m_needsSync = true;
    }
    m_quietUntil = now + m_settings.timeOf(2);
    Queued& queued = flight.queued;
    if (queued.role == Role::Identify || queued.role == Role::Probe) {
        m_guard.isAnswered = false;
        if (!lineProbe(m_settings).mayRepeat) {
            m_guard.clear(m_settings, m_canSetLine);
        }
        m_guard.received += flight.received;
        if (++m_guard.tries == kIdentifyTriesBeforeTold) {
            const Error error = identifyFailure();
            setState(m_reconnect ? LinkState::Retrying : LinkState::Disconnected, error, now);
            if (!m_reconnect) {
                m_guard.clear(m_settings, m_canSetLine);
            }
            m_open = m_open && (m_reconnect || !m_stops.empty()); // what is to stop goes out yet
            if (!m_open) {
                m_again.at.reset();
            }
            m_guard.received.clear();
        } else if (m_state == LinkState::Lost) {
            setState(LinkState::Retrying, std::nullopt, now);
        }
        queueStopForLoss();
        if (m_settings.echo == EchoMode::Auto) {
            m_echo = Echo::Unknown;
            m_pendingEcho.clear();
        }
        return;
    }
    const Error error{code, {}};
    const bool silent = m_failures >= kFailuresOfLoss && now - m_lastValid >= kSilenceOfLoss;
    if (queued.role == Role::Synchronise) {
        if (++m_syncFailures % 2 == 0 && !(m_identify && silent)) {
            if (m_retry) {
                finish(*std::exchange(m_retry, std::nullopt), tl::make_unexpected(error));
            } else if (!m_users.empty()) {
                finish(m_users.front(), tl::make_unexpected(error));
                m_users.pop_front();
            }
        }
    } else {
        const bool isRaw = !queued.transaction.rawBytes.isEmpty();
        const Retry retry = isRaw ? Retry::Never : queued.transaction.command.row().retry;
        if (retry == Retry::ReadClears) {
            ++stats.lostLatchReads;
            m_batch.events.push_back(
                {LinkEvent::Kind::LatchReadLost, m_state, std::nullopt, std::nullopt, now});
        }
        const bool may = retry == Retry::Safe || retry == Retry::ReadClears;
        // A poll that waits to be asked again makes room for what somebody asked for.
        const bool room = !m_retry
            || (m_retry->transaction.priority == Priority::Poll
                && queued.transaction.priority == Priority::User);
        if (may && queued.attempt < kMostAttempts && room && !m_shutDown) {
            ++queued.attempt;
            m_retry = queued;
        } else {
            finish(queued, tl::make_unexpected(error));
        }
    }
    if (m_identify && silent && m_state == LinkState::Connected) {
        loseLink({ErrorCode::NoReply, {}}, now);
    }
}

Error LinkEngine::identifyFailure() const
{
    if (m_guard.received.isEmpty()) {
        return {m_guard.sawEchoOnly ? ErrorCode::EchoOnly : ErrorCode::NoReply, {}};
    }
    const bool printable = std::all_of(m_guard.received.begin(), m_guard.received.end(),
                                       [](char c) { return c >= 0x20 && c < 0x7F; });
    const QByteArray seen = m_guard.received.left(24);
    return printable ? Error{ErrorCode::NotATrex, QString::fromLatin1(seen)}
                     : Error{ErrorCode::Garbage, toHex(seen)};
}

} // namespace trex
