// SPDX-License-Identifier: GPL-3.0-or-later
#include "simbench.h"

#include <QTest>

using namespace trex;
using namespace trex::sim;

class TstSimSettings : public QObject {
    Q_OBJECT
private slots:
    void calibration_isWrittenInSevenBitHalves();
    void calibration_isWrittenInEightBitHalvesByQuirk();
    void calibration_answersAfterWriting();
    void calibration_mustBeInOrder_data();
    void calibration_mustBeInOrder();
    void parameter_answersAfterWriting();
    void refusals_comeInOrder_data();
    void refusals_comeInOrder();
    void refusals_outsideSerialMode();
    void refusals_underSerialOverride();
    void ranges_areAsResolved_data();
    void ranges_areAsResolved();
    void wrongFormatBytes_getNoAnswer();
    void lowParameters_actAtOnce();
    void highParameters_actAfterPowerCycle();
    void powerCycle_keepsWhatWasWritten();
    void reset_keepsCalibrations();
    void responseDelay_needsFirmware12();
    void writes_areCountedByAddress();
    void bytesDuringWriting_areKeptUntilTheBufferIsFull();
};

// C-35: 3637 is 0x35 and 0x1C in halves of seven bits
void TstSimSettings::calibration_isWrittenInSevenBitHalves()
{
    SimBench bench;
    QCOMPARE(bench.askByte("A0 3C 13 35 1C 08 27 7D 00 55 2A", 50), 0);
    const CalibrationValues expected{2492, 3637, 5000, 125};
    QCOMPARE(bench.device().calibration(InputKind::Rc, 1), expected);
    QCOMPARE(bench.ask("90"), QByteArray("BC09350E88137D00"));
    QCOMPARE(bench.device().calibration(InputKind::Analog, 1),
             (CalibrationValues{0, 512, 1023, 20}));
}

// C-35
void TstSimSettings::calibration_isWrittenInEightBitHalvesByQuirk()
{
    SimOptions options;
    QVERIFY(options.applyQuirk(QStringLiteral("calibration-bytes=8")));
    SimBench bench(options);
    QCOMPARE(bench.askByte("A0 44 09 26 0E 08 13 64 00 55 2A", 50), 0);
    QCOMPARE(bench.ask("90"), QByteArray("4409260E08136400"));
}

// C-37
void TstSimSettings::calibration_answersAfterWriting()
{
    SimBench bench;
    QCOMPARE(bench.ask("A0 3C 13 35 1C 08 27 7D 00 55 2A", 31), QByteArray());
    QCOMPARE(bench.hear(3), QByteArray("00"));
}

// C-36
void TstSimSettings::calibration_mustBeInOrder_data()
{
    QTest::addColumn<QByteArray>("packet");
    QTest::addColumn<int>("answer");
    QTest::newRow("minimum = neutral") << QByteArray("A1 10 00 10 00 20 00 00 00 55 2A") << 0;
    QTest::newRow("neutral = maximum") << QByteArray("A1 10 00 20 00 20 00 00 00 55 2A") << 0;
    QTest::newRow("all equal") << QByteArray("A1 10 00 10 00 10 00 00 00 55 2A") << 2;
    QTest::newRow("minimum above neutral") << QByteArray("A1 11 00 10 00 20 00 00 00 55 2A") << 2;
    QTest::newRow("neutral above maximum") << QByteArray("A1 10 00 21 00 20 00 00 00 55 2A") << 2;
}

void TstSimSettings::calibration_mustBeInOrder()
{
    QFETCH(QByteArray, packet);
    QFETCH(int, answer);
    SimBench bench;
    const CalibrationValues before = bench.device().calibration(InputKind::Rc, 2);
    QCOMPARE(bench.askByte(packet.constData(), answer == 0 ? 50 : 1), answer);
    QCOMPARE(bench.device().calibration(InputKind::Rc, 2) == before, answer != 0);
    QCOMPARE(bench.askByte("85"), 0);
}

// C-38
void TstSimSettings::parameter_answersAfterWriting()
{
    SimBench bench;
    QCOMPARE(bench.ask("AF 07 05 55 2A", 3), QByteArray());
    QCOMPARE(bench.hear(2), QByteArray("00"));
    QCOMPARE(bench.askByte("9F 07"), 5);
}

// C-38, C-58: number before value, and at once
void TstSimSettings::refusals_comeInOrder_data()
{
    QTest::addColumn<QByteArray>("packet");
    QTest::addColumn<int>("answer");
    QTest::newRow("no such number") << QByteArray("AF 18 00 55 2A") << 1;
    QTest::newRow("no such number, odd value") << QByteArray("AF 7A 7F 55 2A") << 1;
    QTest::newRow("bad value") << QByteArray("AF 01 20 55 2A") << 2;
    QTest::newRow("reset with another value") << QByteArray("AF 7F 00 55 2A") << 2;
}

void TstSimSettings::refusals_comeInOrder()
{
    QFETCH(QByteArray, packet);
    QFETCH(int, answer);
    SimBench bench;
    QCOMPARE(bench.askByte(packet.constData(), 1), answer);
    QCOMPARE(bench.askByte("84"), 0); // a refusal latches nothing
    QCOMPARE(bench.device().eeprom().totalWrites(), 0);
}

// C-38, C-58
void TstSimSettings::refusals_outsideSerialMode()
{
    for (const JumperMode mode : {JumperMode::Rc, JumperMode::Analog}) {
        SimOptions options;
        options.mode = mode;
        SimBench bench(options);
        QCOMPARE(bench.askByte("AF 18 00 55 2A", 1), 3); // mode before number
        QCOMPARE(bench.askByte("A0 00 00 00 00 00 00 00 00 55 2A", 1), 3); // and before value
        QCOMPARE(bench.askByte("85"), 0);
    }
}

// C-58: serial override is not serial mode
void TstSimSettings::refusals_underSerialOverride()
{
    SimOptions options;
    options.mode = JumperMode::Rc;
    options.scenario = heldAt({3750, 3750, 3750, 5000, 2500});
    SimBench bench(options);
    bench.waitMs(100);
    QCOMPARE(bench.askByte("83"), 1);
    QCOMPARE(bench.askByte("AF 07 05 55 2A", 1), 3);
}

// C-59
void TstSimSettings::ranges_areAsResolved_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("largest");
    for (int number = 0; number <= 0x17; ++number) {
        const bool isMask = number >= 1 && number <= 4;
        const bool isFlag = number == 0x08 || number == 0x17;
        const bool isPrescaler = number == 0x09 || number == 0x0A;
        const int largest = isMask ? 31 : isFlag ? 1 : isPrescaler ? 3 : 127;
        QTest::addRow("0x%02x", number) << number << largest;
    }
    QTest::newRow("0x7b") << 0x7B << 1;
    QTest::newRow("0x7c") << 0x7C << 1;
    QTest::newRow("0x7d") << 0x7D << 127;
    QTest::newRow("0x7e") << 0x7E << 0x7A;
}

void TstSimSettings::ranges_areAsResolved()
{
    QFETCH(int, number);
    QFETCH(int, largest);
    for (int raw = 0; raw < 128; ++raw) {
        SimBench bench;
        const QByteArray packet = QByteArray("AF") + QByteArray(1, char(number)).toHex()
            + QByteArray(1, char(raw)).toHex() + "552A";
        const bool isBaud = number != 0x7E || (raw & 0x0F) <= 10;
        QCOMPARE(bench.askByte(packet.constData(), 10), raw <= largest && isBaud ? 0 : 2);
    }
}

// C-37, C-38, C-58
void TstSimSettings::wrongFormatBytes_getNoAnswer()
{
    SimBench bench;
    QCOMPARE(bench.ask("AF 07 05 2A 55"), QByteArray());
    QCOMPARE(bench.askByte("85"), 0x40);
    QCOMPARE(bench.ask("A0 3C 13 35 1C 08 27 7D 00 55 00"), QByteArray());
    QCOMPARE(bench.askByte("85"), 0x40);
    QCOMPARE(bench.device().eeprom().totalWrites(), 0);
}

// C-39
void TstSimSettings::lowParameters_actAtOnce()
{
    SimBench bench;
    QCOMPARE(bench.askByte("AF 17 01 55 2A", 10), 0);
    QCOMPARE(bench.device().parameterInForce(0x17), 1);
    bench.tell("82");
    bench.wait(std::chrono::microseconds(900));
    QVERIFY(bench.line.read(bench.now()).isEmpty());
    bench.wait(std::chrono::microseconds(200));
    QCOMPARE(bench.line.read(bench.now()), QByteArray("r"));
}

// C-39, C-53
void TstSimSettings::highParameters_actAfterPowerCycle()
{
    SimBench bench;
    QCOMPARE(bench.askByte("AF 7E 25 55 2A", 10), 0); // 19200, CRC-7
    QCOMPARE(bench.askByte("AF 7B 01 55 2A", 10), 0);
    QCOMPARE(bench.askByte("82"), 'r');
    bench.line.powerCycle(bench.now());
    QCOMPARE(bench.askByte("82"), -1);
    QCOMPARE(bench.ask("53"), QByteArray("725D")); // the CRC that 0x82 was still waiting for
    QCOMPARE(bench.device().parameterInForce(0x7B), 1);
}

// C-40, C-20, C-21
void TstSimSettings::powerCycle_keepsWhatWasWritten()
{
    SimBench bench;
    QCOMPARE(bench.askByte("AF 07 05 55 2A", 10), 0);
    QCOMPARE(bench.askByte("A0 3C 13 35 1C 08 27 7D 00 55 2A", 50), 0);
    bench.tell("88 C2 40");
    bench.waitMs(30);
    bench.line.powerCycle(bench.now());
    QCOMPARE(bench.askByte("9F 07"), 5);
    QCOMPARE(bench.ask("90"), QByteArray("BC09350E88137D00"));
    QCOMPARE(bench.askByte("85"), 0); // latched bits are RAM
    QCOMPARE(bench.output(MotorId::Motor1), (MotorOutput{0, 0}));
}

// C-60
void TstSimSettings::reset_keepsCalibrations()
{
    SimBench bench;
    QCOMPARE(bench.askByte("A0 3C 13 35 1C 08 27 7D 00 55 2A", 50), 0);
    QCOMPARE(bench.askByte("AF 00 09 55 2A", 10), 0);
    QCOMPARE(bench.askByte("AF 7F 7F 55 2A", 10), 0);
    QCOMPARE(bench.askByte("80 09 02"), 'r'); // still in force
    bench.line.powerCycle(bench.now());
    QCOMPARE(bench.askByte("80 07 02"), 'r');
    QCOMPARE(bench.ask("90"), QByteArray("BC09350E88137D00"));
}

// C-39: 0x17 came with firmware 1.2; 1.1 always waits
void TstSimSettings::responseDelay_needsFirmware12()
{
    SimOptions options;
    QVERIFY(options.applyFirmware(QStringLiteral("1.1")));
    SimBench bench(options);
    QCOMPARE(bench.askByte("AF 17 01 55 2A", 5), 1);
    QCOMPARE(bench.ask("9F 17"), QByteArray());
    QCOMPARE(bench.askByte("85"), 0x40);
    bench.tell("82");
    bench.wait(std::chrono::microseconds(900));
    QVERIFY(bench.line.read(bench.now()).isEmpty());
    QCOMPARE(bench.hear(1), QByteArray("72"));
}

// C-40
void TstSimSettings::writes_areCountedByAddress()
{
    SimBench bench;
    for (int i = 0; i < 3; ++i) {
        QCOMPARE(bench.askByte("AF 07 05 55 2A", 10), 0); // the same value wears too
    }
    QCOMPARE(bench.device().eeprom().writeCount(0x07), 3);
    QCOMPARE(bench.device().eeprom().totalWrites(), 3);
    QCOMPARE(bench.askByte("A0 3C 13 35 1C 08 27 7D 00 55 2A", 50), 0);
    QCOMPARE(bench.device().eeprom().totalWrites(), 11);
}

// C-21: a host that does not wait
void TstSimSettings::bytesDuringWriting_areKeptUntilTheBufferIsFull()
{
    SimBench bench;
    bench.tell("AF 07 05 55 2A 82");
    QCOMPARE(bench.hear(10), QByteArray("0072"));
    QCOMPARE(bench.askByte("85"), 0);
    bench.tell("AF 07 05 55 2A");
    for (int i = 0; i < 40; ++i) {
        bench.tell("82");
    }
    QVERIFY(bench.hear(100).size() < 2 * 41);
    QCOMPARE(bench.askByte("85"), 0x02);
}

QTEST_GUILESS_MAIN(TstSimSettings)
#include "tst_simsettings.moc"
