// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations as the verbs print them.
#pragma once

#include "app/trexctl/output.h"
#include "protocol/codec/command.h"

#include <vector>

namespace trex {

struct CalibrationEntry {
    int channel = 1;
    InputKind input = InputKind::Rc;
    Calibration calibration;
    bool isLearned = false; ///< 0x95: differs from the defaults
};

[[nodiscard]] QJsonObject toJson(const CalibrationEntry& entry);
[[nodiscard]] QJsonArray toJson(const std::vector<CalibrationEntry>& entries);
/// A table; before the writing, whether a channel is learned says nothing and is left out.
[[nodiscard]] QString toText(const std::vector<CalibrationEntry>& entries, bool isWritten = true);

} // namespace trex
