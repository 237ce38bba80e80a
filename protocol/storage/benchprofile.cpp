// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/benchprofile.h"

#include "protocol/savefile.h"
#include "protocol/storage/benchtext.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cstdlib>
#include <numeric>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr std::array kMotors{"1", "2", "both", "aux"};
constexpr std::array kActions{"set",  "accelerate", "ramp", "step",  "sine",
                              "hold", "brake",      "wait", "repeat"};
constexpr std::array kConditions{"current-above", "current-below", "status",
                                 "channel-above", "channel-below", "time"};
constexpr std::array kAnalyses{"general",    "step-response", "slow-ramp", "current-speed",
                               "left-right", "braking",       "endurance"};
constexpr std::array kBits{
    "uart-error",         "", "", "", "motor1-fault", "motor1-over-current", "motor2-fault",
    "motor2-over-current"};

Result<void> checkSteps(const std::vector<BenchStep>& steps, const QString& before, int depth)
{
    const auto wrong = [](const QString& where, const QString& why) {
        return fail(ErrorCode::OutOfRange, Bench::tr("step %1: %2").arg(where, why));
    };
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const BenchStep& step = steps[i];
        const QString where = before + QString::number(i + 1);
        if (step.action == BenchAction::Brake && step.motor == BenchMotor::Aux) {
            return wrong(where, Bench::tr("the auxiliary motor cannot brake"));
        }
        const bool isOneWay = step.motor == BenchMotor::Aux && step.action != BenchAction::Wait
            && step.action != BenchAction::Hold && step.action != BenchAction::Repeat;
        const int lowest = step.action == BenchAction::Sine
            ? step.speed - std::abs(step.amplitude)
            : std::min(step.speed, step.from.value_or(0));
        if (isOneWay && lowest < 0) {
            return wrong(where, Bench::tr("the auxiliary motor has no reverse"));
        }
        const int highest =
            std::abs(step.speed) + (step.action == BenchAction::Sine ? step.amplitude : 0);
        if (highest > kFullSpeed) {
            return wrong(where, Bench::tr("it asks for more than full speed (127)"));
        }
        if (step.action != BenchAction::Repeat) {
            continue;
        }
        if (step.steps.empty()) {
            return wrong(where, Bench::tr("there is nothing to repeat"));
        }
        if (depth >= BenchProfile::kDeepestRepeat) {
            return wrong(where, Bench::tr("repetitions stand in each other at most three deep"));
        }
        if (plannedSeconds(step) <= 0.0) {
            return wrong(where, Bench::tr("what is repeated takes no time; add a hold"));
        }
        if (auto inner = checkSteps(step.steps, where + u'.', depth + 1); !inner) {
            return inner;
        }
    }
    return {};
}

int highestSpeed(const std::vector<BenchStep>& steps, MotorId motor)
{
    int highest = 0;
    for (const BenchStep& step : steps) {
        switch (step.action) {
        case BenchAction::Set:
        case BenchAction::Accelerate:
        case BenchAction::Ramp:
        case BenchAction::Step:
        case BenchAction::Sine:
            if (drives(step.motor, motor)) {
                highest = std::max({highest, std::abs(step.speed) + step.amplitude,
                                    std::abs(step.from.value_or(0))});
            }
            break;
        case BenchAction::Repeat:
            highest = std::max(highest, highestSpeed(step.steps, motor));
            break;
        case BenchAction::Hold:
        case BenchAction::Brake:
        case BenchAction::Wait:
            break;
        }
    }
    return highest;
}

} // namespace

QLatin1StringView keyOf(BenchMotor motor)
{
    return QLatin1StringView(kMotors.at(std::size_t(motor)));
}

QLatin1StringView keyOf(BenchAction action)
{
    return QLatin1StringView(kActions.at(std::size_t(action)));
}

QLatin1StringView keyOf(BenchCondition condition)
{
    return QLatin1StringView(kConditions.at(std::size_t(condition)));
}

QLatin1StringView keyOf(BenchAnalysis analysis)
{
    return QLatin1StringView(kAnalyses.at(std::size_t(analysis)));
}

QLatin1StringView statusBitKey(int bit)
{
    return bit < 0 || std::size_t(bit) >= kBits.size()
        ? QLatin1StringView()
        : QLatin1StringView(kBits.at(std::size_t(bit)));
}

bool drives(BenchMotor which, MotorId motor)
{
    switch (which) {
    case BenchMotor::Motor1:
        return motor == MotorId::Motor1;
    case BenchMotor::Motor2:
        return motor == MotorId::Motor2;
    case BenchMotor::Both:
        return motor != MotorId::Aux;
    case BenchMotor::Aux:
        return motor == MotorId::Aux;
    }
    return false;
}

double plannedSeconds(const BenchStep& step)
{
    switch (step.action) {
    case BenchAction::Set:
    case BenchAction::Accelerate:
    case BenchAction::Brake:
        return 0.0;
    case BenchAction::Ramp:
    case BenchAction::Step:
    case BenchAction::Sine:
    case BenchAction::Hold:
    case BenchAction::Wait:
        return step.seconds;
    case BenchAction::Repeat:
        break;
    }
    return step.times
        * std::accumulate(step.steps.begin(), step.steps.end(), 0.0,
                          [](double sum, const BenchStep& s) { return sum + plannedSeconds(s); });
}

double plannedSeconds(const BenchProfile& profile)
{
    return std::accumulate(
        profile.steps.begin(), profile.steps.end(), 0.0,
        [](double sum, const BenchStep& step) { return sum + plannedSeconds(step); });
}

int highestSpeed(const BenchProfile& profile, MotorId motor)
{
    return highestSpeed(profile.steps, motor);
}

Result<void> validate(const BenchProfile& profile)
{
    if (profile.steps.empty()) {
        return fail(ErrorCode::OutOfRange, Bench::tr("the profile has no steps"));
    }
    if (auto checked = checkSteps(profile.steps, {}, 0); !checked) {
        return checked;
    }
    if (plannedSeconds(profile) > BenchProfile::kLongestSeconds) {
        return fail(ErrorCode::OutOfRange,
                    Bench::tr("the profile takes longer than a day, which is the most"));
    }
    return {};
}

Result<BenchProfile> loadBenchProfile(const QString& path)
{
    QFile file(path);
    // A resource is a file of ours; anything else that is no ordinary file might never end.
    const bool isOrdinary = path.startsWith(u':') || QFileInfo(path).isFile();
    if (!isOrdinary || !file.open(QIODevice::ReadOnly)) {
        const QString why = isOrdinary ? file.errorString()
            : QFileInfo::exists(path)  ? Bench::tr("it is no ordinary file")
                                       : Bench::tr("there is no such file");
        return fail(ErrorCode::FileUnreadable, u"%1: %2"_s.arg(path, why));
    }
    return parseBenchProfile(file.read(kLargestProfileBytes + 1), path);
}

Result<void> saveBenchProfile(const BenchProfile& profile, const QString& path)
{
    SaveFile file(path);
    const QByteArray json = writeBenchProfile(profile);
    if (!file.open(QIODevice::WriteOnly) || file.write(json) != json.size() || !file.commit()) {
        return fail(ErrorCode::FileUnwritable, u"%1: %2"_s.arg(path, file.errorString()));
    }
    return {};
}

} // namespace trex
