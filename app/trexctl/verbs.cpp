// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/verbs.h"

#include <array>

namespace trex {
namespace {

#define TREX_FIND QT_TRANSLATE_NOOP("Cli", "Find and identify")
#define TREX_WATCH QT_TRANSLATE_NOOP("Cli", "Watch")
#define TREX_SET_UP QT_TRANSLATE_NOOP("Cli", "Set up")
#define TREX_DRIVE QT_TRANSLATE_NOOP("Cli", "Drive")
#define TREX_TOOLS QT_TRANSLATE_NOOP("Cli", "Tools")

// clang-format off
constexpr auto kVerbs = std::to_array<VerbRow>({
    {"ports", TREX_FIND, QT_TRANSLATE_NOOP("Cli", "serial ports present"), makePorts},
    {"scan", TREX_FIND, QT_TRANSLATE_NOOP("Cli", "find controllers on --port, whatever their line settings"), makeScan},
    {"info", TREX_FIND, QT_TRANSLATE_NOOP("Cli", "signature, mode, who controls the motors, learned channels"), makeInfo},
    {"status", TREX_WATCH, QT_TRANSLATE_NOOP("Cli", "status byte and UART error byte; reading clears both in the controller"), makeStatus},
    {"health", TREX_WATCH, QT_TRANSLATE_NOOP("Cli", "how well the line does, and what would help; reading clears the UART error byte"), makeHealth},
    {"channels", TREX_WATCH, QT_TRANSLATE_NOOP("Cli", "raw and remapped inputs, once or as a stream"), makeChannels},
    {"currents", TREX_WATCH, QT_TRANSLATE_NOOP("Cli", "motor currents, once or as a stream"), makeCurrents},
    {"record", TREX_WATCH, QT_TRANSLATE_NOOP("Cli", "a crash-safe recording of currents, channels, status, settings"), makeRecord},
    {"export", TREX_WATCH, QT_TRANSLATE_NOOP("Cli", "a recording to CSV"), makeExport},
    {"calibration get", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "calibrations of the input set in force"), makeCalibrationGet},
    {"calibration set", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "write one channel's calibration and read it back"), makeCalibrationSet},
    {"calibration learn", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "guided: rest, move to the extremes, confirm, write"), makeCalibrationLearn},
    {"param list", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "all configuration parameters"), makeParamList},
    {"param get", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "one parameter, by key or number"), makeParamGet},
    {"param set", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "write one parameter and read it back"), makeParamSet},
    {"param reset", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "all parameters to factory defaults"), makeParamReset},
    {"config save", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "all parameters and calibrations in force to a JSON file"), makeConfigSave},
    {"config load", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "write what differs from a file; puts all back when one is refused"), makeConfigLoad},
    {"config diff", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "what differs between the controller and a file"), makeConfigDiff},
    {"journal", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "every write that went to a controller on --port: old, new, result"), makeJournal},
    {"journal revert", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "write back what the controller held before an entry"), makeJournalRevert},
    {"checkpoint save", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "keep the whole configuration under a name"), makeCheckpointSave},
    {"checkpoint list", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "what was kept from controllers on --port, by name or by itself"), makeCheckpointList},
    {"checkpoint restore", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "write what differs from a checkpoint"), makeCheckpointRestore},
    {"checkpoint delete", TREX_SET_UP, QT_TRANSLATE_NOOP("Cli", "forget a checkpoint"), makeCheckpointDelete},
    {"motor", TREX_DRIVE, QT_TRANSLATE_NOOP("Cli", "set, accelerate or brake motor 1, 2, both or aux; it keeps running"), makeMotor},
    {"stop", TREX_DRIVE, QT_TRANSLATE_NOOP("Cli", "all three motors to speed 0 now, or 1 and 2 to full brake"), makeStop},
    {"run", TREX_DRIVE, QT_TRANSLATE_NOOP("Cli", "a bench test: steps, ramps, sines on the motors, with limits that stop it"), makeRun},
    {"raw", TREX_TOOLS, QT_TRANSLATE_NOOP("Cli", "send bytes as given, or framed as a packet"), makeRaw},
    {"simulate", TREX_TOOLS, QT_TRANSLATE_NOOP("Cli", "a simulated controller that other programs can open"), makeSimulate},
});
// clang-format on

constexpr auto kFamilies = std::to_array<std::pair<std::string_view, const char*>>({
    {"calibration", QT_TRANSLATE_NOOP("Cli", "channel calibrations: get, set, learn")},
    {"param", QT_TRANSLATE_NOOP("Cli", "configuration parameters: list, get, set, reset")},
    {"config", QT_TRANSLATE_NOOP("Cli", "whole configurations as files: save, load, diff")},
    {"checkpoint",
     QT_TRANSLATE_NOOP("Cli", "whole configurations by name: save, list, restore, delete")},
});

} // namespace

std::span<const VerbRow> verbs()
{
    return kVerbs;
}

const char* familyHelp(std::string_view family)
{
    for (const auto& [name, help] : kFamilies) {
        if (name == family) {
            return help;
        }
    }
    return "";
}

} // namespace trex
