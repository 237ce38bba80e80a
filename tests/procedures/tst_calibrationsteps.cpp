// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/sim/eeprom.h"
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

} // namespace

class TestCalibrationSteps : public QObject {
    Q_OBJECT

private slots:
    void singleChannel_leavesTheOthersBytesInTheEeprom();
    void optionalSteps_canBeSkipped();
    void returns_areCounted();
    void direction_offersToReverseThatChannelOnly();
    void direction_saysWhichChannelMovedInstead();
    void verify_comparesNewWithOld();
    void eightBitController_isToldAtTheNextReview(); // C-35
    void nearestForEightBit_coversTheTrueNeutral_data(); // C-35
    void nearestForEightBit_coversTheTrueNeutral();
};

void TestCalibrationSteps::singleChannel_leavesTheOthersBytesInTheEeprom()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(u"eeprom.json"_s);
    const QString port = u"sim:?state="_s + file;
    const auto contents = [&file] { return sim::loadEeproms(file)->front(); };
    {
        Bench bench;
        QVERIFY(bench.connectTo(port));
        bench.calibration.setChannels(0b10111); // so that no channel is as the factory made it
        QVERIFY(bench.learnAll());
        bench.calibration.next();
        QVERIFY(bench.waitFor(Step::Done));
        bench.controller.close();
        QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
    }
    const sim::Eeprom before = contents();
    Bench bench;
    QVERIFY(bench.connectTo(port));
    QVERIFY(bench.goToDirection(0b00100));
    bench.feed(3700, 1s);
    bench.feedOne(3, 2700, 1s); // falls: channel 3 is reversed, too
    QCOMPARE(bench.calibration.direction(3)->sign, -1);
    bench.calibration.next();
    bench.calibration.next();
    QVERIFY(bench.calibration.isReversed(3));
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    bench.controller.close();
    QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
    const sim::Eeprom after = contents();
    const int own = sim::Eeprom::calibrationAddress(InputKind::Rc, 3);
    for (int address = 0; address < sim::Eeprom::kSize; ++address) {
        const bool isOwn = (address >= own && address < own + 8) || address == kReversed.number;
        if (!isOwn) {
            QCOMPARE(after.at(address), before.at(address));
            QCOMPARE(after.writeCount(address), before.writeCount(address));
        }
    }
    QCOMPARE(after.at(kReversed.number), std::uint8_t(0b00100));
    QCOMPARE(after.calibration(InputKind::Rc, 3).neutral, 3700);
}

void TestCalibrationSteps::optionalSteps_canBeSkipped()
{
    Bench bench;
    bench.calibration.setOptionalSteps(true);
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    QVERIFY(!bench.calibration.isOptional());
    bench.feedNeutral();
    bench.calibration.next();
    QStringList pages;
    while (bench.calibration.step() != Step::Review && pages.size() < 10) {
        pages << bench.calibration.stepKey();
        if (bench.calibration.step() == Step::Extremes) {
            QVERIFY(!bench.calibration.canContinue());
            bench.feedSweep();
        } else {
            QVERIFY(bench.calibration.isOptional());
            QVERIFY(!bench.calibration.isStepDone());
        }
        QVERIFY(bench.calibration.canContinue());
        bench.calibration.next();
    }
    QCOMPARE(pages, QStringList({u"returns"_s, u"extremes"_s, u"direction"_s, u"verify"_s}));
    QCOMPARE(bench.calibration.skipped(),
             std::vector<Step>({Step::Returns, Step::Direction, Step::Verify}));
    QCOMPARE(bench.calibration.learned(1)->returns, 0);
    bench.calibration.back();
    QCOMPARE(bench.calibration.step(), Step::Verify);
    bench.calibration.back();
    bench.calibration.back();
    QCOMPARE(bench.calibration.step(), Step::Extremes);
    bench.calibration.back();
    QCOMPARE(bench.calibration.step(), Step::Neutral);
}

void TestCalibrationSteps::returns_areCounted()
{
    Bench bench;
    bench.calibration.setOptionalSteps(true);
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.setChannels(0b00010);
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    bench.feedNeutral();
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Returns);
    for (const int away : {4500, 2900}) {
        QVERIFY(!bench.calibration.isStepDone());
        bench.feedOne(2, away, 500ms);
        bench.feedOne(2, away > 3700 ? 3712 : 3690, 2s);
    }
    QCOMPARE(bench.calibration.learner()->returnsSeen(2), 2);
    QVERIFY(bench.calibration.isStepDone());
    bench.calibration.next();
    bench.feedSweep();
    bench.calibration.next();
    bench.calibration.next();
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Review);
    QVERIFY(std::abs(bench.calibration.learned(2)->repeatability - 22) <= 4);
    QCOMPARE(bench.calibration.skipped(), std::vector<Step>({Step::Direction, Step::Verify}));
}

void TestCalibrationSteps::direction_offersToReverseThatChannelOnly()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=reversed-channels=10"_s)); // channels 2 and 4
    QVERIFY(bench.goToDirection(0b00111));
    QCOMPARE(bench.calibration.directionChannel(), 1);
    QVERIFY(bench.calibration.isReversed(2) && !bench.calibration.isReversed(1));
    bench.feed(3700, 1s);
    bench.feedOne(1, 2700, 1s);
    QCOMPARE(bench.calibration.directionChannel(), 2);
    QVERIFY(bench.calibration.isReversed(1)); // offered
    bench.feed(3700, 1s);
    bench.feedOne(2, 4700, 1s);
    QVERIFY(!bench.calibration.isReversed(2)); // it was, and should not be
    QCOMPARE(bench.calibration.directionChannel(), 3);
    QVERIFY(!bench.calibration.isStepDone());
    bench.feed(3700, 1s);
    bench.feedOne(3, 4700, 1s);
    QVERIFY(bench.calibration.isStepDone());
    bench.calibration.next();
    QCOMPARE(bench.calibration.curveAfter(1)->reversed, true);
    QCOMPARE(bench.calibration.curveBefore(1)->reversed, false);
    bench.calibration.next();
    bench.calibration.setReversed(2, true); // the person knows better
    bench.calibration.setReversed(4, false); // a switch has no direction here
    bench.calibration.setChannels(0b00001);
    QVERIFY(bench.isUntouched());
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    QCOMPARE(bench.parameter(kReversed), 0b01011);
    QVERIFY(bench.calibration.outcomeText().contains(u"0x03"_s));
    QCOMPARE(bench.stored(2), kDefaultRc);
    QVERIFY(bench.calibration.canUndo());
    bench.calibration.undo();
    QTRY_VERIFY(bench.calibration.outcomeText().contains(u"as they were"_s));
    QCOMPARE(bench.parameter(kReversed), 0b01010);
    QVERIFY(bench.isUntouched());
}

void TestCalibrationSteps::direction_saysWhichChannelMovedInstead()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.goToDirection(0b00011));
    bench.feed(3700, 1s);
    bench.feedOne(2, 2700, 1s); // asked for channel 1
    QCOMPARE(bench.calibration.direction(1)->movedChannel, 2);
    QVERIFY(!bench.calibration.isReversed(1) && !bench.calibration.isReversed(2));
    bench.calibration.selectDirection(1); // once more
    QVERIFY(!bench.calibration.direction(1));
    bench.feed(3700, 1s);
    bench.feedOne(2, 2700, 1s);
    bench.calibration.next();
    bench.calibration.next();
    QCOMPARE(bench.calibration.learned(1)->swappedWith, 2);
    QCOMPARE(bench.calibration.learned(1)->findings.front(), Finding::SwappedWith);
}

void TestCalibrationSteps::verify_comparesNewWithOld()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.goToDirection(0b00001));
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Verify);
    bench.feedSweep();
    const ChannelVerifier* verifier = bench.calibration.learner()->verified(1);
    QVERIFY(verifier != nullptr);
    QCOMPARE(verifier->now().lowest, -kFullSpeed);
    QCOMPARE(verifier->now().highest, kFullSpeed);
    QVERIFY(verifier->before().lowest > -kFullSpeed); // 2600 and 4900 within 2500 to 5000
    QVERIFY(verifier->before().highest < kFullSpeed);
    QVERIFY(bench.calibration.isStepDone());
    QVERIFY(bench.isUntouched());
    QCOMPARE(bench.calibration.skipped(), std::vector<Step>({Step::Returns, Step::Direction}));
}

void TestCalibrationSteps::eightBitController_isToldAtTheNextReview()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?quirk=calibration-bytes=8"_s));
    bench.calibration.setChannels(0b00001);
    const auto learn = [&bench] {
        bench.calibration.next();
        if (!bench.waitFor(Step::Neutral)) {
            return false;
        }
        bench.feed(3750, 2200ms);
        bench.calibration.next();
        bench.feedSweep();
        bench.calibration.next();
        return bench.calibration.step() == Step::Review;
    };
    QVERIFY(learn());
    QVERIFY(!bench.calibration.isNearest(1)); // nobody knows yet
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    const Calibration held = *bench.stored(1);
    // What rests at the true neutral is neutral to the controller: no motor creeps.
    QCOMPARE((ResponseCurve{held, false, false}.remap(3750)), 0);
    QVERIFY(held.neutral != 3750);
    bench.calibration.next();

    bench.calibration.setChannels(0b00011);
    QVERIFY(learn());
    QVERIFY(bench.calibration.isNearest(1) && bench.calibration.isNearest(2));
    const auto planned = bench.calibration.planned(2);
    QCOMPARE(bench.calibration.planned(1), held);
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    QCOMPARE(bench.calibration.writeState(1), WriteState::Unchanged);
    QCOMPARE(bench.calibration.writeState(2), WriteState::Written); // verified as planned
    QCOMPARE(bench.stored(2), planned);
}

void TestCalibrationSteps::nearestForEightBit_coversTheTrueNeutral_data()
{
    QTest::addColumn<int>("neutral");
    QTest::addColumn<int>("deadband");
    for (int low = 0; low < 256; low += 15) {
        QTest::addRow("low byte %d", low) << 0x0E00 + low << 40;
    }
    QTest::newRow("wide deadband") << 0x0EBF << 100;
}

void TestCalibrationSteps::nearestForEightBit_coversTheTrueNeutral()
{
    QFETCH(int, neutral);
    QFETCH(int, deadband);
    const Calibration wanted{neutral - 1150, neutral, neutral + 1150, deadband};
    const Calibration nearest = nearestForEightBit(wanted);
    for (const int value : {nearest.minimum, nearest.neutral, nearest.maximum, nearest.deadband}) {
        QVERIFY((value & 0xFF) <= 0x7F); // can be sent
    }
    QVERIFY(std::abs(nearest.minimum - wanted.minimum) <= 65);
    QVERIFY(std::abs(nearest.maximum - wanted.maximum) <= 65);
    QVERIFY(nearest.neutral - nearest.deadband <= neutral - deadband);
    QVERIFY(nearest.neutral + nearest.deadband >= neutral + deadband);
}

QTEST_GUILESS_MAIN(TestCalibrationSteps)
#include "tst_calibrationsteps.moc"
