// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/calibrationverdict.h"

namespace trex {

/// Looks at the readings of the neutral step for signs that RC and analog are mixed up. Pure.
class SignalCheck {
public:
    explicit SignalCheck(InputKind input) : m_input(input), m_rules(calibrationRules(input)) { }

    void begin(); ///< forgets everything
    /// Any reading, valid or not; those of the neutral step, while nothing should move.
    void feed(int raw, Instant time);

    /// `restarts`: movements seen. `hasNeutral`: it was still at last.
    [[nodiscard]] Confusion confusion(int restarts, bool hasNeutral) const;
    [[nodiscard]] int samples() const { return m_samples; } ///< valid ones
    [[nodiscard]] int missed() const { return m_missed; }

private:
    InputKind m_input;
    const CalibrationRules& m_rules;
    int m_samples = 0;
    int m_missed = 0;
    int m_foreign = 0; ///< only the other kind gives such
    int m_atZero = 0;
    int m_high = 0;
    int m_bursts = 0; ///< times it left zero
    bool m_isHigh = false;
    std::optional<Instant> m_first;
    Instant m_last;
};

} // namespace trex
