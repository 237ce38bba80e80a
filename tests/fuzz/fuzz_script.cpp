// SPDX-License-Identifier: GPL-3.0-or-later
// Scripts of the offscreen mode: any bytes as one. It is read only, never played.
#include "app/script/scriptactions.h"
#include "app/script/scriptfile.h"
#include "tests/fuzz/sentence.h"

using namespace trex;
using fuzz::holds;

namespace {

void checkSteps(const std::vector<ScriptStep>& steps, int depth)
{
    holds(depth <= 10, "repeats have a bottom");
    for (const ScriptStep& step : steps) {
        holds(step.action != nullptr && step.action->check(step.argument).isEmpty(),
              "each step has an action that can be tried");
        holds(!step.timeoutMs || *step.timeoutMs >= 0, "no time to wait is below 0");
        checkSteps(step.steps, depth + 1);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const auto read = parseScript(input.rest(), fuzz::fileName());
    if (!read) {
        fuzz::holdsSentence(read.error());
        return 0;
    }
    checkSteps(read->steps, 0);
    return 0;
}
