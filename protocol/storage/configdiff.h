// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/configfile.h"

#include <vector>

namespace trex {

/// One number that differs. Keys are those of the configuration file: `serial-timeout`,
/// `calibration.rc.1.minimum`.
struct ConfigurationChange {
    QString key;
    std::optional<int> from; ///< raw; none: not known
    int to = 0; ///< raw
    bool operator==(const ConfigurationChange&) const = default;
};

/// What `wanted` says otherwise than `present`: parameters by number, then calibrations. What
/// `wanted` does not mention is no difference.
[[nodiscard]] std::vector<ConfigurationChange> differences(const Configuration& present,
                                                           const Configuration& wanted);

/// The four numbers of a calibration that differ; all of them when `present` is not known.
[[nodiscard]] std::vector<ConfigurationChange>
calibrationDifferences(InputKind input, int channel, const std::optional<Calibration>& present,
                       const Calibration& wanted);

} // namespace trex
