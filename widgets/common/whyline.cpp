// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/whyline.h"

#include "protocol/errortext.h"
#include "protocol/session/controller.h"
#include "widgets/common/eventlog.h"
#include "widgets/common/panel.h"
#include "widgets/common/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace trex {

using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;

namespace {

constexpr auto kStoppedShown = 5s;
constexpr int kShapeSize = 14;
constexpr int kMargin = 8;

QString remedyText(WhyLine::Remedy remedy)
{
    switch (remedy) {
    case WhyLine::Remedy::Connect:
        return WhyLine::tr("Connect");
    case WhyLine::Remedy::Disconnect:
        return WhyLine::tr("Disconnect");
    case WhyLine::Remedy::Arm:
        return WhyLine::tr("Arm");
    case WhyLine::Remedy::Disarm:
        return WhyLine::tr("Disarm");
    case WhyLine::Remedy::None:
        break;
    }
    return {};
}

QString orderText(const MotorOrder& order)
{
    const int percent = qRound(std::abs(order.amount) * 100.0 / kFullSpeed);
    if (order.action == MotorOrder::Action::Brake) {
        return WhyLine::tr("braking %1 %").arg(percent);
    }
    if (order.amount == 0) {
        return WhyLine::tr("at zero");
    }
    return order.amount > 0 ? WhyLine::tr("forward %1 %").arg(percent)
                            : WhyLine::tr("reverse %1 %").arg(percent);
}

bool isDriven(const Controller& controller)
{
    for (const auto motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
        if (controller.lastOrder(motor).amount != 0) {
            return true;
        }
    }
    return false;
}

} // namespace

WhyLine::WhyLine(Controller& controller, EventLog& log, QWidget* parent)
    : QWidget(parent)
    , m_controller(controller)
    , m_log(log)
    , m_text(named(new QLabel(this), u"why.text"_s, tr("Why the motors do or do not move")))
    , m_remedy(named(new QPushButton(this), u"why.remedy"_s))
{
    m_text->setTextFormat(Qt::PlainText);
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(kMargin + kShapeSize + kMargin, 4, kMargin, 4);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_remedy);

    m_stoppedFor.setSingleShot(true);
    m_lockout.setSingleShot(true);
    m_lockout.setTimerType(Qt::PreciseTimer); // a coarse one may end before the lockout does
    connect(&m_stoppedFor, &QTimer::timeout, this, &WhyLine::refresh);
    connect(&m_lockout, &QTimer::timeout, this, &WhyLine::refresh);
    connect(m_remedy, &QPushButton::clicked, this, &WhyLine::onRemedy);
    connect(&controller, &Controller::stateChanged, this, &WhyLine::refresh);
    connect(&controller, &Controller::deviceChanged, this, &WhyLine::refresh);
    connect(&controller, &Controller::armedChanged, this, &WhyLine::refresh);
    connect(&controller, &Controller::ordersChanged, this, &WhyLine::refresh);
    connect(&controller, &Controller::lockedOut, this, &WhyLine::onStopped);
    refresh();
}

QString WhyLine::text() const
{
    return m_text->text();
}

WhyLine::Reason WhyLine::unconnectedReason() const
{
    switch (m_controller.state()) {
    case LinkState::Connecting:
        return {StateShape::Stale, tr("Connecting to %1…").arg(m_controller.options().port),
                Remedy::Disconnect};
    case LinkState::Lost:
    case LinkState::Retrying:
        if (const auto error = m_controller.lastError(); error && !m_wasConnected) {
            return {StateShape::Warning, tr("%1 Trying again.").arg(errorText(*error)),
                    Remedy::Disconnect};
        }
        return {StateShape::Fault,
                tr("The link is lost: what the motors do now is not known. Trying again."),
                Remedy::Disconnect};
    default:
        break;
    }
    if (const auto error = m_controller.lastError()) {
        return {StateShape::Warning, errorText(*error), Remedy::Connect};
    }
    return {StateShape::Off, tr("Not connected: connect to a controller, or simulate one."),
            Remedy::Connect};
}

QString WhyLine::ordersText() const
{
    return tr("motor 1 %1, motor 2 %2, auxiliary %3")
        .arg(orderText(m_controller.lastOrder(MotorId::Motor1)),
             orderText(m_controller.lastOrder(MotorId::Motor2)),
             orderText(m_controller.lastOrder(MotorId::Aux)));
}

WhyLine::Reason WhyLine::armedReason() const
{
    const std::optional<bool> obeys = m_controller.device().serialControls;
    const bool driven = isDriven(m_controller);
    if (obeys == false && driven) {
        // conformance C-50: the last command waits in the controller
        return {StateShape::Warning,
                tr("Command pending: the channels control the motors now. It acts at the moment "
                   "serial takes over."),
                Remedy::Disarm};
    }
    if (obeys == false) {
        return {
            StateShape::Warning,
            tr("Armed, but the channels control the motors: commands will wait in the controller."),
            Remedy::Disarm};
    }
    if (driven) {
        return {StateShape::Ok, tr("Driving: %1.").arg(ordersText()), Remedy::Disarm};
    }
    return {StateShape::Ok, tr("Armed: move a slider to drive. Esc stops."), Remedy::Disarm};
}

WhyLine::Reason WhyLine::reason() const
{
    if (m_controller.state() != LinkState::Connected) {
        return unconnectedReason();
    }
    if (m_controller.isArmed()) {
        return armedReason();
    }
    if (m_stoppedFor.isActive()) {
        return {StateShape::Warning,
                tr("Stopped: all motors were told to stop. Arm to drive again."), Remedy::Arm};
    }
    if (m_controller.device().serialControls == false) {
        return {
            StateShape::Off,
            m_controller.device().mode && isSerial(*m_controller.device().mode)
                ? tr("Disarmed. The channels control the motors now.")
                : tr("Disarmed. The controller is in RC or analog mode: its channels control the "
                     "motors."),
            Remedy::Arm};
    }
    return {StateShape::Off, tr("Disarmed: nothing is sent to the motors. Arm to drive them."),
            Remedy::Arm};
}

void WhyLine::refresh()
{
    const LinkState state = m_controller.state();
    m_wasConnected = state == LinkState::Connected
        || (m_wasConnected && state != LinkState::Disconnected && state != LinkState::Connecting);
    m_reason = reason();
    m_text->setText(m_reason.sentence);
    m_text->setToolTip(m_reason.sentence);
    m_remedy->setVisible(m_reason.remedy != Remedy::None);
    m_remedy->setText(remedyText(m_reason.remedy));
    m_remedy->setAccessibleDescription(m_reason.sentence);
    m_remedy->setEnabled(m_reason.remedy != Remedy::Arm || !m_lockout.isActive());
    update();
}

void WhyLine::onStopped()
{
    m_stoppedFor.start(kStoppedShown);
    m_lockout.start(Controller::kStopLockout);
    refresh();
}

void WhyLine::onRemedy()
{
    switch (m_reason.remedy) {
    case Remedy::Connect:
        emit connectRequested();
        break;
    case Remedy::Disconnect:
        m_controller.close();
        break;
    case Remedy::Disarm:
        m_controller.disarm();
        break;
    case Remedy::Arm:
        if (const Result<void> armed = m_controller.arm(); !armed) {
            m_log.add(EventLog::Warning, errorText(armed.error()));
        }
        break;
    case Remedy::None:
        break;
    }
}

void WhyLine::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), theme::colour(ColourRole::Panel));
    painter.setPen(theme::colour(ColourRole::Border));
    painter.drawLine(QPointF(0, height() - 0.5), QPointF(width(), height() - 0.5));
    drawStateShape(painter, QRectF(kMargin, (height() - kShapeSize) / 2.0, kShapeSize, kShapeSize),
                   m_reason.shape);
}

} // namespace trex
