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
        laststop::prepare(this, m_transport->descriptor(), stopBytes());
        m_hasLastStop = true;
    }
}

QByteArray LinkWorker::stopBytes() const
{
    QByteArray bytes;
    for (const Command& command : stopCommands(false)) {
        bytes += encode(command, m_line);
    }
    return bytes;
}

/// A line that pours is closed. It may still carry what we send: the motors are stopped before.
void LinkWorker::cutOff()
{
    if (m_hasLastStop) {
        m_transport->write(stopBytes());
    }
    onFailed({ErrorCode::Garbage, m_address});
    // Not from within the transport's own signal.
    QMetaObject::invokeMethod(m_transport.get(), &Transport::close, Qt::QueuedConnection);
}

void LinkWorker::withdrawLastStop()
{
    laststop::withdraw(this);
    m_hasLastStop = false;
}

} // namespace trex
