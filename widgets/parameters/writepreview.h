// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/configtransfer.h"
#include "widgets/parameters/parametermodel.h"

namespace trex {

/// Exactly what Apply will write: each setting, old → new, with the bytes of its packet on this
/// line; then what waits for a power cycle, what to know about it, and what is left out.
[[nodiscard]] QString writePreview(const TransferPlan& plan, const ParameterModel& model,
                                   const LineSettings& line);

} // namespace trex
