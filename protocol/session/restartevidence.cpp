// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/restartevidence.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace trex {

void RestartEvidence::follow(Motor& motor, const MotorOrder& order, int counts, Instant at) const
{
    if (order != motor.order) {
        motor = {};
        motor.order = order;
    }
    const bool isDriven =
        order.action != MotorOrder::Action::Brake && std::abs(order.amount) >= kLeastSpeed;
    if (!isDriven) {
        return;
    }
    if (counts > 0) {
        ++motor.readings;
        motor.highest = std::max(motor.highest, counts);
        motor.zeros = 0;
        return;
    }
    if (++motor.zeros == 1) {
        motor.firstZero = m_number;
        motor.goneSince = at;
        motor.wasSteady = motor.readings >= kManyReadings
            || (motor.readings >= kLeastReadings && motor.highest >= kLeastCounts);
        motor.readings = motor.highest = 0;
    }
}

bool RestartEvidence::tells(const Motor& motor, Instant at) const
{
    return m_lostReply && motor.wasSteady && motor.zeros >= kGoneReadings
        && at - motor.goneSince >= kGone
        && std::abs(motor.firstZero - *m_lostReply) <= kReadingsBetween;
}

std::optional<std::size_t> RestartEvidence::take(const Reading& reading)
{
    ++m_number;
    if (reading.timeouts > std::exchange(m_timeouts, reading.timeouts)) {
        m_lostReply = m_number;
    }
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < m_motors.size(); ++i) {
        follow(m_motors.at(i), reading.orders.at(i), reading.counts.at(i), reading.at);
        if (tells(m_motors.at(i), reading.at)) {
            found = i;
        }
    }
    return found;
}

void RestartEvidence::forget(quint64 timeouts)
{
    m_motors = {};
    m_lostReply.reset();
    m_timeouts = timeouts;
}

} // namespace trex
