// SPDX-License-Identifier: GPL-3.0-or-later
// One simulated controller with all that hangs on it: EEPROM, firmware, motors, channel inputs.
#pragma once

#include "protocol/sim/eeprom.h"
#include "protocol/sim/firmware.h"
#include "protocol/sim/inputmodel.h"
#include "protocol/sim/motormodel.h"
#include "protocol/sim/simoptions.h"

#include <array>
#include <deque>

namespace trex::sim {

/// What a motor's bridge did from this moment on.
struct OutputChange {
    Instant time;
    MotorId motor = MotorId::Motor1;
    MotorOutput output;
};

/// Pure: time comes in as an argument and never runs backwards.
class Device {
public:
    /// Without a stored EEPROM it is fresh from the factory, then set as the options say.
    Device(const SimOptions& options, std::size_t index, const Eeprom* stored, Instant start);
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    /// Runs plant, inputs and firmware up to now.
    void advance(Instant now);
    /// A byte whose reception began at `begin` and ends now: advances, then gives it to the
    /// firmware (which is deaf while it sends).
    void receive(const ReceivedByte& byte, Instant begin, Instant now);
    /// The replies since the last clear, in order; each has the time at which it begins.
    [[nodiscard]] const std::vector<Reply>& replies() const { return m_firmware.replies(); }
    void clearReplies() { m_firmware.clearReplies(); }
    /// When something may happen that makes a reply, without a further byte.
    [[nodiscard]] std::optional<Instant> nextWakeAt() const { return m_firmware.busyUntil(); }
    void powerCycle(Instant now);
    void setPaced(bool paced) { m_firmware.setPaced(paced); }

    // The bench: jumpers, loads, signals.
    void setMode(JumperMode mode);
    void setMix(bool on) { m_firmware.setMix(on); }
    void setLoad(int motor, double load); ///< motor 1 or 2; 0 free to 1 heavy
    void setStall(int motor, bool held);
    void setDriverFault(int motor, bool on);
    void setInput(const ChannelWave& wave) { m_inputs.set(wave); }
    /// As if another host had written it: EEPROM, and in force if it acts at once.
    void setParameter(int number, int raw) { m_firmware.storeParameter(number, raw); }

    // Inspection.
    [[nodiscard]] const Eeprom& eeprom() const { return m_eeprom; }
    [[nodiscard]] Eeprom& eeprom() { return m_eeprom; }
    [[nodiscard]] const Firmware& firmware() const { return m_firmware; }
    [[nodiscard]] int storedParameter(int number) const; ///< EEPROM
    [[nodiscard]] int parameterInForce(int number) const;
    [[nodiscard]] CalibrationValues calibration(InputKind kind, int channel) const;
    [[nodiscard]] const UartFormat& uart() const { return m_firmware.uart(); }
    [[nodiscard]] MotorOutput output(MotorId motor) const { return m_firmware.output(motor); }
    [[nodiscard]] double amperes(MotorId motor) const; ///< true, signed
    [[nodiscard]] double revolutionsPerSecond(MotorId motor) const; ///< signed
    /// Packets and output changes since the last clear; the oldest go when there are too many.
    [[nodiscard]] const std::deque<HeardPacket>& heard() const { return m_firmware.heard(); }
    void clearHeard() { m_firmware.clearHeard(); }
    [[nodiscard]] const std::deque<OutputChange>& outputChanges() const { return m_changes; }
    void clearOutputChanges() { m_changes.clear(); }

private:
    void step();
    void stepInputs();
    void stepCurrents();
    void noteOutputs(Instant now);

    Eeprom m_eeprom;
    Firmware m_firmware;
    InputModel m_inputs;
    std::array<Trace, 2> m_currentTraces;
    std::array<MotorModel, 3> m_motors;
    std::array<MotorOutput, 3> m_seen;
    std::deque<OutputChange> m_changes;
    Random m_noise;
    Instant m_start;
    Instant m_stepped; ///< end of the last plant step
    std::int64_t m_tick = 0;
    std::int64_t m_nextConversion = 0; ///< tick at which the currents' averages are due
    std::array<double, 2> m_sums{}; ///< of the amperes since the last conversion
    int m_summed = 0;
    double m_amperesPerCount;
};

} // namespace trex::sim
