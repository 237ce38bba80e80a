// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/motorrow.h"

#include "widgets/common/panel.h"
#include "widgets/common/theme.h"
#include "widgets/motors/holdbutton.h"
#include "widgets/motors/motorslider.h"

#include <QFontMetrics>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

ColourRole roleOf(MotorId motor)
{
    switch (motor) {
    case MotorId::Motor1:
        return ColourRole::Motor1;
    case MotorId::Motor2:
        return ColourRole::Motor2;
    case MotorId::Aux:
        break;
    }
    return ColourRole::Aux;
}

} // namespace

MotorRow::MotorRow(MotorId motor, const QString& title, const QString& namePrefix, QWidget* parent)
    : QWidget(parent)
    , m_slider(named(
          new MotorSlider(motor == MotorId::Aux ? 0 : -kFullSpeed, kFullSpeed, roleOf(motor), this),
          namePrefix + u".slider"_s, tr("%1 speed").arg(title)))
    , m_value(
          named(new QLabel(this), namePrefix + u".value"_s, tr("%1 commanded speed").arg(title)))
    , m_zero(named(new QPushButton(theme::icon(u"zero"_s), tr("Zero"), this),
                   namePrefix + u".zero"_s, tr("%1 to zero").arg(title)))
{
    auto* caption = new QLabel(title, this);
    caption->setBuddy(m_slider);
    m_value->setFont(theme::font(1.0, true));
    m_value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_value->setMinimumWidth(QFontMetrics(m_value->font()).horizontalAdvance(u"−127  −100 %"_s)
                             + 4);
    m_slider->setToolTip(tr("Arrow keys: one step. Page keys: eight. Space or Home: zero."));

    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(4);
    grid->addWidget(caption, 0, 0);
    grid->addWidget(m_value, 0, 1, 1, 3);
    grid->addWidget(m_slider, 1, 0, 1, 4);
    grid->addWidget(m_zero, 2, 0, Qt::AlignLeft);
    grid->addWidget(makeHolds(motor, title, namePrefix), 2, 1, Qt::AlignCenter);
    grid->setColumnStretch(1, 1);
    if (motor != MotorId::Aux) {
        m_duty = named(new QSpinBox(this), namePrefix + u".brakeDuty"_s,
                       tr("%1 braking duty").arg(title));
        m_duty->setRange(0, kFullSpeed);
        m_duty->setValue(kFullSpeed);
        m_duty->setToolTip(tr("Braking duty: 0 coasts, 127 brakes fully."));
        m_brake = named(new QPushButton(theme::icon(u"brake"_s), tr("Brake"), this),
                        namePrefix + u".brake"_s, tr("Brake %1").arg(title));
        grid->addWidget(m_brake, 2, 2);
        grid->addWidget(m_duty, 2, 3);
        connect(m_brake, &QPushButton::clicked, this,
                [this] { emit brakeWanted(m_duty->value()); });
    }
    connect(m_slider, &QSlider::valueChanged, this, [this](int speed) {
        showSpeed(speed);
        emit speedWanted(speed);
    });
    // Also when the slider stands at zero already: after a brake that is a new order.
    connect(m_zero, &QPushButton::clicked, this, [this] {
        setSpeed(0);
        emit speedWanted(0);
    });
    showSpeed(0);
}

int MotorRow::speed() const
{
    return m_slider->value();
}

void MotorRow::setSpeed(int speed)
{
    const QSignalBlocker blocker(m_slider);
    m_slider->setSliderDown(false);
    m_slider->setValue(speed);
    m_slider->update();
    showSpeed(speed);
}

void MotorRow::setReached(int speed)
{
    m_slider->setReached(speed);
}

void MotorRow::setLimit(int maximum, int step)
{
    const QSignalBlocker blocker(m_slider);
    m_slider->setRange(m_slider->minimum() < 0 ? -maximum : 0, maximum);
    m_slider->setPageStep(step);
}

QWidget* MotorRow::makeHolds(MotorId motor, const QString& title, const QString& prefix)
{
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    const auto add = [&](Qt::ArrowType arrow, int sign, const QString& part, const QString& name) {
        auto* button = named(new HoldButton(arrow, box), prefix + part, name);
        button->setToolTip(name);
        row->addWidget(button);
        m_holds << button;
        connect(button, &HoldButton::heldChanged, this,
                [this, sign](bool held) { m_slider->setValue(held ? sign * m_holdSpeed : 0); });
    };
    if (motor != MotorId::Aux) {
        add(Qt::LeftArrow, -1, u".holdReverse"_s, tr("%1 reverse while held").arg(title));
    }
    add(Qt::RightArrow, 1, u".holdForward"_s, tr("%1 forward while held").arg(title));
    return box;
}

void MotorRow::setHold(bool holds, int speed)
{
    m_holdSpeed = speed;
    m_slider->setSpring(holds);
    for (HoldButton* button : std::as_const(m_holds)) {
        button->setVisible(holds);
    }
}

void MotorRow::setBraking(int duty)
{
    setSpeed(0);
    m_value->setText(tr("brake %1").arg(duty));
}

void MotorRow::showSpeed(int speed)
{
    const QString sign = speed < 0 ? u"−"_s : QString();
    const int percent = qRound(std::abs(MotorSpeed::clamped(speed).percent()));
    m_value->setText(u"%1%2  %1%3 %"_s.arg(sign).arg(std::abs(speed)).arg(percent));
}

void MotorRow::setUsable(bool usable)
{
    for (QWidget* control : std::initializer_list<QWidget*>{m_slider, m_zero, m_brake, m_duty}) {
        if (control != nullptr) {
            control->setEnabled(usable);
        }
    }
    for (HoldButton* button : std::as_const(m_holds)) {
        button->setEnabled(usable);
    }
}

} // namespace trex
