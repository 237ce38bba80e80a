// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/plotticks.h"

#include <array>
#include <cmath>

namespace trex::ticks {

using namespace std::chrono_literals;

namespace {

constexpr std::array kTimeSteps{1.0,    2.0,    5.0,    10.0,    15.0,   30.0,
                                60.0,   120.0,  300.0,  600.0,   900.0,  1800.,
                                3600.0, 7200.0, 14400., 21600.0, 43200., 86400.0};
constexpr int kMostYSteps = 5;
constexpr double kHeadroom = 1.08;
constexpr double kFarTooLarge = 0.6; ///< of the top: a range this much smaller would do
constexpr auto kPatience = 2s;

} // namespace

double niceStep(double span, int most)
{
    const double least = span / std::max(most, 1);
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-9)) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

double timeStep(double spanSeconds, int most)
{
    const double least = spanSeconds / std::max(most, 1);
    if (least <= 0.5) {
        return niceStep(spanSeconds, most);
    }
    for (const double step : kTimeSteps) {
        if (step >= least) {
            return step;
        }
    }
    return kTimeSteps.back() * std::ceil(least / kTimeSteps.back());
}

int decimalsFor(double step)
{
    int decimals = 0;
    for (double rest = step; decimals < 4 && std::abs(rest - std::round(rest)) > 1e-6;
         rest *= 10.0) {
        ++decimals;
    }
    return decimals;
}

QString timeLabel(double seconds, double step)
{
    const int decimals = decimalsFor(step);
    const double scale = std::pow(10.0, decimals);
    const auto units = static_cast<qint64>(std::llround(std::abs(seconds) * scale));
    const auto whole = static_cast<qint64>(static_cast<double>(units) / scale);
    const qint64 part = units - static_cast<qint64>(static_cast<double>(whole) * scale);
    const QString sign = seconds < 0 && units > 0 ? QStringLiteral("−") : QString();
    const qint64 hours = whole / 3600;
    const QString minutes = QString::number(whole / 60 % 60);
    QString text =
        hours > 0 ? QStringLiteral("%1:%2").arg(hours).arg(minutes, 2, QLatin1Char('0')) : minutes;
    text += QStringLiteral(":%1").arg(whole % 60, 2, 10, QLatin1Char('0'));
    if (decimals > 0) {
        text += QStringLiteral(".%1").arg(part, decimals, 10, QLatin1Char('0'));
    }
    return sign + text;
}

AxisRange::AxisRange(double smallest, Foot foot)
    : m_smallest(smallest), m_foot(foot), m_ends(fitting(1.0, 0.0))
{
}

AxisRange::Ends AxisRange::fitting(double lowest, double highest) const
{
    const bool isEmpty = lowest > highest;
    if (m_foot == Foot::Zero || isEmpty) {
        const double wanted = std::max(isEmpty ? 0.0 : highest, m_smallest) * kHeadroom;
        const double step = niceStep(wanted, kMostYSteps);
        return {0.0, std::ceil(wanted / step - 1e-9) * step};
    }
    const double span = std::max(highest - lowest, m_smallest);
    const double middle = (highest + lowest) / 2;
    const double half = span / 2 * (2.0 * kHeadroom - 1.0); // headroom at both ends
    const double step = niceStep(2.0 * half, kMostYSteps);
    return {std::floor((middle - half) / step + 1e-9) * step,
            std::ceil((middle + half) / step - 1e-9) * step};
}

bool AxisRange::fit(double lowest, double highest)
{
    m_tooLargeSince.reset();
    const Ends wanted = fitting(lowest, highest);
    return std::exchange(m_ends, wanted) != wanted;
}

bool AxisRange::update(double lowest, double highest, Instant now)
{
    const Ends wanted = fitting(lowest, highest);
    if (wanted.first < m_ends.first || wanted.second > m_ends.second) {
        // The other end stays for now, unless it is far away.
        m_tooLargeSince.reset();
        const Ends grown{std::min(wanted.first, m_ends.first),
                         std::max(wanted.second, m_ends.second)};
        const bool isTooMuch =
            wanted.second - wanted.first <= kFarTooLarge * (grown.second - grown.first);
        return std::exchange(m_ends, isTooMuch ? wanted : grown) != m_ends;
    }
    if (wanted.second - wanted.first > kFarTooLarge * (m_ends.second - m_ends.first)) {
        m_tooLargeSince.reset();
        return false;
    }
    m_tooLargeSince = m_tooLargeSince.value_or(now);
    return now - *m_tooLargeSince >= kPatience && fit(lowest, highest);
}

} // namespace trex::ticks
