// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/benchtrace.h"
#include "protocol/storage/benchprofile.h"

namespace trex {

/// What a profile would tell the motors, waits counted to their end: orders only, no readings, and
/// at most the first `seconds`. The dry run knows more.
[[nodiscard]] BenchTrace previewOf(const BenchProfile& profile, double seconds = 3600.0);

} // namespace trex
