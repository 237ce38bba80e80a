// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/replyparser.h"

#include "protocol/codec/crc7.h"

#include <bit>

namespace trex {
namespace {

// A TReX Jr answers "TReXJr1.2", a TReX "TReX1.2": the fifth byte tells (facts.md 1, C-70).
constexpr QByteArrayView kSignatureStart("TReX");
constexpr char kJrMark = 'J';
constexpr int kTrexSignatureBytes = 7;

} // namespace

int replyLength(const Command& command)
{
    const CommandRow* const row = findCommand(command.opcode);
    if (row == nullptr || row->replyRule == ReplyRule::None) {
        return 0;
    }
    if (row->replyRule != ReplyRule::PerMaskBit) {
        return row->replyBytes;
    }
    if (command.data.isEmpty()) {
        return 0;
    }
    const auto mask = static_cast<std::uint8_t>(command.data[0]);
    return std::popcount(static_cast<unsigned>(mask & kAllChannelsMask)) * row->replyBytes;
}

ReplyParser::ReplyParser(const Command& command, const LineSettings& settings)
    : m_opcode(command.opcode)
    , m_polynomial(settings.polynomial)
    , m_hasCrc(settings.hasCrc())
    , m_expected(replyLength(command))
{
    if (m_expected > 0 && m_hasCrc) {
        ++m_expected;
    }
    m_received.reserve(m_expected);
    judge();
}

int ReplyParser::feed(QByteArrayView bytes)
{
    const bool isSignature = m_opcode == commandRow("get-signature").first;
    int used = 0;
    while (used < bytes.size() && m_received.size() < m_expected) {
        m_received.append(bytes[used]);
        ++used;
        if (isSignature && m_received.size() == kSignatureStart.size() + 1
            && m_received.startsWith(kSignatureStart) && m_received.back() != kJrMark) {
            m_expected = kTrexSignatureBytes + (m_hasCrc ? 1 : 0);
        }
    }
    judge();
    return used;
}

QByteArray ReplyParser::payload() const
{
    return m_hasCrc && m_verdict != Verdict::NeedMore ? m_received.chopped(m_expected > 0 ? 1 : 0)
                                                      : m_received;
}

void ReplyParser::judge()
{
    if (m_received.size() < m_expected) {
        m_verdict = Verdict::NeedMore;
        return;
    }
    m_verdict = Verdict::Complete;
    if (m_hasCrc && m_expected > 0) {
        const QByteArrayView body = QByteArrayView(m_received).chopped(1);
        if (crc7(body, m_polynomial) != static_cast<std::uint8_t>(m_received.back())) {
            m_verdict = Verdict::BadCrc;
        }
    }
}

} // namespace trex
