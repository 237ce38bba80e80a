// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/calibrationpanelbench.h"
#include "widgets/channels/channelbar.h"
#include "widgets/common/theme.h"

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using namespace trex::test;
using Bench = CalibrationPanelBench;

class TestCalibrationPanel : public QObject {
    Q_OBJECT

private slots:
    void names_areThere();
    void unconnected_saysWhatToDo();
    void choice_reachesTheCalibration();
    void otherMode_warnsAboutMovingMotors();
    void walk_writesWhatWasLearned_data();
    void walk_writesWhatWasLearned();
    void cancel_goesBackToChoosing();
    void missingPulse_looksMissing();
    void lostLine_isTold();
};

void TestCalibrationPanel::names_areThere()
{
    const Bench bench;
    for (const auto& name :
         {u"next"_s, u"back"_s, u"cancel"_s, u"undo"_s, u"history"_s, u"curveShown"_s}) {
        QVERIFY2(bench.part<QPushButton>(name) != nullptr, qPrintable(name));
        QVERIFY(!bench.part<QPushButton>(name)->accessibleName().isEmpty());
    }
    QVERIFY(bench.part<QLabel>(u"instruction"_s) != nullptr);
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        for (const auto& name : {u"minimum"_s, u"neutral"_s, u"maximum"_s, u"deadband"_s}) {
            const auto* label = bench.part<QLabel>(u"%1.%2"_s.arg(channel).arg(name));
            QVERIFY(label != nullptr);
            QVERIFY(!label->accessibleName().isEmpty());
        }
        QVERIFY(bench.part<QCheckBox>(u"%1.use"_s.arg(channel))->isChecked());
    }
    QCOMPARE(bench.page(), u"choose"_s);
}

void TestCalibrationPanel::unconnected_saysWhatToDo()
{
    Bench bench;
    QVERIFY(!bench.next()->isEnabled());
    QVERIFY(!bench.part<QPushButton>(u"cancel"_s)->isEnabled());
    QVERIFY(bench.text(u"reason"_s).contains(u"Connect"_s));
    bench.picture(u"unconnected"_s);
}

void TestCalibrationPanel::choice_reachesTheCalibration()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.waitForNext());
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        bench.part<QCheckBox>(u"%1.use"_s.arg(channel))->click();
    }
    QVERIFY(!bench.next()->isEnabled());
    QVERIFY(bench.text(u"reason"_s).contains(u"at least one"_s));
    bench.part<QCheckBox>(u"2.use"_s)->click();
    QVERIFY(bench.next()->isEnabled());
    bench.click(u"next"_s);
    QVERIFY(bench.waitForPage(u"neutral"_s));
    QVERIFY(!bench.part<QCheckBox>(u"1.use"_s)->isEnabled());
    QTRY_COMPARE(bench.part<StateMark>(u"1.state"_s)->text(), u"left as it is"_s);
}

void TestCalibrationPanel::otherMode_warnsAboutMovingMotors()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?mode=rc"_s));
    QTRY_VERIFY(bench.text(u"notice"_s).contains(u"move the motors"_s));
    QVERIFY(bench.text(u"notice"_s).contains(u"serial mode"_s));
    auto* off = bench.part<QCheckBox>(u"motorPowerOff"_s);
    QVERIFY(off->isVisible());
    QVERIFY(!bench.next()->isEnabled());
    QVERIFY(bench.text(u"reason"_s).contains(u"motor power is off"_s));
    bench.picture(u"rcmode"_s);
    off->click();
    QVERIFY(bench.waitForNext());
    bench.clickNext();
    QVERIFY(bench.waitForPage(u"neutral"_s));
    QTRY_VERIFY(!off->isVisible());
    QVERIFY(bench.text(u"notice"_s).contains(u"move the motors"_s)); // still says so
}

void TestCalibrationPanel::walk_writesWhatWasLearned_data()
{
    QTest::addColumn<bool>("isDark");
    QTest::newRow("light") << false;
    if (!qEnvironmentVariableIsEmpty("TREX_TEST_PICTURES")) {
        QTest::newRow("dark") << true;
    }
}

void TestCalibrationPanel::walk_writesWhatWasLearned()
{
    QFETCH(bool, isDark);
    const QString theme = isDark ? u"dark-"_s : u"light-"_s;
    theme::apply(isDark ? theme::Choice::Dark : theme::Choice::Light);
    Bench bench;
    QVERIFY(bench.connectTo(bench.scenario(R"({"stick":{"neutralSeconds":3,"sweepSeconds":4}})")));
    QVERIFY(bench.waitForNext());
    QTRY_VERIFY(bench.part<ChannelBar>(u"1.bar"_s)->isValid());
    bench.picture(theme + u"1-choose"_s);
    bench.click(u"next"_s);
    QVERIFY(bench.waitForPage(u"neutral"_s));
    QTest::qWait(700);
    bench.picture(theme + u"2-neutral"_s);
    QVERIFY(bench.waitForNext());
    bench.picture(theme + u"2-neutral-done"_s);
    bench.click(u"next"_s);
    QCOMPARE(bench.page(), u"returns"_s);
    QVERIFY(bench.next()->isEnabled());
    QCOMPARE(bench.next()->text(), u"Skip"_s);
    bench.click(u"next"_s);
    QCOMPARE(bench.page(), u"extremes"_s);
    QVERIFY(!bench.next()->isEnabled());
    QCOMPARE(bench.next()->text(), u"Next"_s);
    QTRY_VERIFY_WITH_TIMEOUT(bench.text(u"1.detail"_s).contains(u", need "_s), kLongMs);
    QTRY_COMPARE_WITH_TIMEOUT(bench.part<StateMark>(u"1.state"_s)->text(), u"moving"_s, kLongMs);
    QTest::qWait(400);
    bench.picture(theme + u"3-extremes"_s);
    QVERIFY(bench.waitForNext());
    bench.picture(theme + u"3-extremes-done"_s);
    bench.click(u"next"_s);
    QCOMPARE(bench.page(), u"direction"_s);
    bench.click(u"next"_s);
    QCOMPARE(bench.page(), u"verify"_s);
    bench.click(u"next"_s);
    QCOMPARE(bench.page(), u"review"_s);
    QTRY_VERIFY(bench.text(u"notice"_s).contains(u"Skipped"_s));
    QTRY_COMPARE(bench.part<StateMark>(u"1.state"_s)->text(), u"good"_s);
    const int minimum = bench.part<QLabel>(u"1.minimum"_s)->property("raw").toInt();
    QVERIFY2(std::abs(minimum - 2618) <= 22, qPrintable(QString::number(minimum)));
    QVERIFY(bench.text(u"1.minimum"_s).endsWith(u" ms"_s));
    bench.picture(theme + u"4-review"_s);
    bench.part<QCheckBox>(u"5.use"_s)->click();
    bench.click(u"next"_s);
    QVERIFY(bench.waitForPage(u"done"_s));
    bench.picture(theme + u"5-done"_s);
    QVERIFY(bench.part<QPushButton>(u"undo"_s)->isEnabled());
    QCOMPARE(bench.settings.calibration(InputKind::Rc, 1)->minimum, minimum);
    QCOMPARE(bench.settings.calibration(InputKind::Rc, 5)->minimum, 2500); // not chosen
    QTRY_COMPARE(bench.part<StateMark>(u"1.state"_s)->text(), u"written"_s);
    QCOMPARE(bench.text(u"5.minimum"_s), u"1.000 ms"_s); // what it holds, not what was learned
    QVERIFY(bench.text(u"instruction"_s).contains(u"1, 2, 3 and 4"_s));
    QVERIFY(bench.log.toText().contains(u"written and read back"_s));
    bench.click(u"next"_s);
    QCOMPARE(bench.page(), u"choose"_s);
    QVERIFY(bench.part<QCheckBox>(u"5.use"_s)->isChecked());
}

void TestCalibrationPanel::cancel_goesBackToChoosing()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.waitForNext());
    bench.click(u"next"_s);
    QVERIFY(bench.waitForPage(u"neutral"_s));
    bench.click(u"cancel"_s);
    QCOMPARE(bench.page(), u"choose"_s);
    QVERIFY(bench.text(u"instruction"_s).contains(u"nothing was changed"_s));
    QVERIFY(bench.next()->isEnabled());
}

void TestCalibrationPanel::missingPulse_looksMissing()
{
    Bench bench;
    QVERIFY(bench.connectTo(bench.scenario(
        R"({"channels":[{"channel":2,"wave":"missing"},{"channel":1,"wave":"hold"}]})")));
    QVERIFY(bench.waitForNext());
    bench.click(u"next"_s);
    QVERIFY(bench.waitForPage(u"neutral"_s));
    QTRY_COMPARE(bench.part<StateMark>(u"2.state"_s)->text(), u"no pulse"_s);
    QTRY_COMPARE_WITH_TIMEOUT(bench.part<StateMark>(u"1.state"_s)->text(), u"still"_s, kLongMs);
    QVERIFY(!bench.next()->isEnabled());
    QVERIFY(bench.text(u"reason"_s).contains(u"Channel 2"_s));
    bench.picture(u"missing"_s);
}

void TestCalibrationPanel::lostLine_isTold()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.waitForNext());
    bench.click(u"next"_s);
    QVERIFY(bench.waitForPage(u"neutral"_s));
    bench.controller.close();
    QVERIFY(bench.waitForPage(u"stopped"_s));
    QVERIFY(!bench.part<QPushButton>(u"cancel"_s)->isEnabled());
    QVERIFY(bench.text(u"instruction"_s).contains(u"connection to the controller was lost"_s));
    bench.picture(u"stopped"_s);
}

QTEST_MAIN(TestCalibrationPanel)
#include "tst_calibrationpanel.moc"
