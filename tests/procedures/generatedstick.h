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

    static constexpr std::chrono::milliseconds kInterval{20};

    /// Where the stick stands, without noise, `seconds` into the sweep.
    [[nodiscard]] double position(double seconds) const
    {
        const double phase = std::fmod(seconds, 4.0);
        double place = 0.0; // −1 low end, 1 high end
        switch (sweep) {
        case Sweep::Nothing:
            return neutral;
        case Sweep::Sine:
            place = std::sin(phase * std::numbers::pi / 2.0);
            break;
        default: // 0.5 s out, 1 s held, 0.5 s back; then the other way
            const double half = std::fmod(phase, 2.0);
            const double out = std::min({half / 0.5, 1.0, (2.0 - half) / 0.5});
            place = phase < 2.0 ? out : -out;
        }
        if (startsDown) {
            place = -place;
        }
        if (sweep == Sweep::UpOnly) {
            place = std::abs(place);
        } else if (sweep == Sweep::DownOnly) {
            place = -std::abs(place);
        }
        return neutral + place * (place < 0 ? neutral - low : high - neutral);
    }
};

/// Plays the stick sample after sample.
class StickPlayer {
public:
    explicit StickPlayer(const GeneratedStick& stick) : m_stick(stick), m_random(stick.seed) { }

    /// A reading at that position: noise, now and then a spike or 0xFFFF.
    [[nodiscard]] int reading(double position, int smallest, int largest)
    {
        std::uniform_real_distribution<double> chance(0.0, 1.0);
        const double gauss = std::normal_distribution<double>(0.0, 1.0)(m_random);
        const double missing = chance(m_random);
        const double spike = chance(m_random);
        const double height = chance(m_random) * 2.0 - 1.0;
        if (missing < m_stick.missingShare) {
            return kInvalidPulse;
        }
        double value = position + gauss * m_stick.sigma;
        if (spike < m_stick.spikeShare) {
            value += height * (m_stick.high - m_stick.low);
        }
        return std::clamp(static_cast<int>(std::lround(value)), smallest, largest);
    }

private:
    GeneratedStick m_stick;
    std::mt19937 m_random;
};

} // namespace trex
