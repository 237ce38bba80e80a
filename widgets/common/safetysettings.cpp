// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/safetysettings.h"

#include "widgets/common/uisettings.h"

namespace trex {

namespace {

// A settings file may be edited by hand: what makes no sense is brought back into its range.
constexpr int kMostRamp = 10'000; ///< speed steps a second
constexpr int kMostMilliamperes = 40'000;
constexpr int kMostStallMs = 60'000;
constexpr int kMostIdleSeconds = 24 * 3600;

} // namespace

DisarmRules disarmRules(const UiSettings& settings)
{
    const int idle = std::clamp(settings.value(settings::kIdleSeconds), 0, kMostIdleSeconds);
    return {.motorFault = settings.value(settings::kDisarmMotorFault),
            .overCurrent = settings.value(settings::kDisarmOverCurrent),
            .uartError = settings.value(settings::kDisarmUartError),
            .serialTimeout = settings.value(settings::kDisarmSerialTimeout),
            .idle = std::chrono::seconds(idle)};
}

MotionLimits motionLimits(const UiSettings& settings)
{
    const auto maximum = [&settings](const Setting<int>& setting) {
        return std::clamp(settings.value(setting), 1, kFullSpeed);
    };
    const int stall =
        std::clamp(settings.value(settings::kStallMilliamperes), 0, kMostMilliamperes);
    const int stallMs = std::clamp(settings.value(settings::kStallMs), 1, kMostStallMs);
    return {.maximum = {maximum(settings::kMaximum1), maximum(settings::kMaximum2),
                        maximum(settings::kMaximumAux)},
            .softStart = std::clamp(settings.value(settings::kSoftStart), 0, kMostRamp),
            .softStop = std::clamp(settings.value(settings::kSoftStop), 0, kMostRamp),
            .stallAmperes = stall / 1000.0,
            .stallTime = std::chrono::milliseconds(stallMs)};
}

void store(UiSettings& settings, const DisarmRules& rules)
{
    settings.set(settings::kDisarmMotorFault, rules.motorFault);
    settings.set(settings::kDisarmOverCurrent, rules.overCurrent);
    settings.set(settings::kDisarmUartError, rules.uartError);
    settings.set(settings::kDisarmSerialTimeout, rules.serialTimeout);
    settings.set(settings::kIdleSeconds, static_cast<int>(rules.idle.count()));
}

void store(UiSettings& settings, const MotionLimits& limits)
{
    settings.set(settings::kMaximum1, limits.maximum[0]);
    settings.set(settings::kMaximum2, limits.maximum[1]);
    settings.set(settings::kMaximumAux, limits.maximum[2]);
    settings.set(settings::kSoftStart, limits.softStart);
    settings.set(settings::kSoftStop, limits.softStop);
    settings.set(settings::kStallMilliamperes, qRound(limits.stallAmperes * 1000.0));
    settings.set(settings::kStallMs, static_cast<int>(limits.stallTime.count()));
}

} // namespace trex
