// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/benchreport.h"

namespace trex {

/// The report as PDF, A4, with its plots as lines and not as pixels. Whole or not at all. Errors:
/// FileUnwritable.
[[nodiscard]] Result<void> savePdf(const QString& path, const BenchOutcome& outcome,
                                   const BenchReport& report);

} // namespace trex
