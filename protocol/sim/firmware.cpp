// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/firmware.h"

#include <algorithm>

namespace trex::sim {

using namespace std::chrono_literals;

namespace {

constexpr int kParameterCount = 128;
constexpr int kLargestBaudIndex = 10;
constexpr std::size_t kReadBuffer = 32; // size unknown; bytes gathered while the EEPROM is written
constexpr std::size_t kHeardKept = 4096;

// Bits of the status byte (command documentation, 0x84) and the UART error byte (0x85).
constexpr std::uint8_t kUartErrorBit = 0x01;
constexpr std::uint8_t kFormat = 0x40;
constexpr std::uint8_t kCrcError = 0x20;
constexpr std::uint8_t kFrame = 0x10;
constexpr std::uint8_t kParity = 0x04;
constexpr std::uint8_t kReadOverrun = 0x02;

// facts.md 2.3. Firmware before 1.2 runs at half of 28800 and 38400 (facts.md 1).
UartFormat uartFromByte(int byte, FirmwareVersion version)
{
    constexpr std::array rates{1200,  2400,  4800,  9600,  14400, 19200,
                               28800, 38400, 57600, 76800, 115200};
    UartFormat format;
    format.baud = rates[static_cast<std::size_t>(std::min(byte & 0x0F, kLargestBaudIndex))];
    if (version < FirmwareVersion{1, 2} && (format.baud == 28800 || format.baud == 38400)) {
        format.baud /= 2;
    }
    constexpr std::array detections{ErrorDetection::None, ErrorDetection::Crc7,
                                    ErrorDetection::Even, ErrorDetection::Odd};
    format.detection = detections[static_cast<std::size_t>((byte >> 5) & 3)];
    format.stopBits = (byte & 0x10) != 0 ? 2 : 1;
    return format;
}

} // namespace

Firmware::Firmware(const SimOptions& options, Eeprom& eeprom, Instant start)
    : m_eeprom(eeprom)
    , m_model(options.model)
    , m_version(options.firmware)
    , m_quirks(options.quirks)
    , m_mode(options.mode)
    , m_mix(options.mix)
    , m_isPaced(options.pace)
{
    powerUp(start);
}

void Firmware::powerUp(Instant now)
{
    for (int number = 0; number < kParameterCount; ++number) {
        m_inForce[static_cast<std::size_t>(number)] = m_eeprom.at(number);
    }
    m_uart = uartFromByte(inForce(0x7E), m_version);
    const auto polynomial = static_cast<std::uint8_t>(0x80 | inForce(0x7D));
    m_reader.configure(m_uart.hasCrc(), polynomial);
    m_reader.setDevice(static_cast<std::uint8_t>(inForce(0x00)));
    m_crc = CrcTable(polynomial);
    m_drives = {};
    m_stored = {};
    m_currents = {};
    m_status = 0;
    m_uartError = 0;
    m_lastByte.reset();
    m_readBuffer.clear();
    m_busyUntil.reset();
    m_sendBegin = m_sendEnd = now;
    m_replies.clear();
    setMode(m_mode);
}

void Firmware::setMode(JumperMode mode)
{
    m_mode = mode;
    m_channels.forget();
    m_wasValid = {};
    m_drives = {};
    m_serialWas = mode == JumperMode::Serial;
    m_isSafeStart = m_quirks.safeStart && !m_serialWas;
    m_isHalted = !m_serialWas;
    refreshCalibrations();
}

void Firmware::refreshCalibrations()
{
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        m_calibrations[index(channel)] = m_eeprom.calibration(inputKind(), channel);
    }
}

InputKind Firmware::inputKind() const
{
    const bool isAnalog =
        m_mode == JumperMode::Serial ? inForce(0x7C) != 0 : m_mode == JumperMode::Analog;
    return isAnalog ? InputKind::Analog : InputKind::Rc;
}

void Firmware::storeParameter(int number, int raw)
{
    const auto value = static_cast<std::uint8_t>(raw);
    m_eeprom.write(number, value);
    if (number >= 0x7B) {
        return; // after a power cycle (C-39)
    }
    m_inForce[static_cast<std::size_t>(number)] = value;
    if (number == 0x00) {
        m_reader.setDevice(value);
    }
}

void Firmware::receive(const ReceivedByte& byte, Instant begin, Instant now)
{
    if (begin < m_sendEnd && now > m_sendBegin) {
        return; // C-11
    }
    m_lastByte = now;
    if (!m_busyUntil) {
        take(byte, now);
    } else if (m_readBuffer.size() < kReadBuffer) {
        m_readBuffer.push_back(byte);
    } else {
        latchUart(kReadOverrun);
    }
}

void Firmware::resume(Instant now)
{
    m_busyUntil.reset();
    std::vector<ReceivedByte> gathered;
    gathered.swap(m_readBuffer);
    for (const auto& byte : gathered) {
        if (m_busyUntil) {
            m_readBuffer.push_back(byte); // one of them began another wait
        } else {
            take(byte, now);
        }
    }
}

void Firmware::take(const ReceivedByte& byte, Instant now)
{
    if (byte.frameError || byte.parityError) {
        m_reader.abandon();
        latchUart(static_cast<std::uint8_t>((byte.frameError ? kFrame : 0)
                                            | (byte.parityError ? kParity : 0)));
        return;
    }
    const PacketReader::Outcome outcome = m_reader.feed(byte.value);
    if (outcome.formatError) {
        latchUart(kFormat);
        note(PacketKind::BadFormat, now);
    }
    if (outcome.crcError) {
        latchUart(kCrcError);
        note(PacketKind::BadCrc, now);
    }
    if (outcome.isNull) {
        note(PacketKind::Null, now);
        if (m_quirks.nullCommandIsError) {
            latchUart(kFormat);
        }
    }
    if (outcome.isComplete) {
        obey(now);
    }
}

void Firmware::obey(Instant now)
{
    const std::uint8_t command = m_reader.command();
    if (command >= 0xC0) {
        note(PacketKind::Motor, now);
        motorCommand(now);
    } else if (command >= 0xA0) {
        note(PacketKind::Setting, now);
        if (command == 0xAF) {
            setParameterCommand(now);
        } else {
            setCalibration(now);
        }
    } else {
        note(PacketKind::Query, now);
        query(now);
    }
}

void Firmware::latchUart(std::uint8_t bits)
{
    m_uartError |= bits;
    m_status |= kUartErrorBit; // C-61
    if (inForce(0x08) != 0 && m_serialWas) {
        shutDown(); // C-52, C-62
    }
}

void Firmware::shutDown()
{
    for (auto& drive : m_drives) {
        drive.stop();
    }
    m_stored = {};
}

void Firmware::note(PacketKind kind, Instant now)
{
    if (m_heard.size() >= kHeardKept) {
        m_heard.pop_front();
    }
    m_heard.push_back({now,
                       kind,
                       {reinterpret_cast<const char*>(m_reader.bytes()),
                        static_cast<qsizetype>(m_reader.size())}});
}

} // namespace trex::sim
