// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/controller.h"

#include "protocol/errortext.h"
#include "protocol/session/linkengine.h"
#include "protocol/session/linksampler.h"
#include "protocol/session/linkthread.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"

namespace trex {

namespace {

constexpr double kGuardHertz = 40.0; ///< currents for the stall guard

bool isMotorOpcode(int byte)
{
    const CommandRow* row = findCommand(static_cast<std::uint8_t>(byte));
    return row != nullptr && row->kind == CommandKind::Motor;
}

/// In either packet form; 0xC0 to 0xF1 never occurs as a data byte.
bool holdsMotorCommand(const QByteArray& bytes)
{
    for (qsizetype i = 0; i < bytes.size(); ++i) {
        const int byte = static_cast<std::uint8_t>(bytes[i]);
        if (isMotorOpcode(byte)) {
            return true;
        }
        // The command of an unfinished frame may follow in the next bytes given by hand.
        const bool framed = byte == commandRow("pololu-packet").first;
        const bool open = i + 2 >= bytes.size();
        if (framed && (open || isMotorOpcode(static_cast<std::uint8_t>(bytes[i + 2]) | 0x80))) {
            return true;
        }
    }
    return false;
}

} // namespace

Controller::Controller(TelemetryStore* store, StatusLatch* latch, QObject* parent)
    : QObject(parent)
    , m_store(store)
    , m_latch(latch)
    , m_sampler(store != nullptr ? std::make_unique<LinkSampler>(*store) : nullptr)
    , m_link(std::make_unique<LinkThread>())
    , m_motion(this)
    , m_alive(this)
    , m_stopPatience(this)
{
    connect(&m_link->worker(), &LinkWorker::batchReady, this, &Controller::onBatch);
    connect(&m_link->worker(), &LinkWorker::closed, this, [this](quint32 generation) {
        if (generation == m_generation && m_isClosing) {
            m_isClosing = false;
            setState(LinkState::Disconnected, std::nullopt);
            m_waiting.failAll({ErrorCode::NotConnected, {}});
            emit closed();
            if (const auto next = std::exchange(m_openNext, std::nullopt)) {
                open(*next);
            }
        }
    });
    connect(&m_link->worker(), &LinkWorker::frozen, this, [this](quint32 generation) {
        if (generation == m_generation) {
            disarm(DisarmReason::Frozen);
        }
    });
    watchMotion();
    if (latch != nullptr) {
        // Always asked: the link's health, who drives the motors, and the latched bits.
        for (const auto& [poll, hertz] : {std::pair{PollId::Mode, 2.0},
                                          {PollId::SerialControl, 5.0},
                                          {PollId::Learned, 1.0},
                                          {PollId::Status, 10.0},
                                          {PollId::UartErrors, 10.0}}) {
            want(this, poll, hertz);
        }
    }
}

Controller::~Controller()
{
    disconnect(&m_link->worker(), nullptr, this, nullptr);
    const auto packets = closingPackets();
    m_link->post([packets](LinkWorker& worker) { worker.close(packets); });
}

/// A line on which nobody has answered may have another speed, and a controller there hear the stop
/// as an order.
std::vector<Transaction> Controller::closingPackets()
{
    return m_options.stopOnClose && m_wasConnected ? stopPackets(StopKind::Coast)
                                                   : std::vector<Transaction>{};
}

void Controller::closeQuietly()
{
    // While it answers, nothing is in doubt, and it is stopped as by every other way out.
    m_options.stopOnClose = m_options.stopOnClose && m_state == LinkState::Connected;
    close();
}

void Controller::open(const OpenOptions& options)
{
    if (m_isRecording) {
        emit eventLogged(1, errorText({ErrorCode::IsRecording, {}}));
        return;
    }
    if (m_isClosing || m_state != LinkState::Disconnected) {
        close();
        m_openNext = options;
        return;
    }
    m_options = options;
    ++m_generation;
    m_wasConnected = false;
    m_wasSilent = false;
    m_lastMode.reset();
    m_gate.newLine();
    m_stats = {};
    m_health = {};
    if (m_sampler) {
        m_sampler->restart();
    }
    setState(LinkState::Connecting, std::nullopt);
    m_link->post([options, generation = m_generation](LinkWorker& worker) {
        worker.open(options, generation);
    });
}

void Controller::close()
{
    m_openNext.reset();
    if (m_isRecording || m_isClosing || (m_state == LinkState::Disconnected && m_generation == 0)) {
        return;
    }
    m_isClosing = true;
    closeGate(DisarmReason::Disconnected);
    const auto packets = closingPackets();
    m_link->post([packets](LinkWorker& worker) { worker.close(packets); });
}

Model Controller::model() const
{
    return m_device.signature ? m_device.signature->model : Model::TrexJr;
}

void Controller::refuse(quint64 id, const Error& error)
{
    QMetaObject::invokeMethod(
        this, [this, id, error] { m_waiting.answer(id, tl::make_unexpected(error)); },
        Qt::QueuedConnection);
}

void Controller::request(const Command& command, QObject* context, ReplyHandler handler)
{
    const quint64 id = m_waiting.enlist(context, std::move(handler));
    Result<void> verdict = validate(command);
    if (verdict && command.row().kind == CommandKind::Motor) {
        verdict = fail(ErrorCode::BadCommand, describe(command));
    }
    if (verdict && m_isRecording) {
        verdict = fail(ErrorCode::IsRecording);
    } else if (verdict && m_state != LinkState::Connected) {
        verdict = fail(ErrorCode::NotConnected);
    }
    if (!verdict) {
        refuse(id, verdict.error());
        return;
    }
    m_link->post([transaction = Transaction{.id = id, .command = command}](LinkWorker& worker) {
        worker.submit(transaction);
    });
}

void Controller::requestRaw(const QByteArray& bytes, int replyBytes, QObject* context,
                            ReplyHandler handler)
{
    const quint64 id = m_waiting.enlist(context, std::move(handler));
    Result<void> verdict;
    if (bytes.isEmpty()) {
        verdict = fail(ErrorCode::BadCommand);
    } else if (m_isRecording) {
        verdict = fail(ErrorCode::IsRecording);
    } else if (m_state != LinkState::Connected) {
        verdict = fail(ErrorCode::NotConnected);
    } else if (holdsMotorCommand(bytes)) {
        verdict = mayDrive();
    }
    if (!verdict) {
        refuse(id, verdict.error());
        return;
    }
    const Transaction transaction{.id = id, .rawBytes = bytes, .rawReplyBytes = replyBytes};
    m_link->post([transaction](LinkWorker& worker) { worker.submit(transaction); });
}

void Controller::resetHealth()
{
    m_health = {.adapter = m_health.adapter};
    m_link->post([](LinkWorker& worker) { worker.resetHealth(); });
}

void Controller::want(const QObject* who, PollId poll, double hertz)
{
    m_wishes[who].at(static_cast<std::size_t>(poll)) = hertz;
    sendWishes();
}

void Controller::wantNothing(const QObject* who)
{
    m_wishes.remove(who);
    sendWishes();
}

void Controller::sendWishes()
{
    PollWishes highest{};
    if (m_shaper.limits().guardsStall()) {
        highest.at(static_cast<std::size_t>(PollId::Currents)) = kGuardHertz;
    }
    for (const auto& wishes : std::as_const(m_wishes)) {
        for (std::size_t i = 0; i < highest.size(); ++i) {
            highest.at(i) = std::max(highest.at(i), wishes.at(i));
        }
    }
    m_link->post([highest](LinkWorker& worker) { worker.setWishes(highest); });
}

} // namespace trex
