// SPDX-License-Identifier: GPL-3.0-or-later
#include "simbench.h"

#include <QTest>

using namespace trex;
using namespace trex::sim;

class TstSimQueries : public QObject {
    Q_OBJECT
private slots:
    void signature_tellsModelAndFirmware_data();
    void signature_tellsModelAndFirmware();
    void mode_followsJumperAndInputSource();
    void serialControl_isTrueInSerialModeOnly();
    void latchedBytes_areClearedByReadingEachOnItsOwn();
    void driverFault_isLatched();
    void rawChannels_matchTheDocumentsExample();
    void channelMask_choosesChannels();
    void currents_areCountsOfFortyMilliamperes();
    void currents_ofATrexAreCoarser();
    void calibration_isOfTheInputsInUse();
    void learned_isWhatDiffersFromTheDefaults();
    void parameter_hasItsStoredValue();
    void unknownParameter_isPlayedBothWays();
    void factoryDefaults_areAsResolved();
};

// C-17, C-70
void TstSimQueries::signature_tellsModelAndFirmware_data()
{
    QTest::addColumn<QString>("model");
    QTest::addColumn<QString>("firmware");
    QTest::addColumn<QByteArray>("signature");
    QTest::newRow("jr") << "jr"
                        << "1.2" << QByteArray("TReXJr1.2").toHex().toUpper();
    QTest::newRow("jr 1.0") << "jr"
                            << "1.0" << QByteArray("TReXJr1.0").toHex().toUpper();
    QTest::newRow("trex") << "trex"
                          << "1.2" << QByteArray("TReX1.2").toHex().toUpper();
}

void TstSimQueries::signature_tellsModelAndFirmware()
{
    QFETCH(QString, model);
    QFETCH(QString, firmware);
    QFETCH(QByteArray, signature);
    SimOptions options;
    QVERIFY(options.applyModel(model));
    QVERIFY(options.applyFirmware(firmware));
    SimBench bench(options);
    QCOMPARE(bench.ask("81"), signature);
}

// C-18
void TstSimQueries::mode_followsJumperAndInputSource()
{
    SimBench bench;
    QCOMPARE(bench.askByte("82"), 'r');
    bench.line.setMode(JumperMode::Rc);
    QCOMPARE(bench.askByte("82"), 'R');
    bench.line.setMode(JumperMode::Analog);
    QCOMPARE(bench.askByte("82"), 'A');
    SimBench analog(withParameters({{0x7C, 1}}));
    QCOMPARE(analog.askByte("82"), 'a');
    analog.line.setMode(JumperMode::Rc); // 0x7C has no effect outside serial mode
    QCOMPARE(analog.askByte("82"), 'R');
}

// C-19
void TstSimQueries::serialControl_isTrueInSerialModeOnly()
{
    SimOptions options;
    options.scenario = heldAt({3750, 3750, 3750, 5000, 5000});
    SimBench bench(options);
    QCOMPARE(bench.askByte("83"), 1);
    bench.line.setMode(JumperMode::Rc);
    bench.waitMs(100);
    QCOMPARE(bench.askByte("83"), 0);
    bench.line.setInput(held(5, 2600));
    bench.waitMs(100);
    QCOMPARE(bench.askByte("83"), 1);
}

// C-20, C-21, C-61
void TstSimQueries::latchedBytes_areClearedByReadingEachOnItsOwn()
{
    SimBench bench;
    bench.tell("88");
    QCOMPARE(bench.askByte("84"), 0x01);
    QCOMPARE(bench.askByte("84"), 0x00);
    QCOMPARE(bench.askByte("85"), 0x40);
    QCOMPARE(bench.askByte("85"), 0x00);
    bench.tell("88");
    QCOMPARE(bench.askByte("85"), 0x40);
    QCOMPARE(bench.askByte("84"), 0x01);
}

// C-20
void TstSimQueries::driverFault_isLatched()
{
    SimBench bench;
    bench.device().setDriverFault(1, true);
    bench.waitMs(15);
    bench.device().setDriverFault(1, false);
    bench.device().setDriverFault(2, true);
    bench.waitMs(15);
    QCOMPARE(bench.askByte("84"), 0x50);
    bench.device().setDriverFault(2, false);
    bench.askByte("84");
    QCOMPARE(bench.askByte("84"), 0x00);
}

// C-23, C-24, C-25
void TstSimQueries::rawChannels_matchTheDocumentsExample()
{
    SimOptions options;
    options.scenario = heldAt({3637, 0, 3750, 3750, 2715});
    options.scenario.channels[1].wave = Wave::Missing;
    SimBench bench(options);
    bench.waitMs(50);
    QCOMPARE(bench.ask("86 13"), QByteArray("350EFFFF9B0A"));
}

// C-23, C-27, C-69
void TstSimQueries::channelMask_choosesChannels()
{
    SimOptions options;
    options.scenario = heldAt({0x1101 - 1000, 0x0E02, 0x0D03, 0x0C04, 0x0B05});
    SimBench bench(options);
    bench.waitMs(50);
    QCOMPARE(bench.ask("86 1A"), QByteArray("020E040C050B"));
    QCOMPARE(bench.ask("86 00"), QByteArray());
    QCOMPARE(bench.ask("87 00"), QByteArray());
    QCOMPARE(bench.ask("87 1F").size(), 10);
    QCOMPARE(bench.ask("87 04").size(), 2);
    QCOMPARE(bench.askByte("85"), 0);
}

// C-30
void TstSimQueries::currents_areCountsOfFortyMilliamperes()
{
    SimBench bench;
    bench.line.setLoad(2, 0.4);
    bench.tell("DA 7F 7F");
    bench.waitMs(3000);
    const double first = std::abs(bench.device().amperes(MotorId::Motor1)) / 0.040;
    const double second = std::abs(bench.device().amperes(MotorId::Motor2)) / 0.040;
    QVERIFY(std::abs(bench.askByte("8D") - first) <= 1.5);
    QVERIFY(std::abs(bench.askByte("8E") - second) <= 1.5);
    const QByteArray both = hex(bench.ask("8F").constData());
    QCOMPARE(both.size(), 2);
    QVERIFY(std::abs(both[0] - first) <= 1.5);
    QVERIFY(std::abs(both[1] - second) <= 1.5);
    QVERIFY(second > first * 3);
}

// C-30, C-70
void TstSimQueries::currents_ofATrexAreCoarser()
{
    SimOptions options;
    options.model = Model::Trex;
    SimBench bench(options);
    bench.line.setStall(1, true);
    bench.tell("C2 7F");
    bench.waitMs(500);
    QVERIFY(std::abs(bench.askByte("8D") - 12 / 2.18 / 0.150) <= 1.5);
}

// C-32
void TstSimQueries::calibration_isOfTheInputsInUse()
{
    SimBench bench;
    QCOMPARE(bench.ask("90"), QByteArray("C409A60E88136400")); // 2500 3750 5000 100
    QCOMPARE(bench.ask("94"), QByteArray("C409A60E88136400"));
    bench.line.setMode(JumperMode::Analog);
    QCOMPARE(bench.ask("92"), QByteArray("00000002FF031400")); // 0 512 1023 20
    SimBench analog(withParameters({{0x7C, 1}}));
    QCOMPARE(analog.ask("90"), QByteArray("00000002FF031400"));
}

// C-33
void TstSimQueries::learned_isWhatDiffersFromTheDefaults()
{
    SimBench bench;
    QCOMPARE(bench.askByte("95"), 0);
    // channel 3: 2600, 3750, 5000, 100 in 7-bit halves
    QCOMPARE(bench.askByte("A2 28 14 26 1D 08 27 64 00 55 2A", 50), 0);
    QCOMPARE(bench.askByte("95"), 0x04);
    bench.line.setMode(JumperMode::Analog);
    QCOMPARE(bench.askByte("95"), 0);
}

// C-34, C-57
void TstSimQueries::parameter_hasItsStoredValue()
{
    SimBench bench;
    QCOMPARE(bench.askByte("9F 00"), 7);
    QCOMPARE(bench.askByte("AF 7C 01 55 2A", 50), 0);
    QCOMPARE(bench.askByte("9F 7C"), 1); // stored, not yet in force
    QCOMPARE(bench.askByte("82"), 'r');
}

// C-57
void TstSimQueries::unknownParameter_isPlayedBothWays()
{
    for (const char* question : {"9F 18", "9F 7A", "9F 7F"}) {
        SimBench bench;
        QCOMPARE(bench.ask(question), QByteArray());
        QCOMPARE(bench.askByte("85"), 0x40);
    }
    SimOptions options;
    QVERIFY(options.applyQuirk(QStringLiteral("unknown-parameter=ff")));
    SimBench bench(options);
    QCOMPARE(bench.ask("9F 18"), QByteArray("FF"));
    QCOMPARE(bench.askByte("85"), 0x40);
}

// C-63
void TstSimQueries::factoryDefaults_areAsResolved()
{
    const std::map<int, int> expected{
        {0x00, 7}, {0x01, 1}, {0x02, 0}, {0x03, 0}, {0x04, 0},   {0x05, 0},   {0x06, 0},
        {0x07, 0}, {0x08, 0}, {0x09, 1}, {0x0A, 1}, {0x0B, 127}, {0x0C, 127}, {0x0D, 127},
        {0x0E, 0}, {0x0F, 0}, {0x10, 0}, {0x11, 0}, {0x12, 0},   {0x13, 0},   {0x14, 0},
        {0x15, 5}, {0x16, 5}, {0x17, 0}, {0x7B, 0}, {0x7C, 0},   {0x7D, 9},   {0x7E, 5}};
    SimBench bench;
    for (const auto& [number, raw] : expected) {
        const QByteArray question = "9F" + QByteArray::number(number, 16).rightJustified(2, '0');
        QCOMPARE(bench.askByte(question.constData()), raw);
    }
}

QTEST_GUILESS_MAIN(TstSimQueries)
#include "tst_simqueries.moc"
