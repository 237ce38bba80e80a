// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/benchresult.h"

namespace trex::bench {

void measureStore(Results& results); ///< bytes a sample, append and query times
void measurePlot(Results& results); ///< frame time, against Qt Charts' own series in the same run
void measurePrograms(Results& results); ///< start, memory, processor time of trexpanel
void measureRecording(Results& results); ///< bytes a value, processor time, opening a day
void measureLines(Results& results); ///< transactions a second on paced lines
void measureStop(Results& results); ///< from the request to the last stop byte, under load
/// A bare chart window, painted once; prints the milliseconds since the process started.
[[nodiscard]] int runBareChart();

} // namespace trex::bench
