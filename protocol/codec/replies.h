// SPDX-License-Identifier: GPL-3.0-or-later
// Replies as typed values. Each parse function takes a payload whose length and CRC were already
// checked and says BadReply, with what it saw, when no TReX answers so (a signature that does not
// begin with "TReX": NotATrex).
#pragma once

#include "protocol/codec/command.h"
#include "protocol/codec/quantities.h"
#include "protocol/result.h"

#include <QByteArrayView>

namespace trex {

/// "TReXJr1.2" or, from a DMC01, "TReX1.2" (conformance C-17, C-70).
struct Signature {
    Model model = Model::TrexJr;
    int major = 0;
    int minor = 0;
    [[nodiscard]] QString text() const; ///< as sent
    [[nodiscard]] QString modelName() const; ///< "TReX Jr" or "TReX"
    [[nodiscard]] QString firmware() const; ///< "1.2"
    bool operator==(const Signature&) const = default;
};
[[nodiscard]] Result<Signature> parseSignature(QByteArrayView payload);

enum class Mode : std::uint8_t { Rc, Analog, SerialRc, SerialAnalog };
[[nodiscard]] Result<Mode> parseMode(QByteArrayView payload);
[[nodiscard]] char letterOf(Mode mode); ///< 'R' 'A' 'r' 'a'
[[nodiscard]] std::string_view keyOf(Mode mode); ///< "rc" "analog" "serial-rc" "serial-analog"
[[nodiscard]] constexpr bool isSerial(Mode mode)
{
    return mode == Mode::SerialRc || mode == Mode::SerialAnalog;
}
[[nodiscard]] constexpr InputKind inputOf(Mode mode)
{
    return mode == Mode::Rc || mode == Mode::SerialRc ? InputKind::Rc : InputKind::Analog;
}

/// Bits of 0x84 (command documentation, 0x84).
namespace statusbit {
inline constexpr std::uint8_t kMotor2OverCurrent = 0x80, kMotor2Fault = 0x40,
                              kMotor1OverCurrent = 0x20, kMotor1Fault = 0x10, kUartError = 0x01;
}
/// Bits of 0x85 (command documentation, 0x85).
namespace uartbit {
inline constexpr std::uint8_t kTimeout = 0x80, kFormat = 0x40, kCrc = 0x20, kFrame = 0x10,
                              kOverrun = 0x08, kParity = 0x04, kReadBufferOverrun = 0x02,
                              kSendBufferOverrun = 0x01;
}

[[nodiscard]] Calibration parseCalibration(QByteArrayView payload); ///< 8 bytes of 0x90 to 0x94
/// The answer byte of 0xA0 to A4 and 0xAF: 0 is success, else the matching refusal.
[[nodiscard]] Result<void> parseAnswer(QByteArrayView payload);

} // namespace trex
