// SPDX-License-Identifier: GPL-3.0-or-later
// BenchRun's giving half: which step is due, and what it tells the motors.
#include "protocol/procedures/benchrun.h"
#include "protocol/storage/benchtext.h"

#include <cmath>
#include <numbers>

namespace trex {
namespace {

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

constexpr auto kSteerInterval = 20ms; // a set command takes 2 to 4 ms at 19200 baud
constexpr double kGrace = 5.0; // s, beyond what the steps take by themselves
constexpr auto kControlAge = 2s; // asked five times a second
constexpr std::array kMotors{MotorId::Motor1, MotorId::Motor2, MotorId::Aux};

Duration fromSeconds(double seconds)
{
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

double toSeconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

bool hasTime(BenchAction action)
{
    return action != BenchAction::Set && action != BenchAction::Accelerate
        && action != BenchAction::Brake;
}

} // namespace

BenchOrders BenchRun::advance(Instant now)
{
    const Instant before = std::exchange(m_now, now);
    const auto stale = fromSeconds(m_profile.staleSeconds());
    if (m_ending) {
        return {};
    }
    if (m_hasBegun && now - before > stale) {
        end(BenchEnd::Stale,
            Bench::tr("the computer was busy for %1 s").arg(toSeconds(now - before), 0, 'f', 1));
    }
    checkAges(now);
    if (m_ending || !m_hasBegun) {
        return {};
    }
    for (const Level& level : m_levels) {
        limit(level.watch.time(now), level.repeat != nullptr);
    }
    limit(m_leafWatch.time(now), true);
    while (!m_ending) {
        const auto ended = leafEnd(now);
        if (!ended) {
            break;
        }
        leave(*ended);
    }
    if (!m_ending) {
        steer(now);
    }
    for (const MotorId motor : kMotors) {
        if (const auto& order = m_due.at(std::size_t(motor))) {
            m_trace.addOrder(seconds(), motor, *order);
        }
    }
    return std::exchange(m_due, {});
}

void BenchRun::checkAges(Instant now)
{
    const auto stale = fromSeconds(m_profile.staleSeconds());
    const auto isFresh = [now](const std::optional<Instant>& last, Duration age) {
        return last && now - *last <= age;
    };
    const bool isReady = isFresh(m_lastCurrents, stale) && isFresh(m_lastStatus, stale)
        && isFresh(m_lastControl, kControlAge) && m_statusReads > 1;
    if (!m_hasBegun) {
        if (isReady) {
            begin(now);
        } else if (now - m_asked > kLongestWait) {
            end(BenchEnd::Stale, Bench::tr("no fresh readings came; no motor was moved"));
        }
        return;
    }
    if (!isReady && !m_ending) {
        end(BenchEnd::Stale, Bench::tr("no fresh readings for %1 s").arg(m_profile.staleSeconds()));
    }
}

void BenchRun::begin(Instant now)
{
    m_hasBegun = true;
    m_begun = now;
    note(0, Bench::tr("Started."));
    for (const MotorId motor : kMotors) {
        if (highestSpeed(m_profile, motor) > 0) { // whatever it was told by others before
            m_due.at(std::size_t(motor)) = MotorOrder{};
        }
    }
    BenchLimits limits = m_profile.limits;
    limits.seconds = limits.seconds.value_or(plannedSeconds(m_profile) + kGrace);
    m_levels.push_back({.steps = &m_profile.steps, .watch = {limits, now, m_linkErrors}});
    enter(now);
}

const BenchStep* BenchRun::leaf() const
{
    if (m_levels.empty() || m_levels.back().index >= m_levels.back().steps->size()) {
        return nullptr;
    }
    return &(*m_levels.back().steps)[m_levels.back().index];
}

void BenchRun::enter(Instant at)
{
    const BenchStep* step = leaf();
    while (step != nullptr && step->action == BenchAction::Repeat) {
        m_levels.push_back(
            {&step->steps, step, 0, 0, BenchLimitWatch(step->limits, at, m_linkErrors)});
        step = leaf();
    }
    if (step == nullptr) {
        end(BenchEnd::Completed, {});
        return;
    }
    m_leafStart = at;
    m_isMet = false;
    m_before = m_commanded;
    m_leafWatch = BenchLimitWatch(step->limits, at, m_linkErrors);
    m_steered = {};
    if (!step->label.isEmpty()) {
        note(0, step->label);
    }
    using Action = MotorOrder::Action;
    switch (step->action) {
    case BenchAction::Set:
    case BenchAction::Step:
        order(step->motor, Action::Set, step->speed);
        break;
    case BenchAction::Accelerate:
        order(step->motor, Action::Accelerate, step->speed);
        break;
    case BenchAction::Brake:
        order(step->motor, Action::Brake, step->speed);
        break;
    case BenchAction::Ramp:
    case BenchAction::Sine:
    case BenchAction::Hold:
    case BenchAction::Wait:
    case BenchAction::Repeat:
        break;
    }
}

void BenchRun::leave(Instant at)
{
    const BenchStep* step = leaf();
    if (step->action == BenchAction::Step || step->action == BenchAction::Ramp) {
        for (const MotorId motor : kMotors) {
            if (drives(step->motor, motor)) {
                orderOne(motor,
                         step->action == BenchAction::Step
                             ? m_before.at(std::size_t(motor))
                             : MotorOrder{MotorOrder::Action::Set, step->speed});
            }
        }
    }
    ++m_levels.back().index;
    while (m_levels.size() > 1 && m_levels.back().index >= m_levels.back().steps->size()) {
        Level& level = m_levels.back();
        if (++level.round < level.repeat->times) {
            level.index = 0;
            break;
        }
        m_levels.pop_back();
        ++m_levels.back().index;
    }
    enter(at);
}

std::optional<Instant> BenchRun::leafEnd(Instant now)
{
    const BenchStep* step = leaf();
    if (step == nullptr) {
        return std::nullopt;
    }
    if (!hasTime(step->action)) {
        return m_leafStart;
    }
    const Instant due = m_leafStart + fromSeconds(step->seconds);
    if (step->action != BenchAction::Wait) {
        return now >= due ? std::optional(due) : std::nullopt;
    }
    const bool isTime =
        step->condition == BenchCondition::Time && now >= m_begun + fromSeconds(step->threshold);
    if (m_isMet || isTime) {
        return now;
    }
    if (now < due) {
        return std::nullopt;
    }
    if (step->mustHappen) {
        end(BenchEnd::NotMet,
            Bench::tr("what step %1 waited for did not come in %2 s")
                .arg(position())
                .arg(step->seconds));
        return std::nullopt;
    }
    return now;
}

void BenchRun::steer(Instant now)
{
    const BenchStep* step = leaf();
    if (step == nullptr || now - m_steered < kSteerInterval
        || (step->action != BenchAction::Ramp && step->action != BenchAction::Sine)) {
        return;
    }
    m_steered = now;
    const double elapsed = toSeconds(now - m_leafStart);
    for (const MotorId motor : kMotors) {
        if (!drives(step->motor, motor)) {
            continue;
        }
        double speed = step->speed;
        if (step->action == BenchAction::Ramp) {
            const MotorOrder& before = m_before.at(std::size_t(motor));
            const int from =
                step->from.value_or(before.action == MotorOrder::Action::Brake ? 0 : before.amount);
            speed = from + (step->speed - from) * std::min(elapsed / step->seconds, 1.0);
        } else {
            speed += step->amplitude * std::sin(2.0 * std::numbers::pi * elapsed / step->period);
        }
        orderOne(motor, {MotorOrder::Action::Set, int(std::lround(speed))});
    }
}

void BenchRun::order(BenchMotor motor, MotorOrder::Action action, int amount)
{
    for (const MotorId each : kMotors) {
        if (drives(motor, each)) {
            orderOne(each, {action, amount});
        }
    }
}

void BenchRun::orderOne(MotorId motor, const MotorOrder& wanted)
{
    MotorOrder& commanded = m_commanded.at(std::size_t(motor));
    if (commanded == wanted) {
        return;
    }
    commanded = wanted;
    m_due.at(std::size_t(motor)) = wanted;
}

QString BenchRun::position() const
{
    QString numbers;
    QString rounds;
    for (const Level& level : m_levels) {
        if (level.repeat != nullptr) {
            rounds = Bench::tr(", round %1 of %2").arg(level.round + 1).arg(level.repeat->times);
        }
        numbers += (numbers.isEmpty() ? QString() : u"."_s) + QString::number(level.index + 1);
    }
    const BenchStep* step = leaf();
    const QString label =
        step != nullptr && !step->label.isEmpty() ? u" (%1)"_s.arg(step->label) : QString();
    return numbers + label + rounds;
}

} // namespace trex
