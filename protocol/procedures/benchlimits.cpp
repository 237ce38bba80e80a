// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/benchlimits.h"

#include "protocol/storage/benchtext.h"

namespace trex {
namespace {

double secondsBetween(Instant from, Instant to)
{
    return std::chrono::duration<double>(to - from).count();
}

/// Where readings were missing, what was drawn meanwhile is counted at most so long.
constexpr double kLongestStep = 5.0;

} // namespace

BenchLimitWatch::BenchLimitWatch(const BenchLimits& limits, Instant start, quint64 linkErrors)
    : m_limits(limits), m_start(start), m_linkErrors(linkErrors)
{
}

QString BenchLimitWatch::currents(Instant time, const std::array<double, 2>& amperes)
{
    const double step = m_last ? std::min(secondsBetween(*m_last, time), kLongestStep) : 0.0;
    QString found;
    for (std::size_t i = 0; i < amperes.size(); ++i) {
        // The larger of two readings counts for the time between them.
        m_charge[i] += std::max(amperes[i], m_before[i]) * step;
        if (m_limits.ampereSeconds && m_charge[i] > *m_limits.ampereSeconds) {
            found = Bench::tr("motor %1: current × time exceeded %2 A s")
                        .arg(i + 1)
                        .arg(*m_limits.ampereSeconds);
        }
        if (!m_limits.amperes || amperes[i] <= *m_limits.amperes) {
            m_above[i].reset();
            continue;
        }
        m_above[i] = m_above[i].value_or(time);
        if (secondsBetween(*m_above[i], time) >= m_limits.forSeconds) {
            found = Bench::tr("motor %1 drew %2 A, more than %3 A for %4 s")
                        .arg(i + 1)
                        .arg(amperes[i], 0, 'f', 2)
                        .arg(*m_limits.amperes)
                        .arg(m_limits.forSeconds);
        }
    }
    m_last = time;
    m_before = amperes;
    return found;
}

QString BenchLimitWatch::time(Instant now) const
{
    return m_limits.seconds && secondsBetween(m_start, now) > *m_limits.seconds
        ? Bench::tr("it took longer than %1 s").arg(*m_limits.seconds)
        : QString();
}

QString BenchLimitWatch::errors(quint64 linkErrors) const
{
    return m_limits.linkErrors && linkErrors - m_linkErrors > quint64(*m_limits.linkErrors)
        ? Bench::tr("more than %1 replies were lost or damaged on the line")
              .arg(*m_limits.linkErrors)
        : QString();
}

} // namespace trex
