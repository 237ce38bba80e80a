// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/plottimeline.h"

#include "protocol/telemetry/marktrack.h"
#include "protocol/telemetry/streamtable.h"

#include <algorithm>

namespace trex {

using namespace std::chrono_literals;

namespace {

constexpr Duration kShortestSession = 10s; ///< "whole session" shows at least this much
constexpr Duration kShortestSpan = 20ms;
constexpr Duration kLongestSpan = std::chrono::hours(24 * 400);
constexpr Duration kOneStep = 700ms; ///< steps of one kind closer than this are one change
constexpr std::size_t kMostViews = 200;

Duration scaled(Duration duration, double factor)
{
    return std::chrono::duration_cast<Duration>(
        std::chrono::duration<double, std::nano>(static_cast<double>(duration.count()) * factor));
}

} // namespace

PlotTimeline::PlotTimeline(const TelemetryStore& store, QObject* parent)
    : QObject(parent)
    , m_store(store)
    , m_clock([&store] { return store.now(); })
    , m_cursors(kCursors)
{
    place();
}

void PlotTimeline::setClock(Clock clock)
{
    m_clock = std::move(clock);
    place();
}

std::optional<Instant> PlotTimeline::lastSample() const
{
    std::optional<Instant> last;
    for (std::size_t i = 0; i < streams().size(); ++i) {
        const TimeSeries& series = m_store.series(static_cast<int>(i));
        if (!series.isEmpty()) {
            const Instant time = TimeAxis::instantOf(series.axis().lastTick());
            last = std::max(last.value_or(time), time);
        }
    }
    return last;
}

Instant PlotTimeline::rightEdge() const
{
    return m_isLive ? now() : lastSample().value_or(now());
}

void PlotTimeline::place()
{
    m_origin = m_store.start().value_or(rightEdge());
    if (m_view.isPaused) {
        return;
    }
    if (m_capture) {
        m_view.from = m_capture->from;
        m_view.span = m_capture->to - m_capture->from;
        return;
    }
    const Instant right = rightEdge();
    const Instant oldest = m_store.oldest().value_or(m_origin); // the rest has left the memory
    m_view.span = std::chrono::seconds(m_view.windowSeconds);
    if (m_view.windowSeconds == kWholeSession) {
        m_view.span = std::max<Duration>(right - oldest, kShortestSession);
    }
    m_view.from = right - m_view.span;
    if (m_view.windowSeconds == kWholeSession && m_view.from < oldest) {
        m_view.from = oldest;
    }
}

void PlotTimeline::remember(Step step)
{
    place();
    const Instant time = now();
    const bool goesOn = step != Step::Other && step == m_lastStep && m_lastStepAt
        && time - *m_lastStepAt < kOneStep;
    m_lastStep = step;
    m_lastStepAt = time;
    if (goesOn) {
        return;
    }
    if (m_back.size() >= kMostViews) {
        m_back.erase(m_back.begin());
    }
    m_back.push_back(m_view);
    m_forward.clear();
}

void PlotTimeline::apply(const View& view)
{
    const bool wasPaused = std::exchange(m_view, view).isPaused;
    place();
    if (wasPaused != m_view.isPaused) {
        emit pausedChanged(m_view.isPaused);
    }
    emit viewChanged();
}

void PlotTimeline::travel(std::vector<View>& from, std::vector<View>& to)
{
    if (from.empty()) {
        return;
    }
    place();
    to.push_back(m_view);
    const View view = from.back();
    from.pop_back();
    m_lastStepAt.reset();
    apply(view);
}

void PlotTimeline::back()
{
    travel(m_back, m_forward);
}

void PlotTimeline::forward()
{
    travel(m_forward, m_back);
}

void PlotTimeline::setWindowSeconds(int seconds)
{
    View view = m_view;
    view.windowSeconds = seconds;
    if (m_view.isPaused) { // the right edge stays, so that what was paused at is still seen
        const Instant right = m_view.from + m_view.span;
        if (seconds == kWholeSession) {
            view.from = m_store.oldest().value_or(right - kShortestSession);
            view.span = std::max<Duration>(rightEdge() - view.from, kShortestSession);
        } else {
            view.span = std::chrono::seconds(seconds);
            view.from = right - view.span;
        }
    }
    apply(view);
}

void PlotTimeline::setPaused(bool paused)
{
    if (m_view.isPaused != paused) {
        place();
        View view = m_view;
        view.isPaused = paused;
        apply(view);
    }
}

void PlotTimeline::setLive(bool live)
{
    m_isLive = live;
}

void PlotTimeline::setCapture(std::optional<TimeRange> capture)
{
    m_capture = capture;
    place();
}

void PlotTimeline::moveTo(Instant from, Duration span)
{
    View view = m_view;
    view.from = from;
    view.span = std::clamp(span, kShortestSpan, kLongestSpan);
    view.isPaused = true;
    apply(view);
}

void PlotTimeline::stand(Instant from, Duration span)
{
    remember(Step::Other);
    moveTo(from, span);
}

void PlotTimeline::zoom(double factor, double about)
{
    remember(Step::Zoom);
    const Duration span = std::clamp(scaled(m_view.span, factor), kShortestSpan, kLongestSpan);
    const Instant pivot = m_view.from + scaled(m_view.span, about);
    moveTo(pivot - scaled(span, about), span);
}

void PlotTimeline::pan(double part)
{
    remember(Step::Pan);
    moveTo(m_view.from + scaled(m_view.span, part), m_view.span);
}

void PlotTimeline::fit()
{
    remember(Step::Other);
    m_view.values.clear();
    const Instant right = rightEdge();
    const Instant from = m_store.oldest().value_or(right);
    moveTo(from, std::max<Duration>(right - from, 1s));
}

void PlotTimeline::follow()
{
    remember(Step::Other);
    View view = m_view;
    view.values.clear();
    view.isPaused = false;
    apply(view);
}

void PlotTimeline::showStart()
{
    remember(Step::Other);
    moveTo(m_store.oldest().value_or(m_view.from), m_view.span);
}

void PlotTimeline::show(Instant moment)
{
    place();
    constexpr int kMargin = 20; // a twentieth of what is visible
    const Duration margin = m_view.span / kMargin;
    if (!m_view.isPaused || moment < m_view.from + margin
        || moment > m_view.from + m_view.span - margin) {
        remember(Step::Other);
        moveTo(moment - m_view.span / 2, m_view.span);
    }
}

std::optional<PlotTimeline::ValueRange> PlotTimeline::values(int plot) const
{
    const auto found = m_view.values.constFind(plot);
    return found == m_view.values.constEnd() ? std::nullopt : std::optional(*found);
}

void PlotTimeline::setValues(int plot, const ValueRange& range)
{
    remember(Step::Values);
    m_view.values.insert(plot, range);
    emit viewChanged();
}

void PlotTimeline::setView(int plot, const ValueRange& range, Instant from, Duration span)
{
    remember(Step::Other);
    m_view.values.insert(plot, range);
    moveTo(from, span);
}

void PlotTimeline::freeValues()
{
    if (!m_view.values.isEmpty()) {
        remember(Step::Other);
        m_view.values.clear();
        emit viewChanged();
    }
}

void PlotTimeline::setCursor(int index, std::optional<Instant> time)
{
    auto& cursor = m_cursors.at(static_cast<std::size_t>(index));
    if (cursor != time) {
        cursor = time;
        emit cursorsChanged();
    }
}

void PlotTimeline::clearCursors()
{
    std::fill(m_cursors.begin(), m_cursors.end(), std::nullopt);
    m_activeCursor = 0;
    emit cursorsChanged();
}

void PlotTimeline::setActiveCursor(int index)
{
    if (m_activeCursor != index) {
        m_activeCursor = index;
        emit cursorsChanged();
    }
}

std::optional<TimeRange> PlotTimeline::measured() const
{
    const auto& first = m_cursors.front();
    const auto& second = m_cursors.back();
    if (!first || !second) {
        return std::nullopt;
    }
    return TimeRange{std::min(*first, *second), std::max(*first, *second)};
}

void PlotTimeline::showNextMark()
{
    place();
    const bool isSeen = m_shownMark && *m_shownMark >= from() && *m_shownMark <= from() + span();
    const Instant here = isSeen ? *m_shownMark : from() + span() / 2;
    if (const Mark* mark = m_marks != nullptr ? m_marks->after(here) : nullptr) {
        showMark(mark->time);
    }
}

void PlotTimeline::showPreviousMark()
{
    place();
    const bool isSeen = m_shownMark && *m_shownMark >= from() && *m_shownMark <= from() + span();
    const Instant here = isSeen ? *m_shownMark : from() + span();
    if (const Mark* mark = m_marks != nullptr ? m_marks->before(here) : nullptr) {
        showMark(mark->time);
    }
}

void PlotTimeline::showMark(Instant time)
{
    m_shownMark = time;
    show(time);
    emit cursorsChanged();
}

} // namespace trex
