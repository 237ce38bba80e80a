// SPDX-License-Identifier: GPL-3.0-or-later
// Who controls the motors, and what they are told: the firmware's 10 ms work.
#include "protocol/sim/firmware.h"

#include <cstdlib>

namespace trex::sim {

using namespace std::chrono_literals;

namespace {

// Bits of the status byte (command documentation, 0x84), by motor, and of the UART error byte.
constexpr std::uint8_t kOverCurrent[]{0x20, 0x80};
constexpr std::uint8_t kFault[]{0x10, 0x40};
constexpr auto kTimeoutUnit = 100ms; // facts.md 2, 0x07
constexpr auto kRequiredLost = 500ms; // facts.md 5.1
constexpr int kNearNeutral = 10; // safe-start; how near is not published
constexpr std::uint8_t kTimeout = 0x80;

} // namespace

void Firmware::watch(Instant now)
{
    checkTimeout(m_serialWas, now);
}

// C-62: from the last byte received; once for each silence.
void Firmware::checkTimeout(bool serial, Instant now)
{
    const int units = inForce(0x07);
    if (units == 0 || !serial || !m_lastByte || now - *m_lastByte < units * kTimeoutUnit
        || !m_quirks.serialTimeoutActs) {
        return;
    }
    m_lastByte.reset();
    shutDown();
    latchUart(kTimeout);
}

void Firmware::update(Instant now)
{
    bool serial = true;
    ChannelUnit::Values values{};
    if (m_mode != JumperMode::Serial) {
        values = remapped(now);
        refreshHalt(values, now);
        serial = !m_isSafeStart && values[4] <= kSwitchesOn;
    }
    checkTimeout(serial, now);
    refreshControl(serial && !m_isHalted);
    if (m_isHalted) {
        for (auto& drive : m_drives) {
            drive.stop();
        }
    } else if (!serial) {
        followChannels(values);
    }
    for (std::size_t i = 0; i < m_drives.size(); ++i) {
        const int n = static_cast<int>(i);
        const bool isAux = i == 2;
        const int limit = isAux ? 0 : 2 * inForce(0x13 + n); // facts.md 2: desired current / 2
        const bool isOver = m_drives[i].update({.acceleration = inForce(0x0E + n),
                                                .brakeDuration = isAux ? 0 : inForce(0x11 + n),
                                                .limit = limit,
                                                .p = isAux ? 0 : inForce(0x15 + n)},
                                               isAux ? 0 : m_currents[i]);
        if (!isAux) {
            m_status = static_cast<std::uint8_t>(m_status | (isOver ? kOverCurrent[i] : 0)
                                                 | (m_driverFault[i] ? kFault[i] : 0));
        }
    }
}

// C-68, facts.md 5.5: RC and analog mode only.
void Firmware::refreshHalt(const ChannelUnit::Values& values, Instant now)
{
    bool isMissing = false;
    if (m_mode == JumperMode::Rc) {
        const auto raw = rawChannels(now);
        for (int i = 0; i < kChannelCount; ++i) {
            const auto channel = static_cast<std::size_t>(i);
            if (raw[channel] != kInvalidPulse) {
                m_wasValid[channel] = true;
                m_lastValid[channel] = now;
            }
            const bool isRequired = (inForce(0x01) & ~inForce(0x02) & (1 << i)) != 0;
            const bool isLost = !m_wasValid[channel]
                || (raw[channel] == kInvalidPulse && now - m_lastValid[channel] > kRequiredLost);
            isMissing = isMissing || (isRequired && isLost);
        }
    }
    if (isMissing && m_quirks.safeStart) {
        m_isSafeStart = true;
    }
    const auto isResting = [&](std::size_t i) { return std::abs(values[i]) <= kNearNeutral; };
    if (m_isSafeStart && !isMissing && isResting(0) && isResting(1) && isResting(2)
        && values[4] > kSwitchesOn) {
        m_isSafeStart = false;
    }
    m_isHalted = isMissing || m_isSafeStart;
}

void Firmware::refreshControl(bool serial)
{
    if (serial && !m_serialWas) {
        for (std::size_t i = 0; i < m_drives.size(); ++i) {
            m_drives[i].stop();
            m_drives[i].apply(m_stored[i]); // C-50
        }
    }
    m_serialWas = serial;
}

void Firmware::followChannels(const ChannelUnit::Values& values)
{
    const std::size_t bridges = isJoint() ? 1 : 2;
    for (std::size_t i = 0; i < bridges; ++i) {
        if (values[i] == 0) {
            m_drives[i].rest(inForce(0x05 + static_cast<int>(i)));
        } else {
            m_drives[i].apply({false, values[i] < 0 ? -1 : 1, std::abs(values[i])});
        }
    }
    m_drives[2].apply({false, 1, std::abs(values[2])}); // C-29: the magnitude
}

void Firmware::captureChannel(int channel, std::uint16_t raw, Instant now)
{
    m_channels.capture(channel, raw, now);
}

void Firmware::setCurrents(int motor1, int motor2)
{
    m_currents = isJoint() ? std::array<int, 2>{} : std::array{motor1, motor2}; // C-67
}

MotorOutput Firmware::output(MotorId motor) const
{
    auto i = static_cast<std::size_t>(motor);
    if (motor != MotorId::Aux && m_driverFault[i]) {
        return {};
    }
    if (motor == MotorId::Motor2 && isJoint()) {
        i = 0;
    }
    return m_drives[i].output();
}

int Firmware::pwmMaximum(MotorId motor) const
{
    return inForce(0x0B + static_cast<int>(motor));
}

bool Firmware::serialControls(Instant now) const
{
    return m_mode == JumperMode::Serial || (!m_isSafeStart && remapped(now)[4] <= kSwitchesOn);
}

std::array<std::uint16_t, kChannelCount> Firmware::rawChannels(Instant now) const
{
    std::array<std::uint16_t, kChannelCount> raw{};
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        raw[index(channel)] = m_channels.raw(channel, inputKind(), now, m_quirks.invalidAfter);
    }
    return raw;
}

ChannelUnit::Values Firmware::remapped(Instant now) const
{
    return ChannelUnit::remap(rawChannels(now), m_calibrations,
                              {.kind = inputKind(),
                               .ignored = inForce(0x02),
                               .reversed = inForce(0x03),
                               .parabolic = inForce(0x04),
                               .mix = m_mix && !isJoint()}); // facts.md 2, 0x7B
}

} // namespace trex::sim
