// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/inputmodel.h"

#include <cmath>
#include <numbers>

namespace trex::sim {
namespace {

struct Range {
    double minimum;
    double neutral;
    double maximum;
    double jitter; ///< of signals that are to look alive
};
constexpr Range kRc{2500, 3750, 5000, 1.5};
constexpr Range kAnalog{0, 512, 1023, 0.6};
constexpr double kShortestPulse = 1250; // facts.md 5.1: 0.5 ms
constexpr double kLongestPulse = 6250; // 2.5 ms

// No two sticks are alike, and none is where the factory calibration assumes it.
constexpr std::array<Range, kChannelCount> kRcSticks{{{2618, 3762, 4894, 1.5},
                                                      {2586, 3738, 4871, 1.5},
                                                      {2640, 3755, 4915, 1.5},
                                                      {2552, 3744, 4938, 1.5},
                                                      {2604, 3750, 4902, 1.5}}};
constexpr std::array<Range, kChannelCount> kAnalogSticks{{{38, 518, 991, 0.6},
                                                          {44, 507, 978, 0.6},
                                                          {31, 513, 985, 0.6},
                                                          {52, 510, 996, 0.6},
                                                          {40, 514, 970, 0.6}}};

const Range& rangeOf(const ChannelWave& row, InputKind kind)
{
    if (row.wave != Wave::Stick) {
        return kind == InputKind::Rc ? kRc : kAnalog;
    }
    const auto channel = static_cast<std::size_t>(row.channel - 1);
    return kind == InputKind::Rc ? kRcSticks[channel] : kAnalogSticks[channel];
}

// −1 to 1: at rest, then from end to end; the overdrive lets the stick stay at its ends a while.
double stickPosition(const StickPlan& plan, double seconds)
{
    const double inRound = std::fmod(seconds, plan.neutralSeconds + plan.sweepSeconds);
    if (inRound < plan.neutralSeconds) {
        return 0.0;
    }
    const double sweeps = std::max(1.0, std::round(plan.sweepSeconds / 3.0));
    const double turn = (inRound - plan.neutralSeconds) / plan.sweepSeconds * sweeps;
    return std::clamp(1.15 * std::sin(turn * 2.0 * std::numbers::pi), -1.0, 1.0);
}

// Without a scenario: slow movements of the first three; the last two rest high, which is off.
std::vector<ChannelWave> defaultRows()
{
    return {{.channel = 1, .wave = Wave::Sine, .period = 7.0, .jitter = kRc.jitter},
            {.channel = 2, .wave = Wave::Sine, .period = 11.0, .jitter = kRc.jitter},
            {.channel = 3, .wave = Wave::Ramp, .period = 16.0, .jitter = kRc.jitter}};
}

} // namespace

InputModel::InputModel(const Scenario& scenario, quint64 seed)
    : m_plan(scenario.stick.value_or(StickPlan{})), m_traces(scenario.channelTraces), m_random(seed)
{
    const bool isDefault = scenario.channels.empty() && !scenario.stick;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        ChannelWave rest{.channel = channel, .wave = scenario.stick ? Wave::Stick : Wave::Hold};
        if (channel >= 4 && !scenario.stick) {
            rest.wave = Wave::Square; // its first half, for ever: the top of either kind
            rest.period = Faults::kNever;
        }
        if (isDefault) {
            rest.jitter = kRc.jitter;
        }
        m_rows[static_cast<std::size_t>(channel - 1)].push_back(rest);
    }
    for (const auto& row : isDefault ? defaultRows() : scenario.channels) {
        m_rows[static_cast<std::size_t>(row.channel - 1)].push_back(row);
    }
}

void InputModel::set(const ChannelWave& wave)
{
    auto& rows = m_rows[static_cast<std::size_t>(wave.channel - 1)];
    if (wave.from <= 0.0 && std::isinf(wave.to)) {
        rows.clear();
    }
    rows.push_back(wave);
}

const ChannelWave& InputModel::rowAt(std::size_t channel, double seconds) const
{
    const auto& rows = m_rows[channel];
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        if (seconds >= row->from && seconds < row->to) {
            return *row;
        }
    }
    return rows.front();
}

double InputModel::level(const ChannelWave& row, double seconds, InputKind kind)
{
    const Range& range = rangeOf(row, kind);
    const double low = row.minimum.value_or(range.minimum);
    const double high = row.maximum.value_or(range.maximum);
    const double turn = (seconds - row.from) / row.period;
    const auto between = [&](double position) { return low + (high - low) * (position + 1) / 2; };
    switch (row.wave) {
    case Wave::Hold:
        if (row.value) {
            return *row.value;
        }
        if (row.minimum.has_value() != row.maximum.has_value()) {
            return row.minimum ? *row.minimum : *row.maximum;
        }
        return row.minimum ? between(0.0) : range.neutral;
    case Wave::Sine:
        return between(std::sin(turn * 2.0 * std::numbers::pi));
    case Wave::Square:
        return turn - std::floor(turn) < 0.5 ? high : low;
    case Wave::Ramp: { // begins half-way up
        const double phase = turn + 0.25 - std::floor(turn + 0.25);
        return between(phase < 0.5 ? phase * 4 - 1 : 3 - phase * 4);
    }
    case Wave::Noise:
        return between(m_random.symmetric());
    case Wave::Stick: {
        const double neutral = row.value.value_or(range.neutral);
        const double position = stickPosition(m_plan, seconds - row.from);
        return neutral + (position < 0 ? neutral - low : high - neutral) * position;
    }
    case Wave::Missing:
        break;
    }
    return range.neutral;
}

std::optional<std::uint16_t> InputModel::sample(int channel, double seconds, InputKind kind)
{
    if (const auto traced = m_traces[static_cast<std::size_t>(channel - 1)].at(seconds)) {
        return traced;
    }
    const ChannelWave& row = rowAt(static_cast<std::size_t>(channel - 1), seconds);
    if (kind == InputKind::Rc && (row.wave == Wave::Missing || m_random.chance(row.missing))) {
        return std::nullopt;
    }
    const double usual = row.wave == Wave::Stick ? rangeOf(row, kind).jitter : 0.0;
    const double jitter = row.jitter.value_or(usual);
    double value = level(row, seconds, kind);
    if (jitter > 0.0) {
        value += jitter * m_random.symmetric();
    }
    if (kind == InputKind::Analog) {
        return static_cast<std::uint16_t>(std::clamp(std::lround(value), 0L, 1023L));
    }
    const bool isPulse = value >= kShortestPulse && value <= kLongestPulse;
    return isPulse ? static_cast<std::uint16_t>(std::lround(value)) : kInvalidPulse;
}

} // namespace trex::sim
