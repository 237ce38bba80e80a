// SPDX-License-Identifier: GPL-3.0-or-later
// A brushed DC motor on a bridge: current from resistance, inductance and back-EMF; speed from
// inertia, friction and load.
#pragma once

namespace trex::sim {

/// A small 12 V gearmotor, at the motor's own shaft: about 0.25 A free, 1.2 A at load 0.4, 5.5 A
/// stalled.
struct MotorConstants {
    double volts = 12.0; ///< supply
    double ohms = 2.18;
    double henries = 1.1e-3;
    double voltSeconds = 0.01824; ///< back-EMF a rad/s, and torque an ampere
    double inertia = 1.2e-5; ///< kg m²
    double coulomb = 3.2e-3; ///< N m, dry friction
    double viscous = 2.2e-6; ///< N m s
    double fullLoad = 0.0433; ///< N m at load 1, against the motion
};

class MotorModel {
public:
    explicit MotorModel(const MotorConstants& constants = {});

    /// One millisecond. Duty −1 to 1 drives; duty 0 brakes with 0 (coasting) to 1.
    void step(double duty, double brake);
    void setLoad(double load) { m_load = load; } ///< 0 to 1
    void setStall(bool held) { m_isHeld = held; } ///< shaft held fast
    [[nodiscard]] double amperes() const { return m_amperes; } ///< signed
    [[nodiscard]] double radiansPerSecond() const { return m_speed; }

private:
    MotorConstants m_constants;
    double m_decay; ///< of the current's distance from its end value, a step
    double m_load = 0.0;
    bool m_isHeld = false;
    double m_amperes = 0.0;
    double m_speed = 0.0;
};

} // namespace trex::sim
