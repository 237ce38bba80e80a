// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/benchsamples.h"

#include <cmath>

namespace trex::bench {

std::uint16_t currentAt(std::size_t sample, int motor)
{
    const double wave = std::sin(double(sample) * (motor == 0 ? 0.01 : 0.013));
    return static_cast<std::uint16_t>(60.0 + 40.0 * wave
                                      + double((sample * 2654435761U) >> 28U & 7U));
}

void fillCurrents(TelemetryStore& store, std::size_t count, Instant end)
{
    constexpr std::size_t kPeriod = 8192; // made before, so that only the store is measured
    static const auto kValues = [] {
        std::vector<std::array<std::uint16_t, kChannelCount>> values(kPeriod);
        for (std::size_t i = 0; i < kPeriod; ++i) {
            values[i] = {currentAt(i, 0), currentAt(i, 1)};
        }
        return values;
    }();
    for (std::size_t i = 0; i < count; ++i) {
        const Instant time = end - static_cast<std::int64_t>(count - i) * kSampleStep;
        store.append({PollId::Currents, kValues[i % kPeriod], time});
    }
}

} // namespace trex::bench
