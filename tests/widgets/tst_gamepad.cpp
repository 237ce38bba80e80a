// SPDX-License-Identifier: GPL-3.0-or-later
// A gamepad drives while its dead man's button is held, and only where the pad can be used. With
// SDL2, a virtual gamepad of SDL's own stands for a real one.
#include "widgets/motors/drivepad.h"
#include "widgets/motors/gamepad.h"

#ifdef TREX_HAS_SDL2
#define SDL_MAIN_HANDLED
#include <SDL.h>
#endif

#include <QSignalSpy>
#include <QTest>

using namespace trex;

class TestGamepad : public QObject {
    Q_OBJECT

private slots:
    void stick_isNothingWithoutTheDeadMansButton()
    {
        QCOMPARE(stickOrder(32767, -32768, false), (std::pair{0, 0}));
        QCOMPARE(stickOrder(0, -32768, true), (std::pair{127, 0}));
        QCOMPARE(stickOrder(0, 32767, true), (std::pair{-127, 0}));
        QCOMPARE(stickOrder(-32768, 0, true), (std::pair{0, -127}));
        QCOMPARE(stickOrder(4000, -4000, true), (std::pair{0, 0})); // the slack of a worn stick
        int last = 0;
        for (int y = 0; y >= -32768; y -= 64) {
            const int forward = stickOrder(0, y, true).first;
            QVERIFY(forward >= last && forward - last <= 1); // no jump at the end of the slack
            last = forward;
        }
    }

    void pad_followsWhileItCanBeUsed()
    {
        DrivePad pad;
        pad.show();
        pad.activateWindow();
        QTRY_VERIFY(pad.isActiveWindow());
        pad.steer(50, 10);
        QCOMPARE(pad.forward(), 50);
        QCOMPARE(pad.turn(), 10);
        pad.setEnabled(false); // disarmed
        pad.steer(50, 10);
        QCOMPARE(pad.forward(), 0);
        pad.setEnabled(true); // armed again, and the stick is still pulled
        pad.steer(50, 10);
        QCOMPARE(pad.forward(), 0);
        pad.steer(0, 0); // let go once
        pad.steer(30, 0);
        QCOMPARE(pad.forward(), 30);
        pad.hide();
        pad.steer(30, 0);
        QCOMPARE(pad.forward(), 0);
    }

    void virtualGamepad_drivesAndIsNeutralWhenUnplugged()
    {
#ifdef TREX_HAS_SDL2
        Gamepad gamepad;
        QSignalSpy moved(&gamepad, &Gamepad::moved);
        gamepad.listen(true);
        const int index =
            SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                      SDL_CONTROLLER_BUTTON_MAX, 0);
        QVERIFY2(index >= 0, SDL_GetError());
        QTRY_VERIFY(!gamepad.name().isEmpty());
        SDL_Joystick* stick = SDL_JoystickOpen(index);
        SDL_JoystickSetVirtualAxis(stick, SDL_CONTROLLER_AXIS_LEFTY, -32768);
        QTest::qWait(100);
        QVERIFY2(moved.isEmpty(), "the dead man's button is not held");
        SDL_JoystickSetVirtualButton(stick, SDL_CONTROLLER_BUTTON_LEFTSHOULDER, 1);
        QTRY_VERIFY(moved.count() > 2); // again and again
        QCOMPARE(moved.last().at(0).toInt(), 127);
        SDL_JoystickSetVirtualButton(stick, SDL_CONTROLLER_BUTTON_LEFTSHOULDER, 0);
        QTRY_COMPARE(moved.last().at(0).toInt(), 0);
        SDL_JoystickSetVirtualButton(stick, SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, 1);
        QTRY_COMPARE(moved.last().at(0).toInt(), 127);
        SDL_JoystickClose(stick);
        SDL_JoystickDetachVirtual(index);
        QTRY_VERIFY(gamepad.name().isEmpty());
        QTRY_COMPARE(moved.last().at(0).toInt(), 0);
        gamepad.listen(false);
#else
        QSKIP("built without SDL2");
#endif
    }
};

QTEST_MAIN(TestGamepad)
#include "tst_gamepad.moc"
