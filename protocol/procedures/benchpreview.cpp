// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/benchpreview.h"

#include "protocol/procedures/benchrun.h"

namespace trex {
namespace {

using namespace std::chrono_literals;

void letWaitsPass(std::vector<BenchStep>& steps)
{
    for (BenchStep& step : steps) {
        step.mustHappen = false;
        letWaitsPass(step.steps);
    }
}

} // namespace

BenchTrace previewOf(const BenchProfile& profile, double seconds)
{
    if (!validate(profile)) {
        return {};
    }
    BenchProfile patient = profile;
    letWaitsPass(patient.steps);
    patient.limits = {};
    const double length = std::min(plannedSeconds(profile), seconds);
    // Fine enough for every speed of a short test; a long one need not be finer than the screen.
    const Duration step = length > 600.0 ? 100ms : 20ms;
    BenchRun run(patient, Model::TrexJr);
    Instant now{1h};
    run.start(now, 0);
    while (!run.hasEnded() && run.seconds() <= length) {
        for (const PollId poll : {PollId::Currents, PollId::Status, PollId::SerialControl}) {
            PollSample sample{poll, {}, now};
            sample.raw.front() = poll == PollId::SerialControl ? 1 : 0;
            run.take(sample);
        }
        static_cast<void>(run.advance(now));
        now += step;
    }
    BenchTrace trace = run.trace();
    trace.seconds = std::max(run.seconds(), 0.1);
    trace.samples.clear();
    return trace;
}

} // namespace trex
