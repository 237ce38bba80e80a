// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/quantities.h"
#include "protocol/storage/benchprofile.h"

namespace trex {

/// Watches the limits of a profile or of one of its steps over the readings. Pure.
class BenchLimitWatch {
public:
    BenchLimitWatch() = default;
    /// `linkErrors`: how many there were before.
    BenchLimitWatch(const BenchLimits& limits, Instant start, quint64 linkErrors);

    /// Each gives a sentence when a limit is exceeded, else an empty text.
    [[nodiscard]] QString currents(Instant time, const std::array<double, 2>& amperes);
    [[nodiscard]] QString time(Instant now) const;
    [[nodiscard]] QString errors(quint64 linkErrors) const;
    [[nodiscard]] bool overCurrentStops() const { return m_limits.overCurrentStops; }

private:
    BenchLimits m_limits;
    Instant m_start;
    quint64 m_linkErrors = 0;
    std::optional<Instant> m_last; ///< reading
    std::array<double, 2> m_before{}; ///< amperes then
    std::array<double, 2> m_charge{}; ///< A s
    std::array<std::optional<Instant>, 2> m_above; ///< since when above `amperes`
};

} // namespace trex
