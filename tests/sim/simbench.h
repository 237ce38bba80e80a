// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated line on a virtual clock, spoken to in hex: bytes are typed from the documents, never
// made by the host's codec.
#pragma once

#include "protocol/sim/simulatedline.h"

#include <QByteArray>

namespace trex::sim {

inline QByteArray hex(const char* text)
{
    return QByteArray::fromHex(text);
}

class SimBench {
public:
    explicit SimBench(const SimOptions& options = {})
        : m_start(Instant{} + std::chrono::hours(1)), m_now(m_start), line(options, m_start)
    {
    }

    void wait(Duration time) { line.advance(m_now += time); }
    void waitMs(int ms) { wait(std::chrono::milliseconds(ms)); }
    void tell(const char* hexBytes) { line.write(hex(hexBytes), m_now); }
    /// What has come within the time, in upper-case hex without spaces.
    QByteArray hear(int ms = 200)
    {
        m_now += std::chrono::milliseconds(ms);
        return line.read(m_now).toHex().toUpper();
    }
    QByteArray ask(const char* hexBytes, int ms = 200)
    {
        tell(hexBytes);
        return hear(ms);
    }
    /// As ask(), as a number of one byte; −1: no reply, −2: more than one byte.
    int askByte(const char* hexBytes, int ms = 5)
    {
        const QByteArray reply = QByteArray::fromHex(ask(hexBytes, ms));
        return reply.isEmpty() ? -1 : reply.size() > 1 ? -2 : static_cast<std::uint8_t>(reply[0]);
    }
    [[nodiscard]] Instant now() const { return m_now; }
    [[nodiscard]] Instant start() const { return m_start; }
    Device& device(std::size_t i = 0) { return line.device(i); }
    MotorOutput output(MotorId motor) { return line.device().output(motor); }

private:
    Instant m_start;
    Instant m_now;

public:
    SimulatedLine line;
};

/// Options with parameters in hex-free form: {{0x07, 5}}.
inline SimOptions withParameters(std::map<int, int> parameters)
{
    SimOptions options;
    options.parameters = std::move(parameters);
    return options;
}

/// A channel that stands still.
inline ChannelWave held(int channel, double raw, double from = 0.0)
{
    ChannelWave wave;
    wave.channel = channel;
    wave.value = raw;
    wave.from = from;
    return wave;
}

/// All five at these raw values.
inline Scenario heldAt(std::array<double, 5> raw)
{
    Scenario scenario;
    for (int channel = 1; channel <= 5; ++channel) {
        scenario.channels.push_back(held(channel, raw[static_cast<std::size_t>(channel - 1)]));
    }
    return scenario;
}

} // namespace trex::sim
