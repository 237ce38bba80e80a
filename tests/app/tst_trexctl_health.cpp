// SPDX-License-Identifier: GPL-3.0-or-later
// trexctl health, and whom the simulator serves.
#include "tests/app/commandrunner.h"

#include <QFile>
#include <QNetworkInterface>
#include <QTcpSocket>
#include <QTest>
#include <QUrl>

#include <unistd.h>

using namespace Qt::Literals::StringLiterals;

class tst_trexctl_health : public QObject {
    Q_OBJECT

private slots:
    void wellLine_saysSo();
    void noisyLine_advises();
    void longLine_isInterrupted();
    void text_isForPeople();
    void simulator_servesThisComputerOnly();
    void simulator_saysWhenItServesOthers();
    void deniedPort_namesTheGroup();
    void portInUse_namesTheProgram();
};

namespace {

QStringList health(const Simulator& simulator, const QStringList& more)
{
    return QStringList{u"--port"_s, simulator.port(), u"health"_s} + more;
}

/// An address of this computer that others reach; null where there is none.
QHostAddress outerAddress()
{
    for (const QHostAddress& address : QNetworkInterface::allAddresses()) {
        if (address.protocol() == QAbstractSocket::IPv4Protocol && !address.isLoopback()) {
            return address;
        }
    }
    return {};
}

bool canConnect(const QHostAddress& address, int port)
{
    QTcpSocket socket;
    socket.connectToHost(address, static_cast<quint16>(port));
    return socket.waitForConnected(2000);
}

} // namespace

void tst_trexctl_health::wellLine_saysSo()
{
    Simulator simulator({u"--pace"_s});
    QVERIFY(simulator.isReady());
    const Finished done = run(health(simulator, {u"--duration"_s, u"3"_s, u"--json"_s}));
    QVERIFY2(done.code == 0, done.err);
    const QJsonObject object = done.object();
    QCOMPARE(object["baud"_L1].toInt(), 19200);
    QVERIFY(object["answers"_L1].toInt() > 50);
    QVERIFY(object["seconds"_L1].toDouble() > 2.0);
    for (const auto& key : {"timeouts"_L1, "shortReplies"_L1, "crcErrors"_L1, "badReplies"_L1,
                            "unaskedBytes"_L1, "losses"_L1}) {
        QCOMPARE(object[key].toInt(-1), 0);
    }
    const QJsonObject latency = object["latencyMs"_L1].toObject();
    QVERIFY(latency["median"_L1].toDouble() >= latency["wireMedian"_L1].toDouble());
    QVERIFY(latency["longest"_L1].toDouble() >= latency["p99"_L1].toDouble());
    QVERIFY(latency["wireMedian"_L1].toDouble() > 1.0); // two bytes and more at 19200 baud
    int answers = 0;
    for (const QJsonValue bin : object["histogram"_L1].toArray()) {
        answers += bin["answers"_L1].toInt();
    }
    QVERIFY(answers > 50 && answers <= object["answers"_L1].toInt());
    QCOMPARE(object["adapter"_L1]["kind"_L1].toString(), u"pty"_s);
    QCOMPARE(object["rates"_L1].toArray().size(), 6);
    QVERIFY(object["wireShare"_L1].toDouble() > 0.0 && object["wireShare"_L1].toDouble() < 1.0);
    const QJsonArray advice = object["advice"_L1].toArray();
    QVERIFY(!advice.isEmpty());
    // Nothing moves for it, and the status byte's bits are left to whoever wants them.
    QVERIFY(simulator.packets(u"motor"_s).isEmpty());
    for (const QString& packet : simulator.packets()) {
        QVERIFY(packet != u"84"_s);
    }
}

void tst_trexctl_health::noisyLine_advises()
{
    Simulator simulator({u"--pace"_s, u"--fault"_s, u"garbage=2"_s});
    QVERIFY(simulator.isReady());
    const Finished done = run(health(simulator, {u"--duration"_s, u"4"_s, u"--json"_s}));
    QVERIFY2(done.code == 0, done.err);
    QStringList keys;
    for (const QJsonValue advice : done.object()["advice"_L1].toArray()) {
        keys << advice["key"_L1].toString();
    }
    QVERIFY2(keys.contains(u"damagedWithoutCrc"_s), qPrintable(keys.join(u',')));
    QVERIFY(!keys.contains(u"well"_s));
    QVERIFY(done.object()["badReplies"_L1].toInt() > 0);
}

void tst_trexctl_health::longLine_isInterrupted()
{
    Simulator simulator;
    QVERIFY(simulator.isReady());
    RunningCommand command(health(simulator, {u"--duration"_s, u"60"_s}));
    QTRY_VERIFY_WITH_TIMEOUT(simulator.packets().size() > 20, 10'000);
    command.interrupt();
    const Finished done = command.wait();
    QCOMPARE(done.code, 130);
    QVERIFY(done.out.isEmpty());
    QCOMPARE(run({u"--port"_s, simulator.port(), u"health"_s, u"--duration"_s, u"0"_s}).code, 2);
    QCOMPARE(run({u"--port"_s, simulator.port(), u"health"_s, u"--duration"_s, u"x"_s}).code, 2);
}

void tst_trexctl_health::text_isForPeople()
{
    Simulator simulator;
    QVERIFY(simulator.isReady());
    const Finished done = run(health(simulator, {u"--duration"_s, u"2"_s}));
    QVERIFY2(done.code == 0, done.err);
    for (const char* part : {"19200 baud", "Wire alone", "No answer: 0, 0", "pseudo-terminal"}) {
        QVERIFY2(done.out.contains(part), done.out);
    }
}

void tst_trexctl_health::simulator_servesThisComputerOnly()
{
    Simulator simulator({}, true);
    QVERIFY(simulator.isReady());
    const QUrl url(simulator.port());
    QCOMPARE(url.host(), u"127.0.0.1"_s);
    QVERIFY(canConnect(QHostAddress(QHostAddress::LocalHost), url.port()));
    const QHostAddress outer = outerAddress();
    if (!outer.isNull()) {
        QVERIFY2(!canConnect(outer, url.port()), qPrintable(outer.toString()));
    }
    const Finished done = simulator.stop();
    QCOMPARE(done.code, 0);
    QVERIFY2(done.err.isEmpty(), done.err);
}

void tst_trexctl_health::simulator_saysWhenItServesOthers()
{
    RunningCommand command({u"simulate"_s, u"--tcp"_s, u"0.0.0.0:0"_s});
    QVERIFY(command.waitForLine("ready tcp://0.0.0.0:"));
    const int port = QUrl(QString::fromLatin1(command.firstLine().mid(6).trimmed())).port();
    const QHostAddress outer = outerAddress();
    if (!outer.isNull()) {
        QVERIFY(canConnect(outer, port));
    }
    command.interrupt();
    const Finished done = command.wait();
    QCOMPARE(done.code, 0);
    QCOMPARE(done.errLines().size(), 1);
    QVERIFY2(done.err.contains("0.0.0.0"), done.err);
    RunningCommand loopback({u"simulate"_s, u"--tcp"_s, u"127.0.0.1:0"_s});
    QVERIFY(loopback.waitForLine("ready tcp://127.0.0.1:"));
    loopback.interrupt();
    QVERIFY(loopback.wait().err.isEmpty());
    for (const QString& bad : {u"host.example:7"_s, u":7"_s, u"0.0.0.0:"_s, u"1.2.3.4.5:7"_s}) {
        QCOMPARE(run({u"simulate"_s, u"--tcp"_s, bad}).code, 2);
    }
}

void tst_trexctl_health::deniedPort_namesTheGroup()
{
    Simulator simulator;
    QVERIFY(simulator.isReady());
    const QString device = QFile::symLinkTarget(simulator.port());
    QFile file(device);
    const auto before = file.permissions();
    QVERIFY(file.setPermissions({}));
    // The superuser may open everything; somebody else is asked then.
    const bool isRoot = ::geteuid() == 0;
    QProcess process;
    if (isRoot) {
        process.start(u"setpriv"_s,
                      {u"--reuid=65534"_s, u"--regid=65534"_s, u"--clear-groups"_s,
                       QString::fromUtf8(TREXCTL), u"--port"_s, device, u"info"_s});
    } else {
        process.start(QString::fromUtf8(TREXCTL), {u"--port"_s, device, u"info"_s});
    }
    QVERIFY(process.waitForFinished());
    file.setPermissions(before);
    const QByteArray said = process.readAllStandardError();
    if (isRoot && process.exitCode() > 5) {
        QSKIP("nobody else may run what was built here");
    }
    QCOMPARE(process.exitCode(), 4);
    QVERIFY2(said.contains("dialout"), said);
    QVERIFY2(said.contains(device.toUtf8()), said);
}

void tst_trexctl_health::portInUse_namesTheProgram()
{
    Simulator simulator;
    QVERIFY(simulator.isReady());
    RunningCommand first({u"--port"_s, simulator.port(), u"currents"_s, u"--watch"_s});
    QVERIFY(first.waitForLine());
    const Finished second = run({u"--port"_s, simulator.port(), u"info"_s});
    QCOMPARE(second.code, 4);
    QVERIFY2(second.err.contains("Another program uses"), second.err);
    QVERIFY2(second.err.contains("trexctl, process "), second.err);
    first.interrupt();
    QCOMPARE(first.wait().code, 0);
    QCOMPARE(run({u"--port"_s, simulator.port(), u"info"_s}).code, 0); // the lock went with it
}

QTEST_GUILESS_MAIN(tst_trexctl_health)
#include "tst_trexctl_health.moc"
