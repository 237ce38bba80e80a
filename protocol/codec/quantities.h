// SPDX-License-Identifier: GPL-3.0-or-later
// The small types that carry a unit or a range, and the only place that converts between what is
// on the wire (raw) and what people read (physical).
#pragma once

#include <QByteArray>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

namespace trex {

/// A moment on the steady clock (or on a test's virtual clock). The core never asks for the time;
/// it is given it.
using Instant = std::chrono::steady_clock::time_point;
using Duration = std::chrono::nanoseconds;

inline constexpr int kChannelCount = 5;
inline constexpr int kFullSpeed = 127; ///< largest speed, braking duty and remapped magnitude
inline constexpr std::uint8_t kAllChannelsMask = 0x1F;
inline constexpr std::uint16_t kInvalidPulse = 0xFFFF; ///< command documentation, 0x86

/// How sure we are of a fact about the device (facts.md). Inferred values are never shown as fact.
enum class Grade : std::uint8_t { Documented, Observed, InferredStrong, Inferred, InferredWeak };
[[nodiscard]] constexpr bool isGuess(Grade grade)
{
    return grade >= Grade::InferredStrong;
}

enum class Model : std::uint8_t { TrexJr, Trex }; ///< DMC02, DMC01
enum class InputKind : std::uint8_t { Rc, Analog };
enum class MotorId : std::uint8_t { Motor1, Motor2, Aux };
/// Bits 1:0 of a motor command (command documentation, 0xC0): 00 and 11 brake low.
enum class MotorDirection : std::uint8_t {
    Brake = 0,
    Reverse = 1,
    Forward = 2,
    BrakeAlternate = 3
};

/// Signed speed, −127 (full reverse) to 127 (full forward). The range is checked at birth.
class MotorSpeed {
public:
    constexpr MotorSpeed() = default;
    [[nodiscard]] static constexpr std::optional<MotorSpeed> from(int speed)
    {
        return speed < -kFullSpeed || speed > kFullSpeed ? std::nullopt
                                                         : std::optional(MotorSpeed(speed));
    }
    [[nodiscard]] static constexpr MotorSpeed clamped(int speed)
    {
        return MotorSpeed(std::clamp(speed, -kFullSpeed, kFullSpeed));
    }
    [[nodiscard]] constexpr int raw() const { return m_speed; }
    [[nodiscard]] constexpr std::uint8_t magnitude() const
    {
        return static_cast<std::uint8_t>(m_speed < 0 ? -m_speed : m_speed);
    }
    [[nodiscard]] constexpr MotorDirection direction() const
    {
        return m_speed < 0 ? MotorDirection::Reverse : MotorDirection::Forward;
    }
    [[nodiscard]] constexpr double percent() const { return m_speed * 100.0 / kFullSpeed; }
    constexpr bool operator==(const MotorSpeed&) const = default;

private:
    constexpr explicit MotorSpeed(int speed) : m_speed(static_cast<std::int8_t>(speed)) { }
    std::int8_t m_speed = 0;
};

/// A remapped value is sign and magnitude, not two's complement (command documentation, 0x87).
[[nodiscard]] constexpr int signedFromRemapped(std::uint8_t raw)
{
    return (raw & 0x80U) != 0U ? -(raw & 0x7F) : (raw & 0x7F);
}

/// RC pulse width: 0.4 µs a unit (command documentation, 0x86).
[[nodiscard]] constexpr double microsecondsFromRaw(int raw)
{
    return raw * 0.4;
}
[[nodiscard]] constexpr double millisecondsFromRaw(int raw)
{
    return raw * 0.0004;
}
/// Analog input: 10 bits over 5 V (facts.md 5.2).
[[nodiscard]] constexpr double voltsFromRaw(int raw)
{
    return raw * 5.0 / 1023.0;
}
/// Motor current: 40 mA a unit on a TReX Jr (command documentation, 0x8D); about 150 mA on a TReX,
/// which is inferred (facts.md 1, grade I) and must be marked so wherever it is shown.
[[nodiscard]] constexpr double amperesPerCount(Model model)
{
    return model == Model::TrexJr ? 0.040 : 0.150;
}
[[nodiscard]] constexpr Grade amperesGrade(Model model)
{
    return model == Model::TrexJr ? Grade::Documented : Grade::Inferred;
}

} // namespace trex
