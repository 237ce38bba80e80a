// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/script/scriptfile.h"

#include <QStringList>

#include <string_view>

namespace trex {

class FileDialogs;

/// What a handler may use; it lives as long as its step.
struct StepContext {
    FileDialogs& fileDialogs;
    const QString& folder; ///< of the screenshots
    QStringList& screenshots; ///< files written, relative to the folder
    qint64 elapsedMs = 0; ///< since the step began
    int timeoutMs = kDefaultStepTimeoutMs;
    int phase = 0; ///< the handler's own; 0 when the step begins
    qint64 phaseBeganMs = 0; ///< the handler's own
};

enum class Verdict {
    Done,
    Pending, ///< call again soon
    Failed,
    Enter, ///< play step.steps, then call again
    Quit, ///< done, and so is the script
};

struct StepResult {
    Verdict verdict = Verdict::Done;
    QString message; ///< why it failed, or what it waits for
};

/// One action of scripts: parser and player loop over the rows.
struct ActionRow {
    std::string_view name;
    QString (*check)(const QJsonValue& argument); ///< what is wrong with it; empty: nothing
    StepResult (*run)(StepContext& context, const ScriptStep& step);
};

[[nodiscard]] const ActionRow* findAction(QStringView name); ///< null: there is none

} // namespace trex
