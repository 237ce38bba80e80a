// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/motionreason.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace trex {

using namespace motionfacts;

namespace {

constexpr QLatin1StringView kChannels("channels");
constexpr QLatin1StringView kStatus("status");
constexpr QLatin1StringView kParameters("parameters");

QString words(const char* text)
{
    return QCoreApplication::translate("MotionReason", text);
}

using Facts = const MotionFacts&;
struct CauseRow {
    MotionCause cause;
    bool (*holds)(Facts);
    MotionLook look;
    const char* text;
    MotionRemedy remedy = MotionRemedy::None;
    QLatin1StringView panel{};
    QStringList (*arguments)(Facts) = nullptr;
    bool isGuess = false;
};

constexpr std::array kCauses{
    CauseRow{.cause = MotionCause::StopAsked,
             .holds = [](Facts f) { return !isDisconnected(f) && f.stop == StopProgress::Asked; },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "Stopping: the stop is on its way to all three motors."),
             .remedy = MotionRemedy::None},
    CauseRow{.cause = MotionCause::StopFailed,
             .holds = [](Facts f) { return !isDisconnected(f) && f.stop == StopProgress::Failed; },
             .look = MotionLook::Fault,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "The stop could NOT be confirmed: the motors may still run. "
                                       "Cut their power if they do."),
             .remedy = MotionRemedy::Stop},
    CauseRow{.cause = MotionCause::Connecting,
             .holds = [](Facts f) { return f.link == LinkState::Connecting; },
             .look = MotionLook::Waiting,
             .text = QT_TRANSLATE_NOOP("MotionReason", "Connecting to %1…"),
             .remedy = MotionRemedy::Disconnect,
             .arguments = [](Facts f) -> QStringList { return {f.port}; }},
    CauseRow{.cause = MotionCause::NotFound,
             .holds = [](Facts f) { return isTrying(f) && f.error && !f.wasConnected; },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason", "%1 Trying again."),
             .remedy = MotionRemedy::Disconnect,
             .arguments = errorWords},
    CauseRow{.cause = MotionCause::LinkLost,
             .holds = [](Facts f) { return isTrying(f) && f.error.has_value(); },
             .look = MotionLook::Fault,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "%1 What the motors do now is not known. Trying again."),
             .remedy = MotionRemedy::Disconnect,
             .arguments = errorWords},
    CauseRow{
        .cause = MotionCause::LinkLost,
        .holds = isTrying,
        .look = MotionLook::Fault,
        .text = QT_TRANSLATE_NOOP(
            "MotionReason", "The link is lost: what the motors do now is not known. Trying again."),
        .remedy = MotionRemedy::Disconnect},
    CauseRow{.cause = MotionCause::LinkError,
             .holds = [](Facts f) { return isDisconnected(f) && f.error.has_value(); },
             .look = MotionLook::Warning,
             .text = "%1", // the error says all
             .remedy = MotionRemedy::Connect,
             .arguments = errorWords},
    CauseRow{.cause = MotionCause::NotConnected,
             .holds = [](Facts f) { return !isConnected(f); },
             .look = MotionLook::Off,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "Not connected: connect to a controller, or simulate one."),
             .remedy = MotionRemedy::Connect},
    CauseRow{.cause = MotionCause::Proving,
             .holds = [](Facts f) { return f.isProving; },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP(
                 "MotionReason", "The watchdog proof runs: nothing is sent on purpose. Esc stops."),
             .remedy = MotionRemedy::Stop},
    CauseRow{
        .cause = MotionCause::StallGuard,
        .holds = [](Facts f) { return f.isRampingDown; },
        .look = MotionLook::Fault,
        .text = QT_TRANSLATE_NOOP(
            "MotionReason",
            "Stall guard: a motor drew too much current for too long. All motors are led to zero."),
        .remedy = MotionRemedy::Stop},
    CauseRow{.cause = MotionCause::LockedOut,
             .holds = [](Facts f) { return f.isLockedOut && isDisarmedByHand(f); },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "Stopped: all motors were told to stop. Arming is locked "
                                       "for half a second."),
             .remedy = MotionRemedy::Arm},
    CauseRow{.cause = MotionCause::Stopped,
             .holds = [](Facts f) { return f.isJustStopped && isDisarmedByHand(f); },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP(
                 "MotionReason", "Stopped: all motors were told to stop. Arm to drive again."),
             .remedy = MotionRemedy::Arm},
    CauseRow{.cause = MotionCause::DriverFault,
             .holds = [](Facts f) { return (f.status & kDriverFault) != 0; },
             .look = MotionLook::Fault,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "Motor %1: its driver reports a fault and has switched off. "
                                       "Look for a short circuit, heat or a weak supply."),
             .remedy = MotionRemedy::OpenPanel,
             .panel = kStatus,
             .arguments = faultyMotor},
    CauseRow{
        .cause = MotionCause::RequiredChannelMissing,
        .holds = [](Facts f) { return missingChannel(f) > 0; },
        .look = MotionLook::Warning,
        .text = QT_TRANSLATE_NOOP("MotionReason",
                                  "Motors off: channel %1 is required and brings no valid pulse. "
                                  "Switch the transmitter on, or change the required channels."),
        .remedy = MotionRemedy::OpenPanel,
        .panel = kParameters,
        .arguments = [](Facts f) -> QStringList { return {QString::number(missingChannel(f))}; }},
    CauseRow{
        .cause = MotionCause::OverrideActive,
        .holds =
            [](Facts f) { return hasChannelMode(f) && f.serialControls == true && !f.isArmed; },
        .look = MotionLook::Warning,
        .text = QT_TRANSLATE_NOOP("MotionReason",
                                  "Serial override: channel 5 has given the motors to this "
                                  "program. Arm to drive, or switch channel 5 back."),
        .remedy = MotionRemedy::Arm},
    CauseRow{
        .cause = MotionCause::SafeStart,
        .holds = isSafeStartLikely,
        .look = MotionLook::Warning,
        .text = QT_TRANSLATE_NOOP("MotionReason",
                                  "Probably safe-start: channel %1 is not at neutral, and no motor "
                                  "draws current. Bring all motor channels to neutral (inferred)."),
        .remedy = MotionRemedy::OpenPanel,
        .panel = kChannels,
        .arguments = [](Facts f) -> QStringList {
            return {QString::number(std::abs(remappedOf(f, 0)) > kNearNeutral ? 1 : 2)};
        },
        .isGuess = true},
    CauseRow{.cause = MotionCause::CommandPending,
             .holds = [](Facts f) { return f.isArmed && f.serialControls == false && isDriven(f); },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "Command pending: the channels control the motors now. It "
                                       "acts at the moment serial takes over."),
             .remedy = MotionRemedy::Disarm},
    CauseRow{.cause = MotionCause::ArmedWithoutControl,
             .holds = [](Facts f) { return f.isArmed && f.serialControls == false; },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "Armed, but the channels control the motors (mode jumper, "
                                       "channel 5): commands will wait in the controller."),
             .remedy = MotionRemedy::Disarm},
    CauseRow{.cause = MotionCause::ChannelsDrive,
             .holds = [](Facts f) { return f.serialControls == false && doChannelsOrder(f); },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "The channels drive the motors: motor 1 %1, motor 2 %2. "
                                       "They do not hear this program."),
             .remedy = MotionRemedy::OpenPanel,
             .panel = kChannels,
             .arguments = channelOrders},
    CauseRow{
        .cause = MotionCause::ChannelsControl,
        .holds = [](Facts f) { return f.serialControls == false; },
        .look = MotionLook::Off,
        .text = QT_TRANSLATE_NOOP(
            "MotionReason",
            "Disarmed. The controller is in RC or analog mode: its channels control the motors."),
        .remedy = MotionRemedy::OpenPanel,
        .panel = kChannels},
    CauseRow{.cause = MotionCause::TimeoutLatched,
             .holds = [](Facts f) { return !f.isArmed && (f.uart & kTimeout) != 0; },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "Motors off: the serial timeout has stopped them, nothing "
                                       "was heard for its time. Arm to drive again."),
             .remedy = MotionRemedy::Arm},
    CauseRow{.cause = MotionCause::UartShutdown,
             .holds = [](Facts f) { return (f.uart & ~kTimeout) != 0 && f.uartErrorShutdown == 1; },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "Motors off: the controller heard an error on the line and "
                                       "is set to stop for it. The next order drives again."),
             .remedy = MotionRemedy::OpenPanel,
             .panel = kStatus},
    CauseRow{.cause = MotionCause::CurrentLimited,
             .holds = isLimited,
             .look = MotionLook::Warning,
             .text =
                 QT_TRANSLATE_NOOP("MotionReason", "Motor %1 is held back by its current limit."),
             .remedy = MotionRemedy::OpenPanel,
             .panel = kParameters,
             .arguments = overCurrentMotor},
    CauseRow{.cause = MotionCause::OverCurrent,
             .holds = [](Facts f) { return (f.status & kOverCurrent) != 0; },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "Motor %1 drew more current than its limit a moment ago."),
             .remedy = MotionRemedy::OpenPanel,
             .panel = kStatus,
             .arguments = overCurrentMotor},
    CauseRow{.cause = MotionCause::DisarmedFor,
             .holds = isDisarmedFor,
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason", "Disarmed: %1. Arm to drive again."),
             .remedy = MotionRemedy::Arm,
             .arguments = disarmedWords},
    CauseRow{.cause = MotionCause::Disarmed,
             .holds = [](Facts f) { return !f.isArmed; },
             .look = MotionLook::Off,
             .text = QT_TRANSLATE_NOOP(
                 "MotionReason", "Disarmed: nothing is sent to the motors. Arm to drive them."),
             .remedy = MotionRemedy::Arm},
    CauseRow{.cause = MotionCause::JointMode,
             .holds =
                 [](Facts f) {
                     return f.isJoint == true && isMoved(f.orders[1]) && !isMoved(f.orders[0]);
                 },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP(
                 "MotionReason",
                 "Joint mode: both bridges follow motor 1. Orders to motor 2 do nothing."),
             .remedy = MotionRemedy::OpenPanel,
             .panel = kParameters},
    CauseRow{.cause = MotionCause::Braking,
             .holds = isBraking,
             .look = MotionLook::Ok,
             .text = QT_TRANSLATE_NOOP("MotionReason", "Braking: %1."),
             .remedy = MotionRemedy::Disarm,
             .arguments = [](Facts f) -> QStringList { return {ordersText(f.orders)}; }},
    CauseRow{.cause = MotionCause::Ramping,
             .holds = [](Facts f) { return f.sent != f.orders; },
             .look = MotionLook::Ok,
             .text = QT_TRANSLATE_NOOP("MotionReason", "Ramp: %1, on the way to the order."),
             .remedy = MotionRemedy::Disarm,
             .arguments = [](Facts f) -> QStringList { return {ordersText(f.sent)}; }},
    CauseRow{.cause = MotionCause::NoCurrent,
             .holds =
                 [](Facts f) {
                     return f.isSettled && f.isJoint != true && isWithoutCurrent(f)
                         && std::max(speedOf(f.orders[0]), speedOf(f.orders[1])) >= kWorthCurrent;
                 },
             .look = MotionLook::Warning,
             .text = QT_TRANSLATE_NOOP("MotionReason",
                                       "Ordered to move, but no motor draws current: probably none "
                                       "is connected, or their supply is off (inferred)."),
             .remedy = MotionRemedy::Disarm,
             .isGuess = true},
    CauseRow{.cause = MotionCause::Driving,
             .holds = isDriven,
             .look = MotionLook::Ok,
             .text = QT_TRANSLATE_NOOP("MotionReason", "Driving: %1."),
             .remedy = MotionRemedy::Disarm,
             .arguments = [](Facts f) -> QStringList { return {ordersText(f.orders)}; }},
    CauseRow{.cause = MotionCause::Armed,
             .holds = [](Facts) { return true; },
             .look = MotionLook::Ok,
             .text = QT_TRANSLATE_NOOP("MotionReason", "Armed: move a slider to drive. Esc stops."),
             .remedy = MotionRemedy::Disarm},
};

} // namespace

MotionReason motionReason(const MotionFacts& facts)
{
    const auto row = std::find_if(kCauses.begin(), kCauses.end(),
                                  [&facts](const CauseRow& r) { return r.holds(facts); });
    QString sentence = words(row->text); // the last row always holds
    const QStringList arguments = row->arguments != nullptr ? row->arguments(facts) : QStringList{};
    for (const QString& argument : arguments) {
        sentence = sentence.arg(argument);
    }
    return {row->cause, row->look, sentence, row->remedy, row->panel, row->isGuess};
}

} // namespace trex
