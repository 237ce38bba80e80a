// SPDX-License-Identifier: GPL-3.0-or-later
// Every ready bench test on the simulated motor: its results against the constants of that motor
// (sim/motormodel.h), which the estimators do not know. Virtual time.
#include "protocol/procedures/benchanalysis.h"
#include "protocol/procedures/benchdryrun.h"
#include "protocol/sim/motormodel.h"
#include "protocol/sim/simulatedline.h"
#include "protocol/storage/configadapt.h"
#include "protocol/storage/readyprofiles.h"

#include <QDir>
#include <QTest>

#include <cmath>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr sim::MotorConstants kMotor;

/// What the equations of the motor say, in closed form.
namespace truth {
constexpr double kDamping = kMotor.voltSeconds * kMotor.voltSeconds / kMotor.ohms + kMotor.viscous;
constexpr double kTimeConstant = kMotor.inertia / kDamping; // s
double friction(double load)
{
    return kMotor.coulomb + load * kMotor.fullLoad;
}
double speed(int command, double load = 0.0) ///< rad/s, settled
{
    const double torque = kMotor.voltSeconds * kMotor.volts * command / 127.0 / kMotor.ohms;
    return (torque - friction(load)) / kDamping;
}
double current(int command, double load = 0.0) ///< A, settled
{
    return (friction(load) + kMotor.viscous * speed(command, load)) / kMotor.voltSeconds;
}
double inrush(int command)
{
    return kMotor.volts * command / 127.0 / kMotor.ohms;
}
double breakaway(double load = 0.0)
{
    return friction(load) / kMotor.voltSeconds;
}
double deadZone(double load = 0.0) ///< commands at which the shaft stands still
{
    return breakaway(load) * kMotor.ohms / kMotor.volts * 127.0;
}
/// Part of the speed that is left after `seconds` of full braking or of coasting.
double speedLeft(int command, double seconds, bool isBraking)
{
    const double damping = isBraking ? kDamping : kMotor.viscous;
    const double end = friction(0.0) / damping; // what it would go to if friction could turn it
    const double start = speed(command);
    const double left = (start + end) * std::exp(-seconds * damping / kMotor.inertia) - end;
    return std::max(left, 0.0) / start;
}
} // namespace truth

BenchOutcome play(const BenchProfile& profile, const BenchDryRunOptions& options = {})
{
    BenchDryRun dry(profile, options);
    while (dry.advance(10s)) { }
    return evaluate(dry.run(), true);
}

BenchProfile ready(const char* key)
{
    auto profile = readyProfile(key);
    if (!profile) {
        qFatal("%s", qPrintable(profile.error().context));
    }
    return *profile;
}

const BenchResult* resultOf(const BenchOutcome& outcome, const QString& key)
{
    const auto found = std::ranges::find(outcome.results, key, &BenchResult::key);
    return found == outcome.results.end() ? nullptr : &*found;
}

const BenchProposal* proposalOf(const BenchOutcome& outcome, std::uint8_t number)
{
    const auto found = std::ranges::find(outcome.proposals, number, &BenchProposal::parameter);
    return found == outcome.proposals.end() ? nullptr : &*found;
}

} // namespace

/// The value is within `tolerance` of the truth, and the truth within the uncertainty that is
/// stated (and a little: two standard deviations are not certainty).
#define COMPARE_RESULT(outcome, key, truth, tolerance)                                             \
    do {                                                                                           \
        const BenchResult* result = resultOf(outcome, key);                                        \
        QVERIFY2(result != nullptr && result->value, qPrintable(QString(key)));                    \
        const double error = *result->value - (truth);                                             \
        const QString said =                                                                       \
            u"%1: %2, truth %3"_s.arg(QString(key), valueText(*result)).arg(truth);                \
        QVERIFY2(std::abs(error) <= (tolerance), qPrintable(said));                                \
        QVERIFY2(std::abs(error) <= 1.5 * result->uncertainty, qPrintable(said));                  \
    } while (false)

class TestReadyProfiles : public QObject {
    Q_OBJECT

private slots:
    void everyFile_hasItsRow();
    void stepResponse_findsTheTimeConstant();
    void slowRamp_findsTheDeadZone();
    void slowRamp_ofAHeldMotor_saysSo();
    void currentSpeed_findsFrictionAndSlope();
    void leftRight_findsTheHeavierSide();
    void braking_findsTheSpeedsLeft();
    void endurance_findsNoDriftAndTheCharge();
    void expectations_areJudged();
    void interruptedTest_hasNotPassed();
    void proposals_makeAConfiguration();
    void noVolts_noOhms();
};

void TestReadyProfiles::everyFile_hasItsRow()
{
    QStringList keys;
    for (const ReadyProfileRow& row : readyProfiles()) {
        const auto profile = readyProfile(row.key);
        QVERIFY2(profile, profile ? "" : qPrintable(profile.error().context));
        // What the table says for translation is what the file says.
        const QString key = QString::fromLatin1(row.key.data(), qsizetype(row.key.size()));
        const auto asFile = loadBenchProfile(u":/profiles/%1.json"_s.arg(key));
        QCOMPARE(asFile->name, QString::fromUtf8(row.title));
        QCOMPARE(asFile->description, QString::fromUtf8(row.description));
        QVERIFY(profile->limits.amperes); // none runs without one
        keys << key + u".json"_s;
    }
    keys.sort();
    QCOMPARE(QDir(u":/profiles"_s).entryList(QDir::Files, QDir::Name), keys);
}

void TestReadyProfiles::stepResponse_findsTheTimeConstant()
{
    BenchProfile profile = ready("step-response");
    profile.supplyVolts = kMotor.volts;
    profile.limits.amperes = 2.0; // as the person would set it for the proposal …
    profile.limits.forSeconds = 1.0; // … without it ending the test
    const BenchOutcome outcome = play(profile);
    QVERIFY(outcome.hasPassed());
    for (const char* motor : {"motor1", "motor2"}) {
        const QString m = QLatin1StringView(motor);
        COMPARE_RESULT(outcome, m + u".steady-current"_s, truth::current(80), 0.015);
        COMPARE_RESULT(outcome, m + u".inrush-current"_s, truth::inrush(80), 0.35);
        COMPARE_RESULT(outcome, m + u".time-constant"_s, truth::kTimeConstant * 1000.0, 5.0);
        COMPARE_RESULT(outcome, m + u".winding-resistance"_s, kMotor.ohms, 0.22);
        QVERIFY(*resultOf(outcome, m + u".peak-current"_s)->value < truth::inrush(80));
    }
    // The proposal, tried: with it an accelerated start stays under the limit.
    const std::uint8_t number = parameterRow("motor1-acceleration").number;
    const BenchProposal* proposal = proposalOf(outcome, number);
    QVERIFY(proposal != nullptr && proposal->raw > 1 && proposal->raw < 127);
    BenchProfile trial = profile;
    trial.analysis = BenchAnalysis::General;
    trial.limits.amperes = 6.0;
    trial.steps = {BenchStep{.action = BenchAction::Accelerate, .speed = 127},
                   BenchStep{.action = BenchAction::Hold, .seconds = 4.0}};
    BenchDryRunOptions options;
    options.parameters[number] = proposal->raw;
    const BenchOutcome gentle = play(trial, options);
    QVERIFY(*resultOf(gentle, u"motor1.peak-current"_s)->value <= 2.0 + 0.08);
    QVERIFY(*resultOf(gentle, u"motor1.peak-current"_s)->value >= 1.0); // and not over-cautious
    QVERIFY(*resultOf(gentle, u"motor2.peak-current"_s)->value > 3.0); // which had none
}

void TestReadyProfiles::slowRamp_findsTheDeadZone()
{
    BenchProfile profile = ready("slow-ramp");
    profile.supplyVolts = kMotor.volts;
    BenchDryRunOptions options;
    options.load[1] = 0.1; // motor 2 has it harder
    const BenchOutcome outcome = play(profile, options);
    QCOMPARE(outcome.ending.end, BenchEnd::Completed);
    for (const auto& [motor, load] : {std::pair{u"motor1"_s, 0.0}, {u"motor2"_s, 0.1}}) {
        for (const QString& direction : {u".forward"_s, u".reverse"_s}) {
            COMPARE_RESULT(outcome, motor + direction + u".dead-zone"_s, truth::deadZone(load),
                           0.6);
            COMPARE_RESULT(outcome, motor + direction + u".breakaway-current"_s,
                           truth::breakaway(load), 0.02);
        }
        COMPARE_RESULT(outcome, motor + u".stall-current"_s, truth::inrush(127), 0.5);
        COMPARE_RESULT(outcome, motor + u".winding-resistance"_s, kMotor.ohms, 0.2);
    }
}

void TestReadyProfiles::slowRamp_ofAHeldMotor_saysSo()
{
    BenchDryRunOptions options;
    options.isHeld[0] = true;
    const BenchOutcome outcome = play(ready("slow-ramp"), options);
    const BenchResult* zone = resultOf(outcome, u"motor1.forward.dead-zone"_s);
    QVERIFY(zone != nullptr && !zone->value && !zone->note.isEmpty());
    QCOMPARE(valueText(*zone), u"–"_s);
    QVERIFY(resultOf(outcome, u"motor2.forward.dead-zone"_s)->value);
}

void TestReadyProfiles::currentSpeed_findsFrictionAndSlope()
{
    const BenchOutcome outcome = play(ready("current-speed"));
    QCOMPARE(outcome.ending.end, BenchEnd::Completed);
    COMPARE_RESULT(outcome, u"motor1.friction-current"_s, truth::current(0), 0.02);
    COMPARE_RESULT(outcome, u"motor1.full-current"_s, truth::current(127), 0.015);
    COMPARE_RESULT(outcome, u"motor1.direction-difference"_s, 0.0, 0.015);
    const std::uint8_t number = parameterRow("motor1-current-limit").number;
    const BenchProposal* proposal = proposalOf(outcome, number);
    QVERIFY(proposal != nullptr);
    const double limit = physicalFromRaw(*findParameter(number), proposal->raw, Model::TrexJr);
    QVERIFY2(limit >= 1.45 * truth::current(127) && limit < 1.5 * truth::current(127) + 0.09,
             qPrintable(QString::number(limit)));
    QCOMPARE(outcome.curves.size(), std::size_t(2));
    QCOMPARE(outcome.curves[0].points.size(), std::size_t(10));
}

void TestReadyProfiles::leftRight_findsTheHeavierSide()
{
    const BenchOutcome even = play(ready("left-right"));
    QVERIFY(even.hasPassed());
    COMPARE_RESULT(even, u"left-right.difference"_s, 0.0, 0.01);
    COMPARE_RESULT(even, u"left-right.ratio"_s, 100.0, 4.0);
    BenchDryRunOptions options;
    options.load[1] = 0.15;
    const BenchOutcome uneven = play(ready("left-right"), options);
    const double mean =
        (truth::current(40) + truth::current(80) + truth::current(120) - truth::current(40, 0.15)
         - truth::current(80, 0.15) - truth::current(120, 0.15))
        / 3.0;
    COMPARE_RESULT(uneven, u"left-right.difference"_s, mean, 0.015);
    QVERIFY(!uneven.hasPassed());
    QCOMPARE(resultOf(uneven, u"left-right.difference"_s)->verdict, BenchVerdict::Failed);
}

void TestReadyProfiles::braking_findsTheSpeedsLeft()
{
    const BenchOutcome outcome = play(ready("braking"));
    QVERIFY2(outcome.ending.end == BenchEnd::Completed, qPrintable(outcome.ending.reason));
    COMPARE_RESULT(outcome, u"motor1.time-constant"_s, truth::kTimeConstant * 1000.0, 5.0);
    for (const int ms : {50, 100, 200}) {
        COMPARE_RESULT(outcome, u"motor1.brake-%1ms.speed-left"_s.arg(ms),
                       100.0 * truth::speedLeft(100, ms / 1000.0, true), 6.0);
    }
    for (const int ms : {200, 800}) {
        COMPARE_RESULT(outcome, u"motor1.coast-%1ms.speed-left"_s.arg(ms),
                       100.0 * truth::speedLeft(100, ms / 1000.0, false), 6.0);
    }
    double tenth = 0.0;
    while (truth::speedLeft(100, tenth, true) > 0.1) {
        tenth += 0.001;
    }
    COMPARE_RESULT(outcome, u"motor1.brake-time"_s, 1000.0 * tenth, 30.0);
    QVERIFY(!resultOf(outcome, u"motor1.coast-time"_s)->value); // longer than was tried
    // It coasts for seconds and brakes in less than the 0.4 s that are wanted: something between.
    const BenchProposal* proposal =
        proposalOf(outcome, parameterRow("motor1-deadband-brake").number);
    QVERIFY(proposal != nullptr);
    QVERIFY2(proposal->raw > 20 && proposal->raw < 100, qPrintable(QString::number(proposal->raw)));
}

void TestReadyProfiles::endurance_findsNoDriftAndTheCharge()
{
    const BenchOutcome outcome = play(ready("endurance"));
    QVERIFY(outcome.hasPassed());
    COMPARE_RESULT(outcome, u"motor1.drift"_s, 0.0, 0.01);
    COMPARE_RESULT(outcome, u"motor1.runs"_s, 40.0, 0.0);
    // 40 runs of 20 s, and the starts beside them.
    const double starts = 40 * kMotor.inertia * truth::speed(70) / kMotor.voltSeconds;
    const double charge = 40 * 20.0 * truth::current(70) + starts;
    COMPARE_RESULT(outcome, u"motor1.charge"_s, charge / 3.6, 2.0);
    QVERIFY(std::abs(*resultOf(outcome, u"line.readings"_s)->value - 80.0) < 8.0);
    COMPARE_RESULT(outcome, u"line.errors"_s, 0.0, 0.0);
}

void TestReadyProfiles::expectations_areJudged()
{
    BenchProfile profile = ready("current-speed");
    profile.expect[u"motor1.full-current"_s] = {.minimum = 0.2, .maximum = 0.3};
    profile.expect[u"motor2.full-current"_s] = {.minimum = 0.3, .maximum = {}};
    const BenchOutcome outcome = play(profile);
    QCOMPARE(resultOf(outcome, u"motor1.full-current"_s)->verdict, BenchVerdict::Passed);
    QCOMPARE(resultOf(outcome, u"motor2.full-current"_s)->verdict, BenchVerdict::Failed);
    QCOMPARE(resultOf(outcome, u"motor1.friction-current"_s)->verdict, BenchVerdict::NotJudged);
    QVERIFY(!outcome.hasPassed());
    QVERIFY(outcome.verdictText().contains(u"1 of 2"_s));
    profile.expect = {{u"motor1.full-curent"_s, {.minimum = 0.2, .maximum = {}}}};
    const BenchOutcome mistyped = play(profile);
    QVERIFY(!mistyped.hasPassed());
    QCOMPARE(resultOf(mistyped, u"motor1.full-curent"_s)->verdict, BenchVerdict::NotMeasured);
}

void TestReadyProfiles::interruptedTest_hasNotPassed()
{
    BenchProfile profile = ready("endurance");
    profile.limits.seconds = 100.0;
    const BenchOutcome outcome = play(profile);
    QCOMPARE(outcome.ending.end, BenchEnd::Limit);
    QVERIFY(!outcome.hasPassed());
    QVERIFY(outcome.proposals.empty());
    QVERIFY(resultOf(outcome, u"motor1.mean-current"_s)->value); // what was measured stays
}

void TestReadyProfiles::proposals_makeAConfiguration()
{
    const BenchOutcome outcome = play(ready("braking"));
    QCOMPARE(outcome.proposals.size(), std::size_t(2));
    const Configuration configuration = configurationOf(outcome.proposals, u"A \"test\"\n<b>"_s);
    const QByteArray json = writeConfiguration(configuration);
    const auto read = parseConfiguration(json, u"proposals.json"_s);
    QVERIFY2(read, read ? "" : qPrintable(read.error().context));
    QVERIFY(read->parameters == configuration.parameters);
    QCOMPARE(read->parameters.size(), std::size_t(2));
    QVERIFY2(json.contains("full braking"), json); // the reason is in the file
    QCOMPARE(remarkOn(*read), QString());
}

void TestReadyProfiles::noVolts_noOhms()
{
    const BenchOutcome outcome = play(ready("step-response"));
    const BenchResult* ohms = resultOf(outcome, u"motor1.winding-resistance"_s);
    QVERIFY(ohms != nullptr && !ohms->value && ohms->note.contains(u"supplyVolts"_s));
}

QTEST_GUILESS_MAIN(TestReadyProfiles)
#include "tst_readyprofiles.moc"
