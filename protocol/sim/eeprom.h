// SPDX-License-Identifier: GPL-3.0-or-later
// The controller's EEPROM: bytes that outlive its power, and how often each was written.
#pragma once

#include "protocol/codec/quantities.h"
#include "protocol/result.h"

#include <QJsonObject>

#include <array>

namespace trex::sim {

/// In the order of the bytes of 0x90 (command documentation).
struct CalibrationValues {
    int minimum = 0;
    int neutral = 0;
    int maximum = 0;
    int deadband = 0;
    bool operator==(const CalibrationValues&) const = default;
};

/// The simulator's own layout: parameter n at address n, then the RC and the analog calibrations,
/// eight bytes a channel, low bytes first.
class Eeprom {
public:
    static constexpr int kSize = 256;
    static constexpr int kCalibrations = 0x80;
    [[nodiscard]] static constexpr int calibrationAddress(InputKind kind, int channel)
    {
        return kCalibrations + (kind == InputKind::Analog ? kChannelCount * 8 : 0)
            + (channel - 1) * 8;
    }

    [[nodiscard]] std::uint8_t at(int address) const { return m_bytes[index(address)]; }
    /// Counts, also when the byte stays the same: the cell wears either way.
    void write(int address, std::uint8_t value);
    /// Factory programming: does not count.
    void preset(int address, std::uint8_t value) { m_bytes[index(address)] = value; }

    [[nodiscard]] CalibrationValues calibration(InputKind kind, int channel) const;
    void writeCalibration(InputKind kind, int channel, const CalibrationValues& values);
    void presetCalibration(InputKind kind, int channel, const CalibrationValues& values);

    [[nodiscard]] int writeCount(int address) const { return m_writes[index(address)]; }
    [[nodiscard]] int totalWrites() const;

    [[nodiscard]] bool isDirty() const { return m_dirty; }
    void setClean() { m_dirty = false; }
    [[nodiscard]] QJsonObject toJson() const;
    /// FileMalformed with what is wrong.
    [[nodiscard]] static Result<Eeprom> fromJson(const QJsonObject& object);

private:
    static constexpr std::size_t index(int address)
    {
        return static_cast<std::size_t>(address) % kSize;
    }
    std::array<std::uint8_t, kSize> m_bytes = [] {
        std::array<std::uint8_t, kSize> erased{};
        erased.fill(0xFF);
        return erased;
    }();
    std::array<int, kSize> m_writes{};
    bool m_dirty = false;
};

/// All controllers of a line. FileUnreadable, FileMalformed; an empty list when there is no file.
[[nodiscard]] Result<std::vector<Eeprom>> loadEeproms(const QString& path);
/// Replaces the file in one step. FileUnwritable.
[[nodiscard]] Result<void> saveEeproms(const QString& path, const std::vector<Eeprom>& eeproms);

} // namespace trex::sim
