// SPDX-License-Identifier: GPL-3.0-or-later
// How the line to a controller is set: speed, error detection, packet form; and the time that
// bytes take on it.
#pragma once

#include "protocol/codec/quantities.h"
#include "protocol/result.h"

#include <array>
#include <string_view>

namespace trex {

enum class ErrorDetection : std::uint8_t { None, Even, Odd, Crc7 };
enum class PacketForm : std::uint8_t { Compact, Pololu };
enum class EchoMode : std::uint8_t { Auto, On, Off };

/// The 11 rates that the controller knows; the place in the list is the index that parameter 0x7E
/// carries (facts.md 2.3; 115200 = 10 observed, the rest inferred; conformance C-53).
inline constexpr std::array<int, 11> kBaudRates{1200,  2400,  4800,  9600,  14400, 19200,
                                                28800, 38400, 57600, 76800, 115200};
[[nodiscard]] constexpr int baudIndex(int baud)
{
    for (std::size_t i = 0; i < kBaudRates.size(); ++i) {
        if (kBaudRates[i] == baud) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

inline constexpr std::uint8_t kDefaultDeviceNumber = 7; // command documentation, 0x80
inline constexpr std::uint8_t kDefaultPolynomial = 0x89; // guide 5.e (facts.md 3)

struct LineSettings {
    int baud = 19200;
    ErrorDetection errorDetection = ErrorDetection::None;
    std::uint8_t polynomial = kDefaultPolynomial; ///< bit 7 set
    int stopBits = 1;
    PacketForm form = PacketForm::Compact;
    std::uint8_t device = kDefaultDeviceNumber; ///< 0 to 127; only in the Pololu form on the wire
    EchoMode echo = EchoMode::Auto;
    std::chrono::milliseconds timeout{100}; ///< wait for a reply above its time on the wire

    [[nodiscard]] bool hasCrc() const { return errorDetection == ErrorDetection::Crc7; }
    [[nodiscard]] bool hasParity() const;
    /// Start bit, eight data bits, parity if any, stop bits.
    [[nodiscard]] int bitsPerByte() const;
    /// Time of n bytes on the wire.
    [[nodiscard]] Duration timeOf(int bytes) const;
    bool operator==(const LineSettings&) const = default;
};

/// Every field in its range, or the first that is not, named in the error's context.
[[nodiscard]] Result<void> validate(const LineSettings& settings);

[[nodiscard]] std::string_view keyOf(ErrorDetection detection); ///< "none", "even", "odd", "crc7"
[[nodiscard]] std::string_view keyOf(PacketForm form); ///< "compact", "pololu"
[[nodiscard]] std::optional<ErrorDetection> errorDetectionFromKey(QStringView key);
[[nodiscard]] std::optional<PacketForm> packetFormFromKey(QStringView key);

/// Parameter 0x7E, taken apart (facts.md 2.3; bits 6:5 and 4 inferred but for CRC-7).
struct UartSettings {
    int baudIndex = 5;
    ErrorDetection errorDetection = ErrorDetection::None;
    int stopBits = 1;
    [[nodiscard]] std::uint8_t toRaw() const;
    [[nodiscard]] static std::optional<UartSettings> fromRaw(int raw); ///< none: no such index
};

} // namespace trex
