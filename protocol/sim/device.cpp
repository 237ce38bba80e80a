// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/device.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trex::sim {

using namespace std::chrono_literals;

namespace {

constexpr Duration kStep = 1ms;
constexpr std::int64_t kUpdateTicks = 10; // command documentation, 0xC4: 100 times a second
constexpr std::int64_t kPulseTicks = 20; // a receiver's 50 Hz
constexpr std::size_t kChangesKept = 4096;
constexpr double kConversionNoise = 0.6; // counts
constexpr double kFullDuty = 127.0;

// Something light on the auxiliary output.
constexpr MotorConstants kAuxMotor{
    .ohms = 6.0, .henries = 2e-3, .inertia = 5e-6, .coulomb = 1.5e-3};

double amperesPerConversion(Model model) // C-30, C-70
{
    return model == Model::TrexJr ? 0.040 : 0.150;
}

int uartByte(const SimOptions& options) // facts.md 2.3
{
    constexpr std::array codes{0x00, 0x40, 0x60, 0x20}; // none, even, odd, CRC-7
    return std::max(0, baudIndex(options.baud))
        | codes[static_cast<std::size_t>(options.errorDetection)]
        | (options.stopBits == 2 ? 0x10 : 0);
}

Eeprom freshEeprom(const SimOptions& options, std::size_t index)
{
    Eeprom eeprom;
    const auto preset = [&](int number, int raw) {
        eeprom.preset(number, static_cast<std::uint8_t>(raw));
    };
    for (int number = 0; number < Eeprom::kCalibrations; ++number) {
        if (parameterLimits(number).exists) {
            preset(number, parameterLimits(number).initial);
        }
    }
    preset(0x00, options.devices.at(index));
    preset(0x7D, options.polynomial & 0x7F);
    preset(0x7E, uartByte(options));
    for (const auto& [number, raw] : options.parameters) {
        if (number != 0x00 || options.devices.size() == 1) {
            preset(number, raw);
        }
    }
    for (const InputKind kind : {InputKind::Rc, InputKind::Analog}) {
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            eeprom.presetCalibration(kind, channel, factoryCalibration(kind));
        }
    }
    return eeprom;
}

} // namespace

Device::Device(const SimOptions& options, std::size_t index, const Eeprom* stored, Instant start)
    : m_eeprom(stored != nullptr ? *stored : freshEeprom(options, index))
    , m_firmware(options, m_eeprom, start)
    , m_inputs(options.scenario, options.seed * 64 + 2 * index)
    , m_currentTraces(options.scenario.currentTraces)
    , m_motors{MotorModel{}, MotorModel{}, MotorModel{kAuxMotor}}
    , m_noise(options.seed * 64 + 2 * index + 1)
    , m_start(start)
    , m_stepped(start)
    , m_amperesPerCount(amperesPerConversion(options.model))
{
}

void Device::advance(Instant now)
{
    while (true) {
        const Instant next = m_stepped + kStep;
        const auto busyUntil = m_firmware.busyUntil();
        if (busyUntil && *busyUntil <= now && *busyUntil <= next) {
            m_firmware.resume(*busyUntil);
            noteOutputs(*busyUntil);
        } else if (next <= now) {
            step();
        } else {
            return;
        }
    }
}

void Device::receive(const ReceivedByte& byte, Instant begin, Instant now)
{
    advance(now);
    m_firmware.receive(byte, begin, now);
    noteOutputs(now);
}

void Device::powerCycle(Instant now)
{
    advance(now);
    m_firmware.powerUp(now);
    noteOutputs(now);
}

void Device::setMode(JumperMode mode)
{
    m_firmware.setMode(mode);
    noteOutputs(m_stepped);
}

void Device::setLoad(int motor, double load)
{
    m_motors[static_cast<std::size_t>(motor - 1)].setLoad(load);
}

void Device::setStall(int motor, bool held)
{
    m_motors[static_cast<std::size_t>(motor - 1)].setStall(held);
}

void Device::setDriverFault(int motor, bool on)
{
    m_firmware.setDriverFault(motor, on);
    noteOutputs(m_stepped);
}

int Device::storedParameter(int number) const
{
    return m_eeprom.at(number);
}

int Device::parameterInForce(int number) const
{
    return m_firmware.inForce(number);
}

CalibrationValues Device::calibration(InputKind kind, int channel) const
{
    return m_eeprom.calibration(kind, channel);
}

double Device::amperes(MotorId motor) const
{
    return m_motors[static_cast<std::size_t>(motor)].amperes();
}

double Device::revolutionsPerSecond(MotorId motor) const
{
    return m_motors[static_cast<std::size_t>(motor)].radiansPerSecond() / (2 * std::numbers::pi);
}

void Device::step()
{
    m_stepped += kStep;
    ++m_tick;
    for (std::size_t i = 0; i < m_motors.size(); ++i) {
        const auto motor = static_cast<MotorId>(i);
        const MotorOutput& output = m_seen[i];
        double duty = 0.0;
        if (output.speed != 0) { // the PWM maximum is the full scale of the speed number
            duty = std::clamp(output.speed / std::max(1.0, double(m_firmware.pwmMaximum(motor))),
                              -1.0, 1.0);
        }
        m_motors[i].step(duty, output.brake / kFullDuty);
    }
    stepInputs();
    stepCurrents();
    m_firmware.watch(m_stepped);
    if (m_tick % kUpdateTicks == 0) {
        m_firmware.update(m_stepped);
    }
    noteOutputs(m_stepped);
}

// A receiver sends its pulses one after another; analog inputs are converted together.
void Device::stepInputs()
{
    const std::int64_t phase = m_tick % kPulseTicks;
    const InputKind kind = m_firmware.inputKind();
    const bool isAnalog = kind == InputKind::Analog;
    if (phase > (isAnalog ? 0 : 2 * kChannelCount) || (!isAnalog && phase % 2 == 0)) {
        return;
    }
    const double seconds = std::chrono::duration<double>(m_stepped - m_start).count();
    const int first = isAnalog ? 1 : static_cast<int>(phase / 2) + 1;
    const int last = isAnalog ? kChannelCount : first;
    for (int channel = first; channel <= last; ++channel) {
        if (const auto raw = m_inputs.sample(channel, seconds, kind)) {
            m_firmware.captureChannel(channel, *raw, m_stepped);
        }
    }
}

void Device::stepCurrents()
{
    for (std::size_t i = 0; i < m_sums.size(); ++i) {
        m_sums[i] += std::abs(m_motors[i].amperes());
    }
    ++m_summed;
    if (m_tick < m_nextConversion) {
        return;
    }
    std::array<int, 2> counts{};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (m_sums[i] > 0.0) {
            const double count = m_sums[i] / m_summed / m_amperesPerCount;
            const double noisy = count + kConversionNoise * m_noise.symmetric();
            counts[i] = static_cast<int>(std::clamp(std::lround(noisy), 0L, 255L));
        }
    }
    const double seconds = std::chrono::duration<double>(m_stepped - m_start).count();
    for (std::size_t i = 0; i < counts.size(); ++i) {
        counts[i] = m_currentTraces[i].at(seconds).value_or(static_cast<std::uint16_t>(counts[i]));
    }
    m_firmware.setCurrents(counts[0], counts[1]);
    m_sums = {};
    m_summed = 0;
    // C-30: 50 Hz with analog inputs, about 80 Hz with RC inputs (12 and 13 ms in turn).
    const bool isAnalog = m_firmware.inputKind() == InputKind::Analog;
    m_nextConversion = isAnalog ? m_tick + 20 : (m_tick * 2 / 25 + 1) * 25 / 2;
}

void Device::noteOutputs(Instant now)
{
    for (std::size_t i = 0; i < m_seen.size(); ++i) {
        const auto motor = static_cast<MotorId>(i);
        const MotorOutput output = m_firmware.output(motor);
        if (output == m_seen[i]) {
            continue;
        }
        m_seen[i] = output;
        if (m_changes.size() >= kChangesKept) {
            m_changes.pop_front();
        }
        m_changes.push_back({now, motor, output});
    }
}

} // namespace trex::sim
