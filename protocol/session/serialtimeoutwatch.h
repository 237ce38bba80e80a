// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/quantities.h"

#include <QObject>

namespace trex {

class Controller;
class DeviceSettings;

/// What the controller does by itself when nobody speaks any more (parameter 0x07). Reads it once a
/// connection is there; keeps it from acting while the gate is open, by a byte at least every third
/// of its time; says whether it would stop the motors of a host that died. Main thread.
class SerialTimeoutWatch : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(SerialTimeoutWatch)

public:
    enum class State : std::uint8_t {
        Unknown, ///< not connected, or not read yet
        Off, ///< motors run on when this program, its computer or the cable dies
        On,
    };
    /// What setIt() writes, in units of 100 ms: longer than any wait for one reply of ours, and
    /// short for a motor that runs away.
    static constexpr int kSensible = 5;

    SerialTimeoutWatch(Controller& controller, DeviceSettings& settings, QObject* parent = nullptr);
    [[nodiscard]] State state() const;
    [[nodiscard]] std::chrono::milliseconds timeout() const; ///< 0 when it is off or unknown
    void setIt(); ///< writes kSensible, verified and journalled as every write

    /// How often a query has to be sent so that the line is never silent for more than a third of
    /// this timeout; 0: no need.
    [[nodiscard]] static double keepAliveHertz(std::chrono::milliseconds timeout);

signals:
    void changed();

private:
    void onConnected();
    void refresh();
    void tell(int severity, const QString& text); ///< with the façade's own events

    Controller& m_controller;
    DeviceSettings& m_settings;
    State m_state = State::Unknown;
};

} // namespace trex
