// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/quantities.h"

namespace trex {

/// Tells a line that pours bytes from one that answers. No line of a TReX brings more than 11,520
/// bytes a second; a peer on a network that sends as fast as it can would keep a processor busy and
/// fill memory. Pure.
class FloodGuard {
public:
    static constexpr qint64 kMostBytes = 131'072; ///< within kWithin, bursts of servers included
    static constexpr std::chrono::seconds kWithin{1};

    /// True when these bytes are too much.
    [[nodiscard]] bool isTooMuch(qint64 bytes, Instant at)
    {
        if (at - m_start >= kWithin) {
            m_start = at;
            m_bytes = 0;
        }
        m_bytes += bytes;
        return m_bytes > kMostBytes;
    }

private:
    Instant m_start{};
    qint64 m_bytes = 0;
};

} // namespace trex
