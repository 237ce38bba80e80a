// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/result.h"

#include <QJsonObject>

namespace trex {

class Metrics;
class ScriptPlayer;

/// The report of a script as the contract of the offscreen test mode words it.
[[nodiscard]] QJsonObject reportOf(const ScriptPlayer& player, const Metrics& metrics);

/// Whole or not at all. Errors: FileUnwritable.
[[nodiscard]] Result<void> writeReport(const QString& path, const QJsonObject& report);

} // namespace trex
