// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/motordrive.h"

#include "protocol/codec/quantities.h"

#include <algorithm>

namespace trex::sim {

void MotorDrive::apply(const MotorGoal& goal)
{
    m_goal = goal;
    m_isResting = false;
    if (!goal.immediate) {
        return;
    }
    m_isReversing = false;
    m_direction = goal.direction;
    m_tenths = goal.direction == 0 ? 0 : goal.amount * 10;
    m_brake = goal.direction == 0 ? goal.amount : 0;
}

void MotorDrive::rest(int duty)
{
    m_isReversing = false;
    m_isResting = true;
    m_tenths = 0;
    m_brake = duty;
}

bool MotorDrive::update(const Settings& settings, int current)
{
    const int excess = settings.limit > 0 ? current - settings.limit : 0;
    if (m_isResting) {
        return excess > 0;
    }
    if (m_goal.direction == 0) {
        apply({true, 0, m_goal.amount});
        return excess > 0;
    }
    if (isBraking(settings)) {
        return excess > 0;
    }
    if (m_direction != m_goal.direction) {
        m_tenths = 0;
    }
    m_direction = m_goal.direction;
    m_brake = 0;
    if (excess > 0 && settings.p > 0) {
        m_tenths =
            std::max(0, std::min(m_tenths, m_goal.amount * 10) - settings.p * excess); // C-66
    } else {
        accelerate(settings);
    }
    return excess > 0;
}

// "The first update will brake the motor at 100% duty cycle for the amount of time specified by its
// brake duration parameter. It will then set the motor speed to zero and accelerate from there."
bool MotorDrive::isBraking(const Settings& settings)
{
    const bool turns = m_direction != 0 && m_direction != m_goal.direction;
    if (!turns || settings.brakeDuration == 0) {
        m_isReversing = false;
        return false;
    }
    if (!m_isReversing) {
        m_isReversing = true;
        m_reversing = settings.brakeDuration;
        m_tenths = 0;
        m_brake = kFullSpeed;
        return true;
    }
    m_isReversing = --m_reversing > 0;
    return m_isReversing;
}

void MotorDrive::accelerate(const Settings& settings)
{
    const int goal = m_goal.amount * 10;
    if (m_tenths > goal || settings.acceleration == 0) {
        m_tenths = goal;
    } else {
        m_tenths = std::min(goal, m_tenths + settings.acceleration);
    }
}

MotorOutput MotorDrive::output() const
{
    const int speed = m_tenths / 10;
    return speed > 0 ? MotorOutput{speed * m_direction, 0} : MotorOutput{0, m_brake};
}

} // namespace trex::sim
