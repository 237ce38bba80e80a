// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/factory.h"

#include "protocol/codec/parametertable.h"

#include <array>

namespace trex::sim {
namespace {

constexpr std::size_t kParameterCount = 128;
constexpr int kLargestBaudIndex = 10; // facts.md 2.3

constexpr auto kLimits = [] {
    std::array<ParameterLimits, kParameterCount> limits{};
    for (const auto& row : kParameters) {
        limits[row.number] = {!row.isTrigger, row.minimum, row.maximum, row.defaultRaw};
    }
    return limits;
}();

} // namespace

const ParameterLimits& parameterLimits(int number)
{
    return kLimits[static_cast<std::size_t>(number) % kParameterCount];
}

bool takesParameter(int number, int raw)
{
    const ParameterLimits& limits = parameterLimits(number);
    const bool isKnownBaud = number != 0x7E || (raw & 0x0F) <= kLargestBaudIndex;
    return limits.exists && raw >= limits.minimum && raw <= limits.maximum && isKnownBaud;
}

CalibrationValues factoryCalibration(InputKind kind) // C-63
{
    return kind == InputKind::Rc ? CalibrationValues{2500, 3750, 5000, 100}
                                 : CalibrationValues{0, 512, 1023, 20};
}

} // namespace trex::sim
