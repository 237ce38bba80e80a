// SPDX-License-Identifier: GPL-3.0-or-later
// Times since this process began, and the most memory that it had: the operating system knows.
#pragma once

#include <QtGlobal>

namespace trex::processclock {

/// Monotonic. The first call asks the system for the age of the process; make it early.
double sinceStartMs();
[[nodiscard]] qint64 startEpochMs(); ///< wall clock of the start
[[nodiscard]] double peakRssMiB(); ///< 0 where it is not known

} // namespace trex::processclock
