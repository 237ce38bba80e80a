// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/channels/channelbar.h"

#include "widgets/common/theme.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr double kRawLane = 18.0;
constexpr double kRemappedLane = 6.0;
constexpr double kLaneGap = 3.0;
constexpr double kMarker = 3.0;
constexpr double kRadius = 3.0;
constexpr double kSideMargin = 2.0;
constexpr int kLargestAnalog = 1023; // 10 bits (command documentation, 0x86)
constexpr int kShortestPulse = 1250; // 0.5 and 2.5 ms in 0.4 µs (facts.md 5.1)
constexpr int kLongestPulse = 6250;

QColor withAlpha(QColor colour, int alpha)
{
    colour.setAlpha(alpha);
    return colour;
}

} // namespace

ChannelBar::ChannelBar(int channel, QWidget* parent) : QWidget(parent), m_channel(channel)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Channel %1").arg(channel));
    updateDescription();
}

std::pair<int, int> ChannelBar::scaleOf(InputKind input)
{
    return input == InputKind::Rc ? std::pair(kShortestPulse, kLongestPulse)
                                  : std::pair(0, kLargestAnalog);
}

bool ChannelBar::isValid() const
{
    return !m_stale && m_raw >= 0 && m_raw != kInvalidPulse;
}

void ChannelBar::setInput(InputKind input)
{
    if (m_input != input) {
        m_input = input;
        updateDescription();
    }
}

void ChannelBar::setRaw(int raw)
{
    if (m_raw != raw) {
        m_raw = raw;
        updateDescription();
    }
}

void ChannelBar::setRemapped(std::optional<int> remapped)
{
    if (m_remapped != remapped) {
        m_remapped = remapped;
        update();
    }
}

void ChannelBar::setStale(bool stale)
{
    if (m_stale != stale) {
        m_stale = stale;
        updateDescription();
    }
}

void ChannelBar::setCalibration(const std::optional<Calibration>& calibration)
{
    if (m_calibration != calibration) {
        m_calibration = calibration;
        updateDescription();
    }
}

void ChannelBar::setTravel(const std::optional<Travel>& travel)
{
    if (m_travel != travel) {
        m_travel = travel;
        update();
    }
}

void ChannelBar::setRemappedShown(bool shown)
{
    m_remappedShown = shown;
    updateGeometry();
    update();
}

QString ChannelBar::text() const
{
    if (m_raw < 0) {
        return tr("–");
    }
    if (m_raw == kInvalidPulse) {
        return tr("– no pulse");
    }
    constexpr int kMsDecimals = 3;
    constexpr int kVoltDecimals = 2;
    return m_input == InputKind::Rc
        ? u"%1 ms (%2)"_s.arg(millisecondsFromRaw(m_raw), 0, 'f', kMsDecimals).arg(m_raw)
        : u"%1 V (%2)"_s.arg(voltsFromRaw(m_raw), 0, 'f', kVoltDecimals).arg(m_raw);
}

void ChannelBar::updateDescription()
{
    QString description = m_stale && m_raw >= 0 ? tr("%1, old").arg(text()) : text();
    if (m_calibration) {
        const Calibration& c = *m_calibration;
        description += u'\n'
            + tr("Calibration: minimum %1, neutral %2, maximum %3, deadband ±%4")
                  .arg(c.minimum)
                  .arg(c.neutral)
                  .arg(c.maximum)
                  .arg(c.deadband);
    }
    setAccessibleDescription(description);
    setToolTip(description);
    update();
}

QSize ChannelBar::sizeHint() const
{
    const double height = m_remappedShown ? kRawLane + kLaneGap + kRemappedLane : kRawLane;
    return {220, static_cast<int>(height) + 2};
}

QSize ChannelBar::minimumSizeHint() const
{
    return {100, sizeHint().height()};
}

void ChannelBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        update();
    }
}

double ChannelBar::xOf(int raw, const QRectF& lane) const
{
    const auto [low, high] = scaleOf(m_input);
    const double part = std::clamp(double(raw - low) / double(high - low), 0.0, 1.0);
    return lane.left() + part * lane.width();
}

void ChannelBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double below = m_remappedShown ? kLaneGap + kRemappedLane : 0.0;
    const QRectF lane(kSideMargin, 1.0, width() - 2 * kSideMargin, height() - 2.0 - below);
    paintRawLane(painter, lane);
    if (m_remappedShown) {
        paintRemappedLane(
            painter, QRectF(lane.left(), lane.bottom() + kLaneGap, lane.width(), kRemappedLane));
    }
}

void ChannelBar::paintCalibration(QPainter& painter, const QRectF& lane) const
{
    const double low = xOf(m_calibration->minimum, lane);
    const double high = xOf(m_calibration->maximum, lane);
    const double neutral = xOf(m_calibration->neutral, lane);
    painter.fillRect(QRectF(low, lane.top(), high - low, lane.height()),
                     theme::colour(ColourRole::Grid));
    const double dead1 = xOf(m_calibration->neutral - m_calibration->deadband, lane);
    const double dead2 = xOf(m_calibration->neutral + m_calibration->deadband, lane);
    painter.fillRect(QRectF(dead1, lane.top(), dead2 - dead1, lane.height()),
                     theme::colour(ColourRole::Border));
    painter.setPen(QPen(theme::colour(ColourRole::DimText), 1.0));
    for (const double x : {low, high}) { // brackets that open towards neutral
        const double inward = x < neutral || (x == neutral && x == low) ? 4.0 : -4.0;
        painter.drawLine(QPointF(x, lane.top()), QPointF(x, lane.bottom()));
        painter.drawLine(QPointF(x, lane.top()), QPointF(x + inward, lane.top()));
        painter.drawLine(QPointF(x, lane.bottom()), QPointF(x + inward, lane.bottom()));
    }
    painter.drawLine(QPointF(neutral, lane.top()), QPointF(neutral, lane.bottom()));
}

void ChannelBar::paintRawLane(QPainter& painter, const QRectF& lane) const
{
    QPainterPath outline;
    outline.addRoundedRect(lane, kRadius, kRadius);
    painter.save();
    painter.setClipPath(outline);
    painter.fillRect(lane, theme::colour(ColourRole::Window));
    const bool isInvalid = m_raw == kInvalidPulse;
    if (m_calibration) {
        paintCalibration(painter, lane);
    }
    if (isInvalid) {
        painter.fillRect(
            lane, QBrush(withAlpha(theme::colour(ColourRole::Stale), 130), Qt::BDiagPattern));
    } else if (m_raw >= 0) {
        const QColor colour =
            m_stale ? theme::colour(ColourRole::Stale) : theme::channelColour(m_channel);
        const double x = xOf(m_raw, lane);
        if (m_calibration) {
            const double neutral = xOf(m_calibration->neutral, lane);
            const QRectF deviation(std::min(x, neutral), lane.top() + 5.0, std::abs(x - neutral),
                                   lane.height() - 10.0);
            painter.fillRect(deviation, withAlpha(colour, m_stale ? 70 : 150));
        }
        painter.fillRect(QRectF(x - kMarker / 2, lane.top(), kMarker, lane.height()), colour);
    }
    if (m_travel) {
        painter.setPen(QPen(theme::colour(ColourRole::Text), 1.0, Qt::DashLine));
        for (const int visited : {m_travel->lowest, m_travel->highest}) {
            const double x = xOf(visited, lane);
            painter.drawLine(QPointF(x, lane.top()), QPointF(x, lane.bottom()));
        }
    }
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme::colour(ColourRole::Border), 1.0));
    painter.drawRoundedRect(lane, kRadius, kRadius);
    if (isInvalid) {
        const QString words = tr("no pulse");
        const double wordsWidth = painter.fontMetrics().horizontalAdvance(words) + 12.0;
        QRectF plate(0, 0, wordsWidth, lane.height() - 3.0);
        plate.moveCenter(lane.center());
        painter.fillRect(plate, theme::colour(ColourRole::Panel));
        painter.setPen(theme::colour(m_stale ? ColourRole::Stale : ColourRole::Warning));
        painter.drawText(lane, Qt::AlignCenter, words);
    }
}

void ChannelBar::paintRemappedLane(QPainter& painter, const QRectF& lane) const
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::colour(ColourRole::Grid));
    painter.drawRoundedRect(lane, lane.height() / 2, lane.height() / 2);
    const double middle = lane.center().x();
    if (m_remapped && m_raw != kInvalidPulse) {
        const double x = middle + lane.width() / 2 * (*m_remapped / double(kFullSpeed));
        const QColor colour =
            m_stale ? theme::colour(ColourRole::Stale) : theme::channelColour(m_channel);
        painter.setBrush(colour);
        QRectF bar(std::min(x, middle), lane.top(), std::abs(x - middle), lane.height());
        painter.drawRoundedRect(bar, std::min(2.0, bar.width() / 2), 2.0);
    }
    painter.fillRect(QRectF(middle - 0.5, lane.top() - 1.0, 1.0, lane.height() + 2.0),
                     theme::colour(ColourRole::DimText));
}

} // namespace trex
