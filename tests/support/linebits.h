// SPDX-License-Identifier: GPL-3.0-or-later
// A serial line bit by bit: bytes as levels on a wire, a receiver that samples them at a speed and
// parity of its own, and a reader of packets that looks for motor commands in what it heard.
// Independent of the program's own codec and of the simulator's wire.
#pragma once

#include <QByteArray>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace trex::test {

enum class Parity : std::uint8_t { None, Even, Odd };

/// The level of a wire over time, in seconds; it rests high.
class Wave {
public:
    /// Appends one character, `pause` seconds after what is there already.
    void send(int byte, double baud, Parity parity, int stopBits, double pause = 0.0)
    {
        const double bit = 1.0 / baud;
        double at = m_end + pause;
        set(at, false);
        at += bit;
        bool isOdd = false;
        for (int i = 0; i < 8; ++i, at += bit) {
            const bool high = (byte >> i & 1) != 0;
            isOdd = isOdd != high;
            set(at, high);
        }
        if (parity != Parity::None) {
            set(at, parity == Parity::Even ? isOdd : !isOdd);
            at += bit;
        }
        set(at, true);
        m_end = at + bit * stopBits;
    }

    [[nodiscard]] bool level(double at) const
    {
        const auto after = std::ranges::upper_bound(m_times, at);
        return after == m_times.begin() || m_levels[std::size_t(after - m_times.begin()) - 1];
    }
    /// The first fall at or after this time; negative: none.
    [[nodiscard]] double fall(double from) const
    {
        auto i = std::size_t(std::ranges::lower_bound(m_times, from) - m_times.begin());
        for (; i < m_times.size(); ++i) {
            if (!m_levels[i]) {
                return m_times[i];
            }
        }
        return -1.0;
    }

private:
    void set(double at, bool high)
    {
        if (m_levels.empty() ? !high : m_levels.back() != high) {
            m_times.push_back(at);
            m_levels.push_back(high);
        }
    }
    std::vector<double> m_times;
    std::vector<bool> m_levels;
    double m_end = 0.0;
};

struct HeardByte {
    int value = 0;
    bool frameError = false;
    bool parityError = false;
};

/// The controller's UART, as the data sheets of its family describe it: a fall begins a character,
/// each bit is the majority of three samples in its middle, of 16 or (double speed) 8 a bit.
struct Receiver {
    double baud = 19200;
    Parity parity = Parity::None;
    int samples = 16; ///< a bit
    double phase = 0.0; ///< of the sampling clock against the fall, in samples, 0 to 1
    bool restartsLow = false; ///< quirk: a line still low after a character begins the next one

    [[nodiscard]] std::vector<HeardByte> hear(const Wave& wave) const
    {
        std::vector<HeardByte> heard;
        const double bit = 1.0 / baud;
        const double sample = bit / samples;
        for (double from = 0.0;;) {
            const double fall = restartsLow && !wave.level(from) ? from : wave.fall(from);
            if (fall < 0.0) {
                return heard;
            }
            const double base = fall + phase * sample;
            const auto middle = [&](int which) {
                int high = 0;
                for (const double place : {-1.5, -0.5, 0.5}) {
                    high += wave.level(base + which * bit + (samples / 2 + place) * sample) ? 1 : 0;
                }
                return high >= 2;
            };
            if (middle(0)) {
                from = base + bit * 0.65; // too short for a start bit
                continue;
            }
            HeardByte byte;
            bool isOdd = false;
            for (int i = 0; i < 8; ++i) {
                if (middle(1 + i)) {
                    byte.value |= 1 << i;
                    isOdd = !isOdd;
                }
            }
            int next = 9;
            if (parity != Parity::None) {
                byte.parityError = middle(next) != (parity == Parity::Even ? isOdd : !isOdd);
                ++next;
            }
            byte.frameError = !middle(next);
            heard.push_back(byte);
            from = base + next * bit + bit * 0.65; // ready from the middle of the stop bit on
        }
    }
};

/// What a firmware may do with a byte that failed its frame or parity check; no document says.
enum class OnError : std::uint8_t { DropPacket, SkipByte, TakeByte };

/// Watches bytes for motor commands as a controller's packet reader would, at its most willing: any
/// device number is its own, and a CRC byte is always right. (Command documentation: 0xC0 to 0xF1
/// in the compact form; 0x80, device, 0x40 to 0x71 in the Pololu form; data bytes follow.)
class MotorWatch {
public:
    explicit MotorWatch(OnError onError) : m_onError(onError) { }

    void feed(const HeardByte& heard)
    {
        if (heard.frameError || heard.parityError) {
            if (m_onError == OnError::DropPacket) {
                m_state = State::Idle;
            }
            if (m_onError != OnError::TakeByte) {
                return;
            }
        }
        const int byte = heard.value;
        if (byte >= 0x80) {
            m_state = byte == 0x80 ? State::Number : State::Idle;
            begin(byte);
        } else if (m_state == State::Number) {
            m_state = State::Command;
        } else if (m_state == State::Command) {
            m_state = State::Idle;
            begin(byte | 0x80);
        } else if (m_state == State::Motor) {
            m_amount |= byte;
            if (--m_wanted == 0) {
                ++commands;
                moving += m_amount != 0 ? 1 : 0;
                m_state = State::Idle;
            }
        }
    }
    void feed(const std::vector<HeardByte>& heard)
    {
        for (const HeardByte& byte : heard) {
            feed(byte);
        }
    }
    /// A motor command waits for its data.
    [[nodiscard]] bool isOpen() const { return m_state == State::Motor; }
    /// Equal: the same bytes will be read alike. 0: no packet is open.
    [[nodiscard]] int state() const
    {
        return int(m_state) * 4 + (m_state == State::Motor ? m_wanted : 0);
    }

    int commands = 0;
    int moving = 0; ///< of them, with a speed or duty other than 0

private:
    enum class State : std::uint8_t { Idle, Number, Command, Motor };
    void begin(int command)
    {
        if (command >= 0xC0 && command <= 0xF1) {
            m_state = State::Motor;
            m_wanted = command >= 0xD0 && command < 0xF0 ? 2 : 1;
            m_amount = 0;
        }
    }
    OnError m_onError;
    State m_state = State::Idle;
    int m_wanted = 0;
    int m_amount = 0;
};

} // namespace trex::test
