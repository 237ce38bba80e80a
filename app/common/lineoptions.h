// SPDX-License-Identifier: GPL-3.0-or-later
// The options that say where a controller is and how its line is set: one parser for both programs.
#pragma once

#include "protocol/session/controller.h"
#include "protocol/storage/setting.h"

#include <optional>

namespace CLI {
class App;
}

namespace trex {

/// As typed; what was not given stays empty.
struct LineOptionValues {
    std::optional<QString> port;
    std::optional<QString> baud;
    std::optional<QString> protocol;
    std::optional<QString> device;
    std::optional<QString> errorDetection;
    std::optional<QString> polynomial;
    std::optional<QString> stopBits;
    std::optional<QString> echo;
    std::optional<QString> timeout;
    /// True when something about the line was said, so that stored settings do not count.
    [[nodiscard]] bool any() const;
};

/// Adds --port, --baud and so on to a program's options. `values` must outlive the parsing.
void addLineOptions(CLI::App& app, LineOptionValues& values);

/// The settings alone, each checked. Errors: OutOfRange with the option's name and its range.
[[nodiscard]] Result<LineSettings> toLineSettings(const LineOptionValues& values);

/// Settings and port (left out: the last one used, else "sim:"). Errors: as above; PortAddress;
/// what is wrong with the settings file, when the port has to come from there.
[[nodiscard]] Result<OpenOptions> toOpenOptions(const LineOptionValues& values,
                                                SettingsFile& settings);

} // namespace trex
