// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedures/responsecurve.h"

#include <QWidget>

#include <optional>

namespace trex {

/// What a channel makes of its input: raw → remapped, before (dashed) and after, with deadband,
/// parabola and direction applied, and the live point on both. GUI thread.
class ResponseCurveView : public QWidget {
    Q_OBJECT
    Q_PROPERTY(int channel READ channel)
    Q_PROPERTY(QString text READ text)

public:
    explicit ResponseCurveView(QWidget* parent = nullptr);

    /// `after`: the new numbers, none while nothing was learned.
    void setCurves(int channel, InputKind input, const std::optional<ResponseCurve>& before,
                   const std::optional<ResponseCurve>& after);
    void setLive(std::optional<int> raw); ///< a fresh, valid reading; none: no point is drawn

    [[nodiscard]] int channel() const { return m_channel; }
    /// The live point in words: "1.455 ms: −12 before, −14 new".
    [[nodiscard]] QString text() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Scale {
        QRectF area;
        double low = 0.0; ///< raw at the left edge
        double high = 1.0;
        [[nodiscard]] double xOf(double raw) const;
        [[nodiscard]] double yOf(double remapped) const;
        [[nodiscard]] int rawAt(double x) const;
    };
    [[nodiscard]] Scale scale() const;
    [[nodiscard]] bool isGuess() const; ///< the exact parabola is not published
    void paintGrid(QPainter& painter, const Scale& scale) const;
    void paintCurve(QPainter& painter, const Scale& scale, const ResponseCurve& curve) const;
    void paintLive(QPainter& painter, const Scale& scale) const;
    void paintLegend(QPainter& painter, const QRectF& line) const;
    void updateDescription();

    int m_channel = 1;
    InputKind m_input = InputKind::Rc;
    std::optional<ResponseCurve> m_before;
    std::optional<ResponseCurve> m_after;
    std::optional<int> m_live;
};

} // namespace trex
