// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/replay.h"

#include "app/trexctl/failure.h"
#include "protocol/storage/recordingreader.h"

namespace trex {
namespace {

/// Only where the number changes.
sim::Trace traceOf(const TimeSeries& series, Instant start)
{
    sim::Trace trace;
    for (std::size_t i = series.first(); i < series.size(); ++i) {
        const auto raw = static_cast<std::uint16_t>(series.value(i));
        if (trace.points.empty() || trace.points.back().second != raw) {
            const std::chrono::duration<double> since = series.time(i) - start;
            trace.points.emplace_back(since.count(), raw);
        }
    }
    return trace;
}

/// The settings that the controller had at the start. Those of the line stay as they are, so that
/// whoever connects finds it; what --param says comes first.
void applySettings(RecordingReader& reader, sim::SimOptions& options)
{
    const auto configurations = reader.configurations();
    if (configurations.empty()) {
        return;
    }
    // The first that is whole: a recording may begin before everything was read.
    const auto whole = std::max_element(
        configurations.begin(), configurations.end(),
        [](const RecordedConfiguration& a, const RecordedConfiguration& b) {
            return a.configuration.parameters.size() < b.configuration.parameters.size();
        });
    for (const auto& [number, raw] : whole->configuration.parameters) {
        const bool isOfLine = number == parameterRow("device-number").number
            || number == parameterRow("uart-settings").number
            || number == parameterRow("crc7-polynomial").number;
        if (!isOfLine) {
            options.parameters.emplace(number, raw);
        }
    }
}

} // namespace

Result<void> replayRecording(const QString& path, sim::SimOptions& options)
{
    sim::Scenario& scenario = options.scenario;
    const auto reader = RecordingReader::open(path);
    if (!reader) {
        return tl::make_unexpected(reader.error());
    }
    TelemetryStore store;
    (*reader)->loadAll(store, Instant());
    const auto range = (*reader)->range();
    const Instant start = range ? TimeAxis::instantOf(range->first) : Instant();
    bool isAnything = false;
    for (std::size_t i = 0; i < streams().size(); ++i) {
        const StreamRow& row = streams()[i];
        const TimeSeries& series = store.series(static_cast<int>(i));
        if (row.source == PollId::RawChannels) {
            scenario.channelTraces.at(std::size_t(row.field)) = traceOf(series, start);
        } else if (row.source == PollId::Currents) {
            scenario.currentTraces.at(std::size_t(row.field)) = traceOf(series, start);
        } else {
            continue;
        }
        isAnything = isAnything || !series.isEmpty();
    }
    applySettings(**reader, options);
    if (!isAnything) {
        return fail(ErrorCode::FileMalformed,
                    QStringLiteral("%1: %2").arg(
                        path, Cli::tr("neither channels nor currents were recorded")));
    }
    return {};
}

} // namespace trex
