// SPDX-License-Identifier: GPL-3.0-or-later
// A bench test as a value: what the motors are told, step by step, what stops it, and what is
// expected of it. The file format is described in benchprofile.md. A profile names no files, starts
// no programs, and moves nothing by being read.
#pragma once

#include "protocol/codec/command.h"
#include "protocol/result.h"

#include <map>
#include <optional>
#include <vector>

namespace trex {

enum class BenchMotor : std::uint8_t { Motor1, Motor2, Both, Aux };
enum class BenchAction : std::uint8_t {
    Set, ///< a speed at once, and on
    Accelerate, ///< a speed by the controller's own acceleration, and on
    Ramp, ///< speeds in even steps over `seconds`
    Step, ///< a speed for `seconds`, then back to what it was
    Sine, ///< around `speed`, for `seconds`
    Hold, ///< nothing new for `seconds`
    Brake, ///< a braking duty at once, and on
    Wait, ///< until a condition holds, at most `seconds`
    Repeat ///< `steps`, `times` times
};
enum class BenchCondition : std::uint8_t {
    CurrentAbove,
    CurrentBelow,
    Status,
    ChannelAbove,
    ChannelBelow,
    Time ///< since the start of the test
};
/// What the results of a run are computed from (benchanalysis.h).
enum class BenchAnalysis : std::uint8_t {
    General,
    StepResponse,
    SlowRamp,
    CurrentSpeed,
    LeftRight,
    Braking,
    Endurance
};

/// A text of the person's own in the file; written back where it stood.
struct BenchComment {
    QString key;
    QString after; ///< the key before it in its object; empty: it is the first
    QByteArray json;
    bool operator==(const BenchComment&) const = default;
};
using BenchComments = std::vector<BenchComment>;

/// What ends everything. A driver fault always does.
struct BenchLimits {
    static constexpr double kUsualStaleSeconds = 0.5;
    std::optional<double> seconds; ///< longer than this
    std::optional<double> amperes; ///< more than this in one motor, for `forSeconds` or longer
    double forSeconds = 0.0;
    std::optional<double> ampereSeconds; ///< current × time in one motor
    std::optional<int> linkErrors; ///< more than so many replies lost or damaged
    std::optional<double> staleSeconds; ///< no fresh reading for so long
    bool overCurrentStops = true; ///< an over-current bit; false: current limiting is wanted
    BenchComments comments;
    bool operator==(const BenchLimits&) const = default;
};

struct BenchStep {
    BenchAction action = BenchAction::Hold;
    BenchMotor motor = BenchMotor::Both;
    QString label{}; ///< for people
    int speed = 0; ///< −127 to 127; ramp: where it ends; sine: its middle; brake: duty 0 to 127
    std::optional<int> from{}; ///< ramp: where it begins; none: where the motor is
    int amplitude = 0; ///< sine
    double seconds = 0.0; ///< the length; wait: at most
    double period = 1.0; ///< sine, seconds
    BenchCondition condition = BenchCondition::Time;
    double threshold = 0.0; ///< wait: A, raw channel or s
    int number = 0; ///< wait: channel 1 to 5, or the status byte's bit
    bool mustHappen = true; ///< wait: that it did not come ends the test, as failed
    int times = 1;
    std::vector<BenchStep> steps{};
    BenchLimits limits{}; ///< while the step lasts, beside the profile's
    BenchComments comments{};
    bool operator==(const BenchStep&) const = default;
};

/// What a result has to be for the verdict "passed".
struct BenchExpectation {
    std::optional<double> minimum{};
    std::optional<double> maximum{};
    bool operator==(const BenchExpectation&) const = default;
};

struct BenchProfile {
    static constexpr int kVersion = 1;
    static constexpr double kLongestSeconds = 24.0 * 3600.0;
    static constexpr int kDeepestRepeat = 3;
    QString name;
    QString description;
    BenchAnalysis analysis = BenchAnalysis::General;
    BenchMotor motor = BenchMotor::Both; ///< of steps that name none
    std::optional<double> supplyVolts; ///< as the person measured it; none: not known
    double stopWithinSeconds = 0.5; ///< how soon a motor should stand, for the braking proposal
    BenchLimits limits;
    std::map<QString, BenchExpectation> expect; ///< by result key
    std::vector<BenchStep> steps;
    BenchComments comments;
    bool operator==(const BenchProfile&) const = default;

    [[nodiscard]] double staleSeconds() const
    {
        return limits.staleSeconds.value_or(BenchLimits::kUsualStaleSeconds);
    }
};

inline constexpr qint64 kLargestProfileBytes = qint64(256) * 1024;

/// All or nothing. Errors: FileMalformed, with `fileName`, the place (line, key) and the reason.
[[nodiscard]] Result<BenchProfile> parseBenchProfile(const QByteArray& json,
                                                     const QString& fileName);
/// The same profile gives the same bytes, and what was written is read back as the same profile.
[[nodiscard]] QByteArray writeBenchProfile(const BenchProfile& profile);
/// Errors: FileUnreadable (also for what is no ordinary file), FileMalformed.
[[nodiscard]] Result<BenchProfile> loadBenchProfile(const QString& path);
/// Whole or not at all. Errors: FileUnwritable.
[[nodiscard]] Result<void> saveBenchProfile(const BenchProfile& profile, const QString& path);

/// What a hand-made profile has to hold beyond its ranges: something to do, an end within
/// kLongestSeconds, no braking of the auxiliary motor. OutOfRange, with the step's number.
[[nodiscard]] Result<void> validate(const BenchProfile& profile);
/// The longest it can take by its own steps, waits counted to their end.
[[nodiscard]] double plannedSeconds(const BenchProfile& profile);
[[nodiscard]] double plannedSeconds(const BenchStep& step);
/// The highest speed magnitude that the steps ask of a motor; 0: it is never driven.
[[nodiscard]] int highestSpeed(const BenchProfile& profile, MotorId motor);
[[nodiscard]] bool drives(BenchMotor which, MotorId motor);

[[nodiscard]] QLatin1StringView keyOf(BenchMotor motor); ///< "1", "2", "both", "aux"
[[nodiscard]] QLatin1StringView keyOf(BenchAction action); ///< "set" …
[[nodiscard]] QLatin1StringView keyOf(BenchCondition condition); ///< "current-above" …
[[nodiscard]] QLatin1StringView keyOf(BenchAnalysis analysis); ///< "step-response" …
[[nodiscard]] QLatin1StringView statusBitKey(int bit); ///< "motor1-fault" …; "" for no such bit

} // namespace trex
