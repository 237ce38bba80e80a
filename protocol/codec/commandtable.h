// SPDX-License-Identifier: GPL-3.0-or-later
// THE command table: one row for each command of the firmware 1.2 command documentation. Encoding,
// decoding, timing, retries, the packet view, `trexctl raw` and the tests loop over it.
#pragma once

#include "protocol/codec/fieldspec.h"

#include <QtGlobal>

#include <array>
#include <stdexcept>

namespace trex {

enum class CommandKind : std::uint8_t { Framing, Query, Setting, Motor };

/// What to do when no valid reply came.
enum class Retry : std::uint8_t {
    Safe, ///< ask again
    ReadClears, ///< ask again, but the lost reply may have taken latched bits with it: say so
    Never, ///< a write whose effect is unknown: read back instead
    NoReply, ///< motor command: nothing to wait for
};

enum class ReplyRule : std::uint8_t { None, Fixed, PerMaskBit, Signature };

/// What the low bits of the opcode say.
enum class OpcodeBits : std::uint8_t { None, Channel, Direction, DirectionPair };

struct CommandRow {
    std::uint8_t first = 0; ///< opcode, or the first of the row's range
    std::uint8_t last = 0;
    std::string_view key;
    const char* title = nullptr; ///< QT_TRANSLATE_NOOP("Commands", …)
    const char* help = nullptr;
    CommandKind kind = CommandKind::Query;
    OpcodeBits opcodeBits = OpcodeBits::None;
    std::span<const FieldSpec> arguments{};
    ReplyRule replyRule = ReplyRule::None;
    int replyBytes = 0; ///< fixed length, bytes a mask bit, or the longest signature
    std::span<const FieldSpec> reply{}; ///< with PerMaskBit: one field, repeated
    std::chrono::milliseconds processing{0}; ///< the controller's own time before it answers
    std::chrono::milliseconds giveUp{0}; ///< document's limit; 0: the line's timeout decides
    Retry retry = Retry::Safe;
    bool needsSerialMode = false;
    Grade grade = Grade::Documented;
    std::string_view source; ///< document and section
};

namespace commandfields {
inline constexpr std::array<std::string_view, 5> kChannelBits{"channel1", "channel2", "channel3",
                                                              "channel4", "channel5"};
inline constexpr std::array<std::string_view, 8> kStatusBits{
    "uart-error",         "", "", "", "motor1-fault", "motor1-over-current", "motor2-fault",
    "motor2-over-current"};
inline constexpr std::array<std::string_view, 8> kUartBits{"send-buffer-overrun",
                                                           "read-buffer-overrun",
                                                           "parity",
                                                           "overrun",
                                                           "frame",
                                                           "crc",
                                                           "format",
                                                           "timeout"};
inline constexpr std::array kMask{FieldSpec{"mask", FieldKind::Bits, 0, 31, kChannelBits}};
inline constexpr std::array kDevice{FieldSpec{"device", FieldKind::Byte, 0, 127}};
inline constexpr std::array kNumber{FieldSpec{"parameter", FieldKind::Byte, 0, 127}};
inline constexpr std::array kSpeed{FieldSpec{"speed", FieldKind::Byte, 0, 127}};
inline constexpr std::array kTwoSpeeds{FieldSpec{"motor1-speed", FieldKind::Byte, 0, 127},
                                       FieldSpec{"motor2-speed", FieldKind::Byte, 0, 127}};
inline constexpr std::array kSetCalibration{FieldSpec{"minimum", FieldKind::Pair7, 0, 16383},
                                            FieldSpec{"neutral", FieldKind::Pair7, 0, 16383},
                                            FieldSpec{"maximum", FieldKind::Pair7, 0, 16383},
                                            FieldSpec{"deadband", FieldKind::Pair7, 0, 16383},
                                            FieldSpec{"format1", FieldKind::Constant, 0x55, 0x55},
                                            FieldSpec{"format2", FieldKind::Constant, 0x2A, 0x2A}};
inline constexpr std::array kSetParameter{FieldSpec{"parameter", FieldKind::Byte, 0, 127},
                                          FieldSpec{"value", FieldKind::Byte, 0, 127},
                                          FieldSpec{"format1", FieldKind::Constant, 0x55, 0x55},
                                          FieldSpec{"format2", FieldKind::Constant, 0x2A, 0x2A}};

inline constexpr std::array kText{FieldSpec{"signature", FieldKind::Ascii, 0, 255}};
inline constexpr std::array kMode{FieldSpec{"mode", FieldKind::Ascii, 0, 255}};
inline constexpr std::array kFlag{FieldSpec{"serial-controls", FieldKind::Byte, 0, 1}};
inline constexpr std::array kStatus{FieldSpec{"status", FieldKind::Bits, 0, 255, kStatusBits}};
inline constexpr std::array kUart{FieldSpec{"uart-errors", FieldKind::Bits, 0, 255, kUartBits}};
inline constexpr std::array kRaw{FieldSpec{"raw", FieldKind::Word, 0, 65535}};
inline constexpr std::array kRemapped{FieldSpec{"remapped", FieldKind::SignMagnitude, -127, 127}};
inline constexpr std::array kCurrent1{FieldSpec{"motor1-current", FieldKind::Byte, 0, 255}};
inline constexpr std::array kCurrent2{FieldSpec{"motor2-current", FieldKind::Byte, 0, 255}};
inline constexpr std::array kCurrents{FieldSpec{"motor1-current", FieldKind::Byte, 0, 255},
                                      FieldSpec{"motor2-current", FieldKind::Byte, 0, 255}};
inline constexpr std::array kCalibration{FieldSpec{"minimum", FieldKind::Word, 0, 65535},
                                         FieldSpec{"neutral", FieldKind::Word, 0, 65535},
                                         FieldSpec{"maximum", FieldKind::Word, 0, 65535},
                                         FieldSpec{"deadband", FieldKind::Word, 0, 65535}};
inline constexpr std::array kLearned{FieldSpec{"learned", FieldKind::Bits, 0, 31, kChannelBits}};
inline constexpr std::array kValue{FieldSpec{"value", FieldKind::Byte, 0, 255}};
inline constexpr std::array kAnswer{FieldSpec{"answer", FieldKind::AnswerCode, 0, 3}};
} // namespace commandfields

// clang-format off
inline constexpr auto kCommands = std::to_array<CommandRow>({
    {.first = 0x80, .last = 0x80, .key = "pololu-packet", .title = QT_TRANSLATE_NOOP("Commands", "Pololu packet"),
     .help = QT_TRANSLATE_NOOP("Commands", "Starts a packet for one device on a shared line: device number, then the command with its top bit cleared."),
     .kind = CommandKind::Framing, .arguments = commandfields::kDevice, .retry = Retry::NoReply, .source = "command documentation, 0x80"},
    {.first = 0x81, .last = 0x81, .key = "get-signature", .title = QT_TRANSLATE_NOOP("Commands", "Get signature"),
     .help = QT_TRANSLATE_NOOP("Commands", "Product name and firmware version: nine bytes from a TReX Jr, seven from a TReX."),
     .replyRule = ReplyRule::Signature, .replyBytes = 9, .reply = commandfields::kText, .source = "command documentation, 0x81"},
    {.first = 0x82, .last = 0x82, .key = "get-mode", .title = QT_TRANSLATE_NOOP("Commands", "Get mode"),
     .help = QT_TRANSLATE_NOOP("Commands", "Mode set by the mode jumper: R RC, A analog, r serial with RC inputs, a serial with analog inputs."),
     .replyRule = ReplyRule::Fixed, .replyBytes = 1, .reply = commandfields::kMode, .source = "command documentation, 0x82"},
    {.first = 0x83, .last = 0x83, .key = "get-serial-control", .title = QT_TRANSLATE_NOOP("Commands", "Does serial control the motors?"),
     .help = QT_TRANSLATE_NOOP("Commands", "1 in serial mode or while channel 5 overrides, else 0."),
     .replyRule = ReplyRule::Fixed, .replyBytes = 1, .reply = commandfields::kFlag, .source = "command documentation, 0x83"},
    {.first = 0x84, .last = 0x84, .key = "get-status", .title = QT_TRANSLATE_NOOP("Commands", "Get status byte"),
     .help = QT_TRANSLATE_NOOP("Commands", "Faults and over-current of both motors, UART error. Reading clears the latched bits in the controller."),
     .replyRule = ReplyRule::Fixed, .replyBytes = 1, .reply = commandfields::kStatus, .retry = Retry::ReadClears, .source = "command documentation, 0x84"},
    {.first = 0x85, .last = 0x85, .key = "get-uart-errors", .title = QT_TRANSLATE_NOOP("Commands", "Get UART error byte"),
     .help = QT_TRANSLATE_NOOP("Commands", "What was wrong on the serial line. Reading clears the latched bits in the controller."),
     .replyRule = ReplyRule::Fixed, .replyBytes = 1, .reply = commandfields::kUart, .retry = Retry::ReadClears, .source = "command documentation, 0x85"},
    {.first = 0x86, .last = 0x86, .key = "get-raw-channels", .title = QT_TRANSLATE_NOOP("Commands", "Get raw channel values"),
     .help = QT_TRANSLATE_NOOP("Commands", "Inputs as measured: pulse widths of 0.4 µs (0xFFFF is no valid pulse) or 10-bit voltages."),
     .arguments = commandfields::kMask, .replyRule = ReplyRule::PerMaskBit, .replyBytes = 2, .reply = commandfields::kRaw, .source = "command documentation, 0x86"},
    {.first = 0x87, .last = 0x87, .key = "get-remapped-channels", .title = QT_TRANSLATE_NOOP("Commands", "Get remapped channel values"),
     .help = QT_TRANSLATE_NOOP("Commands", "Inputs after calibration, reversal, curve, mix and flip: what the motors would be told."),
     .arguments = commandfields::kMask, .replyRule = ReplyRule::PerMaskBit, .replyBytes = 1, .reply = commandfields::kRemapped, .source = "command documentation, 0x87"},
    {.first = 0x8D, .last = 0x8D, .key = "get-motor1-current", .title = QT_TRANSLATE_NOOP("Commands", "Get motor 1 current"),
     .help = QT_TRANSLATE_NOOP("Commands", "Averaged current, 40 mA a unit on a TReX Jr. Independent motor mode only."),
     .replyRule = ReplyRule::Fixed, .replyBytes = 1, .reply = commandfields::kCurrent1, .source = "command documentation, 0x8D"},
    {.first = 0x8E, .last = 0x8E, .key = "get-motor2-current", .title = QT_TRANSLATE_NOOP("Commands", "Get motor 2 current"),
     .help = QT_TRANSLATE_NOOP("Commands", "Averaged current, 40 mA a unit on a TReX Jr. Independent motor mode only."),
     .replyRule = ReplyRule::Fixed, .replyBytes = 1, .reply = commandfields::kCurrent2, .source = "command documentation, 0x8E"},
    {.first = 0x8F, .last = 0x8F, .key = "get-currents", .title = QT_TRANSLATE_NOOP("Commands", "Get motor currents"),
     .help = QT_TRANSLATE_NOOP("Commands", "Currents of motor 1 and motor 2 in one reply."),
     .replyRule = ReplyRule::Fixed, .replyBytes = 2, .reply = commandfields::kCurrents, .source = "command documentation, 0x8F"},
    {.first = 0x90, .last = 0x94, .key = "get-calibration", .title = QT_TRANSLATE_NOOP("Commands", "Get channel calibration"),
     .help = QT_TRANSLATE_NOOP("Commands", "Minimum, neutral, maximum and deadband of one channel, of the input set in force."),
     .opcodeBits = OpcodeBits::Channel, .replyRule = ReplyRule::Fixed, .replyBytes = 8, .reply = commandfields::kCalibration, .source = "command documentation, 0x90"},
    {.first = 0x95, .last = 0x95, .key = "get-learned", .title = QT_TRANSLATE_NOOP("Commands", "Get calibrated channels"),
     .help = QT_TRANSLATE_NOOP("Commands", "Channels whose calibration differs from the defaults."),
     .replyRule = ReplyRule::Fixed, .replyBytes = 1, .reply = commandfields::kLearned, .source = "command documentation, 0x95"},
    {.first = 0x9F, .last = 0x9F, .key = "get-parameter", .title = QT_TRANSLATE_NOOP("Commands", "Get configuration parameter"),
     .help = QT_TRANSLATE_NOOP("Commands", "The stored value of one configuration parameter."),
     .arguments = commandfields::kNumber, .replyRule = ReplyRule::Fixed, .replyBytes = 1, .reply = commandfields::kValue, .source = "command documentation, 0x9F"},
    {.first = 0xA0, .last = 0xA4, .key = "set-calibration", .title = QT_TRANSLATE_NOOP("Commands", "Set channel calibration"),
     .help = QT_TRANSLATE_NOOP("Commands", "Stores one channel's calibration (serial mode only). Answers when stored, after about 32 ms."),
     .kind = CommandKind::Setting, .opcodeBits = OpcodeBits::Channel, .arguments = commandfields::kSetCalibration, .replyRule = ReplyRule::Fixed, .replyBytes = 1,
     .reply = commandfields::kAnswer, .processing = std::chrono::milliseconds(32), .giveUp = std::chrono::milliseconds(100), .retry = Retry::Never, .needsSerialMode = true, .source = "command documentation, 0xA0"},
    {.first = 0xAF, .last = 0xAF, .key = "set-parameter", .title = QT_TRANSLATE_NOOP("Commands", "Set configuration parameter"),
     .help = QT_TRANSLATE_NOOP("Commands", "Stores one configuration parameter (serial mode only). Answers when stored, after about 4 ms."),
     .kind = CommandKind::Setting, .arguments = commandfields::kSetParameter, .replyRule = ReplyRule::Fixed, .replyBytes = 1,
     .reply = commandfields::kAnswer, .processing = std::chrono::milliseconds(4), .giveUp = std::chrono::milliseconds(50), .retry = Retry::Never, .needsSerialMode = true, .source = "command documentation, 0xAF"},
    {.first = 0xC0, .last = 0xC3, .key = "set-motor1", .title = QT_TRANSLATE_NOOP("Commands", "Set motor 1"),
     .help = QT_TRANSLATE_NOOP("Commands", "Sets speed and direction, or braking duty, at once; overrides current limiting for the moment."),
     .kind = CommandKind::Motor, .opcodeBits = OpcodeBits::Direction, .arguments = commandfields::kSpeed, .retry = Retry::NoReply, .source = "command documentation, 0xC0"},
    {.first = 0xC4, .last = 0xC7, .key = "accelerate-motor1", .title = QT_TRANSLATE_NOOP("Commands", "Accelerate motor 1"),
     .help = QT_TRANSLATE_NOOP("Commands", "Sets the target speed; the controller accelerates to it every 10 ms and keeps to the current limit."),
     .kind = CommandKind::Motor, .opcodeBits = OpcodeBits::Direction, .arguments = commandfields::kSpeed, .retry = Retry::NoReply, .source = "command documentation, 0xC4"},
    {.first = 0xC8, .last = 0xCB, .key = "set-motor2", .title = QT_TRANSLATE_NOOP("Commands", "Set motor 2"),
     .help = QT_TRANSLATE_NOOP("Commands", "Sets speed and direction, or braking duty, at once; overrides current limiting for the moment."),
     .kind = CommandKind::Motor, .opcodeBits = OpcodeBits::Direction, .arguments = commandfields::kSpeed, .retry = Retry::NoReply, .source = "command documentation, 0xC8"},
    {.first = 0xCC, .last = 0xCF, .key = "accelerate-motor2", .title = QT_TRANSLATE_NOOP("Commands", "Accelerate motor 2"),
     .help = QT_TRANSLATE_NOOP("Commands", "Sets the target speed; the controller accelerates to it every 10 ms and keeps to the current limit."),
     .kind = CommandKind::Motor, .opcodeBits = OpcodeBits::Direction, .arguments = commandfields::kSpeed, .retry = Retry::NoReply, .source = "command documentation, 0xCC"},
    {.first = 0xD0, .last = 0xDF, .key = "set-motors", .title = QT_TRANSLATE_NOOP("Commands", "Set motors 1 and 2"),
     .help = QT_TRANSLATE_NOOP("Commands", "Sets both motors at once; overrides current limiting for the moment."),
     .kind = CommandKind::Motor, .opcodeBits = OpcodeBits::DirectionPair, .arguments = commandfields::kTwoSpeeds, .retry = Retry::NoReply, .source = "command documentation, 0xD0"},
    // The document's formula prints 0xD0 here too; its heading and conformance C-44 say 0xE0.
    {.first = 0xE0, .last = 0xEF, .key = "accelerate-motors", .title = QT_TRANSLATE_NOOP("Commands", "Accelerate motors 1 and 2"),
     .help = QT_TRANSLATE_NOOP("Commands", "Sets the target speeds of both motors."),
     .kind = CommandKind::Motor, .opcodeBits = OpcodeBits::DirectionPair, .arguments = commandfields::kTwoSpeeds, .retry = Retry::NoReply, .source = "command documentation, 0xE0"},
    {.first = 0xF0, .last = 0xF0, .key = "set-aux", .title = QT_TRANSLATE_NOOP("Commands", "Set auxiliary motor"),
     .help = QT_TRANSLATE_NOOP("Commands", "Sets the speed of the auxiliary motor, one direction, at once."),
     .kind = CommandKind::Motor, .arguments = commandfields::kSpeed, .retry = Retry::NoReply, .source = "command documentation, 0xF0"},
    {.first = 0xF1, .last = 0xF1, .key = "accelerate-aux", .title = QT_TRANSLATE_NOOP("Commands", "Accelerate auxiliary motor"),
     .help = QT_TRANSLATE_NOOP("Commands", "Sets the target speed of the auxiliary motor."),
     .kind = CommandKind::Motor, .arguments = commandfields::kSpeed, .retry = Retry::NoReply, .source = "command documentation, 0xF1"},
});
// clang-format on

static_assert([] {
    int previousLast = 0x7F;
    for (const auto& row : kCommands) {
        if (row.first <= previousLast || row.last < row.first || row.title == nullptr
            || row.help == nullptr || row.key.empty() || row.source.empty()
            || (row.replyRule == ReplyRule::None) != (row.retry == Retry::NoReply)) {
            return false;
        }
        previousLast = row.last;
    }
    return true;
}());

/// The row of an opcode; null where the document knows no such command.
[[nodiscard]] constexpr const CommandRow* findCommand(std::uint8_t opcode)
{
    for (const auto& row : kCommands) {
        if (opcode >= row.first && opcode <= row.last) {
            return &row;
        }
    }
    return nullptr;
}

/// The row of a key known when compiling: a wrong key does not compile.
[[nodiscard]] consteval const CommandRow& commandRow(std::string_view key)
{
    for (const auto& row : kCommands) {
        if (row.key == key) {
            return row;
        }
    }
    throw std::logic_error("no such command");
}

/// Data bytes that a command of this row carries.
[[nodiscard]] constexpr int argumentBytes(const CommandRow& row)
{
    int bytes = 0;
    for (const auto& field : row.arguments) {
        bytes += field.width();
    }
    return bytes;
}

/// The row of a key from a person; null when there is none.
[[nodiscard]] const CommandRow* findCommand(std::string_view key);

} // namespace trex
