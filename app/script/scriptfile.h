// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/result.h"

#include <QJsonValue>
#include <QString>

#include <optional>
#include <vector>

namespace trex {

struct ActionRow;

/// One step of a script, checked: its action exists and its argument makes sense.
struct ScriptStep {
    const ActionRow* action = nullptr;
    QJsonValue argument;
    std::optional<int> timeoutMs;
    QString note;
    std::vector<ScriptStep> steps; ///< of a repeat
};

struct Script {
    std::vector<ScriptStep> steps;
};

inline constexpr int kDefaultStepTimeoutMs = 5000;

/// Errors: FileMalformed, whose context says where (line and column, or the step) and what.
[[nodiscard]] Result<Script> parseScript(const QByteArray& json, const QString& name);
/// Errors: FileUnreadable, FileMalformed.
[[nodiscard]] Result<Script> readScript(const QString& path);

} // namespace trex
