// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/restartwatch.h"

#include "protocol/session/controller.h"
#include "protocol/telemetry/telemetrystore.h"

#include <cstdlib>

namespace trex {

RestartWatch::RestartWatch(Controller& controller, const TelemetryStore& store, QObject* parent)
    : QObject(parent), m_controller(controller), m_store(store)
{
    connect(&controller, &Controller::batchArrived, this, &RestartWatch::look);
}

bool RestartWatch::isGone(Motor& motor, const MotorOrder& order, int counts, Instant at) const
{
    if (order != motor.order) {
        motor = {order, at, false, std::nullopt};
    }
    const bool isDriven =
        order.action != MotorOrder::Action::Brake && std::abs(order.amount) >= kLeastSpeed;
    if (!isDriven) {
        return false;
    }
    if (counts > 0) {
        motor.hadCurrent = motor.hadCurrent || counts >= kLeastCounts;
        motor.goneSince.reset();
        return false;
    }
    if (!motor.hadCurrent) {
        return false;
    }
    if (!motor.goneSince) {
        motor.goneSince = at;
    }
    return at - *motor.goneSince >= kGone;
}

void RestartWatch::look()
{
    const quint64 timeouts = m_controller.stats().timeouts;
    const PollSample* sample = m_store.latest(PollId::Currents);
    if (!m_controller.isArmed() || sample == nullptr) {
        m_motors = {};
        m_lostReply.reset();
        m_timeouts = timeouts;
        return;
    }
    if (timeouts > std::exchange(m_timeouts, timeouts)) {
        m_lostReply = sample->time;
    }
    for (const MotorId id : {MotorId::Motor1, MotorId::Motor2}) {
        const auto i = static_cast<std::size_t>(id);
        const bool gone =
            isGone(m_motors.at(i), m_controller.sentOrder(id), sample->raw.at(i), sample->time);
        if (gone && m_lostReply && sample->time - *m_lostReply < kLostReplyCounts) {
            m_controller.noteRestart(tr("a reply was missing, and motor %1 draws no current any "
                                        "more although its order stands")
                                         .arg(i + 1));
            return;
        }
    }
}

} // namespace trex
