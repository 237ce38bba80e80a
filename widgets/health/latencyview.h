// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/linkhealth.h"

#include <QWidget>

namespace trex {

/// How long answers took: bars over a logarithmic time axis, their number on a logarithmic axis too
/// (one answer in a thousand is to be seen), with median, 99 % and the longest marked, and as a
/// stepped line what the wire alone would take. GUI thread.
class LatencyView : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(LatencyView)
    Q_PROPERTY(double medianMs READ medianMs)
    Q_PROPERTY(int answers READ answers)

public:
    explicit LatencyView(QWidget* parent = nullptr);
    void show(const HealthCounts& counts);
    [[nodiscard]] double medianMs() const; ///< 0: no answers
    [[nodiscard]] int answers() const { return static_cast<int>(m_trips.total()); }
    [[nodiscard]] QSize sizeHint() const override { return {360, 220}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override; ///< tool tip: the bar under the pointer

private:
    struct Scale;
    [[nodiscard]] Scale scale() const;
    void paintAxes(QPainter& painter, const Scale& scale) const;
    void paintBars(QPainter& painter, const Scale& scale) const;
    void paintWire(QPainter& painter, const Scale& scale) const;
    void paintMarks(QPainter& painter, const Scale& scale) const;
    void paintLegend(QPainter& painter, const Scale& scale) const;

    LatencyHistogram m_trips;
    LatencyHistogram m_wire;
};

} // namespace trex
