// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/configfile.h"

namespace trex {

/// A setting that two configurations say otherwise, or that only one of them has.
struct ComparedSetting {
    QString key; ///< "serial-timeout", "calibration.rc.1"
    QString title;
    QString left; ///< "0.5 s (5)", "2500 / 3750 / 5000 ± 100"; an en dash: not in it
    QString right;
    bool operator==(const ComparedSetting&) const = default;
};

/// Where a side of a comparison comes from.
enum class SettingsOrigin : std::uint8_t {
    Held, ///< by a controller or a file
    Factory ///< stated by our table, which marks with ≈ what is a guess
};

/// Every setting that differs: parameters by number, then calibrations. `model` is whose current
/// steps amperes are counted in.
[[nodiscard]] std::vector<ComparedSetting>
compare(const Configuration& left, const Configuration& right, Model model,
        SettingsOrigin leftOrigin = SettingsOrigin::Held,
        SettingsOrigin rightOrigin = SettingsOrigin::Held);
/// One line a setting, columns by tabs, a heading first.
[[nodiscard]] QString comparisonText(const std::vector<ComparedSetting>& settings,
                                     const QString& leftName, const QString& rightName);

/// The factory's parameters as far as they are known; no calibrations, the vendor states none.
[[nodiscard]] Configuration factoryDefaults();
/// "2500 / 3750 / 5000 ± 100": minimum, neutral, maximum, deadband.
[[nodiscard]] QString calibrationText(const Calibration& calibration);

} // namespace trex
