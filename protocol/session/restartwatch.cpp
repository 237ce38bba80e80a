// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/restartwatch.h"

#include "protocol/session/controller.h"
#include "protocol/telemetry/telemetrystore.h"

#include <utility>

namespace trex {

RestartWatch::RestartWatch(Controller& controller, const TelemetryStore& store, QObject* parent)
    : QObject(parent), m_controller(controller), m_store(store)
{
    connect(&controller, &Controller::batchArrived, this, &RestartWatch::look);
    connect(&controller, &Controller::armedChanged, this, &RestartWatch::wantCurrents);
    wantCurrents();
}

RestartWatch::~RestartWatch()
{
    m_controller.wantNothing(this);
}

void RestartWatch::wantCurrents()
{
    m_controller.want(this, PollId::Currents, m_controller.isArmed() ? kHertz : 0.0);
}

void RestartWatch::look()
{
    const PollSample* sample = m_store.latest(PollId::Currents);
    if (!m_controller.isArmed() || sample == nullptr) {
        m_evidence.forget(m_controller.stats().timeouts);
        return;
    }
    if (std::exchange(m_last, sample->time) == sample->time) {
        return; // what was read before says nothing about now
    }
    const auto motor = m_evidence.take(
        {sample->time,
         {m_controller.sentOrder(MotorId::Motor1), m_controller.sentOrder(MotorId::Motor2)},
         {static_cast<int>(sample->raw.at(0)), static_cast<int>(sample->raw.at(1))},
         m_controller.stats().timeouts});
    if (motor) {
        m_controller.noteRestart(tr("a reply was missing, and motor %1 draws no current any "
                                    "more although its order stands")
                                     .arg(*motor + 1));
    }
}

} // namespace trex
