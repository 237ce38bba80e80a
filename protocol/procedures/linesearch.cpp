// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/linesearch.h"

#include "protocol/codec/packet.h"
#include "protocol/codec/replyparser.h"
#include "protocol/session/transaction.h"

#include <algorithm>
#include <ranges>
#include <utility>

namespace trex {
namespace {

constexpr int kSignatureJr = 9; // command documentation, 0x81

// The likeliest first: as it leaves the factory, then what people set.
constexpr std::array kByLikelihood{19200, 115200, 9600,  57600, 38400, 28800,
                                   14400, 4800,   76800, 2400,  1200};
static_assert(kByLikelihood.size() == kBaudRates.size());

/// As it goes out: one form, and time for the receiver between the bytes.
LineSettings onWire(LineSettings line)
{
    line.form = PacketForm::Compact;
    line.stopBits = 2;
    line.echo = EchoMode::Off; // taken off here, so that an echo alone is seen
    line.timeout = LineSearch::kReplyTimeout;
    return line;
}

bool isSameTry(const LineSettings& a, const LineSettings& b)
{
    return a.baud == b.baud && a.errorDetection == b.errorDetection
        && (!a.hasCrc() || a.polynomial == b.polynomial);
}

/// The payload when these bytes are exactly one reply of that length.
std::optional<QByteArray> payloadOf(const Command& asked, QByteArrayView bytes,
                                    const LineSettings& line)
{
    ReplyParser parser(asked, line);
    const int used = parser.feed(bytes);
    return parser.verdict() == ReplyParser::Verdict::Complete && used == bytes.size()
        ? std::optional(parser.payload())
        : std::nullopt;
}

} // namespace

std::optional<Signature> signatureIn(QByteArrayView bytes, const LineSettings& line)
{
    const qsizetype start = bytes.toByteArray().indexOf("TReX");
    if (start < 0) {
        return std::nullopt;
    }
    // The parser knows that a TReX answers two bytes fewer than a TReX Jr (conformance C-70).
    ReplyParser parser(query("get-signature"), line);
    parser.feed(bytes.sliced(start));
    if (parser.verdict() != ReplyParser::Verdict::Complete) {
        return std::nullopt;
    }
    const auto signature = parseSignature(parser.payload());
    return signature ? std::optional(*signature) : std::nullopt;
}

LineSearch::LineSearch(const LineSearchOptions& options) : m_options(options)
{
    plan(options);
}

void LineSearch::plan(const LineSearchOptions& options)
{
    if (!options.only.empty()) {
        for (const LineSettings& line : options.only) {
            m_steps.push_back(onWire(line));
        }
        return;
    }
    std::vector<LineSettings> known = options.remembered;
    known.push_back(options.given);
    if (!options.isNetwork) {
        known.emplace_back(); // as it leaves the factory
    }
    for (const LineSettings& line : known) {
        addTry(line);
    }
    LineSettings line = options.given;
    for (const ErrorDetection detection : {ErrorDetection::None, ErrorDetection::Crc7,
                                           ErrorDetection::Even}) { // none asks odd parity too
        line.errorDetection = detection;
        if (detection == ErrorDetection::Crc7) {
            planCrc(known);
        } else if (!options.isNetwork) {
            for (const int baud : kByLikelihood) {
                line.baud = baud;
                addTry(line);
            }
        } else if (detection == ErrorDetection::None) {
            addTry(line);
        }
    }
}

/// With the polynomials that are known of this port, then the one of the factory.
void LineSearch::planCrc(const std::vector<LineSettings>& known)
{
    std::vector<std::uint8_t> polynomials;
    for (const LineSettings& line : known) {
        polynomials.push_back(line.polynomial);
    }
    polynomials.push_back(kDefaultPolynomial);
    LineSettings line = m_options.given;
    line.errorDetection = ErrorDetection::Crc7;
    for (const std::uint8_t polynomial : polynomials) {
        line.polynomial = polynomial;
        for (const int baud : kByLikelihood) {
            if (!m_options.isNetwork || baud == m_options.given.baud) {
                line.baud = baud;
                addTry(line);
            }
        }
    }
}

void LineSearch::addTry(const LineSettings& line)
{
    const LineSettings wired = onWire(line);
    if (isPlanned(wired)) {
        return;
    }
    if (m_options.isNetwork || lineProbe(wired).isClean) {
        m_steps.push_back(wired);
    } else if (std::ranges::none_of(m_leftOut, [&wired](const LineSettings& other) {
                   return isSameTry(other, wired);
               })) {
        m_leftOut.push_back(wired);
    }
}

bool LineSearch::isPlanned(const LineSettings& line) const
{
    return std::ranges::any_of(m_steps,
                               [&line](const LineSettings& step) { return isSameTry(step, line); });
}

int LineSearch::total() const
{
    return m_done + static_cast<int>(m_steps.size());
}

LineSearch::Ask LineSearch::ask(const char* key, int payload) const
{
    const QByteArray bytes = encode(query(key), m_current);
    return {m_current, bytes, static_cast<int>(bytes.size()) + payload};
}

std::optional<LineSearch::Ask> LineSearch::next()
{
    if (m_found) {
        return std::nullopt;
    }
    if (m_pieces.empty() && m_stage == Stage::Signature) {
        m_pieces.push_back(ask("get-signature", kSignatureJr));
    } else if (m_pieces.empty() && m_stage == Stage::Parity) {
        m_pieces.push_back(ask("get-serial-control", 1));
    } else if (m_pieces.empty() && !m_steps.empty()) {
        beginTry();
    }
    if (m_pieces.empty()) {
        return std::nullopt;
    }
    m_latest = m_pieces.front();
    m_pieces.pop_front();
    return m_latest;
}

void LineSearch::beginTry()
{
    m_current = m_steps.front();
    m_steps.pop_front();
    ++m_done;
    m_isUnclear = !m_options.isNetwork;
    const LineProbe probe = lineProbe(m_current);
    m_query = probe.query;
    if (m_options.isNetwork) { // its speed is not ours to set: in one
        m_pieces.push_back({m_current, encode(m_query, m_current)});
    } else {
        for (const WirePiece& piece : probe.pieces) {
            m_pieces.push_back({piece.line, piece.bytes});
        }
    }
    m_pieces.front().isTry = true;
    Ask& last = m_pieces.back();
    last.replyBytes = static_cast<int>(last.bytes.size()) + replyLength(m_query);
}

void LineSearch::clearLine()
{
    if (std::exchange(m_isUnclear, false)) {
        m_pieces.clear();
        for (const WirePiece& piece : lineClearing()) {
            m_pieces.push_back({onWire(piece.line), piece.bytes});
        }
    }
}

QByteArrayView LineSearch::withoutEcho(QByteArrayView received)
{
    const QByteArray& sent = m_latest.bytes;
    if (!received.toByteArray().startsWith(sent)) {
        return received;
    }
    m_candidate.echo = true;
    return received.sliced(sent.size());
}

void LineSearch::answer(QByteArrayView received)
{
    if (m_latest.replyBytes == 0 || m_found) {
        return;
    }
    if (m_stage == Stage::Probe) {
        m_candidate = {};
    }
    const QByteArrayView reply = withoutEcho(received);
    LineAnswer heard = m_candidate.echo ? LineAnswer::EchoOnly : LineAnswer::Silence;
    if (!reply.isEmpty()) {
        heard = std::ranges::all_of(reply, [](char byte) { return byte == 0; })
            ? LineAnswer::Zeros
            : LineAnswer::Garbage;
    }
    m_heard = std::max(m_heard, heard);
    switch (m_stage) {
    case Stage::Probe:
        onProbe(reply);
        break;
    case Stage::Signature:
        onSignature(reply);
        break;
    case Stage::Parity:
        m_stage = Stage::Probe;
        if (const auto payload = payloadOf(query("get-serial-control"), reply, m_current);
            payload && isPlausible(query("get-serial-control"), *payload)) {
            accept();
        } else {
            tryOddParity();
        }
        break;
    }
    if (m_stage == Stage::Probe && !m_found) {
        clearLine();
    }
}

void LineSearch::onProbe(QByteArrayView reply)
{
    const auto payload = payloadOf(m_query, reply, m_current);
    if (payload && isPlausible(m_query, *payload)) {
        m_candidate.status = m_query == query("get-status")
            ? static_cast<std::uint8_t>(payload->front())
            : std::uint8_t{0};
        m_stage = Stage::Signature;
    } else if (!reply.isEmpty()) {
        tryOddParity();
    }
}

void LineSearch::onSignature(QByteArrayView reply)
{
    m_stage = Stage::Probe;
    const auto signature = signatureIn(reply, m_current);
    if (!signature) {
        tryOddParity();
        return;
    }
    m_candidate.signature = *signature;
    const ErrorDetection detection = m_current.errorDetection;
    if (detection == ErrorDetection::None || detection == ErrorDetection::Odd) {
        m_stage = Stage::Parity; // 0x83 has the other parity: only the right setting hears it
    } else {
        accept();
    }
}

/// A controller set to odd parity takes an 0x82 that was sent without: its parity bit is 1, as a
/// stop bit is. Its reply may come damaged.
void LineSearch::tryOddParity()
{
    LineSettings line = m_current;
    if (line.errorDetection != ErrorDetection::None || m_options.isNetwork) {
        return;
    }
    line.errorDetection = ErrorDetection::Odd;
    std::erase_if(m_steps, [&line](const LineSettings& step) { return isSameTry(step, line); });
    m_steps.push_front(line);
}

void LineSearch::accept()
{
    m_candidate.line = m_options.given;
    m_candidate.line.baud = m_current.baud;
    m_candidate.line.errorDetection = m_current.errorDetection;
    m_candidate.line.polynomial = m_current.polynomial;
    m_found = m_candidate;
}

void LineSearch::giveUp()
{
    m_steps.clear();
    m_stage = Stage::Probe;
    m_found.reset();
    clearLine();
}

void LineSearch::resume()
{
    if (std::exchange(m_found, std::nullopt)) {
        clearLine();
    }
}

} // namespace trex
