// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/linesettings.h"
#include "protocol/codec/polltable.h"

#include <array>
#include <optional>

namespace trex {

using PollWishes = std::array<double, kPollCount>; ///< Hz by PollId; 0: not wanted

/// Decides which query is polled next. Pure: time comes in as argument. Where the line cannot carry
/// what is wanted, every stream slows in proportion (scale()).
class PollPlan {
public:
    void setLine(const LineSettings& settings);
    void setWishes(const PollWishes& wishes, Instant now);
    /// The measured time a transaction takes beyond its bytes on the wire.
    void setOverhead(Duration overhead);
    void restart(Instant now); ///< after a pause of the link: everything is due, nothing is late

    [[nodiscard]] std::optional<PollId> due(Instant now) const;
    [[nodiscard]] std::optional<Instant> nextDue() const; ///< none: nothing is wanted
    void sent(PollId id, Instant now);

    [[nodiscard]] double scale() const { return m_scale; }
    [[nodiscard]] const PollWishes& wishes() const { return m_wishes; }
    /// Time one transaction of this poll takes on the line, overhead included.
    [[nodiscard]] Duration cost(PollId id) const;

private:
    void rescale();
    [[nodiscard]] Duration period(std::size_t index) const;
    LineSettings m_line;
    PollWishes m_wishes{};
    std::array<Instant, kPollCount> m_due{};
    std::array<Duration, kPollCount> m_wire{};
    Duration m_overhead{std::chrono::microseconds(300)};
    double m_scale = 1.0;
};

} // namespace trex
