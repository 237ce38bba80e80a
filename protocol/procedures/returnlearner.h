// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/calibrationverdict.h"

#include <deque>

namespace trex {

/// Where a channel stands between two rests.
enum class ReturnState : std::uint8_t {
    Rest, ///< at its neutral, not yet moved (again)
    Away, ///< moved off
    Settling, ///< back near its neutral, not yet still for long enough
};

/// Learns how a stick comes back to its neutral: it is moved away and let go, some times. Pure.
class ReturnLearner {
public:
    explicit ReturnLearner(InputKind input) : m_rules(calibrationRules(input)) { }

    /// Forgets all returns and starts from this neutral, with this noise.
    void begin(double neutral, double sigma);
    /// Valid readings only, in order of time.
    void feed(int raw, Instant time);

    [[nodiscard]] int count() const { return static_cast<int>(m_rests.size()); }
    [[nodiscard]] ReturnState state() const { return m_state; }
    /// The middle of the rests from above and those from below, or of all when only one side is
    /// known: play in the centre does not pull it to one side.
    [[nodiscard]] double neutral() const;
    [[nodiscard]] double repeatability() const; ///< spread of all rests, the first neutral included
    [[nodiscard]] double farthestRest() const; ///< from neutral()
    [[nodiscard]] std::optional<double> hysteresis() const;

private:
    struct Point {
        int raw;
        Instant time;
    };
    struct Rest {
        double value;
        int side; ///< 1: came from above, −1: from below
    };
    void settle();
    [[nodiscard]] std::optional<double> medianFrom(int side) const;

    const CalibrationRules& m_rules;
    double m_first = 0.0;
    double m_sigma = 0.0;
    ReturnState m_state = ReturnState::Rest;
    int m_side = 0;
    std::deque<Point> m_window; ///< the latest readings; while settling, since it was back
    std::vector<Rest> m_rests;
};

} // namespace trex
