// SPDX-License-Identifier: GPL-3.0-or-later
// What happened in a bench test: what was told, what was read, and what was remarked. Plain values.
#pragma once

#include "protocol/codec/command.h"

#include <QString>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace trex {

/// All times count from the first order, in ticks of 100 µs.
struct BenchTrace {
    static constexpr double kTicksPerSecond = 10'000.0;
    /// Two readings further apart than this have a gap between them: nothing is known there.
    static constexpr double kGapSeconds = 0.3;

    struct Sample { ///< both currents in one reply, at the time of its read
        std::uint32_t tick = 0;
        std::array<std::uint8_t, 2> raw{};
    };
    struct Order {
        std::uint32_t tick = 0;
        MotorId motor = MotorId::Motor1;
        MotorOrder::Action action = MotorOrder::Action::Set;
        std::int8_t amount = 0; ///< signed speed, or braking duty
    };
    struct Event {
        double seconds = 0.0;
        int severity = 0; ///< 0 information, 1 warning, 2 error
        QString text;
    };
    std::vector<Sample> samples;
    std::vector<Order> orders;
    std::vector<Event> events;
    Model model = Model::TrexJr;
    double seconds = 0.0; ///< from the first order to the end
    quint64 linkErrors = 0; ///< replies lost or damaged meanwhile

    void addOrder(double at, MotorId motor, const MotorOrder& order)
    {
        orders.push_back({tickOf(at), motor, order.action, static_cast<std::int8_t>(order.amount)});
    }
    [[nodiscard]] static std::uint32_t tickOf(double at)
    {
        return static_cast<std::uint32_t>(std::lround(std::max(at, 0.0) * kTicksPerSecond));
    }
    [[nodiscard]] static double secondsOf(std::uint32_t tick) { return tick / kTicksPerSecond; }
    /// Motor 1 or 2; the auxiliary motor's current is not measured.
    [[nodiscard]] double amperes(std::size_t index, MotorId motor) const
    {
        return samples[index].raw.at(std::size_t(motor)) * amperesPerCount(model);
    }
};

} // namespace trex
