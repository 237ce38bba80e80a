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

Instant clockNow()
{
    return std::chrono::steady_clock::now();
}

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

constexpr std::size_t indexOf(MotorId motor)
{
    return static_cast<std::size_t>(motor);
}

} // namespace

Controller::Controller(TelemetryStore* store, StatusLatch* latch, QObject* parent)
    : QObject(parent)
    , m_store(store)
    , m_latch(latch)
    , m_sampler(store != nullptr ? std::make_unique<LinkSampler>(*store) : nullptr)
    , m_link(std::make_unique<LinkThread>())
{
    connect(&m_link->worker(), &LinkWorker::batchReady, this, &Controller::onBatch);
    connect(&m_link->worker(), &LinkWorker::closed, this, [this](quint32 generation) {
        if (generation == m_generation && m_isClosing) {
            m_isClosing = false;
            setState(LinkState::Disconnected, std::nullopt);
            failPending({ErrorCode::NotConnected, {}});
            emit closed();
            if (const auto next = std::exchange(m_openNext, std::nullopt)) {
                open(*next);
            }
        }
    });
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
    m_stopLatencyMsMax = 0.0;
    m_stats = {};
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
    if (m_isClosing || (m_state == LinkState::Disconnected && m_generation == 0)) {
        return;
    }
    m_isClosing = true;
    setArmed(false);
    m_orders = {};
    const auto packets = closingPackets();
    m_link->post([packets](LinkWorker& worker) { worker.close(packets); });
}

Model Controller::model() const
{
    return m_device.signature ? m_device.signature->model : Model::TrexJr;
}

quint64 Controller::enlist(QObject* context, ReplyHandler handler)
{
    const quint64 id = m_nextId++;
    if (handler) {
        m_waiting.insert(id, {context, context != nullptr, std::move(handler)});
    }
    return id;
}

void Controller::answer(quint64 id, const Result<Reply>& reply)
{
    if (!m_waiting.contains(id)) {
        return;
    }
    const Waiting waiting = m_waiting.take(id);
    if (!waiting.hasContext || waiting.context) {
        waiting.handler(reply);
    }
}

void Controller::failPending(const Error& error)
{
    const auto ids = m_waiting.keys();
    for (const quint64 id : ids) {
        answer(id, tl::make_unexpected(error));
    }
}

void Controller::request(const Command& command, QObject* context, ReplyHandler handler)
{
    const quint64 id = enlist(context, std::move(handler));
    Result<void> verdict = validate(command);
    if (verdict && command.row().kind == CommandKind::Motor) {
        verdict = fail(ErrorCode::BadCommand, describe(command));
    }
    if (verdict && m_state != LinkState::Connected) {
        verdict = fail(ErrorCode::NotConnected);
    }
    if (!verdict) {
        const Error error = verdict.error();
        QMetaObject::invokeMethod(
            this, [this, id, error] { answer(id, tl::make_unexpected(error)); },
            Qt::QueuedConnection);
        return;
    }
    m_link->post([transaction = Transaction{.id = id, .command = command}](LinkWorker& worker) {
        worker.submit(transaction);
    });
}

void Controller::requestRaw(const QByteArray& bytes, int replyBytes, QObject* context,
                            ReplyHandler handler)
{
    const quint64 id = enlist(context, std::move(handler));
    Result<void> verdict;
    if (bytes.isEmpty()) {
        verdict = fail(ErrorCode::BadCommand);
    } else if (m_state != LinkState::Connected) {
        verdict = fail(ErrorCode::NotConnected);
    } else if (holdsMotorCommand(bytes)) {
        verdict = gate();
    }
    if (!verdict) {
        const Error error = verdict.error();
        QMetaObject::invokeMethod(
            this, [this, id, error] { answer(id, tl::make_unexpected(error)); },
            Qt::QueuedConnection);
        return;
    }
    const Transaction transaction{.id = id, .rawBytes = bytes, .rawReplyBytes = replyBytes};
    m_link->post([transaction](LinkWorker& worker) { worker.submit(transaction); });
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
    for (const auto& wishes : std::as_const(m_wishes)) {
        for (std::size_t i = 0; i < highest.size(); ++i) {
            highest.at(i) = std::max(highest.at(i), wishes.at(i));
        }
    }
    m_link->post([highest](LinkWorker& worker) { worker.setWishes(highest); });
}

// ---- the motor gate

Result<void> Controller::gate() const
{
    if (m_state != LinkState::Connected || m_isClosing) {
        return fail(ErrorCode::NotConnected);
    }
    if (m_lockedUntil && clockNow() < *m_lockedUntil) {
        return fail(ErrorCode::LockedOut);
    }
    return m_armed ? Result<void>{} : fail(ErrorCode::Disarmed);
}

Result<void> Controller::arm()
{
    auto verdict = gate();
    if (!verdict && verdict.error().code != ErrorCode::Disarmed) {
        return verdict;
    }
    setArmed(true);
    return {};
}

void Controller::disarm()
{
    stop();
}

void Controller::setArmed(bool armed)
{
    if (m_armed != armed) {
        m_armed = armed;
        emit eventLogged(0, armed ? tr("Armed: motor orders are sent.") : tr("Disarmed."));
        emit armedChanged(armed);
    }
}

Result<void> Controller::order(const Result<Command>& command, QObject* context,
                               ReplyHandler handler)
{
    if (!command) {
        return tl::make_unexpected(command.error());
    }
    if (auto verdict = gate(); !verdict) {
        return verdict;
    }
    const Transaction transaction{.id = enlist(context, std::move(handler)),
                                  .command = *command,
                                  .priority = Priority::Motor};
    m_link->post([transaction](LinkWorker& worker) { worker.submit(transaction); });
    return {};
}

Result<void> Controller::driveMotor(MotorId motor, const MotorOrder& wanted, QObject* context,
                                    ReplyHandler handler)
{
    auto verdict = order(trex::driveMotor(motor, wanted), context, std::move(handler));
    if (verdict) {
        m_orders.at(indexOf(motor)) = wanted;
        emit ordersChanged();
    }
    return verdict;
}

Result<void> Controller::driveBoth(const MotorOrder& motor1, const MotorOrder& motor2,
                                   QObject* context, ReplyHandler handler)
{
    auto verdict = order(trex::driveBoth(motor1, motor2), context, std::move(handler));
    if (verdict) {
        m_orders.at(indexOf(MotorId::Motor1)) = motor1;
        m_orders.at(indexOf(MotorId::Motor2)) = motor2;
        emit ordersChanged();
    }
    return verdict;
}

MotorOrder Controller::lastOrder(MotorId motor) const
{
    return m_orders.at(indexOf(motor));
}

std::vector<Transaction> Controller::stopPackets(StopKind kind)
{
    std::vector<Transaction> packets;
    for (const Command& command : stopCommands(kind == StopKind::Brake)) {
        packets.push_back({.id = m_nextId++, .command = command, .priority = Priority::Stop});
    }
    return packets;
}

void Controller::stop(StopKind kind, QObject* context, ReplyHandler handler)
{
    const Instant now = clockNow();
    const auto packets = stopPackets(kind);
    m_stopId = packets.back().id;
    m_stopAsked = now;
    if (handler) {
        m_waiting.insert(m_stopId, {context, context != nullptr, std::move(handler)});
    }
    m_lockedUntil = now + kStopLockout;
    emit lockedOut();
    m_orders = {};
    m_link->post([packets](LinkWorker& worker) { worker.stop(packets); });
    if (m_state == LinkState::Disconnected) { // no line that could tell how it went
        QMetaObject::invokeMethod(
            this, [this, id = m_stopId] { answer(id, fail(ErrorCode::NotConnected)); },
            Qt::QueuedConnection);
    }
    setArmed(false);
    emit ordersChanged();
}

void Controller::powerCycleSimulator()
{
    m_link->post([](LinkWorker& worker) { worker.powerCycle(); });
    setArmed(false);
    if (m_sampler) {
        m_sampler->forgetOrders();
    }
    emit restarted();
}

void Controller::noteRestart(const QString& evidence)
{
    emit eventLogged(1, tr("The controller was restarted: %1.").arg(evidence));
    if (m_armed) {
        stop(); // it has forgotten our orders; nothing starts again without a person
    }
    m_orders = {};
    if (m_sampler) {
        m_sampler->forgetOrders();
    }
    emit ordersChanged();
    emit restarted();
}

} // namespace trex
