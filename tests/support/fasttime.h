// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trex::test {

/// The whole process lives in a faster time: its clocks, timers and waits go `factor` times as fast
/// as those of the computer, so that what takes a person's minutes takes seconds of a test's, with
/// the real worker, timers and simulator. Link fasttime.cpp to the test and call this before
/// anything else in main(); TREX_TEST_SPEED overrides the factor (1: as fast as the computer).
void makeTimeFaster(double factor);

} // namespace trex::test
