// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/motorslider.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>

namespace trex {

namespace {

constexpr int kHandleWidth = 14;
constexpr int kHeight = 36;
constexpr int kDetent = 3; // speed steps about neutral that a dragged handle falls into
constexpr int kSmallStep = 1;
constexpr int kLargeStep = 8;

} // namespace

MotorSlider::MotorSlider(int minimum, int maximum, ColourRole role, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), m_role(role), m_hold(*this)
{
    setRange(minimum, maximum);
    setSingleStep(kSmallStep);
    setPageStep(kLargeStep);
    setFocusPolicy(Qt::StrongFocus); // not by the wheel
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&m_hold, &HoldWatch::lost, this, &MotorSlider::springBack);
}

void MotorSlider::setSpring(bool springs)
{
    if (m_springs && !springs) {
        springBack();
    }
    m_springs = springs;
}

void MotorSlider::springBack()
{
    m_hold.end();
    if (m_springs) {
        setSliderDown(false);
        setValue(0);
    }
}

void MotorSlider::setReached(int speed)
{
    if (m_reached != speed) {
        m_reached = speed;
        update();
    }
}

QSize MotorSlider::sizeHint() const
{
    return {200, kHeight};
}

QSize MotorSlider::minimumSizeHint() const
{
    return {120, kHeight};
}

double MotorSlider::xOf(int value) const
{
    const double room = width() - kHandleWidth;
    return kHandleWidth / 2.0 + room * (value - minimum()) / (maximum() - minimum());
}

int MotorSlider::valueAt(double x) const
{
    const double room = std::max(1, width() - kHandleWidth);
    const double share = (x - kHandleWidth / 2.0) / room;
    return minimum() + static_cast<int>(std::lround(share * (maximum() - minimum())));
}

void MotorSlider::paintScale(QPainter& painter) const
{
    painter.setPen(theme::colour(ColourRole::Border));
    const int middle = height() / 2;
    for (int quarter = -4; quarter <= 4; ++quarter) {
        const int value = quarter * 127 / 4;
        if (value >= minimum()) {
            const double x = xOf(value);
            const int reach = quarter == 0 ? 14 : 9;
            painter.drawLine(QPointF(x, middle - reach), QPointF(x, middle + reach));
        }
    }
}

void MotorSlider::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event)
    QPainter painter(this);
    paintScale(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = height() / 2.0;
    const QColor colour = isEnabled() ? theme::colour(m_role) : theme::colour(ColourRole::Stale);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::colour(ColourRole::Border));
    painter.drawRoundedRect(QRectF(kHandleWidth / 2.0, middle - 3, width() - kHandleWidth, 6), 3,
                            3);
    const double neutral = xOf(0);
    const double handle = xOf(sliderPosition());
    if (isEnabled() && sliderPosition() != 0) {
        painter.setBrush(colour);
        painter.drawRoundedRect(
            QRectF(std::min(neutral, handle), middle - 3, std::abs(handle - neutral), 6), 3, 3);
    }
    if (isEnabled() && m_reached != sliderPosition()) { // a ramp is on its way
        painter.setBrush(theme::colour(ColourRole::Text));
        painter.drawRect(QRectF(xOf(m_reached) - 1.5, middle - 9, 3, 18));
    }
    painter.setPen(
        QPen(hasFocus() ? theme::colour(ColourRole::Accent) : colour, hasFocus() ? 2.0 : 1.0));
    painter.setBrush(isEnabled() ? colour : theme::colour(ColourRole::Panel));
    painter.drawRoundedRect(
        QRectF(handle - kHandleWidth / 2.0 + 1, middle - 11, kHandleWidth - 2, 22), 3, 3);
    painter.setPen(theme::colour(ColourRole::Panel));
    painter.drawLine(QPointF(handle, middle - 6), QPointF(handle, middle + 6));
}

void MotorSlider::wheelEvent(QWheelEvent* event)
{
    if (hasFocus() && !m_springs) { // a wheel is not held
        QSlider::wheelEvent(event);
    } else {
        event->ignore(); // scrolls what the slider stands in
    }
}

void MotorSlider::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Home:
    case Qt::Key_Space:
    case Qt::Key_0:
        setValue(0);
        return;
    case Qt::Key_End: // would be full speed at one stroke
        return;
    default:
        break;
    }
    if (m_springs) {
        if (event->isAutoRepeat() && !m_hold.isHeld()) {
            return; // a repeat alone starts nothing: its press was before an interruption
        }
        event->isAutoRepeat() ? m_hold.sign() : m_hold.begin(HoldWatch::By::Key);
    }
    QSlider::keyPressEvent(event);
}

void MotorSlider::keyReleaseEvent(QKeyEvent* event)
{
    if (m_springs && !event->isAutoRepeat()) {
        springBack();
    }
    QSlider::keyReleaseEvent(event);
}

void MotorSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    setFocus(Qt::MouseFocusReason);
    if (m_springs) {
        m_hold.begin(HoldWatch::By::Mouse);
    }
    const double x = event->position().x();
    m_grip = x - xOf(sliderPosition());
    if (std::abs(m_grip) <= kHandleWidth) {
        setSliderDown(true);
        return;
    }
    // Beside the handle: one large step towards the pointer, never a jump to it.
    triggerAction(m_grip < 0 ? SliderPageStepSub : SliderPageStepAdd);
}

void MotorSlider::mouseMoveEvent(QMouseEvent* event)
{
    if (m_springs && (event->buttons() & Qt::LeftButton) == 0) {
        springBack(); // its release went elsewhere
        return;
    }
    if (isSliderDown()) {
        const int wanted =
            std::clamp(valueAt(event->position().x() - m_grip), minimum(), maximum());
        setSliderPosition(std::abs(wanted) <= kDetent ? 0 : wanted);
    }
}

void MotorSlider::mouseReleaseEvent(QMouseEvent* event)
{
    Q_UNUSED(event)
    setSliderDown(false);
    springBack();
}

} // namespace trex
