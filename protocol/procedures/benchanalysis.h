// SPDX-License-Identifier: GPL-3.0-or-later
// What a bench test has shown: named results with units, uncertainties and verdicts, and what
// follows for the parameters. The methods are described in benchanalysis.md. Pure.
#pragma once

#include "protocol/procedures/benchrun.h"
#include "protocol/storage/configfile.h"

namespace trex {

enum class BenchVerdict : std::uint8_t {
    NotJudged, ///< the profile expects nothing of it
    Passed,
    Failed,
    NotMeasured ///< something is expected, but it could not be found out
};

struct BenchResult {
    QString key; ///< "motor1.steady-current": in files, expectations and JSON
    QString title; ///< for people
    std::optional<double> value; ///< in `unit`; none: it could not be found out, `note` says why
    double uncertainty = 0.0; ///< about two standard deviations, in `unit`
    QString unit;
    int decimals = 2;
    BenchExpectation expected;
    BenchVerdict verdict = BenchVerdict::NotJudged;
    QString note; ///< what it rests on
};

/// A value of a parameter that follows from the results. A proposal, never written by itself.
struct BenchProposal {
    std::uint8_t parameter = 0; ///< number
    int raw = 0;
    QString reason;
};

/// One more thing to draw than speeds and currents over time: current over speed and the like.
struct BenchCurve {
    struct Point {
        double x = 0.0;
        double y = 0.0;
    };
    QString title;
    QString group; ///< curves of one group share a plot, whose title this is
    QString xTitle;
    QString yTitle;
    MotorId motor = MotorId::Motor1;
    std::vector<Point> points;
};

struct BenchOutcome {
    BenchProfile profile;
    BenchEnding ending;
    BenchTrace trace;
    bool isDryRun = false;
    std::vector<BenchResult> results;
    std::vector<BenchProposal> proposals;
    std::vector<BenchCurve> curves;

    /// Done to its end, and nothing that was expected has failed or is missing.
    [[nodiscard]] bool hasPassed() const;
    /// Passed, Failed, or NotJudged: done, but nothing was expected.
    [[nodiscard]] BenchVerdict verdict() const;
    [[nodiscard]] QString verdictText() const; ///< one sentence
};

/// `run` has ended.
[[nodiscard]] BenchOutcome evaluate(const BenchRun& run, bool isDryRun);

/// Anew, after the profile's expectations have changed.
void judge(BenchOutcome& outcome);

/// The proposals as a configuration with their reasons as comments: a file that the parameters
/// panel loads and `trexctl config diff` reads.
[[nodiscard]] Configuration configurationOf(const std::vector<BenchProposal>& proposals,
                                            const QString& profileName);

[[nodiscard]] QLatin1StringView keyOf(BenchVerdict verdict); ///< "passed" …
[[nodiscard]] QLatin1StringView keyOf(BenchEnd end); ///< "completed", "limit" …
[[nodiscard]] QString textOf(BenchVerdict verdict); ///< for people
/// "0.25 ± 0.01 A", "–".
[[nodiscard]] QString valueText(const BenchResult& result);
/// "0.2 to 0.4", "at most 0.4", "".
[[nodiscard]] QString expectedText(const BenchResult& result);

} // namespace trex
