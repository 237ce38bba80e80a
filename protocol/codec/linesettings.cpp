// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/linesettings.h"

#include "protocol/errortext.h"

namespace trex {
namespace {

constexpr std::array<std::string_view, 4> kDetectionKeys{"none", "even", "odd", "crc7"};
constexpr std::array<std::string_view, 2> kFormKeys{"compact", "pololu"};
constexpr std::chrono::milliseconds kLongestTimeout{60'000};

// Bits 6:5 of parameter 0x7E, by ErrorDetection (facts.md 2.3; 01 = CRC-7 is documented,
// guide 5.e).
constexpr std::array<int, 4> kDetectionBits{0b00, 0b10, 0b11, 0b01};

template <class Enum, std::size_t Count>
std::optional<Enum> fromKey(const std::array<std::string_view, Count>& keys, QStringView key)
{
    for (std::size_t i = 0; i < Count; ++i) {
        if (key == QLatin1StringView(keys[i].data(), static_cast<qsizetype>(keys[i].size()))) {
            return static_cast<Enum>(i);
        }
    }
    return std::nullopt;
}

} // namespace

bool LineSettings::hasParity() const
{
    return errorDetection == ErrorDetection::Even || errorDetection == ErrorDetection::Odd;
}

int LineSettings::bitsPerByte() const
{
    return 1 + 8 + (hasParity() ? 1 : 0) + stopBits;
}

Duration LineSettings::timeOf(int bytes) const
{
    const std::int64_t bits = std::int64_t{bytes} * bitsPerByte();
    const std::int64_t rate = std::max(baud, 1);
    // Whole seconds apart, so that no count overflows; rounded up, never shorter than the wire.
    return std::chrono::seconds(bits / rate)
        + Duration((bits % rate * std::nano::den + rate - 1) / rate);
}

Result<void> validate(const LineSettings& settings)
{
    if (baudIndex(settings.baud) < 0) {
        return outOfRange("baud", settings.baud, kBaudRates.front(), kBaudRates.back());
    }
    if (settings.polynomial < 0x80) {
        return outOfRange("crc-polynomial", settings.polynomial, 0x80, 0xFF);
    }
    if (settings.stopBits < 1 || settings.stopBits > 2) {
        return outOfRange("stop-bits", settings.stopBits, 1, 2);
    }
    if (settings.device > 127) {
        return outOfRange("device", settings.device, 0, 127);
    }
    if (settings.timeout.count() < 1 || settings.timeout > kLongestTimeout) {
        return outOfRange("timeout", settings.timeout.count(), 1, kLongestTimeout.count());
    }
    return {};
}

std::string_view keyOf(ErrorDetection detection)
{
    return kDetectionKeys[static_cast<std::size_t>(detection)];
}

std::string_view keyOf(PacketForm form)
{
    return kFormKeys[static_cast<std::size_t>(form)];
}

std::optional<ErrorDetection> errorDetectionFromKey(QStringView key)
{
    return fromKey<ErrorDetection>(kDetectionKeys, key);
}

std::optional<PacketForm> packetFormFromKey(QStringView key)
{
    return fromKey<PacketForm>(kFormKeys, key);
}

std::uint8_t UartSettings::toRaw() const
{
    const int detectionBits = kDetectionBits[static_cast<std::size_t>(errorDetection)];
    return static_cast<std::uint8_t>(detectionBits << 5 | (stopBits - 1) << 4 | baudIndex);
}

std::optional<UartSettings> UartSettings::fromRaw(int raw)
{
    const int index = raw & 0x0F;
    if (raw < 0 || raw > 127 || index >= static_cast<int>(kBaudRates.size())) {
        return std::nullopt;
    }
    const auto* const bits = std::ranges::find(kDetectionBits, raw >> 5);
    const auto detection = static_cast<ErrorDetection>(bits - kDetectionBits.begin());
    return UartSettings{index, detection, (raw >> 4 & 1) + 1};
}

} // namespace trex
