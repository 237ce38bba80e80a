// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/panelbench.h"
#include "widgets/motors/motorslider.h"
#include "widgets/motors/motorspanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QWheelEvent>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

using Bench = test::PanelBench<MotorsPanel>;

const QString kStop = u"DA0000"_s;
const QString kStopAux = u"F000"_s;

QSlider* slider(const Bench& bench, const QString& motor)
{
    return bench.part<QSlider>(u"motors.%1.slider"_s.arg(motor));
}

/// As a person does it, and until the sliders can be used.
bool arm(Bench& bench)
{
    auto* button = bench.part<QPushButton>(u"motors.arm"_s);
    if (!QTest::qWaitFor([&] { return button->isEnabled(); }, 5000)) {
        return false;
    }
    button->click();
    return bench.controller.isArmed() && slider(bench, u"motor1"_s)->isEnabled();
}

} // namespace

class TestMotorsPanel : public QObject {
    Q_OBJECT

private slots:
    void start_isDisarmed_andNothingIsSent()
    {
        Bench bench;
        QVERIFY(!bench.part<QPushButton>(u"motors.arm"_s)->isChecked());
        for (const QString& motor : {u"motor1"_s, u"motor2"_s, u"aux"_s}) {
            QVERIFY(!slider(bench, motor)->isEnabled());
        }
        QVERIFY(bench.connectTo(u"sim:"_s));
        QTest::qWait(100);
        QVERIFY2(bench.motorPackets.isEmpty(), qPrintable(bench.motorPackets.join(u' ')));
        QVERIFY(!slider(bench, u"motor1"_s)->isEnabled());
    }

    void sliders_sendSignedSpeeds()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QVERIFY(arm(bench));
        QVERIFY2(bench.motorPackets.isEmpty(), "arming itself moves nothing");
        slider(bench, u"motor1"_s)->setValue(64);
        QTRY_COMPARE(bench.lastMotorPacket(), u"C240"_s);
        slider(bench, u"motor2"_s)->setValue(-40);
        QTRY_COMPARE(bench.lastMotorPacket(), u"C928"_s);
        slider(bench, u"aux"_s)->setValue(127);
        QTRY_COMPARE(bench.lastMotorPacket(), u"F07F"_s);
        QCOMPARE(bench.part<QLabel>(u"motors.motor1.value"_s)->text(), u"64  50 %"_s);
        QCOMPARE(bench.part<QLabel>(u"motors.motor2.value"_s)->text(), u"−40  −31 %"_s);
        auto* mode = bench.part<QComboBox>(u"motors.mode"_s);
        mode->setCurrentIndex(mode->findData(u"accelerate"_s));
        slider(bench, u"motor1"_s)->setValue(65);
        QTRY_COMPARE(bench.lastMotorPacket(), u"C641"_s);
    }

    void linked_oneSliderMovesBothInOnePacket()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QVERIFY(arm(bench));
        bench.part<QCheckBox>(u"motors.link"_s)->setChecked(true);
        slider(bench, u"motor2"_s)->setValue(-16);
        QTRY_COMPARE(bench.lastMotorPacket(), u"D51010"_s);
        QCOMPARE(slider(bench, u"motor1"_s)->value(), -16);
        QCOMPARE(bench.motorPackets.size(), 1);
    }

    void brake_sendsItsDuty()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QVERIFY(arm(bench));
        slider(bench, u"motor1"_s)->setValue(64);
        bench.part<QSpinBox>(u"motors.motor1.brakeDuty"_s)->setValue(100);
        bench.part<QPushButton>(u"motors.motor1.brake"_s)->click();
        QTRY_COMPARE(bench.lastMotorPacket(), u"C064"_s);
        QCOMPARE(slider(bench, u"motor1"_s)->value(), 0);
        QCOMPARE(bench.part<QLabel>(u"motors.motor1.value"_s)->text(), u"brake 100"_s);
        bench.part<QPushButton>(u"motors.motor1.zero"_s)->click();
        QTRY_COMPARE(bench.lastMotorPacket(), u"C200"_s);
    }

    void stopButton_stopsDisarmsAndZeroes()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QVERIFY(arm(bench));
        slider(bench, u"motor1"_s)->setValue(90);
        QTest::mousePress(bench.part<QPushButton>(u"motors.stop"_s), Qt::LeftButton);
        QTRY_VERIFY(bench.motorPackets.contains(kStopAux));
        QCOMPARE(bench.motorPackets.mid(bench.motorPackets.size() - 2),
                 (QStringList{kStop, kStopAux}));
        QVERIFY(!bench.controller.isArmed());
        QVERIFY(!bench.part<QPushButton>(u"motors.arm"_s)->isChecked());
        QCOMPARE(slider(bench, u"motor1"_s)->value(), 0);
        QVERIFY(!slider(bench, u"motor1"_s)->isEnabled());
    }

    void disarming_stopsAllThree()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QVERIFY(arm(bench));
        slider(bench, u"aux"_s)->setValue(30);
        QTRY_VERIFY(!bench.motorPackets.isEmpty());
        bench.part<QPushButton>(u"motors.arm"_s)->click();
        QTRY_COMPARE(bench.motorPackets.mid(1), (QStringList{kStop, kStopAux}));
    }

    void disconnecting_stopsAndReconnectingStaysDisarmed()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QVERIFY(arm(bench));
        slider(bench, u"motor1"_s)->setValue(50);
        QTRY_COMPARE(bench.motorPackets.size(), 1);
        bench.controller.close();
        QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
        QCOMPARE(bench.motorPackets.mid(1), (QStringList{kStop, kStopAux}));
        bench.motorPackets.clear();
        QVERIFY(bench.connectTo(u"sim:"_s));
        QTest::qWait(100);
        QVERIFY(!bench.controller.isArmed());
        QVERIFY(!slider(bench, u"motor1"_s)->isEnabled());
        QVERIFY(bench.motorPackets.isEmpty());
    }

    void wheel_doesNothingWithoutTheFocus()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QVERIFY(arm(bench));
        QSlider* motor = slider(bench, u"motor1"_s);
        bench.part<QPushButton>(u"motors.arm"_s)->setFocus();
        const auto turn = [&] {
            QWheelEvent wheel({10, 10}, motor->mapToGlobal(QPoint(10, 10)), {}, {0, 120},
                              Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
            QCoreApplication::sendEvent(motor, &wheel);
        };
        turn();
        QCOMPARE(motor->value(), 0);
        bench.panel.activateWindow();
        motor->setFocus();
        QTRY_VERIFY(motor->hasFocus());
        turn();
        QVERIFY(motor->value() != 0);
    }

    void keys_stepAndNeverJumpToFullSpeed()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:"_s));
        QVERIFY(arm(bench));
        QSlider* motor = slider(bench, u"motor1"_s);
        QTest::keyClick(motor, Qt::Key_Right);
        QCOMPARE(motor->value(), 1);
        QTest::keyClick(motor, Qt::Key_End);
        QCOMPARE(motor->value(), 1);
        QTest::keyClick(motor, Qt::Key_Home);
        QCOMPARE(motor->value(), 0);
    }

    void lostLink_disarms()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:?fault=silent-after=2&fault=silent-for=3"_s));
        QVERIFY(arm(bench));
        slider(bench, u"motor1"_s)->setValue(50);
        QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Lost, 10'000);
        QVERIFY(!bench.controller.isArmed());
        QVERIFY(!slider(bench, u"motor1"_s)->isEnabled());
        QCOMPARE(slider(bench, u"motor1"_s)->value(), 0);
        QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Connected, 15'000);
        QVERIFY(!bench.controller.isArmed());
        QTRY_VERIFY(bench.motorPackets.mid(1).contains(kStop));
        for (const QString& packet : bench.motorPackets.mid(1)) {
            QVERIFY2(packet == kStop || packet == kStopAux, qPrintable(packet));
        }
    }

    void serialNotInControl_isSaid() // C-49, C-50
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:?mode=rc"_s));
        auto* hint = bench.part<QLabel>(u"motors.hint"_s);
        QTRY_VERIFY(hint->text().contains(u"waits in the controller"_s));
        bench.controller.close();
        QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
        QVERIFY(hint->text().contains(u"overrides current limiting"_s));
    }
};

QTEST_MAIN(TestMotorsPanel)
#include "tst_motorspanel.moc"
