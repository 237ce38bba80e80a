// SPDX-License-Identifier: GPL-3.0-or-later
// Where an end of a travel lies, and how well that is known. Pure.
#pragma once

#include "protocol/procedures/learnedchannel.h"

#include <deque>

namespace trex {

struct SweepPoint {
    int raw;
    Instant time;
};

/// An end from the readings around the time it was held for.
struct EndEstimate {
    double value = 0.0; ///< the middle of the window's readings
    EndWindow window; ///< the readings it was learned from
    /// ±, raw: the end lies no further away. What the noise leaves open, kNoiseErrors standard
    /// errors wide, and how far the readings still rose or fell within the window.
    double uncertainty = 0.0;
    bool isAgreed = false; ///< most of the readings of that time lie in the window: no spikes' end
};

/// The noise's part of an uncertainty, for so many readings of noise σ.
[[nodiscard]] double noiseUncertainty(double sigma, std::size_t samples);

/// `sweep[first]` to `sweep[last]` is where the best value was sustained, `sign` is 1 for the high
/// end. Looks at as much of the time before and after as agrees with it, and keeps the part that
/// makes the end surest: a chosen peak of the noise is no end, but the middle of a long hold is.
/// Readings further than `outlier` from the sustained value are left out.
[[nodiscard]] EndEstimate estimateEnd(const std::deque<SweepPoint>& sweep, std::size_t first,
                                      std::size_t last, int sign, double sigma, double outlier);

} // namespace trex
