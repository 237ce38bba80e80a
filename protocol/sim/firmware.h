// SPDX-License-Identifier: GPL-3.0-or-later
// One controller's firmware, as a second reading of the vendor's documents: bytes, pulses, currents
// and virtual time in; replies and motor outputs out.
#pragma once

#include "protocol/sim/channelunit.h"
#include "protocol/sim/eeprom.h"
#include "protocol/sim/factory.h"
#include "protocol/sim/motordrive.h"
#include "protocol/sim/packetreader.h"
#include "protocol/sim/senttally.h"
#include "protocol/sim/simoptions.h"
#include "protocol/sim/wire.h"

#include <QByteArray>

#include <array>
#include <deque>
#include <vector>

namespace trex::sim {

/// A reply on its way: its first start bit begins at `begin`.
struct Reply {
    Instant begin;
    std::uint8_t size = 0;
    std::array<std::uint8_t, 15> bytes{};
    [[nodiscard]] QByteArrayView view() const { return {bytes.data(), size}; }
};

enum class PacketKind : std::uint8_t { Query, Setting, Motor, Null, BadFormat, BadCrc };

/// A packet that was meant for this controller, as it came, with header and CRC byte.
struct HeardPacket {
    Instant time; ///< end of its last byte
    PacketKind kind = PacketKind::Query;
    QByteArray bytes;
};

class Firmware {
public:
    Firmware(const SimOptions& options, Eeprom& eeprom, Instant start);

    /// All RAM as after power-up; parameters in force from the EEPROM.
    void powerUp(Instant now);
    void receive(const ReceivedByte& byte, Instant begin, Instant now);
    /// To be called each virtual millisecond, and with update() each tenth.
    void watch(Instant now);
    void update(Instant now);
    void captureChannel(int channel, std::uint16_t raw, Instant now);
    void setCurrents(int motor1, int motor2); ///< averaged conversions, 0 to 255
    /// Replies take their time on the wire, and the controller is deaf meanwhile (C-11).
    void setPaced(bool paced) { m_isPaced = paced; }

    [[nodiscard]] const std::vector<Reply>& replies() const { return m_replies; }
    void clearReplies() { m_replies.clear(); }
    /// While it writes its EEPROM it only gathers bytes; they are obeyed from here on.
    [[nodiscard]] std::optional<Instant> busyUntil() const { return m_busyUntil; }
    void resume(Instant now); ///< at busyUntil()

    void setMode(JumperMode mode);
    void setMix(bool on) { m_mix = on; }
    void setDriverFault(int motor, bool on) { m_driverFault[index(motor)] = on; }
    void storeParameter(int number, int raw);

    [[nodiscard]] MotorOutput output(MotorId motor) const;
    [[nodiscard]] int pwmMaximum(MotorId motor) const;
    [[nodiscard]] InputKind inputKind() const;
    [[nodiscard]] bool serialControls(Instant now) const; ///< 0x83
    [[nodiscard]] bool isHalted() const { return m_isHalted; } ///< safe-start, or a channel missing
    [[nodiscard]] int inForce(int number) const
    {
        return m_inForce[static_cast<std::size_t>(number)];
    }
    [[nodiscard]] const UartFormat& uart() const { return m_uart; }
    [[nodiscard]] std::uint8_t statusByte() const { return m_status; } ///< without clearing it
    [[nodiscard]] std::uint8_t uartErrorByte() const { return m_uartError; }
    [[nodiscard]] const std::deque<HeardPacket>& heard() const { return m_heard; }
    void clearHeard() { m_heard.clear(); }
    [[nodiscard]] const SentTally& sent() const { return m_sent; }

private:
    static std::size_t index(int oneBased) { return static_cast<std::size_t>(oneBased - 1); }
    void take(const ReceivedByte& byte, Instant now);
    void obey(Instant now);
    void latchUart(std::uint8_t bits);
    void shutDown();
    void note(PacketKind kind, Instant now);

    // Answers, in firmwarecommands.cpp.
    void query(Instant now);
    void queryChannels(Instant now);
    void queryParameter(Instant now);
    void querySignature(Instant now);
    void setCalibration(Instant now);
    void setParameterCommand(Instant now);
    void motorCommand(Instant now);
    void order(MotorId motor, const MotorGoal& goal);
    void answer(QByteArrayView bytes, Instant ready);
    void answer(std::uint8_t byte, Instant ready);

    void refreshCalibrations();
    [[nodiscard]] std::array<std::uint16_t, kChannelCount> rawChannels(Instant now) const;
    [[nodiscard]] ChannelUnit::Values remapped(Instant now) const;
    [[nodiscard]] bool isJoint() const { return inForce(0x7B) != 0; }
    [[nodiscard]] char modeLetter() const;
    void checkTimeout(bool serial, Instant now);
    void refreshHalt(const ChannelUnit::Values& values, Instant now);
    void refreshControl(bool serial);
    void followChannels(const ChannelUnit::Values& values);

    Eeprom& m_eeprom;
    Model m_model;
    FirmwareVersion m_version;
    Quirks m_quirks;
    JumperMode m_mode;
    bool m_mix;
    bool m_isPaced;

    std::array<int, 128> m_inForce{};
    std::array<CalibrationValues, kChannelCount> m_calibrations;
    UartFormat m_uart;
    PacketReader m_reader;
    CrcTable m_crc;
    ChannelUnit m_channels;
    std::array<MotorDrive, 3> m_drives;
    std::array<MotorGoal, 3> m_stored; ///< last serial orders (C-50)
    std::array<int, 2> m_currents{};
    std::array<bool, 2> m_driverFault{};
    std::array<Instant, kChannelCount> m_lastValid;
    std::array<bool, kChannelCount> m_wasValid{};

    std::uint8_t m_status = 0;
    std::uint8_t m_uartError = 0;
    bool m_serialWas = false;
    bool m_isHalted = false;
    bool m_isSafeStart = false;
    std::optional<Instant> m_lastByte; ///< none: timeout unarmed (C-62)
    std::vector<ReceivedByte> m_readBuffer;
    std::optional<Instant> m_busyUntil;
    Instant m_sendBegin;
    Instant m_sendEnd;
    std::vector<Reply> m_replies;
    std::deque<HeardPacket> m_heard;
    SentTally m_sent;
};

} // namespace trex::sim
