// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/command.h"
#include "protocol/result.h"

#include <QDateTime>

#include <array>
#include <vector>

namespace trex {

/// What closed the gate. Every way out names itself, so that a person can be told.
enum class DisarmReason : std::uint8_t {
    NeverArmed,
    Person, ///< Disarm
    Stop, ///< STOP, Esc
    LinkLost,
    Disconnected,
    Restarted, ///< the controller was off, or may have been
    SessionLocked,
    Suspending,
    WindowHidden,
    Idle,
    MotorFault,
    OverCurrent,
    UartError,
    SerialTimeout, ///< the controller stopped by itself and latched it
    Stalled, ///< the stall guard
    LanguageSwitch,
    Frozen, ///< the program did not answer for a while
};
/// A clause for the log and the why-line, without full stop: "the link was lost".
[[nodiscard]] QString disarmText(DisarmReason reason);

/// The latest closing of the gate.
struct Disarming {
    DisarmReason reason = DisarmReason::NeverArmed;
    QString detail; ///< what more is known, as a clause; may be empty
    QDateTime time;
};

/// What a person chose to disarm for. The rest (a lost link, a restart, STOP …) always does.
struct DisarmRules {
    bool motorFault = true;
    bool overCurrent = false; ///< a current limit at work latches it, too
    bool uartError = false; ///< any but the timeout
    bool serialTimeout = true;
    std::chrono::seconds idle{600}; ///< all motors at neutral and no order for so long; 0: never
    bool operator==(const DisarmRules&) const = default;
};

/// How far the latest stop has come, by the records of its packets.
enum class StopProgress : std::uint8_t { None, Asked, Sent, Failed };

/// The state of the motor gate: open or closed and why, the lock-out after a stop, the orders that
/// hold, the stop under way. Pure: time comes in as argument. Controller is its one user.
class MotorGate {
public:
    static constexpr std::chrono::milliseconds kLockout{500};

    [[nodiscard]] bool isArmed() const { return m_armed; }
    [[nodiscard]] const Disarming& lastDisarming() const { return m_disarming; }
    [[nodiscard]] bool isLockedOut(Instant now) const
    {
        return m_lockedUntil && now < *m_lockedUntil;
    }
    /// Errors: LockedOut, Disarmed.
    [[nodiscard]] Result<void> check(Instant now) const;
    void arm(Instant now);
    bool disarm(DisarmReason reason, const QString& detail); ///< true: it was armed

    [[nodiscard]] const MotorOrder& order(MotorId motor) const;
    void setOrder(MotorId motor, const MotorOrder& order, Instant now);
    void forgetOrders() { m_orders = {}; } ///< all at neutral
    [[nodiscard]] bool isAtNeutral() const;
    [[nodiscard]] bool isIdle(Instant now) const; ///< armed, by the rules' time

    void setRules(const DisarmRules& rules) { m_rules = rules; }
    [[nodiscard]] const DisarmRules& rules() const { return m_rules; }
    /// What in a status or UART error byte closes the gate by the rules; none: nothing.
    [[nodiscard]] std::optional<Disarming> faultIn(bool uart, std::uint8_t bits) const;

    void stopAsked(const std::vector<quint64>& packets, Instant now);
    enum class StopStep : std::uint8_t { NotOurs, More, Sent, Failed };
    /// A stop packet's record: has it left, and was it the last?
    StopStep stopRecorded(quint64 packet, bool hasLeft);
    void stopGivenUp(); ///< no record came in time
    [[nodiscard]] StopProgress stopProgress() const { return m_progress; }
    /// The last stop's bytes were handed to the line then; returns the milliseconds since it was
    /// asked.
    double stopSent(Instant sent);
    [[nodiscard]] double stopLatencyMsMax() const { return m_stopLatencyMsMax; }
    void newLine() { m_stopLatencyMsMax = 0.0; }

private:
    bool m_armed = false;
    Disarming m_disarming;
    DisarmRules m_rules;
    std::array<MotorOrder, 3> m_orders{};
    Instant m_lastOrder; ///< or the arming
    std::optional<Instant> m_lockedUntil;
    std::vector<quint64> m_stopPackets; ///< not yet recorded
    StopProgress m_progress = StopProgress::None;
    Instant m_stopAsked;
    double m_stopLatencyMsMax = 0.0;
};

} // namespace trex
