// SPDX-License-Identifier: GPL-3.0-or-later
// Choosing and sending. What is received: linkreception.cpp; what fails: linkfailure.cpp.
#include "protocol/session/linkengine.h"

#include "protocol/codec/packet.h"

#include <algorithm>

namespace trex {

namespace {

using namespace std::chrono_literals;

// Late replies prolong the wait for the synchronising one, endless noise does not.
constexpr auto kSynchroniseExtra = 500ms;
constexpr qsizetype kMostRecorded = 1024; // of what a line gone mad brings instead of a reply

std::size_t motorSlot(const Command& command)
{
    const std::string_view key = command.row().key;
    if (key == "set-motor1" || key == "accelerate-motor1") {
        return 0;
    }
    if (key == "set-motor2" || key == "accelerate-motor2") {
        return 1;
    }
    return key == "set-motors" || key == "accelerate-motors" ? 2 : 3;
}

bool movesMotor(const Transaction& transaction)
{
    if (!transaction.rawBytes.isEmpty()) {
        return true; // given by hand: assume that it may
    }
    if (transaction.command.row().kind != CommandKind::Motor) {
        return false;
    }
    return std::any_of(transaction.command.data.begin(), transaction.command.data.end(),
                       [](char speed) { return speed != 0; });
}

} // namespace

std::vector<Command> stopCommands(bool brake)
{
    const MotorOrder order = brake ? MotorOrder{MotorOrder::Action::Brake, kFullSpeed}
                                   : MotorOrder{MotorOrder::Action::Set, 0};
    return {*driveBoth(order, order), *driveMotor(MotorId::Aux, {MotorOrder::Action::Set, 0})};
}

QLatin1StringView keyOf(LinkState state)
{
    static constexpr std::array<QLatin1StringView, 5> kKeys{
        QLatin1StringView("disconnected"), QLatin1StringView("connecting"),
        QLatin1StringView("connected"), QLatin1StringView("lost"), QLatin1StringView("retrying")};
    return kKeys.at(static_cast<std::size_t>(state));
}

LinkEngine::LinkEngine(const LineSettings& settings, bool identify, bool reconnect, bool canSetLine,
                       bool stopsInDoubt)
    : m_settings(settings)
    , m_identify(identify)
    , m_reconnect(reconnect)
    , m_canSetLine(canSetLine)
    , m_stopsInDoubt(stopsInDoubt)
{
    m_plan.setLine(settings);
}

void LinkEngine::opened(Instant now, const AdapterFacts& adapter)
{
    m_open = true;
    m_echo = m_settings.echo == EchoMode::Auto ? Echo::Unknown
        : m_settings.echo == EchoMode::On      ? Echo::Yes
                                               : Echo::No;
    m_pendingEcho.clear();
    m_undecided.clear();
    m_lineFreeAt = now;
    m_quietUntil = now;
    m_guard = {};
    m_guard.nextIdentify = now;
    m_again.at.reset();
    m_needsSync = false;
    m_lastValid = now;
    m_failures = 0;
    m_rates.start = now;
    m_rates.health.opened(now, adapter);
    if (!m_identify) {
        setState(LinkState::Connected, std::nullopt, now);
        m_plan.restart(now);
    } else if (!m_wasConnected && m_state != LinkState::Retrying) {
        setState(LinkState::Connecting, std::nullopt, now);
    } else {
        setState(LinkState::Retrying, std::nullopt, now);
    }
    queueStopForLoss();
}

void LinkEngine::lineFailed(const Error& error, Instant now)
{
    m_open = false;
    m_rates.health.closed(now);
    m_guard = {};
    m_again.at.reset();
    if (m_flight) {
        const Flight flight = std::move(*m_flight);
        m_flight.reset();
        record(flight, now, error.code);
        finish(flight.queued, tl::make_unexpected(error));
    }
    if (m_state == LinkState::Connected) {
        loseLink(error, now);
    }
    setState(m_reconnect ? (m_wasConnected ? LinkState::Lost : LinkState::Retrying)
                         : LinkState::Disconnected,
             error, now);
    for (const Queued& queued : std::exchange(m_stops, {})) {
        finish(queued, tl::make_unexpected(error));
    }
}

void LinkEngine::submit(const Transaction& transaction)
{
    if (m_shutDown || !m_open || m_state != LinkState::Connected) {
        finish(Queued{transaction}, fail(ErrorCode::NotConnected));
        return;
    }
    if (transaction.priority == Priority::Stop) {
        m_stops.push_back({transaction});
    } else if (transaction.priority == Priority::Motor) {
        m_again.at.reset(); // somebody has ordered anew
        const std::size_t slot = motorSlot(transaction.command);
        // Latest wins: an order for both motors also replaces what waits for each of them.
        for (const std::size_t other :
             {slot, slot == 2 ? std::size_t{0} : slot, slot == 2 ? std::size_t{1} : slot}) {
            if (m_motors.at(other)) {
                finish(Queued{*m_motors.at(other)}, fail(ErrorCode::Cancelled));
                m_motors.at(other).reset();
                std::erase(m_motorOrder, other);
            }
        }
        m_motors.at(slot) = transaction;
        m_motorOrder.push_back(slot);
    } else {
        m_users.push_back({transaction});
    }
}

void LinkEngine::setWishes(const PollWishes& wishes, Instant now)
{
    m_plan.setWishes(wishes, now);
}

void LinkEngine::shutDown()
{
    m_shutDown = true;
    if (m_retry) {
        finish(*m_retry, fail(ErrorCode::Cancelled));
        m_retry.reset();
    }
    for (const Queued& queued : std::exchange(m_users, {})) {
        finish(queued, fail(ErrorCode::Cancelled));
    }
    if (m_state != LinkState::Connected) {
        m_flight.reset(); // a question: nobody waits for its answer
        m_guard.clear(m_settings, m_canSetLine);
    }
}

LinkEngine::Action LinkEngine::next(Instant now)
{
    Action action = decide(now);
    if (action.kind != Action::Kind::Send && m_again.at && !m_flight) {
        const bool isIdle = action.kind == Action::Kind::Idle;
        action = {
            Action::Kind::Wait, isIdle ? *m_again.at : std::min(action.until, *m_again.at), {}};
    }
    return action;
}

LinkEngine::Action LinkEngine::decide(Instant now)
{
    m_rates.into(m_batch.stats, now);
    if (const auto wait = waitForFlight(now)) {
        return *wait;
    }
    stopOnceMore(now);
    if (m_open && !m_stops.empty()) {
        m_guard.drop();
        if (m_guard.line && now < m_guard.deafUntil) {
            return {Action::Kind::Wait, m_guard.deafUntil, {}}; // until the line is ours again
        }
        // A stop does not wait for the line to fall quiet: its bytes follow those on their way.
        const Queued queued = std::move(m_stops.front());
        m_stops.pop_front();
        if (m_state == LinkState::Disconnected && m_stops.empty()) { // given up meanwhile
            m_open = false;
            m_again.at.reset();
            m_guard.clear(m_settings, m_canSetLine);
        }
        return send(queued, now);
    }
    if (m_guard.isBusy()) {
        return sendPiece(now);
    }
    if (!m_open) {
        return {};
    }
    const Instant free = std::max(m_lineFreeAt, m_shutDown ? m_lineFreeAt : m_quietUntil);
    if (now < free) {
        return {Action::Kind::Wait, free, {}};
    }
    if (m_shutDown) {
        return {};
    }
    if (const auto queued = choose(now)) {
        return send(*queued, now);
    }
    if (m_guard.isBusy()) {
        return sendPiece(now);
    }
    const auto wake = nextWake();
    return wake ? Action{Action::Kind::Wait, std::max(*wake, now), {}} : Action{};
}

std::optional<LinkEngine::Queued> LinkEngine::choose(Instant now)
{
    if (m_state != LinkState::Connected) {
        return chooseIdentify(now);
    }
    if (!m_motorOrder.empty()) {
        const std::size_t slot = m_motorOrder.front();
        m_motorOrder.pop_front();
        Queued queued{*m_motors.at(slot)};
        m_motors.at(slot).reset();
        return queued;
    }
    const auto poll = m_plan.due(now);
    if (m_needsSync && (m_retry || !m_users.empty() || poll)) {
        return Queued{{.command = query("get-mode"), .priority = Priority::User},
                      1,
                      std::nullopt,
                      Role::Synchronise};
    }
    if (m_retry && (m_retry->transaction.priority == Priority::User || m_users.empty())) {
        ++m_batch.stats.retries;
        ++m_rates.health.at(now).retries;
        return std::exchange(m_retry, std::nullopt);
    }
    if (!m_users.empty()) {
        Queued queued = std::move(m_users.front());
        m_users.pop_front();
        return queued;
    }
    if (poll) {
        m_plan.sent(*poll, now);
        return Queued{{.command = pollCommand(*poll), .priority = Priority::Poll}, 1, poll};
    }
    return std::nullopt;
}

std::optional<Instant> LinkEngine::nextWake() const
{
    if (m_state == LinkState::Disconnected) {
        return std::nullopt;
    }
    return m_state == LinkState::Connected ? m_plan.nextDue() : std::optional(m_guard.nextIdentify);
}

LinkEngine::Action LinkEngine::send(const Queued& queued, Instant now)
{
    const Transaction& transaction = queued.transaction;
    const bool isRaw = !transaction.rawBytes.isEmpty();
    Flight flight;
    flight.queued = queued;
    flight.sentBytes = isRaw ? transaction.rawBytes : encode(transaction.command, m_settings);
    if (queued.role == Role::Probe) {
        flight.sentBytes = probeBytes(now);
    }
    flight.sent = now;
    flight.heldBefore = m_undecided.size();
    const int crc = m_settings.hasCrc() ? 1 : 0;
    int replyBytes = 0;
    Duration wait = m_settings.timeout + m_slack;
    Duration usual = isRaw ? wait : usualOverhead();
    if (isRaw) {
        replyBytes = transaction.rawReplyBytes > 0 ? transaction.rawReplyBytes + crc : 0;
    } else {
        flight.parser = ReplyParser(transaction.command, m_settings);
        replyBytes = flight.parser.expectedBytes();
        const CommandRow& row = transaction.command.row();
        wait = std::max<Duration>(m_settings.timeout + m_slack + row.processing, row.giveUp);
        usual = std::max<Duration>(usual, row.giveUp);
    }
    const auto sentCount = static_cast<int>(flight.sentBytes.size());
    ++m_batch.stats.transactions;
    ++m_rates.transactions;
    m_batch.stats.bytesSent += static_cast<quint64>(flight.sentBytes.size());
    m_rates.health.at(now).addSent(m_settings.timeOf(sentCount), sentCount);
    if (m_echo != Echo::No) {
        m_pendingEcho += flight.sentBytes;
        if (m_pendingEcho.size() > 512) { // orders without reply on a line not known to echo
            m_pendingEcho = m_pendingEcho.last(256);
        }
    }
    m_lineFreeAt = std::max(m_lineFreeAt, now) + m_settings.timeOf(sentCount);
    if (transaction.priority == Priority::Stop && m_stops.empty()) {
        doubtStop();
    }
    noteMotion(transaction);
    Action action{Action::Kind::Send, now, flight.sentBytes, {}};
    if (std::exchange(m_guard.line, std::nullopt)) {
        action.line = m_settings;
    }
    if (replyBytes == 0) {
        record(flight, now, std::nullopt);
        finish(flight.queued, Reply{transaction.command, {}, flight.sentBytes, now, now});
        return action;
    }
    flight.expected = m_lineFreeAt + m_settings.timeOf(replyBytes) + usual;
    flight.deadline = m_lineFreeAt + m_settings.timeOf(replyBytes) + wait;
    flight.limit = flight.deadline;
    if (queued.role == Role::Synchronise) {
        flight.limit += kSynchroniseExtra;
    }
    flight.lastByte = flight.deadline;
    m_noisySince.reset();
    m_flight = std::move(flight);
    return action;
}

void LinkEngine::noteMotion(const Transaction& transaction)
{
    if (transaction.priority == Priority::Stop) {
        // Only a line known to work takes the motion back: on a dead one nobody has heard it.
        const bool heard = m_stops.empty() && !m_again.at && m_state == LinkState::Connected;
        m_motionSent = m_motionSent && !heard;
    } else if (movesMotor(transaction)) {
        m_motionSent = true;
    }
}

void LinkEngine::record(const Flight& flight, Instant ended, std::optional<ErrorCode> error)
{
    const Transaction& transaction = flight.queued.transaction;
    m_batch.records.push_back({transaction.command, transaction.priority, flight.sentBytes,
                               flight.received.left(kMostRecorded), flight.sent, ended,
                               flight.queued.attempt, error, !transaction.rawBytes.isEmpty()});
}

void LinkEngine::finish(const Queued& queued, const Result<Reply>& result)
{
    if (queued.transaction.id != 0) {
        m_batch.outcomes.push_back({queued.transaction.id, result});
    }
}

bool LinkEngine::hasNews() const
{
    return !m_batch.outcomes.empty() || !m_batch.events.empty();
}

LinkBatch LinkEngine::takeBatch(Instant now)
{
    m_rates.into(m_batch.stats, now);
    m_batch.stats.echo = m_echo == Echo::Yes;
    m_batch.stats.askedHertz = m_plan.wishes();
    m_batch.stats.pollScale = m_plan.scale();
    if (auto health = m_rates.health.take(now)) {
        health->patience = m_slack;
        m_batch.health.push_back(std::move(*health));
    }
    LinkBatch batch = std::move(m_batch);
    m_batch = {};
    m_batch.stats = batch.stats;
    return batch;
}

} // namespace trex
