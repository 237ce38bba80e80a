// SPDX-License-Identifier: GPL-3.0-or-later
// What happens around a simulated controller: the signals on its channels, and events at set times.
#pragma once

#include "protocol/codec/quantities.h"
#include "protocol/result.h"
#include "protocol/sim/faults.h"

#include <QString>

#include <array>
#include <map>
#include <vector>

namespace trex::sim {

/// The mode selection shorting block.
enum class JumperMode : std::uint8_t { Rc, Analog, Serial };

enum class Wave : std::uint8_t { Hold, Sine, Square, Ramp, Noise, Missing, Stick };

/// One stretch of one channel's signal. Levels are raw units of the input kind in use (0.4 µs or
/// 10-bit counts); without them the wave spans the usual range of that kind. A hold stands at
/// `value`; without it at the one limit that is given, else half-way between the two.
struct ChannelWave {
    int channel = 1; ///< 1 to 5
    Wave wave = Wave::Hold;
    std::optional<double> minimum{};
    std::optional<double> maximum{};
    std::optional<double> value{};
    double period = 4.0; ///< s
    double from = 0.0; ///< s since the start of the line
    double to = std::numeric_limits<double>::infinity();
    std::optional<double> jitter{}; ///< ± raw units
    double missing = 0.0; ///< chance that a pulse is left out
};

/// The guided movement of a calibration: at rest, then from end to end, again and again.
struct StickPlan {
    double neutralSeconds = 3.0;
    double sweepSeconds = 6.0;
};

struct ScenarioEvent {
    double at = 0.0; ///< s since the start of the line
    std::array<std::optional<double>, 2> load; ///< motor 1, 2: 0 free to 1 heavy
    std::array<std::optional<bool>, 2> stall; ///< shaft held fast
    std::array<std::optional<bool>, 2> driverFault; ///< the motor driver reports a fault
    std::optional<JumperMode> mode;
    std::optional<bool> mix;
    std::map<int, int> parameters; ///< number to raw value, as if written by another host
    bool powerCycle = false;
    std::vector<std::pair<QString, double>> faults; ///< names and values, times from here on
};

/// A recorded signal: from each moment (s since the start of the line, ascending) its raw number,
/// until the next one; the last one stays. Before the first, and when empty: nothing is known.
struct Trace {
    std::vector<std::pair<double, std::uint16_t>> points;
    [[nodiscard]] std::optional<std::uint16_t> at(double seconds) const;
};

struct Scenario {
    /// Later rows win where they overlap. Empty, and no stick: the default signals.
    std::vector<ChannelWave> channels;
    std::optional<StickPlan> stick; ///< for the channels without a row of their own
    std::vector<ScenarioEvent> events; ///< in order of time
    std::array<Trace, kChannelCount> channelTraces; ///< where they know, they win over the rows
    std::array<Trace, 2> currentTraces; ///< what the controller measures, whatever its motors do
};

/// The JSON of cli.md, "Scenario file". FileMalformed with the line (syntax) or the key.
[[nodiscard]] Result<Scenario> parseScenario(const QByteArray& json, const QString& name);
/// FileUnreadable, or as parseScenario().
[[nodiscard]] Result<Scenario> readScenario(const QString& path);

} // namespace trex::sim
