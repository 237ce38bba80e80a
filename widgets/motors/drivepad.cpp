// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/drivepad.h"

#include "protocol/codec/quantities.h"
#include "widgets/common/theme.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>

namespace trex {

namespace {

constexpr int kUsualSide = 200;
constexpr int kLeastSide = 120;
constexpr int kDetent = 8; ///< about each axis: a straight line is easy to hold
constexpr double kHandle = 11.0;

bool isArrow(int key)
{
    return key == Qt::Key_Up || key == Qt::Key_Down || key == Qt::Key_Left || key == Qt::Key_Right;
}

int onAxis(double share)
{
    const int value =
        std::clamp(static_cast<int>(std::lround(share * kFullSpeed)), -kFullSpeed, kFullSpeed);
    return std::abs(value) <= kDetent ? 0 : value;
}

} // namespace

DrivePad::DrivePad(QWidget* parent) : QWidget(parent), m_hold(*this)
{
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    setToolTip(tr("Hold and pull: up is forward, sideways turns. Or hold the arrow keys. Let go: "
                  "both motors go to zero."));
    connect(&m_hold, &HoldWatch::lost, this, &DrivePad::springBack);
}

QSize DrivePad::sizeHint() const
{
    return {kUsualSide, kUsualSide};
}

QSize DrivePad::minimumSizeHint() const
{
    return {kLeastSide, kLeastSide};
}

QRectF DrivePad::field() const
{
    const double side = std::min(width(), height()) - 4.0;
    return {(width() - side) / 2, (height() - side) / 2, side, side};
}

void DrivePad::set(int forward, int turn)
{
    if (forward == m_forward && turn == m_turn) {
        return;
    }
    m_forward = forward;
    m_turn = turn;
    update();
    emit moved(forward, turn);
}

void DrivePad::springBack()
{
    m_hold.end();
    m_keys.clear();
    set(0, 0);
}

void DrivePad::steer(int forward, int turn)
{
    const bool isNeutral = forward == 0 && turn == 0;
    const bool isUsable = isVisible() && isEnabled() && isActiveWindow() && !m_hold.isHeld();
    m_isSteerStale = !isNeutral && (m_isSteerStale || !isUsable);
    if (!m_hold.isHeld()) {
        m_isSteerStale ? set(0, 0) : set(forward, turn);
    }
}

void DrivePad::followMouse(const QPointF& position)
{
    const QRectF area = field().adjusted(kHandle, kHandle, -kHandle, -kHandle);
    const QPointF from = position - area.center();
    set(onAxis(-2 * from.y() / area.height()), onAxis(2 * from.x() / area.width()));
}

void DrivePad::followKeys()
{
    const auto axis = [this](int more, int less) {
        return m_keySpeed * (int(m_keys.contains(more)) - int(m_keys.contains(less)));
    };
    set(axis(Qt::Key_Up, Qt::Key_Down), axis(Qt::Key_Right, Qt::Key_Left));
}

void DrivePad::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !field().contains(event->position())) {
        springBack(); // any other button lets go
        return;
    }
    setFocus(Qt::MouseFocusReason);
    m_keys.clear();
    m_hold.begin(HoldWatch::By::Mouse);
    followMouse(event->position());
}

void DrivePad::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_hold.isHeld()) {
        return;
    }
    if ((event->buttons() & Qt::LeftButton) == 0) {
        springBack(); // its release went elsewhere
    } else {
        followMouse(event->position());
    }
}

void DrivePad::mouseReleaseEvent(QMouseEvent* /*event*/)
{
    springBack();
}

void DrivePad::keyPressEvent(QKeyEvent* event)
{
    if (!isArrow(event->key())) {
        springBack();
        QWidget::keyPressEvent(event);
        return;
    }
    if (event->isAutoRepeat()) {
        if (m_keys.contains(event->key())) {
            m_hold.sign();
        }
        return; // a repeat alone starts nothing: its press was before an interruption
    }
    m_keys.insert(event->key());
    m_hold.begin(HoldWatch::By::Key);
    followKeys();
}

void DrivePad::keyReleaseEvent(QKeyEvent* event)
{
    if (!isArrow(event->key())) {
        QWidget::keyReleaseEvent(event);
        return;
    }
    if (event->isAutoRepeat() || !m_keys.remove(event->key())) {
        return;
    }
    if (m_keys.isEmpty()) {
        springBack();
        return;
    }
    m_hold.begin(HoldWatch::By::Key); // the key that is left may not repeat any more
    followKeys();
}

void DrivePad::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = field();
    const QPointF centre = area.center();
    painter.setPen(
        QPen(hasFocus() ? theme::colour(ColourRole::Accent) : theme::colour(ColourRole::Border),
             hasFocus() ? 2.0 : 1.0));
    painter.setBrush(theme::colour(ColourRole::Window));
    painter.drawRoundedRect(area, 6, 6);
    painter.setPen(theme::colour(ColourRole::Border));
    painter.drawLine(QPointF(centre.x(), area.top() + 6), QPointF(centre.x(), area.bottom() - 6));
    painter.drawLine(QPointF(area.left() + 6, centre.y()), QPointF(area.right() - 6, centre.y()));
    const double reach = area.width() / 2 - kHandle;
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, reach / 2, reach / 2);

    const QPointF handle =
        centre + QPointF(m_turn * reach / kFullSpeed, -m_forward * reach / kFullSpeed);
    const QColor colour =
        isEnabled() ? theme::colour(ColourRole::Accent) : theme::colour(ColourRole::Stale);
    painter.setPen(QPen(colour, 2.0));
    painter.drawLine(centre, handle);
    painter.setBrush(isEnabled() ? colour : theme::colour(ColourRole::Panel));
    painter.drawEllipse(handle, kHandle - 2, kHandle - 2);
}

} // namespace trex
