// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/csvexport.h"
#include "widgets/common/plotticks.h"
#include "widgets/common/theme.h"

#include <QChartView>

#include <functional>
#include <memory>

class QValueAxis;

namespace trex {

class FrameTicker;
class PlotTrace;
struct PlotFrame;

/// A live plot of streams of the store over time. Qt Charts gives the chart, its value axis, legend
/// and layout; the traces are ours (PlotTrace). Follows the newest sample, or stands still while
/// data goes on behind (paused). Mouse: wheel zooms time about the cursor (Ctrl: values), dragging
/// zooms into a box, middle or Shift drag pans, double click follows again. Keys: arrows pan, + and
/// − zoom (Ctrl: values), Home start, End follow, F everything, P pause. Repaints at most once a
/// tick, and only when there is something new and it is visible. GUI thread.
class PlotView : public QChartView {
    Q_OBJECT
    Q_PROPERTY(bool paused READ isPaused WRITE setPaused NOTIFY pausedChanged)
    Q_PROPERTY(int windowSeconds READ windowSeconds WRITE setWindowSeconds NOTIFY viewChanged)
    Q_PROPERTY(double fromSeconds READ fromSeconds)
    Q_PROPERTY(double toSeconds READ toSeconds)
    Q_PROPERTY(double top READ top)
    Q_PROPERTY(double bottom READ bottom)

public:
    static constexpr int kWholeSession = 0;
    using Clock = std::function<Instant()>;

    PlotView(const TelemetryStore& store, FrameTicker& ticker, QWidget* parent = nullptr);
    ~PlotView() override;
    Q_DISABLE_COPY_MOVE(PlotView)

    /// Adds a stream of streamtable.h under its title; gives the curve's number.
    int addCurve(std::string_view streamKey, ColourRole colour);
    void setCurveScale(int curve, double scale); ///< physical = (stored + offset) × scale
    void setCurveVisible(int curve, bool visible);
    [[nodiscard]] bool isCurveVisible(int curve) const;
    void setUnit(const QString& unit); ///< shown at the value axis
    void setSmallestTop(double physical); ///< the value axis ends at least here

    void setWindowSeconds(int seconds); ///< length of time shown; kWholeSession: all there is
    [[nodiscard]] int windowSeconds() const { return m_windowSeconds; }
    void setPaused(bool paused);
    [[nodiscard]] bool isPaused() const { return m_paused; }
    /// True: data is expected now, so that time goes on (and silence shows as such).
    void setLive(bool live);
    void setMessage(const QString& message); ///< said in the plot; "" for none

    void fit(); ///< everything recorded, values fitted
    void follow(); ///< the newest, in the window's length, values fitted
    void zoomTime(double factor, double about = 0.5); ///< below 1: closer; about: 0 left to 1 right
    void zoomValues(double factor, double about = 0.0); ///< about: 0 bottom to 1 top
    void pan(double timePart, double valuePart); ///< in parts of what is visible
    void showStart();

    [[nodiscard]] TimeRange visibleRange() const;
    [[nodiscard]] double fromSeconds() const; ///< left edge, seconds since the store's start
    [[nodiscard]] double toSeconds() const;
    [[nodiscard]] double top() const;
    [[nodiscard]] double bottom() const;
    [[nodiscard]] QImage picture(double scale = 2.0); ///< as shown, at a multiple of its size
    void setClock(Clock clock); ///< the steady clock unless told otherwise (tests)

public slots:
    void refresh(); ///< draws what is new, if there is something and it can be seen

signals:
    void pausedChanged(bool paused);
    void viewChanged(); ///< what is visible changed by the person's doing

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    enum class Drag { None, Box, Pan };
    void buildChart();
    void applyColours();
    void applyValueAxis();
    void place(); ///< the part of time that is due, into the frame
    void fitValues(bool atOnce);
    void redraw(); ///< now, whether new or not
    void stand(Instant from, Duration span); ///< pauses at a part of time
    void zoomInto(const QRectF& box);
    [[nodiscard]] bool panByKey(const QKeyEvent& event);
    [[nodiscard]] Instant rightEdge() const;
    [[nodiscard]] std::optional<Instant> lastSample() const;
    [[nodiscard]] QPointF inScene(const QPointF& position) const;

    const TelemetryStore& m_store;
    FrameTicker& m_ticker;
    Clock m_clock;
    QValueAxis* m_valueAxis;
    QValueAxis* m_timeAxis; ///< hidden: our labels move with the trace
    PlotTrace* m_trace; ///< owned by the scene
    std::unique_ptr<PlotFrame> m_frame;
    std::vector<ColourRole> m_colours; ///< of the curves
    QString m_unit;
    ticks::AxisTop m_top{1.0};
    int m_windowSeconds = 10;
    bool m_paused = false;
    bool m_live = false;
    bool m_valuesByHand = false; ///< zoomed: the value axis stays as it is
    Drag m_drag = Drag::None;
    QPointF m_dragFrom;
    quint64 m_drawnRevision = 0;
    std::optional<Instant> m_drawnAt;
};

} // namespace trex
