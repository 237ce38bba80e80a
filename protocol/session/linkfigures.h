// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of the line as text: for the panel, the clipboard and the command line.
#pragma once

#include "protocol/session/linkfacts.h"

namespace trex {

/// A figure that is counted: of the last minute and since the counting began.
struct CountedFigure {
    QLatin1StringView key; ///< never translated
    QString title;
    QString recent;
    QString total;
    bool isTrouble = false; ///< counts what should not be, and something was counted recently
};
[[nodiscard]] std::vector<CountedFigure> countedFigures(const LinkFacts& facts);

/// A figure of the line as it is now.
struct LineFigure {
    QLatin1StringView key;
    QString title;
    QString text;
    bool isTrouble = false;
};
[[nodiscard]] std::vector<LineFigure> lineFigures(const LinkFacts& facts);

/// What a poll brings, as people call it: "currents".
[[nodiscard]] QString pollText(PollId poll);
/// Figures and advice, a line each.
[[nodiscard]] QString linkReport(const LinkFacts& facts);

} // namespace trex
