// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/quantities.h"

#include <QTest>

#include <limits>

using namespace trex;

class TstQuantities : public QObject {
    Q_OBJECT

private slots:
    void motorSpeed_takesItsRangeOnly(); // C-41
    void motorSpeed_splitsIntoDirectionAndMagnitude(); // C-41
    void motorSpeed_clamps();
    void remapped_isSignAndMagnitude(); // C-27
    void pulses_areFourTenthsOfAMicrosecond(); // C-24, C-25
    void analog_isTenBitsOverFiveVolts(); // C-26
    void current_is40MilliamperesACount(); // C-30, C-70
};

void TstQuantities::motorSpeed_takesItsRangeOnly()
{
    for (int speed = -300; speed <= 300; ++speed) {
        const auto made = MotorSpeed::from(speed);
        QCOMPARE(made.has_value(), speed >= -127 && speed <= 127);
        if (made) {
            QCOMPARE(made->raw(), speed);
        }
    }
    QVERIFY(!MotorSpeed::from(std::numeric_limits<int>::min()));
    QVERIFY(!MotorSpeed::from(std::numeric_limits<int>::max()));
}

void TstQuantities::motorSpeed_splitsIntoDirectionAndMagnitude()
{
    QVERIFY(MotorSpeed::from(-127)->direction() == MotorDirection::Reverse);
    QCOMPARE(int{MotorSpeed::from(-127)->magnitude()}, 127);
    QVERIFY(MotorSpeed::from(1)->direction() == MotorDirection::Forward);
    QVERIFY(MotorSpeed().direction() == MotorDirection::Forward);
    QCOMPARE(int{MotorSpeed().magnitude()}, 0);
    QCOMPARE(MotorSpeed::from(127)->percent(), 100.0);
    QCOMPARE(MotorSpeed::from(-127)->percent(), -100.0);
}

void TstQuantities::motorSpeed_clamps()
{
    QCOMPARE(MotorSpeed::clamped(500).raw(), 127);
    QCOMPARE(MotorSpeed::clamped(-500).raw(), -127);
    QCOMPARE(MotorSpeed::clamped(-3).raw(), -3);
}

void TstQuantities::remapped_isSignAndMagnitude()
{
    QCOMPARE(signedFromRemapped(0x00), 0);
    QCOMPARE(signedFromRemapped(0x7F), 127);
    QCOMPARE(signedFromRemapped(0x80), 0); // minus nothing; two's complement would say -128
    QCOMPARE(signedFromRemapped(0x81), -1); // two's complement would say -127
    QCOMPARE(signedFromRemapped(0xFF), -127); // two's complement would say -1
    for (int raw = 0; raw < 256; ++raw) {
        const int value = signedFromRemapped(static_cast<std::uint8_t>(raw));
        QCOMPARE(qAbs(value), raw & 0x7F);
        QVERIFY(value == 0 || (value < 0) == (raw >= 128));
    }
}

void TstQuantities::pulses_areFourTenthsOfAMicrosecond()
{
    QCOMPARE(microsecondsFromRaw(3750), 1500.0);
    QCOMPARE(millisecondsFromRaw(3750), 1.5);
    QCOMPARE(QString::number(millisecondsFromRaw(3637), 'f', 3), QStringLiteral("1.455"));
    QCOMPARE(QString::number(millisecondsFromRaw(2715), 'f', 3), QStringLiteral("1.086"));
}

void TstQuantities::analog_isTenBitsOverFiveVolts()
{
    QCOMPARE(voltsFromRaw(0), 0.0);
    QCOMPARE(voltsFromRaw(1023), 5.0);
    QCOMPARE(QString::number(voltsFromRaw(1) * 1000, 'f', 2), QStringLiteral("4.89"));
}

void TstQuantities::current_is40MilliamperesACount()
{
    QCOMPARE(55 * amperesPerCount(Model::TrexJr), 2.2); // the document's example
    QVERIFY(!isGuess(amperesGrade(Model::TrexJr)));
    QCOMPARE(amperesPerCount(Model::Trex), 0.15);
    QVERIFY(isGuess(amperesGrade(Model::Trex))); // facts.md 1: inferred, to be marked
}

QTEST_APPLESS_MAIN(TstQuantities)
#include "tst_quantities.moc"
