// SPDX-License-Identifier: GPL-3.0-or-later
// Streams: rate, end, interruption, silence, a lost port, CSV; and the signals of simulate.
#include "tests/app/commandrunner.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTest>

#include <csignal>

using namespace Qt::Literals::StringLiterals;

class tst_trexctl_streams : public QObject {
    Q_OBJECT

private slots:
    void duration_givesTwentyASecond();
    void rate_isAsAsked();
    void interrupt_endsDone();
    void interruptBeforeDuration_endsInterrupted();
    void csv_hasHeaderAndRows();
    void csv_failedRunLeavesNoFile();
    void shortSilence_isSkipped();
    void longSilence_ends();
    void lostPort_ends();
    void closedPipe_endsQuietly();
    void simulate_powerCycleBySignal();
    void simulate_stateSurvives();
    void simulate_termEndsDone();
};

namespace {

QStringList watch(const Simulator& simulator, const QString& command)
{
    return QStringList{u"--port"_s, simulator.port(), u"--json"_s} + words(command);
}

} // namespace

void tst_trexctl_streams::duration_givesTwentyASecond()
{
    Simulator simulator;
    for (const QString& verb : {u"currents"_s, u"channels"_s}) {
        const Finished done = run(watch(simulator, verb + u" --watch --duration 1"_s));
        QVERIFY2(done.code == 0, done.err);
        const auto lines = done.lines();
        QVERIFY2(lines.size() >= 12 && lines.size() <= 21,
                 qPrintable(QString::number(lines.size())));
        double last = -1.0;
        for (const QJsonObject& line : lines) {
            const double t = line["t"_L1].toDouble(-1.0);
            QVERIFY(t > last && t < 1.1);
            last = t;
        }
        QCOMPARE(lines.front()["t"_L1], 0.0);
    }
}

void tst_trexctl_streams::rate_isAsAsked()
{
    Simulator simulator;
    const auto count = [&](const QString& options) {
        return run(watch(simulator, u"currents "_s + options)).lines().size();
    };
    const qsizetype slow = count(u"--rate 4 --duration 1"_s);
    QVERIFY2(slow >= 3 && slow <= 5, qPrintable(QString::number(slow)));
    const qsizetype fast = count(u"--rate 100 --duration 1"_s);
    QVERIFY2(fast >= 40 && fast <= 101, qPrintable(QString::number(fast)));
}

void tst_trexctl_streams::interrupt_endsDone()
{
    Simulator simulator;
    RunningCommand command(watch(simulator, u"channels --watch"_s));
    QVERIFY(command.waitForLine());
    command.interrupt();
    const Finished done = command.wait(3000);
    QCOMPARE(done.code, 0);
    QVERIFY2(done.err.isEmpty(), done.err);
    QVERIFY(done.out.endsWith('\n'));
}

void tst_trexctl_streams::interruptBeforeDuration_endsInterrupted()
{
    Simulator simulator;
    RunningCommand command(watch(simulator, u"currents --watch --duration 60"_s));
    QVERIFY(command.waitForLine());
    command.interrupt();
    QCOMPARE(command.wait(3000).code, 130);
    Simulator silent({u"--fault"_s, u"silent-after=0"_s});
    RunningCommand waiting({u"--port"_s, silent.port(), u"--timeout"_s, u"5000"_s, u"info"_s});
    QTest::qWait(300);
    waiting.interrupt();
    QCOMPARE(waiting.wait(3000).code, 130);
}

void tst_trexctl_streams::csv_hasHeaderAndRows()
{
    Simulator simulator;
    QTemporaryDir folder;
    const QString path = folder.filePath(u"c.csv"_s);
    const Finished done = run(watch(simulator, u"currents --duration 0.5 --csv "_s + path));
    QVERIFY2(done.code == 0, done.err);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> rows = file.readAll().trimmed().split('\n');
    QCOMPARE(rows[0], QByteArray("t_s,motor1_raw,motor2_raw,motor1_A,motor2_A"));
    QCOMPARE(rows.size() - 1, done.lines().size());
    for (qsizetype i = 1; i < rows.size(); ++i) {
        const QList<QByteArray> cells = rows[i].split(',');
        QCOMPARE(cells.size(), 5);
        QVERIFY(qAbs(cells[0].toDouble() - done.lines()[i - 1]["t"_L1].toDouble()) < 0.001);
        QVERIFY(qAbs(cells[3].toDouble() - cells[1].toInt() * 0.04) < 0.001);
    }
}

void tst_trexctl_streams::csv_failedRunLeavesNoFile()
{
    Simulator silent({u"--fault"_s, u"silent-after=0"_s});
    QTemporaryDir folder;
    const QString fresh = folder.filePath(u"new.csv"_s);
    QCOMPARE(run(watch(silent, u"currents --watch --csv "_s + fresh)).code, 3);
    QVERIFY(!QFile::exists(fresh));
    QFile old(folder.filePath(u"old.csv"_s));
    QVERIFY(old.open(QIODevice::WriteOnly));
    old.write("precious");
    old.close();
    QCOMPARE(run(watch(silent, u"currents --watch --csv "_s + old.fileName())).code, 3);
    QCOMPARE(old.size(), 8);
}

void tst_trexctl_streams::shortSilence_isSkipped()
{
    Simulator simulator({u"--fault"_s, u"silent-after=1.5"_s, u"--fault"_s, u"silent-for=1"_s});
    const Finished done = run(watch(simulator, u"currents --watch --duration 4"_s));
    QVERIFY2(done.code == 0, done.err);
    QVERIFY2(done.err.contains("left out"), done.err);
    QVERIFY(done.lines().last()["t"_L1].toDouble() > 3.0);
}

void tst_trexctl_streams::longSilence_ends()
{
    Simulator simulator({u"--fault"_s, u"silent-after=2"_s});
    QElapsedTimer timer;
    timer.start();
    const Finished done = run(watch(simulator, u"currents --watch"_s));
    QCOMPARE(done.code, 3);
    QCOMPARE(done.errLines().size(), 1);
    QVERIFY(!done.out.isEmpty()); // what was printed stays
    QVERIFY(timer.elapsed() < 9'000);
}

void tst_trexctl_streams::lostPort_ends()
{
    for (const bool isTcp : {false, true}) {
        Simulator simulator({}, isTcp);
        RunningCommand command(watch(simulator, u"currents --watch"_s));
        QVERIFY(command.waitForLine());
        QCOMPARE(simulator.stop().code, 0);
        const Finished done = command.wait(5000);
        QVERIFY2(done.code == 4, done.err);
        QCOMPARE(done.errLines().size(), 1);
    }
}

void tst_trexctl_streams::closedPipe_endsQuietly()
{
    Simulator simulator;
    QProcess shell;
    shell.start(u"sh"_s,
                {u"-c"_s, u"\"$0\" --port \"$1\" currents --watch | head -n 3"_s,
                 QStringLiteral(TREXCTL), simulator.port()});
    QVERIFY(shell.waitForFinished(10'000));
    QCOMPARE(shell.readAllStandardOutput().count('\n'), 3);
    QVERIFY(shell.readAllStandardError().isEmpty());
    QTRY_COMPARE(run(watch(simulator, u"info"_s)).code, 0); // it has gone, and the port is free
}

void tst_trexctl_streams::simulate_powerCycleBySignal()
{
    Simulator simulator;
    const Finished set = run(watch(simulator, u"param set channel-input-source 1"_s));
    QVERIFY2(set.code == 0, set.err);
    QCOMPARE(set.object()["needsReset"_L1], true);
    QCOMPARE(run(watch(simulator, u"info"_s)).object()["mode"_L1], "serial-rc"_L1); // C-39
    QCOMPARE(run(watch(simulator, u"param get 0x7C"_s)).object()["pending"_L1], true);
    simulator.powerCycle();
    QTRY_COMPARE(run(watch(simulator, u"info"_s)).object()["mode"_L1], "serial-analog"_L1);
    QCOMPARE(run(watch(simulator, u"param get 0x7C"_s)).object()["pending"_L1], false);
}

void tst_trexctl_streams::simulate_stateSurvives()
{
    QTemporaryDir folder;
    const QStringList options{u"--state"_s, folder.filePath(u"eeprom"_s)};
    {
        Simulator simulator(options);
        QCOMPARE(run(watch(simulator, u"param set serial-timeout 500ms"_s)).code, 0);
        QCOMPARE(simulator.stop().code, 0);
    }
    Simulator simulator(options); // C-40
    QCOMPARE(run(watch(simulator, u"param get 7"_s)).object()["value"_L1], 5);
}

void tst_trexctl_streams::simulate_termEndsDone()
{
    for (const int number : {SIGINT, SIGTERM}) {
        QTemporaryDir folder;
        const QString link = folder.filePath(u"line"_s);
        RunningCommand simulate({u"simulate"_s, u"--pty"_s, link, u"--tcp"_s, u"0"_s});
        QVERIFY(simulate.waitForLine("ready "));
        QVERIFY(simulate.waitForLine("ready tcp://127.0.0.1:"));
        QVERIFY(QFile::exists(link));
        simulate.signal(number);
        QCOMPARE(simulate.wait(3000).code, 0);
        QVERIFY(!QFile(link).exists());
    }
}

QTEST_GUILESS_MAIN(tst_trexctl_streams)
#include "tst_trexctl_streams.moc"
