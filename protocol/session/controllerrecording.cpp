// SPDX-License-Identifier: GPL-3.0-or-later
// Controller as the façade of a recording: it shows what was known then, and reaches no line.
#include "protocol/session/controller.h"
#include "protocol/session/recordedstate.h"

namespace trex {

/// Whatever would need a line is refused (IsRecording); STOP is told by lockedOut() all the same,
/// for the controller that is connected.
void Controller::becomeRecording()
{
    Q_ASSERT(m_generation == 0); // no line was ever opened by it, and none will be
    m_isRecording = true;
}

void Controller::show(const RecordedState& state)
{
    const auto isSame = [](const DeviceInfo& a, const DeviceInfo& b) {
        const auto text = [](const auto& signature) {
            return signature ? signature->text() : QString();
        };
        return text(a.signature) == text(b.signature) && a.mode == b.mode
            && a.serialControls == b.serialControls && a.learnedMask == b.learnedMask;
    };
    const bool isNewDevice = !isSame(m_device, state.device);
    const bool isNewLink = m_state != state.link;
    m_options = state.options;
    m_device = state.device;
    m_stats = state.stats;
    m_state = state.link;
    if (isNewDevice) {
        emit deviceChanged();
    }
    showOrders(state.orders);
    if (isNewLink) {
        emit stateChanged(m_state);
    }
    emit batchArrived();
}

/// As if they had been ordered and sent, without limits; nothing ramps and nothing is sent.
void Controller::showOrders(const std::array<MotorOrder, 3>& orders)
{
    bool isNew = false;
    for (std::size_t i = 0; i < orders.size(); ++i) {
        const auto motor = static_cast<MotorId>(i);
        if (m_gate.order(motor) != orders[i]) {
            m_gate.setOrder(motor, orders[i], {});
            m_shaper.take(motor, orders[i], {});
            isNew = true;
        }
    }
    if (isNew) {
        emit ordersChanged();
    }
}

void Controller::showRecords(const std::vector<TransactionRecord>& records, bool isAnew)
{
    if (isAnew) {
        emit recordsForgotten();
    }
    if (!records.empty()) {
        emit recordsArrived(records);
    }
}

} // namespace trex
