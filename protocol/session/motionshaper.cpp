// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/motionshaper.h"

#include <algorithm>
#include <cmath>

namespace trex {

namespace {

constexpr std::size_t indexOf(MotorId motor)
{
    return static_cast<std::size_t>(motor);
}

bool isBrake(const MotorOrder& order)
{
    return order.action == MotorOrder::Action::Brake;
}

/// `from` towards `to` by at most `most`.
double towards(double from, double to, double most)
{
    return from < to ? std::min(from + most, to) : std::max(from - most, to);
}

} // namespace

MotorOrder MotionShaper::limited(MotorId motor, const MotorOrder& order) const
{
    if (isBrake(order)) {
        return order;
    }
    const int most = std::clamp(m_limits.maximum.at(indexOf(motor)), 1, kFullSpeed);
    return {order.action, std::clamp(order.amount, -most, most)};
}

int MotionShaper::downRate() const
{
    return m_isRampingDown && m_limits.softStop == 0 ? kGuardRamp : m_limits.softStop;
}

/// Where a motor is that the firmware accelerates is not known: a ramp from where it was sent to
/// could make it faster first.
bool MotionShaper::isReachKnown(const Motor& motor)
{
    return motor.sent.action != MotorOrder::Action::Accelerate || motor.sent.amount == 0;
}

/// A reversal goes down to neutral first, by its own rate, and starts from there.
void MotionShaper::advance(Motor& motor, Instant now) const
{
    double left = std::chrono::duration<double>(now - motor.at).count();
    motor.at = now;
    const double goal = motor.wanted.amount;
    const bool isBeyond = motor.speed * goal < 0 || std::abs(motor.speed) > std::abs(goal);
    if (isBeyond) {
        const double lowest = motor.speed * goal < 0 ? 0.0 : goal;
        if (downRate() == 0) {
            motor.speed = lowest;
        } else {
            const double before = motor.speed;
            motor.speed = towards(before, lowest, downRate() * left);
            left -= std::abs(motor.speed - before) / downRate();
        }
    }
    const bool isShort = motor.speed * goal >= 0 && std::abs(motor.speed) < std::abs(goal);
    if (isShort) {
        motor.speed = m_limits.softStart == 0
            ? goal
            : towards(motor.speed, goal, m_limits.softStart * std::max(left, 0.0));
    }
}

MotorOrder MotionShaper::take(MotorId motor, const MotorOrder& order, Instant now)
{
    Motor& m = m_motors.at(indexOf(motor));
    const bool wasRamping = m.sent != m.wanted;
    m.wanted = order;
    if (order.action != MotorOrder::Action::Set || !isReachKnown(m)) {
        m.speed = isBrake(order) ? 0.0 : order.amount;
        m.sent = order;
        m.at = now;
        return order;
    }
    if (!wasRamping) {
        m.at = now - kStep; // the first step is taken now
    }
    advance(m, now);
    m.sent = {order.action, static_cast<int>(std::lround(m.speed))};
    return m.sent;
}

std::optional<MotorOrder> MotionShaper::step(MotorId motor, Instant now)
{
    Motor& m = m_motors.at(indexOf(motor));
    if (m.sent == m.wanted) {
        return std::nullopt;
    }
    advance(m, now);
    const MotorOrder next{m.wanted.action, static_cast<int>(std::lround(m.speed))};
    if (next == m.sent) {
        return std::nullopt; // less than a step of speed so far
    }
    m.sent = next;
    return next;
}

bool MotionShaper::isRamping() const
{
    return std::any_of(m_motors.begin(), m_motors.end(),
                       [](const Motor& m) { return m.sent != m.wanted; });
}

const MotorOrder& MotionShaper::sent(MotorId motor) const
{
    return m_motors.at(indexOf(motor)).sent;
}

void MotionShaper::reset()
{
    m_motors = {};
    m_isRampingDown = false;
}

bool MotionShaper::isStalled(MotorId motor, double amperes, Instant at)
{
    Motor& m = m_motors.at(indexOf(motor));
    if (!m_limits.guardsStall() || amperes < m_limits.stallAmperes) {
        m.overSince.reset();
        return false;
    }
    if (!m.overSince) {
        m.overSince = at;
    }
    return at - *m.overSince >= m_limits.stallTime;
}

void MotionShaper::rampDown(Instant now)
{
    m_isRampingDown = true;
    for (Motor& m : m_motors) {
        if (isBrake(m.wanted)) {
            continue;
        }
        if (!isReachKnown(m)) {
            m.speed = 0.0;
        }
        m.wanted = {MotorOrder::Action::Set, 0};
        m.at = now - kStep;
    }
}

} // namespace trex
