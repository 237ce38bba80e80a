// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/telemetry/measurement.h"

namespace trex {

/// When a crossing counts, in physical units of its source.
struct TriggerSettings {
    enum class Mode : std::uint8_t {
        Single, ///< one crossing, then hold until armed anew
        Normal, ///< each crossing replaces the one shown; without one, the last stays
        Auto, ///< as Normal, but runs freely while none comes
    };
    enum class Edge : std::uint8_t { Rising, Falling, Both };
    Mode mode = Mode::Normal;
    Edge edge = Edge::Rising;
    double level = 1.0;
    double hysteresis = 0.0; ///< the value must have been so far on the other side before
    Duration before{std::chrono::seconds(2)}; ///< shown before the crossing (pre-trigger)
    Duration after{std::chrono::seconds(8)}; ///< shown after it; until then no other counts
    bool operator==(const TriggerSettings&) const = default;
};

/// Looks for crossings of a level in one stream as samples come, as an oscilloscope does. Exact to
/// the sample: a crossing's time is that of the first sample on the far side. Across a gap nothing
/// is known, so that nothing crosses. Pure; sees each sample once.
class Trigger {
public:
    enum class State : std::uint8_t {
        Waiting, ///< for a crossing
        Capturing, ///< crossed; the time after it is still coming
        Holding, ///< Single, complete: until arm()
    };

    explicit Trigger(const TriggerSettings& settings = {}) : m_settings(settings) { }
    [[nodiscard]] const TriggerSettings& settings() const { return m_settings; }
    void setSettings(const TriggerSettings& settings) { m_settings = settings; }

    /// Forgets the crossing and looks at samples after `now` only.
    void arm(Instant now);
    /// Looks at what is new; true when there is a new crossing or the state changed. `now` may be
    /// later than the last sample.
    bool advance(const TimeSeries& series, const ValueScale& scale, Instant now);

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] std::optional<Instant> crossing() const { return m_crossing; } ///< the latest
    [[nodiscard]] int count() const { return m_count; } ///< crossings since arm()
    /// Auto: no crossing came for as long as is shown, so that the picture may move on.
    [[nodiscard]] bool runsFreely(Instant now) const;

private:
    [[nodiscard]] bool crosses(double physical);

    TriggerSettings m_settings;
    State m_state = State::Waiting;
    std::optional<Instant> m_armed; ///< none: from the first sample on
    std::optional<Instant> m_seen; ///< of the last sample looked at
    std::optional<Instant> m_crossing;
    bool m_wasBelow = false; ///< by the hysteresis, since the last gap
    bool m_wasAbove = false;
    int m_count = 0;
};

/// The first crossing of a stream at or after `from`; none: it has none.
[[nodiscard]] std::optional<Instant> firstCrossing(const TimeSeries& series,
                                                   const ValueScale& scale,
                                                   const TriggerSettings& settings, Instant from);

} // namespace trex
