// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/responsecurve.h"

#include <cmath>

namespace trex {
namespace {

/// −127 to 127, before parabola and reversal. The ends are looked at first: a calibration whose
/// deadband reaches beyond an end still gives 127 there (command documentation, 0x87).
double linear(double raw, const Calibration& calibration)
{
    const auto& [minimum, neutral, maximum, deadband] = calibration;
    if (raw >= maximum) {
        return kFullSpeed;
    }
    if (raw <= minimum) {
        return -kFullSpeed;
    }
    const double above = raw - neutral - deadband;
    const double below = neutral - deadband - raw;
    if (above > 0.0) {
        return kFullSpeed * above / (maximum - neutral - deadband);
    }
    return below > 0.0 ? -kFullSpeed * below / (neutral - deadband - minimum) : 0.0;
}

double parabola(double value)
{
    return value * std::abs(value) / kFullSpeed;
}

} // namespace

int ResponseCurve::remap(double raw) const
{
    double value = std::trunc(linear(raw, calibration));
    if (parabolic) {
        value = std::trunc(parabola(value));
    }
    return static_cast<int>(reversed ? -value : value);
}

double ResponseCurve::shape(double raw) const
{
    const double line = linear(raw, calibration);
    const double value = parabolic ? parabola(line) : line;
    return reversed ? -value : value;
}

double ResponseCurve::switchThreshold() const
{
    const auto& [minimum, neutral, maximum, deadband] = calibration;
    const double level = -kSwitchOnLevel;
    const double share = (parabolic ? std::sqrt(level * kFullSpeed) : level) / kFullSpeed;
    return reversed ? neutral + deadband + share * std::max(0, maximum - neutral - deadband)
                    : neutral - deadband - share * std::max(0, neutral - deadband - minimum);
}

bool ResponseCurve::isSwitchedOn(double raw) const
{
    return remap(raw) <= kSwitchOnLevel;
}

} // namespace trex
