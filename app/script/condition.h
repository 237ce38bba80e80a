// SPDX-License-Identifier: GPL-3.0-or-later
// {"object", "property", and one of "equals", "matches", "min", "max"}: what waitFor, expect and
// repeat look at.
#pragma once

#include <QJsonValue>
#include <QString>

namespace trex {

/// What makes no sense in it; empty: nothing.
[[nodiscard]] QString conditionProblem(const QJsonValue& condition);

/// Empty when it holds now; else a sentence that says what is there instead.
[[nodiscard]] QString unmetCondition(const QJsonValue& condition);

} // namespace trex
