// SPDX-License-Identifier: GPL-3.0-or-later
#include "simbench.h"

#include <QElapsedTimer>
#include <QTest>

using namespace trex;
using namespace trex::sim;
using namespace std::chrono_literals;

class TstSimLine : public QObject {
    Q_OBJECT
private slots:
    void pace_isTheByteTime_data();
    void pace_isTheByteTime();
    void nextByteAt_leadsToEachByte();
    void controller_isDeafWhileItSends();
    void echo_comesBackFirst();
    void wrongSpeed_isGarbage_data();
    void wrongSpeed_isGarbage();
    void wrongParity_isLatched();
    void oldFirmware_runsAtHalfTheSpeed_data();
    void oldFirmware_runsAtHalfTheSpeed();
    void baudRates_areThoseOfTheList_data();
    void baudRates_areThoseOfTheList();
    void faults_followFromTheSeed_data();
    void faults_followFromTheSeed();
    void delay_postponesReplies();
    void hostBytes_areHarmedOnTheirWay_data();
    void hostBytes_areHarmedOnTheirWay();
    void unplugged_hearsAndSaysNothing();
    void silence_hasAnEnd();
    void hangUp_comesAndGoes();
    void brownOut_losesRamOnly();
    void devices_areToldApart();
    void devices_answerTogether();
    void events_happenInTime();
    void virtualTime_isMuchFasterThanReal();
};

// C-53, C-37: eleven, ten or twelve bits a byte
void TstSimLine::pace_isTheByteTime_data()
{
    QTest::addColumn<ErrorDetection>("detection");
    QTest::addColumn<int>("stopBits");
    QTest::addColumn<int>("bits");
    QTest::newRow("8N1") << ErrorDetection::None << 1 << 10;
    QTest::newRow("8N2") << ErrorDetection::None << 2 << 11;
    QTest::newRow("8E1") << ErrorDetection::Even << 1 << 11;
    QTest::newRow("8O2") << ErrorDetection::Odd << 2 << 12;
}

void TstSimLine::pace_isTheByteTime()
{
    QFETCH(ErrorDetection, detection);
    QFETCH(int, stopBits);
    QFETCH(int, bits);
    SimOptions options;
    options.pace = true;
    options.baud = 1200;
    options.errorDetection = detection;
    options.stopBits = stopBits;
    SimBench bench(options);
    bench.line.setHostLine(HostLine{1200, detection, stopBits});
    const Duration byteTime = 1'000'000'000ns * bits / 1200;
    bench.tell("81"); // one byte there, nine back
    bench.wait(10 * byteTime - 1ms);
    QCOMPARE(bench.line.read(bench.now()).size(), 8);
    bench.wait(2ms);
    QCOMPARE(bench.line.read(bench.now()).size(), 1);
}

void TstSimLine::nextByteAt_leadsToEachByte()
{
    SimOptions options;
    options.pace = true;
    SimBench bench(options);
    QVERIFY(!bench.line.nextByteAt());
    bench.tell("AF 07 05 55 2A");
    QByteArray reply;
    int looks = 0;
    while (const auto next = bench.line.nextByteAt()) {
        QVERIFY(++looks < 20);
        reply += bench.line.read(*next);
    }
    QCOMPARE(reply, QByteArray(1, '\0'));
}

// C-11
void TstSimLine::controller_isDeafWhileItSends()
{
    SimOptions options;
    options.pace = true;
    SimBench bench(options);
    bench.tell("81");
    bench.waitMs(2); // it sends since about 0.6 ms, for 4.7 ms
    bench.tell("C2 40"); // 1 ms
    bench.waitMs(1);
    QCOMPARE(bench.hear(20), QByteArray("545265584A72312E32"));
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    QCOMPARE(bench.askByte("85"), 0);
    bench.tell("C2 40");
    bench.waitMs(5);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0x40);
}

// C-12
void TstSimLine::echo_comesBackFirst()
{
    for (const bool pace : {false, true}) {
        SimOptions options;
        options.echo = true;
        options.pace = pace;
        SimBench bench(options);
        QCOMPARE(bench.ask("80 07 02"), QByteArray("80070272"));
        QCOMPARE(bench.ask("C2 00"), QByteArray("C200"));
        QCOMPARE(bench.ask("FF"), QByteArray("FF"));
    }
}

// C-21, C-53: no automatic detection
void TstSimLine::wrongSpeed_isGarbage_data()
{
    QTest::addColumn<int>("baud");
    for (const int baud : {1200, 9600, 14400, 28800, 57600, 115200}) {
        QTest::addRow("%d", baud) << baud;
    }
}

void TstSimLine::wrongSpeed_isGarbage()
{
    QFETCH(int, baud);
    for (const bool pace : {false, true}) {
        SimOptions options;
        options.pace = pace;
        SimBench bench(options);
        bench.line.setHostLine(HostLine{baud});
        for (int i = 0; i < 20; ++i) {
            QVERIFY(!bench.ask("81", 100).contains("545265584A72312E32"));
        }
        // At 115200 the only zeros of 0x81 are too short to be noticed at 19200.
        QCOMPARE(bench.device().firmware().uartErrorByte() != 0, baud != 115200);
        bench.line.setHostLine(HostLine{19200});
        bench.waitMs(100);
        QCOMPARE(bench.ask("01 81", 100), QByteArray("545265584A72312E32"));
    }
}

// C-21, C-53
void TstSimLine::wrongParity_isLatched()
{
    SimOptions options;
    options.errorDetection = ErrorDetection::Even;
    SimBench bench(options);
    bench.line.setHostLine(HostLine{19200, ErrorDetection::Odd});
    bench.tell("81");
    bench.waitMs(50);
    QCOMPARE(bench.device().firmware().uartErrorByte(), 0x04);
    bench.line.setHostLine(HostLine{19200, ErrorDetection::None}); // 0x81: the stop bit reads as
    bench.tell("C1"); // parity 1; even parity of three ones is 1, so the stop bit is what follows
    bench.waitMs(50);
    bench.line.setHostLine(HostLine{19200, ErrorDetection::Even});
    QCOMPARE(bench.askByte("84", 20), 0x01);
    QCOMPARE(bench.askByte("85", 20) & 0x04, 0x04);
    QCOMPARE(bench.ask("81"), QByteArray("545265584A72312E32"));
}

// C-53: facts.md 1
void TstSimLine::oldFirmware_runsAtHalfTheSpeed_data()
{
    QTest::addColumn<QString>("firmware");
    QTest::addColumn<int>("set");
    QTest::addColumn<int>("real");
    QTest::newRow("1.1 at 38400") << "1.1" << 38400 << 19200;
    QTest::newRow("1.0 at 28800") << "1.0" << 28800 << 14400;
    QTest::newRow("1.1 at 57600") << "1.1" << 57600 << 57600;
    QTest::newRow("1.2 at 38400") << "1.2" << 38400 << 38400;
}

void TstSimLine::oldFirmware_runsAtHalfTheSpeed()
{
    QFETCH(QString, firmware);
    QFETCH(int, set);
    QFETCH(int, real);
    SimOptions options;
    QVERIFY(options.applyFirmware(firmware));
    options.baud = set;
    SimBench bench(options);
    bench.line.setHostLine(HostLine{real});
    QCOMPARE(bench.askByte("82", 20), 'r');
}

// C-53, C-59
void TstSimLine::baudRates_areThoseOfTheList_data()
{
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("baud");
    int index = 0;
    for (const int baud :
         {1200, 2400, 4800, 9600, 14400, 19200, 28800, 38400, 57600, 76800, 115200}) {
        QTest::addRow("%d", baud) << index++ << baud;
    }
}

void TstSimLine::baudRates_areThoseOfTheList()
{
    QFETCH(int, index);
    QFETCH(int, baud);
    SimBench bench(withParameters({{0x7E, index}}));
    bench.line.setHostLine(HostLine{baud});
    QCOMPARE(bench.askByte("82", 50), 'r');
}

void TstSimLine::faults_followFromTheSeed_data()
{
    QTest::addColumn<QString>("fault");
    QTest::newRow("drop") << "drop=0.2";
    QTest::newRow("corrupt") << "corrupt=0.2";
    QTest::newRow("duplicate") << "duplicate=0.2";
    QTest::newRow("garbage") << "garbage=3";
}

void TstSimLine::faults_followFromTheSeed()
{
    QFETCH(QString, fault);
    const auto play = [&](quint64 seed) {
        SimOptions options;
        options.seed = seed;
        [&] { QVERIFY(options.applyFault(fault)); }();
        SimBench bench(options);
        QByteArrayList replies;
        for (int i = 0; i < 200; ++i) {
            replies.append(bench.ask("81", 5));
        }
        return replies;
    };
    const QByteArrayList first = play(1);
    QCOMPARE(play(1), first);
    QVERIFY(play(2) != first);
    const QByteArray good("545265584A72312E32");
    const auto whole = first.count(good);
    QVERIFY2(whole > 5 && whole < 195, qPrintable(QString::number(whole)));
    int longer = 0;
    int shorter = 0;
    for (const auto& reply : first) {
        longer += reply.size() > good.size() ? 1 : 0;
        shorter += reply.size() < good.size() ? 1 : 0;
        if (fault.startsWith(QLatin1String("garbage"))) {
            QVERIFY(reply.endsWith(good));
        }
    }
    const bool loses = fault.startsWith(QLatin1String("drop"));
    const bool keepsLength = fault.startsWith(QLatin1String("corrupt"));
    QCOMPARE(shorter > 0, loses);
    QCOMPARE(longer > 0, !loses && !keepsLength);
}

void TstSimLine::delay_postponesReplies()
{
    SimOptions options;
    QVERIFY(options.applyFault(QStringLiteral("delay=40")));
    SimBench bench(options);
    QCOMPARE(bench.ask("82", 40), QByteArray());
    QCOMPARE(bench.hear(1), QByteArray("72"));
}

void TstSimLine::hostBytes_areHarmedOnTheirWay_data()
{
    QTest::addColumn<QString>("fault");
    QTest::newRow("drop-sent") << "drop-sent=0.2";
    QTest::newRow("corrupt-sent") << "corrupt-sent=0.2";
    QTest::newRow("repeat-sent") << "repeat-sent=0.2";
}

void TstSimLine::hostBytes_areHarmedOnTheirWay()
{
    QFETCH(QString, fault);
    SimOptions options;
    QVERIFY(options.applyFault(fault));
    SimBench bench(options);
    int good = 0;
    int silent = 0;
    int twice = 0;
    for (int i = 0; i < 400; ++i) { // whole answers, but not always to the question
        const QByteArray reply = bench.ask("82", 5);
        good += reply == "72" ? 1 : 0;
        silent += reply.isEmpty() ? 1 : 0;
        twice += reply == "7272" ? 1 : 0;
    }
    QVERIFY2(good > 240 && good < 400, qPrintable(QString::number(good)));
    QCOMPARE(twice > 40, fault.startsWith(QLatin1String("repeat")));
    QCOMPARE(silent > 40, !fault.startsWith(QLatin1String("repeat")));
}

void TstSimLine::unplugged_hearsAndSaysNothing()
{
    SimOptions options;
    options.devices = {7, 7};
    QVERIFY(options.applyFault(QStringLiteral("unplugged=1")));
    SimBench bench(options);
    bench.device(1).setParameter(0x13, 0x0F);
    bench.device(0).setParameter(0x13, 0x3C);
    QCOMPARE(bench.askByte("80071F13"), 0x3C);
    bench.tell("C240");
    QCOMPARE(bench.device(1).output(MotorId::Motor1).speed, 0);
    bench.line.setFaults({}, bench.now());
    QCOMPARE(bench.askByte("80071F13"), 0x0C); // joined by AND
    bench.tell("C240");
    QCOMPARE(bench.device(1).output(MotorId::Motor1).speed, 0x40);
}

void TstSimLine::silence_hasAnEnd()
{
    SimOptions options;
    QVERIFY(options.applyFault(QStringLiteral("silent-after=1")));
    QVERIFY(options.applyFault(QStringLiteral("silent-for=2")));
    SimBench bench(options);
    QCOMPARE(bench.askByte("82", 900), 'r');
    bench.waitMs(200);
    QCOMPARE(bench.askByte("82", 900), -1);
    bench.tell("C2 40"); // mute, not deaf
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0x40);
    bench.waitMs(1100);
    QCOMPARE(bench.askByte("82"), 'r');
}

void TstSimLine::hangUp_comesAndGoes()
{
    SimOptions options;
    QVERIFY(options.applyFault(QStringLiteral("hangup-after=1")));
    QVERIFY(options.applyFault(QStringLiteral("hangup-for=2")));
    SimBench bench(options);
    QVERIFY(!bench.line.isHungUp(bench.now()));
    bench.waitMs(1100);
    QVERIFY(bench.line.isHungUp(bench.now()));
    bench.tell("C2 40");
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    bench.waitMs(2000);
    QVERIFY(!bench.line.isHungUp(bench.now()));
    QCOMPARE(bench.ask("82"), QByteArray("72"));
}

// C-20, C-40
void TstSimLine::brownOut_losesRamOnly()
{
    SimOptions options = withParameters({{0x07, 99}});
    QVERIFY(options.applyFault(QStringLiteral("reset-after=1")));
    SimBench bench(options);
    bench.tell("C2 40 88");
    bench.waitMs(900);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0x40);
    bench.waitMs(200);
    QCOMPARE(bench.output(MotorId::Motor1).speed, 0);
    QCOMPARE(bench.askByte("85"), 0);
    QCOMPARE(bench.askByte("9F 07"), 99);
}

// C-05
void TstSimLine::devices_areToldApart()
{
    SimOptions options;
    options.devices = {7, 8};
    SimBench bench(options);
    bench.tell("80 08 42 20 80 07 42 30");
    QCOMPARE(bench.device(0).output(MotorId::Motor1).speed, 0x30);
    QCOMPARE(bench.device(1).output(MotorId::Motor1).speed, 0x20);
    QCOMPARE(bench.askByte("80 08 1F 00"), 8); // 0x9F of 0x00
    QCOMPARE(bench.askByte("80 07 1F 00"), 7);
    QCOMPARE(bench.askByte("80 07 05"), 0);
    QCOMPARE(bench.askByte("80 08 05"), 0);
}

// C-04: a compact packet is for all; outputs joined by AND
void TstSimLine::devices_answerTogether()
{
    for (const bool pace : {false, true}) {
        SimOptions options;
        options.pace = pace;
        options.devices = {7, 8};
        SimBench bench(options);
        QCOMPARE(bench.ask("81"), QByteArray("545265584A72312E32"));
        QCOMPARE(bench.ask("9F 00"), QByteArray("00")); // 7 AND 8
    }
}

void TstSimLine::events_happenInTime()
{
    const auto scenario = parseScenario(
        R"({"events":[{"t":2,"set":{"powerCycle":true}},{"t":1,"set":{"mode":"rc","mix":true,
            "parameter":{"serial-timeout":5},"stall1":true,"load2":0.5}},
            {"t":3,"fault":{"silent-for":1}}]})",
        QStringLiteral("test"));
    QVERIFY(scenario);
    SimOptions options;
    options.scenario = *scenario;
    SimBench bench(options);
    bench.tell("DA 7F 7F");
    QCOMPARE(bench.askByte("82", 900), 'r');
    QVERIFY(bench.device().revolutionsPerSecond(MotorId::Motor1) > 50);
    bench.waitMs(200);
    QCOMPARE(bench.askByte("82"), 'R');
    QCOMPARE(bench.askByte("9F 07"), 5);
    QCOMPARE(bench.device().revolutionsPerSecond(MotorId::Motor1), 0.0);
    bench.tell("88");
    bench.waitMs(1000);
    QCOMPARE(bench.askByte("85"), 0); // power-cycled
    bench.waitMs(1000);
    QCOMPARE(bench.askByte("82", 400), -1);
    bench.waitMs(600);
    QCOMPARE(bench.askByte("82"), 'R');
}

void TstSimLine::virtualTime_isMuchFasterThanReal()
{
    SimOptions options;
    options.pace = true;
    options.baud = 115200;
    SimBench bench(options);
    bench.tell("DA 40 60");
    constexpr int kSeconds = 60;
    constexpr int kQueries = 200;
    QElapsedTimer timer;
    timer.start();
    qsizetype bytes = 0;
    for (int i = 0; i < kSeconds * kQueries; ++i) {
        bench.tell("8F");
        bench.wait(5ms);
        bytes += bench.line.read(bench.now()).size();
    }
    const double factor = kSeconds / (static_cast<double>(timer.nsecsElapsed()) / 1e9);
    qInfo("%.0f times real time with %d queries a second", factor, kQueries);
    QCOMPARE(bytes, 2 * kSeconds * kQueries);
    QVERIFY(factor > 20); // generous: sanitizers, busy machines
}

QTEST_GUILESS_MAIN(TstSimLine)
#include "tst_simline.moc"
