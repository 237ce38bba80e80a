// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/csvexport.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QHash>
#include <QObject>

#include <functional>

namespace trex {

class MarkTrack;

/// The part of time that one plot, or several stacked ones, show together: following the newest
/// sample, showing a trigger's capture, or standing still (paused) while data goes on behind. Keeps
/// the views that the person has seen (back, forward) and the two measuring cursors. GUI thread.
class PlotTimeline : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(PlotTimeline)

public:
    static constexpr int kWholeSession = 0;
    static constexpr int kCursors = 2;
    using Clock = std::function<Instant()>;
    using ValueRange = std::pair<double, double>; ///< low, high

    explicit PlotTimeline(const TelemetryStore& store, QObject* parent = nullptr);

    void setClock(Clock clock); ///< the steady clock unless told otherwise (tests, recordings)
    [[nodiscard]] Instant now() const { return m_clock(); }
    [[nodiscard]] const TelemetryStore& store() const { return m_store; }

    [[nodiscard]] Instant origin() const { return m_origin; } ///< second 0
    [[nodiscard]] Instant from() const { return m_view.from; }
    [[nodiscard]] Duration span() const { return m_view.span; }
    [[nodiscard]] TimeRange range() const { return {from(), from() + span()}; }
    /// Moves on to the part of time that is due now.
    void place();
    [[nodiscard]] std::optional<Instant> lastSample() const;

    void setWindowSeconds(int seconds); ///< length of time shown; kWholeSession: all there is
    [[nodiscard]] int windowSeconds() const { return m_view.windowSeconds; }
    void setPaused(bool paused);
    [[nodiscard]] bool isPaused() const { return m_view.isPaused; }
    void setLive(bool live); ///< data is expected now, so that time goes on by itself
    [[nodiscard]] bool isLive() const { return m_isLive; }
    [[nodiscard]] bool isStanding() const { return isPaused() || m_capture.has_value(); }
    /// What is shown while following, instead of the newest; none: the newest again.
    void setCapture(std::optional<TimeRange> capture);

    void stand(Instant from, Duration span); ///< pauses at a part of time
    void zoom(double factor, double about); ///< below 1: closer; about: 0 left to 1 right
    void pan(double part); ///< in parts of what is visible
    void fit(); ///< everything recorded
    void follow(); ///< the newest, in the window's length
    void showStart();
    void show(Instant moment); ///< moves it into the middle, where it is not well in sight

    /// The view before the last change, and again forward. A series of small steps is one change.
    void back();
    void forward();
    [[nodiscard]] bool canGoBack() const { return !m_back.empty(); }
    [[nodiscard]] bool canGoForward() const { return !m_forward.empty(); }

    /// Each plot has a number, under which its values are kept when they were zoomed by hand.
    [[nodiscard]] int newPlot() { return ++m_plots; }
    [[nodiscard]] std::optional<ValueRange> values(int plot) const;
    void setValues(int plot, const ValueRange& range);
    void setView(int plot, const ValueRange& range, Instant from, Duration span); ///< both at once
    void freeValues(); ///< all plots fit themselves again

    [[nodiscard]] std::optional<Instant> cursor(int index) const
    {
        return m_cursors.at(static_cast<std::size_t>(index));
    }
    void setCursor(int index, std::optional<Instant> time);
    void clearCursors();
    [[nodiscard]] int activeCursor() const { return m_activeCursor; } ///< the one that keys move
    void setActiveCursor(int index);
    /// From the earlier to the later cursor; none unless both are set.
    [[nodiscard]] std::optional<TimeRange> measured() const;

    void setMarks(const MarkTrack* marks) { m_marks = marks; } ///< null: there are none
    [[nodiscard]] const MarkTrack* marks() const { return m_marks; }
    void showNextMark();
    void showPreviousMark();
    void showMark(Instant time); ///< moves it into sight and points it out
    [[nodiscard]] std::optional<Instant> shownMark() const { return m_shownMark; }

signals:
    void pausedChanged(bool paused);
    void viewChanged(); ///< by the person's doing
    void cursorsChanged();

private:
    struct View {
        bool isPaused = false;
        int windowSeconds = 10;
        Instant from;
        Duration span{std::chrono::seconds(10)};
        QHash<int, ValueRange> values;
    };
    enum class Step { Zoom, Pan, Values, Other };
    void remember(Step step);
    void travel(std::vector<View>& from, std::vector<View>& to);
    void apply(const View& view);
    void moveTo(Instant from, Duration span);
    [[nodiscard]] Instant rightEdge() const;

    const TelemetryStore& m_store;
    Clock m_clock;
    const MarkTrack* m_marks = nullptr;
    View m_view;
    std::vector<View> m_back;
    std::vector<View> m_forward;
    Step m_lastStep = Step::Other;
    std::optional<Instant> m_lastStepAt;
    Instant m_origin;
    std::optional<TimeRange> m_capture;
    std::vector<std::optional<Instant>> m_cursors;
    std::optional<Instant> m_shownMark;
    int m_activeCursor = 0;
    int m_plots = 0;
    bool m_isLive = false;
};

} // namespace trex
