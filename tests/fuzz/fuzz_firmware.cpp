// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated controller: any bytes at any times, readable or not, with power cycles between.
//
// What it holds and does is checked without its own packet reader: a motor may turn only when the
// bytes that just came end with a whole, valid motor packet for it; what the EEPROM holds is in
// range; a reply is one that a command of that kind has.
#include "protocol/codec/parametertable.h"
#include "protocol/sim/device.h"
#include "tests/fuzz/peer.h"

using namespace trex;
using namespace std::chrono_literals;
using fuzz::holds;
using sim::Device;

namespace {

/// The motor packets of the command documentation, found at the end of what came, by what they look
/// like and nothing else. Any device number will do.
class MotorPackets {
public:
    void lose() { m_bytes.clear(); } ///< an unreadable byte
    /// True when a motor packet ends with this byte.
    [[nodiscard]] bool take(int byte, bool withCrc, int polynomial)
    {
        if ((byte & 0x80) != 0) {
            const bool isDevice = byte == 0x80;
            m_bytes = {byte};
            m_isPololu = isDevice;
            return false;
        }
        m_bytes.push_back(byte);
        const std::size_t head = m_isPololu ? 3 : 1;
        if (m_bytes.size() < head || m_bytes.front() == 0) {
            return false;
        }
        const int command = m_bytes[head - 1] | 0x80;
        const bool isDouble = command >= 0xD0 && command <= 0xEF;
        if (command < 0xC0 || command > 0xF1
            || m_bytes.size() != head + (isDouble ? 2U : 1U) + (withCrc ? 1U : 0U)) {
            return false;
        }
        QByteArray body;
        for (const int each : m_bytes) {
            body += static_cast<char>(each);
        }
        if (withCrc && fuzz::slowCrc(body.chopped(1), polynomial) != byte) {
            return false;
        }
        const int first = m_bytes[head];
        for (std::size_t i = 0; i < m_most.size(); ++i) {
            const bool isFor = i == 2 ? command >= 0xF0
                : isDouble            ? true
                                      : command < 0xF0 && ((command & 8) != 0) == (i == 1);
            const int amount = isDouble && i == 1 ? m_bytes[head + 1] : first;
            m_most[i] = isFor ? std::max(m_most[i], amount) : m_most[i];
        }
        return true;
    }
    void forget() { m_most = {}; }
    /// The most that any packet has asked of this motor since the power came on.
    [[nodiscard]] int most(std::size_t motor) const { return m_most[motor]; }

private:
    std::vector<int> m_bytes;
    bool m_isPololu = false;
    std::array<int, 3> m_most{};
};

sim::SimOptions anyOptions(fuzz::Input& input)
{
    sim::SimOptions options;
    const int bits = input.byte();
    options.model = (bits & 1) != 0 ? Model::Trex : Model::TrexJr;
    options.firmware.minor = bits >> 1 & 3;
    options.errorDetection = static_cast<ErrorDetection>(bits >> 3 & 3);
    options.mode = (bits & 0x60) == 0x20 ? sim::JumperMode::Rc
        : (bits & 0x60) == 0x40          ? sim::JumperMode::Analog
                                         : sim::JumperMode::Serial;
    options.pace = (bits & 0x80) != 0;
    const int more = input.byte();
    options.polynomial = (more & 1) != 0 ? std::uint8_t(input.byte() | 0x80) : kDefaultPolynomial;
    options.quirks.calibrationBits = (more & 2) != 0 ? 8 : 7;
    options.quirks.nullCommandIsError = (more & 4) != 0;
    options.quirks.unknownParameterAnswersFf = (more & 8) != 0;
    options.quirks.serialTimeoutActs = (more & 16) == 0;
    options.quirks.safeStart = (more & 32) != 0;
    options.quirks.motorCommandsAnswerFf = (more & 64) != 0;
    options.mix = (more & 128) != 0;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        options.scenario.channels.push_back({.channel = channel, .wave = sim::Wave::Missing});
    }
    return options;
}

class Bench {
public:
    explicit Bench(fuzz::Input& input)
        : m_input(input), m_options(anyOptions(input)), m_device(m_options, 0, nullptr, m_now)
    {
        m_device.setPaced(m_options.pace);
    }
    void play()
    {
        while (!m_input.isAtEnd() && m_now < Instant(1h) + 4s) {
            act();
            check();
        }
        m_now += 100ms;
        m_device.advance(m_now);
        check();
    }

private:
    void act()
    {
        const int choice = m_input.byte();
        if (choice < 0xC0) { // this many bytes, some at once, some a millisecond apart
            const QByteArray bytes = m_input.bytes(1 + (choice & 0x0F));
            for (const char each : bytes) {
                hear({.value = static_cast<std::uint8_t>(each)}, (choice & 0x10) != 0 ? 1ms : 60us);
            }
        } else if (choice < 0xD0) {
            hear({.value = m_input.byte(),
                  .frameError = (choice & 1) != 0,
                  .parityError = (choice & 2) != 0},
                 1ms);
        } else if (choice < 0xE0) {
            m_now += 5ms * m_input.byte();
            m_device.advance(m_now);
        } else if (choice < 0xE8) {
            m_now += 1ms;
            m_device.powerCycle(m_now);
            m_sendBegin = m_sendEnd = m_now;
            m_hasLostBytes = false;
            m_packets.forget();
            m_packets.lose();
        } else if (choice < 0xF0) {
            m_now += 40ms; // it has written its EEPROM
            m_device.advance(m_now);
        } else {
            m_device.setStall(1 + (choice & 1), (choice & 2) != 0);
            m_device.setLoad(1 + (choice & 1), (choice & 4) != 0 ? 1.0 : 0.0);
        }
    }
    void hear(const sim::ReceivedByte& byte, Duration apart)
    {
        const Instant begin = m_now;
        m_now += apart;
        m_device.advance(m_now);
        noteReplies();
        if (begin < m_sendEnd && m_now > m_sendBegin) {
            // C-11: it is deaf while it sends, and what came before and comes after are one.
        } else if (byte.frameError || byte.parityError) {
            m_packets.lose();
        } else {
            (void)m_packets.take(byte.value, m_device.uart().hasCrc(),
                                 0x80 | m_device.parameterInForce(0x7D));
        }
        m_device.receive(byte, begin, m_now);
        noteReplies();
        // Bytes that found its buffer full are lost, and what is left can be a packet nobody sent.
        constexpr int kReadBufferOverrun = 0x02;
        m_hasLostBytes =
            m_hasLostBytes || (m_device.firmware().uartErrorByte() & kReadBufferOverrun) != 0;
    }
    void noteReplies()
    {
        const Duration each = m_options.pace ? m_device.uart().byteTime() : Duration{0};
        for (const sim::Reply& reply : m_device.replies()) {
            const int crc = m_device.uart().hasCrc() ? 1 : 0;
            holds(reply.size > 0 && reply.size - crc <= 10, "a reply has the length of one");
            m_sendBegin = reply.begin > m_sendEnd ? reply.begin : m_sendBegin;
            m_sendEnd = reply.begin + each * reply.size;
        }
        m_device.clearReplies();
    }
    void check()
    {
        checkMotors();
        for (const ParameterRow& row : kParameters) {
            const int stored = m_device.storedParameter(row.number);
            holds(row.isTrigger || (stored >= row.minimum && stored <= row.maximum),
                  "the EEPROM holds values in range");
        }
        for (const InputKind kind : {InputKind::Rc, InputKind::Analog}) {
            for (int channel = 1; channel <= kChannelCount; ++channel) {
                const auto values = m_device.calibration(kind, channel);
                holds(values.minimum <= values.neutral && values.neutral <= values.maximum
                          && values.minimum < values.maximum,
                      "the EEPROM holds calibrations that rise");
            }
        }
        holds(m_device.uart().baud >= 1200 && m_device.uart().baud <= 115200,
              "a speed that exists");
        noteReplies();
        m_device.clearHeard();
        m_device.clearOutputChanges();
    }
    void checkMotors()
    {
        if (m_hasLostBytes || m_options.mode == sim::JumperMode::Analog) {
            return; // an open input is a voltage too, and drives
        }
        constexpr std::array kMotors{MotorId::Motor1, MotorId::Motor2, MotorId::Aux};
        const int both = std::max(m_packets.most(0), m_packets.most(1));
        const bool isJoint = m_device.parameterInForce(0x7B) != 0;
        for (std::size_t i = 0; i < kMotors.size(); ++i) {
            const sim::MotorOutput output = m_device.output(kMotors[i]);
            const int asked = isJoint && i < 2 ? both : m_packets.most(i);
            holds(std::abs(output.speed) <= asked, "a motor moves by a whole, valid packet only");
            holds(output.brake >= 0 && output.brake <= kFullSpeed, "a braking duty in range");
        }
        // Without pulses RC mode has nobody who drives.
        holds(m_options.mode == sim::JumperMode::Serial
                  || (m_device.output(MotorId::Motor1).speed == 0
                      && m_device.output(MotorId::Motor2).speed == 0),
              "without serial mode and signals nothing moves");
    }

    fuzz::Input& m_input;
    sim::SimOptions m_options;
    Instant m_now{1h};
    Device m_device;
    MotorPackets m_packets;
    bool m_hasLostBytes = false;
    Instant m_sendBegin = m_now;
    Instant m_sendEnd = m_now;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::Input input(data, size);
    Bench(input).play();
    return 0;
}
