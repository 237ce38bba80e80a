// SPDX-License-Identifier: GPL-3.0-or-later
// What the firmware answers and does: one function a family of the command documentation.
#include "protocol/sim/firmware.h"

#include <algorithm>

namespace trex::sim {

using namespace std::chrono_literals;

namespace {

constexpr std::uint8_t kFormat = 0x40;
constexpr std::uint8_t kSendOverrun = 0x01;
constexpr std::uint8_t kEveryChannel = 0x1F;
constexpr std::uint8_t kFormatByte1 = 0x55;
constexpr std::uint8_t kFormatByte2 = 0x2A;
constexpr std::uint8_t kResetValue = 0x7F; // facts.md 2, 0x7F
constexpr std::uint8_t kUnknown = 0xFF; // facts.md 2, as the qik answers
constexpr int kResponseDelay = 0x17;

enum Answer : std::uint8_t { Done = 0, BadParameter = 1, BadValue = 2, NotInSerialMode = 3 };

constexpr auto kParameterWriting = 4ms; // command documentation, 0xAF
constexpr auto kCalibrationWriting = 32ms; // 0xA0
constexpr auto kPause = 1ms; // facts.md 1
constexpr auto kFastest = 60us; // some cycles to decode the packet and begin
constexpr int kSendBuffer = 64; // size unknown

// Bit 7 is the direction, bits 6:0 the magnitude (0x87).
std::uint8_t signAndMagnitude(int value)
{
    return static_cast<std::uint8_t>(value < 0 ? 0x80 | -value : value);
}

std::uint8_t lowByte(int word)
{
    return static_cast<std::uint8_t>(word & 0xFF);
}
std::uint8_t highByte(int word)
{
    return static_cast<std::uint8_t>((word >> 8) & 0xFF);
}

} // namespace

void Firmware::query(Instant now)
{
    const std::uint8_t command = m_reader.command();
    switch (command) {
    case 0x81:
        querySignature(now);
        return;
    case 0x82:
        answer(static_cast<std::uint8_t>(modeLetter()), now);
        return;
    case 0x83:
        answer(serialControls(now) ? 1 : 0, now);
        return;
    case 0x84:
        answer(std::exchange(m_status, std::uint8_t{0}), now);
        return; // C-20
    case 0x85:
        answer(std::exchange(m_uartError, std::uint8_t{0}), now);
        return; // C-21
    case 0x86:
    case 0x87:
        queryChannels(now);
        return;
    case 0x8D:
        answer(static_cast<std::uint8_t>(m_currents[0]), now);
        return;
    case 0x8E:
        answer(static_cast<std::uint8_t>(m_currents[1]), now);
        return;
    case 0x8F: {
        const std::array both{lowByte(m_currents[0]), lowByte(m_currents[1])};
        answer(QByteArrayView(both), now);
        return;
    }
    case 0x95: {
        int learned = 0; // differs from the defaults
        for (std::size_t i = 0; i < m_calibrations.size(); ++i) {
            learned |= m_calibrations[i] == factoryCalibration(inputKind()) ? 0 : 1 << i;
        }
        answer(lowByte(learned), now);
        return;
    }
    case 0x9F:
        queryParameter(now);
        return;
    default:
        break;
    }
    const auto& [minimum, neutral, maximum, deadband] =
        m_calibrations[static_cast<std::size_t>(command - 0x90)];
    const std::array values{lowByte(minimum),  highByte(minimum), lowByte(neutral),
                            highByte(neutral), lowByte(maximum),  highByte(maximum),
                            lowByte(deadband), highByte(deadband)};
    answer(QByteArrayView(values), now);
}

char Firmware::modeLetter() const
{
    if (m_mode == JumperMode::Serial) {
        return inputKind() == InputKind::Rc ? 'r' : 'a';
    }
    return m_mode == JumperMode::Rc ? 'R' : 'A';
}

void Firmware::querySignature(Instant now)
{
    QByteArray signature = m_model == Model::TrexJr ? "TReXJr" : "TReX"; // C-17, C-70
    signature += QByteArray::number(m_version.major) + '.' + QByteArray::number(m_version.minor);
    answer(signature, now);
}

void Firmware::queryChannels(Instant now)
{
    const std::uint8_t mask = m_reader.data(0);
    if (mask > kEveryChannel) {
        latchUart(kFormat); // C-09, C-23
        return;
    }
    std::array<std::uint8_t, 2 * kChannelCount> bytes{};
    qsizetype size = 0;
    const bool isRaw = m_reader.command() == 0x86;
    const auto raw = rawChannels(now);
    const auto values = isRaw ? ChannelUnit::Values{} : remapped(now);
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if ((mask & (1 << i)) == 0) {
            continue;
        }
        const auto place = static_cast<std::size_t>(size);
        if (isRaw) {
            bytes[place] = lowByte(raw[i]);
            bytes[place + 1] = highByte(raw[i]);
            size += 2;
        } else {
            bytes[place] = signAndMagnitude(values[i]);
            size += 1;
        }
    }
    if (size > 0) { // C-69
        answer(QByteArrayView(bytes.data(), size), now);
    }
}

void Firmware::queryParameter(Instant now)
{
    const int number = m_reader.data(0);
    const bool isOld = number == kResponseDelay && m_version < FirmwareVersion{1, 2};
    if (parameterLimits(number).exists && !isOld) {
        answer(m_eeprom.at(number), now);
        return;
    }
    latchUart(kFormat); // C-57
    if (m_quirks.unknownParameterAnswersFf) {
        answer(kUnknown, now);
    }
}

void Firmware::setCalibration(Instant now)
{
    if (m_reader.data(8) != kFormatByte1 || m_reader.data(9) != kFormatByte2) {
        latchUart(kFormat);
        return;
    }
    if (m_mode != JumperMode::Serial) {
        answer(NotInSerialMode, now);
        return;
    }
    // The documents do not say how much the low byte carries (C-35).
    const auto word = [this](std::size_t i) {
        return m_reader.data(2 * i) + (m_reader.data(2 * i + 1) << m_quirks.calibrationBits);
    };
    const CalibrationValues values{word(0), word(1), word(2), word(3)};
    if (values.minimum > values.neutral || values.neutral > values.maximum
        || values.minimum >= values.maximum) {
        answer(BadValue, now); // C-36
        return;
    }
    const int channel = m_reader.command() - 0xA0 + 1;
    m_eeprom.writeCalibration(inputKind(), channel, values);
    m_calibrations[index(channel)] = values;
    m_busyUntil = now + kCalibrationWriting;
    answer(Done, *m_busyUntil);
}

void Firmware::setParameterCommand(Instant now)
{
    if (m_reader.data(2) != kFormatByte1 || m_reader.data(3) != kFormatByte2) {
        latchUart(kFormat); // C-58: format, mode, number, value
        return;
    }
    const int number = m_reader.data(0);
    const int raw = m_reader.data(1);
    const bool isReset = number == 0x7F;
    const bool isOld = number == kResponseDelay && m_version < FirmwareVersion{1, 2};
    if (m_mode != JumperMode::Serial) {
        answer(NotInSerialMode, now);
    } else if ((!parameterLimits(number).exists && !isReset) || isOld) {
        answer(BadParameter, now);
    } else if (isReset ? raw != kResetValue : !takesParameter(number, raw)) {
        answer(BadValue, now);
    } else {
        if (isReset) { // C-60: in force after a power cycle, calibrations stay
            for (int each = 0; each < 0x7F; ++each) {
                if (parameterLimits(each).exists) {
                    m_eeprom.write(each, lowByte(parameterLimits(each).initial));
                }
            }
        } else {
            storeParameter(number, raw);
        }
        m_busyUntil = now + kParameterWriting;
        answer(Done, *m_busyUntil);
    }
}

void Firmware::motorCommand(Instant now)
{
    const std::uint8_t command = m_reader.command();
    const auto goal = [](bool immediate, int bits, int amount) {
        constexpr std::array directions{0, -1, 1, 0}; // brake low, reverse, forward, brake low
        return MotorGoal{immediate, directions[static_cast<std::size_t>(bits & 3)], amount};
    };
    if (command >= 0xF0) {
        order(MotorId::Aux, {command == 0xF0, 1, m_reader.data(0)});
    } else if (command >= 0xD0) {
        const bool isSet = command < 0xE0;
        order(MotorId::Motor1, goal(isSet, command, m_reader.data(0)));
        order(MotorId::Motor2, goal(isSet, command >> 2, m_reader.data(1)));
    } else {
        const bool isSet = (command & 0x04) == 0;
        const MotorId motor = (command & 0x08) == 0 ? MotorId::Motor1 : MotorId::Motor2;
        order(motor, goal(isSet, command, m_reader.data(0)));
    }
    if (m_quirks.motorCommandsAnswerFf) {
        answer(kUnknown, now);
    }
}

void Firmware::order(MotorId motor, const MotorGoal& goal)
{
    if (motor == MotorId::Motor2 && isJoint()) {
        return; // C-67
    }
    const auto i = static_cast<std::size_t>(motor);
    m_stored[i] = goal;
    if (m_serialWas) {
        m_drives[i].apply(goal);
    }
}

void Firmware::answer(std::uint8_t byte, Instant ready)
{
    answer(QByteArrayView(&byte, 1), ready);
}

void Firmware::answer(QByteArrayView bytes, Instant ready)
{
    m_sent.add(m_reader.command(), bytes);
    const bool pauses =
        m_version.minor == 1 || (m_version.minor > 1 && inForce(kResponseDelay) != 0);
    Reply reply;
    reply.begin = std::max(ready + (pauses ? Duration(kPause) : Duration(kFastest)), m_sendEnd);
    std::uint8_t crc = 0;
    for (const char each : bytes) {
        const auto byte = static_cast<std::uint8_t>(each);
        reply.bytes[reply.size++] = byte;
        crc = m_crc.step(crc, byte);
    }
    if (m_uart.hasCrc()) {
        reply.bytes[reply.size++] = crc;
    }
    const Duration byteTime = m_isPaced ? m_uart.byteTime() : Duration{0};
    if (m_isPaced && m_sendEnd - ready > byteTime * kSendBuffer) {
        latchUart(kSendOverrun);
        return;
    }
    if (reply.begin > m_sendEnd) {
        m_sendBegin = reply.begin;
    }
    m_sendEnd = reply.begin + byteTime * reply.size;
    m_replies.push_back(reply);
}

} // namespace trex::sim
