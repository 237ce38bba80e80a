// SPDX-License-Identifier: GPL-3.0-or-later
#include "simbench.h"

#include <QTest>

using namespace trex;
using namespace trex::sim;

class TstSimChannels : public QObject {
    Q_OBJECT
private slots:
    void missingPulse_becomesInvalid_data();
    void missingPulse_becomesInvalid();
    void badPulse_isInvalid();
    void analog_isTenBits();
    void remapping_scales_data();
    void remapping_scales();
    void remapping_bends_data();
    void remapping_bends();
    void remapped_isWhatTheMotorsAreTold();
    void deadbandBrake_actsAtRest();
    void switches_turnAtMinus64();
    void requiredChannel_missingStopsTheMotors();
    void ignoredChannel_restsAndIsNotRequired();
    void safeStart_byQuirk();
    void safeStart_holdsSerialOverride();
    void updateRate_isFiftyHertz();
};

// C-24
void TstSimChannels::missingPulse_becomesInvalid_data()
{
    QTest::addColumn<QString>("quirk");
    QTest::addColumn<int>("ms");
    QTest::newRow("100 ms") << "invalid-after=100" << 100;
    QTest::newRow("150 ms") << "invalid-after=150" << 150;
}

void TstSimChannels::missingPulse_becomesInvalid()
{
    QFETCH(QString, quirk);
    QFETCH(int, ms);
    SimOptions options;
    QVERIFY(options.applyQuirk(quirk));
    options.scenario = heldAt({3750, 3750, 3750, 5000, 5000});
    SimBench bench(options);
    QCOMPARE(bench.ask("86 01", 1), QByteArray("FFFF")); // before the first pulse
    bench.waitMs(40); // the last pulse of channel 1 ended at 41 ms
    ChannelWave gone = held(1, 0);
    gone.wave = Wave::Missing;
    bench.line.setInput(gone);
    bench.waitMs(ms - 5);
    QCOMPARE(bench.ask("86 01", 1), QByteArray("A60E"));
    bench.waitMs(10);
    QCOMPARE(bench.ask("86 01", 1), QByteArray("FFFF"));
    QCOMPARE(bench.ask("87 01", 1), QByteArray("00")); // C-64
}

// C-24: too long or too short
void TstSimChannels::badPulse_isInvalid()
{
    SimOptions options;
    options.scenario = heldAt({1249, 1250, 6250, 6251, 3750});
    SimBench bench(options);
    bench.waitMs(50);
    QCOMPARE(bench.ask("86 1F"), QByteArray("FFFFE2046A18FFFFA60E"));
}

// C-26
void TstSimChannels::analog_isTenBits()
{
    SimOptions options;
    options.mode = JumperMode::Analog;
    options.scenario = heldAt({0, 1023, 5000, 512, 1});
    SimBench bench(options);
    bench.waitMs(50);
    QCOMPARE(bench.ask("86 1F"), QByteArray("0000FF03FF0300020100"));
}

// C-27, C-28: calibration 2500, 3750, 5000, 100
void TstSimChannels::remapping_scales_data()
{
    QTest::addColumn<double>("raw");
    QTest::addColumn<int>("remapped");
    QTest::newRow("above maximum") << 5100.0 << 127;
    QTest::newRow("maximum") << 5000.0 << 127;
    QTest::newRow("below maximum") << 4999.0 << 126;
    QTest::newRow("half-way up") << 4425.0 << 63;
    QTest::newRow("edge of the deadband") << 3850.0 << 0;
    QTest::newRow("neutral") << 3750.0 << 0;
    QTest::newRow("other edge") << 3650.0 << 0;
    QTest::newRow("half-way down") << 3075.0 << (0x80 | 63);
    QTest::newRow("minimum") << 2500.0 << (0x80 | 127);
    QTest::newRow("below minimum") << 2400.0 << (0x80 | 127);
}

void TstSimChannels::remapping_scales()
{
    QFETCH(double, raw);
    QFETCH(int, remapped);
    SimOptions options;
    options.scenario = heldAt({raw, 3750, 3750, 5000, 5000});
    SimBench bench(options);
    bench.waitMs(50);
    QCOMPARE(bench.askByte("87 01"), remapped);
}

// C-28, C-65: scale, parabolic, reverse, mix, flip
void TstSimChannels::remapping_bends_data()
{
    using Parameters = std::map<int, int>;
    QTest::addColumn<Parameters>("parameters");
    QTest::addColumn<bool>("mix");
    QTest::addColumn<double>("flip");
    QTest::addColumn<QByteArray>("remapped");
    // raw 4425 is 63, raw 3075 is −63, 5000 is 127
    QTest::newRow("plain") << Parameters{} << false << 5000.0 << QByteArray("3FBF7F");
    QTest::newRow("parabolic: 63² / 127 = 31")
        << Parameters{{0x04, 0x03}} << false << 5000.0 << QByteArray("1F9F7F");
    QTest::newRow("reversed") << Parameters{{0x03, 0x05}} << false << 5000.0
                              << QByteArray("BFBFFF");
    QTest::newRow("mix: forward −63, turn 63")
        << Parameters{} << true << 5000.0 << QByteArray("00FE7F");
    QTest::newRow("mix after reverse")
        << Parameters{{0x03, 0x01}} << true << 5000.0 << QByteArray("FE007F");
    QTest::newRow("flip changes places and signs")
        << Parameters{} << false << 2500.0 << QByteArray("3FBF7F");
    QTest::newRow("flip after mix") << Parameters{} << true << 2500.0 << QByteArray("7E007F");
    QTest::newRow("no mix in joint mode")
        << Parameters{{0x7B, 1}} << true << 5000.0 << QByteArray("3FBF7F");
    QTest::newRow("ignored") << Parameters{{0x02, 0x05}} << false << 5000.0 << QByteArray("00BF00");
}

void TstSimChannels::remapping_bends()
{
    using Parameters = std::map<int, int>;
    QFETCH(Parameters, parameters);
    QFETCH(bool, mix);
    QFETCH(double, flip);
    QFETCH(QByteArray, remapped);
    SimOptions options = withParameters(parameters);
    options.mix = mix;
    options.scenario = heldAt({4425, 3075, 5000, flip, 5000});
    SimBench bench(options);
    bench.waitMs(50);
    QCOMPARE(bench.ask("87 07"), remapped);
}

// C-29
void TstSimChannels::remapped_isWhatTheMotorsAreTold()
{
    SimOptions options;
    options.mode = JumperMode::Rc;
    options.mix = true;
    options.scenario = heldAt({4000, 4425, 4700, 2500, 5000});
    SimBench bench(options);
    bench.waitMs(100);
    const QByteArray values = QByteArray::fromHex(bench.ask("87 07"));
    const auto speed = [&](int i) {
        const int raw = static_cast<std::uint8_t>(values[i]);
        return (raw & 0x80) != 0 ? -(raw & 0x7F) : raw;
    };
    QVERIFY(speed(0) < 0);
    QCOMPARE(bench.output(MotorId::Motor1).speed, speed(0));
    QCOMPARE(bench.output(MotorId::Motor2).speed, speed(1));
    QCOMPARE(bench.output(MotorId::Aux).speed, speed(2));
}

// C-28: facts.md 2, 0x05
void TstSimChannels::deadbandBrake_actsAtRest()
{
    SimOptions options = withParameters({{0x05, 100}, {0x06, 0}});
    options.mode = JumperMode::Rc;
    options.scenario = heldAt({3750, 3750, 3750, 5000, 5000});
    SimBench bench(options);
    bench.waitMs(100);
    QCOMPARE(bench.output(MotorId::Motor1), (MotorOutput{0, 100}));
    QCOMPARE(bench.output(MotorId::Motor2), (MotorOutput{0, 0}));
}

// C-19, C-64
void TstSimChannels::switches_turnAtMinus64()
{
    SimOptions options;
    options.mode = JumperMode::Rc;
    // −63: 3650 − 63 × 1150 / 127 = 3079.5; −64: 3070.5
    options.scenario = heldAt({3750, 3750, 3750, 5000, 3075});
    SimBench bench(options);
    bench.waitMs(100);
    QCOMPARE(bench.askByte("87 10"), 0x80 | 63);
    QCOMPARE(bench.askByte("83"), 0);
    bench.line.setInput(held(5, 3070));
    bench.waitMs(50);
    QCOMPARE(bench.askByte("87 10"), 0x80 | 64);
    QCOMPARE(bench.askByte("83"), 1);
    ChannelWave gone = held(5, 0);
    gone.wave = Wave::Missing; // an invalid channel is off
    bench.line.setInput(gone);
    bench.waitMs(200);
    QCOMPARE(bench.askByte("83"), 0);
}

// C-68
void TstSimChannels::requiredChannel_missingStopsTheMotors()
{
    SimOptions options;
    options.mode = JumperMode::Rc;
    options.scenario = heldAt({4425, 4425, 3750, 5000, 5000});
    ChannelWave gone = held(1, 0, 1.0);
    gone.wave = Wave::Missing;
    gone.to = 3.0;
    options.scenario.channels.push_back(gone);
    SimBench bench(options);
    bench.waitMs(1400); // invalid since 1.1 s
    QCOMPARE(bench.output(MotorId::Motor2).speed, 63);
    bench.waitMs(300);
    QCOMPARE(bench.output(MotorId::Motor1), (MotorOutput{0, 0}));
    QCOMPARE(bench.output(MotorId::Motor2), (MotorOutput{0, 0}));
    bench.waitMs(1400);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 63);
    QCOMPARE(bench.output(MotorId::Motor2).speed, 63);
}

// C-68: facts.md 2, 0x02
void TstSimChannels::ignoredChannel_restsAndIsNotRequired()
{
    SimOptions options = withParameters({{0x02, 0x01}});
    options.mode = JumperMode::Rc;
    options.scenario = heldAt({0, 4425, 3750, 5000, 5000});
    options.scenario.channels[0].wave = Wave::Missing;
    SimBench bench(options);
    bench.waitMs(1000);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    QCOMPARE(bench.output(MotorId::Motor2).speed, 63);
}

// C-68: the other way, facts.md 5.5
void TstSimChannels::safeStart_byQuirk()
{
    SimOptions options;
    QVERIFY(options.applyQuirk(QStringLiteral("safe-start=on")));
    options.mode = JumperMode::Rc;
    options.scenario = heldAt({4425, 3750, 3750, 5000, 5000});
    SimBench bench(options);
    bench.waitMs(1000);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    bench.line.setInput(held(1, 3750));
    bench.waitMs(100);
    bench.line.setInput(held(1, 4425));
    bench.waitMs(100);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 63);
    bench.line.powerCycle(bench.now());
    bench.waitMs(500);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
}

// C-68, C-19
void TstSimChannels::safeStart_holdsSerialOverride()
{
    SimOptions options;
    QVERIFY(options.applyQuirk(QStringLiteral("safe-start=on")));
    options.mode = JumperMode::Rc;
    options.scenario = heldAt({3750, 3750, 3750, 5000, 2500});
    SimBench bench(options);
    bench.waitMs(500);
    QCOMPARE(bench.askByte("83"), 0);
    bench.tell("C2 40");
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    bench.line.setInput(held(5, 5000));
    bench.waitMs(100);
    bench.line.setInput(held(5, 2500));
    bench.waitMs(100);
    QCOMPARE(bench.askByte("83"), 1);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0x40);
}

// C-24, C-26
void TstSimChannels::updateRate_isFiftyHertz()
{
    for (const JumperMode mode : {JumperMode::Rc, JumperMode::Analog}) {
        SimOptions options;
        options.mode = mode;
        ChannelWave noise;
        noise.wave = Wave::Noise;
        options.scenario.channels.push_back(noise);
        SimBench bench(options);
        bench.waitMs(100);
        int changes = 0;
        QByteArray last;
        for (int ms = 0; ms < 1000; ++ms) {
            const QByteArray reply = bench.ask("86 01", 1);
            changes += reply != last ? 1 : 0;
            last = reply;
        }
        QVERIFY2(changes >= 47 && changes <= 51, qPrintable(QString::number(changes)));
    }
}

QTEST_GUILESS_MAIN(TstSimChannels)
#include "tst_simchannels.moc"
