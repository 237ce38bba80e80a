// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/benchdryrun.h"

#include "protocol/errortext.h"
#include "protocol/session/linkengine.h"
#include "protocol/sim/simulatedline.h"
#include "protocol/storage/benchtext.h"

namespace trex {
namespace {

using namespace std::chrono_literals;

constexpr double kStatusHertz = 20.0; // as BenchTest asks
constexpr double kControlHertz = 5.0;
constexpr auto kAfterStop = 200ms;
constexpr auto kShortest = 1us;
constexpr Instant kStart{1h};

sim::SimOptions simOptions(const BenchDryRunOptions& options)
{
    sim::SimOptions result;
    result.model = options.model;
    result.pace = true;
    for (const auto& [number, raw] : options.parameters) {
        const ParameterRow* row = findParameter(number);
        // The line's own settings and the number stay those that we talk with.
        const bool isLine = number == parameterRow("device-number").number
            || number == parameterRow("crc7-polynomial").number
            || number == parameterRow("uart-settings").number;
        if (row != nullptr && !row->isTrigger && !isLine) {
            result.parameters[number] = raw;
        }
    }
    return result;
}

} // namespace

BenchDryRun::BenchDryRun(const BenchProfile& profile, const BenchDryRunOptions& options)
    : m_now(kStart)
    , m_line(std::make_unique<sim::SimulatedLine>(simOptions(options), kStart))
    , m_engine(std::make_unique<LinkEngine>(LineSettings(), true, false))
    , m_run(profile, options.model)
    , m_nextCall(kStart)
{
    m_line->setHostLine(sim::HostLine{});
    for (int motor = 1; motor <= 2; ++motor) {
        m_line->setLoad(motor, options.load.at(std::size_t(motor - 1)));
        m_line->setStall(motor, options.isHeld.at(std::size_t(motor - 1)));
    }
    PollWishes wishes{};
    wishes.at(std::size_t(PollId::Currents)) = pollRow(PollId::Currents).hertz;
    wishes.at(std::size_t(PollId::Status)) = kStatusHertz;
    wishes.at(std::size_t(PollId::SerialControl)) = kControlHertz;
    if (m_run.wantsChannels()) {
        wishes.at(std::size_t(PollId::RawChannels)) = pollRow(PollId::RawChannels).hertz;
    }
    m_engine->opened(m_now);
    m_engine->setWishes(wishes, m_now);
}

BenchDryRun::~BenchDryRun() = default;

void BenchDryRun::cancel()
{
    m_run.end(BenchEnd::Stopped, Bench::tr("stopped on request"));
}

bool BenchDryRun::advance(Duration simulated)
{
    const Instant end = m_now + simulated;
    while (m_now < end && !(m_stopAt && m_now >= *m_stopAt)) {
        step(end);
    }
    return !(m_stopAt && m_now >= *m_stopAt);
}

/// As LinkWorker does it, but that time jumps to whatever comes next.
void BenchDryRun::step(Instant end)
{
    const QByteArray bytes = m_line->read(m_now);
    if (!bytes.isEmpty()) {
        m_engine->received(bytes, m_now);
    }
    takeBatch();
    if (m_isStarted && m_now >= m_nextCall && !m_stopAt) {
        m_nextCall = m_now + BenchRun::kInterval;
        giveOrders(m_run.advance(m_now));
    }
    if (m_run.hasEnded() && !m_stopAt) {
        std::vector<Transaction> packets;
        for (const Command& command : stopCommands(false)) {
            packets.push_back({.command = command, .priority = Priority::Stop});
        }
        m_engine->stop(packets, m_now);
        m_stopAt = m_now + kAfterStop;
    }
    const LinkEngine::Action action = m_engine->next(m_now);
    if (action.kind == LinkEngine::Action::Kind::Send) {
        m_line->write(action.bytes, m_now);
        return;
    }
    Instant next = std::min(end, m_now + BenchRun::kInterval);
    if (m_isStarted && !m_stopAt) {
        next = std::min(next, m_nextCall);
    }
    if (action.kind == LinkEngine::Action::Kind::Wait) {
        next = std::min(next, action.until);
    }
    if (const auto byte = m_line->nextByteAt()) {
        next = std::min(next, *byte);
    }
    m_now = std::max(next, m_now + kShortest);
}

void BenchDryRun::takeBatch()
{
    if (!m_engine->hasNews() && !m_isStarted) {
        return;
    }
    const LinkBatch batch = m_engine->takeBatch(m_now);
    if (!m_isStarted && m_engine->state() == LinkState::Connected) {
        m_isStarted = true;
        m_nextCall = m_now;
        m_run.start(m_now, 0);
    }
    for (const PollSample& sample : batch.samples) {
        m_run.take(sample);
    }
}

void BenchDryRun::giveOrders(const BenchOrders& orders)
{
    if (orders[0] && orders[1] && canShare(*orders[0], *orders[1])) {
        submit(trex::driveBoth(*orders[0], *orders[1]));
    } else {
        for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2}) {
            if (const auto& order = orders.at(std::size_t(motor))) {
                submit(trex::driveMotor(motor, *order));
            }
        }
    }
    if (orders[2]) {
        submit(trex::driveMotor(MotorId::Aux, *orders[2]));
    }
}

void BenchDryRun::submit(const Result<Command>& command)
{
    if (!command) {
        m_run.end(BenchEnd::Failed, errorText(command.error()));
        return;
    }
    m_engine->submit({.command = *command, .priority = Priority::Motor});
}

} // namespace trex
