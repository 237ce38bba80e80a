// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences about lines: how one is set, and what to try when nothing answers.
#pragma once

#include "protocol/procedures/linesearch.h"

#include <QString>

namespace trex {

/// As people say it: "19200 baud, no error detection".
[[nodiscard]] QString lineText(const LineSettings& line);
/// What to look at, by what came back while nothing was found.
[[nodiscard]] QString wiringAdvice(LineAnswer heard);
/// One sentence on the settings that a search has left out, and why; empty if none.
[[nodiscard]] QString leftOutText(const std::vector<LineSettings>& leftOut);
/// The vendor's way to factory line settings. Its steps were observed, its effect is inferred
/// (facts.md 6, serial-parameter reset): the text says so.
[[nodiscard]] QString vendorResetText();

} // namespace trex
