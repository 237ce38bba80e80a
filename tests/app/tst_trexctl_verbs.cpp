// SPDX-License-Identifier: GPL-3.0-or-later
// Every command of contracts/cli.md that asks or tells once: fields, values, exit codes.
#include "tests/app/commandrunner.h"

#include <QFile>
#include <QTest>

using namespace Qt::Literals::StringLiterals;

namespace {

/// The fields of an object, sorted: a contract names them, no more and no fewer.
QStringList keys(const QJsonObject& object)
{
    return object.keys();
}

QStringList ask(const Simulator& simulator, const QString& command)
{
    return QStringList{u"--port"_s, simulator.port(), u"--json"_s} + words(command);
}

} // namespace

class tst_trexctl_verbs : public QObject {
    Q_OBJECT

private slots:
    void info_tellsTheController();
    void info_tellsADmc01();
    void status_tellsBothBytesAndClears();
    void channels_tellRcAndInvalidPulses();
    void channels_tellVolts();
    void currents_scaleByModel();
    void currents_saySoInJointMode();
    void calibration_setIsReadBack();
    void calibration_otherByteOrderIsRecognised();
    void calibration_isRefusedOutsideSerialMode();
    void motor_sends_data();
    void motor_sends();
    void motor_isPendingWhenSerialIsNotInControl();
    void motor_keepsRunningAfterTheEnd();
    void stop_stopsAllThree();
    void raw_sendsAsGiven();
    void raw_frames();
    void ports_isAnArray();
    void text_isForPeople();
};

void tst_trexctl_verbs::info_tellsTheController()
{
    Simulator simulator;
    QVERIFY(simulator.isReady());
    const Finished done = run(ask(simulator, u"info"_s)); // C-17, C-18, C-19, C-33
    QCOMPARE(done.code, 0);
    QVERIFY2(done.err.isEmpty(), done.err);
    const QJsonObject info = done.object();
    QCOMPARE(keys(info),
             (QStringList{u"baud"_s, u"calibratedChannels"_s, u"device"_s, u"echo"_s,
                          u"errorDetection"_s, u"firmware"_s, u"mode"_s, u"modeByte"_s, u"model"_s,
                          u"protocol"_s, u"serialControlsMotors"_s, u"signature"_s}));
    QCOMPARE(info["signature"_L1], "TReXJr1.2"_L1);
    QCOMPARE(info["model"_L1], "TReX Jr"_L1);
    QCOMPARE(info["firmware"_L1], "1.2"_L1);
    QCOMPARE(info["mode"_L1], "serial-rc"_L1);
    QCOMPARE(info["modeByte"_L1], "r"_L1);
    QCOMPARE(info["serialControlsMotors"_L1], true);
    QCOMPARE(info["calibratedChannels"_L1].toArray(), QJsonArray());
    QCOMPARE(info["baud"_L1], 19200);
    QCOMPARE(info["device"_L1], 7);
    QCOMPARE(info["protocol"_L1], "compact"_L1);
    QCOMPARE(info["errorDetection"_L1], "none"_L1);
    QCOMPARE(info["echo"_L1], false);
    // Options after the command are as good.
    QCOMPARE(run({u"--port"_s, simulator.port(), u"info"_s, u"--json"_s}).out, done.out);
    QCOMPARE(simulator.stop().code, 0);
    QVERIFY(!QFile::exists(simulator.port()));
}

void tst_trexctl_verbs::info_tellsADmc01()
{
    Simulator simulator({u"--model"_s, u"trex"_s});
    const Finished done = run(ask(simulator, u"info"_s)); // C-70
    QCOMPARE(done.code, 0);
    QCOMPARE(done.object()["signature"_L1], "TReX1.2"_L1);
    QCOMPARE(done.object()["model"_L1], "TReX"_L1);
}

void tst_trexctl_verbs::status_tellsBothBytesAndClears()
{
    Simulator simulator;
    QCOMPARE(run(ask(simulator, u"raw 96"_s)).code, 0); // no such command: format error (C-07)
    const Finished first = run(ask(simulator, u"status"_s)); // C-20, C-21
    QCOMPARE(first.code, 0);
    const QJsonObject status = first.object()["status"_L1].toObject();
    const QJsonObject uart = first.object()["uartError"_L1].toObject();
    QCOMPARE(keys(status),
             (QStringList{u"byte"_s, u"motor1Fault"_s, u"motor1OverCurrent"_s, u"motor2Fault"_s,
                          u"motor2OverCurrent"_s, u"uartError"_s}));
    QCOMPARE(keys(uart),
             (QStringList{u"byte"_s, u"crc"_s, u"format"_s, u"frame"_s, u"overrun"_s, u"parity"_s,
                          u"readBufferOverrun"_s, u"sendBufferOverrun"_s, u"timeout"_s}));
    QCOMPARE(status["byte"_L1], 1);
    QCOMPARE(status["uartError"_L1], true);
    QCOMPARE(status["motor1Fault"_L1], false);
    QCOMPARE(uart["byte"_L1], 0x40);
    QCOMPARE(uart["format"_L1], true);
    QCOMPARE(uart["crc"_L1], false);
    const QJsonObject second = run(ask(simulator, u"status"_s)).object();
    QCOMPARE(second["status"_L1].toObject()["byte"_L1], 0);
    QCOMPARE(second["uartError"_L1].toObject()["byte"_L1], 0);
}

void tst_trexctl_verbs::channels_tellRcAndInvalidPulses()
{
    QTemporaryDir folder;
    QFile scenario(folder.filePath(u"s.json"_s));
    QVERIFY(scenario.open(QIODevice::WriteOnly));
    scenario.write(R"({"channels":[{"channel":1,"wave":"hold","value":3637},
                                   {"channel":2,"wave":"missing"},
                                   {"channel":5,"wave":"hold","value":2715}]})");
    scenario.close();
    Simulator simulator({u"--scenario"_s, scenario.fileName()});
    QVERIFY(simulator.isReady());
    QTRY_COMPARE(run(ask(simulator, u"channels --mask 0x01"_s))
                     .object()["channels"_L1]
                     .toArray()[0]
                     .toObject()["raw"_L1],
                 3637); // C-25
    const QJsonObject reply = run(ask(simulator, u"channels --mask 0x13"_s)).object();
    QCOMPARE(keys(reply), (QStringList{u"channels"_s, u"input"_s, u"t"_s}));
    QCOMPARE(reply["input"_L1], "rc"_L1);
    const QJsonArray channels = reply["channels"_L1].toArray();
    QCOMPARE(channels.size(), 3);
    QCOMPARE(keys(channels[0].toObject()),
             (QStringList{u"channel"_s, u"microseconds"_s, u"raw"_s, u"remapped"_s, u"valid"_s}));
    QCOMPARE(channels[0]["channel"_L1], 1);
    QCOMPARE(channels[0]["valid"_L1], true);
    QCOMPARE(channels[0]["microseconds"_L1], 1454.8);
    QCOMPARE(channels[1]["channel"_L1], 2); // C-24: no value is made of an invalid pulse
    QCOMPARE(channels[1]["valid"_L1], false);
    QCOMPARE(channels[1]["raw"_L1], 65535);
    QVERIFY(channels[1]["microseconds"_L1].isUndefined());
    QCOMPARE(channels[2]["channel"_L1], 5);
    QCOMPARE(channels[2]["microseconds"_L1], 1086.0);
}

void tst_trexctl_verbs::channels_tellVolts()
{
    Simulator simulator({u"--param"_s, u"channel-input-source=1"_s});
    const QJsonObject reply = run(ask(simulator, u"channels"_s)).object(); // C-26
    QCOMPARE(reply["input"_L1], "analog"_L1);
    QCOMPARE(reply["channels"_L1].toArray().size(), 5);
    const QJsonObject first = reply["channels"_L1].toArray()[0].toObject();
    QVERIFY(!first.contains("microseconds"_L1));
    const double raw = first["raw"_L1].toDouble();
    QVERIFY(raw >= 0 && raw <= 1023);
    QVERIFY(qAbs(first["volts"_L1].toDouble() - raw * 5.0 / 1023.0) < 0.0001);
}

void tst_trexctl_verbs::currents_scaleByModel()
{
    for (const auto& [model, scale] : {std::pair{u"jr"_s, 0.04}, {u"trex"_s, 0.15}}) {
        Simulator simulator({u"--model"_s, model});
        QCOMPARE(run(ask(simulator, u"motor both set 100"_s)).code, 0);
        QJsonObject motor1;
        QTRY_VERIFY(
            (motor1 = run(ask(simulator, u"currents"_s)).object()["motor1"_L1].toObject())["raw"_L1]
                .toInt()
            > 0);
        QCOMPARE(keys(motor1), (QStringList{u"amperes"_s, u"raw"_s}));
        const double wanted = motor1["raw"_L1].toInt() * scale; // C-30, C-70
        QVERIFY(qAbs(motor1["amperes"_L1].toDouble() - wanted) < 1e-9);
        const Finished text = run({u"--port"_s, simulator.port(), u"currents"_s});
        QCOMPARE(text.out.contains("about"), model == "trex"_L1); // a guess is marked as one
    }
}

void tst_trexctl_verbs::currents_saySoInJointMode()
{
    Simulator simulator({u"--param"_s, u"motor-mode=1"_s});
    for (const QString& command : {u"currents"_s, u"currents --watch"_s}) {
        const Finished done = run(ask(simulator, command)); // C-31
        QCOMPARE(done.code, 0);
        QCOMPARE(keys(done.object()), (QStringList{u"available"_s, u"reason"_s, u"t"_s}));
        QCOMPARE(done.object()["available"_L1], false);
        QVERIFY(!done.object()["reason"_L1].toString().isEmpty());
    }
}

void tst_trexctl_verbs::calibration_setIsReadBack()
{
    Simulator simulator;
    const QJsonArray before = run(ask(simulator, u"calibration get"_s)).array();
    QCOMPARE(before.size(), 5); // C-32
    QCOMPARE(keys(before[0].toObject()),
             (QStringList{u"channel"_s, u"deadband"_s, u"input"_s, u"learned"_s, u"maximum"_s,
                          u"minimum"_s, u"neutral"_s}));
    QCOMPARE(before[2]["channel"_L1], 3);
    QCOMPARE(before[2]["input"_L1], "rc"_L1);
    QCOMPARE(before[2]["learned"_L1], false);
    const Finished set = run(ask(simulator, u"calibration set 3 2600 3650 0x1324 90"_s)); // C-35
    QCOMPARE(set.code, 0);
    QCOMPARE(set.object()["verified"_L1], true);
    QCOMPARE(set.object()["learned"_L1], true);
    const QJsonArray one = run(ask(simulator, u"calibration get 3"_s)).array();
    QCOMPARE(one.size(), 1);
    QCOMPARE(one[0]["minimum"_L1], 2600);
    QCOMPARE(one[0]["neutral"_L1], 3650);
    QCOMPARE(one[0]["maximum"_L1], 4900);
    QCOMPARE(one[0]["deadband"_L1], 90);
    QCOMPARE(one[0]["learned"_L1], true);
    QCOMPARE(run(ask(simulator, u"info"_s)).object()["calibratedChannels"_L1].toArray(),
             QJsonArray{3});
    QCOMPARE(run(ask(simulator, u"calibration get"_s)).array()[0], before[0]);
}

void tst_trexctl_verbs::calibration_otherByteOrderIsRecognised()
{
    Simulator simulator({u"--quirk"_s, u"calibration-bytes=8"_s}); // C-35
    const Finished done = run(ask(simulator, u"calibration set 1 2490 3700 5010 90"_s));
    QCOMPARE(done.code, 0);
    QCOMPARE(done.errLines().size(), 1);
    QVERIFY2(done.err.contains("256"), done.err);
    for (const auto& [key, wanted] :
         {std::pair{"minimum"_L1, 2490}, {"neutral"_L1, 3700}, {"maximum"_L1, 5010}}) {
        const int got = done.object()[key].toInt();
        QVERIFY2(qAbs(got - wanted) <= 64, qPrintable(QString::number(got)));
    }
    QCOMPARE(run(ask(simulator, u"calibration get 1"_s)).array()[0]["neutral"_L1],
             done.object()["neutral"_L1]);
}

void tst_trexctl_verbs::calibration_isRefusedOutsideSerialMode()
{
    Simulator simulator({u"--mode"_s, u"analog"_s});
    const Finished done = run(ask(simulator, u"calibration set 1 100 500 900 20"_s));
    QCOMPARE(done.code, 1);
    QVERIFY(done.out.isEmpty());
    QCOMPARE(done.errLines().size(), 1);
    QVERIFY2(done.err.contains("serial mode"), done.err);
    QCOMPARE(run(ask(simulator, u"calibration get 1"_s)).array()[0]["input"_L1], "analog"_L1);
}

void tst_trexctl_verbs::motor_sends_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("sent");
    QTest::addColumn<QJsonObject>("motors");
    const auto row = [](const char* command, const char* sent, const QByteArray& motors) {
        QTest::newRow(command) << QString::fromLatin1(command) << QString::fromLatin1(sent)
                               << QJsonDocument::fromJson(motors).object();
    };
    // C-41 to C-45
    row("motor 1 set 64", "C240", R"({"motor1":{"action":"set","speed":64}})");
    row("motor 1 set -0x7F", "C17F", R"({"motor1":{"action":"set","speed":-127}})");
    row("motor 1 set 0", "C200", R"({"motor1":{"action":"set","speed":0}})");
    row("motor 2 accelerate -5", "CD05", R"({"motor2":{"action":"accelerate","speed":-5}})");
    row("motor 2 brake 127", "C87F", R"({"motor2":{"action":"brake","duty":127}})");
    row("motor both set 40 -40", "D62828",
        R"({"motor1":{"action":"set","speed":40},"motor2":{"action":"set","speed":-40}})");
    row("motor both set 40", "DA2828",
        R"({"motor1":{"action":"set","speed":40},"motor2":{"action":"set","speed":40}})");
    row("motor both accelerate -1 2", "E90102",
        R"({"motor1":{"action":"accelerate","speed":-1},"motor2":{"action":"accelerate","speed":2}})");
    row("motor both brake 10 20", "D00A14",
        R"({"motor1":{"action":"brake","duty":10},"motor2":{"action":"brake","duty":20}})");
    row("motor aux set 127", "F07F", R"({"aux":{"action":"set","speed":127}})");
    row("motor aux accelerate 0x10", "F110", R"({"aux":{"action":"accelerate","speed":16}})");
}

void tst_trexctl_verbs::motor_sends()
{
    QFETCH(QString, command);
    QFETCH(QString, sent);
    QFETCH(QJsonObject, motors);
    static Simulator simulator;
    const qsizetype heardBefore = simulator.packets(u"motor"_s).size();
    const Finished done = run(ask(simulator, command));
    QVERIFY2(done.code == 0, done.err);
    QVERIFY2(done.err.isEmpty(), done.err);
    QCOMPARE(keys(done.object()), (QStringList{u"motors"_s, u"pending"_s, u"sent"_s}));
    QCOMPARE(done.object()["sent"_L1], sent);
    QCOMPARE(done.object()["motors"_L1].toObject(), motors);
    QCOMPARE(done.object()["pending"_L1], false);
    QTRY_COMPARE(simulator.packets(u"motor"_s).mid(heardBefore), QStringList{sent});
}

void tst_trexctl_verbs::motor_isPendingWhenSerialIsNotInControl()
{
    Simulator simulator({u"--mode"_s, u"rc"_s});
    const Finished done = run(ask(simulator, u"motor 1 set 64"_s)); // C-50
    QCOMPARE(done.code, 0);
    QCOMPARE(done.object()["pending"_L1], true);
    QCOMPARE(done.errLines().size(), 1);
    QVERIFY2(done.err.contains("waits"), done.err);
}

void tst_trexctl_verbs::motor_keepsRunningAfterTheEnd()
{
    Simulator simulator;
    QCOMPARE(run(ask(simulator, u"motor 1 accelerate 60"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"info"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"currents --duration 0.2"_s)).code, 0);
    QCOMPARE(simulator.packets(u"motor"_s), QStringList{u"C63C"_s}); // and nothing stopped it
}

void tst_trexctl_verbs::stop_stopsAllThree()
{
    Simulator simulator;
    const Finished stop = run(ask(simulator, u"stop"_s));
    QCOMPARE(stop.code, 0);
    QCOMPARE(stop.object()["sent"_L1], "DA0000F000"_L1);
    QCOMPARE(keys(stop.object()["motors"_L1].toObject()),
             (QStringList{u"aux"_s, u"motor1"_s, u"motor2"_s}));
    QCOMPARE(stop.object()["pending"_L1], false);
    const Finished brake = run(ask(simulator, u"stop --brake"_s));
    QCOMPARE(brake.object()["sent"_L1], "D07F7FF000"_L1);
    QCOMPARE(brake.object()["motors"_L1]["motor2"_L1]["duty"_L1], 127);
    QTRY_COMPARE(simulator.packets(u"motor"_s),
                 (QStringList{u"DA0000"_s, u"F000"_s, u"D07F7F"_s, u"F000"_s}));
    const Finished pololu = run(ask(simulator, u"--device 7 stop"_s));
    QCOMPARE(pololu.object()["sent"_L1], "80075A000080077000"_L1);
}

void tst_trexctl_verbs::raw_sendsAsGiven()
{
    Simulator simulator;
    const Finished done = run(ask(simulator, u"raw 81 --reply 9"_s));
    QCOMPARE(done.code, 0);
    QCOMPARE(done.object(),
             (QJsonObject{{u"sent"_s, u"81"_s}, {u"received"_s, u"545265584A72312E32"_s}}));
    // Left out, the command's own row says how much comes back.
    QCOMPARE(run(ask(simulator, u"raw 0x82"_s)).object()["received"_L1], "72"_L1);
    // C-55: the command's top bit not cleared is a format error, then a compact command.
    QCOMPARE(run(ask(simulator, u"raw 80 07 81 --reply 9"_s)).object()["received"_L1],
             "545265584A72312E32"_L1);
    QCOMPARE(
        run(ask(simulator, u"raw 861f --reply 10"_s)).object()["received"_L1].toString().size(),
        20);
    const Finished motor = run(ask(simulator, u"raw c2 40"_s));
    QCOMPARE(motor.object(), (QJsonObject{{u"sent"_s, u"C240"_s}, {u"received"_s, u""_s}}));
    QTRY_COMPARE(simulator.packets(u"motor"_s), QStringList{u"C240"_s});
    const Finished silent = run(ask(simulator, u"raw C2 40 --reply 1"_s)); // C-46
    QCOMPARE(silent.code, 3);
    QVERIFY(silent.out.isEmpty());
}

void tst_trexctl_verbs::raw_frames()
{
    Simulator simulator({u"--error-detection"_s, u"crc7"_s});
    // C-03, C-13, C-14: the published example
    const Finished compact =
        run(ask(simulator, u"--error-detection crc7 raw 86 1F --frame --reply 10"_s));
    QCOMPARE(compact.code, 0);
    QCOMPARE(compact.object()["sent"_L1], "861F07"_L1);
    QCOMPARE(compact.object()["received"_L1].toString().size(), 20); // without its CRC byte
    const Finished pololu =
        run(ask(simulator, u"--device 7 --error-detection crc7 raw 861F --frame"_s));
    QCOMPARE(pololu.object()["sent"_L1], "8007061F0B"_L1);
    QCOMPARE(pololu.object()["received"_L1].toString().size(), 20);
}

void tst_trexctl_verbs::ports_isAnArray()
{
    const Finished done = run({u"--json"_s, u"ports"_s});
    QCOMPARE(done.code, 0);
    QVERIFY(done.json().isArray());
    QVERIFY2(done.err.isEmpty(), done.err);
}

void tst_trexctl_verbs::text_isForPeople()
{
    Simulator simulator;
    for (const QString& command : {u"info"_s, u"status"_s, u"channels"_s, u"currents"_s, u"stop"_s,
                                   u"calibration get"_s, u"param list"_s, u"param get 7"_s}) {
        const Finished done = run(QStringList{u"--port"_s, simulator.port()} + words(command));
        QVERIFY2(done.code == 0, done.err);
        QVERIFY(done.out.endsWith('\n'));
        QVERIFY2(!done.out.contains('{') && done.out.size() > 10, done.out);
    }
    const Finished help = run({u"--help"_s});
    QCOMPARE(help.code, 0);
    for (const char* verb : {"record", "export", "run", "journal", "checkpoint"}) {
        QVERIFY2(help.out.contains(QByteArray("\n  ") + verb), verb);
    }
    QVERIFY(run({u"--version"_s}).out.startsWith("trexctl "));
}

QTEST_GUILESS_MAIN(tst_trexctl_verbs)
#include "tst_trexctl_verbs.moc"
