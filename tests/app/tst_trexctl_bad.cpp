// SPDX-License-Identifier: GPL-3.0-or-later
// What bad input gets: the exit code of the contract, nothing on stdout, one line on stderr, and
// where it is a matter of what was typed, not a byte on the line.
#include "tests/app/commandrunner.h"

#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

using namespace Qt::Literals::StringLiterals;

class tst_trexctl_bad : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void typed_data();
    void typed();
    void port_data();
    void port();
    void controller_data();
    void controller();
    void file_data();
    void file();
    void oneLine_evenWithControlCharacters();
    void busyPort_isSaidSo();
    void hungUpPeer_isALostPort();

private:
    void expectFailure(const Finished& done, int code);
    QTemporaryDir m_folder;
    std::unique_ptr<Simulator> m_simulator;
};

void tst_trexctl_bad::initTestCase()
{
    m_simulator = std::make_unique<Simulator>();
    QVERIFY(m_simulator->isReady());
}

void tst_trexctl_bad::expectFailure(const Finished& done, int code)
{
    QVERIFY2(done.code == code, (QByteArray::number(done.code) + ' ' + done.err).constData());
    QVERIFY2(done.out.isEmpty(), done.out);
    QVERIFY2(done.errLines().size() == 1 && done.err.size() > 10, done.err);
}

void tst_trexctl_bad::typed_data()
{
    QTest::addColumn<QString>("command");
    for (const char* command :
         {// no command, or none that there is
          "", "frobnicate", "frobnicate 1 2", "--json", "infos", "info extra", "ports x",
          "calibration", "calibration frob", "param", "config", "record",
          "record f.trexrec --duration 0", "record f.trexrec --streams all", "export f --csv o",
          "run p.json",
          // line options
          "--baud 9601 info", "--baud 0 info", "--baud -19200 info", "--baud fast info",
          "--baud 19200.0 info", "--baud 99999999999999999999 info", "--baud info",
          "--protocol qik info", "--device 128 info", "--device -1 info", "--device x info",
          "--device 3 --protocol compact info", "--error-detection crc8 info",
          "--error-detection Even info", "--crc-polynomial 9 info", "--crc-polynomial 0x7F info",
          "--crc-polynomial 0x100 info", "--stop-bits 0 info", "--stop-bits 3 info",
          "--echo maybe info", "--timeout 0 info", "--timeout -5 info", "--timeout 1e3 info",
          "--timeout 999999999 info", "--frob info", "info --frob",
          // motors
          "motor", "motor 1", "motor 1 set", "motor 3 set 1", "motor 0 set 1", "motor left set 1",
          "motor 1 set 128", "motor 1 set -128", "motor 1 set 0x80", "motor 1 set 5.5",
          "motor 1 set fast", "motor 1 spin 5", "motor 1 set 1 2", "motor both set 1 2 3",
          "motor both set 1 128", "motor both brake -1", "motor 1 brake 128", "motor 1 brake -1",
          "motor aux set -1", "motor aux set 128", "motor aux brake 5", "motor aux set 1 2",
          "motor 1 set 010x", "stop now", "stop --coast",
          // channels and currents
          "channels --mask 0", "channels --mask 32", "channels --mask 0x20", "channels --mask all",
          "channels --rate 0", "channels --rate -1", "channels --rate 1e9", "channels --rate nan",
          "currents --duration 0", "currents --duration -2", "currents --duration inf",
          "currents --duration soon", "currents --csv", "currents --rate",
          // calibrations
          "calibration get 0", "calibration get 6", "calibration get one", "calibration set",
          "calibration set 1 2 3 4", "calibration set 1 5000 3750 2500 10",
          "calibration set 1 2500 2500 2500 10", "calibration set 1 0 8000 16384 0",
          "calibration set 1 -1 0 5 0", "calibration set 6 1 2 3 0",
          "calibration set 1 2500 3750 5000 16384", "calibration set 1 2500 6000 5000 1",
          "calibration learn", "calibration learn --yes --channels 6",
          "calibration learn --yes --channels 1,,2", "calibration learn --yes --neutral-seconds 0",
          "calibration learn --yes --sweep-seconds x",
          // parameters
          "param get", "param get no-such-key", "param get 0x18", "param get 127", "param get -1",
          "param get factory-reset", "param get 300", "param set serial-timeout",
          "param set serial-timeout 128", "param set serial-timeout -1",
          "param set serial-timeout 20s", "param set serial-timeout 5A",
          "param set serial-timeout ms", "param set serial-timeout 5.5",
          "param set motor1-current-limit 11A", "param set motor1-current-limit 5ms",
          "param set required-channels 32", "param set motor1-pwm-prescaler 4",
          "param set motor-mode 2", "param set uart-settings 11", "param set nope 1",
          "param set factory-reset 127", "param set 0x7F 0x7F", "param set 7 nan",
          "param set 7 -500ms", "param reset",
          // raw
          "raw", "raw 8G", "raw 861", "raw --frame 1F", "raw --frame 86 9F", "raw 81 --reply -1",
          "raw 81 --reply 9999", "raw 81 --reply nine", "raw 0x", "raw ''",
          // simulate
          "simulate --model duo", "simulate --mode usb", "simulate --baud 300",
          "simulate --fault drop=2", "simulate --fault bogus=1", "simulate --fault drop",
          "simulate --quirk bogus=1", "simulate --quirk calibration-bytes=9",
          "simulate --param nope=1", "simulate --param serial-timeout=300", "simulate --device 128",
          "simulate --tcp 70000", "simulate --tcp x", "simulate --crc-polynomial 9",
          "simulate --speed 0", "simulate --firmware 9.9", "simulate --seed x",
          "simulate --scenario /nonexistent/s.json", "simulate --frob",
          "simulate --error-detection crc16"}) {
        QTest::newRow(command) << QString::fromLatin1(command);
    }
}

void tst_trexctl_bad::typed()
{
    QFETCH(QString, command);
    const qsizetype heard = m_simulator->packets().size();
    const Finished done = run(QStringList{u"--port"_s, m_simulator->port()} + words(command));
    expectFailure(done, 2);
    QCOMPARE(m_simulator->packets().size(), heard);
}

void tst_trexctl_bad::port_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<int>("code");
    QTest::newRow("missing") << u"/dev/ttyNothing9"_s << 4;
    QTest::newRow("missing, relative") << u"ttyNothing9"_s << 4;
    QTest::newRow("a plain file") << QString::fromLatin1(TREX_SOURCE_DIR "/LICENSE") << 4;
    QTest::newRow("a folder") << u"/tmp"_s << 4;
    QTest::newRow("no serial port") << u"/dev/null"_s << 4;
    QTest::newRow("endless") << u"/dev/zero"_s << 4;
    QTest::newRow("nobody listens") << u"tcp://127.0.0.1:1"_s << 4;
    QTest::newRow("no such host") << u"tcp://no-such-host.invalid:7"_s << 4;
    QTest::newRow("empty") << QString() << 2;
    QTest::newRow("no TCP port") << u"tcp://127.0.0.1"_s << 2;
    QTest::newRow("TCP port too large") << u"tcp://127.0.0.1:70000"_s << 2;
    QTest::newRow("no host") << u"tcp://:7"_s << 2;
    QTest::newRow("sim, unknown key") << u"sim:?bogus=1"_s << 2;
    QTest::newRow("sim, bad value") << u"sim:?mode=usb"_s << 2;
}

void tst_trexctl_bad::port()
{
    QFETCH(QString, port);
    QFETCH(int, code);
    for (const QString& command : {u"info"_s, u"motor 1 set 5"_s, u"currents --watch"_s}) {
        expectFailure(run(QStringList{u"--port"_s, port} + words(command)), code);
    }
    if (code == 4) {
        expectFailure(run({u"--port"_s, port, u"--json"_s, u"scan"_s}), 4);
    }
}

void tst_trexctl_bad::controller_data()
{
    QTest::addColumn<QString>("simulator");
    QTest::addColumn<QString>("command");
    QTest::addColumn<int>("code");
    const auto row = [](const char* simulator, const char* command, int code) {
        QTest::addRow("%s / %s", simulator, command)
            << QString::fromLatin1(simulator) << QString::fromLatin1(command) << code;
    };
    for (const char* command :
         {"info", "status", "channels", "currents", "calibration get", "param list", "param get 7",
          "param set 7 5", "param reset --yes", "motor 1 set 5", "stop", "raw 81 --reply 9",
          "calibration learn --yes", "calibration set 1 2500 3750 5000 9", "currents --watch"}) {
        row("--fault silent-after=0", command, 3);
    }
    row("--baud 9600", "info", 3);
    row("--error-detection crc7", "info", 3);
    row("--fault corrupt=1", "--error-detection crc7 info", 3);
    row("--device 9", "--device 8 info", 3);
    row("--mode rc", "param set serial-timeout 5", 1); // C-38: answer 3
    row("--mode rc", "param reset --yes", 1);
    row("--mode analog", "calibration learn --yes", 1);
    row("--firmware 1.1", "param set uart-response-delay 1", 3); // it knows no 0x17
}

void tst_trexctl_bad::controller()
{
    QFETCH(QString, simulator);
    QFETCH(QString, command);
    QFETCH(int, code);
    Simulator controller(words(simulator));
    QVERIFY(controller.isReady());
    const Finished done =
        run(QStringList{u"--port"_s, controller.port(), u"--json"_s} + words(command));
    expectFailure(done, code);
}

void tst_trexctl_bad::file_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("no JSON") << QByteArray("hello");
    QTest::newRow("cut off") << QByteArray(R"({"format":"trexpanel-configuration","ver)");
    QTest::newRow("other format") << QByteArray(R"({"format":"x","version":1})");
    QTest::newRow("unknown key") << QByteArray(
        R"({"format":"trexpanel-configuration","version":1,"parameters":{"no":{"raw":1}}})");
    QTest::newRow("out of range") << QByteArray(
        R"({"format":"trexpanel-configuration","version":1,"parameters":{"motor-mode":{"raw":2}}})");
    QTest::newRow("physical disagrees") << QByteArray(
        R"({"format":"trexpanel-configuration","version":1,"parameters":{"serial-timeout":{"raw":5,"physical":600,"unit":"ms"}}})");
    QTest::newRow("bytes") << QByteArray("\x00\xff\xfe\x80", 4);
}

void tst_trexctl_bad::file()
{
    QFETCH(QByteArray, content);
    QFile file(m_folder.filePath(u"bad.json"_s));
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write(content);
    file.close();
    const qsizetype heard = m_simulator->packets().size();
    for (const QString& command : {u"load"_s, u"diff"_s}) {
        expectFailure(
            run({u"--port"_s, m_simulator->port(), u"config"_s, command, file.fileName()}), 2);
        expectFailure(
            run({u"--port"_s, m_simulator->port(), u"config"_s, command, u"/no/such/file"_s}), 2);
        expectFailure(run({u"--port"_s, m_simulator->port(), u"config"_s, command, u"/dev/zero"_s}),
                      2);
    }
    expectFailure(run({u"--port"_s, m_simulator->port(), u"config"_s, u"save"_s, u"/no/such/f"_s}),
                  2);
    expectFailure(
        run({u"--port"_s, m_simulator->port(), u"currents"_s, u"--csv"_s, u"/no/such/f.csv"_s}), 2);
    QCOMPARE(m_simulator->packets().size(), heard);
    expectFailure(run({u"simulate"_s, u"--scenario"_s, file.fileName()}), 2);
}

void tst_trexctl_bad::oneLine_evenWithControlCharacters()
{
    expectFailure(run({u"--port"_s, u"/dev/no\nsuch\r\tport"_s, u"info"_s}), 4);
    expectFailure(run({u"--port"_s, m_simulator->port(), u"param"_s, u"get"_s, u"a\nb"_s}), 2);
    expectFailure(run({u"motor\nboth"_s}), 2);
    expectFailure(run({u"--port"_s, m_simulator->port(), u"raw"_s, QString()}), 2);
}

void tst_trexctl_bad::busyPort_isSaidSo()
{
    // The first user has taken the port for himself, as QSerialPort does.
    RunningCommand first({u"--port"_s, m_simulator->port(), u"currents"_s, u"--watch"_s});
    QVERIFY(first.waitForLine());
    expectFailure(run({u"--port"_s, m_simulator->port(), u"info"_s}), 4);
    first.interrupt();
    QCOMPARE(first.wait().code, 0);
}

void tst_trexctl_bad::hungUpPeer_isALostPort()
{
    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost));
    RunningCommand command(
        {u"--port"_s, u"tcp://127.0.0.1:%1"_s.arg(server.serverPort()), u"info"_s});
    QVERIFY(server.waitForNewConnection(5000));
    server.nextPendingConnection()->close();
    expectFailure(command.wait(), 4);
}

QTEST_GUILESS_MAIN(tst_trexctl_bad)
#include "tst_trexctl_bad.moc"
