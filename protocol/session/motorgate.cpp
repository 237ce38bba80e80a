// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/motorgate.h"

#include <QCoreApplication>

#include <algorithm>

namespace trex {

namespace {

// Command documentation, 0x84 and 0x85.
constexpr std::uint8_t kMotor1OverCurrent = 0x20;
constexpr std::uint8_t kMotor2OverCurrent = 0x80;
constexpr std::uint8_t kMotor1Fault = 0x10;
constexpr std::uint8_t kMotor2Fault = 0x40;
constexpr std::uint8_t kTimeout = 0x80;

struct ReasonRow {
    DisarmReason reason;
    const char* text;
};
constexpr std::array kReasons{
    ReasonRow{DisarmReason::NeverArmed, QT_TRANSLATE_NOOP("Disarm", "not armed yet")},
    ReasonRow{DisarmReason::Person, QT_TRANSLATE_NOOP("Disarm", "on request")},
    ReasonRow{DisarmReason::Stop, QT_TRANSLATE_NOOP("Disarm", "stopped on request")},
    ReasonRow{DisarmReason::LinkLost, QT_TRANSLATE_NOOP("Disarm", "the link was lost")},
    ReasonRow{DisarmReason::Disconnected, QT_TRANSLATE_NOOP("Disarm", "disconnected")},
    ReasonRow{DisarmReason::Restarted, QT_TRANSLATE_NOOP("Disarm", "the controller was restarted")},
    ReasonRow{DisarmReason::SessionLocked, QT_TRANSLATE_NOOP("Disarm", "the screen was locked")},
    ReasonRow{DisarmReason::Suspending,
              QT_TRANSLATE_NOOP("Disarm", "the computer was going to sleep")},
    ReasonRow{DisarmReason::WindowHidden,
              QT_TRANSLATE_NOOP("Disarm", "no window of the program was to be seen any more")},
    ReasonRow{DisarmReason::Idle,
              QT_TRANSLATE_NOOP("Disarm", "no order was given for the idle time")},
    ReasonRow{DisarmReason::MotorFault,
              QT_TRANSLATE_NOOP("Disarm", "the controller reports a motor fault")},
    ReasonRow{DisarmReason::OverCurrent,
              QT_TRANSLATE_NOOP("Disarm", "the controller reports too much current")},
    ReasonRow{DisarmReason::UartError,
              QT_TRANSLATE_NOOP("Disarm", "the controller reports an error on the line")},
    ReasonRow{
        DisarmReason::SerialTimeout,
        QT_TRANSLATE_NOOP("Disarm", "the controller's serial timeout has stopped the motors")},
    ReasonRow{DisarmReason::Stalled,
              QT_TRANSLATE_NOOP("Disarm", "the stall guard has stopped them")},
    ReasonRow{DisarmReason::LanguageSwitch,
              QT_TRANSLATE_NOOP("Disarm", "the language was changed")},
    ReasonRow{DisarmReason::Frozen,
              QT_TRANSLATE_NOOP("Disarm", "the program did not answer for a while")},
};

QString motorsText(bool motor1, bool motor2)
{
    return motor1 && motor2 ? QCoreApplication::translate("Disarm", "motors 1 and 2")
        : motor1            ? QCoreApplication::translate("Disarm", "motor 1")
                            : QCoreApplication::translate("Disarm", "motor 2");
}

constexpr std::size_t indexOf(MotorId motor)
{
    return static_cast<std::size_t>(motor);
}

} // namespace

QString disarmText(DisarmReason reason)
{
    const auto* row = std::find_if(kReasons.begin(), kReasons.end(),
                                   [reason](const ReasonRow& r) { return r.reason == reason; });
    return row == kReasons.end() ? QString() : QCoreApplication::translate("Disarm", row->text);
}

Result<void> MotorGate::check(Instant now) const
{
    if (isLockedOut(now)) {
        return fail(ErrorCode::LockedOut);
    }
    return m_armed ? Result<void>{} : fail(ErrorCode::Disarmed);
}

void MotorGate::arm(Instant now)
{
    m_armed = true;
    m_lastOrder = now;
}

bool MotorGate::disarm(DisarmReason reason, const QString& detail)
{
    if (!std::exchange(m_armed, false)) {
        return false;
    }
    m_disarming = {reason, detail, QDateTime::currentDateTime()};
    return true;
}

const MotorOrder& MotorGate::order(MotorId motor) const
{
    return m_orders.at(indexOf(motor));
}

void MotorGate::setOrder(MotorId motor, const MotorOrder& order, Instant now)
{
    m_orders.at(indexOf(motor)) = order;
    m_lastOrder = now;
}

bool MotorGate::isAtNeutral() const
{
    return std::all_of(m_orders.begin(), m_orders.end(), [](const MotorOrder& order) {
        return order.amount == 0 || order.action == MotorOrder::Action::Brake;
    });
}

bool MotorGate::isIdle(Instant now) const
{
    return m_armed && m_rules.idle.count() > 0 && isAtNeutral()
        && now - m_lastOrder >= m_rules.idle;
}

std::optional<Disarming> MotorGate::faultIn(bool uart, std::uint8_t bits) const
{
    if (uart) {
        if (m_rules.serialTimeout && (bits & kTimeout) != 0) {
            return Disarming{DisarmReason::SerialTimeout, {}, {}};
        }
        if (m_rules.uartError && (bits & ~kTimeout) != 0) {
            return Disarming{DisarmReason::UartError, {}, {}};
        }
        return std::nullopt;
    }
    if (m_rules.motorFault && (bits & (kMotor1Fault | kMotor2Fault)) != 0) {
        return Disarming{DisarmReason::MotorFault,
                         motorsText((bits & kMotor1Fault) != 0, (bits & kMotor2Fault) != 0),
                         {}};
    }
    if (m_rules.overCurrent && (bits & (kMotor1OverCurrent | kMotor2OverCurrent)) != 0) {
        return Disarming{
            DisarmReason::OverCurrent,
            motorsText((bits & kMotor1OverCurrent) != 0, (bits & kMotor2OverCurrent) != 0),
            {}};
    }
    return std::nullopt;
}

void MotorGate::stopAsked(const std::vector<quint64>& packets, Instant now)
{
    m_orders = {};
    m_stopPackets = packets;
    m_stopAsked = now;
    m_lockedUntil = now + kLockout;
    m_progress = StopProgress::Asked;
}

MotorGate::StopStep MotorGate::stopRecorded(quint64 packet, bool hasLeft)
{
    const auto place = std::find(m_stopPackets.begin(), m_stopPackets.end(), packet);
    if (place == m_stopPackets.end()) {
        return StopStep::NotOurs;
    }
    m_stopPackets.erase(place);
    if (!hasLeft) {
        m_stopPackets.clear();
        m_progress = StopProgress::Failed;
        return StopStep::Failed;
    }
    if (!m_stopPackets.empty()) {
        return StopStep::More;
    }
    m_progress = StopProgress::Sent;
    return StopStep::Sent;
}

double MotorGate::stopSent(Instant sent)
{
    const double ms = std::chrono::duration<double, std::milli>(sent - m_stopAsked).count();
    m_stopLatencyMsMax = std::max(m_stopLatencyMsMax, ms);
    return ms;
}

void MotorGate::stopGivenUp()
{
    m_stopPackets.clear();
    m_progress = StopProgress::Failed;
}

} // namespace trex
