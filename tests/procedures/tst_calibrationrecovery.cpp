// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/procedures/calibrationbench.h"

#include <QElapsedTimer>
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

class TestCalibrationRecovery : public QObject {
    Q_OBJECT

private slots:
    void undo_putsTheFormerValuesBack();
    void lostLineWhileWriting_isReadBackOnReconnect_data();
    void lostLineWhileWriting_isReadBackOnReconnect();
    void resetWhileWriting_isReadBack();
    void lostLineWhileUndoing_isReadBack();
    void anotherInputSet_isNotReadBackAsThisOne();
    void sleep_endsIt();
    void gapInTheSamples_endsIt();
    void interruptWhileWriting_stopsBehindTheChannel();
    void motorPower_isAskedAgainAfterALoss();
};

void TestCalibrationRecovery::undo_putsTheFormerValuesBack()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QSignalSpy noted(&bench.calibration, &ChannelCalibration::noted);
    QVERIFY(!bench.calibration.canUndo());
    bench.calibration.setChannels(0b01010);
    QVERIFY(bench.learnAll());
    QVERIFY(!bench.calibration.canUndo());
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    QCOMPARE(bench.stored(4)->neutral, 3700);
    QVERIFY(bench.calibration.canUndo());
    bench.calibration.undo();
    QVERIFY(!bench.calibration.canUndo());
    QVERIFY(!bench.calibration.canContinue());
    QTRY_COMPARE(noted.size(), 1);
    QCOMPARE(bench.calibration.writeState(2), WriteState::Restored);
    QCOMPARE(bench.calibration.writeState(1), WriteState::Untouched);
    QVERIFY(bench.isUntouched());
    QVERIFY(bench.calibration.outcomeText().contains(u"2 and 4"_s));
    QVERIFY(!bench.calibration.canUndo());
    QVERIFY(bench.calibration.canContinue());
}

void TestCalibrationRecovery::lostLineWhileWriting_isReadBackOnReconnect_data()
{
    QTest::addColumn<int>("item");
    for (int item = 1; item <= CalibrationWriter::kDirections; ++item) {
        QTest::newRow(qPrintable(QString::number(item))) << item;
    }
}

void TestCalibrationRecovery::lostLineWhileWriting_isReadBackOnReconnect()
{
    QFETCH(int, item);
    const QTemporaryDir folder;
    const QString port = u"sim:?state="_s + folder.filePath(u"eeprom.json"_s);
    Bench bench;
    QVERIFY(bench.connectTo(port));
    QVERIFY(bench.goToDirection(kAllChannelsMask));
    bench.feed(3700, 1s);
    bench.feedOne(1, 2700, 1s);
    bench.calibration.next();
    bench.calibration.next();
    QCOMPARE(bench.calibration.step(), Step::Review);
    bench.whenWriting(item, [&bench] { bench.controller.close(); });
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Stopped));
    QCOMPARE(bench.calibration.writeState(item), WriteState::Failed);
    QVERIFY(!bench.calibration.canContinue());
    QVERIFY(!bench.calibration.canUndo()); // not there
    QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);

    QSignalSpy noted(&bench.calibration, &ChannelCalibration::noted);
    QVERIFY(bench.connectTo(port));
    QTRY_COMPARE(noted.size(), 1);
    const QString text = bench.calibration.outcomeText();
    QVERIFY2(text.startsWith(u"The connection to the controller was lost. Read back: "_s)
                 || item == CalibrationWriter::kDirections || item == 1,
             qPrintable(text));
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        const auto stored = bench.stored(channel);
        const WriteState state = bench.calibration.writeState(channel);
        if (channel < item) {
            QCOMPARE(state, WriteState::HoldsNew);
            QCOMPARE(stored, bench.calibration.planned(channel));
        } else if (channel > item) {
            QCOMPARE(state, WriteState::Untouched);
            QCOMPARE(stored, kDefaultRc);
        } else { // either, and named as what it is
            QVERIFY(state == WriteState::HoldsNew || state == WriteState::HoldsOld);
            QCOMPARE(stored,
                     state == WriteState::HoldsNew ? bench.calibration.planned(channel)
                                                   : std::optional(kDefaultRc));
        }
    }
    if (item >= 3 && item <= kChannelCount) {
        QVERIFY2(text.contains(u" hold the new values"_s), qPrintable(text));
        const bool isOld = bench.calibration.writeState(item) == WriteState::HoldsOld;
        QCOMPARE(text.contains(u"channel %1 still the old ones"_s.arg(item)), isOld);
    }
    if (bench.calibration.canUndo()) {
        bench.calibration.undo();
        QTRY_COMPARE(noted.size(), 2);
    }
    QVERIFY(bench.isUntouched());
    QCOMPARE(bench.parameter(kReversed), 0);
    QVERIFY(bench.calibration.canContinue());
}

void TestCalibrationRecovery::resetWhileWriting_isReadBack()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.learnAll());
    QSignalSpy noted(&bench.calibration, &ChannelCalibration::noted);
    bench.whenWriting(3, [&bench] { bench.controller.powerCycleSimulator(); });
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Stopped));
    QTRY_COMPARE(noted.size(), 1);
    const QString text = bench.calibration.outcomeText();
    QVERIFY2(text.contains(u"1 and 2"_s) || text.contains(u"1, 2 and 3"_s), qPrintable(text));
    QCOMPARE(bench.calibration.writeState(1), WriteState::HoldsNew);
    QCOMPARE(bench.calibration.writeState(4), WriteState::Untouched);
    bench.calibration.undo();
    QTRY_COMPARE(noted.size(), 2);
    QVERIFY(bench.isUntouched());
}

void TestCalibrationRecovery::lostLineWhileUndoing_isReadBack()
{
    const QTemporaryDir folder;
    const QString port = u"sim:?state="_s + folder.filePath(u"eeprom.json"_s);
    Bench bench;
    QVERIFY(bench.connectTo(port));
    QVERIFY(bench.learnAll());
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Done));
    bench.calibration.undo();
    QTRY_COMPARE(bench.calibration.writeState(2), WriteState::Writing);
    bench.controller.close();
    QVERIFY(bench.waitFor(Step::Stopped));
    QVERIFY(bench.calibration.outcomeText().contains(u"while the former values were put back"_s));
    QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
    QSignalSpy noted(&bench.calibration, &ChannelCalibration::noted);
    QVERIFY(bench.connectTo(port));
    QTRY_COMPARE(noted.size(), 1);
    QCOMPARE(bench.calibration.writeState(1), WriteState::HoldsOld);
    QCOMPARE(bench.calibration.writeState(5), WriteState::HoldsNew);
    bench.calibration.undo();
    QTRY_COMPARE(noted.size(), 2);
    QVERIFY(bench.isUntouched());
}

void TestCalibrationRecovery::anotherInputSet_isNotReadBackAsThisOne()
{
    const QTemporaryDir folder;
    const QString state = folder.filePath(u"eeprom.json"_s);
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?state="_s + state));
    QVERIFY(bench.learnAll());
    bench.whenWriting(3, [&bench] { bench.controller.close(); });
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Stopped));
    QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
    QSignalSpy noted(&bench.calibration, &ChannelCalibration::noted);
    QVERIFY(bench.connectTo(u"sim:?mode=analog&state="_s + state));
    QVERIFY(bench.stored(1).has_value()); // replies come
    QCOMPARE(noted.size(), 0);
    QCOMPARE(bench.calibration.writeState(3), WriteState::Failed);
    QVERIFY(!bench.calibration.canUndo());
}

void TestCalibrationRecovery::sleep_endsIt()
{
    Bench bench;
    qint64 wall = 1'000'000;
    QElapsedTimer since;
    since.start();
    bench.calibration.watch().setWallClock([&] { return wall + since.elapsed(); });
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    QTest::qWait(600);
    bench.feed(3700, 100ms);
    QCOMPARE(bench.calibration.step(), Step::Neutral);
    wall += 60'000; // the steady clock stood still meanwhile
    QVERIFY(bench.waitFor(Step::Stopped));
    QVERIFY(bench.calibration.outcomeText().contains(u"asleep"_s));
    QVERIFY(bench.calibration.outcomeText().contains(u"Nothing was changed"_s));
    QVERIFY(bench.isUntouched());
}

void TestCalibrationRecovery::gapInTheSamples_endsIt()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    bench.calibration.next();
    QVERIFY(bench.waitFor(Step::Neutral));
    bench.feedNeutral();
    bench.now += 4s; // a slow line may do that
    bench.feed(3700, 100ms);
    QCOMPARE(bench.calibration.step(), Step::Neutral);
    bench.now += 6s;
    bench.feed(3700, 100ms);
    QCOMPARE(bench.calibration.step(), Step::Stopped);
    QVERIFY(bench.calibration.outcomeText().contains(u"No reading came for 6 s"_s));
}

void TestCalibrationRecovery::interruptWhileWriting_stopsBehindTheChannel()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.learnAll());
    bench.calibration.next();
    bench.calibration.interrupt(u"The calibration's panel was closed."_s);
    QVERIFY(bench.waitFor(Step::Stopped));
    QCOMPARE(bench.calibration.writeState(1), WriteState::Written);
    QCOMPARE(bench.stored(2), kDefaultRc);
    QVERIFY(bench.calibration.outcomeText().startsWith(u"The calibration's panel was closed."_s));
    QVERIFY(bench.calibration.canUndo());
}

void TestCalibrationRecovery::motorPower_isAskedAgainAfterALoss()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?mode=analog"_s));
    bench.calibration.setMotorPowerOff(true);
    QVERIFY(bench.calibration.canContinue());
    bench.controller.close();
    QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
    QVERIFY(bench.connectTo(u"sim:?mode=analog"_s));
    QVERIFY(!bench.calibration.isMotorPowerOff());
    QVERIFY(!bench.calibration.canContinue());
}

QTEST_GUILESS_MAIN(TestCalibrationRecovery)
#include "tst_calibrationrecovery.moc"
