// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/linesearch.h"

#include "protocol/codec/crc7.h"
#include "protocol/codec/packet.h"
#include "protocol/codec/replyparser.h"

#include <algorithm>
#include <ranges>
#include <utility>

namespace trex {
namespace {

constexpr int kSignatureJr = 9; // command documentation, 0x81
constexpr std::uint8_t kUnusedStatusBits = 0x0E; // command documentation, 0x84: bits 3-1 not used

// Where clearing begins and ends: slower receivers hear the last of it as a byte of ones.
constexpr int kFastest = 115200;
constexpr int kSlowestClearing = 9600;

/// CRC bytes that are clean at a speed, as a set of 128 bits; from the model of tst_linebits.cpp.
struct CleanCrc {
    int baud;
    std::array<std::uint64_t, 2> bytes;
};
constexpr std::uint64_t kEvery = ~std::uint64_t{0};
constexpr std::array<CleanCrc, 11> kCleanCrc{{
    {1200, {kEvery, kEvery}},
    {2400, {0xFDF5'FF55'FDF5'FDFF, 0xFFFF'FFFF'FFFF'FDFF}},
    {4800, {0xFDF5'FF55'FDF5'FDFF, 0xFFFF'FFFF'FFFF'FDFF}},
    {9600, {0xFDF5'FF55'FDF5'FDFF, 0xFFFF'FFFF'FFFF'FDFF}},
    {14400, {0x5105'0015'5105'1115, 0xFDF5'B955'FDF5'1155}},
    {19200, {0xFDF5'FF55'FDF5'FDFF, 0xFFFF'FFFF'FFFF'FDFF}},
    {28800, {0xFFBF'BBBF'FFBF'BBBF, 0xFFFF'BBFF'FFFF'BBFF}},
    {38400, {kEvery, kEvery}},
    {57600, {kEvery, kEvery}},
    {76800, {kEvery, kEvery}},
    {115200, {kEvery, kEvery}},
}};

Command probe()
{
    return query("get-status");
}

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

std::uint8_t probeCrc(std::uint8_t polynomial)
{
    LineSettings line;
    line.errorDetection = ErrorDetection::Crc7;
    line.polynomial = polynomial;
    return static_cast<std::uint8_t>(encode(probe(), line).back());
}

bool isUnclean(const LineSettings& line)
{
    return line.hasCrc() && !isCleanCrcProbe(line.baud, probeCrc(line.polynomial));
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

bool isCleanCrcProbe(int baud, std::uint8_t crcByte)
{
    const auto* const row = std::ranges::find(kCleanCrc, baud, &CleanCrc::baud);
    return row != kCleanCrc.end() && crcByte < 128
        && (row->bytes.at(crcByte / 64) >> (crcByte % 64) & 1U) != 0U;
}

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
            addTry(line, !options.isNetwork);
        }
        return;
    }
    std::vector<LineSettings> first = options.remembered;
    first.push_back(options.given);
    if (!options.isNetwork) {
        first.emplace_back(); // as it leaves the factory
    }
    for (const LineSettings& line : first) {
        if (options.isNetwork || !isUnclean(line)) {
            addTry(line, !options.isNetwork);
        }
    }
    LineSettings line = options.given;
    if (options.isNetwork) {
        line.errorDetection = ErrorDetection::None;
        addTry(line, false);
        planCrc(first, true);
        planCrc(first, false);
        return;
    }
    for (const auto& detection : {ErrorDetection::None, ErrorDetection::Even}) {
        line.errorDetection = detection;
        for (const int baud : kBaudRates | std::views::reverse) {
            line.baud = baud;
            const bool wasTried = isPlanned(onWire(line));
            if (!wasTried) {
                addTry(line, detection == ErrorDetection::Even);
            } else if (detection == ErrorDetection::None) {
                m_steps.push_back({onWire(line), true}); // closes what the one before left open
            }
        }
        if (detection == ErrorDetection::None) {
            planCrc(first, true);
        }
    }
    planCrc(first, false); // last, when whoever could misread them would have answered
}

/// With the polynomials that are known of this port, then the one of the factory.
void LineSearch::planCrc(const std::vector<LineSettings>& known, bool clean)
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
        for (const int baud : kBaudRates | std::views::reverse) {
            line.baud = baud;
            if (isUnclean(line) == !clean
                && (!m_options.isNetwork || baud == m_options.given.baud)) {
                addTry(line, !m_options.isNetwork);
            }
        }
    }
}

void LineSearch::addTry(const LineSettings& line, bool clear)
{
    const LineSettings wired = onWire(line);
    if (isPlanned(wired)) {
        return;
    }
    m_steps.push_back({wired, false});
    if (clear) {
        addClearing(m_steps);
    }
}

void LineSearch::addClearing(std::deque<Step>& steps) const
{
    LineSettings line = onWire(m_options.given);
    line.errorDetection = ErrorDetection::None;
    for (const int baud : kBaudRates | std::views::reverse) {
        if (baud >= kSlowestClearing && baud <= kFastest) {
            line.baud = baud;
            steps.push_back({line, true});
        }
    }
}

bool LineSearch::isPlanned(const LineSettings& line) const
{
    return std::ranges::any_of(m_steps, [&line](const Step& step) {
        return !step.isClearing && isSameTry(step.line, line);
    });
}

int LineSearch::total() const
{
    return m_done + static_cast<int>(std::ranges::count(m_steps, false, &Step::isClearing));
}

LineSearch::Ask LineSearch::ask(const char* key, int payload) const
{
    const QByteArray bytes = encode(query(key), m_current.line);
    return {m_current.line, bytes, static_cast<int>(bytes.size()) + payload};
}

std::optional<LineSearch::Ask> LineSearch::next()
{
    if (m_found) {
        return std::nullopt;
    }
    if (m_stage == Stage::Signature) {
        return ask("get-signature", kSignatureJr);
    }
    if (m_stage == Stage::Parity) {
        return ask("get-serial-control", 1);
    }
    if (m_steps.empty()) {
        return std::nullopt;
    }
    m_current = m_steps.front();
    m_steps.pop_front();
    Ask next = ask("get-status", 1);
    if (m_current.isClearing) {
        next.replyBytes = 0;
    } else {
        next.isTry = true;
        ++m_done;
    }
    return next;
}

QByteArrayView LineSearch::withoutEcho(QByteArrayView received)
{
    const char* const key = m_stage == Stage::Probe ? "get-status"
        : m_stage == Stage::Signature               ? "get-signature"
                                                    : "get-serial-control";
    const QByteArray sent = encode(query(key), m_current.line);
    if (!received.toByteArray().startsWith(sent)) {
        return received;
    }
    m_candidate.echo = true;
    return received.sliced(sent.size());
}

void LineSearch::answer(QByteArrayView received)
{
    if (m_current.isClearing || m_found) {
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
        if (const auto payload = payloadOf(query("get-serial-control"), reply, m_current.line);
            payload && static_cast<std::uint8_t>(payload->front()) <= 1) {
            accept();
        } else {
            tryOddParity();
        }
        break;
    }
}

void LineSearch::onProbe(QByteArrayView reply)
{
    const auto payload = payloadOf(probe(), reply, m_current.line);
    if (payload && (static_cast<std::uint8_t>(payload->front()) & kUnusedStatusBits) == 0) {
        m_candidate.status = static_cast<std::uint8_t>(payload->front());
        m_stage = Stage::Signature;
    } else if (!reply.isEmpty()) {
        tryOddParity();
    }
}

void LineSearch::onSignature(QByteArrayView reply)
{
    m_stage = Stage::Probe;
    const auto signature = signatureIn(reply, m_current.line);
    if (!signature) {
        tryOddParity();
        return;
    }
    m_candidate.signature = *signature;
    const ErrorDetection detection = m_current.line.errorDetection;
    if (detection == ErrorDetection::None || detection == ErrorDetection::Odd) {
        m_stage = Stage::Parity; // 0x83 has the other parity: only the right setting hears it
    } else {
        accept();
    }
}

/// A controller set to odd parity takes an 0x84 that was sent without: its parity bit is 1, as a
/// stop bit is. Its reply may come damaged.
void LineSearch::tryOddParity()
{
    LineSettings line = m_current.line;
    if (line.errorDetection != ErrorDetection::None || m_options.isNetwork) {
        return;
    }
    line.errorDetection = ErrorDetection::Odd;
    std::erase_if(m_steps, [&line](const Step& step) {
        return !step.isClearing && isSameTry(step.line, line);
    });
    m_steps.push_front({line, false});
}

void LineSearch::accept()
{
    m_candidate.line = m_options.given;
    m_candidate.line.baud = m_current.line.baud;
    m_candidate.line.errorDetection = m_current.line.errorDetection;
    m_candidate.line.polynomial = m_current.line.polynomial;
    m_found = m_candidate;
}

void LineSearch::giveUp()
{
    m_steps.clear();
    m_stage = Stage::Probe;
    m_found.reset();
    if (m_done > 0 && !m_options.isNetwork) {
        addClearing(m_steps);
    }
}

void LineSearch::resume()
{
    if (!m_found) {
        return;
    }
    m_found.reset();
    // What has answered is still there and hears the rest.
    m_leftOut += static_cast<int>(std::erase_if(
        m_steps, [](const Step& step) { return !step.isClearing && isUnclean(step.line); }));
}

} // namespace trex
