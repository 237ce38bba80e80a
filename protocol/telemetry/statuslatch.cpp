// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/statuslatch.h"

namespace trex {

void StatusLatch::record(Byte byte, std::uint8_t bits, Instant time)
{
    const auto which = static_cast<std::size_t>(byte);
    m_lastRead.at(which) = time;
    for (std::size_t bit = 0; bit < 8; ++bit) {
        Entry& entry = m_entries.at(which).at(bit);
        entry.lit = (bits >> bit & 1U) != 0U;
        if (entry.lit) {
            ++entry.count;
            entry.lastSeen = QDateTime::currentDateTime();
            if (!entry.firstSeen.isValid()) {
                entry.firstSeen = entry.lastSeen;
            }
        }
    }
    emit changed();
}

const StatusLatch::Entry& StatusLatch::entry(Byte byte, int bit) const
{
    return m_entries.at(static_cast<std::size_t>(byte)).at(static_cast<std::size_t>(bit));
}

std::optional<Instant> StatusLatch::lastRead(Byte byte) const
{
    return m_lastRead.at(static_cast<std::size_t>(byte));
}

void StatusLatch::clear()
{
    for (auto& bits : m_entries) {
        for (Entry& entry : bits) {
            const bool lit = entry.lit;
            entry = {};
            entry.lit = lit;
        }
    }
    emit changed();
}

void StatusLatch::show(const Shown& shown)
{
    m_entries = shown.entries;
    m_lastRead = shown.lastRead;
    m_now = shown.now;
    emit changed();
}

QDateTime StatusLatch::now() const
{
    return m_now.isValid() ? m_now : QDateTime::currentDateTime();
}

void StatusLatch::linkLost()
{
    m_lastRead = {};
    emit changed();
}

} // namespace trex
