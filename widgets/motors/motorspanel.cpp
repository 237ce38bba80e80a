// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/motorspanel.h"

#include "protocol/errortext.h"
#include "protocol/session/devicesettings.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"
#include "widgets/motors/motorrow.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace trex {

using namespace Qt::Literals::StringLiterals;

MotorsPanel::MotorsPanel(PanelContext& context, QWidget* parent)
    : Panel(context, parent), m_lockout(this)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    makeControls();
    makeRows();
    layout->addStretch();
    m_lockout.setSingleShot(true);
    m_lockout.setTimerType(Qt::PreciseTimer); // not a moment before the gate opens
    connect(&m_lockout, &QTimer::timeout, this, &MotorsPanel::refresh);
    connect(&context.controller, &Controller::armedChanged, this, &MotorsPanel::refresh);
    connect(&context.controller, &Controller::stateChanged, this, &MotorsPanel::refresh);
    connect(&context.controller, &Controller::deviceChanged, this, &MotorsPanel::refreshHint);
    connect(&context.controller, &Controller::ordersChanged, this, &MotorsPanel::showOrders);
    connect(&context.deviceSettings, &DeviceSettings::parameterChanged, this,
            &MotorsPanel::refresh);
    connect(&context.controller, &Controller::lockedOut, this, [this] {
        m_lockout.start(Controller::kStopLockout);
        refresh();
    });
    refresh();
    showOrders();
}

void MotorsPanel::makeControls()
{
    auto* layout = static_cast<QVBoxLayout*>(this->layout());
    m_arm = named(new QPushButton(theme::icon(u"arm"_s), tr("Arm"), this), u"motors.arm"_s,
                  tr("Arm the motors"));
    m_arm->setCheckable(true);
    auto* stop =
        named(new StopButton(context().controller, this), u"motors.stop"_s, tr("Stop all motors"));
    m_mode = named(new QComboBox(this), u"motors.mode"_s, tr("How a speed is reached"));
    m_mode->addItem(tr("Set at once"), u"set"_s);
    m_mode->addItem(tr("Accelerate"), u"accelerate"_s);
    m_link = named(new QCheckBox(tr("Link 1 and 2"), this), u"motors.link"_s,
                   tr("Move both motors together"));
    m_hint = named(new QLabel(this), u"motors.hint"_s, tr("What orders do"));
    m_hint->setWordWrap(true);
    m_hint->setForegroundRole(QPalette::PlaceholderText);

    auto* first = new QHBoxLayout;
    first->setSpacing(16); // Arm does not sit beside STOP by accident
    first->addWidget(m_arm, 1);
    first->addWidget(stop, 1);
    auto* second = new QHBoxLayout;
    second->setSpacing(8);
    second->addWidget(m_mode, 1);
    second->addWidget(m_link);
    layout->addLayout(first);
    layout->addLayout(second);
    layout->addWidget(m_hint);
    connect(m_arm, &QPushButton::clicked, this, &MotorsPanel::onArmClicked);
    connect(m_mode, &QComboBox::currentIndexChanged, this, &MotorsPanel::refreshHint);
}

void MotorsPanel::makeRows()
{
    struct RowSpec {
        MotorId motor;
        QString title;
        QString name;
    };
    const std::array specs{RowSpec{MotorId::Motor1, tr("Motor 1"), u"motors.motor1"_s},
                           RowSpec{MotorId::Motor2, tr("Motor 2"), u"motors.motor2"_s},
                           RowSpec{MotorId::Aux, tr("Auxiliary motor"), u"motors.aux"_s}};
    for (const RowSpec& spec : specs) {
        auto* motorRow = new MotorRow(spec.motor, spec.title, spec.name, this);
        m_rows.at(static_cast<std::size_t>(spec.motor)) = motorRow;
        layout()->addWidget(motorRow);
        connect(motorRow, &MotorRow::speedWanted, this,
                [this, motor = spec.motor](int speed) { onSpeed(motor, speed); });
        connect(motorRow, &MotorRow::brakeWanted, this,
                [this, motor = spec.motor](int duty) { onBrake(motor, duty); });
    }
}

MotorRow& MotorsPanel::row(MotorId motor) const
{
    return *m_rows.at(static_cast<std::size_t>(motor));
}

MotorOrder MotorsPanel::orderFor(int speed) const
{
    const bool accelerate = m_mode->currentData().toString() == u"accelerate"_s;
    return {accelerate ? MotorOrder::Action::Accelerate : MotorOrder::Action::Set, speed};
}

bool MotorsPanel::isJoint() const
{
    const ParameterRow& mode = parameterRow("motor-mode");
    return context().deviceSettings.parameter(mode.number) == 1
        && !context().deviceSettings.isPending(mode.number);
}

void MotorsPanel::onArmClicked(bool wanted)
{
    if (wanted) {
        report(context().controller.arm());
    } else {
        context().controller.disarm();
    }
    refresh();
}

void MotorsPanel::onSpeed(MotorId motor, int speed)
{
    const MotorOrder order = orderFor(speed);
    if (m_link->isChecked() && motor != MotorId::Aux && !isJoint()) {
        row(MotorId::Motor1).setSpeed(speed);
        row(MotorId::Motor2).setSpeed(speed);
        report(context().controller.driveBoth(order, order));
    } else {
        report(context().controller.driveMotor(motor, order));
    }
}

void MotorsPanel::onBrake(MotorId motor, int duty)
{
    const MotorOrder order{MotorOrder::Action::Brake, duty};
    report(m_link->isChecked() ? context().controller.driveBoth(order, order)
                               : context().controller.driveMotor(motor, order));
}

void MotorsPanel::report(const Result<void>& result)
{
    if (!result) {
        context().log.add(EventLog::Warning, errorText(result.error()));
        showOrders(); // the sliders go back to what was sent
    }
}

/// The sliders show what was last sent: after a stop, from whichever control, they stand at zero.
void MotorsPanel::showOrders()
{
    for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
        const MotorOrder order = context().controller.lastOrder(motor);
        if (order.action == MotorOrder::Action::Brake) {
            row(motor).setBraking(order.amount);
        } else if (row(motor).speed() != order.amount || order.amount == 0) {
            row(motor).setSpeed(order.amount);
        }
    }
}

void MotorsPanel::refresh()
{
    const bool armed = context().controller.isArmed();
    const bool connected = context().controller.state() == LinkState::Connected;
    {
        const QSignalBlocker blocker(m_arm);
        m_arm->setChecked(armed);
    }
    m_arm->setText(armed ? tr("Disarm") : tr("Arm"));
    m_arm->setIcon(theme::icon(armed ? u"disarm"_s : u"arm"_s));
    m_arm->setEnabled(armed || (connected && !m_lockout.isActive()));
    for (MotorRow* motorRow : m_rows) {
        motorRow->setUsable(armed && !(motorRow == &row(MotorId::Motor2) && isJoint()));
    }
    m_link->setEnabled(!isJoint());
    refreshHint();
}

void MotorsPanel::refreshHint()
{
    const DeviceInfo& device = context().controller.device();
    QString hint;
    if (device.serialControls == false) {
        hint =
            tr("Serial does not control the motors now: an order waits in the controller and acts "
               "the moment serial override starts.");
    } else if (isJoint()) {
        hint = tr("Joint mode: motor 1 orders drive both H-bridges; motor 2 has none.");
    } else if (m_mode->currentData().toString() == u"accelerate"_s) {
        hint = tr(
            "Accelerate keeps to the acceleration, brake duration and current limit parameters.");
    } else {
        hint = tr("Set acts at once and overrides current limiting for the moment.");
    }
    m_hint->setText(hint);
}

} // namespace trex
