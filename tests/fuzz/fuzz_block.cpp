// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of recordings: any bytes as one of any source, with any number of samples; and samples
// made of any bytes, written and read.
#include "protocol/storage/recordingblock.h"
#include "tests/fuzz/fuzzing.h"

#include <algorithm>

using namespace trex;
using fuzz::holds;

namespace {

Source anySource(fuzz::Input& input)
{
    return kSources[std::size_t(input.below(int(kSourceCount)))].source;
}

void checkRun(Source source, const SampleRun& run)
{
    const std::size_t columns = streamsOf(source).size();
    holds(run.values.size() == run.size() * columns, "each sample has all its values");
    holds(std::ranges::is_sorted(run.ticks), "time does not run backwards");
    holds(run.isEmpty() || (run.ticks.front() >= -kLargestTick && run.ticks.back() <= kLargestTick),
          "times are times");
    holds(std::ranges::is_sorted(run.gaps) && std::ranges::adjacent_find(run.gaps) == run.gaps.end()
              && (run.gaps.empty() || run.gaps.back() < run.size()),
          "gaps are before samples, one each");
    for (const ColumnSummary& summary : summarise(source, run)) {
        holds(summary.valid <= run.size() && summary.sum <= summary.valid * 0xFFFF,
              "a summary is of these samples");
    }
}

void roundTrip(Source source, const SampleRun& run)
{
    for (const bool isFinal : {false, true}) {
        const auto again = decodeBlock(source, encodeBlock(source, run, isFinal), run.size());
        holds(again.has_value() && *again == run, "samples that were written are read");
    }
}

void read(fuzz::Input& input, Source source)
{
    const auto samples = static_cast<std::size_t>(input.word());
    const auto run = decodeBlock(source, input.rest(), samples);
    if (run) {
        holds(run->size() == samples, "as many samples as were said");
        checkRun(source, *run);
        roundTrip(source, *run);
    }
}

void write(fuzz::Input& input, Source source)
{
    SampleRun run;
    Tick tick = (input.word() - 0x8000) * Tick(1000);
    while (!input.isAtEnd() && run.size() < kBlockSamples) {
        const int bits = input.byte();
        tick += (bits & 1) != 0 ? input.word() : 1250;
        if ((bits & 2) != 0) {
            run.gaps.push_back(run.size());
        }
        run.ticks.push_back(tick);
        for (const int stream : streamsOf(source)) {
            const StreamRow& row = streams()[std::size_t(stream)];
            const int value = row.width == ValueWidth::Word ? input.word() : input.byte();
            run.values.push_back(static_cast<std::uint16_t>(
                row.encoding == StreamEncoding::SignMagnitude ? value % (2 * kFullSpeed + 1)
                                                              : value));
        }
    }
    checkRun(source, run);
    if (!run.isEmpty()) {
        roundTrip(source, run);
    }
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/)
{
    qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {});
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    const int kind = input.byte();
    const Source source = anySource(input);
    if (kind == 'w') {
        write(input, source);
    } else {
        read(input, source);
    }
    return 0;
}
