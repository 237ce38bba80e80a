// SPDX-License-Identifier: GPL-3.0-or-later
// Controller's motor gate: the one place through which every motor command passes.
#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "protocol/session/linkengine.h"
#include "protocol/session/linksampler.h"
#include "protocol/session/linkthread.h"

namespace trex {

using namespace std::chrono_literals;

namespace {

constexpr std::array kMotors{MotorId::Motor1, MotorId::Motor2, MotorId::Aux};
constexpr auto kStopPatience = 1s; ///< until a stop whose records do not come is called failed

Instant clockNow()
{
    return std::chrono::steady_clock::now();
}

QString reasonSentence(const Disarming& disarming)
{
    const QString reason = disarmText(disarming.reason);
    return disarming.detail.isEmpty()
        ? Controller::tr("Disarmed: %1.").arg(reason)
        : Controller::tr("Disarmed: %1 (%2).").arg(reason, disarming.detail);
}

} // namespace

void Controller::watchMotion()
{
    m_motion.setTimerType(Qt::PreciseTimer);
    m_motion.setInterval(MotionShaper::kStep);
    connect(&m_motion, &QTimer::timeout, this, [this] {
        ShapedOrders steps;
        for (const MotorId motor : kMotors) {
            if (const auto order = m_shaper.step(motor, clockNow())) {
                steps.emplace_back(motor, *order);
            }
        }
        drive(steps, nullptr, {});
        if (m_shaper.isRamping()) {
            return;
        }
        m_motion.stop();
        if (m_shaper.isRampingDown()) {
            disarm(DisarmReason::Stalled);
        }
    });
    m_alive.setInterval(LinkWorker::kHeartbeat);
    connect(&m_alive, &QTimer::timeout, this, [this] {
        m_link->post([](LinkWorker& worker) { worker.heartbeat(); });
        if (m_gate.isIdle(clockNow())) {
            disarm(DisarmReason::Idle);
        }
    });
    m_stopPatience.setSingleShot(true);
    m_stopPatience.setInterval(kStopPatience);
    connect(&m_stopPatience, &QTimer::timeout, this, [this] {
        m_gate.stopGivenUp();
        stopEnded(fail(ErrorCode::NoReply));
    });
}

Result<void> Controller::mayDrive() const
{
    if (m_isRecording) {
        return fail(ErrorCode::IsRecording);
    }
    if (m_state != LinkState::Connected || m_isClosing) {
        return fail(ErrorCode::NotConnected);
    }
    return m_shaper.isRampingDown() ? fail(ErrorCode::LockedOut) : m_gate.check(clockNow());
}

Result<void> Controller::arm()
{
    auto verdict = mayDrive();
    if (!verdict && verdict.error().code != ErrorCode::Disarmed) {
        return verdict;
    }
    if (!m_gate.isArmed()) {
        m_gate.arm(clockNow());
        m_alive.start();
        m_link->post([](LinkWorker& worker) { worker.setArmed(true); });
        emit eventLogged(0, tr("Armed: motor orders are sent."));
        emit armedChanged(true);
    }
    return {};
}

void Controller::disarm()
{
    stopFor({DisarmReason::Person, {}, {}}, StopKind::Coast, nullptr, {});
}

void Controller::disarm(DisarmReason reason, const QString& detail)
{
    if (m_gate.isArmed()) {
        stopFor({reason, detail, {}}, StopKind::Coast, nullptr, {});
    }
}

/// No order is left behind: nothing that was under way goes on after this.
void Controller::closeGate(DisarmReason reason, const QString& detail)
{
    m_motion.stop();
    m_alive.stop();
    m_shaper.reset();
    m_gate.forgetOrders();
    if (m_gate.disarm(reason, detail)) {
        m_link->post([](LinkWorker& worker) { worker.setArmed(false); });
        const bool isAsked = reason == DisarmReason::Person || reason == DisarmReason::Stop
            || reason == DisarmReason::Disconnected;
        emit eventLogged(isAsked ? 0 : 1, reasonSentence(m_gate.lastDisarming()));
        emit armedChanged(false);
    }
}

Result<void> Controller::driveMotor(MotorId motor, const MotorOrder& wanted, QObject* context,
                                    ReplyHandler handler)
{
    if (const auto command = trex::driveMotor(motor, wanted); !command) {
        return tl::make_unexpected(command.error());
    }
    if (auto verdict = mayDrive(); !verdict) {
        return verdict;
    }
    const Instant now = clockNow();
    const MotorOrder order = m_shaper.limited(motor, wanted);
    m_gate.setOrder(motor, order, now);
    drive({{motor, m_shaper.take(motor, order, now)}}, context, std::move(handler));
    return {};
}

Result<void> Controller::driveBoth(const MotorOrder& motor1, const MotorOrder& motor2,
                                   QObject* context, ReplyHandler handler)
{
    if (const auto command = trex::driveBoth(motor1, motor2); !command) {
        return tl::make_unexpected(command.error());
    }
    if (auto verdict = mayDrive(); !verdict) {
        return verdict;
    }
    const Instant now = clockNow();
    ShapedOrders orders;
    for (const auto& [motor, wanted] :
         {std::pair{MotorId::Motor1, motor1}, std::pair{MotorId::Motor2, motor2}}) {
        const MotorOrder order = m_shaper.limited(motor, wanted);
        m_gate.setOrder(motor, order, now);
        orders.emplace_back(motor, m_shaper.take(motor, order, now));
    }
    drive(orders, context, std::move(handler));
    return {};
}

/// Motors 1 and 2 in one packet where that can be said in one.
void Controller::drive(const ShapedOrders& orders, QObject* context, ReplyHandler handler)
{
    std::vector<Command> commands;
    for (std::size_t i = 0; i < orders.size(); ++i) {
        const auto& [motor, order] = orders[i];
        const bool isPair = motor == MotorId::Motor1 && i + 1 < orders.size()
            && orders[i + 1].first == MotorId::Motor2;
        if (const auto both = isPair ? trex::driveBoth(order, orders[i + 1].second)
                                     : Result<Command>(fail(ErrorCode::BadCommand))) {
            commands.push_back(*both);
            ++i;
        } else if (const auto one = trex::driveMotor(motor, order)) {
            commands.push_back(*one);
        }
    }
    const auto submit = [this](quint64 id, const Command& command) {
        m_link->post(
            [transaction = Transaction{.id = id, .command = command, .priority = Priority::Motor}](
                LinkWorker& worker) { worker.submit(transaction); });
    };
    for (std::size_t i = 0; i + 1 < commands.size(); ++i) {
        submit(m_waiting.nextId(), commands[i]);
    }
    if (!commands.empty()) { // the last one's leaving is told
        submit(m_waiting.enlist(context, std::move(handler)), commands.back());
    }
    if (m_shaper.isRamping() && !m_motion.isActive()) {
        m_motion.start();
    }
    if (!commands.empty()) {
        emit ordersChanged();
    }
}

void Controller::setMotionLimits(const MotionLimits& limits)
{
    m_shaper.setLimits(limits);
    sendWishes(); // the stall guard needs currents
    // What runs already obeys them, too.
    for (const MotorId motor : kMotors) {
        const MotorOrder order = m_gate.order(motor);
        if (m_gate.isArmed() && m_shaper.limited(motor, order) != order) {
            std::ignore = driveMotor(motor, order);
        }
    }
}

std::vector<Transaction> Controller::stopPackets(StopKind kind)
{
    std::vector<Transaction> packets;
    for (const Command& command : stopCommands(kind == StopKind::Brake)) {
        packets.push_back(
            {.id = m_waiting.nextId(), .command = command, .priority = Priority::Stop});
    }
    return packets;
}

void Controller::stop(StopKind kind, QObject* context, ReplyHandler handler)
{
    stopFor({DisarmReason::Stop, {}, {}}, kind, context, std::move(handler));
}

void Controller::stopFor(const Disarming& why, StopKind kind, QObject* context,
                         ReplyHandler handler)
{
    if (m_isRecording) {
        emit lockedOut(); // whoever presses STOP means the motors that run now
        return;
    }
    const auto packets = stopPackets(kind);
    std::vector<quint64> ids;
    ids.reserve(packets.size());
    for (const Transaction& packet : packets) {
        ids.push_back(packet.id);
    }
    m_gate.stopAsked(ids, clockNow());
    m_stopPatience.start();
    m_waiting.wait(ids.back(), context, std::move(handler));
    emit lockedOut();
    m_link->post([packets](LinkWorker& worker) { worker.stop(packets); });
    if (m_state == LinkState::Disconnected) { // no line that could tell how it went
        m_stopPatience.stop();
        m_gate.stopGivenUp();
        refuse(ids.back(), {ErrorCode::NotConnected, {}});
    }
    closeGate(why.reason, why.detail);
    emit ordersChanged();
}

/// Told "stopped" only when the record of each packet is there.
void Controller::stopEnded(const Result<Reply>& lastPacket)
{
    m_stopPatience.stop();
    if (lastPacket) {
        const double ms = m_gate.stopSent(lastPacket->sent);
        emit eventLogged(0, tr("Stop sent to all three motors (%1 ms).").arg(ms, 0, 'f', 1));
        emit stopped();
        return;
    }
    const QString why = errorText(lastPacket.error());
    emit eventLogged(2, tr("Stop could not be sent: %1").arg(why));
    emit stopFailed(why);
}

void Controller::guard(const PollSample& sample)
{
    if (!m_gate.isArmed()) {
        return;
    }
    const bool isUart = sample.poll == PollId::UartErrors;
    if (isUart || sample.poll == PollId::Status) {
        const auto fault = m_gate.faultIn(isUart, static_cast<std::uint8_t>(sample.raw.front()));
        const bool isExpected =
            m_expectsTimeout && fault && fault->reason == DisarmReason::SerialTimeout;
        if (fault && !isExpected) {
            disarm(fault->reason, fault->detail);
        }
    } else if (sample.poll == PollId::Currents && !m_shaper.isRampingDown()) {
        for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2}) {
            const double amperes =
                sample.raw.at(static_cast<std::size_t>(motor)) * amperesPerCount(model());
            if (m_shaper.isStalled(motor, amperes, sample.time)) {
                rampDownFor(motor, amperes);
                return;
            }
        }
    }
}

void Controller::rampDownFor(MotorId motor, double amperes)
{
    emit eventLogged(1,
                     tr("Stall guard: motor %1 drew %2 A for %3 ms. All motors are led to zero.")
                         .arg(motor == MotorId::Motor1 ? 1 : 2)
                         .arg(amperes, 0, 'f', 2)
                         .arg(m_shaper.limits().stallTime.count()));
    m_gate.forgetOrders();
    m_shaper.rampDown(clockNow());
    m_motion.start();
    emit ordersChanged();
}

void Controller::beSilentFor(std::chrono::milliseconds duration)
{
    m_expectsTimeout = true;
    m_link->post([duration](LinkWorker& worker) { worker.beSilentFor(duration); });
}

void Controller::endSilence()
{
    m_expectsTimeout = false;
    m_link->post([](LinkWorker& worker) { worker.beSilentFor({}); });
}

void Controller::powerCycleSimulator()
{
    m_link->post([](LinkWorker& worker) { worker.powerCycle(); });
    closeGate(DisarmReason::Restarted);
    if (m_sampler) {
        m_sampler->forgetOrders();
    }
    emit ordersChanged();
    emit restarted();
}

void Controller::noteRestart(const QString& evidence)
{
    emit eventLogged(1, tr("The controller was restarted: %1.").arg(evidence));
    // It has forgotten our orders; nothing starts again without a person.
    disarm(DisarmReason::Restarted, evidence);
    closeGate(DisarmReason::Restarted);
    if (m_sampler) {
        m_sampler->forgetOrders();
    }
    emit ordersChanged();
    emit restarted();
}

} // namespace trex
