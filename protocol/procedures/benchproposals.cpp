// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from the results for the parameters. Every proposal says on what it rests.
#include "protocol/procedures/benchresults.h"
#include "protocol/storage/benchtext.h"
#include "protocol/storage/configadapt.h"

#include <cmath>

using namespace Qt::Literals::StringLiterals;

namespace trex::bench {
namespace {

constexpr double kHeadroom = 1.5; // of a current limit, over what the motor needs
constexpr double kStartingShare = 2.0; // times the running current, where no limit is given
constexpr double kTenthSeconds = 0.1; // an acceleration's unit: speed steps in 100 ms

std::optional<double> valueOf(const BenchOutcome& outcome, MotorId motor, const char* key)
{
    const BenchResult* result = find(outcome, keyOf(motor) + u'.' + QLatin1StringView(key));
    return result != nullptr ? result->value : std::nullopt;
}

std::uint8_t numberOf(const ParameterRow& ofMotor1, MotorId motor)
{
    return std::uint8_t(ofMotor1.number + (motor == MotorId::Motor2 ? 1 : 0));
}

QString amperes(double value)
{
    return QString::number(value, 'f', 2);
}

/// The fastest acceleration to full speed whose starting current stays under the limit: while the
/// speed is raised evenly over a time T, the current is above the running one by
/// stall × constant / T × (1 − e^(−T / constant)).
void proposeAcceleration(BenchOutcome& outcome, MotorId motor)
{
    const auto inrush = valueOf(outcome, motor, "inrush-current");
    const auto steady = valueOf(outcome, motor, "steady-current");
    const auto constant = valueOf(outcome, motor, "time-constant");
    if (!inrush || !steady || !constant) {
        return;
    }
    const int highest = highestSpeed(outcome.profile, motor);
    const double stall = *inrush * kFullSpeed / std::max(highest, 1);
    const double limit = outcome.profile.limits.amperes.value_or(kStartingShare * *steady);
    if (stall <= limit || limit <= *steady) {
        return; // it needs no help, or cannot be helped
    }
    const double tau = *constant / 1000.0;
    for (int raw = kFullSpeed; raw >= 1; --raw) {
        const double time = kFullSpeed * kTenthSeconds / raw;
        const double peak = *steady + stall * tau / time * (1.0 - std::exp(-time / tau));
        if (peak <= limit || raw == 1) {
            outcome.proposals.push_back(
                {numberOf(parameterRow("motor1-acceleration"), motor), raw,
                 Bench::tr(
                     "A start at once draws about %1 A; with this acceleration (full speed in "
                     "%2 s) about %3 A, for accelerate commands and the channels.")
                     .arg(amperes(stall), QString::number(time, 'f', 1), amperes(peak))});
            return;
        }
    }
}

void proposeCurrentLimit(BenchOutcome& outcome, MotorId motor)
{
    const auto full = valueOf(outcome, motor, "full-current");
    if (!full || *full <= 0.0) {
        return;
    }
    const std::uint8_t number = numberOf(parameterRow("motor1-current-limit"), motor);
    const ParameterRow& row = *findParameter(number);
    const double step = physicalFromRaw(row, 1, outcome.trace.model);
    const int raw = std::clamp(int(std::ceil(kHeadroom * *full / step)), 1, row.maximum);
    outcome.proposals.push_back(
        {number, raw,
         Bench::tr("The motor needs %1 A at full speed under the load of this test; half as much "
                   "again is allowed. A heavier load needs a higher limit.")
             .arg(amperes(*full))});
}

void proposeDeadbandBrake(BenchOutcome& outcome, MotorId motor)
{
    const double wanted = outcome.profile.stopWithinSeconds * 1000.0;
    const auto coast = valueOf(outcome, motor, "coast-time");
    const auto brake = valueOf(outcome, motor, "brake-time");
    if (!brake) {
        return;
    }
    int raw = kFullSpeed;
    if (coast && *coast <= wanted) {
        raw = 0;
    } else if (*brake < wanted) {
        // Rates add: what slows it down anyway, and the brake in parts of its duty.
        const double without = coast ? 1.0 / *coast : 0.0;
        const double part = (1.0 / wanted - without) / (1.0 / *brake - without);
        raw = std::clamp(int(std::ceil(part * kFullSpeed)), 0, kFullSpeed);
    }
    const QString coasting = coast ? Bench::tr("coasting takes %1 ms").arg(*coast, 0, 'f', 0)
                                   : Bench::tr("coasting takes longer than was tried");
    outcome.proposals.push_back(
        {numberOf(parameterRow("motor1-deadband-brake"), motor), raw,
         Bench::tr("To a tenth of its speed within %1 ms: %2, full braking %3 ms.")
             .arg(QString::number(wanted, 'f', 0), coasting, QString::number(*brake, 'f', 0))});
}

} // namespace

void propose(BenchOutcome& outcome)
{
    for (const MotorId motor : kMeasured) {
        switch (outcome.profile.analysis) {
        case BenchAnalysis::StepResponse:
            proposeAcceleration(outcome, motor);
            break;
        case BenchAnalysis::CurrentSpeed:
            proposeCurrentLimit(outcome, motor);
            break;
        case BenchAnalysis::Braking:
            proposeDeadbandBrake(outcome, motor);
            break;
        case BenchAnalysis::General:
        case BenchAnalysis::SlowRamp:
        case BenchAnalysis::LeftRight:
        case BenchAnalysis::Endurance:
            break;
        }
    }
}

} // namespace trex::bench
