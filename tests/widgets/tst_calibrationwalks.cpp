// SPDX-License-Identifier: GPL-3.0-or-later
// The whole wizard, with its real widgets, over simulated sticks of all kinds.
#include "protocol/sim/eeprom.h"
#include "tests/support/fasttime.h"
#include "tests/widgets/calibrationpanelbench.h"
#include "widgets/calibration/calibrationhistory.h"
#include "widgets/calibration/responsecurveview.h"
#include "widgets/common/theme.h"

#include <QElapsedTimer>
#include <QScrollArea>
#include <QScrollBar>
#include <QTreeWidget>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using namespace trex::test;

namespace {

using Bench = CalibrationPanelBench;

constexpr double kSpeed = 6.0; // as fast as a hand
constexpr std::uint8_t kFirstTwo = 0b00011;
const QByteArray kStick = R"("stick":{"neutralSeconds":2.8,"sweepSeconds":4.2})";
const QByteArray kOthersRest = R"({"channel":3,"wave":"hold"},{"channel":4,"wave":"hold"},)"
                               R"({"channel":5,"wave":"hold"})";
/// From then on a stick of such a scenario does something else than rest and sweep.
constexpr qint64 kLaterMs = 26'000;

QByteArray scenarioOf(const QByteArray& rows)
{
    return "{" + kStick + ",\"channels\":[" + rows + "]}";
}

} // namespace

class TestCalibrationWalks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void stick_isLearnedOrDeclined_data();
    void stick_isLearnedOrDeclined();
    void singleChannel_leavesAllOtherBytes();
    void eightBitController_getsTheNearestAndSaysSo(); // C-35
    void everyPage_getsItsWorkDone();
    void reversedChannel_isReversedByItsOwnBit();
    void swappedChannels_areTold();
    void resetWhileWriting_isNamedAndUndone();
    void lostWhileWriting_isNamedOnReconnect();
    void closedPanel_endsIt();
    void history_restoresWithOneClick();
    void history_needsSerialMode();
    void curve_showsBeforeAndAfter();
};

void TestCalibrationWalks::initTestCase()
{
    const bool isDark = qEnvironmentVariable("TREX_TEST_THEME") == "dark"_L1;
    theme::apply(isDark ? theme::Choice::Dark : theme::Choice::Light);
}

void TestCalibrationWalks::stick_isLearnedOrDeclined_data()
{
    QTest::addColumn<QByteArray>("rows");
    QTest::addColumn<QString>("state"); // of channel 2 at the review
    QTest::addColumn<QString>("detail");
    QTest::newRow("clean") << QByteArray() << u"good"_s << u"symmetry"_s;
    QTest::newRow("noisy") << QByteArray(R"({"channel":2,"wave":"stick","jitter":20})")
                           << u"usable"_s << u"noisy"_s;
    QTest::newRow("missing pulses") << QByteArray(R"({"channel":2,"wave":"stick","missing":0.55})")
                                    << u"usable"_s << u"pulses were missing"_s;
}

void TestCalibrationWalks::stick_isLearnedOrDeclined()
{
    QFETCH(QByteArray, rows);
    QFETCH(QString, state);
    QFETCH(QString, detail);
    Bench bench;
    QVERIFY(bench.connectTo(bench.scenario(scenarioOf(rows))));
    QVERIFY(bench.waitForNext());
    bench.choose(kFirstTwo);
    QVERIFY(bench.goTo(u"review"_s));
    QTRY_COMPARE(bench.state(2), state);
    QVERIFY2(bench.text(u"2.detail"_s).contains(detail), qPrintable(bench.text(u"2.detail"_s)));
    bench.picture(u"review-"_s + QString::fromLatin1(QTest::currentDataTag()));
    QVERIFY(bench.goTo(u"done"_s));
    QTRY_COMPARE(bench.state(2), u"written"_s);
    QCOMPARE(bench.state(3), u"as before"_s);
}

void TestCalibrationWalks::singleChannel_leavesAllOtherBytes()
{
    Bench bench;
    const QString state = bench.folder.filePath(u"eeprom.json"_s);
    const QString port = bench.scenario("{" + kStick + "}") + u"&state="_s + state;
    const auto contents = [&] {
        bench.controller.close();
        return QTest::qWaitFor(
                   [&bench] { return bench.controller.state() == LinkState::Disconnected; })
            ? sim::loadEeproms(state)->front()
            : sim::Eeprom();
    };
    const auto learn = [&](std::uint8_t channels) {
        if (!bench.connectTo(port) || !bench.waitForNext()) {
            return false;
        }
        bench.choose(channels);
        return bench.goTo(u"done"_s);
    };
    QVERIFY(learn(0b11011)); // so that no channel is as the factory made it
    const sim::Eeprom before = contents();
    bench.clickNext();
    QVERIFY(learn(0b00100));
    const sim::Eeprom after = contents();
    const int own = sim::Eeprom::calibrationAddress(InputKind::Rc, 3);
    for (int address = 0; address < sim::Eeprom::kSize; ++address) {
        if (address < own || address >= own + 8) {
            QCOMPARE(after.at(address), before.at(address));
            QCOMPARE(after.writeCount(address), before.writeCount(address));
        }
    }
    QVERIFY(after.calibration(InputKind::Rc, 3) != before.calibration(InputKind::Rc, 3));
}

void TestCalibrationWalks::eightBitController_getsTheNearestAndSaysSo()
{
    Bench bench;
    QVERIFY(bench.connectTo(bench.scenario("{" + kStick + "}") + u"&quirk=calibration-bytes=8"_s));
    QVERIFY(bench.waitForNext());
    bench.choose(kFirstTwo);
    QVERIFY(bench.goTo(u"done"_s));
    const QString told = bench.text(u"instruction"_s);
    QVERIFY2(told.contains(u"nearest values that this controller can take: 1 and 2"_s),
             qPrintable(told));
    for (const int channel : {1, 2}) {
        QCOMPARE(bench.state(channel), u"nearest"_s);
        const auto held = bench.settings.calibration(InputKind::Rc, channel);
        QVERIFY(held.has_value());
        // What is shown is what was read back; and no motor creeps at the stick's rest.
        QCOMPARE(bench.part<QLabel>(u"%1.neutral"_s.arg(channel))->property("raw").toInt(),
                 held->neutral);
        QCOMPARE((ResponseCurve{*held, false, false}.remap(channel == 1 ? 3762 : 3738)), 0);
    }
    bench.picture(u"done-nearest"_s);
}

void TestCalibrationWalks::everyPage_getsItsWorkDone()
{
    Bench bench;
    QVERIFY(bench.connectTo(bench.scenario("{" + kStick + "}")));
    QVERIFY(bench.waitForNext());
    bench.choose(0b10001);
    const auto isDone = [&bench] { return bench.next()->text() == u"Next"_s; };
    for (const auto& page : {u"returns"_s, u"direction"_s, u"verify"_s}) {
        QVERIFY(bench.goTo(page));
        QCOMPARE(bench.next()->text(), u"Skip"_s);
        bench.picture(page + u"-1"_s);
        QTest::qWait(1500);
        bench.picture(page + u"-2"_s);
        QTRY_VERIFY_WITH_TIMEOUT(isDone(), kLongMs);
        bench.picture(page + u"-done"_s);
        // As narrow as in a window of 1440 pixels, with longer words than ours: nothing is cut, and
        // nothing lies outside.
        bench.panel.resize(738, 420);
        QTRY_COMPARE(bench.panel.findChild<QScrollArea*>()->horizontalScrollBar()->maximum(), 0);
        for (const auto* const mark : bench.panel.findChildren<StateMark*>()) {
            QVERIFY2(mark->width() >= mark->sizeHint().width(), qPrintable(mark->text()));
        }
        bench.picture(page + u"-narrow"_s);
        bench.panel.resize(1000, 460);
    }
    QTRY_COMPARE(bench.state(1), u"confirmed"_s);
    const QString tried = bench.text(u"1.detail"_s);
    QVERIFY2(tried.contains(u"ends −127 / +127"_s), qPrintable(tried));
    bench.clickNext();
    QCOMPARE(bench.page(), u"review"_s);
    QTRY_COMPARE(bench.text(u"notice"_s), QString());
    bench.picture(u"review-complete"_s);
}

void TestCalibrationWalks::reversedChannel_isReversedByItsOwnBit()
{
    // Later it rests half of the time, and is pushed to where its readings fall in the other.
    const QByteArray rows = R"({"channel":1,"wave":"stick","to":25},)"
                            R"({"channel":1,"wave":"square","minimum":2618,"maximum":3762,)"
                            R"("period":6,"from":25},{"channel":2,"wave":"hold"},)"
        + kOthersRest;
    Bench bench;
    QElapsedTimer since;
    since.start();
    QVERIFY(bench.connectTo(bench.scenario(scenarioOf(rows))
                            + u"&param=reversed-channels=12"_s)); // channels 3 and 4
    QVERIFY(bench.waitForNext());
    bench.choose(0b00001);
    QVERIFY(bench.goTo(u"extremes"_s));
    QVERIFY(bench.waitForNext());
    QTRY_VERIFY_WITH_TIMEOUT(since.hasExpired(kLaterMs), kLongMs);
    bench.clickNext();
    QCOMPARE(bench.page(), u"direction"_s);
    auto* reverse = bench.part<QCheckBox>(u"1.reversed"_s);
    QVERIFY(!reverse->isChecked());
    QTRY_COMPARE_WITH_TIMEOUT(bench.state(1), u"runs backwards"_s, kLongMs);
    QVERIFY(reverse->isVisible() && reverse->isChecked());
    bench.picture(u"direction-reversed"_s);
    bench.part<QPushButton>(u"1.again"_s)->click();
    QTRY_VERIFY(bench.state(1) != u"runs backwards"_s);
    QTRY_COMPARE_WITH_TIMEOUT(bench.state(1), u"runs backwards"_s, kLongMs);
    QVERIFY(bench.goTo(u"done"_s));
    QVERIFY(bench.text(u"instruction"_s).contains(u"0x03"_s));
    QCOMPARE(bench.settings.parameter(parameterRow("reversed-channels").number), 0b01101);
    bench.click(u"undo"_s);
    QTRY_VERIFY(bench.text(u"instruction"_s).contains(u"as they were"_s));
    QCOMPARE(bench.settings.parameter(parameterRow("reversed-channels").number), 0b01100);
    bench.picture(u"undone"_s);
}

void TestCalibrationWalks::swappedChannels_areTold()
{
    // Later channel 1 rests for ever, while channel 2 goes on.
    const QByteArray rows = R"({"channel":1,"wave":"stick","to":25},)"
                            R"({"channel":1,"wave":"hold","value":3762,"from":25},)"
                            R"({"channel":2,"wave":"stick"},)"
        + kOthersRest;
    Bench bench;
    QElapsedTimer since;
    since.start();
    QVERIFY(bench.connectTo(bench.scenario(scenarioOf(rows))));
    QVERIFY(bench.waitForNext());
    bench.choose(kFirstTwo);
    QVERIFY(bench.goTo(u"extremes"_s));
    QVERIFY(bench.waitForNext());
    QTRY_VERIFY_WITH_TIMEOUT(since.hasExpired(kLaterMs), kLongMs);
    bench.clickNext();
    QTRY_COMPARE_WITH_TIMEOUT(bench.state(1), u"channel 2 moved"_s, kLongMs);
    QVERIFY(bench.text(u"1.detail"_s).contains(u"1 and 2 are swapped"_s));
    QVERIFY(!bench.part<QCheckBox>(u"1.reversed"_s)->isChecked());
    bench.picture(u"direction-swapped"_s);
    QVERIFY(bench.goTo(u"review"_s));
    QTRY_COMPARE(bench.state(1), u"usable"_s);
    bench.picture(u"review-swapped"_s);
}

void TestCalibrationWalks::resetWhileWriting_isNamedAndUndone()
{
    Bench bench;
    QVERIFY(bench.connectTo(bench.scenario("{" + kStick + "}")));
    QVERIFY(bench.waitForNext());
    QVERIFY(bench.goTo(u"review"_s));
    QVERIFY(bench.waitForNext());
    bench.clickNext();
    QCOMPARE(bench.page(), u"writing"_s);
    QTRY_COMPARE(bench.state(2), u"writing…"_s);
    bench.picture(u"writing"_s);
    bench.controller.powerCycleSimulator();
    QVERIFY(bench.waitForPage(u"stopped"_s));
    QTRY_VERIFY(bench.text(u"instruction"_s).contains(u"Read back: "_s));
    QVERIFY(bench.text(u"instruction"_s).startsWith(u"The controller was switched off and on."_s));
    QTRY_COMPARE(bench.state(1), u"new values"_s);
    QVERIFY(bench.state(2) == u"new values"_s || bench.state(2) == u"old values"_s);
    QCOMPARE(bench.state(5), u"as before"_s);
    QVERIFY(bench.log.toText().contains(u"Read back: "_s));
    bench.picture(u"stopped-reset"_s);
    QTRY_VERIFY(bench.part<QPushButton>(u"undo"_s)->isEnabled());
    bench.click(u"undo"_s);
    QTRY_VERIFY(bench.text(u"instruction"_s).contains(u"former values are back"_s));
    QCOMPARE(bench.settings.calibration(InputKind::Rc, 1), (Calibration{2500, 3750, 5000, 100}));
}

void TestCalibrationWalks::lostWhileWriting_isNamedOnReconnect()
{
    Bench bench;
    const QString port =
        bench.scenario("{" + kStick + "}") + u"&state="_s + bench.folder.filePath(u"eeprom.json"_s);
    QVERIFY(bench.connectTo(port));
    QVERIFY(bench.waitForNext());
    QVERIFY(bench.goTo(u"review"_s));
    QVERIFY(bench.waitForNext());
    bench.clickNext();
    QTRY_COMPARE(bench.state(3), u"writing…"_s);
    bench.controller.close();
    QVERIFY(bench.waitForPage(u"stopped"_s));
    int lost = 3; // or a later one, when the answer was quicker than the end of the line
    while (lost < 5 && bench.state(lost) == u"written"_s) {
        ++lost;
    }
    QTRY_COMPARE(bench.state(lost), u"failed"_s);
    QTRY_VERIFY2(bench.text(u"reason"_s).contains(u"read back"_s), // once the line is closed, too
                 qPrintable(bench.text(u"reason"_s)));
    QCOMPARE(bench.text(u"%1.minimum"_s.arg(lost)), u"–"_s); // nobody knows
    bench.picture(u"stopped-lost"_s);
    QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
    QVERIFY(bench.connectTo(port));
    QTRY_VERIFY(bench.text(u"instruction"_s).contains(u"hold the new values"_s));
    QTRY_VERIFY(bench.state(lost) == u"new values"_s || bench.state(lost) == u"old values"_s);
    bench.picture(u"stopped-reconnected"_s);
}

void TestCalibrationWalks::closedPanel_endsIt()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.goTo(u"neutral"_s));
    bench.panel.hide();
    QCOMPARE(bench.page(), u"stopped"_s);
    bench.panel.show();
    QTRY_VERIFY(bench.text(u"instruction"_s).contains(u"panel was closed"_s));
    QVERIFY(bench.text(u"instruction"_s).contains(u"Nothing was changed"_s));
}

void TestCalibrationWalks::history_restoresWithOneClick()
{
    Bench bench;
    QVERIFY(bench.connectTo(bench.scenario("{" + kStick + "}")));
    QVERIFY(bench.waitForNext());
    bench.choose(0b00010);
    QVERIFY(bench.goTo(u"done"_s));
    const auto written = bench.settings.calibration(InputKind::Rc, 2);
    bench.click(u"history"_s);
    auto* dialog = bench.part<CalibrationHistory>(u"historyDialog"_s);
    QVERIFY(dialog != nullptr && dialog->isVisible());
    auto* list = bench.part<QTreeWidget>(u"history.list"_s);
    QCOMPARE(list->topLevelItemCount(), 1);
    QCOMPARE(list->topLevelItem(0)->text(1), u"2"_s);
    QVERIFY(list->topLevelItem(0)->text(2).startsWith(u"1.000 ms / 1.500 ms / 2.000 ms"_s));
    if (!qEnvironmentVariableIsEmpty("TREX_TEST_PICTURES")) {
        QTest::qWait(100);
        dialog->grab().save(
            QDir(qEnvironmentVariable("TREX_TEST_PICTURES")).filePath(u"history.png"_s));
    }
    bench.click(u"history.restoreBefore"_s);
    QTRY_VERIFY(bench.text(u"history.text"_s).startsWith(u"Channel 2 holds 1.000 ms"_s));
    QVERIFY(bench.text(u"history.text"_s).endsWith(u"again, read back."_s));
    QCOMPARE(bench.settings.calibration(InputKind::Rc, 2), (Calibration{2500, 3750, 5000, 100}));
    QTRY_COMPARE(list->topLevelItemCount(), 2); // itself in the journal
    list->setCurrentItem(list->topLevelItem(1));
    bench.click(u"history.restore"_s);
    QTRY_COMPARE(bench.settings.calibration(InputKind::Rc, 2), written);
    QVERIFY(bench.log.toText().contains(u"again, read back"_s));
}

void TestCalibrationWalks::history_needsSerialMode()
{
    Bench bench;
    const QString state = u"state="_s + bench.folder.filePath(u"eeprom.json"_s);
    QVERIFY(bench.connectTo(bench.scenario("{" + kStick + "}") + u'&' + state));
    QVERIFY(bench.waitForNext());
    bench.choose(0b00001);
    QVERIFY(bench.goTo(u"done"_s));
    bench.click(u"history"_s);
    QVERIFY(bench.part<QPushButton>(u"history.restore"_s)->isEnabled());
    bench.controller.close();
    QTRY_VERIFY(!bench.part<QPushButton>(u"history.restore"_s)->isEnabled());
    QVERIFY(bench.text(u"history.text"_s).contains(u"Connect"_s));
}

void TestCalibrationWalks::curve_showsBeforeAndAfter()
{
    Bench bench;
    auto* curve = bench.part<ResponseCurveView>(u"curve"_s);
    auto* shown = bench.part<QPushButton>(u"curveShown"_s);
    bench.panel.resize(1400, 520);
    QVERIFY(curve->isVisible());
    bench.panel.resize(500, 260);
    QTRY_VERIFY(!curve->isVisible()); // no room
    QVERIFY(!shown->isChecked());
    shown->click();
    QVERIFY(curve->isVisible());
    shown->click();
    QVERIFY(!curve->isVisible());
    shown->click();
    bench.panel.resize(1400, 520);
    QVERIFY(bench.connectTo(bench.scenario("{" + kStick + "}") + u"&param=parabolic-channels=1"_s));
    QVERIFY(bench.waitForNext());
    bench.choose(0b00001);
    QVERIFY(bench.goTo(u"neutral"_s));
    QTRY_VERIFY2(curve->text().contains(u"≈"_s), qPrintable(curve->text()));
    QVERIFY(!curve->text().contains(u"new"_s));
    QVERIFY(bench.goTo(u"verify"_s));
    QTRY_VERIFY2(curve->text().contains(u" before, "_s) && curve->text().endsWith(u" new"_s),
                 qPrintable(curve->text()));
    QCOMPARE(curve->accessibleName(), u"Response of channel 1"_s);
    QCOMPARE(curve->accessibleDescription(), curve->text());
    bench.picture(u"curve-parabolic"_s);
}

int main(int argc, char** argv)
{
    makeTimeFaster(kSpeed);
    QApplication app(argc, argv);
    TestCalibrationWalks test;
    QTEST_SET_MAIN_SOURCE_PATH
    return QTest::qExec(&test, argc, argv);
}

#include "tst_calibrationwalks.moc"
