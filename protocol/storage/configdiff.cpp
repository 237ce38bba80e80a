// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/configdiff.h"

using namespace Qt::Literals::StringLiterals;

namespace trex {

std::vector<ConfigurationChange> calibrationDifferences(InputKind input, int channel,
                                                        const std::optional<Calibration>& present,
                                                        const Calibration& wanted)
{
    struct Field {
        QLatin1StringView key;
        int Calibration::*value;
    };
    constexpr std::array kFields{
        Field{"minimum"_L1, &Calibration::minimum}, Field{"neutral"_L1, &Calibration::neutral},
        Field{"maximum"_L1, &Calibration::maximum}, Field{"deadband"_L1, &Calibration::deadband}};
    std::vector<ConfigurationChange> changes;
    for (const auto& field : kFields) {
        const auto from = present ? std::optional((*present).*field.value) : std::optional<int>();
        if (from != wanted.*field.value) {
            changes.push_back(
                {u"calibration.%1.%2.%3"_s.arg(keyOf(input)).arg(channel).arg(field.key), from,
                 wanted.*field.value});
        }
    }
    return changes;
}

std::vector<ConfigurationChange> differences(const Configuration& present,
                                             const Configuration& wanted)
{
    std::vector<ConfigurationChange> changes;
    for (const auto& [number, to] : wanted.parameters) {
        const auto* const row = findParameter(number);
        const auto found = present.parameters.find(number);
        const auto from =
            found == present.parameters.end() ? std::optional<int>() : std::optional(found->second);
        if (row != nullptr && from != to) {
            changes.push_back({keyText(*row), from, to});
        }
    }
    for (const auto& [input, channels] : wanted.calibrations) {
        const auto set = present.calibrations.find(input);
        for (const auto& [channel, to] : channels) {
            std::optional<Calibration> from;
            if (set != present.calibrations.end() && set->second.contains(channel)) {
                from = set->second.at(channel);
            }
            const auto fields = calibrationDifferences(input, channel, from, to);
            changes.insert(changes.end(), fields.begin(), fields.end());
        }
    }
    return changes;
}

} // namespace trex
