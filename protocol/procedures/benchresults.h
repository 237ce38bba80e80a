// SPDX-License-Identifier: GPL-3.0-or-later
// The estimators, one for each kind of analysis: each fills the outcome from its trace.
#pragma once

#include "protocol/procedures/benchanalysis.h"
#include "protocol/procedures/benchstatistics.h"

namespace trex::bench {

void evaluateGeneral(BenchOutcome& outcome);
void evaluateStepResponse(BenchOutcome& outcome);
void evaluateSlowRamp(BenchOutcome& outcome);
void evaluateCurrentSpeed(BenchOutcome& outcome);
void evaluateLeftRight(BenchOutcome& outcome);
void evaluateBraking(BenchOutcome& outcome);
void evaluateEndurance(BenchOutcome& outcome);
/// What follows from the results for the parameters.
void propose(BenchOutcome& outcome);

inline constexpr std::array kMeasured{MotorId::Motor1, MotorId::Motor2};
[[nodiscard]] QString keyOf(MotorId motor); ///< "motor1"
[[nodiscard]] QString titleOf(MotorId motor); ///< "Motor 1"

struct Measure {
    const char* key; ///< behind the motor's
    QString title; ///< behind the motor's
    QString unit;
    int decimals = 2;
};
void add(BenchOutcome& outcome, const QString& prefix, const QString& prefixTitle,
         const Measure& measure, const std::optional<Estimate>& estimate, const QString& note);
void add(BenchOutcome& outcome, MotorId motor, const Measure& measure,
         const std::optional<Estimate>& estimate, const QString& note = {});
[[nodiscard]] const BenchResult* find(const BenchOutcome& outcome, const QString& key);

/// A reading's value is older than its read: the mean of the converter's last period (half of it on
/// average), kept up to a period more until it is asked for, and a reply's time on the line. And an
/// order takes a while to act. So much later than the order does a reading begin to show it, on
/// average, give or take kDelayDoubt.
inline constexpr double kDelay = 0.015; // s
inline constexpr double kDelayDoubt = 0.008; // s
/// What a reading shows from here on lies wholly behind the order.
inline constexpr double kClean = 0.035; // s

} // namespace trex::bench
