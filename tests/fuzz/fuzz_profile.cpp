// SPDX-License-Identifier: GPL-3.0-or-later
// Bench test profiles: any bytes as one.
#include "protocol/storage/benchprofile.h"
#include "tests/fuzz/sentence.h"

#include <cmath>

using namespace trex;
using fuzz::holds;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const auto read = parseBenchProfile(input.rest(), fuzz::fileName());
    if (!read) {
        fuzz::holdsSentence(read.error());
        return 0;
    }
    holds(validate(*read).has_value(), "a profile from a file makes sense");
    const double seconds = plannedSeconds(*read);
    holds(std::isfinite(seconds) && seconds >= 0.0 && seconds <= BenchProfile::kLongestSeconds,
          "a profile from a file ends");
    for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
        const int speed = highestSpeed(*read, motor);
        holds(speed >= 0 && speed <= kFullSpeed, "a profile from a file keeps to the speeds");
    }
    const QByteArray written = writeBenchProfile(*read);
    const auto again = parseBenchProfile(written, fuzz::fileName());
    holds(again.has_value(), "what we wrote we can read");
    holds(*again == *read, "what was written is read as the same");
    holds(writeBenchProfile(*again) == written, "the same is written as the same");
    return 0;
}
