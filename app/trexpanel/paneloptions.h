// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/lineoptions.h"

#include <QString>

#include <optional>

namespace trex {

/// The command line of trexpanel, checked as far as that can be done before anything is shown.
struct PanelOptions {
    LineOptionValues line;
    bool simulate = false;
    bool offscreen = false;
    QString recording; ///< to be opened; "": none
    QString script;
    QString report;
    QString screenshots; ///< "": left out
    QString settings; ///< "": the person's own
    QString language; ///< "": as stored
    QString theme; ///< "": as stored
    double scale = 0.0; ///< factor; 0: the system's
    int verbosity = 0;

    /// A script of its own, or the built-in demonstration.
    [[nodiscard]] bool playsDemonstration() const
    {
        return offscreen && simulate && script.isEmpty();
    }
    [[nodiscard]] bool plays() const { return playsDemonstration() || !script.isEmpty(); }
};

/// Fills `options`; an exit code when the program has nothing more to do (help, version, or an
/// option that makes no sense, which is told on stderr).
[[nodiscard]] std::optional<int> parsePanelOptions(int argc, char** argv, PanelOptions& options);

/// What has to stand in the environment before Qt starts: platform and scale.
void prepareEnvironment(const PanelOptions& options);

} // namespace trex
