// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/lineprobe.h"

#include <deque>
#include <optional>

namespace trex {

/// What LinkEngine remembers about a line of which nobody knows yet that it is set right: pieces on
/// their way out, how the line is set meanwhile, and whether packets may be open at other speeds.
struct LineGuard {
    std::deque<WirePiece> pieces{}; ///< to be sent before anything else but stops, with rests
    bool questionFollows = false; ///< the last piece of the question, when the others are out
    bool isAnswered = false; ///< somebody is there: the signature may be asked for
    bool isUnclear = false; ///< a question went out that nobody has answered
    std::optional<LineSettings> line{}; ///< set so now; none: as the connection's
    Instant deafUntil{}; ///< what comes before is no reply
    Instant nextIdentify{};
    int tries = 0; ///< without a signature, in a row
    QByteArray received{}; ///< instead of one
    bool sawEchoOnly = false;
    int asked = 0; ///< questions since the last signature
    Instant lastAsked{};

    [[nodiscard]] bool isBusy() const { return !pieces.empty() || questionFollows; }
    void drop(); ///< what is left of the pieces; the line is unclear then
    /// Queues what closes open packets, when there may be any: all of lineClearing(), or where the
    /// line cannot be set, a null command, which closes most and all that could move.
    void clear(const LineSettings& own, bool canSetLine);
};

} // namespace trex
