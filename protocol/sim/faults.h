// SPDX-License-Identifier: GPL-3.0-or-later
// What can be wrong with a simulated line: by name, and deterministic from the line's seed.
#pragma once

#include "protocol/codec/quantities.h"
#include "protocol/result.h"

#include <QByteArray>
#include <QString>

#include <limits>
#include <optional>

namespace trex::sim {

/// A small random generator (xorshift64*): the same numbers everywhere from the same seed.
class Random {
public:
    explicit Random(quint64 seed);
    quint64 next();
    double unit(); ///< 0 ≤ x < 1
    double symmetric(); ///< −1 ≤ x < 1
    bool chance(double probability); ///< draws nothing when it cannot happen

private:
    quint64 m_state;
};

/// | fault        | unit                | effect                                                 |
/// | ------------ | ------------------- | ------------------------------------------------------ |
/// | drop         | chance a reply byte | the byte is lost                                       |
/// | corrupt      | chance a reply byte | one of its bits is flipped                             |
/// | duplicate    | chance a reply byte | it comes twice                                         |
/// | delay        | ms                  | every reply begins later                               |
/// | garbage      | bytes               | so many random bytes before one reply in eight         |
/// | silent-after | s                   | from then on no reply (commands are still obeyed)      |
/// | silent-for   | s                   | for so long, then replies again; alone: from now       |
/// | hangup-after | s                   | the port is gone from then on                          |
/// | hangup-for   | s                   | for so long, then it is back; alone: from now          |
/// | reset-after  | s                   | brown-out: RAM and latched bits lost, EEPROM kept      |
/// | drop-at      | byte number         | that byte is lost                                      |
/// | corrupt-at   | byte number         | its bits of corrupt-mask (default 1) are flipped       |
/// | hangup-at    | byte number         | the port is gone from that byte on, for hangup-for     |
/// | reset-at     | byte number         | that byte is lost in a brown-out                       |
/// | drop-sent    | chance a host byte  | the byte does not reach the controllers                |
/// | corrupt-sent | chance a host byte  | one of its bits is flipped on the way                  |
/// | repeat-sent  | chance a host byte  | the controllers hear it twice                          |
/// | unplugged    | controllers         | the last so many of the line hear and say nothing      |
///
/// Times count from the start of the line, or from the scenario event that sets them. Byte numbers
/// count what crosses the wire in either direction since the start of the line, from 1; the echo is
/// not counted.
struct Faults {
    static constexpr double kNever = std::numeric_limits<double>::infinity();
    double drop = 0.0;
    double corrupt = 0.0;
    double duplicate = 0.0;
    double delayMs = 0.0;
    int garbage = 0;
    std::optional<double> silentAfter;
    std::optional<double> silentFor;
    std::optional<double> hangupAfter;
    std::optional<double> hangupFor;
    std::optional<double> resetAfter;
    std::optional<qint64> dropAt;
    std::optional<qint64> corruptAt;
    std::uint8_t corruptMask = 1;
    std::optional<qint64> hangupAt;
    std::optional<qint64> resetAt;
    double dropSent = 0.0;
    double corruptSent = 0.0;
    double repeatSent = 0.0;
    int unplugged = 0;

    /// "drop", 0.1. OutOfRange with a sentence for an unknown name or a value out of range.
    [[nodiscard]] Result<void> apply(const QString& name, double value);
    bool operator==(const Faults&) const = default;
};

/// A stretch of virtual time, in seconds since the start of the line.
struct FaultWindow {
    double from = Faults::kNever;
    double to = Faults::kNever;
    [[nodiscard]] bool contains(double seconds) const { return seconds >= from && seconds < to; }
};
/// "-after" and "-for" together: an absent one is now, and for ever; neither: never.
[[nodiscard]] FaultWindow silence(const Faults& faults, double origin);
[[nodiscard]] FaultWindow hangUp(const Faults& faults, double origin);

/// What becomes of one byte on the wire, by its number.
enum class ByteFate : std::uint8_t { Passes, Dropped, HangsUp, Resets };
/// `value` is changed when it is the one to be corrupted.
[[nodiscard]] ByteFate fateOf(const Faults& faults, qint64 number, std::uint8_t& value);

/// True when damaged() could change anything.
[[nodiscard]] bool damages(const Faults& faults);
/// A reply as it comes out of a bad line: drop, corrupt, duplicate, garbage.
[[nodiscard]] QByteArray damaged(QByteArrayView reply, const Faults& faults, Random& random);
/// How often a byte of the host arrives, 0 to 2; `value` as it does.
[[nodiscard]] int arrivals(std::uint8_t& value, const Faults& faults, Random& random);

} // namespace trex::sim
