// SPDX-License-Identifier: GPL-3.0-or-later
// LinkWorker's own gate: what happens on the link thread when the façade cannot, or not soon
// enough.
#include "protocol/codec/packet.h"
#include "protocol/session/linkworker.h"
#include "protocol/transport/laststop.h"

namespace trex {

void LinkWorker::setArmed(bool armed)
{
    m_isArmed = armed && m_engine && m_engine->state() == LinkState::Connected;
    if (m_isArmed) {
        heartbeat();
        m_freeze.start();
    } else {
        m_freeze.stop();
    }
}

void LinkWorker::lookForFreeze()
{
    if (std::chrono::steady_clock::now() - m_lastHeartbeat < kLongestFreeze) {
        return;
    }
    setArmed(false);
    std::vector<Transaction> packets;
    for (const Command& command : stopCommands(false)) {
        packets.push_back({.command = command, .priority = Priority::Stop});
    }
    stop(packets);
    emit frozen(m_generation);
}

void LinkWorker::refuse(const Transaction& transaction)
{
    LinkBatch batch = m_engine->takeBatch(clockNow());
    batch.generation = m_generation;
    batch.outcomes.push_back({transaction.id, fail(ErrorCode::Disarmed)});
    emit batchReady(batch);
}

void LinkWorker::beSilentFor(std::chrono::milliseconds duration)
{
    m_silentUntil = duration.count() > 0 ? clockNow() + duration : Instant{};
    schedulePump();
}

/// What follows on this thread from the engine's state, without the round through the façade.
void LinkWorker::followState()
{
    const bool isConnected = m_engine->state() == LinkState::Connected;
    if (!isConnected && m_isArmed) {
        setArmed(false);
    }
    if (isConnected && m_isOpen && m_stopOnClose && !m_hasLastStop) {
        QByteArray bytes;
        for (const Command& command : stopCommands(false)) {
            bytes += encode(command, m_line);
        }
        laststop::prepare(this, m_transport->descriptor(), bytes);
        m_hasLastStop = true;
    }
}

void LinkWorker::withdrawLastStop()
{
    laststop::withdraw(this);
    m_hasLastStop = false;
}

} // namespace trex
