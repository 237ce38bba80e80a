// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that can be chosen about a simulated controller and its line, as one value. Both
// "trexctl simulate" and the address "sim:?mode=rc&seed=3" end here.
#pragma once

#include "protocol/codec/linesettings.h"
#include "protocol/codec/quantities.h"
#include "protocol/result.h"
#include "protocol/sim/faults.h"
#include "protocol/sim/scenario.h"

#include <QString>

#include <map>
#include <vector>

namespace trex::sim {

/// How the simulator plays what the documents leave open (conformance.md, marked ⚙).
///
/// | quirk             | values              | plays                                              |
/// | ----------------- | ------------------- | -------------------------------------------------- |
/// | calibration-bytes | 7 (default), 8      | 0xA0 to A4 join byte pairs as low + 128 × high, or |
/// |                   |                     | low + 256 × high (C-35)                            |
/// | null-command      | silent (d.), error  | 0xFF latches nothing, or a format error (C-56)     |
/// | unknown-parameter | silent (d.), ff     | 0x9F of an unknown number: no reply, or 0xFF; a    |
/// |                   |                     | format error either way (C-57)                     |
/// | serial-timeout    | on (default), off   | off: a controller that never stops for silence     |
/// | safe-start        | off (default), on   | on: RC and analog start with the motors off until  |
/// |                   |                     | all rest near neutral and channel 5 is off (C-68,  |
/// |                   |                     | facts 5.5); off: only until required ones are valid|
/// | motor-reply       | silent (d.), ff     | ff: motor commands answer 0xFF (facts 4, F-13311)  |
/// | invalid-after     | 100 (default), 150  | ms without a pulse until 0xFFFF (C-24, facts 5.1)  |
struct Quirks {
    int calibrationBits = 7; ///< bits in the low byte of a pair: 7 or 8
    bool nullCommandIsError = false;
    bool unknownParameterAnswersFf = false;
    bool serialTimeoutActs = true;
    bool safeStart = false;
    bool motorCommandsAnswerFf = false;
    std::chrono::milliseconds invalidAfter{100};
    bool operator==(const Quirks&) const = default;
};

/// 1.0 to 1.3 exist (facts.md 1): before 1.2 there is no parameter 0x17, 1.1 always waits 1 ms
/// before a reply, and 28800 and 38400 baud run at half their speed.
struct FirmwareVersion {
    int major = 1;
    int minor = 2;
    auto operator<=>(const FirmwareVersion&) const = default;
};

struct SimOptions {
    Model model = Model::TrexJr;
    FirmwareVersion firmware;
    JumperMode mode = JumperMode::Serial;
    bool mix = false; ///< mix jumper
    // Of a fresh EEPROM only: what the state file holds wins.
    int baud = 19200;
    ErrorDetection errorDetection = ErrorDetection::None;
    std::uint8_t polynomial = kDefaultPolynomial;
    int stopBits = 1;
    std::vector<int> devices{kDefaultDeviceNumber}; ///< one controller each, on the same line
    std::map<int, int> parameters; ///< number to raw value; wins over the five above
    // The line and the surroundings.
    bool pace = false; ///< bytes take their time on the wire
    bool echo = false; ///< RS-232 wiring: the host hears itself
    QString stateFile; ///< EEPROM kept here; empty: forgotten at the end
    quint64 seed = 1; ///< faults, jitter and noise follow from it
    double speed = 1.0; ///< virtual seconds a real second (server only)
    bool jumpsInTime = false; ///< in process only: waiting takes no time at all, for tests
    Quirks quirks;
    Faults faults;
    Scenario scenario;

    // Each takes one NAME=VALUE as typed and says OutOfRange, with a sentence, when it makes no
    // sense: nothing is changed then.
    [[nodiscard]] Result<void> applyParameter(const QString& assignment); ///< "serial-timeout=5"
    [[nodiscard]] Result<void> applyQuirk(const QString& assignment); ///< "null-command=error"
    [[nodiscard]] Result<void> applyFault(const QString& assignment); ///< "drop=0.1"
    [[nodiscard]] Result<void> applyModel(const QString& name); ///< "jr", "trex"
    [[nodiscard]] Result<void> applyMode(const QString& name); ///< "rc", "analog", "serial"
    [[nodiscard]] Result<void> applyFirmware(const QString& version); ///< "1.0" to "1.3"
    /// FileUnreadable, or FileMalformed with the line or the key.
    [[nodiscard]] Result<void> loadScenario(const QString& path);
    /// All fields in range (for those set directly): OutOfRange with a sentence.
    [[nodiscard]] Result<void> validate() const;
};

/// "sim:", "sim:?mode=rc&seed=3&state=FILE": keys mode, model, firmware, seed, state, baud,
/// error-detection, crc-polynomial, stop-bits, device (may repeat), pace, echo, mix (0 or 1),
/// speed, clock (real or virtual), scenario, and, repeatable, param=KEY=VALUE, quirk=NAME=VALUE,
/// fault=NAME=VALUE.
[[nodiscard]] Result<SimOptions> simOptionsFromUrl(const QString& url);

} // namespace trex::sim
