// SPDX-License-Identifier: GPL-3.0-or-later
// What is known about the line at one moment, and the questions that linkadvice.cpp asks of it.
#pragma once

#include "protocol/session/transaction.h"

#include <QStringList>

namespace trex {

/// All that the advice may know.
struct LinkFacts {
    LinkState state = LinkState::Disconnected;
    LineSettings line;
    LinkStats stats;
    LinkHealth health;
};

/// What was asked of the adapter and what came of it, for the log; empty: nothing was to be asked.
[[nodiscard]] QString adapterText(const AdapterFacts& adapter);

namespace linkfacts {

inline constexpr quint64 kEnough = 50; ///< answers due before anything is said about them
inline constexpr quint64 kFewest = 3; ///< of one kind: a single one is an accident
inline constexpr double kDamagedShare = 0.001;
inline constexpr double kSilentShare = 0.002;
inline constexpr double kAskedShare = 0.95; ///< of the rates asked for; below, the line is too slow
inline constexpr double kBusy = 0.6; ///< of the time, from which on the speed is what limits
/// The controller itself answers within less (command documentation; 1 ms more by parameter 0x17).
inline constexpr std::chrono::milliseconds kHeldBack{6};

inline constexpr std::uint8_t kFrameBits = uartbit::kFrame | uartbit::kParity;
inline constexpr std::uint8_t kOverrunBits = uartbit::kOverrun | uartbit::kReadBufferOverrun;
inline constexpr std::uint8_t kFormatBits = uartbit::kFormat | uartbit::kCrc;

[[nodiscard]] const HealthCounts& recent(const LinkFacts& facts);
[[nodiscard]] QString number(quint64 count);
[[nodiscard]] QString percent(double share); ///< "0.5", "12"
[[nodiscard]] QString milliseconds(Duration duration); ///< "2.6", "140"
[[nodiscard]] Duration medianOf(const LatencyHistogram& histogram);
[[nodiscard]] double shareOf(quint64 count, const LinkFacts& facts); ///< of the answers due
/// Times that any of these bits of the UART error byte was seen.
[[nodiscard]] quint64 uartCount(const LinkFacts& facts, std::uint8_t mask);
[[nodiscard]] bool isDamaged(const LinkFacts& facts);
[[nodiscard]] QStringList damagedWords(const LinkFacts& facts);
[[nodiscard]] bool hasSlowTimer(const LinkFacts& facts);
[[nodiscard]] bool isTooSlow(const LinkFacts& facts);
/// Median of the answers, of the wire alone, and of the difference.
[[nodiscard]] QStringList answerWords(const LinkFacts& facts);
/// The next rate that would carry what the panels ask, or the highest; none: the speed is not what
/// limits, or there is no higher one.
[[nodiscard]] std::optional<int> sufficientBaud(const LinkFacts& facts);

} // namespace linkfacts
} // namespace trex
