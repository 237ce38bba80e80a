// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibration/responsecurveview.h"

#include "protocol/procedures/calibrationtext.h"
#include "widgets/calibration/calibrationpages.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double kMargin = 4.0;
constexpr double kPoint = 4.0; // radius of the live point
constexpr double kBeyond = 0.08; // drawn of the flat parts, in parts of the travel

} // namespace

ResponseCurveView::ResponseCurveView(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    updateDescription();
}

void ResponseCurveView::setCurves(int channel, InputKind input,
                                  const std::optional<ResponseCurve>& before,
                                  const std::optional<ResponseCurve>& after)
{
    if (m_channel == channel && m_input == input && m_before == before && m_after == after) {
        return;
    }
    m_channel = channel;
    m_input = input;
    m_before = before;
    m_after = after;
    updateDescription();
}

void ResponseCurveView::setLive(std::optional<int> raw)
{
    if (m_live != raw) {
        m_live = raw;
        updateDescription();
    }
}

bool ResponseCurveView::isGuess() const
{
    return (m_before && m_before->parabolic) || (m_after && m_after->parabolic);
}

QString ResponseCurveView::text() const
{
    if (!m_before && !m_after) {
        return tr("The calibration has not been read yet.");
    }
    if (!m_live) {
        return tr("No fresh reading.");
    }
    const QString about = isGuess() ? u"≈ "_s : QString();
    const QString reading = readingText(*m_live, m_input);
    const auto value = [this, &about](const std::optional<ResponseCurve>& curve) {
        return about + calibrationpages::remappedText(curve->remap(*m_live));
    };
    if (m_before && m_after) {
        return tr("%1: %2 before, %3 new").arg(reading, value(m_before), value(m_after));
    }
    return tr("%1: %2").arg(reading, value(m_after ? m_after : m_before));
}

void ResponseCurveView::updateDescription()
{
    setAccessibleName(tr("Response of channel %1").arg(m_channel));
    setAccessibleDescription(text());
    setToolTip(isGuess() ? tr("What channel %1 makes of its input. ≈: the exact form of the "
                              "parabola is not published; this one is a guess.")
                               .arg(m_channel)
                         : tr("What channel %1 makes of its input.").arg(m_channel));
    update();
}

QSize ResponseCurveView::sizeHint() const
{
    const int line = fontMetrics().height();
    return {line * 14, line * 11};
}

QSize ResponseCurveView::minimumSizeHint() const
{
    const int line = fontMetrics().height();
    return {line * 10, line * 7};
}

void ResponseCurveView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        update();
    }
}

double ResponseCurveView::Scale::xOf(double raw) const
{
    return area.left() + (raw - low) / (high - low) * area.width();
}

double ResponseCurveView::Scale::yOf(double remapped) const
{
    return area.center().y() - remapped / kFullSpeed * area.height() / 2.0;
}

int ResponseCurveView::Scale::rawAt(double x) const
{
    return static_cast<int>(std::lround(low + (x - area.left()) / area.width() * (high - low)));
}

ResponseCurveView::Scale ResponseCurveView::scale() const
{
    const double line = fontMetrics().height();
    const double labels = fontMetrics().horizontalAdvance(u"−127"_s) + kMargin;
    Scale scale;
    scale.area = QRectF(labels, line + kMargin, width() - labels - kMargin,
                        height() - 3.5 * line - 2.0 * kMargin);
    double low = 1e9;
    double high = -1e9;
    for (const auto& curve : {m_before, m_after}) {
        if (curve) {
            low = std::min(low, double(curve->calibration.minimum));
            high = std::max(high, double(curve->calibration.maximum));
        }
    }
    const double beyond = kBeyond * std::max(1.0, high - low);
    scale.low = low - beyond;
    scale.high = std::max(low + 1.0, high) + beyond;
    return scale;
}

void ResponseCurveView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(theme::font(0.85, true));
    const double line = painter.fontMetrics().height();
    if (!m_before && !m_after) {
        painter.setPen(theme::colour(ColourRole::DimText));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, text());
        return;
    }
    const Scale scale = this->scale();
    paintGrid(painter, scale);
    if (m_before) {
        painter.setPen(QPen(theme::colour(ColourRole::DimText), 1.5, Qt::DashLine));
        paintCurve(painter, scale, *m_before);
    }
    if (m_after) {
        painter.setPen(QPen(theme::channelColour(m_channel), 2.0));
        paintCurve(painter, scale, *m_after);
    }
    if (m_live) {
        paintLive(painter, scale);
    }
    paintLegend(painter, QRectF(scale.area.left(), 0, scale.area.width(), line));
    painter.setPen(theme::colour(ColourRole::Text));
    painter.drawText(QRectF(0, height() - line - 1.0, width(), line),
                     Qt::AlignRight | Qt::AlignVCenter, text());
}

void ResponseCurveView::paintGrid(QPainter& painter, const Scale& scale) const
{
    const double line = painter.fontMetrics().height();
    painter.fillRect(scale.area, theme::colour(ColourRole::Window));
    painter.setPen(QPen(theme::colour(ColourRole::Grid), 1.0));
    for (const int remapped : {-kFullSpeed, 0, kFullSpeed}) {
        const double y = scale.yOf(remapped);
        painter.setPen(QPen(theme::colour(ColourRole::Grid), 1.0));
        painter.drawLine(QPointF(scale.area.left(), y), QPointF(scale.area.right(), y));
        painter.setPen(theme::colour(ColourRole::DimText));
        painter.drawText(QRectF(0, y - line / 2, scale.area.left() - kMargin, line),
                         Qt::AlignRight | Qt::AlignVCenter,
                         calibrationpages::remappedText(remapped));
    }
    // The numbers that the curve turns at, as far as they have room.
    const Calibration& c = (m_after ? m_after : m_before)->calibration;
    double taken = -1e9;
    for (const int raw : {c.minimum, c.neutral, c.maximum}) {
        const double x = scale.xOf(raw);
        painter.setPen(QPen(theme::colour(ColourRole::Grid), 1.0));
        painter.drawLine(QPointF(x, scale.area.top()), QPointF(x, scale.area.bottom()));
        const QString label = readingText(raw, m_input);
        const double half = painter.fontMetrics().horizontalAdvance(label) / 2.0;
        const double left = std::clamp(x - half, 0.0, std::max(0.0, width() - 2.0 * half));
        if (left < taken + kMargin) {
            continue;
        }
        taken = left + 2.0 * half;
        painter.setPen(theme::colour(ColourRole::DimText));
        painter.drawText(QRectF(left, scale.area.bottom() + line / 2, 2.0 * half + 1.0, line),
                         Qt::AlignCenter, label);
    }
}

void ResponseCurveView::paintCurve(QPainter& painter, const Scale& scale,
                                   const ResponseCurve& curve) const
{
    QPainterPath path;
    const int steps = std::max(2, static_cast<int>(scale.area.width()));
    for (int i = 0; i <= steps; ++i) {
        const double x = scale.area.left() + scale.area.width() * i / steps;
        const QPointF point(x, scale.yOf(curve.shape(scale.rawAt(x))));
        i == 0 ? path.moveTo(point) : path.lineTo(point);
    }
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);
}

void ResponseCurveView::paintLive(QPainter& painter, const Scale& scale) const
{
    const double x = std::clamp(scale.xOf(*m_live), scale.area.left(), scale.area.right());
    painter.setPen(QPen(theme::colour(ColourRole::Text), 1.0, Qt::DotLine));
    painter.drawLine(QPointF(x, scale.area.top()), QPointF(x, scale.area.bottom()));
    if (m_before) {
        painter.setPen(QPen(theme::colour(ColourRole::DimText), 1.5));
        painter.setBrush(theme::colour(ColourRole::Window));
        painter.drawEllipse(QPointF(x, scale.yOf(m_before->remap(*m_live))), kPoint, kPoint);
    }
    if (m_after) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme::channelColour(m_channel));
        painter.drawEllipse(QPointF(x, scale.yOf(m_after->remap(*m_live))), kPoint, kPoint);
    }
}

void ResponseCurveView::paintLegend(QPainter& painter, const QRectF& line) const
{
    constexpr double kStroke = 18.0;
    double x = line.left();
    const auto entry = [&](const QPen& pen, const QString& word) {
        painter.setPen(pen);
        painter.drawLine(QPointF(x, line.center().y()), QPointF(x + kStroke, line.center().y()));
        x += kStroke + kMargin;
        const double wide = painter.fontMetrics().horizontalAdvance(word);
        painter.setPen(theme::colour(ColourRole::DimText));
        painter.drawText(QRectF(x, line.top(), wide + 1.0, line.height()), Qt::AlignVCenter, word);
        x += wide + 3.0 * kMargin;
    };
    if (m_before) {
        entry(QPen(theme::colour(ColourRole::DimText), 1.5, Qt::DashLine),
              m_after ? tr("before") : tr("now"));
    }
    if (m_after) {
        entry(QPen(theme::channelColour(m_channel), 2.0), tr("new"));
    }
    if (isGuess()) {
        painter.setPen(theme::colour(ColourRole::DimText));
        painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, tr("≈ parabolic"));
    }
}

} // namespace trex
