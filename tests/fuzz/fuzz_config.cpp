// SPDX-License-Identifier: GPL-3.0-or-later
// Configuration files: any bytes as one.
#include "protocol/codec/parametertable.h"
#include "protocol/storage/configfile.h"
#include "tests/fuzz/sentence.h"

using namespace trex;
using fuzz::holds;

namespace {

void checkValues(const Configuration& configuration)
{
    for (const auto& [number, raw] : configuration.parameters) {
        const ParameterRow* const row = findParameter(number);
        holds(row != nullptr && !row->isTrigger && raw >= row->minimum && raw <= row->maximum,
              "a parameter from a file is in range");
    }
    for (const auto& [input, channels] : configuration.calibrations) {
        for (const auto& [channel, calibration] : channels) {
            holds(channel >= 1 && channel <= kChannelCount && validate(calibration).has_value(),
                  "a calibration from a file can be sent");
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const auto read = parseConfiguration(input.rest(), fuzz::fileName());
    if (!read) {
        fuzz::holdsPlace(read.error());
        return 0;
    }
    checkValues(*read);
    (void)remarkOn(*read);
    const QByteArray written = writeConfiguration(*read);
    const auto again = parseConfiguration(written, fuzz::fileName());
    fuzz::say(QString::fromUtf8(written) + (again ? QString() : again.error().context));
    holds(again.has_value(), "what we wrote we can read");
    holds(*again == *read, "what was written is read as the same");
    holds(writeConfiguration(*again) == written, "the same is written as the same");
    return 0;
}
