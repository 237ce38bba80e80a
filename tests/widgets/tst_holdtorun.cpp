// SPDX-License-Identifier: GPL-3.0-or-later
// Hold to run: motors move while something is held, and by nothing that only seems to be.
#include "protocol/session/drivemix.h"
#include "tests/support/panelbench.h"
#include "widgets/motors/drivepad.h"
#include "widgets/motors/motorspanel.h"

#include <QCheckBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

using Bench = test::PanelBench<MotorsPanel>;

bool arm(Bench& bench)
{
    return bench.connectTo(u"sim:"_s) && bench.controller.arm().has_value();
}

void press(QWidget* widget, int key, bool repeats = false)
{
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier, {}, repeats);
    QCoreApplication::sendEvent(widget, &event);
}

void release(QWidget* widget, int key, bool repeats = false)
{
    QKeyEvent event(QEvent::KeyRelease, key, Qt::NoModifier, {}, repeats);
    QCoreApplication::sendEvent(widget, &event);
}

const QString kBothZero = u"DA0000"_s;

} // namespace

class TestHoldToRun : public QObject {
    Q_OBJECT

private slots:
    void mix_staysWithinFullSpeedAndKeepsTheTurn() // C-65
    {
        QCOMPARE(mixed(60, 0), (std::pair{60, 60}));
        QCOMPARE(mixed(0, 40), (std::pair{40, -40}));
        QCOMPARE(mixed(-50, 20), (std::pair{-30, -70}));
        QCOMPARE(mixed(127, 127), (std::pair{127, 0}));
        QCOMPARE(mixed(-127, 127), (std::pair{0, -127}));
        for (int forward = -127; forward <= 127; ++forward) {
            for (int turn = -127; turn <= 127; ++turn) {
                const auto [first, second] = mixed(forward, turn);
                QVERIFY(std::abs(first) <= kFullSpeed && std::abs(second) <= kFullSpeed);
            }
        }
    }

    void slider_springsBackAtTheRelease()
    {
        Bench bench;
        bench.part<QCheckBox>(u"motors.hold"_s)->click();
        QVERIFY(bench.uiSettings.value(settings::kHoldToRun));
        QVERIFY(arm(bench));
        auto* slider = bench.part<QSlider>(u"motors.motor1.slider"_s);
        QTest::mousePress(slider, Qt::LeftButton, {}, {slider->width() / 2, slider->height() / 2});
        QMouseEvent move(QEvent::MouseMove, QPointF(slider->width() * 0.75, 10),
                         slider->mapToGlobal(QPointF(slider->width() * 0.75, 10)), Qt::LeftButton,
                         Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(slider, &move);
        QVERIFY(slider->value() > 40);
        QTRY_VERIFY(!bench.motorPackets.isEmpty());
        QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->width() * 3 / 4, 10});
        QCOMPARE(slider->value(), 0);
        QTRY_COMPARE(bench.lastMotorPacket(), u"C200"_s);
        QVERIFY2(bench.controller.isArmed(), "a release is no stop");
    }

    void slider_withoutIt_stays()
    {
        Bench bench;
        QVERIFY(arm(bench));
        auto* slider = bench.part<QSlider>(u"motors.motor1.slider"_s);
        press(slider, Qt::Key_PageUp);
        release(slider, Qt::Key_PageUp);
        QCOMPARE(slider->value(), 8);
        QTest::qWait(50);
        QCOMPARE(slider->value(), 8);
    }

    void padKeys_driveWhileTheyAreHeld()
    {
        Bench bench;
        bench.uiSettings.set(settings::kHoldSpeed, 40);
        bench.part<QPushButton>(u"motors.padShown"_s)->click();
        auto* pad = bench.part<DrivePad>(u"motors.pad"_s);
        QVERIFY(pad->isVisible() && !pad->isEnabled());
        QVERIFY(!bench.part<QSlider>(u"motors.motor1.slider"_s)->isVisible());
        QVERIFY(arm(bench));
        press(pad, Qt::Key_Up);
        QTRY_COMPARE(bench.lastMotorPacket(), u"DA2828"_s);
        press(pad, Qt::Key_Right);
        QTRY_COMPARE(bench.lastMotorPacket(), u"DA5000"_s);
        release(pad, Qt::Key_Right);
        QTRY_COMPARE(bench.lastMotorPacket(), u"DA2828"_s);
        press(pad, Qt::Key_Up, true);
        release(pad, Qt::Key_Up, true); // an auto-repeat's release is none
        QCOMPARE(pad->forward(), 40);
        release(pad, Qt::Key_Up);
        QTRY_COMPARE(bench.lastMotorPacket(), kBothZero);
        QCOMPARE(pad->forward(), 0);
    }

    void loss_springsBack_data()
    {
        QTest::addColumn<int>("loss");
        int number = 0;
        for (const char* name : {"focus", "window", "dialog", "hidden", "disabled", "other key",
                                 "mouse grab", "repeats end"}) {
            QTest::newRow(name) << number++;
        }
    }

    void loss_springsBack()
    {
        QFETCH(int, loss);
        Bench bench;
        bench.part<QPushButton>(u"motors.padShown"_s)->click();
        QVERIFY(arm(bench));
        auto* pad = bench.part<DrivePad>(u"motors.pad"_s);
        press(pad, Qt::Key_Up);
        QTRY_VERIFY(!bench.motorPackets.isEmpty());
        QFocusEvent focus(QEvent::FocusOut);
        QEvent window(QEvent::WindowDeactivate);
        QEvent dialog(QEvent::WindowBlocked);
        QEvent grab(QEvent::UngrabMouse);
        switch (loss) {
        case 0:
            QCoreApplication::sendEvent(pad, &focus);
            break;
        case 1:
            QCoreApplication::sendEvent(pad, &window);
            break;
        case 2:
            QCoreApplication::sendEvent(pad, &dialog);
            break;
        case 3:
            bench.panel.hide();
            break;
        case 4:
            pad->setEnabled(false);
            break;
        case 5:
            press(pad, Qt::Key_A);
            break;
        case 6:
            QCoreApplication::sendEvent(pad, &grab);
            break;
        default:
            press(pad, Qt::Key_Up, true); // and then nothing: its release was lost
            break;
        }
        QTRY_COMPARE(pad->forward(), 0);
        QTRY_COMPARE(bench.lastMotorPacket(), kBothZero);
        press(pad, Qt::Key_Up, true); // a repeat alone starts nothing
        QTest::qWait(50);
        QCOMPARE(pad->forward(), 0);
    }

    void keyWithoutAnySign_endsAfterItsTime()
    {
        DrivePad pad;
        pad.show();
        QSignalSpy moved(&pad, &DrivePad::moved);
        press(&pad, Qt::Key_Left);
        QCOMPARE(moved.count(), 1);
        QVERIFY(pad.turn() < 0);
        QTRY_COMPARE_WITH_TIMEOUT(pad.turn(), 0, 10'000);
    }

    void repeats_keepItAlive()
    {
        DrivePad pad;
        pad.show();
        press(&pad, Qt::Key_Down);
        for (int i = 0; i < 40; ++i) { // 4 s, longer than a key without repeats may last
            QTest::qWait(100);
            press(&pad, Qt::Key_Down, true);
        }
        QVERIFY(pad.forward() < 0);
    }

    void padMouse_springsBackAtTheRelease()
    {
        Bench bench;
        bench.part<QPushButton>(u"motors.padShown"_s)->click();
        QVERIFY(arm(bench));
        auto* pad = bench.part<DrivePad>(u"motors.pad"_s);
        QTest::mousePress(pad, Qt::LeftButton, {}, {pad->width() / 2, pad->height() / 4});
        QVERIFY(pad->forward() > 30);
        QCOMPARE(pad->turn(), 0);
        QTRY_VERIFY(!bench.motorPackets.isEmpty());
        QTest::mouseRelease(pad, Qt::LeftButton, {}, {pad->width() / 2, pad->height() / 4});
        QTRY_COMPARE(bench.lastMotorPacket(), kBothZero);
    }

    void stop_springsBackAndNothingFollows()
    {
        Bench bench;
        bench.part<QPushButton>(u"motors.padShown"_s)->click();
        QVERIFY(arm(bench));
        auto* pad = bench.part<DrivePad>(u"motors.pad"_s);
        press(pad, Qt::Key_Up);
        QTRY_VERIFY(!bench.motorPackets.isEmpty());
        bench.controller.stop();
        QCOMPARE(pad->forward(), 0);
        press(pad, Qt::Key_Up, true);
        QTRY_COMPARE(bench.lastMotorPacket(), u"F000"_s);
        QTest::qWait(100);
        QCOMPARE(bench.lastMotorPacket(), u"F000"_s);
    }
};

QTEST_MAIN(TestHoldToRun)
#include "tst_holdtorun.moc"
