// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/bench/benchchart.h"

#include "widgets/common/plotticks.h"
#include "widgets/common/theme.h"

#include <QFontMetrics>
#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr std::array kRoles{ColourRole::Motor1, ColourRole::Motor2, ColourRole::Aux};
constexpr std::array kStyles{Qt::SolidLine, Qt::DashLine, Qt::DotLine};
constexpr double kLeastAmperes = 0.4;
constexpr int kGap = 16;

} // namespace

struct BenchChart::Area {
    QRectF rect;
    double seconds = 1.0; ///< across
    double low = 0.0;
    double high = 1.0;
    [[nodiscard]] double x(double at) const { return rect.left() + at / seconds * rect.width(); }
    [[nodiscard]] double y(double value) const
    {
        return rect.bottom() - (value - low) / (high - low) * rect.height();
    }
};

BenchChart::BenchChart(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void BenchChart::setPlan(const BenchTrace& plan)
{
    m_plan = plan;
    update();
}

void BenchChart::setPrediction(const BenchTrace& prediction)
{
    m_prediction = prediction;
    update();
}

void BenchChart::setMeasured(const BenchTrace* measured)
{
    m_measured = measured;
    update();
}

void BenchChart::setNow(double seconds)
{
    m_now = seconds;
    update();
}

QSize BenchChart::sizeHint() const
{
    return {480, 220};
}

QSize BenchChart::minimumSizeHint() const
{
    return {240, 120};
}

void BenchChart::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(theme::font(1.0, true));
    painter.fillRect(rect(), theme::colour(ColourRole::Panel));
    const QFontMetrics metrics(painter.font());
    const int left = metrics.horizontalAdvance(u"−127 "_s) + metrics.height() + 8;
    const int line = metrics.height();
    const QRectF inner(left, line + 4, width() - left - 10, height() - 2 * line - 12);
    paintLegend(painter, QRectF(left, 0, inner.width(), line + 2));
    const double seconds =
        std::max({m_plan.seconds, m_prediction.seconds,
                  m_measured != nullptr ? m_measured->seconds : 0.0, m_now, 0.1});
    const double above = inner.height() * 0.42;
    const Area speeds{QRectF(inner.left(), inner.top(), inner.width(), above - kGap), seconds,
                      -kFullSpeed, kFullSpeed};
    Area currents{QRectF(inner.left(), inner.top() + above, inner.width(), inner.height() - above),
                  seconds, 0.0, kLeastAmperes};
    for (const BenchTrace* trace : {static_cast<const BenchTrace*>(&m_prediction), m_measured}) {
        for (std::size_t i = 0; trace != nullptr && i < trace->samples.size(); ++i) {
            currents.high = std::max({currents.high, trace->amperes(i, MotorId::Motor1) * 1.08,
                                      trace->amperes(i, MotorId::Motor2) * 1.08});
        }
    }
    paintSpeeds(painter, speeds);
    paintCurrents(painter, currents);
    paintTimes(painter, currents);
    if (m_now >= 0.0) {
        painter.setPen(QPen(theme::colour(ColourRole::Accent), 1.5));
        painter.drawLine(QPointF(speeds.x(m_now), inner.top()),
                         QPointF(speeds.x(m_now), inner.bottom()));
    }
}

void BenchChart::paintLegend(QPainter& painter, const QRectF& place) const
{
    QStringList names{tr("Motor 1"), tr("Motor 2"), tr("Aux")};
    double x = place.left();
    for (std::size_t i = 0; i < kRoles.size(); ++i) {
        const auto motor = static_cast<MotorId>(i);
        const bool isUsed =
            std::ranges::any_of(m_plan.orders, [motor](const BenchTrace::Order& order) {
                return order.motor == motor;
            });
        if (!isUsed) {
            continue;
        }
        painter.setPen(QPen(theme::colour(kRoles.at(i)), 2.0, kStyles.at(i)));
        painter.drawLine(QPointF(x, place.center().y()), QPointF(x + 22, place.center().y()));
        painter.setPen(theme::colour(ColourRole::DimText));
        const QString& name = names.at(static_cast<qsizetype>(i));
        painter.drawText(QPointF(x + 27, place.bottom() - 5), name);
        x += 44 + QFontMetrics(painter.font()).horizontalAdvance(name);
    }
    QString what;
    if (m_measured != nullptr && !m_measured->samples.empty()) {
        what = m_prediction.samples.empty() ? tr("measured") : tr("measured; thin: predicted");
    } else if (!m_prediction.samples.empty()) {
        what = tr("predicted by the dry run");
    }
    painter.setPen(theme::colour(ColourRole::DimText));
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, what);
}

void BenchChart::paintSpeeds(QPainter& painter, const Area& area) const
{
    for (const int speed : {-kFullSpeed, 0, kFullSpeed}) {
        painter.setPen(theme::colour(speed == 0 ? ColourRole::Border : ColourRole::Grid));
        painter.drawLine(QPointF(area.rect.left(), area.y(speed)),
                         QPointF(area.rect.right(), area.y(speed)));
        painter.setPen(theme::colour(ColourRole::DimText));
        const QString text = QString::number(speed).replace(u'-', u'−');
        painter.drawText(QRectF(0, area.y(speed) - 9, area.rect.left() - 6, 18),
                         Qt::AlignRight | Qt::AlignVCenter, text);
    }
    for (std::size_t i = 0; i < kRoles.size(); ++i) {
        QPainterPath path;
        bool isBegun = false;
        double level = area.y(0.0);
        for (const BenchTrace::Order& order : m_plan.orders) {
            if (order.motor != static_cast<MotorId>(i)) {
                continue;
            }
            if (!std::exchange(isBegun, true)) {
                path.moveTo(area.rect.left(), level);
            }
            const double x = area.x(BenchTrace::secondsOf(order.tick));
            path.lineTo(x, level);
            level = area.y(order.action == MotorOrder::Action::Brake ? 0 : order.amount);
            path.lineTo(x, level);
        }
        if (isBegun) {
            path.lineTo(area.x(m_plan.seconds), level);
            painter.setPen(QPen(theme::colour(kRoles.at(i)), 1.6, kStyles.at(i)));
            painter.drawPath(path);
        }
    }
}

void BenchChart::paintCurrents(QPainter& painter, const Area& area) const
{
    const double step = ticks::niceStep(area.high, std::max(3, int(area.rect.height() / 34)));
    for (int i = 0; i * step <= area.high; ++i) {
        const double y = area.y(i * step);
        painter.setPen(theme::colour(i == 0 ? ColourRole::Border : ColourRole::Grid));
        painter.drawLine(QPointF(area.rect.left(), y), QPointF(area.rect.right(), y));
        painter.setPen(theme::colour(ColourRole::DimText));
        painter.drawText(QRectF(0, y - 9, area.rect.left() - 6, 18),
                         Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(i * step, 'f', ticks::decimalsFor(step)) + u" A"_s);
    }
    if (!m_prediction.samples.empty()) {
        paintTrace(painter, area, m_prediction,
                   m_measured != nullptr && !m_measured->samples.empty());
    }
    if (m_measured != nullptr) {
        paintTrace(painter, area, *m_measured, false);
    }
    if (m_prediction.samples.empty() && (m_measured == nullptr || m_measured->samples.empty())) {
        painter.setPen(theme::colour(ColourRole::DimText));
        painter.drawText(area.rect, Qt::AlignCenter | Qt::TextWordWrap,
                         tr("The dry run shows here what currents to expect."));
    }
}

/// The extremes of each pixel column, so that no spike is lost.
void BenchChart::paintTrace(QPainter& painter, const Area& area, const BenchTrace& trace,
                            bool isThin) const
{
    for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2}) {
        QPainterPath path;
        double before = -1.0;
        std::size_t i = 0;
        while (i < trace.samples.size()) {
            const double first = BenchTrace::secondsOf(trace.samples[i].tick);
            const double column = std::floor(area.x(first));
            double low = trace.amperes(i, motor);
            double high = low;
            double last = first;
            for (; i < trace.samples.size(); ++i) {
                last = BenchTrace::secondsOf(trace.samples[i].tick);
                if (std::floor(area.x(last)) > column) {
                    break;
                }
                low = std::min(low, trace.amperes(i, motor));
                high = std::max(high, trace.amperes(i, motor));
            }
            const bool isGap = before < 0.0 || first - before > BenchTrace::kGapSeconds;
            isGap ? path.moveTo(column, area.y(high)) : path.lineTo(column, area.y(high));
            path.lineTo(column, area.y(low) + 0.05);
            before = last;
        }
        QColor colour = theme::colour(kRoles.at(std::size_t(motor)));
        colour.setAlphaF(isThin ? 0.45F : 1.0F);
        painter.setPen(QPen(colour, isThin ? 0.8 : 1.3));
        painter.drawPath(path);
    }
}

void BenchChart::paintTimes(QPainter& painter, const Area& area) const
{
    const double step = ticks::timeStep(area.seconds, std::max(2, int(area.rect.width() / 90)));
    for (int i = 0; i * step <= area.seconds; ++i) {
        const double x = area.x(i * step);
        painter.setPen(theme::colour(ColourRole::DimText));
        QRectF place(x - 40, area.rect.bottom() + 3, 80, 18);
        int align = Qt::AlignHCenter;
        if (place.right() > width()) { // the last one ends where the plot does
            place.moveRight(area.rect.right() + 8);
            align = Qt::AlignRight;
        }
        painter.drawText(place, align | Qt::AlignVCenter, ticks::timeLabel(i * step, step));
    }
}

} // namespace trex
