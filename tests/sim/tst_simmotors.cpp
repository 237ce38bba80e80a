// SPDX-License-Identifier: GPL-3.0-or-later
#include "simbench.h"

#include <QTest>

using namespace trex;
using namespace trex::sim;

class TstSimMotors : public QObject {
    Q_OBJECT
private slots:
    void set_actsAtOnce_data();
    void set_actsAtOnce();
    void accelerate_gainsATenthEachUpdate();
    void accelerate_neverPassesItsTarget();
    void accelerate_ofZeroIsInfinite();
    void accelerate_slowsDownAtOnce();
    void reversal_brakesFirst();
    void reversal_bySetDoesNot();
    void aux_isSetAndAccelerated();
    void pwmMaximum_isFullScale();
    void storedCommands_waitForSerialOverride();
    void timeout_stopsOnceForEachSilence();
    void timeout_startsWithTheFirstByte();
    void timeout_clearsStoredCommands();
    void timeout_canBeIgnoredByQuirk();
    void uartErrorShutdown_stopsAndGoesOnObeying();
    void currentLimit_cutsBackAndReports();
    void currentLimit_withoutGainOnlyReports();
    void jointMode_drivesBothBridges();
    void motorReply_byQuirk();
};

// C-41, C-43, C-45, C-46
void TstSimMotors::set_actsAtOnce_data()
{
    QTest::addColumn<QByteArray>("sent");
    QTest::addColumn<int>("speed1");
    QTest::addColumn<int>("brake1");
    QTest::addColumn<int>("speed2");
    QTest::addColumn<int>("brake2");
    QTest::newRow("C0 brakes") << QByteArray("C0 40") << 0 << 64 << 0 << 0;
    QTest::newRow("C1 reverse") << QByteArray("C1 40") << -64 << 0 << 0 << 0;
    QTest::newRow("C2 forward") << QByteArray("C2 7F") << 127 << 0 << 0 << 0;
    QTest::newRow("C3 brakes") << QByteArray("C3 7F") << 0 << 127 << 0 << 0;
    QTest::newRow("C0 0 coasts") << QByteArray("C2 10 C0 00") << 0 << 0 << 0 << 0;
    QTest::newRow("C8 brakes") << QByteArray("C8 01") << 0 << 0 << 0 << 1;
    QTest::newRow("C9 reverse") << QByteArray("C9 02") << 0 << 0 << -2 << 0;
    QTest::newRow("CA forward") << QByteArray("CA 03") << 0 << 0 << 3 << 0;
    QTest::newRow("CB brakes") << QByteArray("CB 04") << 0 << 0 << 0 << 4;
    QTest::newRow("D6: 1 forward, 2 reverse") << QByteArray("D6 10 20") << 16 << 0 << -32 << 0;
    QTest::newRow("D9: 1 reverse, 2 forward") << QByteArray("D9 10 20") << -16 << 0 << 32 << 0;
    QTest::newRow("DF brakes both") << QByteArray("DF 10 20") << 0 << 16 << 0 << 32;
}

void TstSimMotors::set_actsAtOnce()
{
    QFETCH(QByteArray, sent);
    QFETCH(int, speed1);
    QFETCH(int, brake1);
    QFETCH(int, speed2);
    QFETCH(int, brake2);
    SimBench bench(withParameters({{0x0E, 1}, {0x0F, 1}, {0x11, 50}, {0x12, 50}}));
    bench.tell(sent.constData());
    QCOMPARE(bench.output(MotorId::Motor1), (MotorOutput{speed1, brake1}));
    QCOMPARE(bench.output(MotorId::Motor2), (MotorOutput{speed2, brake2}));
    QCOMPARE(bench.hear(), QByteArray());
    QCOMPARE(bench.output(MotorId::Motor1), (MotorOutput{speed1, brake1}));
}

// C-42, C-44, C-47
void TstSimMotors::accelerate_gainsATenthEachUpdate()
{
    SimBench bench(withParameters({{0x0E, 20}, {0x0F, 5}}));
    bench.tell("E6 64 64"); // 1 forward, 2 reverse, to 100
    for (int update = 1; update <= 20; ++update) {
        bench.waitMs(10);
        QCOMPARE(bench.output(MotorId::Motor1).speed, 2 * update);
        QCOMPARE(bench.output(MotorId::Motor2).speed, -(update / 2));
    }
}

// C-47
void TstSimMotors::accelerate_neverPassesItsTarget()
{
    SimBench bench(withParameters({{0x0E, 127}}));
    bench.tell("C6 0F");
    bench.waitMs(10);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 12);
    bench.waitMs(10);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 15);
    bench.waitMs(100);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 15);
}

// C-47
void TstSimMotors::accelerate_ofZeroIsInfinite()
{
    SimBench bench;
    bench.tell("CD 7F");
    QCOMPARE(bench.output(MotorId::Motor2).speed, 0);
    bench.waitMs(10);
    QCOMPARE(bench.output(MotorId::Motor2).speed, -127);
}

// C-47: there is no deceleration
void TstSimMotors::accelerate_slowsDownAtOnce()
{
    SimBench bench(withParameters({{0x0E, 1}}));
    bench.tell("C2 7F C6 05");
    bench.waitMs(10);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 5);
}

// C-48
void TstSimMotors::reversal_brakesFirst()
{
    SimBench bench(withParameters({{0x0E, 100}, {0x11, 5}}));
    bench.tell("C2 7F");
    bench.waitMs(20);
    bench.tell("C5 64");
    QCOMPARE(bench.output(MotorId::Motor1).speed, 127);
    for (int update = 0; update < 5; ++update) {
        bench.waitMs(10);
        QCOMPARE(bench.output(MotorId::Motor1), (MotorOutput{0, 127}));
    }
    bench.waitMs(10);
    QCOMPARE(bench.output(MotorId::Motor1).speed, -10);
    bench.waitMs(10);
    QCOMPARE(bench.output(MotorId::Motor1).speed, -20);
}

// C-41, C-48: "set" is at once
void TstSimMotors::reversal_bySetDoesNot()
{
    SimBench bench(withParameters({{0x11, 50}}));
    bench.tell("C2 7F");
    bench.waitMs(20);
    bench.tell("C1 7F");
    QCOMPARE(bench.output(MotorId::Motor1).speed, -127);
    bench.waitMs(50);
    QCOMPARE(bench.output(MotorId::Motor1).speed, -127);
}

// C-45
void TstSimMotors::aux_isSetAndAccelerated()
{
    SimBench bench(withParameters({{0x10, 50}}));
    bench.tell("F0 7F");
    QCOMPARE(bench.output(MotorId::Aux).speed, 127);
    bench.tell("F0 00 F1 64");
    bench.waitMs(30);
    QCOMPARE(bench.output(MotorId::Aux).speed, 15);
    QCOMPARE(bench.hear(), QByteArray());
}

// C-41: the PWM maximum is the full scale of the speed number (facts.md 2)
void TstSimMotors::pwmMaximum_isFullScale()
{
    SimBench bench(withParameters({{0x0B, 64}}));
    bench.tell("DA 40 40");
    bench.waitMs(2000);
    const double full = bench.device().revolutionsPerSecond(MotorId::Motor1);
    const double half = bench.device().revolutionsPerSecond(MotorId::Motor2);
    QVERIFY(full > 1.8 * half);
}

// C-50
void TstSimMotors::storedCommands_waitForSerialOverride()
{
    SimOptions options;
    options.mode = JumperMode::Rc;
    options.scenario = heldAt({3750, 3750, 3750, 5000, 5000});
    SimBench bench(options);
    bench.waitMs(200);
    bench.tell("C2 20 CE 30 C2 40 F0 10");
    bench.waitMs(100);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    bench.line.setInput(held(5, 2500));
    bench.waitMs(60);
    QCOMPARE(bench.askByte("83"), 1);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0x40); // the most recent one
    QCOMPARE(bench.output(MotorId::Motor2).speed, 0x30);
    QCOMPARE(bench.output(MotorId::Aux).speed, 0x10);
    bench.line.setInput(held(5, 5000));
    bench.waitMs(60);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
}

// C-51, C-62
void TstSimMotors::timeout_stopsOnceForEachSilence()
{
    SimBench bench(withParameters({{0x07, 5}}));
    bench.tell("DA 40 40 F0 40");
    bench.waitMs(498);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0x40);
    bench.waitMs(4);
    for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
        QCOMPARE(bench.output(motor), (MotorOutput{0, 0}));
    }
    QCOMPARE(bench.device().firmware().uartErrorByte(), 0x80);
    bench.waitMs(2000);
    QCOMPARE(bench.askByte("84"), 0x01);
    QCOMPARE(bench.askByte("85"), 0x80);
    QCOMPARE(bench.askByte("85"), 0x00);
    bench.waitMs(600); // silent again
    QCOMPARE(bench.askByte("85"), 0x80);
}

// C-62
void TstSimMotors::timeout_startsWithTheFirstByte()
{
    SimBench bench(withParameters({{0x07, 1}}));
    bench.waitMs(5000);
    QCOMPARE(bench.askByte("85"), 0x00);
}

// C-62
void TstSimMotors::timeout_clearsStoredCommands()
{
    SimOptions options = withParameters({{0x07, 2}});
    options.mode = JumperMode::Rc;
    options.scenario = heldAt({3750, 3750, 3750, 5000, 2500});
    SimBench bench(options);
    bench.waitMs(100);
    bench.tell("C2 40");
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0x40);
    bench.waitMs(300);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    bench.line.setInput(held(5, 5000));
    bench.waitMs(100);
    bench.line.setInput(held(5, 2500));
    bench.waitMs(100);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    QCOMPARE(bench.askByte("83"), 1);
}

// C-51
void TstSimMotors::timeout_canBeIgnoredByQuirk()
{
    SimOptions options = withParameters({{0x07, 1}});
    QVERIFY(options.applyQuirk(QStringLiteral("serial-timeout=off")));
    SimBench bench(options);
    bench.tell("C2 40");
    bench.waitMs(1000);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0x40);
}

// C-52, C-62
void TstSimMotors::uartErrorShutdown_stopsAndGoesOnObeying()
{
    SimBench off;
    off.tell("C2 40 88");
    QCOMPARE(off.output(MotorId::Motor1).speed, 0x40);

    SimBench on(withParameters({{0x08, 1}}));
    on.tell("DA 40 40 F0 40 88");
    QCOMPARE(on.output(MotorId::Motor1).speed, 0);
    QCOMPARE(on.output(MotorId::Motor2).speed, 0);
    QCOMPARE(on.output(MotorId::Aux).speed, 0);
    on.tell("C2 30");
    QCOMPARE(on.output(MotorId::Motor1).speed, 0x30);
    on.tell("C2 C2 31"); // C-08: the error stops, then the new packet is obeyed
    QCOMPARE(on.output(MotorId::Motor1).speed, 0x31);
}

// C-66
void TstSimMotors::currentLimit_cutsBackAndReports()
{
    // 25 is 50 counts, 2 A; P 5
    SimBench bench(withParameters({{0x13, 25}, {0x15, 5}, {0x0E, 50}}));
    bench.line.setStall(1, true);
    bench.tell("C6 7F");
    bench.waitMs(3000);
    const int limited = bench.askByte("8D");
    QVERIFY2(limited > 25 && limited < 70, qPrintable(QString::number(limited)));
    QCOMPARE(bench.askByte("84") & 0xF0, 0x20);
    bench.tell("C2 7F"); // for the moment, "set" overrides
    QCOMPARE(bench.output(MotorId::Motor1).speed, 127);
    bench.waitMs(500);
    QVERIFY(bench.output(MotorId::Motor1).speed < 100);

    SimBench free;
    free.line.setStall(1, true);
    free.tell("C6 7F");
    free.waitMs(1000);
    QVERIFY(free.askByte("8D") > 130);
    QCOMPARE(free.askByte("84"), 0);
}

// C-66
void TstSimMotors::currentLimit_withoutGainOnlyReports()
{
    SimBench bench(withParameters({{0x14, 25}, {0x16, 0}}));
    bench.line.setStall(2, true);
    bench.tell("CE 7F");
    bench.waitMs(1000);
    QCOMPARE(bench.output(MotorId::Motor2).speed, 127);
    QCOMPARE(bench.askByte("84"), 0x80);
}

// C-31, C-67
void TstSimMotors::jointMode_drivesBothBridges()
{
    SimBench bench(withParameters({{0x7B, 1}}));
    bench.tell("C2 40 CA 20");
    bench.waitMs(500);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0x40);
    QCOMPARE(bench.output(MotorId::Motor2).speed, 0x40);
    bench.tell("D5 10 7F");
    QCOMPARE(bench.output(MotorId::Motor2).speed, -0x10);
    bench.waitMs(500);
    QCOMPARE(bench.ask("8F"), QByteArray("0000"));
}

// C-46: what one user saw (facts.md 4)
void TstSimMotors::motorReply_byQuirk()
{
    SimOptions options;
    QVERIFY(options.applyQuirk(QStringLiteral("motor-reply=ff")));
    SimBench bench(options);
    QCOMPARE(bench.ask("C2 40"), QByteArray("FF"));
}

QTEST_GUILESS_MAIN(TstSimMotors)
#include "tst_simmotors.moc"
