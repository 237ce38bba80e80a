// SPDX-License-Identifier: GPL-3.0-or-later
// THE parameter table: one row for each configuration parameter. The editor, the command line, the
// configuration file, the simulator's EEPROM and the help loop over it. Names and numbers are
// observed in two independent projects (facts.md 2); each further fact has its own grade.
#pragma once

#include "protocol/codec/quantities.h"

#include <QString>
#include <QtGlobal>

#include <array>
#include <span>
#include <stdexcept>
#include <string_view>

namespace trex {

/// Which editor fits the meaning.
enum class ParameterEditor : std::uint8_t {
    Number,
    ChannelBits,
    Toggle,
    Choice,
    Prescaler,
    Polynomial,
    UartSettings,
    Trigger
};

struct ParameterChoice {
    int raw = 0;
    const char* title = nullptr; ///< QT_TRANSLATE_NOOP("Parameters", …)
};

struct ParameterRow {
    std::uint8_t number = 0;
    std::string_view key;
    const char* title = nullptr; ///< QT_TRANSLATE_NOOP("Parameters", …)
    const char* help = nullptr;
    const char* group = nullptr;
    ParameterEditor editor = ParameterEditor::Number;
    int minimum = 0; ///< raw, accepted by the controller (conformance C-59)
    int maximum = 127;
    int defaultRaw = 0; ///< raw; a guess where defaultGrade says so
    Grade defaultGrade = Grade::Inferred;
    std::string_view unit{}; ///< physical unit, "" for plain numbers
    double scale = 1.0; ///< physical = raw × scale
    int decimals = 0;
    std::span<const ParameterChoice> choices{};
    /// What raw 0 reads where it is no quantity, QT_TRANSLATE_NOOP("Parameters", …); null: 0 units
    const char* zeroText = nullptr;
    bool needsReset = false; ///< in force after a power cycle (0x7B to 0x7F)
    bool isTrigger = false; ///< written, never read or listed (0x7F)
    Grade meaningGrade = Grade::Documented;
    std::string_view source; ///< where the facts come from
};

namespace parameterchoices {
inline constexpr std::array kMotorMode{
    ParameterChoice{0, QT_TRANSLATE_NOOP("Parameters", "independent")},
    ParameterChoice{1, QT_TRANSLATE_NOOP("Parameters", "joint (one motor on both H-bridges)")}};
inline constexpr std::array kInput{
    ParameterChoice{0, QT_TRANSLATE_NOOP("Parameters", "RC pulses")},
    ParameterChoice{1, QT_TRANSLATE_NOOP("Parameters", "analog voltages")}};
inline constexpr std::array kPrescaler{
    ParameterChoice{0, QT_TRANSLATE_NOOP("Parameters", "0: 19.5 kHz")},
    ParameterChoice{1, QT_TRANSLATE_NOOP("Parameters", "1: 2.4 kHz")},
    ParameterChoice{2, QT_TRANSLATE_NOOP("Parameters", "2: about 610 Hz (unsure)")},
    ParameterChoice{3, QT_TRANSLATE_NOOP("Parameters", "3: about 150 Hz (unsure)")}};
} // namespace parameterchoices

#define TREX_GROUP_GENERAL QT_TRANSLATE_NOOP("Parameters", "Serial line and safety")
#define TREX_GROUP_CHANNELS QT_TRANSLATE_NOOP("Parameters", "Channels")
#define TREX_GROUP_MOTORS QT_TRANSLATE_NOOP("Parameters", "Motors")
#define TREX_GROUP_LIMITS QT_TRANSLATE_NOOP("Parameters", "Current limits")

// clang-format off
inline constexpr auto kParameters = std::to_array<ParameterRow>({
    {.number = 0x00, .key = "device-number", .title = QT_TRANSLATE_NOOP("Parameters", "Device number"),
     .help = QT_TRANSLATE_NOOP("Parameters", "The number this controller listens to in Pololu packets. Give each controller on a shared line its own."),
     .group = TREX_GROUP_GENERAL, .defaultRaw = 7, .defaultGrade = Grade::Documented, .source = "command documentation, 0x80"},
    {.number = 0x01, .key = "required-channels", .title = QT_TRANSLATE_NOOP("Parameters", "Required channels"),
     .help = QT_TRANSLATE_NOOP("Parameters", "RC mode: these channels must carry valid pulses before motors run; losing one for 500 ms stops them."),
     .group = TREX_GROUP_CHANNELS, .editor = ParameterEditor::ChannelBits, .maximum = 31, .defaultRaw = 1, .defaultGrade = Grade::Documented, .source = "user guide 4.c, TReX Jr guide 4.e"},
    {.number = 0x02, .key = "ignored-channels", .title = QT_TRANSLATE_NOOP("Parameters", "Ignored channels"),
     .help = QT_TRANSLATE_NOOP("Parameters", "These channels count as resting at neutral, whatever their pins show."),
     .group = TREX_GROUP_CHANNELS, .editor = ParameterEditor::ChannelBits, .maximum = 31, .defaultGrade = Grade::InferredStrong, .source = "user guide 4.c, 4.d"},
    {.number = 0x03, .key = "reversed-channels", .title = QT_TRANSLATE_NOOP("Parameters", "Reversed channels"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Forward and reverse change places on these channels."),
     .group = TREX_GROUP_CHANNELS, .editor = ParameterEditor::ChannelBits, .maximum = 31, .defaultGrade = Grade::InferredStrong, .source = "user guide 4.b"},
    {.number = 0x04, .key = "parabolic-channels", .title = QT_TRANSLATE_NOOP("Parameters", "Parabolic channels"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Square-law response: finer control near neutral on these channels."),
     .group = TREX_GROUP_CHANNELS, .editor = ParameterEditor::ChannelBits, .maximum = 31, .defaultGrade = Grade::InferredStrong, .source = "user guide 4.b"},
    {.number = 0x05, .key = "motor1-deadband-brake", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 1 deadband brake"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Braking duty while motor 1's channel rests in its deadband (RC and analog modes): 0 coasts, 127 brakes fully."),
     .group = TREX_GROUP_MOTORS, .meaningGrade = Grade::Inferred, .source = "facts 2 (name observed, meaning inferred)"},
    {.number = 0x06, .key = "motor2-deadband-brake", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 2 deadband brake"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Braking duty while motor 2's channel rests in its deadband (RC and analog modes): 0 coasts, 127 brakes fully."),
     .group = TREX_GROUP_MOTORS, .meaningGrade = Grade::Inferred, .source = "facts 2 (name observed, meaning inferred)"},
    {.number = 0x07, .key = "serial-timeout", .title = QT_TRANSLATE_NOOP("Parameters", "Serial timeout"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Motors stop when the controller hears nothing for this long. 0 switches the protection off."),
     .group = TREX_GROUP_GENERAL, .unit = "ms", .scale = 100.0, .zeroText = QT_TRANSLATE_NOOP("Parameters", "off"), .meaningGrade = Grade::Observed, .source = "command documentation, 0x85; unit observed twice"},
    {.number = 0x08, .key = "uart-error-shutdown", .title = QT_TRANSLATE_NOOP("Parameters", "Stop on UART error"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Any serial error stops the motors; the controller keeps listening."),
     .group = TREX_GROUP_GENERAL, .editor = ParameterEditor::Toggle, .maximum = 1, .source = "serial protocols 5.b; encoding inferred"},
    {.number = 0x09, .key = "motor1-pwm-prescaler", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 1 PWM prescaler"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Sets motor 1's PWM frequency. The TReX Jr's driver is rated for 10 kHz."),
     .group = TREX_GROUP_MOTORS, .editor = ParameterEditor::Prescaler, .maximum = 3, .defaultRaw = 1, .defaultGrade = Grade::Documented, .choices = parameterchoices::kPrescaler, .source = "facts 2.1 (forum 1133)"},
    {.number = 0x0A, .key = "motor2-pwm-prescaler", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 2 PWM prescaler"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Sets motor 2's PWM frequency. The TReX Jr's driver is rated for 10 kHz."),
     .group = TREX_GROUP_MOTORS, .editor = ParameterEditor::Prescaler, .maximum = 3, .defaultRaw = 1, .defaultGrade = Grade::Documented, .choices = parameterchoices::kPrescaler, .source = "facts 2.1 (forum 1133)"},
    {.number = 0x0B, .key = "motor1-pwm-maximum", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 1 PWM maximum"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Full scale of motor 1's speed number; 127 is the default 7-bit resolution."),
     .group = TREX_GROUP_MOTORS, .defaultRaw = 127, .defaultGrade = Grade::Documented, .source = "facts 2.1 (forum 1133)"},
    {.number = 0x0C, .key = "motor2-pwm-maximum", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 2 PWM maximum"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Full scale of motor 2's speed number; 127 is the default 7-bit resolution."),
     .group = TREX_GROUP_MOTORS, .defaultRaw = 127, .defaultGrade = Grade::Documented, .source = "facts 2.1 (forum 1133)"},
    {.number = 0x0D, .key = "aux-pwm-maximum", .title = QT_TRANSLATE_NOOP("Parameters", "Auxiliary motor PWM maximum"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Full scale of the auxiliary motor's speed number."),
     .group = TREX_GROUP_MOTORS, .defaultRaw = 127, .meaningGrade = Grade::Observed, .source = "facts 2 (name observed)"},
    {.number = 0x0E, .key = "motor1-acceleration", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 1 acceleration"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Speed steps gained every 100 ms by accelerate commands; 0 is unlimited."),
     .group = TREX_GROUP_MOTORS, .zeroText = QT_TRANSLATE_NOOP("Parameters", "unlimited"), .source = "command documentation, 0xC4"},
    {.number = 0x0F, .key = "motor2-acceleration", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 2 acceleration"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Speed steps gained every 100 ms by accelerate commands; 0 is unlimited."),
     .group = TREX_GROUP_MOTORS, .zeroText = QT_TRANSLATE_NOOP("Parameters", "unlimited"), .source = "command documentation, 0xC4"},
    {.number = 0x10, .key = "aux-acceleration", .title = QT_TRANSLATE_NOOP("Parameters", "Auxiliary motor acceleration"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Speed steps gained every 100 ms by accelerate commands; 0 is unlimited."),
     .group = TREX_GROUP_MOTORS, .zeroText = QT_TRANSLATE_NOOP("Parameters", "unlimited"), .source = "command documentation, 0xF1"},
    {.number = 0x11, .key = "motor1-brake-duration", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 1 brake duration"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Full braking before an accelerate command reverses motor 1."),
     .group = TREX_GROUP_MOTORS, .unit = "ms", .scale = 10.0, .source = "command documentation, 0xC4; unit from forum 624"},
    {.number = 0x12, .key = "motor2-brake-duration", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 2 brake duration"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Full braking before an accelerate command reverses motor 2."),
     .group = TREX_GROUP_MOTORS, .unit = "ms", .scale = 10.0, .source = "command documentation, 0xC4; unit from forum 624"},
    {.number = 0x13, .key = "motor1-current-limit", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 1 current limit"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Motor 1 is slowed above this current; accelerate commands only. 0 is probably no limit."),
     .group = TREX_GROUP_LIMITS, .unit = "A", .scale = 0.08, .decimals = 2, .zeroText = QT_TRANSLATE_NOOP("Parameters", "no limit (unsure)"), .source = "facts 2 (forum 13311); 0 = off inferred"},
    {.number = 0x14, .key = "motor2-current-limit", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 2 current limit"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Motor 2 is slowed above this current; accelerate commands only. 0 is probably no limit."),
     .group = TREX_GROUP_LIMITS, .unit = "A", .scale = 0.08, .decimals = 2, .zeroText = QT_TRANSLATE_NOOP("Parameters", "no limit (unsure)"), .source = "facts 2 (forum 13311); 0 = off inferred"},
    {.number = 0x15, .key = "motor1-current-limit-p", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 1 current limit gain"),
     .help = QT_TRANSLATE_NOOP("Parameters", "How hard the speed is cut back for each unit of excess current (proportionality constant P)."),
     .group = TREX_GROUP_LIMITS, .defaultRaw = 5, .meaningGrade = Grade::InferredWeak, .source = "facts 2.2 (name observed, law unpublished)"},
    {.number = 0x16, .key = "motor2-current-limit-p", .title = QT_TRANSLATE_NOOP("Parameters", "Motor 2 current limit gain"),
     .help = QT_TRANSLATE_NOOP("Parameters", "How hard the speed is cut back for each unit of excess current (proportionality constant P)."),
     .group = TREX_GROUP_LIMITS, .defaultRaw = 5, .meaningGrade = Grade::InferredWeak, .source = "facts 2.2 (name observed, law unpublished)"},
    {.number = 0x17, .key = "uart-response-delay", .title = QT_TRANSLATE_NOOP("Parameters", "Reply delay of 1 ms"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Waits 1 ms before each reply, for slow hosts. Firmware 1.2 and later."),
     .group = TREX_GROUP_GENERAL, .editor = ParameterEditor::Toggle, .maximum = 1, .source = "facts 2 (forum 1491)"},
    {.number = 0x7B, .key = "motor-mode", .title = QT_TRANSLATE_NOOP("Parameters", "Motor mode"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Two motors, or one motor on both H-bridges. Joint mode has no current readings."),
     .group = TREX_GROUP_MOTORS, .editor = ParameterEditor::Choice, .maximum = 1, .defaultGrade = Grade::InferredStrong, .choices = parameterchoices::kMotorMode, .needsReset = true, .source = "facts 2 (forum 2572)"},
    {.number = 0x7C, .key = "channel-input-source", .title = QT_TRANSLATE_NOOP("Parameters", "Channel input source"),
     .help = QT_TRANSLATE_NOOP("Parameters", "How the five inputs are read in serial mode."),
     .group = TREX_GROUP_CHANNELS, .editor = ParameterEditor::Choice, .maximum = 1, .defaultGrade = Grade::Documented, .choices = parameterchoices::kInput, .needsReset = true, .source = "command documentation, 0x82; encoding inferred"},
    {.number = 0x7D, .key = "crc7-polynomial", .title = QT_TRANSLATE_NOOP("Parameters", "CRC-7 polynomial"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Low seven bits of the CRC-7 polynomial; the top bit is always 1. 9 is the default 0x89."),
     .group = TREX_GROUP_GENERAL, .editor = ParameterEditor::Polynomial, .defaultRaw = 9, .defaultGrade = Grade::Documented, .needsReset = true, .meaningGrade = Grade::InferredStrong, .source = "TReX Jr guide 5.e; storage inferred"},
    {.number = 0x7E, .key = "uart-settings", .title = QT_TRANSLATE_NOOP("Parameters", "UART settings"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Baud rate, error detection and stop bits of the serial line, in one byte."),
     .group = TREX_GROUP_GENERAL, .editor = ParameterEditor::UartSettings, .defaultRaw = 5, .defaultGrade = Grade::InferredStrong, .needsReset = true, .meaningGrade = Grade::InferredStrong, .source = "facts 2.3"},
    {.number = 0x7F, .key = "factory-reset", .title = QT_TRANSLATE_NOOP("Parameters", "Reset all parameters"),
     .help = QT_TRANSLATE_NOOP("Parameters", "Puts all parameters back to factory defaults. Calibrations stay."),
     .group = TREX_GROUP_GENERAL, .editor = ParameterEditor::Trigger, .defaultRaw = 127, .needsReset = true, .isTrigger = true, .meaningGrade = Grade::Inferred, .source = "facts 2 (name observed)"},
});
// clang-format on

inline constexpr std::uint8_t kFactoryResetValue = 0x7F; // facts.md 2, 0x7F: observed, unconfirmed

static_assert(kParameters.size() == 29);
static_assert([] {
    int previous = -1;
    for (const auto& row : kParameters) {
        if (row.number <= previous || row.key.empty() || row.title == nullptr || row.help == nullptr
            || row.group == nullptr || row.source.empty() || row.defaultRaw < row.minimum
            || row.defaultRaw > row.maximum || row.needsReset != (row.number >= 0x7B)) {
            return false;
        }
        previous = row.number;
    }
    return true;
}());

/// The row of a key known when compiling: a wrong key does not compile.
[[nodiscard]] consteval const ParameterRow& parameterRow(std::string_view key)
{
    for (const auto& row : kParameters) {
        if (row.key == key) {
            return row;
        }
    }
    throw std::logic_error("no such parameter");
}

[[nodiscard]] const ParameterRow* findParameter(int number);
[[nodiscard]] const ParameterRow* findParameter(QStringView key);

/// True when the controller takes this raw value (conformance C-59; 0x7E also needs a known baud).
[[nodiscard]] bool accepts(const ParameterRow& row, int raw);
[[nodiscard]] double physicalFromRaw(const ParameterRow& row, int raw);
/// Nearest raw value; none when the result is out of the row's range.
[[nodiscard]] std::optional<int> rawFromPhysical(const ParameterRow& row, double physical);
/// "500 ms", "2.40 A", "channels 1, 3", "19200 baud, CRC-7, 1 stop bit": translated, for people.
[[nodiscard]] QString parameterText(const ParameterRow& row, int raw);
/// PWM frequency for a prescaler and maximum (facts.md 2.1); 2 and 3 are inferred.
[[nodiscard]] double pwmHertz(int prescaler, int pwmMaximum);

} // namespace trex
