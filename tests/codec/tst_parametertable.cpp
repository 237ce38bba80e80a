// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/parametertable.h"

#include <QTest>

#include <limits>

using namespace trex;

class TstParameterTable : public QObject {
    Q_OBJECT

private slots:
    void numbersAndKeys_areTheContracts(); // C-34
    void find_knowsWhatThereIs();
    void range_isTheConformanceRange_data();
    void range_isTheConformanceRange(); // C-59
    void needsReset_isTheDocuments(); // C-39
    void guesses_areMarked(); // C-63
    void physical_roundTrips_everyRawValue();
    void physical_takesTheNearestRawValue_data();
    void physical_takesTheNearestRawValue();
    void text_isForPeople_data();
    void text_isForPeople();
    void text_takesAnyRawValue();
    void pwmHertz_meetsTheAnchors();
};

void TstParameterTable::numbersAndKeys_areTheContracts()
{
    const std::pair<int, const char*> wanted[]{{0x00, "device-number"},
                                               {0x01, "required-channels"},
                                               {0x02, "ignored-channels"},
                                               {0x03, "reversed-channels"},
                                               {0x04, "parabolic-channels"},
                                               {0x05, "motor1-deadband-brake"},
                                               {0x06, "motor2-deadband-brake"},
                                               {0x07, "serial-timeout"},
                                               {0x08, "uart-error-shutdown"},
                                               {0x09, "motor1-pwm-prescaler"},
                                               {0x0A, "motor2-pwm-prescaler"},
                                               {0x0B, "motor1-pwm-maximum"},
                                               {0x0C, "motor2-pwm-maximum"},
                                               {0x0D, "aux-pwm-maximum"},
                                               {0x0E, "motor1-acceleration"},
                                               {0x0F, "motor2-acceleration"},
                                               {0x10, "aux-acceleration"},
                                               {0x11, "motor1-brake-duration"},
                                               {0x12, "motor2-brake-duration"},
                                               {0x13, "motor1-current-limit"},
                                               {0x14, "motor2-current-limit"},
                                               {0x15, "motor1-current-limit-p"},
                                               {0x16, "motor2-current-limit-p"},
                                               {0x17, "uart-response-delay"},
                                               {0x7B, "motor-mode"},
                                               {0x7C, "channel-input-source"},
                                               {0x7D, "crc7-polynomial"},
                                               {0x7E, "uart-settings"},
                                               {0x7F, "factory-reset"}};
    QCOMPARE(std::size(wanted), kParameters.size());
    for (std::size_t i = 0; i < kParameters.size(); ++i) {
        QCOMPARE(int{kParameters[i].number}, wanted[i].first);
        QCOMPARE(QString::fromLatin1(kParameters[i].key), QString::fromLatin1(wanted[i].second));
    }
}

void TstParameterTable::find_knowsWhatThereIs()
{
    int found = 0;
    for (int number = -300; number < 600; ++number) {
        const auto* const row = findParameter(number);
        found += row != nullptr ? 1 : 0;
        QVERIFY(row == nullptr || row->number == number);
    }
    QCOMPARE(found, 29);
    for (const auto& row : kParameters) {
        QCOMPARE(findParameter(QString::fromLatin1(row.key)), &row);
    }
    QVERIFY(findParameter(u"Serial-Timeout") == nullptr);
    QVERIFY(findParameter(u"") == nullptr);
}

void TstParameterTable::range_isTheConformanceRange_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("maximum");
    for (const auto& row : kParameters) {
        const int number = row.number;
        const bool isMask = number >= 0x01 && number <= 0x04;
        const bool isFlag = number == 0x08 || number == 0x17 || number == 0x7B || number == 0x7C;
        const bool isPrescaler = number == 0x09 || number == 0x0A;
        QTest::addRow("0x%02X", static_cast<unsigned>(number)) << number
                                                               << (isMask            ? 31
                                                                       : isFlag      ? 1
                                                                       : isPrescaler ? 3
                                                                                     : 127);
    }
}

void TstParameterTable::range_isTheConformanceRange()
{
    QFETCH(int, number);
    QFETCH(int, maximum);
    const auto& row = *findParameter(number);
    for (int raw = -200; raw <= 400; ++raw) {
        const bool hasBaud = number != 0x7E || (raw & 15) <= 10;
        QCOMPARE(accepts(row, raw), raw >= 0 && raw <= maximum && hasBaud);
    }
    QVERIFY(!accepts(row, std::numeric_limits<int>::max()));
    QVERIFY(!accepts(row, std::numeric_limits<int>::min()));
    QVERIFY(accepts(row, row.defaultRaw));
}

void TstParameterTable::needsReset_isTheDocuments()
{
    for (const auto& row : kParameters) {
        QCOMPARE(row.needsReset, row.number >= 0x7B && row.number <= 0x7F);
        QCOMPARE(row.isTrigger, row.number == 0x7F);
    }
}

void TstParameterTable::guesses_areMarked()
{
    // facts.md 2: only these defaults come from Pololu; the rest must not look like facts.
    const QList<int> documented{0x00, 0x01, 0x09, 0x0A, 0x0B, 0x0C, 0x7C, 0x7D};
    for (const auto& row : kParameters) {
        QCOMPARE(!isGuess(row.defaultGrade), documented.contains(row.number));
    }
    QVERIFY(isGuess(parameterRow("uart-settings").meaningGrade));
    QVERIFY(!isGuess(parameterRow("serial-timeout").meaningGrade));
}

void TstParameterTable::physical_roundTrips_everyRawValue()
{
    for (const auto& row : kParameters) {
        for (int raw = row.minimum; raw <= row.maximum; ++raw) {
            const auto back = rawFromPhysical(row, physicalFromRaw(row, raw));
            QVERIFY(back);
            QCOMPARE(*back, raw);
        }
        QVERIFY(!rawFromPhysical(row, physicalFromRaw(row, row.maximum + 1)));
        QVERIFY(!rawFromPhysical(row, physicalFromRaw(row, -1)));
        QVERIFY(!rawFromPhysical(row, std::numeric_limits<double>::quiet_NaN()));
        QVERIFY(!rawFromPhysical(row, std::numeric_limits<double>::infinity()));
        QVERIFY(!rawFromPhysical(row, -1e300));
    }
}

void TstParameterTable::physical_takesTheNearestRawValue_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<double>("physical");
    QTest::addColumn<int>("raw"); // -1: none
    QTest::newRow("500 ms") << QStringLiteral("serial-timeout") << 500.0 << 5;
    QTest::newRow("549 ms") << QStringLiteral("serial-timeout") << 549.0 << 5;
    QTest::newRow("551 ms") << QStringLiteral("serial-timeout") << 551.0 << 6;
    QTest::newRow("12.7 s") << QStringLiteral("serial-timeout") << 12'700.0 << 127;
    QTest::newRow("12.8 s") << QStringLiteral("serial-timeout") << 12'800.0 << -1;
    QTest::newRow("-100 ms") << QStringLiteral("serial-timeout") << -100.0 << -1;
    QTest::newRow("2.4 A") << QStringLiteral("motor1-current-limit") << 2.4 << 30;
    QTest::newRow("2.43 A") << QStringLiteral("motor1-current-limit") << 2.43 << 30;
    QTest::newRow("10.16 A") << QStringLiteral("motor2-current-limit") << 10.16 << 127;
    QTest::newRow("10.24 A") << QStringLiteral("motor2-current-limit") << 10.24 << -1;
    QTest::newRow("100 ms of brake") << QStringLiteral("motor1-brake-duration") << 100.0 << 10;
}

void TstParameterTable::physical_takesTheNearestRawValue()
{
    QFETCH(QString, key);
    QFETCH(double, physical);
    QFETCH(int, raw);
    QCOMPARE(rawFromPhysical(*findParameter(key), physical).value_or(-1), raw);
}

void TstParameterTable::text_isForPeople_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("raw");
    QTest::addColumn<QString>("text");
    const auto add = [](int number, int raw, const char* text) {
        QTest::newRow(text) << number << raw << QString::fromLatin1(text);
    };
    add(0x00, 7, "7");
    add(0x01, 1, "channel 1");
    add(0x01, 0b10101, "channels 1, 3, 5");
    add(0x02, 0, "no channel");
    add(0x07, 5, "500 ms");
    add(0x07, 0, "off");
    add(0x0E, 0, "unlimited");
    add(0x13, 0, "no limit (unsure)");
    add(0x08, 1, "on");
    add(0x17, 0, "off");
    add(0x09, 1, "1: 2.4 kHz");
    add(0x11, 10, "100 ms");
    add(0x13, 30, "2.40 A");
    add(0x7B, 1, "joint (one motor on both H-bridges)");
    add(0x7C, 0, "RC pulses");
    add(0x7D, 9, "0x89");
    add(0x7E, 0x25, "19200 baud, CRC-7, 1 stop bit");
    add(0x7E, 0x5A, "115200 baud, even parity, 2 stop bits");
    add(0x7E, 0x60, "1200 baud, odd parity, 1 stop bit");
    add(0x7E, 0x05, "19200 baud, no error detection, 1 stop bit");
    add(0x7E, 0x0B, "11: no such baud rate");
}

void TstParameterTable::text_isForPeople()
{
    QFETCH(int, number);
    QFETCH(int, raw);
    QFETCH(QString, text);
    QCOMPARE(parameterText(*findParameter(number), raw), text);
}

void TstParameterTable::text_takesAnyRawValue()
{
    for (const auto& row : kParameters) {
        for (int raw = 0; raw < 256; ++raw) { // a controller may send what no table expects
            QVERIFY(!parameterText(row, raw).isEmpty());
        }
    }
}

void TstParameterTable::pwmHertz_meetsTheAnchors()
{
    // facts.md 2.1: 2.4 kHz by default, 10 kHz for prescaler 0 with eight bits.
    QCOMPARE(qRound(pwmHertz(0, 127)), 19531);
    QCOMPARE(qRound(pwmHertz(1, 127)), 2441);
    QCOMPARE(qRound(pwmHertz(2, 127)), 610);
    QCOMPARE(qRound(pwmHertz(3, 127)), 153);
    QCOMPARE(qRound(pwmHertz(0, 255)), 9766);
    QCOMPARE(pwmHertz(4, 127), 0.0);
    QCOMPARE(pwmHertz(-1, 127), 0.0);
    QCOMPARE(pwmHertz(0, -1), 0.0);
}

QTEST_APPLESS_MAIN(TstParameterTable)
#include "tst_parametertable.moc"
