// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/calibrationverdict.h"

#include <deque>

namespace trex {

/// Learns one channel: first its neutral from a still window, then its ends from sustained values.
/// Pure: fed with fresh readings and their times, it asks for nothing.
class ChannelLearner {
public:
    ChannelLearner(int channel, InputKind input, Duration stillTime);

    /// Throws the neutral away and waits for a still window.
    void beginNeutral();
    /// Keeps the present window as the neutral, throws the ends away. Only with hasStillWindow().
    void beginExtremes();
    /// A reading and the time of its read; times must grow (others are no new samples and ignored).
    /// 0xFFFF and values that no input can have count as missed.
    void feed(int raw, Instant time);

    [[nodiscard]] bool isLearningExtremes() const { return m_isExtremes; }
    [[nodiscard]] bool isValid() const { return m_isValid; } ///< the latest reading was one
    [[nodiscard]] int raw() const { return m_raw; } ///< latest valid reading

    // Neutral
    [[nodiscard]] bool hasStillWindow() const;
    [[nodiscard]] Duration stillFor() const; ///< how long the window has been still
    [[nodiscard]] Duration stillTime() const { return m_stillTime; }
    [[nodiscard]] int restarts() const { return m_restarts; } ///< movements seen in this step
    [[nodiscard]] int movedBy() const { return m_movedBy; } ///< the last of them, raw, signed
    [[nodiscard]] Instant movedAt() const { return m_movedAt; }

    /// The median of the still window; known while the extremes are learned.
    [[nodiscard]] double neutral() const { return m_neutral; }

    // Extremes; sustained values, never a spike
    [[nodiscard]] int lowTravel() const; ///< reached below neutral, raw, ≥ 0
    [[nodiscard]] int highTravel() const;
    [[nodiscard]] int lowNeeded() const; ///< still missing to the needed travel, ≥ 0
    [[nodiscard]] int highNeeded() const;
    /// Both ends reached and no longer growing (for levers and switches: the one end).
    [[nodiscard]] bool areEndsSettled() const;

    [[nodiscard]] LearnedChannel result() const;

private:
    struct Point {
        int raw;
        Instant time;
    };
    struct End {
        double value = 0.0; ///< best sustained value
        double noted = 0.0; ///< the value when it last grew notably,
        Instant grownAt; ///< and when that was
    };
    void feedNeutral(int raw, Instant time);
    void feedExtremes(int raw, Instant time);
    void restartWindow(std::size_t keep);
    [[nodiscard]] bool isDrifting() const;
    [[nodiscard]] std::size_t sustainedCount() const;
    void growEnds(double sustained, Instant time);
    [[nodiscard]] double refinedEnd(double reached, int sign) const;

    int m_channel;
    InputKind m_input;
    const CalibrationRules& m_rules;
    Duration m_stillTime;
    bool m_isExtremes = false;
    bool m_isValid = false;
    int m_raw = 0;
    std::optional<Instant> m_latest;

    std::deque<Point> m_window; ///< of the neutral
    std::deque<Instant> m_missedInWindow;
    int m_restarts = 0;
    int m_movedBy = 0;
    Instant m_movedAt;
    bool m_hasSeenReading = false;

    double m_neutral = 0.0;
    double m_sigma = 0.0;
    int m_neutralSamples = 0;
    int m_neutralMissed = 0;
    std::deque<Point> m_sweep;
    int m_sweepSamples = 0;
    int m_sweepMissed = 0;
    End m_low;
    End m_high;
};

} // namespace trex
