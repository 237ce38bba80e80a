// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/benchresult.h"

namespace trex::bench {

void measureStore(Results& results); ///< bytes a sample, append and query times
void measurePlot(Results& results); ///< frame time at any length, against QCustomPlot and the floor
void measureStart(Results& results); ///< of trexpanel, to its first full window
void measureProcessor(Results& results); ///< processor time and memory of trexpanel at work
void measureRecording(Results& results); ///< bytes a value, processor time, opening a day
void measureLines(Results& results); ///< transactions a second on paced lines
void measureStop(Results& results); ///< from the request to the last stop byte, under load
/// The real program with this recording: to its window, and until every sample is loaded.
void measureOpening(const QString& recording, Results& results);
/// A bare chart window, painted once; prints the milliseconds since the process started.
[[nodiscard]] int runBareChart();

} // namespace trex::bench
