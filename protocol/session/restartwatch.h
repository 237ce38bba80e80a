// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/command.h"

#include <QObject>

namespace trex {

class Controller;
class TelemetryStore;

/// Notices a controller that was restarted under way, too short for the link to be lost: a reply
/// failed to come, and a motor that drew current draws none although its order stands. Nothing that
/// can be asked over the line would tell, and the next order would move a motor that nobody expects
/// to move. A current that ends without a lost reply proves nothing: a load may drive the motor.
/// Main thread.
class RestartWatch : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RestartWatch)

public:
    RestartWatch(Controller& controller, const TelemetryStore& store, QObject* parent = nullptr);

    static constexpr int kLeastSpeed = 20; ///< below, the current may be less than one count
    static constexpr int kLeastCounts = 3;
    static constexpr std::chrono::milliseconds kGone{250};
    static constexpr std::chrono::milliseconds kLostReplyCounts{3000};

private:
    struct Motor {
        MotorOrder order;
        Instant orderedAt;
        bool hadCurrent = false; ///< by this order
        std::optional<Instant> goneSince;
    };
    void look();
    [[nodiscard]] bool isGone(Motor& motor, const MotorOrder& order, int counts, Instant at) const;

    Controller& m_controller;
    const TelemetryStore& m_store;
    std::array<Motor, 2> m_motors{};
    quint64 m_timeouts = 0;
    std::optional<Instant> m_lostReply;
};

} // namespace trex
