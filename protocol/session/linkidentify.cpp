// SPDX-License-Identifier: GPL-3.0-or-later
// How LinkEngine finds out whether a controller is there, on a line that may be set wrong.
#include "protocol/codec/packet.h"
#include "protocol/session/linkengine.h"

#include <algorithm>

namespace trex {

namespace {

using namespace std::chrono_literals;

constexpr auto kIdentifyInterval = 250ms;
// Of what comes while an answer is awaited, the end is enough.
constexpr qsizetype kMostKept = 256;
constexpr qsizetype kKept = 32;

/// The end of what came is an answer to the question. Of several controllers on the line (Pololu
/// form) all answer, and their answers may join to something else: its length is enough.
bool isProbeAnswer(const Command& asked, QByteArrayView bytes, const LineSettings& line)
{
    ReplyParser parser(asked, line);
    const int length = parser.expectedBytes();
    if (bytes.size() < length) {
        return false;
    }
    parser.feed(bytes.last(length));
    const bool isGood =
        parser.verdict() == ReplyParser::Verdict::Complete && isPlausible(asked, parser.payload());
    return isGood || (line.form == PacketForm::Pololu && bytes.size() == length);
}

} // namespace

void LineGuard::drop()
{
    isUnclear = isUnclear || !pieces.empty();
    pieces.clear();
    questionFollows = false;
}

void LineGuard::clear(const LineSettings& own, bool canSetLine)
{
    if (std::exchange(isUnclear, false)) {
        const auto closing = lineClearing();
        pieces.assign(closing.begin(), canSetLine ? closing.end() : closing.begin() + 1);
        if (!canSetLine) {
            pieces.front().line = own;
        }
        questionFollows = false;
    }
}

/// 0x81 would be readable as a motor command at other speeds: it is sent where somebody has
/// answered what is not (LineProbe).
std::optional<LinkEngine::Queued> LinkEngine::chooseIdentify(Instant now)
{
    if (m_state == LinkState::Disconnected || now < m_guard.nextIdentify) {
        return std::nullopt;
    }
    m_guard.nextIdentify = now + kIdentifyInterval;
    if (m_guard.isAnswered) {
        return Queued{{.command = query("get-signature")}, 1, std::nullopt, Role::Identify};
    }
    const LineProbe probe = lineProbe(m_settings);
    m_guard.isUnclear = true;
    if (probe.pieces.size() > 1 && m_canSetLine) {
        m_guard.pieces.assign(probe.pieces.begin(), probe.pieces.end() - 1);
        m_guard.questionFollows = true;
        return std::nullopt;
    }
    return Queued{{.command = probe.query}, 1, std::nullopt, Role::Probe};
}

/// In one form, which reads as no order at other speeds; the end of it when the rest is out.
QByteArray LinkEngine::probeBytes(Instant now)
{
    ++m_guard.asked;
    m_guard.lastAsked = now;
    QByteArray bytes;
    for (const WirePiece& piece : lineProbe(m_settings).pieces) {
        if (m_guard.line) {
            bytes = piece.bytes;
        } else if (piece.line.baud == m_settings.baud) {
            bytes += piece.bytes;
        }
    }
    return bytes;
}

/// Each on the line as it wants it, when the one before has had its time and a rest.
LinkEngine::Action LinkEngine::sendPiece(Instant now)
{
    const Instant free = m_lineFreeAt + kWireRest;
    if (now < free) {
        return {Action::Kind::Wait, free, {}};
    }
    if (m_guard.pieces.empty()) {
        m_guard.questionFollows = false;
        return send({{.command = lineProbe(m_settings).query}, 1, std::nullopt, Role::Probe}, now);
    }
    const WirePiece piece = std::move(m_guard.pieces.front());
    m_guard.pieces.pop_front();
    m_guard.line = m_canSetLine ? std::optional(piece.line) : std::nullopt;
    m_lineFreeAt = now + piece.line.timeOf(static_cast<int>(piece.bytes.size()));
    m_guard.deafUntil = m_lineFreeAt + kWireRest;
    m_quietUntil = std::max(m_quietUntil, m_guard.deafUntil);
    m_batch.stats.bytesSent += static_cast<quint64>(piece.bytes.size());
    m_batch.records.push_back(
        {{}, Priority::User, piece.bytes, {}, now, now, 1, std::nullopt, true});
    return {Action::Kind::Send, now, piece.bytes, m_guard.line};
}

void LinkEngine::deliverIdentify(Instant at)
{
    QByteArray& bytes = m_flight->received;
    const qsizetype start = bytes.indexOf("TReX");
    if (start < 0 || bytes.size() < start + 5) {
        if (bytes.size() > kMostKept) {
            bytes = bytes.last(kKept);
        }
        return;
    }
    ReplyParser parser(query("get-signature"), m_settings);
    const int used = parser.feed(QByteArrayView(bytes).sliced(start));
    if (parser.verdict() == ReplyParser::Verdict::NeedMore) {
        return;
    }
    if (parser.verdict() == ReplyParser::Verdict::BadCrc) {
        failFlight(ErrorCode::BadReplyCrc, at);
        return;
    }
    const auto signature = parseSignature(parser.payload());
    if (!signature) {
        failFlight(ErrorCode::BadReply, at);
        return;
    }
    const qsizetype foreign = bytes.size() - used;
    complete(parser.payload(), at);
    m_guard.tries = 0;
    m_guard.received.clear();
    m_guard.sawEchoOnly = false;
    m_wasConnected = true;
    m_guard.isAnswered = false;
    m_guard.isUnclear = false;
    if (std::exchange(m_guard.asked, 0) > 1) {
        // The answer to another question may still be on its way, and nothing tells it from others.
        m_quietUntil = std::max(m_quietUntil, m_guard.lastAsked + m_settings.timeout + kMostSlack);
    }
    m_batch.events.push_back(
        {LinkEvent::Kind::Identified, LinkState::Connected, std::nullopt, *signature, at});
    setState(LinkState::Connected, std::nullopt, at);
    queueStopForLoss();
    m_plan.restart(at);
    m_needsSync = false;
    if (foreign > 0) {
        flushed(foreign, at);
    }
}

/// No wrong speed makes a query of the question: whoever answers has heard it.
void LinkEngine::deliverProbe(Instant at)
{
    Flight& flight = *m_flight;
    if (flight.received.contains("TReX")) {
        deliverIdentify(at); // the late answer to an earlier question
    } else if (flight.received.size() == flight.parser.expectedBytes() && isProbeAnswered()) {
        onProbeAnswered(at);
    } else if (flight.received.size() > flight.parser.expectedBytes()) {
        flight.deadline = std::min(flight.limit, at + quietGap()); // its end may be the answer
        if (flight.received.size() > kMostKept) {
            flight.received = flight.received.last(kKept);
        }
    }
}

bool LinkEngine::isProbeAnswered() const
{
    return isProbeAnswer(m_flight->queued.transaction.command, m_flight->received, m_settings);
}

void LinkEngine::onProbeAnswered(Instant at)
{
    const Flight flight = std::move(*m_flight);
    m_flight.reset();
    record(flight, at, std::nullopt);
    m_guard.isAnswered = true;
    m_guard.isUnclear = false;
    m_guard.nextIdentify = at;
    const Command& asked = flight.queued.transaction.command;
    if (asked == query("get-status")) { // cleared there by reading
        ReplyParser parser(asked, m_settings);
        parser.feed(QByteArrayView(flight.received).last(parser.expectedBytes()));
        // Its length alone may have been enough of an answer; it is not enough of a value.
        if (parser.verdict() == ReplyParser::Verdict::Complete
            && isPlausible(asked, parser.payload())) {
            m_batch.samples.push_back(decodePoll(PollId::Status, parser.payload(), at));
        }
    }
}

} // namespace trex
