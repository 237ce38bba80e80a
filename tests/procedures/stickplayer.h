// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/calibrationlearner.h"

#include "tests/procedures/stickclasses.h"

namespace trex::test {

inline double seconds(Duration time)
{
    return std::chrono::duration<double>(time).count();
}

struct Played {
    LearnedChannel learned;
    bool endsDone = false;
    double seconds = 0.0; ///< when the neutral was settled
    int fed = 0; ///< fresh readings
    /// The fresh, valid ones among them, in order of time.
    std::vector<std::pair<Instant, int>> readings{};
    double spikeShare = 0.0; ///< of the fresh readings
};

/// Plays a case as the wizard would. With `poison`, each fresh sample is followed by repeats of its
/// time (and earlier ones) with other values: a dead link's stale data.
class CasePlayer {
public:
    CasePlayer(const Case& one, bool poison)
        : m_case(one)
        , m_poison(poison)
        , m_player(one.stick)
        , m_random(one.stick.seed + 77)
        , m_rules(calibrationRules(one.input))
        , m_learner(one.input, static_cast<std::uint8_t>(1U << (one.channel - 1)))
    {
    }

    Played play()
    {
        const auto& stick = m_case.stick;
        m_learner.beginNeutral();
        const double rest = stick.neutral + stick.play * (stick.startsDown ? -1 : 1);
        for (int i = 0; i < 600 && !m_learner.isNeutralDone(); ++i) {
            feed(rest);
        }
        if (m_learner.isNeutralDone()) {
            if (m_case.hasReturns && stick.sweep != GeneratedStick::Sweep::Nothing) {
                playReturns();
            }
            m_played.seconds = seconds(m_now.time_since_epoch());
            m_learner.beginExtremes();
            const auto start = m_now;
            for (int i = 0; i < 1200 && !m_learner.areExtremesDone(); ++i) {
                feed(stick.position(seconds(m_now - start)));
            }
        }
        m_played.endsDone = m_learner.areExtremesDone();
        m_played.spikeShare = double(m_player.spikes()) / std::max(1, m_played.fed);
        m_played.learned = m_learner.result(m_case.channel);
        return m_played;
    }

private:
    void playReturns()
    {
        const auto& stick = m_case.stick;
        m_learner.beginReturns();
        int side = stick.startsDown ? -1 : 1;
        side = stick.sweep == GeneratedStick::Sweep::UpOnly  ? 1
            : stick.sweep == GeneratedStick::Sweep::DownOnly ? -1
                                                             : side;
        const bool isOneWay = stick.sweep == GeneratedStick::Sweep::UpOnly
            || stick.sweep == GeneratedStick::Sweep::DownOnly;
        for (int move = 0; move < 6 && !m_learner.areReturnsDone(); ++move) {
            for (int i = 0; i < 50; ++i) { // out, held, back
                feed(stick.at(side * std::min({i / 15.0, 0.9, (49 - i) / 15.0})));
            }
            for (int i = 0; i < 70 && !m_learner.areReturnsDone(); ++i) {
                feed(stick.neutral + side * stick.play);
            }
            side = isOneWay ? side : -side;
        }
    }

    void feed(double position)
    {
        m_now += GeneratedStick::kInterval;
        const double at = seconds(m_now.time_since_epoch());
        PollSample sample{PollId::RawChannels, {}, m_now};
        sample.raw.fill(kInvalidPulse);
        auto& raw = sample.raw.at(static_cast<std::size_t>(m_case.channel - 1));
        const int value = m_case.foreign ? m_case.foreign(at, m_random)
                                         : m_player.reading(position + m_case.stick.offset(at),
                                                            m_rules.smallest, m_rules.largest);
        raw = static_cast<std::uint16_t>(value);
        m_learner.feed(sample);
        ++m_played.fed;
        if (value >= m_rules.smallest && value <= m_rules.largest) {
            m_played.readings.emplace_back(m_now, value);
        }
        if (m_poison) {
            for (const int bad : {m_rules.smallest, m_rules.largest, int(kInvalidPulse)}) {
                raw = static_cast<std::uint16_t>(bad);
                m_learner.feed(sample);
            }
            sample.time -= std::chrono::milliseconds(1);
            m_learner.feed(sample);
        }
    }

    const Case& m_case;
    bool m_poison;
    StickPlayer m_player;
    std::mt19937 m_random;
    const CalibrationRules& m_rules;
    CalibrationLearner m_learner;
    Instant m_now{};
    Played m_played;
};

} // namespace trex::test
