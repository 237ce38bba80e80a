// SPDX-License-Identifier: GPL-3.0-or-later
// Where the samples of the streams come from: each poll of polltable.h, and what is known on our
// side of the line without asking.
#pragma once

#include "protocol/codec/polltable.h"

namespace trex {

/// One source of samples; its streams share their times. Every poll is one.
class Source {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): a poll is a source
    constexpr Source(PollId poll) : m_index(static_cast<std::uint8_t>(poll)) { }
    /// What the motors were last told, as it left: motor 1, motor 2, aux.
    [[nodiscard]] static constexpr Source orders() { return Source(kPollCount); }
    /// How the line does, about once a second: transactions, round trip, errors.
    [[nodiscard]] static constexpr Source linkHealth() { return Source(kPollCount + 1); }

    [[nodiscard]] constexpr std::size_t index() const { return m_index; } ///< into kSources
    /// None: nobody has to ask the controller for it.
    [[nodiscard]] constexpr std::optional<PollId> poll() const
    {
        return m_index < kPollCount ? std::optional(static_cast<PollId>(m_index)) : std::nullopt;
    }
    constexpr bool operator==(const Source&) const = default;

private:
    constexpr explicit Source(int index) : m_index(static_cast<std::uint8_t>(index)) { }
    std::uint8_t m_index;
};

struct SourceRow {
    Source source;
    std::string_view key; ///< stands in recordings
    double hertz; ///< as often as this, when all is well
    int values; ///< numbers a sample
};

inline constexpr int kSourceCount = kPollCount + 2;
inline constexpr int kMostValues = kChannelCount; ///< numbers a sample, of any source
inline constexpr auto kSources = [] {
    constexpr SourceRow kOrders{Source::orders(), "orders", 4.0, 3};
    constexpr SourceRow kHealth{Source::linkHealth(), "link-health", 1.0, 3};
    const auto of = [](std::size_t i) {
        return SourceRow{kPolls[i].id, kPolls[i].key, kPolls[i].hertz, kPolls[i].values};
    };
    return std::array<SourceRow, kSourceCount>{
        {of(0), of(1), of(2), of(3), of(4), of(5), of(6), of(7), kOrders, kHealth}};
}();
static_assert(kPollCount == 8, "one of() a poll");

[[nodiscard]] constexpr const SourceRow& sourceRow(Source source)
{
    return kSources[source.index()];
}

} // namespace trex
