// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/parameters/parametermodel.h"

namespace trex {

/// The help text of a parameter as it stands now, as rich text.
[[nodiscard]] QString parameterHelp(const ParameterModel& model, const ParameterRow& row);

} // namespace trex
