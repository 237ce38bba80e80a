// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/recordedstate.h"
#include "protocol/storage/recordingreader.h"

namespace trex {

/// What a recording holds beside samples and packets, and what it says of line and controller at
/// any moment. Plain values; one thread.
class RecordingHistory {
public:
    explicit RecordingHistory(RecordingReader& reader);

    struct Moment {
        RecordedState state; ///< without orders: the samples tell them
        bool isArmed = false;
        Tick lostAt = 0; ///< values from before are no longer fresh
        std::optional<std::size_t> configuration; ///< index of the latest one
    };
    [[nodiscard]] Moment at(Tick tick) const;

    [[nodiscard]] const std::vector<RecordedEvent>& events() const { return m_events; }
    [[nodiscard]] const std::vector<RecordedConfiguration>& configurations() const
    {
        return m_configurations;
    }
    [[nodiscard]] std::size_t eventsUpTo(Tick tick) const; ///< how many
    /// Of the next moment with an event after `tick`, or of the last one before; none: no such.
    [[nodiscard]] std::optional<Tick> nextEvent(Tick tick) const;
    [[nodiscard]] std::optional<Tick> previousEvent(Tick tick) const;

private:
    struct State {
        Tick since = 0;
        LinkState link = LinkState::Connected;
        bool isArmed = false;
        DeviceInfo device; ///< without the signature
        Tick lostAt = -kLargestTick;
    };
    void collectStates();
    static void follow(State& state, const RecordedEvent& event);
    [[nodiscard]] LinkStats statsAt(Tick tick) const;

    std::vector<RecordedEvent> m_events;
    std::vector<RecordedHealth> m_health;
    std::vector<RecordedConfiguration> m_configurations;
    std::vector<State> m_states; ///< by time; the first holds from the beginning
    OpenOptions m_options;
    std::optional<Signature> m_signature;
};

} // namespace trex
