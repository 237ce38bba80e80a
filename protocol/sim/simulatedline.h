// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated serial line with one or more controllers on it: bytes and time in, bytes out. Pure;
// the caller owns the clock, which may run as fast as it likes but never backwards.
#pragma once

#include "protocol/sim/device.h"
#include "protocol/sim/simoptions.h"
#include "protocol/sim/wire.h"

#include <QByteArray>

#include <deque>
#include <memory>
#include <vector>

namespace trex::sim {

/// The host's port settings. Of the error detection only the parity is on the wire.
struct HostLine {
    int baud = 19200;
    ErrorDetection errorDetection = ErrorDetection::None;
    int stopBits = 1;
    bool operator==(const HostLine&) const = default;
};

/// Several controllers all hear everything. Where they answer at the same time their outputs are
/// joined by a logical AND, as one would wire them (facts.md 4, daisy chain).
class SimulatedLine {
public:
    explicit SimulatedLine(const SimOptions& options, Instant start);
    ~SimulatedLine();
    SimulatedLine(const SimulatedLine&) = delete;
    SimulatedLine& operator=(const SimulatedLine&) = delete;

    /// At another speed or parity the two sides hear garbage and framing errors. None: matches
    /// always (TCP). That is how a line begins.
    void setHostLine(std::optional<HostLine> host);
    /// Host to line. With `pace` a byte takes its time on the wire, else none.
    void write(QByteArrayView bytes, Instant now);
    /// All bytes that have reached the host by now, the echo included.
    [[nodiscard]] QByteArray read(Instant now);
    /// When to look again: the next byte for the host is there at this time, or (while bytes are
    /// still under way to a controller or it is writing its EEPROM) perhaps soon after. None:
    /// nothing comes without a further write. Everything up to the last advance is counted in.
    [[nodiscard]] std::optional<Instant> nextByteAt() const;
    /// Runs line, controllers and plants up to now; read() and write() do it too.
    void advance(Instant now);
    /// The port is gone (hang-up fault); it is back when this turns false.
    [[nodiscard]] bool isHungUp(Instant now) const;
    void powerCycle(Instant now); ///< all controllers

    /// Bytes that have crossed the wire so far, in both directions: what the faults at a byte
    /// count.
    [[nodiscard]] qint64 wireBytes() const { return m_wireBytes; }
    [[nodiscard]] std::size_t deviceCount() const { return m_devices.size(); }
    [[nodiscard]] Device& device(std::size_t index = 0) { return *m_devices[index]; }
    [[nodiscard]] const Device& device(std::size_t index = 0) const { return *m_devices[index]; }
    /// Writes the EEPROMs to the state file, if there is one and anything changed; done at the
    /// end too. FileUnwritable.
    [[nodiscard]] Result<void> saveState();
    /// What is wrong with the state file that was to be read; it is then left alone and the
    /// controllers start fresh.
    [[nodiscard]] const std::optional<Error>& stateError() const { return m_stateError; }

    // Short cuts to all devices' benches.
    void setMode(JumperMode mode);
    void setMix(bool on);
    void setLoad(int motor, double load); ///< motor 1 or 2; 0 free to 1 heavy
    void setStall(int motor, bool held);
    void setInput(const ChannelWave& wave);
    /// Faults from now on; their times count from now.
    void setFaults(const Faults& faults, Instant now);

private:
    struct Incoming { ///< a host byte under way to the controllers
        Instant begin;
        Instant end;
        std::uint8_t value;
    };
    struct Outgoing { ///< a byte under way to the host
        Instant at;
        std::uint8_t value;
        std::int8_t device; ///< −1: echo
        std::int16_t index; ///< place in its reply
    };
    [[nodiscard]] std::optional<Instant> nextEventAt() const;
    void runEvent();
    void apply(const ScenarioEvent& event);
    void applyFaults(const ScenarioEvent& event);
    void resetControllers();
    void deliver(const Incoming& byte);
    void deliverTo(std::size_t device, std::uint8_t value, const Incoming& byte);
    [[nodiscard]] bool isPlugged(std::size_t device) const;
    void settle(std::size_t device);
    void hear(std::size_t device);
    [[nodiscard]] bool crosses(std::uint8_t& value, Instant at);
    void collectReplies(std::size_t device);
    void sendReply(std::size_t device, const Reply& reply);
    void addOutgoing(const Outgoing& byte);
    void refreshFormats();
    [[nodiscard]] double seconds(Instant now) const;

    SimOptions m_options;
    Instant m_start;
    Instant m_now;
    std::vector<std::unique_ptr<Device>> m_devices;
    std::vector<WireSampler> m_toDevice; ///< one a device
    std::vector<WireSampler> m_toHost;
    std::optional<HostLine> m_host;
    std::deque<Incoming> m_incoming;
    std::deque<Outgoing> m_outgoing; ///< by time
    std::vector<SampledByte> m_sampled; ///< scratch
    bool m_isPaced = false; ///< also where speeds differ: what is heard then depends on the times
    Duration m_hostByte{0};
    Instant m_hostFree; ///< end of the host's last byte
    std::size_t m_nextEvent = 0;
    Faults m_faults;
    FaultWindow m_silence;
    FaultWindow m_hangUp;
    std::optional<Instant> m_resetAt;
    qint64 m_wireBytes = 0;
    Random m_random;
    std::optional<Error> m_stateError;
};

} // namespace trex::sim
