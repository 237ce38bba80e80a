// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/calibrationverdict.h"
#include "protocol/procedures/endestimate.h"

#include <deque>

namespace trex {

/// Finds the two ends of a channel's travel: values that were held, never a spike. Pure.
class ExtremeFinder {
public:
    /// An end as it is known in the end.
    struct End {
        double value = 0.0;
        EndWindow window; ///< the readings it was learned from; none: not reached
        double uncertainty = 0.0; ///< ±, raw; see EndEstimate
        bool isHeld = true; ///< neither spikes' only nor passed beyond in a rush
    };
    explicit ExtremeFinder(InputKind input) : m_rules(calibrationRules(input)) { }

    /// Forgets the ends and starts from this neutral, with this noise.
    void begin(double neutral, double sigma, Instant now);
    /// Valid readings only, in order of time.
    void feed(int raw, Instant time);

    [[nodiscard]] int samples() const { return m_samples; }
    [[nodiscard]] double reachedLow() const { return m_low.value; } ///< best held value so far
    [[nodiscard]] double reachedHigh() const { return m_high.value; }
    [[nodiscard]] Instant grownAt() const; ///< when an end last grew notably
    /// The best held value, as exact as the time around it allows.
    [[nodiscard]] End end(int sign) const;
    [[nodiscard]] int spikes() const; ///< readings that stand out of their neighbours

private:
    struct Reach {
        double value = 0.0; ///< best held value
        double noted = 0.0; ///< the value when it last grew notably,
        Instant grownAt; ///< and when that was
        Instant from; ///< the readings that it was held for
        Instant to;
    };
    void grow(Reach& reach, int sign, double held, Instant from, Instant to);
    [[nodiscard]] std::size_t sustainedCount() const;
    [[nodiscard]] std::size_t placeOf(Instant time) const;
    [[nodiscard]] bool isRushedPast(const Reach& reach, int sign) const;

    const CalibrationRules& m_rules;
    double m_neutral = 0.0;
    double m_sigma = 0.0;
    std::deque<SweepPoint> m_sweep;
    int m_samples = 0;
    Reach m_low;
    Reach m_high;
};

} // namespace trex
