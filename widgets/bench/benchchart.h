// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/benchtrace.h"

#include <QWidget>

namespace trex {

/// A bench test over time: above, the speeds as told; below, the currents, as predicted by the dry
/// run (thin) and as measured. GUI thread.
class BenchChart : public QWidget {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(BenchChart)

public:
    explicit BenchChart(QWidget* parent = nullptr);

    void setPlan(const BenchTrace& plan); ///< orders of the profile
    void setPrediction(const BenchTrace& prediction); ///< of the dry run; empty: none
    /// Looked at while painting: lives until it is replaced by another or by null.
    void setMeasured(const BenchTrace* measured);
    void setNow(double seconds); ///< where a running test is; negative: none runs
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Area;
    void paintSpeeds(QPainter& painter, const Area& area) const;
    void paintCurrents(QPainter& painter, const Area& area) const;
    void paintTrace(QPainter& painter, const Area& area, const BenchTrace& trace,
                    bool isThin) const;
    void paintTimes(QPainter& painter, const Area& area) const;
    void paintLegend(QPainter& painter, const QRectF& place) const;

    BenchTrace m_plan;
    BenchTrace m_prediction;
    const BenchTrace* m_measured = nullptr;
    double m_now = -1.0;
};

} // namespace trex
