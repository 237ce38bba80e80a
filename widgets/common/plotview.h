// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/common/plotticks.h"
#include "widgets/common/plottimeline.h"
#include "widgets/common/theme.h"

#include <QChartView>

#include <memory>

class QValueAxis;

namespace trex {

class FrameTicker;
class PlotInput;
class PlotOverlay;
class PlotReferences;
class PlotTrace;
struct PlotFrame;
/// A live plot of streams of the store over time. Qt Charts gives the chart, its value axis, legend
/// and layout; the traces and what lies over them are ours (PlotTrace, PlotOverlay). Its part of
/// time is its PlotTimeline's, which plots can share. Mouse and keys: PlotInput. Repaints at most
/// once a tick, and only what is new and visible. GUI thread.
class PlotView : public QChartView {
    Q_OBJECT
    Q_PROPERTY(bool paused READ isPaused WRITE setPaused NOTIFY pausedChanged)
    Q_PROPERTY(int windowSeconds READ windowSeconds WRITE setWindowSeconds NOTIFY viewChanged)
    Q_PROPERTY(double fromSeconds READ fromSeconds)
    Q_PROPERTY(double toSeconds READ toSeconds)
    Q_PROPERTY(double top READ top)
    Q_PROPERTY(double bottom READ bottom)

public:
    static constexpr int kWholeSession = PlotTimeline::kWholeSession;
    using Clock = PlotTimeline::Clock;
    /// `shared`: shows the same part of time as others; null: its own.
    PlotView(const TelemetryStore& store, FrameTicker& ticker, QWidget* parent = nullptr,
             PlotTimeline* shared = nullptr);
    ~PlotView() override;
    Q_DISABLE_COPY_MOVE(PlotView)
    /// Adds a stream of streamtable.h under its title; gives the curve's number, from 0 on. The
    /// numbers of later curves go down when one is removed.
    int addCurve(std::string_view streamKey, ColourRole colour);
    void removeCurve(int curve);
    [[nodiscard]] int curveCount() const { return static_cast<int>(m_colours.size()); }
    void setCurveScale(int curve, double scale); ///< physical = (stored + offset) × scale
    void setCurveVisible(int curve, bool visible);
    [[nodiscard]] bool isCurveVisible(int curve) const;
    void setCurveColour(int curve, ColourRole colour);
    void setCurveWidth(int curve, double pixels);
    void setUnit(const QString& unit); ///< shown at the value axis
    void setSmallestTop(double physical); ///< the value axis spans at least so much
    void setFoot(ticks::AxisRange::Foot foot, double smallest); ///< zero unless told otherwise
    struct Limit {
        double physical = 0.0;
        QString text;
        ColourRole colour = ColourRole::Warning;
    };
    void setLimits(const std::vector<Limit>& limits); ///< dashed lines with their names
    void setReferences(const PlotReferences* references); ///< drawn behind; null: none
    /// The trigger's level, a line that can be dragged (none: its source is not here), and where it
    /// was crossed last.
    void setTrigger(std::optional<double> level, std::optional<Instant> crossing);
    [[nodiscard]] PlotTimeline& timeline() const { return *m_timeline; }
    void setWindowSeconds(int seconds) { m_timeline->setWindowSeconds(seconds); }
    [[nodiscard]] int windowSeconds() const { return m_timeline->windowSeconds(); }
    void setPaused(bool paused) { m_timeline->setPaused(paused); }
    [[nodiscard]] bool isPaused() const { return m_timeline->isPaused(); }
    void setLive(bool live); ///< data is expected now: time goes on, and silence shows as such
    void setMessage(const QString& message); ///< said in the plot; "" for none
    enum class Tool { Zoom, Pan };
    void setTool(Tool tool); ///< what dragging with the left button does
    void fit() { m_timeline->fit(); } ///< everything recorded, values fitted
    void follow() { m_timeline->follow(); } ///< the newest, in the window's length, values fitted
    void zoomTime(double factor, double about = 0.5) { m_timeline->zoom(factor, about); }
    void zoomValues(double factor, double about = 0.0); ///< about: 0 bottom to 1 top
    void panValues(double part);
    [[nodiscard]] bool areValuesByHand() const; ///< zoomed: they do not fit themselves
    void zoomInto(const QRectF& box); ///< scene coordinates
    // In a stack of plots:
    void setPlaceInStack(bool isTop, bool isBottom); ///< who shows times, who signs of marks
    void setLegendShown(bool shown);
    [[nodiscard]] double axisExtent() const { return m_ownExtent; } ///< pixels of the value axis
    void setAxisExtent(double pixels); ///< takes at least so many: areas of a stack line up
    [[nodiscard]] const PlotFrame& frame() const { return *m_frame; }
    [[nodiscard]] const PlotOverlay& overlay() const { return *m_overlay; }
    [[nodiscard]] TimeRange visibleRange() const { return m_timeline->range(); }
    [[nodiscard]] double fromSeconds() const; ///< left edge, seconds since the store's start
    [[nodiscard]] double toSeconds() const;
    [[nodiscard]] double top() const;
    [[nodiscard]] double bottom() const;
    [[nodiscard]] QImage picture(double scale = 2.0); ///< as shown, at a multiple of its size
    void setClock(Clock clock); ///< the steady clock unless told otherwise (tests)
    void setRubberBand(const QRectF& box);
    void refresh(); ///< draws what is new, if there is something and it can be seen
    void redraw(); ///< now, whether new or not

signals:
    void pausedChanged(bool paused);
    void viewChanged(); ///< what is visible changed by the person's doing
    void axisExtentChanged();
    void levelDragged(double physical);
    void focused(); ///< the person turned to this plot

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    void buildChart();
    void applyColours();
    void applyValueAxis();
    void applyMargins();
    void noteAxisExtent();
    void place(); ///< the part of time that is due, into the frame
    void fitValues(bool atOnce);
    void fillReferences();
    [[nodiscard]] PlotTimeline::ValueRange valueExtent() const;

    PlotTimeline* m_timeline; ///< ours as a child, or shared
    FrameTicker& m_ticker;
    QValueAxis* m_valueAxis;
    QValueAxis* m_timeAxis; ///< hidden: our labels move with the trace
    PlotTrace* m_trace; ///< owned by the scene, as the next
    PlotOverlay* m_overlay;
    std::unique_ptr<PlotFrame> m_frame;
    std::unique_ptr<PlotInput> m_input;
    std::vector<ColourRole> m_colours; ///< of the curves
    std::vector<Limit> m_limits;
    const PlotReferences* m_references = nullptr;
    QString m_unit;
    ticks::AxisRange m_range{1.0};
    int m_number; ///< at the timeline
    double m_ownExtent = 0.0; ///< pixels that the value axis takes
    double m_axisExtent = 0.0; ///< that it shall take at least
    quint64 m_drawnRevision = 0; ///< what the last frame showed
    quint64 m_drawnMarks = 0;
    int m_drawnClears = 0;
    std::optional<Instant> m_drawnTo; ///< the newest sample of its curves then
    std::optional<Instant> m_drawnAt;
};

} // namespace trex
