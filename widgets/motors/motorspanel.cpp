// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motors/motorspanel.h"

#include "protocol/errortext.h"
#include "protocol/session/devicesettings.h"
#include "protocol/session/drivemix.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/safetysettings.h"
#include "widgets/common/stopbutton.h"
#include "widgets/common/theme.h"
#include "widgets/common/uisettings.h"
#include "widgets/motors/drivepad.h"
#include "widgets/motors/gamepad.h"
#include "widgets/motors/motorrow.h"
#include "widgets/motors/safetydialog.h"
#include "widgets/motors/timeoutbanner.h"
#include "widgets/motors/watchdogdialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
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
    makePad();
    makeRows();
    layout->addStretch();
    listen();
    followSettings();
    refresh();
    showOrders();
}

void MotorsPanel::listen()
{
    m_lockout.setSingleShot(true);
    m_lockout.setTimerType(Qt::PreciseTimer); // not a moment before the gate opens
    connect(&m_lockout, &QTimer::timeout, this, &MotorsPanel::refresh);
    const Controller& controller = context().controller;
    connect(&controller, &Controller::armedChanged, this, &MotorsPanel::refresh);
    connect(&controller, &Controller::stateChanged, this, &MotorsPanel::refresh);
    connect(&controller, &Controller::deviceChanged, this, &MotorsPanel::refreshHint);
    connect(&controller, &Controller::ordersChanged, this, &MotorsPanel::showOrders);
    connect(&context().deviceSettings, &DeviceSettings::parameterChanged, this,
            &MotorsPanel::refresh);
    connect(&context().settings, &UiSettings::changed, this, &MotorsPanel::followSettings);
    connect(&controller, &Controller::lockedOut, this, [this] {
        m_lockout.start(Controller::kStopLockout);
        m_pad->springBack();
        refresh();
    });
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
    layout->addWidget(new TimeoutBanner(context(), this));
    layout->addLayout(second);
    makeOptions();
    layout->addWidget(m_hint);
    connect(m_arm, &QPushButton::clicked, this, &MotorsPanel::onArmClicked);
    connect(m_mode, &QComboBox::currentIndexChanged, this, &MotorsPanel::refreshHint);
}

/// One row for what is chosen seldom; the rest is behind its menu.
void MotorsPanel::makeOptions()
{
    m_hold = named(new QCheckBox(tr("Hold to run"), this), u"motors.hold"_s,
                   tr("Motors run only while a control is held"));
    m_hold->setToolTip(tr("A slider springs to zero when it is let go, loses the focus, or its "
                          "window goes behind another."));
    m_padShown = named(new QPushButton(tr("Drive pad"), this), u"motors.padShown"_s,
                       tr("Show the drive pad"));
    m_padShown->setCheckable(true);
    m_padShown->setToolTip(tr("Drives both motors like one stick, in place of their sliders."));
    auto* more = named(new QPushButton(theme::icon(u"settings"_s), tr("More"), this),
                       u"motors.more"_s, tr("More about the motors"));
    auto* menu = new QMenu(more);
    QAction* safety = menu->addAction(tr("Safety and limits…"), this, &MotorsPanel::openSafety);
    safety->setObjectName(u"motors.safety"_s);
    QAction* proof = menu->addAction(tr("Watchdog proof…"), this, &MotorsPanel::openProof);
    proof->setObjectName(u"motors.proof"_s);
    more->setMenu(menu);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(m_hold);
    row->addStretch();
    row->addWidget(m_padShown);
    row->addWidget(more);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    connect(m_hold, &QCheckBox::toggled, this,
            [this](bool holds) { context().settings.set(settings::kHoldToRun, holds); });
    connect(m_padShown, &QPushButton::toggled, this, &MotorsPanel::onPadShown);
}

void MotorsPanel::makePad()
{
    m_pad = named(new DrivePad(this), u"motors.pad"_s,
                  tr("Drive pad: hold and pull, or hold the arrow keys"));
    m_pad->hide();
    layout()->addWidget(m_pad);
    connect(m_pad, &DrivePad::moved, this, &MotorsPanel::onPad);
    m_gamepad = new Gamepad(this);
    m_gamepadText = named(new QLabel(this), u"motors.gamepad"_s, tr("Gamepad"));
    m_gamepadText->setWordWrap(true);
    m_gamepadText->hide();
    layout()->addWidget(m_gamepadText);
    connect(m_gamepad, &Gamepad::moved, m_pad, &DrivePad::steer);
    connect(m_gamepad, &Gamepad::nameChanged, this, &MotorsPanel::refreshGamepad);
}

void MotorsPanel::onPadShown(bool shown)
{
    m_pad->springBack();
    m_padShown->setText(shown ? tr("Sliders") : tr("Drive pad"));
    if (!shown) {
        m_pad->hide(); // one of both at a time: the window need not grow
    }
    for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2}) {
        row(motor).setVisible(!shown);
    }
    m_pad->setVisible(shown);
    m_gamepad->listen(shown);
    refreshGamepad();
}

void MotorsPanel::refreshGamepad()
{
    m_gamepadText->setVisible(m_padShown->isChecked() && !m_gamepad->name().isEmpty());
    m_gamepadText->setText(
        tr("%1: hold a shoulder button and pull the left stick.").arg(m_gamepad->name()));
}

/// Mixed here: the controller's own mixing acts on its channels only.
void MotorsPanel::onPad(int forward, int turn)
{
    if (!context().controller.isArmed() && forward == 0 && turn == 0) {
        return; // it sprang back because the gate had closed
    }
    const auto [first, second] = mixed(forward, isJoint() ? 0 : turn);
    if (isJoint()) {
        report(context().controller.driveMotor(MotorId::Motor1, orderFor(first)));
    } else {
        report(context().controller.driveBoth(orderFor(first), orderFor(second)));
    }
}

void MotorsPanel::followSettings()
{
    const UiSettings& stored = context().settings;
    const MotionLimits limits = motionLimits(stored);
    const bool springs = stored.value(settings::kHoldToRun);
    const int step = std::clamp(stored.value(settings::kSliderStep), 1, kFullSpeed);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows.at(i)->setLimit(limits.maximum.at(i), step);
        m_rows.at(i)->setSpring(springs);
    }
    m_pad->setKeySpeed(std::clamp(stored.value(settings::kHoldSpeed), 1, kFullSpeed));
    const QSignalBlocker blocker(m_hold);
    m_hold->setChecked(springs);
    showOrders();
}

void MotorsPanel::openSafety()
{
    (new SafetyDialog(context(), window()))->show();
}

void MotorsPanel::openProof()
{
    (new WatchdogDialog(context(), window()))->show();
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
        row(motor).setReached(context().controller.sentOrder(motor).amount);
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
    m_pad->setEnabled(armed);
    m_link->setEnabled(!isJoint());
    refreshHint();
}

void MotorsPanel::refreshHint()
{
    const DeviceInfo& device = context().controller.device();
    QString hint;
    if (context().controller.isRecording()) {
        hint = tr("Of the recording: the sliders show what was sent then.");
    } else if (device.serialControls == false) {
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
