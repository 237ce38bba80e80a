// SPDX-License-Identifier: GPL-3.0-or-later
// What a person chooses about safety is kept and reaches the façade's values; the serial timeout is
// warned of and set in one click; the watchdog proof says what it found.
#include "tests/support/panelbench.h"
#include "widgets/common/safetysettings.h"
#include "widgets/motors/motorspanel.h"
#include "widgets/motors/safetydialog.h"
#include "widgets/motors/watchdogdialog.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>

using namespace Qt::Literals::StringLiterals;
using namespace std::chrono_literals;
using namespace trex;

using Bench = test::PanelBench<MotorsPanel>;

class TestSafetyDialog : public QObject {
    Q_OBJECT

private slots:
    void defaults_shapeNothingAndDisarmForWhatIsDangerous()
    {
        Bench bench;
        QCOMPARE(motionLimits(bench.uiSettings), MotionLimits{});
        QCOMPARE(disarmRules(bench.uiSettings), DisarmRules{});
        QVERIFY(bench.uiSettings.value(settings::kDisarmHidden));
        QVERIFY(bench.uiSettings.value(settings::kDisarmLocked));
        QVERIFY(!bench.uiSettings.value(settings::kHoldToRun));
    }

    void choices_areKept()
    {
        Bench bench;
        SafetyDialog dialog(bench.context);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        const auto check = [&dialog](const QString& name, bool on) {
            dialog.findChild<QCheckBox*>(u"motors.safety."_s + name)->setChecked(on);
        };
        const auto number = [&dialog](const QString& name, int value) {
            dialog.findChild<QSpinBox*>(u"motors.safety."_s + name)->setValue(value);
        };
        check(u"motorFault"_s, false);
        check(u"overCurrent"_s, true);
        check(u"uartError"_s, true);
        check(u"serialTimeout"_s, false);
        check(u"locked"_s, false);
        check(u"hidden"_s, false);
        number(u"idle"_s, 3);
        number(u"maximum1"_s, 50);
        number(u"maximum2"_s, 60);
        number(u"maximumAux"_s, 70);
        number(u"softStart"_s, 100);
        number(u"softStop"_s, 200);
        number(u"stallMs"_s, 300);
        number(u"sliderStep"_s, 4);
        number(u"holdSpeed"_s, 25);
        dialog.findChild<QDoubleSpinBox*>(u"motors.safety.stallAmperes"_s)->setValue(2.5);
        QCOMPARE(disarmRules(bench.uiSettings), (DisarmRules{false, true, true, false, 180s}));
        const MotionLimits limits{.maximum = {50, 60, 70},
                                  .softStart = 100,
                                  .softStop = 200,
                                  .stallAmperes = 2.5,
                                  .stallTime = 300ms};
        QCOMPARE(motionLimits(bench.uiSettings), limits);
        QVERIFY(!bench.uiSettings.value(settings::kDisarmLocked));
        QVERIFY(!bench.uiSettings.value(settings::kDisarmHidden));
        QCOMPARE(bench.uiSettings.value(settings::kHoldSpeed), 25);
        // The panel's sliders follow at once.
        QCOMPARE(bench.part<QSlider>(u"motors.motor1.slider"_s)->maximum(), 50);
        QCOMPARE(bench.part<QSlider>(u"motors.motor1.slider"_s)->minimum(), -50);
        QCOMPARE(bench.part<QSlider>(u"motors.aux.slider"_s)->minimum(), 0);
        QCOMPARE(bench.part<QSlider>(u"motors.motor1.slider"_s)->pageStep(), 4);
        // And a dialog opened anew shows them.
        SafetyDialog again(bench.context);
        again.setAttribute(Qt::WA_DeleteOnClose, false);
        QCOMPARE(again.findChild<QSpinBox*>(u"motors.safety.maximum2"_s)->value(), 60);
        QVERIFY(!again.findChild<QCheckBox*>(u"motors.safety.hidden"_s)->isChecked());
    }

    void nonsenseInTheFile_isBroughtIntoRange()
    {
        Bench bench;
        bench.uiSettings.set(settings::kMaximum1, -5);
        bench.uiSettings.set(settings::kSoftStop, 1'000'000);
        bench.uiSettings.set(settings::kIdleSeconds, -1);
        QCOMPARE(motionLimits(bench.uiSettings).maximum[0], 1);
        QVERIFY(motionLimits(bench.uiSettings).softStop <= 10'000);
        QCOMPARE(disarmRules(bench.uiSettings).idle, 0s);
    }

    void timeoutOff_isWarnedOf_andSetInOneClick()
    {
        Bench bench;
        auto* warning = bench.part<QLabel>(u"motors.timeoutWarning"_s);
        auto* set = bench.part<QPushButton>(u"motors.setTimeout"_s);
        QVERIFY(!warning->isVisible());
        QVERIFY(bench.connectTo(u"sim:"_s));
        QTRY_VERIFY(warning->isVisible());
        QVERIFY(warning->text().contains(u"motors run on"_s));
        QTRY_VERIFY(set->isEnabled());
        set->click();
        QTRY_VERIFY(!warning->isVisible());
        QCOMPARE(bench.settings.parameter(parameterRow("serial-timeout").number), 5);
    }

    void timeoutOn_noWarning()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5"_s));
        QTRY_COMPARE(bench.timeoutWatch.state(), SerialTimeoutWatch::State::On);
        QVERIFY(!bench.part<QLabel>(u"motors.timeoutWarning"_s)->isVisible());
    }

    void timeoutOff_inRcMode_cannotBeSet() // C-38
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:?mode=rc"_s));
        QTRY_VERIFY(bench.part<QLabel>(u"motors.timeoutWarning"_s)->isVisible());
        QVERIFY(!bench.part<QPushButton>(u"motors.setTimeout"_s)->isEnabled());
    }

    void proof_passesAndFails_data()
    {
        QTest::addColumn<QString>("options");
        QTest::addColumn<QString>("result");
        QTest::newRow("acts") << u"param=serial-timeout=3"_s << u"Watchdog proof passed"_s;
        QTest::newRow("does not act")
            << u"param=serial-timeout=3&quirk=serial-timeout=off"_s << u"Watchdog proof FAILED"_s;
    }

    void proof_passesAndFails()
    {
        QFETCH(QString, options);
        QFETCH(QString, result);
        Bench bench;
        bench.controller.want(&bench.panel, PollId::Currents, 80.0);
        QVERIFY(bench.connectTo(u"sim:?"_s + options));
        WatchdogDialog dialog(bench.context);
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        dialog.show();
        auto* start = dialog.findChild<QPushButton*>(u"motors.proof.start"_s);
        QVERIFY2(!start->isEnabled(), "it turns a motor: not without arming");
        QTRY_COMPARE(bench.timeoutWatch.state(), SerialTimeoutWatch::State::On);
        QVERIFY(bench.controller.arm().has_value());
        QVERIFY(start->isEnabled());
        start->click();
        auto* text = dialog.findChild<QLabel*>(u"motors.proof.result"_s);
        QTRY_VERIFY_WITH_TIMEOUT(text->text().startsWith(result), 30'000);
        QVERIFY(!bench.controller.isArmed());
        QVERIFY(bench.log.toText().contains(result));
        QTRY_COMPARE(bench.lastMotorPacket(), u"F000"_s);
    }

    void proof_closingTheDialogStops()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=10"_s));
        auto* dialog = new WatchdogDialog(bench.context);
        dialog->show();
        QTRY_COMPARE(bench.timeoutWatch.state(), SerialTimeoutWatch::State::On);
        QVERIFY(bench.controller.arm().has_value());
        dialog->findChild<QPushButton*>(u"motors.proof.start"_s)->click();
        QTRY_COMPARE(bench.lastMotorPacket(), u"C219"_s);
        dialog->close();
        QTRY_COMPARE(bench.lastMotorPacket(), u"F000"_s);
        QVERIFY(!bench.controller.isArmed());
    }
};

QTEST_MAIN(TestSafetyDialog)
#include "tst_safetydialog.moc"
