// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/calibrationfeed.h"
#include "protocol/procedures/calibrationtext.h"
#include "protocol/procedures/channelcalibration.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"

#include "tests/procedures/calibrationbench.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;
using namespace trex;
using namespace trex::test;

namespace {

using Step = ChannelCalibration::Step;
using WriteState = ChannelCalibration::WriteState;
using Bench = CalibrationBench;

// Where the simulator's sticks have their ends and neutrals.
constexpr std::array<Calibration, kChannelCount> kRcSticks{{{2618, 3762, 4894, 0},
                                                            {2586, 3738, 4871, 0},
                                                            {2640, 3755, 4915, 0},
                                                            {2552, 3744, 4938, 0},
                                                            {2604, 3750, 4902, 0}}};
constexpr Calibration kAnalogStick2{44, 507, 978, 0};

/// Ends within 1 % of the travel, neutral within two units.
bool isNear(const Calibration& learned, const Calibration& truth)
{
    const double tolerance = 0.01 * (truth.maximum - truth.minimum);
    return std::abs(learned.minimum - truth.minimum) <= tolerance
        && std::abs(learned.maximum - truth.maximum) <= tolerance
        && std::abs(learned.neutral - truth.neutral) <= 2;
}

QString scenarioFile(const QTemporaryDir& folder, const QByteArray& json)
{
    QFile file(folder.filePath(u"scenario.json"_s));
    if (file.open(QIODevice::WriteOnly)) {
        file.write(json);
    }
    return file.fileName();
}

} // namespace

class TestChannelCalibration : public QObject {
    Q_OBJECT

private slots:
    void steps_leadToVerifiedValues(); // C-32, C-35
    void next_waitsForThePagesWork();
    void movement_restartsTheCountdownAndSaysWho();
    void singleChannel_leavesTheOthersAlone();
    void cancel_changesNothing_data();
    void cancel_changesNothing();
    void back_learnsAgain();
    void declinedChannel_isNotWritten();
    void otherModes_cannotWrite();
    void start_disarms();
    void arming_endsIt();
    void lostLine_endsWithASentence();
    void lostLineWhileWriting_namesWhatWasWritten();
    void cancelWhileWriting_stopsBehindTheChannel();
    void restartedController_endsIt();
    void sameValues_areNotWrittenAgain();
    void eightBitController_getsTheNearestValues(); // C-35
    void unconnected_saysSo();
    void silence_isTold();
    void simulatedStick_isLearnedThroughTheStore();
    void simulatedStick_isLearnedByAsking();
};

void TestChannelCalibration::steps_leadToVerifiedValues()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QSignalSpy finished(&bench.calibration, &Procedure::finished);
    QCOMPARE(bench.calibration.stepKey(), "choose"_L1);
    QVERIFY(bench.learnAll());
    QCOMPARE(bench.calibration.channels(), kAllChannelsMask);
    const Calibration learned = bench.calibration.learned(2)->calibration;
    QVERIFY(std::abs(learned.minimum - 2600) <= 12 && learned.minimum >= 2600);
    QVERIFY(std::abs(learned.maximum - 4900) <= 12 && learned.maximum <= 4900);
    QCOMPARE(learned.neutral, 3700);
    QCOMPARE(bench.calibration.before(2), kDefaultRc);
    QVERIFY(bench.isUntouched()); // nothing before the review is left
    QCOMPARE(finished.size(), 0);

    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Writing);
    QVERIFY(bench.waitFor(Step::Done));
    QCOMPARE(finished.size(), 1);
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        QCOMPARE(bench.calibration.writeState(channel), WriteState::Written);
        QCOMPARE(bench.stored(channel), learned);
        QCOMPARE(bench.calibration.readBack(channel), learned);
    }
    QVERIFY(bench.calibration.outcomeText().contains(u"1, 2, 3, 4 and 5"_s));
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Choose);
}

void TestChannelCalibration::next_waitsForThePagesWork()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.setChannels(0);
    QVERIFY(!bench.calibration.canContinue());
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Choose);
    bench.calibration.setChannels(0b00001);
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    bench.feed(3750, 1s);
    QVERIFY(!bench.calibration.canContinue());
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Neutral);
    bench.feed(3750, 1100ms);
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Extremes);
    bench.feed(5000, 1s);
    QVERIFY(bench.calibration.whyNot().contains(u"both ends: 1"_s));
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Extremes);
    bench.feed(2500, 1s);
    QVERIFY(!bench.calibration.canContinue()); // may go further yet
    bench.feed(2500, 1s);
    QVERIFY(bench.calibration.canContinue());
}

void TestChannelCalibration::movement_restartsTheCountdownAndSaysWho()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    bench.feed(3750, 1900ms);
    const auto before = bench.calibration.learner()->neutralRemaining();
    QVERIFY(before < 300ms);
    bench.feedAll({3750, 3950, 3750, 3750, 3750}, 300ms);
    QVERIFY(bench.calibration.learner()->neutralRemaining() > 1500ms);
    QCOMPARE(bench.calibration.learner()->channel(2).movedBy(), 200);
    QCOMPARE(bench.calibration.learner()->channel(1).restarts(), 0);
    bench.feedAll({3750, 3950, int(kInvalidPulse), 3750, 3750}, 3s);
    QVERIFY(!bench.calibration.canContinue());
    QVERIFY(bench.calibration.whyNot().contains(u"Channel 3"_s));
}

void TestChannelCalibration::singleChannel_leavesTheOthersAlone()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.setChannels(0b00100);
    QVERIFY(bench.learnAll());
    QCOMPARE(bench.calibration.learned(1), nullptr);
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    for (const int channel : {1, 2, 4, 5}) {
        QCOMPARE(bench.stored(channel), kDefaultRc);
        QCOMPARE(bench.calibration.writeState(channel), WriteState::Untouched);
    }
    QCOMPARE(bench.stored(3)->neutral, 3700);
}

void TestChannelCalibration::cancel_changesNothing_data()
{
    QTest::addColumn<int>("step");
    QTest::newRow("preparing") << int(Step::Choose);
    QTest::newRow("neutral") << int(Step::Neutral);
    QTest::newRow("extremes") << int(Step::Extremes);
    QTest::newRow("review") << int(Step::Review);
}

void TestChannelCalibration::cancel_changesNothing()
{
    QFETCH(int, step);
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QSignalSpy finished(&bench.calibration, &Procedure::finished);
    bench.calibration.setChannels(0b00011);
    bench.calibration.next();
    if (step > int(Step::Choose)) {
        QVERIFY(bench.waitFor(Step::Neutral));
        bench.feedNeutral();
    }
    if (step > int(Step::Neutral)) {
        bench.calibration.next();
        bench.feedSweep();
    }
    if (step > int(Step::Extremes)) {
        bench.calibration.next();
    }
    QCOMPARE(int(bench.calibration.step()), step);
    std::vector<Step> told; // at each call to look again: nothing half put back is to be seen
    const auto look = connect(&bench.calibration, &ChannelCalibration::updated, this, [&] {
        told.push_back(bench.calibration.step());
        static_cast<void>(bench.calibration.whyNot());
    });
    bench.calibration.cancel();
    disconnect(look);
    QVERIFY(!told.empty());
    QVERIFY(std::all_of(told.begin(), told.end(), [](Step at) { return at == Step::Choose; }));
    QCOMPARE(bench.calibration.step(), Step::Choose);
    QCOMPARE(bench.calibration.channels(), std::uint8_t(0b00011));
    QCOMPARE(finished.size(), 1);
    const auto result = finished.front().front().value<Result<void>>();
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::Cancelled);
    QVERIFY(bench.isUntouched());
    QCOMPARE(bench.calibration.step(), Step::Choose); // late answers start nothing
    bench.calibration.cancel(); // again: nothing
    QCOMPARE(finished.size(), 1);
}

void TestChannelCalibration::back_learnsAgain()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.learnAll());
    bench.calibration.back();
    QCOMPARE(bench.calibration.step(), Step::Extremes);
    QVERIFY(!bench.calibration.canContinue());
    bench.feed(2800, 1s);
    bench.feed(4500, 1s);
    bench.feed(3700, 2s);
    bench.calibration.next();
    QVERIFY(std::abs(bench.calibration.learned(1)->calibration.maximum - 4500) <= 12);
    bench.calibration.back();
    bench.calibration.back();
    QCOMPARE(bench.calibration.step(), Step::Neutral);
    QVERIFY(!bench.calibration.canContinue());
    bench.calibration.back();
    QCOMPARE(bench.calibration.step(), Step::Choose);
}

void TestChannelCalibration::declinedChannel_isNotWritten()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.setChannels(0b00011);
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    bench.feedNeutral();
    bench.calibration.next();
    bench.feedAll({2600, 3700, 3700, 3700, 3700}, 1s);
    bench.feedAll({4900, 4900, 3700, 3700, 3700}, 1s);
    bench.feed(3700, 2s);
    QVERIFY(!bench.calibration.canContinue());
    bench.calibration.finishExtremes();
    QCOMPARE(bench.calibration.learned(2)->verdict, Verdict::DoAgain);
    QCOMPARE(bench.calibration.learned(2)->findings.front(), Finding::OneDirection);
    QCOMPARE(bench.calibration.channels(), std::uint8_t(0b00001));
    bench.calibration.setChannels(0b00011); // cannot be forced
    QCOMPARE(bench.calibration.channels(), std::uint8_t(0b00001));
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    QCOMPARE(bench.stored(1)->neutral, 3700);
    QCOMPARE(bench.stored(2), kDefaultRc);
    bench.calibration.next();
    QCOMPARE(bench.calibration.channels(), std::uint8_t(0b00011)); // the choice of before
}

void TestChannelCalibration::otherModes_cannotWrite()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?mode=rc"_s));
    QVERIFY(!bench.calibration.canWrite());
    QVERIFY(bench.calibration.doSticksDrive());
    bench.calibration.next(); // not before the person says that nothing can move
    QVERIFY(!bench.calibration.isRunning());
    QVERIFY(bench.calibration.whyNot().contains(u"motor power is off"_s));
    bench.calibration.setMotorPowerOff(true);
    QVERIFY(bench.learnAll());
    QVERIFY(!bench.calibration.canContinue());
    QVERIFY(bench.calibration.whyNot().contains(u"serial mode"_s));
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Review);
    QVERIFY(bench.isUntouched());
}

void TestChannelCalibration::start_disarms()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.controller.arm());
    QVERIFY(bench.controller.driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 40}));
    bench.calibration.next();
    QVERIFY(!bench.controller.isArmed());
    QVERIFY(bench.waitFor(Step::Neutral));
    QCOMPARE(bench.controller.lastOrder(MotorId::Motor1).amount, 0);
}

void TestChannelCalibration::arming_endsIt()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    QVERIFY(bench.controller.arm());
    QCOMPARE(bench.calibration.step(), Step::Stopped);
    QVERIFY(bench.calibration.outcomeText().contains(u"Nothing was changed"_s));
    QVERIFY(!bench.calibration.isCollecting());
    QVERIFY(bench.isUntouched());
}

void TestChannelCalibration::lostLine_endsWithASentence()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?fault=silent-after=1.5"_s));
    QSignalSpy finished(&bench.calibration, &Procedure::finished);
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    QVERIFY(bench.waitFor(Step::Stopped, 8000));
    QVERIFY(
        bench.calibration.outcomeText().startsWith(u"The connection to the controller was lost"_s));
    QVERIFY(bench.calibration.outcomeText().endsWith(u"Nothing was changed in the controller."_s));
    QCOMPARE(finished.size(), 1);
    QCOMPARE(finished.front().front().value<Result<void>>().error().code, ErrorCode::LineLost);
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Choose);
}

void TestChannelCalibration::lostLineWhileWriting_namesWhatWasWritten()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.learnAll());
    connect(&bench.calibration, &Procedure::progressed, &bench.controller,
            [&bench](int channel, int, const QString&) {
                if (channel == 3) {
                    QMetaObject::invokeMethod(
                        &bench.controller, [&bench] { bench.controller.close(); },
                        Qt::QueuedConnection);
                }
            });
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Stopped));
    QCOMPARE(bench.calibration.writeState(2), WriteState::Written);
    QCOMPARE(bench.calibration.writeState(3), WriteState::Failed);
    QCOMPARE(bench.calibration.writeState(4), WriteState::Untouched);
    const QString text = bench.calibration.outcomeText();
    QVERIFY2(text.contains(u"written and read back: 1 and 2."_s), qPrintable(text));
    QVERIFY2(text.contains(u"Channel 3 may hold its old or its new values"_s), qPrintable(text));
    QVERIFY2(text.contains(u"All other channels are as before."_s), qPrintable(text));
}

void TestChannelCalibration::cancelWhileWriting_stopsBehindTheChannel()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.learnAll());
    bench.calibration.next();
    bench.calibration.cancel();
    QVERIFY(bench.waitFor(Step::Stopped));
    QCOMPARE(bench.calibration.writeState(1), WriteState::Written);
    QCOMPARE(bench.stored(1)->neutral, 3700);
    QCOMPARE(bench.stored(2), kDefaultRc);
    QVERIFY(bench.calibration.outcomeText().contains(u"written and read back: 1."_s));
}

void TestChannelCalibration::restartedController_endsIt()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    bench.controller.powerCycleSimulator();
    QVERIFY(bench.waitFor(Step::Stopped));
    QVERIFY(bench.calibration.outcomeText().contains(u"switched off"_s));
}

void TestChannelCalibration::sameValues_areNotWrittenAgain()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.setChannels(0b00001);
    QVERIFY(bench.learnAll());
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    bench.calibration.next();
    QVERIFY(bench.learnAll()); // the same movements
    QSignalSpy records(&bench.controller, &Controller::recordsArrived);
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Done);
    QCOMPARE(bench.calibration.writeState(1), WriteState::Unchanged);
    QVERIFY(bench.calibration.outcomeText().contains(u"so already"_s)
            || bench.calibration.outcomeText().contains(u"nothing was written"_s));
}

void TestChannelCalibration::eightBitController_getsTheNearestValues()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?quirk=calibration-bytes=8"_s));
    bench.calibration.setChannels(0b00001);
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    bench.feed(3750, 2200ms); // 0x0EA6: its low byte has bit 7 set and cannot be sent
    bench.calibration.next();
    bench.feedSweep();
    bench.calibration.next();
    const Calibration wanted = bench.calibration.learned(1)->calibration;
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    QCOMPARE(bench.calibration.writeState(1), WriteState::NearestWritten);
    const auto stored = bench.stored(1);
    QCOMPARE(stored, bench.calibration.readBack(1));
    QVERIFY(stored != wanted);
    QVERIFY(std::abs(stored->minimum - wanted.minimum) <= 64);
    QVERIFY(bench.calibration.outcomeText().contains(u"nearest"_s));
}

void TestChannelCalibration::unconnected_saysSo()
{
    Bench bench;
    QVERIFY(!bench.calibration.canContinue());
    bench.calibration.next();
    QVERIFY(!bench.calibration.isRunning());
    QVERIFY(!bench.calibration.whyNot().isEmpty());
}

void TestChannelCalibration::silence_isTold()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    QVERIFY(!bench.calibration.isStarved());
    QTRY_VERIFY(bench.calibration.isStarved()); // nobody feeds it
    QVERIFY(bench.calibration.whyNot().contains(u"No fresh readings"_s));
    bench.feed(3750, 100ms);
    QVERIFY(!bench.calibration.isStarved());
}

void TestChannelCalibration::simulatedStick_isLearnedThroughTheStore()
{
    const QTemporaryDir folder;
    const auto file = scenarioFile(folder, R"({"stick":{"neutralSeconds":2,"sweepSeconds":4}})");
    Bench bench;
    StoreFeed feed(bench.controller, bench.store, bench.calibration);
    bench.calibration.setStillTime(1s);
    QVERIFY(bench.connectTo(u"sim:?scenario="_s + file));
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    QTRY_VERIFY_WITH_TIMEOUT(bench.calibration.canContinue(), 20000);
    bench.calibration.next();
    QTRY_VERIFY_WITH_TIMEOUT(bench.calibration.canContinue(), 30000);
    bench.calibration.next();
    QCOMPARE(bench.calibration.channels(), kAllChannelsMask);
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        const auto& learned = *bench.calibration.learned(channel);
        const QString what = u"channel %1: %2 %3 %4, %5"_s.arg(channel)
                                 .arg(learned.calibration.minimum)
                                 .arg(learned.calibration.neutral)
                                 .arg(learned.calibration.maximum)
                                 .arg(reasonText(learned, InputKind::Rc));
        QVERIFY2(learned.verdict != Verdict::DoAgain, qPrintable(what));
        QVERIFY2(learned.samples > 150, qPrintable(QString::number(learned.samples)));
        const Calibration& truth = kRcSticks.at(static_cast<std::size_t>(channel - 1));
        QVERIFY2(isNear(learned.calibration, truth), qPrintable(what));
    }
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    QCOMPARE(bench.stored(4), std::optional(bench.calibration.learned(4)->calibration));
    QTRY_COMPARE(bench.controller.device().learnedMask, kAllChannelsMask); // C-33
}

void TestChannelCalibration::simulatedStick_isLearnedByAsking()
{
    const QTemporaryDir folder;
    const auto file = scenarioFile(folder, R"({"stick":{"neutralSeconds":2,"sweepSeconds":4}})");
    Controller controller(nullptr, nullptr); // as the command line has it
    DeviceSettings settings(controller);
    ChannelCalibration calibration(controller, settings);
    RequestFeed feed(controller, calibration);
    calibration.setOptionalSteps(false);
    calibration.setStillTime(1s);
    calibration.setChannels(0b00010);
    controller.open({.port = u"sim:?param=channel-input-source=1&scenario="_s + file, .line = {}});
    QTRY_COMPARE(controller.state(), LinkState::Connected);
    calibration.start();
    QTRY_COMPARE(calibration.step(), Step::Neutral);
    QTRY_VERIFY_WITH_TIMEOUT(calibration.canContinue(), 20000);
    calibration.next();
    QTRY_VERIFY_WITH_TIMEOUT(calibration.canContinue(), 30000);
    calibration.next();
    QCOMPARE(calibration.input(), InputKind::Analog);
    QCOMPARE(calibration.channels(), std::uint8_t(0b00010));
    QVERIFY(isNear(calibration.learned(2)->calibration, kAnalogStick2));
    calibration.next();
    QTRY_COMPARE(calibration.step(), Step::Done);
}

QTEST_GUILESS_MAIN(TestChannelCalibration)
#include "tst_channelcalibration.moc"
