// SPDX-License-Identifier: GPL-3.0-or-later
// One cell of the fault matrix: one fault of the line, one packet form, one error detection, one
// kind of command, on virtual time. Every value that the engine delivers is held against what the
// simulated controller holds, and everything that its motors do against what was ordered.
#pragma once

#include "tests/support/simulatedlink.h"

#include <array>

namespace trex::test {

enum class Asked { Poll, ParameterRead, ParameterWrite, CalibrationWrite, Motor, Stop };
inline constexpr std::array kAskedNames{"poll",         "read parameter", "write parameter",
                                        "write calib.", "motor order",    "stop"};

/// What a fault may do without CRC-7, where nothing can tell, is bounded by the last two columns.
struct LineFault {
    const char* name;
    const char* amount; ///< in force during an episode, as the simulator takes it
    enum class Kind : std::uint8_t {
        Amount,
        Echo, ///< always there, as the wiring is
        OtherSpeed, ///< the controller comes back at another speed
        Reset, ///< and at the end of an episode once more
        Second, ///< a second controller with the same number is plugged in
    } kind = Kind::Amount;
    double mostWrong = 0.0; ///< share of the values delivered
    bool mayMove = false; ///< packets may arrive as orders that nobody gave
};
inline constexpr auto kLineFaults = std::to_array<LineFault>({
    {.name = "drop", .amount = "drop=0.05"},
    {.name = "drop, sent", .amount = "drop-sent=0.02", .mostWrong = 0.01, .mayMove = true},
    {.name = "corrupt", .amount = "corrupt=0.05", .mostWrong = 0.13},
    {.name = "corrupt, sent", .amount = "corrupt-sent=0.02", .mostWrong = 0.01, .mayMove = true},
    {.name = "duplicate", .amount = "duplicate=0.05", .mostWrong = 0.02},
    {.name = "duplicate, sent", .amount = "repeat-sent=0.02", .mostWrong = 0.01, .mayMove = true},
    {.name = "delay", .amount = "delay=130"}, // longer than the timeout: every reply is late
    {.name = "silence", .amount = "silent-for=1000000"},
    {.name = "garbage", .amount = "garbage=7", .mostWrong = 0.01},
    {.name = "hang-up", .amount = "hangup-for=1000000"},
    {.name = "reset", .amount = "reset-after=0.05", .kind = LineFault::Kind::Reset},
    {.name = "echo", .amount = "", .kind = LineFault::Kind::Echo},
    {.name = "wrong speed", .amount = "", .kind = LineFault::Kind::OtherSpeed, .mayMove = true},
    {.name = "second controller", .amount = "", .kind = LineFault::Kind::Second, .mostWrong = 0.8},
});

struct CellCounts {
    quint64 packets = 0;
    quint64 right = 0; ///< values delivered that the controller holds
    quint64 wrong = 0; ///< and such that it does not
    quint64 failed = 0; ///< transactions whose end was an error
    quint64 noReply = 0; ///< by the engine's own counters, from here
    quint64 badReplies = 0;
    quint64 crcErrors = 0; ///< to here
    quint64 recorded = 0; ///< failed attempts in the records, of any kind
    quint64 misheard = 0; ///< motors that did what no order said
    quint64 unstopped = 0; ///< stops after which a motor still ran
    quint64 running = 0; ///< a motor that ran, unasked, when the line was whole again
    quint64 hanging = 0; ///< transactions without an end
    quint64 unrecovered = 0; ///< episodes after which the link was not back within the bound
    Duration worstRecovery{0};
    CellCounts& operator+=(const CellCounts& other);
};

/// The link is back with a right answer this long after the fault has ceased.
inline constexpr std::chrono::milliseconds kRecoveryBound{2000};

class FaultCell {
public:
    FaultCell(const LineFault& fault, PacketForm form, ErrorDetection detection, Asked asked,
              quint64 seed);
    /// Episodes of the fault, each with a recovery, until so many packets were sent.
    [[nodiscard]] CellCounts run(quint64 packets);
    /// For so long, polling at full rate; every minute, about, an episode of any fault but those
    /// that are a matter of the wiring, with any kind of command.
    [[nodiscard]] CellCounts soak(Duration length);
    [[nodiscard]] quint64 samples() const; ///< of polls, delivered
    [[nodiscard]] quint64 sent(); ///< replies to polls that the controller sent
    [[nodiscard]] int episodes() const { return m_episode; }

private:
    struct Speeds {
        std::array<int, 3> values{};
        bool operator==(const Speeds&) const = default;
    };
    void begin();
    void episode();
    void takeCounts();
    void end();
    void work();
    void recover();
    void ask();
    void readParameter();
    void writeParameter();
    void writeCalibration();
    void drive();
    void stop();
    [[nodiscard]] std::optional<QByteArray> answerTo(const Command& command);
    void judge(bool isRight) { ++(isRight ? m_counts.right : m_counts.wrong); }
    void judge(const PollSample& sample);
    void watchMotors();
    void order(const Speeds& speeds);
    void sendStop();
    [[nodiscard]] Speeds outputs() const;
    [[nodiscard]] bool isSecond() const { return m_fault.kind == LineFault::Kind::Second; }
    [[nodiscard]] int number(int from, int to);
    [[nodiscard]] sim::Device& controller() { return m_link.line.device(0); }

    LineFault m_fault;
    LineSettings m_settings;
    Asked m_asked;
    sim::Random m_random;
    SimulatedLink m_link;
    CellCounts m_counts;
    std::vector<Speeds> m_allowed; ///< what the motors may do: the latest orders
    quint64 m_id = 0;
    int m_episode = 0;
    bool m_wasLost = false; ///< in this episode
};

} // namespace trex::test
