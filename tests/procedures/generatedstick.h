// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/quantities.h"

#include <cmath>
#include <numbers>
#include <random>

namespace trex {

/// A stick whose truth is known, for tests: raw readings at 50 Hz with noise, spikes and missing
/// pulses. Deterministic from its seed.
struct GeneratedStick {
    enum class Sweep { Dwell, Sine, UpOnly, DownOnly, Nothing };
    double neutral = 3750.0;
    double low = 2500.0;
    double high = 5000.0;
    double sigma = 0.0;
    double spikeShare = 0.0; ///< of the samples
    double missingShare = 0.0;
    Sweep sweep = Sweep::Dwell;
    bool startsDown = false; ///< a reversed stick goes to its low end first
    unsigned seed = 1;
    double period = 4.0; ///< s, of the sweep
    double expo = 1.0; ///< the transmitter's: flat around the middle, steep at the ends
    double play = 0.0; ///< raw: let go from above it rests so far above its neutral, and likewise
    double wander = 0.0; ///< raw: slow wandering to both sides,
    double wanderPeriod = 7.0; ///< in s
    double creep = 0.0; ///< raw a second,
    double creepUntil = 0.0; ///< and until when, s
    int spikeRun = 1; ///< samples that a spike lasts at most

    static constexpr std::chrono::milliseconds kInterval{20};

    static constexpr double kSpike = 0.1; ///< of the travel, what is worth calling one

    [[nodiscard]] double travel() const { return high - low; }
    /// Neutral and ends are that far from where they began.
    [[nodiscard]] double offset(double seconds) const
    {
        return wander * std::sin(seconds / wanderPeriod * 2.0 * std::numbers::pi)
            + creep * std::min(seconds, creepUntil);
    }
    /// At −1 (low end) to 1 (high end) of its way, without noise.
    [[nodiscard]] double at(double place) const
    {
        return neutral + place * (place < 0 ? neutral - low : high - neutral);
    }
    /// Where the stick stands, without noise, `seconds` into the sweep.
    [[nodiscard]] double position(double seconds) const
    {
        const double phase = std::fmod(seconds, period) * 4.0 / period;
        double place = 0.0; // −1 low end, 1 high end
        switch (sweep) {
        case Sweep::Nothing:
            return neutral;
        case Sweep::Sine:
            place = std::sin(phase * std::numbers::pi / 2.0);
            break;
        default: // a quarter out, half of the time held, a quarter back; then the other way
            const double half = std::fmod(phase, 2.0);
            const double out = std::min({half / 0.5, 1.0, (2.0 - half) / 0.5});
            place = phase < 2.0 ? out : -out;
        }
        place = std::copysign(std::pow(std::abs(place), expo), startsDown ? -place : place);
        if (sweep == Sweep::UpOnly) {
            place = std::abs(place);
        } else if (sweep == Sweep::DownOnly) {
            place = -std::abs(place);
        }
        return at(place);
    }
};

/// Plays the stick sample after sample.
class StickPlayer {
public:
    explicit StickPlayer(const GeneratedStick& stick) : m_stick(stick), m_random(stick.seed) { }

    /// A reading at that position: noise, now and then a spike or 0xFFFF. A voltage ends at the
    /// limits of what can be read; a pulse beyond them is none (facts.md 5.1).
    [[nodiscard]] int reading(double position, int smallest, int largest)
    {
        std::uniform_real_distribution<double> chance(0.0, 1.0);
        const double gauss = std::normal_distribution<double>(0.0, 1.0)(m_random);
        const double missing = chance(m_random);
        const double spike = chance(m_random);
        if (m_spikeLeft > 0) {
            --m_spikeLeft;
        } else if (spike < m_stick.spikeShare * 2.0 / (m_stick.spikeRun + 1)) {
            m_height = chance(m_random) * 2.0 - 1.0;
            m_spikeLeft = static_cast<int>(chance(m_random) * m_stick.spikeRun);
        } else {
            m_height = 0.0;
        }
        if (missing < m_stick.missingShare) {
            return kInvalidPulse;
        }
        const double value = position + gauss * m_stick.sigma + m_height * m_stick.travel();
        const auto rounded = static_cast<int>(std::lround(value));
        const bool isReadable = rounded >= smallest && rounded <= largest;
        const bool isPulse = smallest == 0 || isReadable;
        m_spikes += isPulse && std::abs(m_height) > GeneratedStick::kSpike ? 1 : 0;
        return !isPulse ? kInvalidPulse : std::clamp(rounded, smallest, largest);
    }

    [[nodiscard]] int spikes() const { return m_spikes; } ///< readings given that were one

private:
    GeneratedStick m_stick;
    std::mt19937 m_random;
    int m_spikes = 0;
    double m_height = 0.0;
    int m_spikeLeft = 0;
};

} // namespace trex
