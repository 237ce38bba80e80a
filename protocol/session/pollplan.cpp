// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/pollplan.h"

#include "protocol/codec/packet.h"
#include "protocol/codec/replyparser.h"

namespace trex {

namespace {

constexpr std::size_t indexOf(PollId id)
{
    return static_cast<std::size_t>(id);
}

// Above this load the plan is scaled down. The cost of each poll is measured, overhead included; a
// plan that asks for more than that lets the fastest stream alone fall behind.
constexpr double kFullLoad = 1.0;

} // namespace

void PollPlan::setLine(const LineSettings& settings)
{
    m_line = settings;
    for (const PollRow& row : kPolls) {
        const Command command = pollCommand(row.id);
        const int crc = settings.hasCrc() ? 1 : 0;
        const auto bytes =
            static_cast<int>(encode(command, settings).size()) + replyLength(command) + crc;
        m_wire.at(indexOf(row.id)) = settings.timeOf(bytes);
    }
    rescale();
}

void PollPlan::setWishes(const PollWishes& wishes, Instant now)
{
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        if (m_wishes.at(i) <= 0.0 && wishes.at(i) > 0.0) {
            m_due.at(i) = now;
        }
    }
    m_wishes = wishes;
    rescale();
}

void PollPlan::setOverhead(Duration overhead)
{
    m_overhead = overhead;
    rescale();
}

void PollPlan::restart(Instant now)
{
    m_due.fill(now);
}

Duration PollPlan::cost(PollId id) const
{
    return m_wire.at(indexOf(id)) + m_overhead;
}

void PollPlan::rescale()
{
    double load = 0.0;
    for (const PollRow& row : kPolls) {
        load += m_wishes.at(indexOf(row.id)) * std::chrono::duration<double>(cost(row.id)).count();
    }
    m_scale = load > kFullLoad ? kFullLoad / load : 1.0;
}

Duration PollPlan::period(std::size_t index) const
{
    const double hertz = m_wishes.at(index) * m_scale;
    return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1.0 / hertz));
}

std::optional<PollId> PollPlan::due(Instant now) const
{
    // By how many of its own periods a stream is late: where the line is full, all miss the same
    // share, instead of the fastest alone.
    std::optional<PollId> first;
    double latest = -1.0;
    for (const PollRow& row : kPolls) {
        const std::size_t i = indexOf(row.id);
        if (m_wishes.at(i) <= 0.0 || m_due.at(i) > now) {
            continue;
        }
        const double late =
            std::chrono::duration<double>(now - m_due.at(i)).count() * m_wishes.at(i);
        if (late > latest) {
            latest = late;
            first = row.id;
        }
    }
    return first;
}

std::optional<Instant> PollPlan::nextDue() const
{
    std::optional<Instant> earliest;
    for (std::size_t i = 0; i < m_due.size(); ++i) {
        if (m_wishes.at(i) > 0.0 && (!earliest || m_due.at(i) < *earliest)) {
            earliest = m_due.at(i);
        }
    }
    return earliest;
}

void PollPlan::sent(PollId id, Instant now)
{
    const std::size_t i = indexOf(id);
    if (m_wishes.at(i) <= 0.0) {
        return;
    }
    // On time: keep the rhythm. More than a period late: what was missed stays missed, so that one
    // stream that fell behind does not crowd out the others.
    const Duration step = period(i);
    m_due.at(i) = std::max(m_due.at(i) + step, now - step);
}

} // namespace trex
