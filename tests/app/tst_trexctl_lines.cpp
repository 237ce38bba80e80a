// SPDX-License-Identifier: GPL-3.0-or-later
// The same controller over every way to it: packet forms, error detections, speeds, echo, TCP,
// other people's serial servers; and scan, which finds it.
#include "protocol/codec/lineprobe.h"
#include "tests/app/commandrunner.h"

#include <QElapsedTimer>
#include <QProcess>
#include <QStandardPaths>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

class tst_trexctl_lines : public QObject {
    Q_OBJECT

private slots:
    void wholeJob_data();
    void wholeJob();
    void echo_isFoundAndDropped();
    void severalDevices_answerEach();
    void simInProcess_works();
    void tcpThroughSocat_works();
    void tcpThroughSer2net_works();
    void scan_finds_data();
    void scan_finds();
    void scan_ofSilence_isEmpty();
    void scan_saysWhatItLeavesOut();
    void faults_areRiddenOver();

private:
    void doWholeJob(const QStringList& line);
};

void tst_trexctl_lines::doWholeJob(const QStringList& line)
{
    const auto ask = [&line](const QString& command) {
        return run(QStringList{u"--json"_s} + line + words(command));
    };
    const Finished info = ask(u"info"_s);
    QVERIFY2(info.code == 0, info.err);
    QCOMPARE(info.object()["signature"_L1], "TReXJr1.2"_L1);
    QCOMPARE(ask(u"channels"_s).object()["channels"_L1].toArray().size(), 5);
    const Finished list = ask(u"param list"_s);
    QVERIFY2(list.code == 0, list.err);
    QCOMPARE(list.array().size(), 28);
    for (const auto& [command, key, wanted] :
         {std::tuple{u"param set serial-timeout 20"_s, u"verified"_s, true},
          {u"calibration set 2 2501 3751 5001 99"_s, u"verified"_s, true},
          {u"motor both set 40 -40"_s, u"pending"_s, false},
          {u"stop"_s, u"pending"_s, false}}) {
        const Finished done = ask(command);
        QVERIFY2(done.code == 0, (command.toUtf8() + ": " + done.err).constData());
        QCOMPARE(done.object()[key], wanted);
    }
    const Finished status = ask(u"status"_s);
    QVERIFY2(status.code == 0, status.err);
    QCOMPARE(status.object()["uartError"_L1]["byte"_L1], 0); // nothing was wrong on the line
}

void tst_trexctl_lines::wholeJob_data()
{
    QTest::addColumn<QString>("controller");
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("isTcp");
    const auto row = [](const char* controller, const char* line, bool isTcp = false) {
        QTest::addRow("%s / %s%s", controller, line, isTcp ? " / tcp" : "")
            << QString::fromLatin1(controller) << QString::fromLatin1(line) << isTcp;
    };
    row("", "");
    row("", "--protocol pololu");
    row("--device 0", "--device 0");
    row("--device 127", "--device 127");
    row("--error-detection crc7", "--error-detection crc7");
    row("--error-detection crc7", "--error-detection crc7 --protocol pololu");
    row("--error-detection crc7 --crc-polynomial 0xE5",
        "--error-detection crc7 --crc-polynomial 229");
    row("--error-detection even", "--error-detection even");
    row("--error-detection odd --stop-bits 2", "--error-detection odd --stop-bits 2 --device 7");
    row("--baud 1200", "--baud 1200");
    row("--baud 115200 --pace", "--baud 115200");
    row("--pace --echo", "--echo on");
    row("--pace --echo", "");
    row("--quirk motor-reply=ff", ""); // bytes that nobody expects
    row("--param uart-response-delay=1", "");
    row("", "", true);
    row("--error-detection crc7 --echo", "--error-detection crc7 --device 7", true);
}

void tst_trexctl_lines::wholeJob()
{
    QFETCH(QString, controller);
    QFETCH(QString, line);
    QFETCH(bool, isTcp);
    Simulator simulator(words(controller), isTcp);
    QVERIFY(simulator.isReady());
    QCOMPARE(simulator.port().startsWith("tcp://127.0.0.1:"_L1), isTcp);
    doWholeJob(QStringList{u"--port"_s, simulator.port()} + words(line));
    QCOMPARE(simulator.stop().code, 0);
}

void tst_trexctl_lines::echo_isFoundAndDropped()
{
    Simulator simulator({u"--echo"_s, u"--pace"_s}); // C-12
    const auto echoSeen = [&](const QStringList& options) {
        const Finished done = run(QStringList{u"--port"_s, simulator.port(), u"--json"_s} + options
                                  + words(u"info"_s));
        return done.code == 0 ? done.object()["echo"_L1] : QJsonValue();
    };
    QCOMPARE(echoSeen({}), true);
    QCOMPARE(echoSeen({u"--echo"_s, u"on"_s}), true);
    // The null command may latch an error and stop motors: it is never sent to find out.
    QVERIFY(!simulator.packets().contains(u"FF"_s));
}

void tst_trexctl_lines::severalDevices_answerEach()
{
    Simulator simulator({u"--device"_s, u"3"_s, u"--device"_s, u"4"_s});
    const auto ask = [&](int device, const QString& command) {
        return run(QStringList{u"--port"_s, simulator.port(), u"--json"_s, u"--device"_s,
                               QString::number(device)}
                   + words(command));
    };
    QCOMPARE(ask(3, u"param set 7 33"_s).code, 0);
    QCOMPARE(ask(4, u"param set 7 44"_s).code, 0);
    QCOMPARE(ask(3, u"param get 7"_s).object()["value"_L1], 33); // C-05
    QCOMPARE(ask(4, u"param get 7"_s).object()["value"_L1], 44);
    QCOMPARE(ask(5, u"info"_s).code, 3);
}

void tst_trexctl_lines::simInProcess_works()
{
    doWholeJob({u"--port"_s, u"sim:"_s});
    const Finished rc = run({u"--port"_s, u"sim:?mode=rc"_s, u"--json"_s, u"info"_s});
    QCOMPARE(rc.object()["mode"_L1], "rc"_L1);
    QCOMPARE(rc.object()["serialControlsMotors"_L1], false);
}

void tst_trexctl_lines::tcpThroughSocat_works()
{
    const QString socat = QStandardPaths::findExecutable(u"socat"_s);
    if (socat.isEmpty()) {
        QSKIP("socat is not installed");
    }
    Simulator simulator({u"--pace"_s, u"--baud"_s, u"115200"_s});
    quint16 port = 0;
    {
        QTcpServer probe;
        QVERIFY(probe.listen(QHostAddress::LocalHost));
        port = probe.serverPort();
    }
    QProcess server;
    // One child at a time, and it leaves at once: two would share the replies between them.
    server.start(socat,
                 {u"-t"_s, u"0.01"_s,
                  u"TCP-LISTEN:%1,bind=127.0.0.1,reuseaddr,fork,max-children=1"_s.arg(port),
                  u"FILE:%1,raw,echo=0,b115200"_s.arg(simulator.port())});
    QVERIFY(server.waitForStarted());
    const QStringList line{u"--baud"_s, u"115200"_s, u"--port"_s,
                           u"tcp://127.0.0.1:%1"_s.arg(port)};
    QTRY_COMPARE(run(line + words(u"info"_s)).code, 0);
    doWholeJob(line);
    server.terminate();
    QVERIFY(server.waitForFinished());
}

void tst_trexctl_lines::tcpThroughSer2net_works()
{
    QString ser2net = QStandardPaths::findExecutable(u"ser2net"_s);
    if (ser2net.isEmpty()) {
        ser2net = QStandardPaths::findExecutable(u"ser2net"_s, {u"/usr/sbin"_s, u"/sbin"_s});
    }
    if (ser2net.isEmpty()) {
        QSKIP("ser2net is not installed");
    }
    Simulator simulator({u"--pace"_s});
    quint16 port = 0;
    {
        QTcpServer probe;
        QVERIFY(probe.listen(QHostAddress::LocalHost));
        port = probe.serverPort();
    }
    QProcess server;
    server.start(ser2net,
                 {u"-n"_s, u"-Y"_s, u"connection: &c"_s, u"-Y"_s,
                  u"  accepter: tcp,localhost,%1"_s.arg(port), u"-Y"_s,
                  u"  connector: serialdev,%1,19200n81,local"_s.arg(simulator.port())});
    QVERIFY(server.waitForStarted());
    const QStringList line{u"--port"_s, u"tcp://127.0.0.1:%1"_s.arg(port)};
    QTRY_COMPARE(run(line + words(u"info"_s)).code, 0);
    doWholeJob(line);
    server.terminate();
    server.waitForFinished();
}

void tst_trexctl_lines::scan_finds_data()
{
    QTest::addColumn<QString>("controller");
    QTest::addColumn<int>("baud");
    QTest::addColumn<QString>("errorDetection");
    QTest::addColumn<int>("device");
    QTest::newRow("as delivered") << QString() << 19200 << u"none"_s << 7;
    QTest::newRow("fast") << u"--baud 115200"_s << 115200 << u"none"_s << 7;
    QTest::newRow("CRC") << u"--error-detection crc7 --baud 9600"_s << 9600 << u"crc7"_s << 7;
    QTest::newRow("other number") << u"--device 12 --baud 38400"_s << 38400 << u"none"_s << 12;
}

void tst_trexctl_lines::scan_finds()
{
    QFETCH(QString, controller);
    QFETCH(int, baud);
    QFETCH(QString, errorDetection);
    QFETCH(int, device);
    Simulator simulator(words(controller));
    const Finished done = run({u"--port"_s, simulator.port(), u"--json"_s, u"scan"_s}, 90'000);
    QVERIFY2(done.code == 0, done.err);
    QCOMPARE(done.array().size(), 1);
    const QJsonObject hit = done.array()[0].toObject();
    QStringList keys{u"baud"_s,           u"device"_s,    u"echo"_s,
                     u"errorDetection"_s, u"signature"_s, u"stopBits"_s};
    if (errorDetection == "crc7"_L1) {
        keys.insert(1, u"crcPolynomial"_s);
    }
    QCOMPARE(hit.keys(), keys);
    QCOMPARE(hit["baud"_L1], baud);
    QCOMPARE(hit["errorDetection"_L1], errorDetection);
    QCOMPARE(hit["device"_L1], device);
    QCOMPARE(hit["signature"_L1], "TReXJr1.2"_L1);
    QCOMPARE(hit["stopBits"_L1], 1);
    QCOMPARE(hit["echo"_L1], false);
}

void tst_trexctl_lines::scan_ofSilence_isEmpty()
{
    Simulator simulator({u"--fault"_s, u"silent-after=0"_s});
    const Finished done = run({u"--port"_s, simulator.port(), u"--json"_s, u"scan"_s}, 90'000);
    QCOMPARE(done.code, 3);
    QCOMPARE(done.out, QByteArray("[]\n"));
    QCOMPARE(done.errLines().size(), 1);
}

void tst_trexctl_lines::scan_saysWhatItLeavesOut()
{
    LineSettings line{.baud = 14400, .errorDetection = ErrorDetection::Crc7};
    while (lineProbe(line).isClean) {
        QVERIFY(line.polynomial < 0xFF); // else all are clean now, and the sentence can go
        ++line.polynomial;
    }
    Simulator simulator({u"--fault"_s, u"silent-after=0"_s});
    const Finished done = run({u"--port"_s, simulator.port(), u"--crc-polynomial"_s,
                               QString::number(line.polynomial), u"scan"_s},
                              90'000);
    QCOMPARE(done.code, 3);
    QVERIFY2(done.err.contains("Not tried: 14400 baud, CRC-7 with polynomial"), done.err);
}

void tst_trexctl_lines::faults_areRiddenOver()
{
    // A line that loses or doubles a byte now and then: queries are asked again, and what is
    // printed is right or nothing.
    Simulator simulator({u"--error-detection"_s, u"crc7"_s, u"--fault"_s, u"drop=0.02"_s,
                         u"--fault"_s, u"duplicate=0.02"_s, u"--seed"_s, u"7"_s});
    int good = 0;
    for (int i = 0; i < 10; ++i) {
        const Finished done = run({u"--port"_s, simulator.port(), u"--error-detection"_s, u"crc7"_s,
                                   u"--json"_s, u"info"_s});
        QVERIFY2(done.code == 0 || done.code == 3, done.err);
        QVERIFY(done.code != 0 || done.object()["signature"_L1] == "TReXJr1.2"_L1);
        good += done.code == 0 ? 1 : 0;
    }
    QVERIFY2(good >= 7, qPrintable(QString::number(good)));
}

QTEST_GUILESS_MAIN(tst_trexctl_lines)
#include "tst_trexctl_lines.moc"
