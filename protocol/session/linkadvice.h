// SPDX-License-Identifier: GPL-3.0-or-later
// How well the line does, in plain sentences, each with its reason in figures and what to do.
#pragma once

#include "protocol/session/linkfacts.h"

namespace trex {

/// In the order of their weight.
enum class LinkAdviceKind : std::uint8_t {
    NotConnected,
    TooEarly,
    LineLost,
    ForeignTraffic,
    DamagedWithoutCrc,
    DamagedDespiteCrc,
    NoAnswers,
    ControllerFrame,
    ControllerOverrun,
    ControllerFormat,
    ControllerSendBuffer,
    ControllerTimeout,
    LateAnswers,
    LatencyTimer,
    HeldBack,
    LineTooSlow,
    WaitingTooLong,
    Echo,
    Well,
};
inline constexpr int kLinkAdviceCount = static_cast<int>(LinkAdviceKind::Well) + 1;
[[nodiscard]] QLatin1StringView keyOf(LinkAdviceKind kind); ///< for JSON, never translated

struct LinkAdvice {
    enum class Look : std::uint8_t { Off, Ok, Note, Warning, Fault };
    LinkAdviceKind kind = LinkAdviceKind::NotConnected;
    Look look = Look::Off;
    QString sentence{};
    QLatin1StringView panel{}; ///< the panel that changes it; empty: none
    QLatin1StringView control{}; ///< its object name there; empty: the panel as a whole
    QString command{}; ///< for the superuser's shell; empty: none
    bool isGuess = false; ///< inferred: the sentence says so, too
};

/// At least one; the last is Well where nothing worse than a note holds.
[[nodiscard]] std::vector<LinkAdvice> linkAdvice(const LinkFacts& facts);

} // namespace trex
