// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/extremefinder.h"
#include "protocol/procedures/returnlearner.h"
#include "protocol/procedures/signalcheck.h"

#include <deque>

namespace trex {

/// Learns one channel: first its neutral from a still window, then (if asked) how it comes back to
/// it, then its ends from sustained values. Pure: fed with fresh readings and their times, it asks
/// for nothing.
class ChannelLearner {
public:
    ChannelLearner(int channel, InputKind input, Duration stillTime);

    /// Throws the neutral away and waits for a still window.
    void beginNeutral();
    /// Keeps the present window as the neutral and counts returns to it. Only with
    /// hasStillWindow().
    void beginReturns();
    /// Keeps the neutral (of the present window, or of the returns), throws the ends away. Only
    /// with hasStillWindow() or from another step behind it.
    void beginExtremes();
    /// Learns nothing any more; readings are only shown.
    void beginWatching() { m_phase = Phase::Watching; }
    /// A reading and the time of its read; times must grow (others are no new samples and ignored).
    /// 0xFFFF and values that no input can have count as missed.
    void feed(int raw, Instant time);

    [[nodiscard]] bool isLearningExtremes() const { return m_phase == Phase::Extremes; }
    [[nodiscard]] bool isValid() const { return m_isValid; } ///< the latest reading was one
    [[nodiscard]] int raw() const { return m_raw; } ///< latest valid reading

    // Neutral
    [[nodiscard]] bool hasStillWindow() const;
    [[nodiscard]] Duration stillFor() const; ///< how long the window has been still
    [[nodiscard]] Duration stillTime() const { return m_stillTime; }
    [[nodiscard]] int restarts() const { return m_restarts; } ///< movements seen in this step
    [[nodiscard]] int movedBy() const { return m_movedBy; } ///< the last of them, raw, signed
    [[nodiscard]] Instant movedAt() const { return m_movedAt; }
    /// Of the still window and the returns; known behind the neutral step.
    [[nodiscard]] double neutral() const { return m_neutral; }
    [[nodiscard]] double sigma() const { return m_sigma; }

    // Returns
    [[nodiscard]] int returns() const { return m_returns.count(); }
    [[nodiscard]] ReturnState returnState() const { return m_returns.state(); }

    // Extremes; sustained values, never a spike
    [[nodiscard]] int lowTravel() const; ///< reached below neutral, raw, ≥ 0
    [[nodiscard]] int highTravel() const;
    [[nodiscard]] int lowNeeded() const; ///< still missing to the needed travel, ≥ 0
    [[nodiscard]] int highNeeded() const;
    /// Both ends reached, no longer growing and known well enough to be written (for levers and
    /// switches: the one end). What is not known after a while is told by the result.
    [[nodiscard]] bool areEndsSettled() const;
    /// Both ends reached and no longer growing, but not known: to be held for longer.
    [[nodiscard]] bool areEndsVague() const;

    /// What a direction probe found for this channel: see LearnedChannel.
    void setDirection(int forwardSign, int swappedWith);
    [[nodiscard]] LearnedChannel result() const;

private:
    enum class Phase : std::uint8_t { Neutral, Returns, Extremes, Watching };
    struct Point {
        int raw;
        Instant time;
    };
    void feedNeutral(int raw, Instant time);
    void feedExtremes(int raw, Instant time);
    void restartWindow(std::size_t keep);
    void takeNeutral();
    [[nodiscard]] bool isDrifting() const;
    [[nodiscard]] bool areEndsReached() const;

    int m_channel;
    InputKind m_input;
    const CalibrationRules& m_rules;
    Duration m_stillTime;
    Phase m_phase = Phase::Neutral;
    bool m_isValid = false;
    int m_raw = 0;
    std::optional<Instant> m_latest;

    std::deque<Point> m_window; ///< of the neutral
    std::deque<Instant> m_missedInWindow;
    int m_restarts = 0;
    int m_movedBy = 0;
    Instant m_movedAt;
    SignalCheck m_check;

    bool m_hasNeutral = false;
    double m_neutral = 0.0;
    double m_sigma = 0.0;
    int m_neutralSpikes = 0;
    int m_samplesBefore = 0; ///< of the neutral window and the returns
    int m_missedBefore = 0;
    ReturnLearner m_returns;
    int m_returnSamples = 0;
    int m_returnMissed = 0;
    ExtremeFinder m_extremes;
    int m_sweepMissed = 0;
    bool m_areEndsKnown = false; ///< as of the latest look
    int m_forwardSign = 0;
    int m_swappedWith = 0;
};

} // namespace trex
