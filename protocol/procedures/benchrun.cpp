// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/benchrun.h"

#include "protocol/codec/replies.h"
#include "protocol/storage/benchtext.h"

#include <algorithm>

namespace trex {
namespace {

using namespace Qt::Literals::StringLiterals;

constexpr std::array kFaultBits{statusbit::kMotor1Fault, statusbit::kMotor2Fault};
constexpr std::array kOverCurrentBits{statusbit::kMotor1OverCurrent, statusbit::kMotor2OverCurrent};

double toSeconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

bool waitsForChannel(const std::vector<BenchStep>& steps)
{
    return std::ranges::any_of(steps, [](const BenchStep& step) {
        const bool isChannel = step.condition == BenchCondition::ChannelAbove
            || step.condition == BenchCondition::ChannelBelow;
        return (step.action == BenchAction::Wait && isChannel) || waitsForChannel(step.steps);
    });
}

} // namespace

bool canShare(const MotorOrder& motor1, const MotorOrder& motor2)
{
    using Action = MotorOrder::Action;
    return (motor1.action == Action::Accelerate) == (motor2.action == Action::Accelerate);
}

BenchRun::BenchRun(BenchProfile profile, Model model) : m_profile(std::move(profile))
{
    m_trace.model = model;
}

bool BenchRun::wantsChannels() const
{
    return waitsForChannel(m_profile.steps);
}

void BenchRun::start(Instant now, quint64 linkErrors)
{
    m_asked = now;
    m_now = now;
    m_linkErrors = linkErrors;
    m_linkErrorsBefore = linkErrors;
}

double BenchRun::seconds() const
{
    return m_hasBegun ? toSeconds(m_now - m_begun) : 0.0;
}

void BenchRun::note(int severity, const QString& text)
{
    m_trace.events.push_back({seconds(), severity, text});
}

void BenchRun::end(BenchEnd end, const QString& reason)
{
    if (m_ending) {
        return;
    }
    m_ending = BenchEnding{end, reason};
    m_trace.seconds = seconds();
    m_due = {};
    for (std::size_t i = 0; i < m_commanded.size() && m_hasBegun; ++i) {
        if (m_commanded.at(i).amount != 0) { // the stop that follows
            m_trace.addOrder(seconds(), MotorId(i), {});
        }
    }
    note(end == BenchEnd::Completed ? 0 : 2,
         end == BenchEnd::Completed ? Bench::tr("All steps done.")
                                    : Bench::tr("Ended: %1.").arg(reason));
}

void BenchRun::limit(const QString& found, bool isStep)
{
    if (!found.isEmpty()) {
        end(BenchEnd::Limit,
            isStep ? Bench::tr("limit of a step: %1").arg(found)
                   : Bench::tr("limit: %1").arg(found));
    }
}

// ---- what comes in

void BenchRun::take(const PollSample& sample)
{
    if (m_ending || sample.time < m_asked) {
        return; // what was asked before the person started says nothing about now
    }
    switch (sample.poll) {
    case PollId::Currents:
        takeCurrents(sample);
        break;
    case PollId::Status:
        takeStatus(sample);
        break;
    case PollId::SerialControl:
        m_lastControl = sample.time;
        if (sample.raw.front() != 1) {
            end(BenchEnd::NotInControl,
                Bench::tr("serial does not control the motors (mode jumper, channel 5)"));
        }
        break;
    case PollId::RawChannels:
    case PollId::RemappedChannels:
    case PollId::UartErrors:
    case PollId::Mode:
    case PollId::Learned:
        break;
    }
    if (!m_ending && m_hasBegun) {
        checkCondition(sample);
    }
}

void BenchRun::takeCurrents(const PollSample& sample)
{
    m_lastCurrents = sample.time;
    if (!m_hasBegun || sample.time < m_begun) {
        return;
    }
    const std::array raw{std::uint8_t(sample.raw[0]), std::uint8_t(sample.raw[1])};
    m_trace.samples.push_back({BenchTrace::tickOf(toSeconds(sample.time - m_begun)), raw});
    const double scale = amperesPerCount(m_trace.model);
    const std::array amperes{raw[0] * scale, raw[1] * scale};
    for (Level& level : m_levels) {
        limit(level.watch.currents(sample.time, amperes), level.repeat != nullptr);
    }
    limit(m_leafWatch.currents(sample.time, amperes), true);
}

void BenchRun::takeStatus(const PollSample& sample)
{
    m_lastStatus = sample.time;
    if (++m_statusReads == 1) {
        return; // it may have been latched long ago; reading has cleared it
    }
    const auto bits = std::uint8_t(sample.raw.front());
    for (std::size_t i = 0; i < kFaultBits.size(); ++i) {
        if ((bits & kFaultBits[i]) != 0) {
            end(BenchEnd::Limit, Bench::tr("motor driver %1 reports a fault").arg(i + 1));
        }
        if ((bits & kOverCurrentBits[i]) == 0) {
            continue;
        }
        const bool isWanted = !m_leafWatch.overCurrentStops()
            || std::ranges::any_of(m_levels,
                                   [](const Level& l) { return !l.watch.overCurrentStops(); });
        if (!isWanted) {
            end(BenchEnd::Limit,
                Bench::tr("the controller reports motor %1 over its current limit").arg(i + 1));
        } else {
            note(1, Bench::tr("Motor %1 over the controller's current limit.").arg(i + 1));
        }
    }
}

void BenchRun::checkCondition(const PollSample& sample)
{
    const BenchStep* step = leaf();
    if (step == nullptr || step->action != BenchAction::Wait || sample.time < m_leafStart) {
        return;
    }
    const double scale = amperesPerCount(m_trace.model);
    const auto currents = [&](auto test) {
        return sample.poll == PollId::Currents
            && (!drives(step->motor, MotorId::Motor1) || test(sample.raw[0] * scale))
            && (!drives(step->motor, MotorId::Motor2) || test(sample.raw[1] * scale));
    };
    const auto channel = [&](auto test) {
        const std::uint16_t raw = sample.raw.at(std::size_t(std::max(step->number - 1, 0)));
        return sample.poll == PollId::RawChannels && raw != kInvalidPulse && test(double(raw));
    };
    const auto above = [&](double value) { return value > step->threshold; };
    const auto below = [&](double value) { return value < step->threshold; };
    switch (step->condition) {
    case BenchCondition::CurrentAbove:
        m_isMet = m_isMet || currents(above);
        break;
    case BenchCondition::CurrentBelow:
        m_isMet = m_isMet || currents(below);
        break;
    case BenchCondition::Status:
        m_isMet = m_isMet
            || (sample.poll == PollId::Status && (sample.raw.front() >> step->number & 1) != 0);
        break;
    case BenchCondition::ChannelAbove:
        m_isMet = m_isMet || channel(above);
        break;
    case BenchCondition::ChannelBelow:
        m_isMet = m_isMet || channel(below);
        break;
    case BenchCondition::Time:
        break;
    }
}

void BenchRun::setLinkErrors(quint64 linkErrors)
{
    m_linkErrors = linkErrors;
    m_trace.linkErrors = linkErrors - m_linkErrorsBefore;
    for (const Level& level : m_levels) {
        limit(level.watch.errors(linkErrors), level.repeat != nullptr);
    }
    if (m_hasBegun) {
        limit(m_leafWatch.errors(linkErrors), true);
    }
}

} // namespace trex
