// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/plotreferences.h"

#include "protocol/telemetry/streamtable.h"

#include <algorithm>

namespace trex {

namespace {

constexpr std::array<std::string_view, 3> kCommandStreams{"motor1-command", "motor2-command",
                                                          "aux-command"};

bool isZero(const StreamRow& row, int stored)
{
    return stored + row.offset == 0;
}

/// True when the sample leaves zero, or is the first that anybody knows of. (Orders are sampled as
/// they leave, each after what was in force until then.)
bool isStep(const TimeSeries& series, const StreamRow& row, std::size_t index)
{
    const bool isSpeed = series.isValid(index) && !isZero(row, series.value(index));
    return isSpeed && index > series.first() && !series.axis().hasGapBetween(index - 1, index)
        && (!series.isValid(index - 1) || isZero(row, series.value(index - 1)));
}

} // namespace

PlotReferences::~PlotReferences() = default;

int PlotReferences::add(std::unique_ptr<const TelemetryStore> store, const QString& name,
                        Instant origin, double amperesPerCount)
{
    Run run;
    run.id = m_nextId++;
    run.command = firstCommandStep(*store, origin);
    run.store = std::move(store);
    run.name = name;
    run.origin = origin;
    run.amperesPerCount = amperesPerCount;
    m_runs.push_back(std::move(run));
    emit changed();
    return m_runs.back().id;
}

void PlotReferences::remove(int id)
{
    if (std::erase_if(m_runs, [id](const Run& run) { return run.id == id; }) > 0) {
        emit changed();
    }
}

void PlotReferences::clear()
{
    m_runs.clear();
    emit changed();
}

PlotReferences::Run* PlotReferences::find(int id)
{
    const auto found =
        std::find_if(m_runs.begin(), m_runs.end(), [id](const Run& run) { return run.id == id; });
    return found == m_runs.end() ? nullptr : &*found;
}

const PlotReferences::Run* PlotReferences::run(int id) const
{
    const auto found =
        std::find_if(m_runs.begin(), m_runs.end(), [id](const Run& run) { return run.id == id; });
    return found == m_runs.end() ? nullptr : &*found;
}

void PlotReferences::rename(int id, const QString& name)
{
    if (Run* run = find(id)) {
        run->name = name;
        emit changed();
    }
}

void PlotReferences::setVisible(int id, bool visible)
{
    if (Run* run = find(id)) {
        run->isVisible = visible;
        emit changed();
    }
}

void PlotReferences::setOffset(int id, Duration offset)
{
    if (Run* run = find(id); run != nullptr && run->offset != offset) {
        run->offset = offset;
        emit moved();
    }
}

void PlotReferences::setTrigger(int id, std::optional<Instant> trigger)
{
    if (Run* run = find(id); run != nullptr && run->trigger != trigger) {
        run->trigger = trigger;
        emit moved();
    }
}

void PlotReferences::setAlignment(Alignment alignment)
{
    if (m_alignment != alignment) {
        m_alignment = alignment;
        emit changed();
    }
}

void PlotReferences::setAnchor(Alignment alignment, std::optional<Instant> anchor)
{
    auto& present = m_anchors.at(static_cast<std::size_t>(alignment));
    if (present != anchor) {
        present = anchor;
        if (alignment == m_alignment && !m_runs.empty()) {
            emit moved();
        }
    }
}

std::optional<Duration> PlotReferences::shiftOf(const Run& run) const
{
    const auto& anchor = m_anchors.at(static_cast<std::size_t>(m_alignment));
    std::optional<Instant> own = run.origin;
    if (m_alignment == Alignment::Trigger) {
        own = run.trigger;
    } else if (m_alignment == Alignment::Command) {
        own = run.command;
    }
    if (!anchor || !own) {
        return std::nullopt;
    }
    return *anchor - *own + run.offset;
}

std::unique_ptr<TelemetryStore> copyOf(const TelemetryStore& store, Instant from, Instant to)
{
    auto copy = std::make_unique<TelemetryStore>();
    for (const SourceRow& source : kSources) {
        std::vector<int> indices;
        for (std::size_t i = 0; i < streams().size(); ++i) {
            if (streams()[i].source == source.source) {
                indices.push_back(static_cast<int>(i));
            }
        }
        if (indices.empty()) {
            continue;
        }
        const TimeSeries& first = store.series(indices.front());
        const auto [begin, end] = first.range(from, to);
        for (std::size_t i = begin; i < end; ++i) {
            if (i > begin && first.axis().hasGapBetween(i - 1, i)) {
                copy->markGap(source.source);
            }
            std::array<std::uint16_t, kMostValues> raw{};
            for (const int index : indices) {
                const StreamRow& row = streams()[static_cast<std::size_t>(index)];
                raw.at(static_cast<std::size_t>(row.field)) =
                    rawFromStored(row, store.series(index).value(i));
            }
            copy->append(source.source, raw, first.time(i));
        }
    }
    return copy;
}

std::optional<Instant> firstCommandStep(const TelemetryStore& store, Instant from)
{
    std::optional<Instant> first;
    for (const std::string_view key : kCommandStreams) {
        const int index = streamIndex(key);
        if (index < 0) {
            continue;
        }
        const TimeSeries& series = store.series(index);
        const StreamRow& row = streams()[static_cast<std::size_t>(index)];
        for (std::size_t i = series.range(from, from).first; i < series.size(); ++i) {
            if (isStep(series, row, i)) {
                first = std::min(first.value_or(series.time(i)), series.time(i));
                break;
            }
        }
    }
    return first;
}

std::optional<Instant> lastCommandStep(const TelemetryStore& store, Instant to)
{
    std::optional<Instant> last;
    for (const std::string_view key : kCommandStreams) {
        const int index = streamIndex(key);
        if (index < 0) {
            continue;
        }
        const TimeSeries& series = store.series(index);
        const StreamRow& row = streams()[static_cast<std::size_t>(index)];
        for (std::size_t i = series.range(to, to).first; i-- > series.first();) {
            if (isStep(series, row, i)) {
                last = std::max(last.value_or(series.time(i)), series.time(i));
                break;
            }
            if (last && series.time(i) < *last) {
                break;
            }
        }
    }
    return last;
}

} // namespace trex
