// SPDX-License-Identifier: GPL-3.0-or-later
// Controller's receiving half: what the link thread reports.
#include "protocol/codec/packet.h"
#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "protocol/session/linkengine.h"
#include "protocol/session/linkfacts.h"
#include "protocol/session/linksampler.h"
#include "protocol/session/linkthread.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"

namespace trex {

namespace {

QString stateSentence(LinkState state, const std::optional<Error>& error,
                      const OpenOptions& options, const DeviceInfo& device)
{
    switch (state) {
    case LinkState::Disconnected:
        return error ? Controller::tr("Not connected: %1").arg(errorText(*error))
                     : Controller::tr("Disconnected.");
    case LinkState::Connecting:
        return Controller::tr("Connecting to %1 at %2 baud.")
            .arg(options.port)
            .arg(options.line.baud);
    case LinkState::Connected:
        return device.signature
            ? Controller::tr("Connected to a %1, firmware %2.")
                  .arg(device.signature->modelName(), device.signature->firmware())
            : Controller::tr("Connected.");
    case LinkState::Lost:
        return error ? Controller::tr("Link lost: %1").arg(errorText(*error))
                     : Controller::tr("Link lost.");
    case LinkState::Retrying:
        return error ? Controller::tr("Trying again: %1").arg(errorText(*error)) : QString();
    }
    return {};
}

} // namespace

void Controller::onBatch(const LinkBatch& batch)
{
    if (batch.generation != m_generation) {
        return; // of an earlier connection
    }
    m_stats = batch.stats;
    if (!batch.health.empty()) {
        const AdapterFacts before = std::exchange(m_health, batch.health.back()).adapter;
        const QString note = m_health.adapter != before ? adapterText(m_health.adapter) : QString();
        if (!note.isEmpty()) {
            emit eventLogged(0, note);
        }
    }
    for (const PollSample& sample : batch.samples) {
        onSample(sample);
    }
    if (m_sampler) {
        m_sampler->take(batch, m_options.line);
    }
    if (!batch.records.empty()) {
        emit recordsArrived(batch.records);
    }
    for (const LinkEvent& event : batch.events) {
        onEvent(event);
    }
    for (const Outcome& outcome : batch.outcomes) {
        onOutcome(outcome);
    }
    emit batchArrived();
}

void Controller::onEvent(const LinkEvent& event)
{
    switch (event.kind) {
    case LinkEvent::Kind::StateChanged:
        if (!m_isClosing) {
            setState(event.state, event.error);
        }
        break;
    case LinkEvent::Kind::Identified:
        if (!m_isClosing) {
            m_device.signature = event.signature;
            emit deviceChanged();
        }
        break;
    case LinkEvent::Kind::LatchReadLost:
        emit eventLogged(1,
                         tr("A reply with latched bits was lost on the line; bits that it carried "
                            "may be missing from the counts."));
        break;
    case LinkEvent::Kind::Resynchronised:
        break; // counted in the statistics
    case LinkEvent::Kind::EchoFound:
        emit eventLogged(0,
                         tr("The line echoes what is sent (RS-232 wiring); the echo is dropped."));
        break;
    }
}

void Controller::onOutcome(const Outcome& outcome)
{
    if (outcome.reply) {
        learnFrom(*outcome.reply);
    }
    const auto step = m_gate.stopRecorded(outcome.id, outcome.reply.has_value());
    if (step == MotorGate::StopStep::Sent || step == MotorGate::StopStep::Failed) {
        stopEnded(outcome.reply);
    }
    m_waiting.answer(outcome.id, outcome.reply);
}

/// A reply that somebody asked for says as much as a polled one; latched bits above all, since
/// reading has cleared them in the controller.
void Controller::learnFrom(const Reply& reply)
{
    if (reply.payload.isEmpty()) {
        return;
    }
    Command asked = reply.command;
    if (asked.opcode == 0) { // sent as raw bytes; they may be a packet all the same
        const auto packet = decodePacket(reply.sentBytes, m_options.line);
        if (!packet || replyLength(packet->command) != reply.payload.size()) {
            return;
        }
        asked = packet->command;
    }
    if (m_options.line.form == PacketForm::Pololu) {
        m_options.line.device = deviceAfter(reply.command, reply.payload, m_options.line.device);
    }
    for (const PollRow& row : kPolls) {
        if (!row.hasMask && asked == pollCommand(row.id) && isPlausible(asked, reply.payload)) {
            onSample(decodePoll(row.id, reply.payload, reply.received));
        }
    }
}

void Controller::onSample(const PollSample& sample)
{
    if (m_store != nullptr) {
        m_store->append(sample);
    }
    guard(sample);
    const auto byte = static_cast<std::uint8_t>(sample.raw.front());
    const DeviceInfo before = m_device;
    switch (sample.poll) {
    case PollId::Status:
    case PollId::UartErrors:
        if (m_latch != nullptr) {
            const bool uart = sample.poll == PollId::UartErrors;
            m_latch->record(uart ? StatusLatch::Byte::Uart : StatusLatch::Byte::Status, byte,
                            sample.time);
        }
        break;
    case PollId::Mode: {
        const char letter = static_cast<char>(byte);
        m_device.mode = parseMode(QByteArrayView(&letter, 1))
                            .map([](Mode m) { return std::optional(m); })
                            .value_or(std::nullopt);
        if (m_device.mode) {
            followMode(*m_device.mode);
        }
        break;
    }
    case PollId::SerialControl:
        m_device.serialControls = byte == 1;
        break;
    case PollId::Learned:
        m_device.learnedMask = byte;
        break;
    case PollId::Currents:
    case PollId::RawChannels:
    case PollId::RemappedChannels:
        break;
    }
    if (before.mode != m_device.mode || before.serialControls != m_device.serialControls
        || before.learnedMask != m_device.learnedMask) {
        emit deviceChanged();
    }
}

/// In serial mode the letter follows parameter 0x7C, which takes a power cycle to act (command
/// documentation, 0xAF): another letter is proof of one, however short it was. A jumper's change is
/// none.
void Controller::followMode(Mode mode)
{
    const auto before = std::exchange(m_lastMode, mode);
    if (before && *before != mode && isSerial(*before) && isSerial(mode)) {
        noteRestart(inputOf(mode) == InputKind::Analog
                        ? tr("its channel inputs are read as voltages now, which only a power "
                             "cycle brings about")
                        : tr("its channel inputs are read as RC pulses now, which only a power "
                             "cycle brings about"));
    }
}

void Controller::setState(LinkState state, const std::optional<Error>& error)
{
    if (state == m_state && error == m_lastError) {
        return;
    }
    const LinkState before = std::exchange(m_state, state);
    m_lastError = error;
    if (state != LinkState::Connected) {
        closeGate(DisarmReason::LinkLost);
        if (before == LinkState::Connected) {
            m_device = {};
            if (m_store != nullptr) {
                m_store->markGap(std::chrono::steady_clock::now());
            }
            if (m_latch != nullptr) {
                m_latch->linkLost();
            }
            m_wasSilent = error && error->code == ErrorCode::NoReply;
            emit deviceChanged();
            emit ordersChanged();
        }
    }
    const QString sentence = stateSentence(state, error, m_options, m_device);
    if (!sentence.isEmpty()) {
        emit eventLogged(error ? 2 : 0, sentence);
    }
    emit stateChanged(state);
    if (state == LinkState::Connected) {
        if (std::exchange(m_wasConnected, true)) {
            if (std::exchange(m_wasSilent, false)) {
                emit eventLogged(1,
                                 tr("The controller was silent and answers again: it may have been "
                                    "restarted. Everything is read anew."));
                emit restarted();
            }
            emit reconnected();
        }
    }
}

} // namespace trex
