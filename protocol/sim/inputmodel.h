// SPDX-License-Identifier: GPL-3.0-or-later
// The signals on a controller's five channels: a receiver's pulses, or voltages.
#pragma once

#include "protocol/sim/scenario.h"

namespace trex::sim {

class InputModel {
public:
    InputModel(const Scenario& scenario, quint64 seed);

    /// A further stretch; it wins over earlier ones. One without an end replaces them.
    void set(const ChannelWave& wave);
    /// What the controller measures at this moment, in raw units. None: no pulse. RC values outside
    /// 1250 to 6250 are measured as kInvalidPulse (facts.md 5.1).
    [[nodiscard]] std::optional<std::uint16_t> sample(int channel, double seconds, InputKind kind);

private:
    [[nodiscard]] const ChannelWave& rowAt(std::size_t channel, double seconds) const;
    [[nodiscard]] double level(const ChannelWave& row, double seconds, InputKind kind);

    StickPlan m_plan;
    std::array<Trace, kChannelCount> m_traces;
    std::array<std::vector<ChannelWave>, kChannelCount> m_rows;
    Random m_random;
};

} // namespace trex::sim
