// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/benchtest.h"

#include "protocol/errortext.h"
#include "protocol/storage/benchtext.h"

namespace trex {
namespace {

constexpr double kStatusHertz = 20.0;
constexpr double kControlHertz = 5.0;
constexpr int kTicksAShow = 5;
constexpr std::chrono::seconds kLongestStop{1};
// A controller that starts anew is silent for a moment, shorter than a lost line, and its motors
// stand; nothing it could be asked would tell. The next order of the profile would move them.
constexpr int kMissingOfRestart = 2;
constexpr double kSilenceOfRestart = 0.4; ///< of the profile's staleSeconds

Instant clockNow()
{
    return std::chrono::steady_clock::now();
}

/// The gate sees faults before the run does.
BenchEnd endOf(DisarmReason reason)
{
    switch (reason) {
    case DisarmReason::MotorFault:
    case DisarmReason::OverCurrent:
    case DisarmReason::UartError:
    case DisarmReason::SerialTimeout:
    case DisarmReason::Stalled:
        return BenchEnd::Limit;
    case DisarmReason::LinkLost:
        return BenchEnd::LinkLost;
    default:
        return BenchEnd::Stopped;
    }
}

/// True when the person's motion limits would make other orders of the profile's.
bool shapes(const MotionLimits& limits, const BenchProfile& profile)
{
    bool isLimited = limits.hasRamps();
    for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
        isLimited =
            isLimited || highestSpeed(profile, motor) > limits.maximum.at(std::size_t(motor));
    }
    return isLimited;
}

} // namespace

BenchTest::BenchTest(Controller& controller, const BenchProfile& profile, QObject* parent)
    : Procedure(parent), m_controller(&controller), m_run(profile, controller.model())
{
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(BenchRun::kInterval);
    connect(&m_timer, &QTimer::timeout, this, &BenchTest::onTick);
}

BenchTest::~BenchTest()
{
    if (isRunning() && m_controller) {
        disconnect(m_controller, nullptr, this, nullptr);
        m_controller->stop();
        m_controller->wantNothing(this);
    }
}

void BenchTest::start()
{
    setRunning();
    if (const auto sound = validate(m_run.profile()); !sound) {
        finish(sound);
        return;
    }
    if (shapes(m_controller->shaper().limits(), m_run.profile())) {
        // What was measured would not belong to what was told.
        m_run.end(BenchEnd::Failed,
                  Bench::tr("the motion limits (highest speed, soft start, soft stop) would change "
                            "the orders of this test; choose a slower test or lift them"));
        finish({});
        return;
    }
    if (const auto armed = m_controller->arm(); !armed) {
        finish(armed);
        return;
    }
    connect(m_controller, &Controller::recordsArrived, this, &BenchTest::onRecords);
    connect(m_controller, &Controller::stateChanged, this, &BenchTest::onState);
    connect(m_controller, &Controller::armedChanged, this, [this](bool armed) {
        // A lost link disarms too, and tells so itself.
        if (!armed && m_controller->state() == LinkState::Connected) {
            const Disarming& why = m_controller->gate().lastDisarming();
            m_run.end(endOf(why.reason), disarmText(why.reason));
            QMetaObject::invokeMethod(this, &BenchTest::conclude, Qt::QueuedConnection);
        }
    });
    m_controller->want(this, PollId::Currents, pollRow(PollId::Currents).hertz);
    m_controller->want(this, PollId::Status, kStatusHertz);
    m_controller->want(this, PollId::SerialControl, kControlHertz);
    if (m_run.wantsChannels()) {
        m_controller->want(this, PollId::RawChannels, pollRow(PollId::RawChannels).hertz);
    }
    m_run.start(clockNow(), linkErrors());
    m_timer.start();
}

void BenchTest::cancel()
{
    if (isRunning()) {
        m_run.end(BenchEnd::Stopped, Bench::tr("stopped on request"));
        conclude();
    }
}

quint64 BenchTest::linkErrors() const
{
    const LinkStats& stats = m_controller->stats();
    return stats.timeouts + stats.crcErrors + stats.badReplies;
}

void BenchTest::onRecords(const std::vector<TransactionRecord>& records)
{
    for (const TransactionRecord& record : records) {
        followSilence(record);
        if (record.error || record.isRaw) {
            continue;
        }
        for (const PollRow& row : kPolls) {
            const bool isWhole = record.receivedBytes.size() >= row.values;
            if (record.command == pollCommand(row.id) && isWhole) {
                // A line whose time jumps (a simulated one) must not look fresh for ever.
                const Instant read = std::min(record.ended, clockNow());
                m_run.take(decodePoll(row.id, record.receivedBytes, read));
            }
        }
    }
    m_run.setLinkErrors(linkErrors());
    if (m_run.hasEnded()) {
        conclude();
    }
}

void BenchTest::followSilence(const TransactionRecord& record)
{
    if (record.error != ErrorCode::NoReply) {
        if (!record.receivedBytes.isEmpty()) {
            m_missing = 0;
            m_lastReply = record.ended;
        }
        return;
    }
    const std::chrono::duration<double> silence =
        m_lastReply ? record.ended - *m_lastReply : Duration::zero();
    if (++m_missing >= kMissingOfRestart
        && silence.count() >= kSilenceOfRestart * m_run.profile().staleSeconds()) {
        m_run.end(BenchEnd::Stale,
                  Bench::tr("the controller did not answer %1 times in a row; it may have been "
                            "restarted")
                      .arg(m_missing));
    }
}

void BenchTest::onState(LinkState state)
{
    if (state != LinkState::Connected) {
        m_error = m_controller->lastError().value_or(Error{ErrorCode::NotConnected, {}});
        m_run.end(BenchEnd::LinkLost, Bench::tr("the connection was lost"));
        conclude();
    }
}

void BenchTest::onTick()
{
    if (!m_controller) {
        m_timer.stop();
        return;
    }
    giveOrders(m_run.advance(clockNow()));
    if (m_run.hasEnded()) {
        conclude();
    } else if (++m_ticks % kTicksAShow == 0) {
        emit tick();
    }
}

void BenchTest::giveOrders(const BenchOrders& orders)
{
    Result<void> done;
    if (orders[0] && orders[1] && canShare(*orders[0], *orders[1])) {
        done = m_controller->driveBoth(*orders[0], *orders[1]);
    } else {
        for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2}) {
            if (const auto& order = orders.at(std::size_t(motor)); order && done) {
                done = m_controller->driveMotor(motor, *order);
            }
        }
    }
    if (const auto& aux = orders[2]; aux && done) {
        done = m_controller->driveMotor(MotorId::Aux, *aux);
    }
    if (!done) {
        m_error = done.error();
        m_run.end(BenchEnd::Failed, errorText(done.error()));
    }
}

void BenchTest::conclude()
{
    if (!isRunning() || !m_controller || std::exchange(m_isConcluding, true)) {
        return;
    }
    m_timer.stop();
    disconnect(m_controller, nullptr, this, nullptr);
    m_controller->wantNothing(this);
    const auto done = [this](const Result<Reply>& /*sent*/) {
        finish(m_error ? tl::make_unexpected(*m_error) : Result<void>());
    };
    m_controller->stop(Controller::StopKind::Coast, this, done);
    // A line that is gone may never tell.
    QTimer::singleShot(kLongestStop, this, [done] { done(fail(ErrorCode::NotConnected)); });
    emit tick();
}

} // namespace trex
