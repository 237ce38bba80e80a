// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/trexctl/verb.h"

#include <memory>
#include <span>

namespace trex {

struct VerbRow {
    const char* path; ///< "info", "param get": as typed
    const char* group; ///< QT_TRANSLATE_NOOP("Cli", …)
    const char* help;
    std::unique_ptr<Verb> (*make)();
};

/// THE verb table; parsing and help loop over it.
[[nodiscard]] std::span<const VerbRow> verbs();
/// What a command with sub-commands is for ("param"); empty where there is none.
[[nodiscard]] const char* familyHelp(std::string_view family);

// verb_info.cpp
[[nodiscard]] std::unique_ptr<Verb> makeInfo();
[[nodiscard]] std::unique_ptr<Verb> makeStatus();
// verb_health.cpp
[[nodiscard]] std::unique_ptr<Verb> makeHealth();
// verb_ports.cpp
[[nodiscard]] std::unique_ptr<Verb> makePorts();
[[nodiscard]] std::unique_ptr<Verb> makeScan();
// verb_channels.cpp, verb_currents.cpp
[[nodiscard]] std::unique_ptr<Verb> makeChannels();
[[nodiscard]] std::unique_ptr<Verb> makeCurrents();
// verb_calibration.cpp, verb_learn.cpp
[[nodiscard]] std::unique_ptr<Verb> makeCalibrationGet();
[[nodiscard]] std::unique_ptr<Verb> makeCalibrationSet();
[[nodiscard]] std::unique_ptr<Verb> makeCalibrationLearn();
// verb_param.cpp, verb_paramset.cpp
[[nodiscard]] std::unique_ptr<Verb> makeParamList();
[[nodiscard]] std::unique_ptr<Verb> makeParamGet();
[[nodiscard]] std::unique_ptr<Verb> makeParamSet();
[[nodiscard]] std::unique_ptr<Verb> makeParamReset();
// verb_config.cpp
[[nodiscard]] std::unique_ptr<Verb> makeConfigSave();
[[nodiscard]] std::unique_ptr<Verb> makeConfigLoad();
[[nodiscard]] std::unique_ptr<Verb> makeConfigDiff();
// verb_journal.cpp, verb_checkpoint.cpp
[[nodiscard]] std::unique_ptr<Verb> makeJournal();
[[nodiscard]] std::unique_ptr<Verb> makeJournalRevert();
[[nodiscard]] std::unique_ptr<Verb> makeCheckpointSave();
[[nodiscard]] std::unique_ptr<Verb> makeCheckpointList();
[[nodiscard]] std::unique_ptr<Verb> makeCheckpointRestore();
[[nodiscard]] std::unique_ptr<Verb> makeCheckpointDelete();
// verb_motor.cpp
[[nodiscard]] std::unique_ptr<Verb> makeMotor();
[[nodiscard]] std::unique_ptr<Verb> makeStop();
// verb_raw.cpp
[[nodiscard]] std::unique_ptr<Verb> makeRaw();
// verb_record.cpp, verb_export.cpp
[[nodiscard]] std::unique_ptr<Verb> makeRecord();
[[nodiscard]] std::unique_ptr<Verb> makeExport();
// verb_run.cpp
[[nodiscard]] std::unique_ptr<Verb> makeRun();
// verb_simulate.cpp
[[nodiscard]] std::unique_ptr<Verb> makeSimulate();

} // namespace trex
