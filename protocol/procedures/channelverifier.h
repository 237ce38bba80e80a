// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/responsecurve.h"

#include <deque>
#include <optional>

namespace trex {

/// What a channel reaches with one curve; remapped values, −127 to 127.
struct CurveReach {
    int lowest = 0; ///< held, not passed in a spike
    int highest = 0;
    std::optional<int> atRest; ///< largest value (either sign) while it was last still at neutral
    bool operator==(const CurveReach&) const = default;
};

/// Tries a new calibration on the stick before it is written: what the channel reaches with the
/// new curve, and with the old one. Pure.
class ChannelVerifier {
public:
    /// `isOneWay`: it rests at one end, and only the other is to be reached.
    ChannelVerifier(const ResponseCurve& now, std::optional<ResponseCurve> before, double sigma,
                    bool isOneWay);
    /// Valid readings only, in order of time.
    void feed(int raw, Instant time);

    [[nodiscard]] const ResponseCurve& curve() const { return m_now; }
    [[nodiscard]] const std::optional<ResponseCurve>& curveBefore() const { return m_before; }
    [[nodiscard]] const CurveReach& now() const { return m_reach; }
    [[nodiscard]] const CurveReach& before() const { return m_reachBefore; } ///< with curveBefore()
    [[nodiscard]] int samples() const { return m_samples; }
    [[nodiscard]] bool isLowFull() const { return m_reach.lowest == -kFullSpeed; }
    [[nodiscard]] bool isHighFull() const { return m_reach.highest == kFullSpeed; }
    [[nodiscard]] bool isNeutralZero() const { return m_reach.atRest == 0; }
    /// Both ends (or the one) gave 127 and rest gave 0.
    [[nodiscard]] bool isConfirmed() const;

private:
    struct Point {
        int raw;
        Instant time;
    };
    void reach(double held);
    void rest();

    ResponseCurve m_now;
    std::optional<ResponseCurve> m_before;
    double m_sigma;
    bool m_isOneWay;
    CurveReach m_reach;
    CurveReach m_reachBefore;
    int m_samples = 0;
    std::deque<Point> m_window;
};

} // namespace trex
