// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/codec/polltable.h"
#include "protocol/procedures/benchlimits.h"
#include "protocol/procedures/benchtrace.h"

namespace trex {

/// How a bench test ended. Whatever it was, all three motors are told to stop.
enum class BenchEnd : std::uint8_t {
    Completed, ///< all steps done
    Limit, ///< a limit was exceeded, or a fault bit was set
    NotMet, ///< a wait's condition did not come
    Stale, ///< no fresh readings
    NotInControl, ///< the controller does not listen to serial
    Stopped, ///< STOP, Esc, disarmed: a person's doing
    LinkLost,
    Failed ///< an order was refused
};
struct BenchEnding {
    BenchEnd end = BenchEnd::Completed;
    QString reason; ///< a sentence's part: why
};

/// What the motors are to be told at one moment, by MotorId; the latest order for each.
using BenchOrders = std::array<std::optional<MotorOrder>, 3>;

/// The course of a bench test, pure: readings and time in, orders out. Nothing is ordered before
/// fresh readings are there, nor after they stay away. Whoever drives it (BenchTest over a real
/// controller, BenchDryRun over a simulated one) calls advance() often and, once hasEnded(), stops
/// the motors.
class BenchRun {
public:
    BenchRun(BenchProfile profile, Model model);
    BenchRun(const BenchRun&) = delete;
    BenchRun& operator=(const BenchRun&) = delete;

    static constexpr std::chrono::milliseconds kInterval{10}; ///< between calls of advance()
    static constexpr std::chrono::seconds kLongestWait{3}; ///< for the first readings

    void start(Instant now, quint64 linkErrors);
    /// A valid reply to a poll, at the time of its read.
    void take(const PollSample& sample);
    void setLinkErrors(quint64 linkErrors);
    /// What is due now. Empty once it has ended.
    [[nodiscard]] BenchOrders advance(Instant now);
    void end(BenchEnd end, const QString& reason); ///< the first one counts
    void note(int severity, const QString& text); ///< into the trace

    [[nodiscard]] bool hasStarted() const { return m_hasBegun; } ///< an order may have been given
    [[nodiscard]] bool hasEnded() const { return m_ending.has_value(); }
    [[nodiscard]] const BenchEnding& ending() const { return *m_ending; }
    [[nodiscard]] const BenchProfile& profile() const { return m_profile; }
    [[nodiscard]] const BenchTrace& trace() const { return m_trace; }
    [[nodiscard]] double seconds() const; ///< since the first order
    [[nodiscard]] QString position() const; ///< "step 3.2 (up), round 4 of 10"
    [[nodiscard]] bool wantsChannels() const; ///< a step waits for a channel

private:
    struct Level { ///< a list of steps under way
        const std::vector<BenchStep>* steps = nullptr;
        const BenchStep* repeat = nullptr; ///< whose list it is; null: the profile's
        std::size_t index = 0;
        int round = 0;
        BenchLimitWatch watch;
    };
    [[nodiscard]] const BenchStep* leaf() const;
    void begin(Instant now);
    void enter(Instant at); ///< the step at the cursor begins
    void leave(Instant at);
    [[nodiscard]] std::optional<Instant> leafEnd(Instant now);
    void steer(Instant now); ///< ramps and sines
    void order(BenchMotor motor, MotorOrder::Action action, int amount);
    void orderOne(MotorId motor, const MotorOrder& wanted);
    void checkAges(Instant now);
    void takeCurrents(const PollSample& sample);
    void takeStatus(const PollSample& sample);
    void checkCondition(const PollSample& sample);
    void limit(const QString& found, bool isStep);

    BenchProfile m_profile;
    BenchTrace m_trace;
    std::vector<Level> m_levels;
    BenchLimitWatch m_leafWatch;
    BenchOrders m_due;
    std::array<MotorOrder, 3> m_commanded{};
    std::array<MotorOrder, 3> m_before{}; ///< when the step under way began
    Instant m_asked; ///< start() was called
    Instant m_begun; ///< of the first order
    Instant m_leafStart;
    Instant m_now;
    Instant m_steered; ///< last order of a ramp or sine
    quint64 m_linkErrors = 0;
    quint64 m_linkErrorsBefore = 0;
    bool m_hasBegun = false;
    bool m_isMet = false; ///< the condition waited for
    int m_statusReads = 0;
    std::optional<Instant> m_lastCurrents;
    std::optional<Instant> m_lastStatus;
    std::optional<Instant> m_lastControl;
    std::optional<BenchEnding> m_ending;
};

/// True when one packet can carry both: both set (or brake), or both accelerate.
[[nodiscard]] bool canShare(const MotorOrder& motor1, const MotorOrder& motor2);

} // namespace trex
