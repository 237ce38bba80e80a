// SPDX-License-Identifier: GPL-3.0-or-later
// LinkEngine's receiving half: echo, replies, resynchronisation.
#include "protocol/codec/crc7.h"
#include "protocol/session/linkengine.h"

#include <algorithm>

namespace trex {

namespace {

using namespace std::chrono_literals;

// A USB adapter hands bytes on in chunks up to 16 ms apart (FTDI's latency timer).
constexpr auto kAdapterGap = 20ms;
// A line that never falls quiet is asked all the same: no answer through the noise is a loss.
constexpr auto kLongestNoise = 50ms;
// Of what comes while a signature or the synchronising reply is awaited, the end is enough.
constexpr qsizetype kMostKept = 256;
constexpr qsizetype kKept = 32;

bool isModeLetter(char letter)
{
    return letter == 'R' || letter == 'A' || letter == 'r' || letter == 'a';
}

int wordAt(QByteArrayView bytes, qsizetype index)
{
    return static_cast<std::uint8_t>(bytes[index])
        | (static_cast<std::uint8_t>(bytes[index + 1]) << 8);
}

} // namespace

bool isPlausible(const Command& command, QByteArrayView payload)
{
    const auto byte = [&](qsizetype i) { return static_cast<std::uint8_t>(payload[i]); };
    const std::string_view key = command.row().key;
    if (key == "get-signature") {
        return parseSignature(payload).has_value();
    }
    if (key == "get-mode") {
        return isModeLetter(payload[0]);
    }
    if (key == "get-serial-control") {
        return byte(0) <= 1;
    }
    if (key == "get-status") {
        return (byte(0) & 0x0E) == 0; // bits 3-1 not used (command documentation, 0x84)
    }
    if (key == "get-raw-channels") {
        // 1250 to 6250 units of 0.4 µs, 10-bit voltages, or 0xFFFF (facts.md 5.1, 5.2).
        for (qsizetype i = 0; i + 1 < payload.size(); i += 2) {
            const int raw = wordAt(payload, i);
            if (raw > 6250 && raw != kInvalidPulse) {
                return false;
            }
        }
        return true;
    }
    if (key == "get-calibration") {
        return wordAt(payload, 0) <= wordAt(payload, 2) && wordAt(payload, 2) <= wordAt(payload, 4);
    }
    if (key == "get-learned") {
        return byte(0) <= kAllChannelsMask;
    }
    return true;
}

std::uint8_t deviceAfter(const Command& command, QByteArrayView payload, std::uint8_t device)
{
    // Command documentation, 0xAF: number, value, 0x55, 0x2A; answer 0 is done.
    const bool isDone = command.opcode == commandRow("set-parameter").first && payload.size() == 1
        && payload[0] == 0 && command.data.size() == 4 && command.data[0] == 0;
    return isDone ? static_cast<std::uint8_t>(command.data[1]) : device;
}

void LinkEngine::received(QByteArrayView bytes, Instant at)
{
    if (at < m_guard.deafUntil) {
        return; // of a line that was set otherwise
    }
    const qsizetype earlier = m_flight ? m_flight->heldBefore : 0;
    const QByteArray held = std::exchange(m_undecided, {}) + bytes.toByteArray();
    QByteArrayView rest = held;
    if (m_echo == Echo::Unknown && !m_pendingEcho.isEmpty()) {
        const qsizetype common = std::min(held.size(), m_pendingEcho.size());
        if (QByteArrayView(held).first(common) != QByteArrayView(m_pendingEcho).first(common)) {
            m_echo = Echo::No;
            m_pendingEcho.clear();
            if (earlier > 0) { // no echo after all, and no reply to what was sent only then
                flushed(earlier, at);
                rest = rest.sliced(earlier);
            }
        } else if (held.size() > m_pendingEcho.size()) {
            m_echo = Echo::Yes;
            m_batch.events.push_back(
                {LinkEvent::Kind::EchoFound, m_state, std::nullopt, std::nullopt, at});
        } else {
            m_undecided = held; // may still be echo or a reply that looks like it
            return;
        }
    }
    if (m_echo == Echo::Yes) {
        rest = stripEcho(rest);
    }
    if (!rest.isEmpty()) {
        deliver(rest, at);
    }
}

QByteArrayView LinkEngine::stripEcho(QByteArrayView bytes)
{
    const qsizetype common = std::min(bytes.size(), m_pendingEcho.size());
    qsizetype same = 0;
    while (same < common && bytes[same] == m_pendingEcho[same]) {
        ++same;
    }
    if (same < common) {
        // The echo itself was damaged on the wire; what follows cannot be told from a reply.
        m_pendingEcho.clear();
        m_needsSync = true;
    } else {
        m_pendingEcho.remove(0, common);
    }
    return bytes.sliced(same);
}

void LinkEngine::deliver(QByteArrayView bytes, Instant at)
{
    m_batch.stats.bytesReceived += static_cast<quint64>(bytes.size());
    HealthCounts& health = m_rates.health.at(at);
    const auto count = static_cast<int>(bytes.size());
    health.addBytes(m_settings.timeOf(count), count);
    if (!m_flight) {
        health.addUnasked(bytes, m_needsSync || m_failures > 0 || m_state != LinkState::Connected,
                          !m_noisySince);
        flushed(bytes.size(), at);
        return;
    }
    Flight& flight = *m_flight;
    flight.received += bytes.toByteArray();
    flight.lastByte = at;
    if (!flight.queued.transaction.rawBytes.isEmpty()) {
        deliverRaw(at);
        return;
    }
    if (flight.queued.role == Role::Identify) {
        deliverIdentify(at);
        return;
    }
    if (flight.queued.role == Role::Probe) {
        deliverProbe(at);
        return;
    }
    if (flight.queued.role == Role::Synchronise) {
        // Replies come in order: what is there when the line falls quiet ends with ours.
        if (isModeLetter(flight.received[flight.received.size()
                                         - (m_settings.hasCrc()
                                                ? std::min<qsizetype>(2, flight.received.size())
                                                : 1)])) {
            flight.deadline = std::min(flight.limit, at + quietGap());
        } else {
            ++health.lateReplies;
            noteLateness(); // a reply to an earlier query: this line answers later than we waited
            flight.deadline = std::min(
                flight.limit, std::max(flight.deadline, at + m_settings.timeout + m_slack));
        }
        if (flight.received.size() > kMostKept) {
            failFlight(ErrorCode::BadReply, at); // no late replies: noise
        }
        return;
    }
    const int used = flight.parser.feed(bytes);
    judgeNormal(bytes.size() - used, at);
}

void LinkEngine::judgeNormal(qsizetype surplus, Instant at)
{
    Flight& flight = *m_flight;
    switch (flight.parser.verdict()) {
    case ReplyParser::Verdict::NeedMore:
        // The rest follows within byte times and an adapter's chunking, or never.
        flight.deadline =
            std::min(flight.deadline,
                     at + m_settings.timeOf(flight.parser.expectedBytes())
                         + std::max<Duration>(kAdapterGap * 2, m_settings.timeout / 2));
        return;
    case ReplyParser::Verdict::BadCrc:
        m_batch.stats.surplusBytes += static_cast<quint64>(surplus);
        failFlight(ErrorCode::BadReplyCrc, at);
        return;
    case ReplyParser::Verdict::Complete:
        break;
    }
    const QByteArray payload = flight.parser.payload();
    if (surplus > 0 || !isPlausible(flight.queued.transaction.command, payload)) {
        // More bytes than the reply has: one of them is foreign, and nothing says which.
        m_batch.stats.surplusBytes += static_cast<quint64>(surplus);
        failFlight(ErrorCode::BadReply, at);
        return;
    }
    if (flight.queued.transaction.priority == Priority::User && !m_settings.hasCrc()) {
        // One byte of a reply looks like any other: it is believed when no more follow. Polls are
        // not watched, which would cost a part of their rate.
        flight.isComplete = true;
        flight.deadline = at + m_settings.timeOf(2);
        return;
    }
    complete(payload, at);
}

void LinkEngine::deliverRaw(Instant at)
{
    const Flight& flight = *m_flight;
    const int crc = m_settings.hasCrc() ? 1 : 0;
    const qsizetype wanted = flight.queued.transaction.rawReplyBytes + crc;
    if (flight.received.size() < wanted) {
        return;
    }
    const QByteArrayView reply = QByteArrayView(flight.received).first(wanted);
    m_batch.stats.surplusBytes += static_cast<quint64>(flight.received.size() - wanted);
    if (crc == 1
        && crc7(reply.chopped(1), m_settings.polynomial)
            != static_cast<std::uint8_t>(reply.back())) {
        failFlight(ErrorCode::BadReplyCrc, at);
        return;
    }
    complete(reply.chopped(crc).toByteArray(), at);
}

void LinkEngine::onDeadline(Instant now)
{
    if (m_echo == Echo::Unknown && !m_undecided.isEmpty()) {
        settleUndecided(now);
        if (!m_flight) {
            return;
        }
    }
    const Flight& flight = *m_flight;
    if (flight.isComplete) {
        complete(flight.parser.payload(), flight.lastByte);
        return;
    }
    if (flight.queued.role == Role::Probe && isProbeAnswered()) {
        onProbeAnswered(now);
        return;
    }
    if (flight.queued.role == Role::Synchronise) {
        QByteArrayView bytes = flight.received;
        const qsizetype tail = m_settings.hasCrc() ? 2 : 1;
        const bool quiet = now >= flight.lastByte + quietGap();
        const bool letter = quiet && bytes.size() >= tail
            && isModeLetter(bytes[bytes.size() - tail])
            && (tail == 1
                || crc7(bytes.last(2).first(1), m_settings.polynomial)
                    == static_cast<std::uint8_t>(bytes.back()));
        if (letter) {
            m_batch.stats.surplusBytes += static_cast<quint64>(bytes.size() - tail);
            synchronised(now);
            return;
        }
    }
    failFlight(flight.received.isEmpty() ? ErrorCode::NoReply : ErrorCode::ShortReply, now);
}

/// What came is exactly (a part of) what was sent: the echo alone, or a reply that equals it.
void LinkEngine::settleUndecided(Instant now)
{
    const QByteArray held = std::exchange(m_undecided, {});
    const bool isRaw = !m_flight->queued.transaction.rawBytes.isEmpty();
    const qsizetype wanted = isRaw
        ? m_flight->queued.transaction.rawReplyBytes + (m_settings.hasCrc() ? 1 : 0)
        : m_flight->parser.expectedBytes();
    if (held.size() == wanted && held.size() < m_pendingEcho.size() && m_flight->heldBefore == 0) {
        m_echo = Echo::No;
        m_pendingEcho.clear();
        deliver(held, now);
        return;
    }
    m_guard.sawEchoOnly = held.size() == m_pendingEcho.size();
    m_pendingEcho.clear();
}

void LinkEngine::synchronised(Instant at)
{
    const Flight flight = std::move(*m_flight);
    m_flight.reset();
    record(flight, at, std::nullopt);
    m_needsSync = false;
    if (std::exchange(m_syncFailures, 0) > 0) {
        // More than one was asked: the answer to the other may still be on its way.
        m_quietUntil = std::max(at + m_settings.timeout + m_slack,
                                flight.sent + m_settings.timeout + kMostSlack);
    }
    m_failures = 0;
    m_lastValid = at;
    ++m_batch.stats.resyncs;
    ++m_rates.health.at(at).resyncs;
    m_batch.events.push_back(
        {LinkEvent::Kind::Resynchronised, m_state, std::nullopt, std::nullopt, at});
}

void LinkEngine::complete(const QByteArray& payload, Instant at)
{
    const Flight flight = std::move(*m_flight);
    m_flight.reset();
    record(flight, at, std::nullopt);
    m_failures = 0;
    m_lastValid = at;
    const bool isWrite = flight.queued.transaction.rawBytes.isEmpty()
        && flight.queued.transaction.command.row().needsSerialMode;
    if (std::exchange(m_maybeMisheard, false) && !m_motionSent) {
        m_motionSent = true;
        queueStopForLoss();
    }
    // 0 done, 3 not in serial mode (command documentation, 0xA0 and 0xAF): it was heard as meant.
    if (isWrite && payload != QByteArray(1, '\0') && payload != QByteArray(1, '\3')) {
        stopAfterWrite();
    }
    m_settings.device = deviceAfter(flight.queued.transaction.command, payload, m_settings.device);
    const Duration trip = at - flight.sent;
    const Duration wire =
        m_settings.timeOf(static_cast<int>(flight.sentBytes.size() + flight.received.size()));
    const double trips = std::chrono::duration<double, std::milli>(trip).count();
    LinkStats& stats = m_batch.stats;
    ++m_rates.health.at(at).replies;
    const std::uint8_t opcode = flight.queued.transaction.command.opcode;
    if (opcode == commandRow("get-uart-errors").first && !payload.isEmpty()) {
        m_rates.health.at(at).addUartErrors(static_cast<std::uint8_t>(payload.front()));
    }
    stats.roundTripMs = stats.roundTripMs <= 0.0 ? trips : stats.roundTripMs * 0.95 + trips * 0.05;
    const bool isRaw = !flight.queued.transaction.rawBytes.isEmpty();
    if (!isRaw && !flight.queued.transaction.command.row().needsSerialMode) {
        const auto overhead =
            static_cast<double>(std::max<Duration>(trip - wire, Duration::zero()).count());
        m_overheadNs += (overhead - m_overheadNs) * 0.02;
        m_plan.setOverhead(Duration(static_cast<Duration::rep>(m_overheadNs)));
        m_rates.health.at(at).addReply(trip, wire);
    }
    if (flight.queued.poll) {
        ++m_rates.samples.at(static_cast<std::size_t>(*flight.queued.poll));
        m_batch.samples.push_back(decodePoll(*flight.queued.poll, payload, at));
    }
    finish(flight.queued,
           Reply{flight.queued.transaction.command, payload, flight.sentBytes, flight.sent, at});
}

void LinkEngine::flushed(qsizetype bytes, Instant at)
{
    m_batch.stats.surplusBytes += static_cast<quint64>(bytes);
    m_needsSync = m_state == LinkState::Connected && m_identify;
    if (m_again.at
        && !m_again.isRepeating) { // the controller did send, and listens when it has done
        m_again.at = std::min(m_again.latest, at + m_settings.timeOf(2));
    }
    m_noisySince = m_noisySince.value_or(at);
    m_quietUntil =
        std::max(m_quietUntil, std::min(at + m_settings.timeOf(2), *m_noisySince + kLongestNoise));
}

Duration LinkEngine::quietGap() const
{
    return std::max<Duration>(kAdapterGap, m_settings.timeOf(3));
}

void LinkEngine::noteLateness()
{
    m_slack = std::min<Duration>(m_slack + m_settings.timeout, kMostSlack);
}

} // namespace trex
