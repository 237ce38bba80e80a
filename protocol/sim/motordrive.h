// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware's 10 ms motor logic for one motor (command documentation, 0xC4 to 0xC7).
#pragma once

namespace trex::sim {

/// What a bridge does: a signed speed, or (speed 0) braking low at a duty; duty 0 coasts.
struct MotorOutput {
    int speed = 0; ///< −127 to 127
    int brake = 0; ///< 0 to 127
    bool operator==(const MotorOutput&) const = default;
};

/// A motor command or channel value, taken apart.
struct MotorGoal {
    bool immediate = true; ///< set, not accelerate
    int direction = 1; ///< 1 forward, −1 reverse, 0 brake low
    int amount = 0; ///< speed, or braking duty
};

class MotorDrive {
public:
    struct Settings {
        int acceleration = 0; ///< speed gained in 100 ms; 0 infinite
        int brakeDuration = 0; ///< 10 ms units
        int limit = 0; ///< 8-bit current; 0 none
        int p = 0;
    };

    /// A set acts now, an accelerate from the next update on.
    void apply(const MotorGoal& goal);
    /// The channel rests in its deadband: brakes at this duty, and remembers its direction.
    void rest(int duty);
    /// Coasting, and nothing to come.
    void stop() { *this = {}; }
    /// The 10 ms update; true when the current is over the limit.
    bool update(const Settings& settings, int current);
    [[nodiscard]] MotorOutput output() const;

private:
    [[nodiscard]] bool isBraking(const Settings& settings);
    void accelerate(const Settings& settings);

    MotorGoal m_goal;
    int m_tenths = 0; ///< speed × 10, so that acceleration / 10 adds up
    int m_direction = 0; ///< last driven direction; 0 none
    int m_brake = 0; ///< duty while not driving
    int m_reversing = 0; ///< updates of full braking still to come
    bool m_isReversing = false;
    bool m_isResting = false;
};

} // namespace trex::sim
