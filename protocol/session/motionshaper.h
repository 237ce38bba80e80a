// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/command.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace trex {

/// What the host adds to the firmware's own way with the motors, which knows no deceleration
/// (facts.md 7). All off at first.
struct MotionLimits {
    std::array<int, 3> maximum{kFullSpeed, kFullSpeed, kFullSpeed}; ///< by MotorId, 1 to 127
    int softStart = 0; ///< speed steps a second away from neutral; 0: at once
    int softStop = 0; ///< speed steps a second towards neutral; 0: at once
    double stallAmperes = 0.0; ///< of motors 1 and 2; 0: the stall guard is off
    std::chrono::milliseconds stallTime{500}; ///< how long that much current is no stall
    [[nodiscard]] bool hasRamps() const { return softStart > 0 || softStop > 0; }
    [[nodiscard]] bool guardsStall() const { return stallAmperes > 0.0; }
    bool operator==(const MotionLimits&) const = default;
};

using ShapedOrders = std::vector<std::pair<MotorId, MotorOrder>>; ///< in the order of MotorId

/// Shapes what was ordered into what is sent: speed limits, ramps, and the stall guard's verdict.
/// The ramps are those of "set"; "accelerate" and "brake" are the firmware's own, and pass.
/// Pure: time comes in as argument. STOP knows nothing of it: reset() is at once.
class MotionShaper {
public:
    static constexpr std::chrono::milliseconds kStep{20}; ///< between two steps of a ramp
    /// The stall guard's way down where no soft stop is chosen: full speed to zero in half a
    /// second.
    static constexpr int kGuardRamp = 2 * kFullSpeed;

    void setLimits(const MotionLimits& limits) { m_limits = limits; }
    [[nodiscard]] const MotionLimits& limits() const { return m_limits; }
    [[nodiscard]] MotorOrder limited(MotorId motor, const MotorOrder& order) const;

    /// A new order (already limited); what is to be sent for it now.
    MotorOrder take(MotorId motor, const MotorOrder& order, Instant now);
    /// The next step of a ramp; none: this motor is where it was ordered.
    std::optional<MotorOrder> step(MotorId motor, Instant now);
    [[nodiscard]] bool isRamping() const;
    [[nodiscard]] const MotorOrder& sent(MotorId motor) const; ///< for display beside the order
    void reset(); ///< all at neutral, nothing under way

    /// A current of motor 1 or 2; true: as much for long enough, so the motor is stalled.
    bool isStalled(MotorId motor, double amperes, Instant at);
    /// All motors down to zero, by the soft stop or the guard's own ramp.
    void rampDown(Instant now);
    [[nodiscard]] bool isRampingDown() const { return m_isRampingDown; }

private:
    struct Motor {
        MotorOrder wanted;
        MotorOrder sent;
        double speed = 0.0; ///< where the ramp is
        Instant at; ///< of `speed`
        std::optional<Instant> overSince;
    };
    [[nodiscard]] static bool isReachKnown(const Motor& motor);
    void advance(Motor& motor, Instant now) const;
    [[nodiscard]] int downRate() const;

    MotionLimits m_limits;
    std::array<Motor, 3> m_motors{};
    bool m_isRampingDown = false;
};

} // namespace trex
