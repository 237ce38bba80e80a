// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/command.h"

#include <array>
#include <optional>

namespace trex {

/// What the motor currents tell of a restart under way, which nothing that can be asked over the
/// line would: a reply failed to come, and from then on a motor that drew current steadily draws
/// none, although its order stands. Either alone proves nothing: a line may lose a reply, and a
/// load may drive a motor. Pure: readings and time come in.
class RestartEvidence {
public:
    static constexpr int kLeastSpeed = 20; ///< below, the current may be less than one count
    static constexpr int kLeastCounts = 3; ///< of a current that is no noise
    static constexpr int kLeastReadings = 4; ///< in a row, with such a one among them
    /// So many above zero in a row are a current, too: of a small motor, or without load.
    static constexpr int kManyReadings = 60;
    static constexpr int kGoneReadings = 4; ///< in a row at zero
    static constexpr std::chrono::milliseconds kGone{250}; ///< and for so long
    static constexpr int kReadingsBetween = 2; ///< at most, a lost reply and the first zero

    struct Reading {
        Instant at;
        std::array<MotorOrder, 2> orders; ///< as they left
        std::array<int, 2> counts{}; ///< raw, as the controller told them
        quint64 timeouts = 0; ///< replies that failed to come, ever
    };
    /// Index of the motor that tells of a restart; none.
    [[nodiscard]] std::optional<std::size_t> take(const Reading& reading);
    void forget(quint64 timeouts); ///< no order stands, or nothing is read

private:
    struct Motor {
        MotorOrder order;
        int readings = 0; ///< above zero in a row, by this order
        int highest = 0; ///< of these, in counts
        int zeros = 0; ///< in a row
        int firstZero = 0; ///< number of that reading
        bool wasSteady = false; ///< before the zeros
        Instant goneSince;
    };
    void follow(Motor& motor, const MotorOrder& order, int counts, Instant at) const;
    [[nodiscard]] bool tells(const Motor& motor, Instant at) const;

    std::array<Motor, 2> m_motors{};
    quint64 m_timeouts = 0;
    int m_number = 0; ///< of the reading
    std::optional<int> m_lostReply; ///< seen at that reading
};

} // namespace trex
