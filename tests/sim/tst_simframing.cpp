// SPDX-License-Identifier: GPL-3.0-or-later
#include "simbench.h"

#include <QTest>

using namespace trex;
using namespace trex::sim;

class TstSimFraming : public QObject {
    Q_OBJECT
private slots:
    void packets_areAnswered_data();
    void packets_areAnswered();
    void formatErrors_areLatched_data();
    void formatErrors_areLatched();
    void crc_isCheckedAndSent_data();
    void crc_isCheckedAndSent();
    void crc_wrongDiscardsTheWholePacket();
    void crc_polynomialIsAParameter();
    void nullCommand_isPlayedBothWays();
    void deviceNumber_isAParameter();
    void otherDevicesPacket_isIgnoredWhole();
    void dataBeyondAPacket_isIgnored();
};

// C-01, C-02, C-03, C-04, C-06
void TstSimFraming::packets_areAnswered_data()
{
    QTest::addColumn<QByteArray>("sent");
    QTest::addColumn<QByteArray>("reply");
    QTest::newRow("compact signature") << QByteArray("81") << QByteArray("545265584A72312E32");
    QTest::newRow("pololu signature") << QByteArray("800701") << QByteArray("545265584A72312E32");
    QTest::newRow("compact channels") << QByteArray("8601") << QByteArray("350E");
    QTest::newRow("pololu channels") << QByteArray("80070601") << QByteArray("350E");
    QTest::newRow("both forms in turn") << QByteArray("82 800702 82") << QByteArray("727272");
    QTest::newRow("motor commands are silent") << QByteArray("C240 8007427F F07F") << QByteArray();
}

void TstSimFraming::packets_areAnswered()
{
    QFETCH(QByteArray, sent);
    QFETCH(QByteArray, reply);
    SimOptions options;
    options.scenario = heldAt({3637, 3750, 3750, 5000, 5000});
    SimBench bench(options);
    bench.waitMs(50);
    QCOMPARE(bench.ask(sent.constData()), reply);
    QCOMPARE(bench.askByte("85"), 0);
}

// C-01, C-07, C-08, C-09, C-55, C-61
void TstSimFraming::formatErrors_areLatched_data()
{
    QTest::addColumn<QByteArray>("sent");
    QTest::addColumn<QByteArray>("reply");
    QTest::newRow("no such command") << QByteArray("88") << QByteArray();
    QTest::newRow("no such command, with data") << QByteArray("B0 01 02") << QByteArray();
    QTest::newRow("no such command, pololu") << QByteArray("80 07 08") << QByteArray();
    QTest::newRow("command inside a packet is obeyed") << QByteArray("86 82") << QByteArray("72");
    QTest::newRow("0x80 inside a packet is obeyed") << QByteArray("C2 800702") << QByteArray("72");
    QTest::newRow("command for a device number") << QByteArray("80 82") << QByteArray("72");
    QTest::newRow("bit 7 not cleared, then obeyed")
        << QByteArray("80 07 81") << QByteArray("545265584A72312E32");
    QTest::newRow("mask with bit 5") << QByteArray("86 20") << QByteArray();
    QTest::newRow("remapped mask with bit 6") << QByteArray("87 41") << QByteArray();
    QTest::newRow("wrong format bytes") << QByteArray("AF 07 05 55 2B") << QByteArray();
}

void TstSimFraming::formatErrors_areLatched()
{
    QFETCH(QByteArray, sent);
    QFETCH(QByteArray, reply);
    SimBench bench;
    QCOMPARE(bench.ask(sent.constData()), reply);
    QCOMPARE(bench.askByte("84"), 0x01);
    QCOMPARE(bench.askByte("85"), 0x40);
    QCOMPARE(bench.askByte("85"), 0x00);
}

// C-13, C-14: the published example and the table of the guide
void TstSimFraming::crc_isCheckedAndSent_data()
{
    QTest::addColumn<QByteArray>("sent");
    QTest::addColumn<QByteArray>("reply");
    QTest::newRow("signature") << QByteArray("81 48") << QByteArray("545265584A72312E324E");
    QTest::newRow("pololu signature")
        << QByteArray("800701 7D") << QByteArray("545265584A72312E324E");
    QTest::newRow("UART error byte") << QByteArray("85 6C") << QByteArray("0000");
    QTest::newRow("serial controls") << QByteArray("83 5A") << QByteArray("0109");
    QTest::newRow("write") << QByteArray("AF7B01552A 28") << QByteArray("0000");
    QTest::newRow("mask 0 sends no CRC either") << QByteArray("86 00 69") << QByteArray();
}

void TstSimFraming::crc_isCheckedAndSent()
{
    QFETCH(QByteArray, sent);
    QFETCH(QByteArray, reply);
    SimOptions options;
    options.errorDetection = ErrorDetection::Crc7;
    SimBench bench(options);
    QCOMPARE(bench.ask(sent.constData()), reply);
    QCOMPARE(bench.ask("85 6C"), QByteArray("0000"));
}

// C-15
void TstSimFraming::crc_wrongDiscardsTheWholePacket()
{
    SimOptions options;
    options.errorDetection = ErrorDetection::Crc7;
    SimBench bench(options);
    QCOMPARE(bench.ask("81 49"), QByteArray());
    QCOMPARE(bench.ask("85 6C").left(2), QByteArray("20"));
    bench.tell("C2 7F 11"); // 10 would be right
    bench.waitMs(20);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    bench.tell("C2 7F 10");
    bench.waitMs(20);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 127);
    QCOMPARE(bench.ask("85 6C").left(2), QByteArray("20"));
}

// C-14, C-39: 0x7D holds the low seven bits
void TstSimFraming::crc_polynomialIsAParameter()
{
    SimOptions options;
    options.errorDetection = ErrorDetection::Crc7;
    options.polynomial = 0x80; // then the remainder of anything is 0
    SimBench bench(options);
    QCOMPARE(bench.ask("82 00"), QByteArray("7200"));
    QCOMPARE(bench.ask("9F 7D 00"), QByteArray("0000"));
}

// C-56
void TstSimFraming::nullCommand_isPlayedBothWays()
{
    SimBench silent;
    QCOMPARE(silent.ask("FF"), QByteArray());
    QCOMPARE(silent.ask("80 07 7F"), QByteArray());
    QCOMPARE(silent.askByte("85"), 0);

    SimOptions options;
    QVERIFY(options.applyQuirk(QStringLiteral("null-command=error")));
    SimBench error(options);
    QCOMPARE(error.ask("FF"), QByteArray());
    QCOMPARE(error.askByte("85"), 0x40);
}

// C-06, C-39
void TstSimFraming::deviceNumber_isAParameter()
{
    SimBench bench;
    QCOMPARE(bench.askByte("AF 00 08 55 2A", 50), 0);
    QCOMPARE(bench.askByte("80 07 02"), -1);
    QCOMPARE(bench.askByte("80 08 02"), 'r');
    QCOMPARE(bench.askByte("85"), 0);
}

// C-05
void TstSimFraming::otherDevicesPacket_isIgnoredWhole()
{
    SimBench bench;
    QCOMPARE(bench.ask("80 08 01"), QByteArray());
    QCOMPARE(bench.ask("80 08 42 7F"), QByteArray());
    QCOMPARE(bench.ask("80 08 55 01 02 03"), QByteArray());
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    QCOMPARE(bench.askByte("82"), 'r'); // ends the other's packet without an error
    QCOMPARE(bench.askByte("85"), 0);
    QCOMPARE(bench.askByte("84"), 0);
}

// C-54
void TstSimFraming::dataBeyondAPacket_isIgnored()
{
    SimBench bench;
    QCOMPARE(bench.ask("01 02 7F 82 05 06"), QByteArray("72"));
    QCOMPARE(bench.askByte("85"), 0);
}

QTEST_GUILESS_MAIN(TstSimFraming)
#include "tst_simframing.moc"
