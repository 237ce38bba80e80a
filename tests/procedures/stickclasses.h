// SPDX-License-Identifier: GPL-3.0-or-later
// Classes of generated sticks: how to make one, and for what it may be declined.
#pragma once

#include "protocol/procedures/calibrationverdict.h"
#include "protocol/procedures/learnedchannel.h"

#include "tests/procedures/generatedstick.h"

#include <functional>

namespace trex::test {

using Chance = std::uniform_real_distribution<double>;

/// One stick and how it is played.
struct Case {
    GeneratedStick stick;
    InputKind input = InputKind::Rc;
    int channel = 1;
    bool hasReturns = true;
    /// Replaces the stick's readings where it is none: another kind of input, nothing at all.
    std::function<int(double seconds, std::mt19937& random)> foreign{};
};

/// A class of sticks: how to make one, and for what it may be declined.
struct StickClass {
    const char* name;
    void (*shape)(Case& one, std::mt19937& random);
    bool (*isRight)(Finding reason, const Case& one);
    double leastAccepted; ///< share
    double mostAccepted; ///< share
};

inline double between(double low, double high, std::mt19937& random)
{
    return Chance(low, high)(random);
}

/// A usual stick of either kind, with next to no noise.
inline Case usualCase(unsigned seed, std::mt19937& random)
{
    Case one;
    const bool isRc = seed % 2 == 0;
    one.input = isRc ? InputKind::Rc : InputKind::Analog;
    one.channel = seed % 4 < 2 ? 1 : 2;
    auto& stick = one.stick;
    stick.neutral = isRc ? between(3500, 4000, random) : between(440, 580, random);
    stick.low = stick.neutral - (isRc ? between(750, 1300, random) : between(180, 420, random));
    stick.high = stick.neutral + (isRc ? between(750, 1300, random) : between(180, 420, random));
    stick.sigma = between(0.0, 0.001, random) * stick.travel();
    stick.startsDown = between(0, 1, random) < 0.5;
    stick.seed = seed;
    one.hasReturns = seed % 3 != 0;
    return one;
}

inline bool never(Finding /*reason*/, const Case& /*one*/)
{
    return false;
}

/// For noise, spikes and missing pulses: only when there are nearly so many as are not accepted.
inline bool isTooMuch(Finding reason, const Case& one)
{
    const auto& stick = one.stick;
    return (reason == Finding::Noisy && stick.sigma > 0.005 * stick.travel())
        || (reason == Finding::NotHeld
            && stick.sigma > 0.007 * stick.travel()) // held longer it would do
        || (reason == Finding::NotStill && stick.sigma > 0.0085 * stick.travel())
        || (reason == Finding::MissingPulses && stick.missingShare > 0.15)
        || (reason == Finding::Jitter && stick.spikeShare > 0.015);
}

/// With noise, an end must be held.
inline bool isTooMuchToSwing(Finding reason, const Case& one)
{
    return isTooMuch(reason, one)
        || (reason == Finding::NotHeld && one.stick.sigma > 0.0015 * one.stick.travel());
}

/// Expo makes a swing through an end shorter still.
inline bool isSteepSwing(Finding reason, const Case& one)
{
    return reason == Finding::NotHeld && one.stick.sweep == GeneratedStick::Sweep::Sine
        && one.stick.expo > 1.9;
}

template <Finding... kReasons>
inline bool isOneOf(Finding reason, const Case& /*one*/)
{
    return ((reason == kReasons) || ...);
}

using Sweep = GeneratedStick::Sweep;

// clang-format off
inline const StickClass kStickClasses[] = {
    {"clean", [](Case&, std::mt19937&) {}, never, 1.0, 1.0},
    {"noise 0 to 2 %, held", [](Case& one, std::mt19937& random) {
        one.stick.sigma = between(0, 0.02, random) * one.stick.travel(); }, isTooMuch, 0.4, 0.6},
    {"noise 0 to 2 %, swung", [](Case& one, std::mt19937& random) {
        one.stick.sigma = between(0, 0.02, random) * one.stick.travel();
        one.stick.sweep = Sweep::Sine; }, isTooMuchToSwing, 0.12, 0.6},
    {"spikes to 3.5 %", [](Case& one, std::mt19937& random) {
        one.stick.sigma = between(0, 0.005, random) * one.stick.travel();
        one.stick.spikeShare = between(0, 0.035, random); }, isTooMuch, 0.97, 1.0},
    {"pulses missing to 20 %", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Rc; one.stick = usualCase(one.stick.seed & ~1U, random).stick;
        one.stick.missingShare = between(0, 0.2, random); }, isTooMuch, 0.85, 1.0},
    {"pulses missing 28 to 60 %", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Rc; one.stick = usualCase(one.stick.seed & ~1U, random).stick;
        one.stick.missingShare = between(0.28, 0.6, random); }, isOneOf<Finding::MissingPulses>, 0.0, 0.001},
    {"reversed", [](Case& one, std::mt19937&) { one.stick.startsDown = true; }, never, 1.0, 1.0},
    {"one-sided, drive", [](Case& one, std::mt19937& random) {
        one.stick.sweep = between(0, 1, random) < 0.5 ? Sweep::UpOnly : Sweep::DownOnly; },
        isOneOf<Finding::OneDirection>, 0.0, 0.0},
    {"one-sided, lever or switch", [](Case& one, std::mt19937& random) {
        one.channel = 3 + static_cast<int>(one.stick.seed % 3);
        one.stick.sweep = between(0, 1, random) < 0.5 ? Sweep::UpOnly : Sweep::DownOnly; }, never, 0.995, 1.0},
    {"asymmetrical to 1:4", [](Case& one, std::mt19937& random) {
        const bool isRc = one.input == InputKind::Rc;
        const double side = isRc ? between(640, 700, random) : between(130, 150, random);
        const double other = side * between(1.5, isRc ? 3.3 : 3.8, random);
        one.stick.neutral = isRc ? 3750 : between(1, 2, random) < 1.5 ? 440 : 580;
        const bool isUp = isRc ? between(0, 1, random) < 0.5 : one.stick.neutral < 500;
        one.stick.low = std::max(isRc ? 1260.0 : 5.0, one.stick.neutral - (isUp ? side : other));
        one.stick.high = std::min(isRc ? 6240.0 : 1018.0, one.stick.neutral + (isUp ? other : side)); },
        never, 1.0, 1.0},
    {"expo to cubic", [](Case& one, std::mt19937& random) {
        one.stick.expo = between(1.0, 3.0, random);
        one.stick.sweep = between(0, 1, random) < 0.5 ? Sweep::Sine : Sweep::Dwell; }, isSteepSwing, 0.95, 1.0},
    {"sticky centre", [](Case& one, std::mt19937& random) {
        one.hasReturns = true;
        one.stick.play = between(0.002, 0.02, random) * one.stick.travel(); }, never, 1.0, 1.0},
    {"wandering to 0.3 %", [](Case& one, std::mt19937& random) {
        one.stick.wander = between(0, 0.003, random) * one.stick.travel();
        one.stick.wanderPeriod = between(2, 15, random); }, isOneOf<Finding::NotStill>, 0.9, 1.0},
    {"creeping, then at rest", [](Case& one, std::mt19937& random) {
        const double least = std::max(3.0, 3.0 * one.stick.sigma);
        one.stick.creep = between(least, 20.0 * least, random);
        one.stick.creepUntil = between(1.5, 7.5, random) * least / one.stick.creep; }, never, 1.0, 1.0},
    {"creeping for ever", [](Case& one, std::mt19937& random) {
        one.stick.creep = between(1.0, 4.0, random) * std::max(3.0, 3.0 * one.stick.sigma);
        one.stick.creepUntil = 1e9; }, isOneOf<Finding::NotStill>, 0.0, 0.0},
    {"not moved", [](Case& one, std::mt19937&) { one.stick.sweep = Sweep::Nothing; },
        isOneOf<Finding::NotMoved>, 0.0, 0.0},
    {"too little travel", [](Case& one, std::mt19937& random) {
        const double needed = calibrationRules(one.input).neededTravel;
        one.stick.low = one.stick.neutral - between(0.35, 0.95, random) * needed;
        one.stick.high = one.stick.neutral + between(0.35, 0.95, random) * needed; },
        isOneOf<Finding::TravelTooSmall>, 0.0, 0.0},
    {"rushed, never held", [](Case& one, std::mt19937& random) {
        one.stick.sweep = Sweep::Sine; one.stick.period = between(0.25, 3.0, random); },
        isOneOf<Finding::NotHeld, Finding::TravelTooSmall, Finding::Jitter>, 0.1, 0.9},
    {"failing potentiometer", [](Case& one, std::mt19937& random) {
        one.stick.spikeShare = between(0.12, 0.3, random); one.stick.spikeRun = 3; },
        isOneOf<Finding::Jitter, Finding::NotStill>, 0.0, 0.05},
    {"potentiometer at its rails", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Analog; one.stick.neutral = between(480, 540, random);
        one.stick.low = -20; one.stick.high = 1040; one.stick.sigma = between(0, 2, random); }, never, 1.0, 1.0},
    {"pulses beyond what is read", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Rc; one.stick.neutral = 3750; one.stick.low = 2500;
        one.stick.high = between(6255, 6700, random); one.stick.sigma = between(0, 4, random); },
        isOneOf<Finding::Saturated>, 0.0, 0.3},
    {"RC pulses on analog", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Analog;
        const double share = between(0.1, 0.25, random);
        one.foreign = [share](double, std::mt19937& draw) {
            return Chance(0, 1)(draw) < share ? static_cast<int>(Chance(20, 900)(draw))
                                              : static_cast<int>(Chance(0, 3)(draw)); }; },
        isOneOf<Finding::InputConfused>, 0.0, 0.0},
    {"readings of the other kind", [](Case& one, std::mt19937& random) {
        const bool isRc = one.input == InputKind::Rc;
        const double at = isRc ? between(100, 900, random) : between(2500, 5000, random);
        const double missing = isRc ? 0.0 : between(0, 0.3, random);
        one.foreign = [at, missing](double, std::mt19937& draw) {
            return Chance(0, 1)(draw) < missing ? int(kInvalidPulse)
                                                : static_cast<int>(at + Chance(-2, 2)(draw)); }; },
        isOneOf<Finding::InputConfused>, 0.0, 0.0},
    {"floating analog input", [](Case& one, std::mt19937& random) {
        one.input = InputKind::Analog;
        const double period = between(3, 9, random);
        one.foreign = [period](double at, std::mt19937& draw) {
            return static_cast<int>(500 + 200 * std::sin(at / period * 6.28) + 60 * std::sin(at * 5)
                                    + Chance(-8, 8)(draw)); }; },
        isOneOf<Finding::NotStill, Finding::InputConfused>, 0.0, 0.0},
    {"all of it", [](Case& one, std::mt19937& random) {
        auto& stick = one.stick;
        stick.sigma = between(0, 0.012, random) * stick.travel();
        stick.spikeShare = between(0, 0.03, random);
        stick.missingShare = one.input == InputKind::Rc ? between(0, 0.15, random) : 0.0;
        stick.expo = between(1, 2, random);
        stick.play = one.hasReturns ? between(0, 0.01, random) * stick.travel() : 0.0; },
        isTooMuch, 0.7, 1.0},
};
// clang-format on

} // namespace trex::test
