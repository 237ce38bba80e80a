// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulated controllers heard and did, as JSON Lines, for tests that watch from outside.
#pragma once

#include "protocol/sim/simulatedline.h"

#include <QFile>

namespace trex::sim {

/// One object a line, flushed at once:
/// {"ms":12.3,"epochMs":1700000000000.0,"device":7,"event":"packet","kind":"motor","bytes":"C240"}
/// {"ms":12.3,"epochMs":…,"device":7,"event":"output","motor":1,"speed":64,"brake":0}
/// {"ms":12.3,"epochMs":…,"device":7,"event":"eeprom","writes":1,"total":9}, in bytes: a
/// calibration is eight; `total` is over the controller's life, with a state file
/// {"ms":0,"epochMs":…,"event":"started"}, also "powerCycle", "hungUp", "returned".
/// `ms` counts virtual time since the start, `epochMs` is the wall clock. Kinds: query, setting,
/// motor, null, bad-format, bad-crc. Motor 3 is the auxiliary one.
class SimLog {
public:
    /// `speed`: virtual seconds a real second.
    SimLog(Instant start, double speed);
    [[nodiscard]] Result<void> open(const QString& path); ///< FileUnwritable
    void note(Instant at, const char* event);
    /// What is new on the line's controllers, by time; takes it off them.
    void collect(SimulatedLine& line);

private:
    void write(Instant at, QJsonObject entry);

    QFile m_file;
    Instant m_start;
    double m_startEpochMs;
    double m_speed;
    std::vector<int> m_eepromWrites; ///< of each controller, as last told
};

} // namespace trex::sim
