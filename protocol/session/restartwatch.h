// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/restartevidence.h"

#include <QObject>

namespace trex {

class Controller;
class TelemetryStore;

/// Notices a controller that was restarted under way, too short for the link to be lost: the next
/// order would move a motor that nobody expects to move. While armed it has the motor currents
/// read, whether a panel shows them or not. Main thread.
class RestartWatch : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RestartWatch)

public:
    RestartWatch(Controller& controller, const TelemetryStore& store, QObject* parent = nullptr);
    ~RestartWatch() override;

    static constexpr double kHertz = 20.0; ///< at least, of the currents

private:
    void look();
    void wantCurrents();

    Controller& m_controller;
    const TelemetryStore& m_store;
    RestartEvidence m_evidence;
    std::optional<Instant> m_last; ///< of the readings taken
};

} // namespace trex
