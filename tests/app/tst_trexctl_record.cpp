// SPDX-License-Identifier: GPL-3.0-or-later
// record and export as a person or a script runs them, and what a kill or a full disk leaves.
#include "protocol/errortext.h"
#include "protocol/storage/recordingreader.h"
#include "tests/app/commandrunner.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTest>

#include <csignal>
#include <random>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

class tst_trexctl_record : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void duration_givesFileAndAnswer();
    void streams_areThoseAskedFor();
    void settings_standAtTheHead();
    void badArguments_sendNothing_data();
    void badArguments_sendNothing();
    void interrupt_endsDone();
    void longSilence_endsAndKeeps();
    void lostPort_endsAndKeeps();
    void jointMode_leavesCurrentsOut();
    void kill_losesASecondAtMost();
    void fullDisk_isToldAndKeeps();
    void export_refusesStrangers();
    void replay_givesTheSameChannels();

private:
    QString path(const QString& name = u"r.trexrec"_s) const { return m_folder->filePath(name); }
    QStringList record(const QString& port, const QString& options = {}) const
    {
        return QStringList{u"--port"_s, port, u"--json"_s, u"record"_s, path()}
        + (options.isEmpty() ? QStringList() : words(options));
    }
    QList<QByteArray> exported() const
    {
        const Finished done = run({u"export"_s, path(), u"--csv"_s, path(u"o.csv"_s)});
        QFile file(path(u"o.csv"_s));
        return done.code == 0 && file.open(QIODevice::ReadOnly)
            ? file.readAll().trimmed().split('\n')
            : QList<QByteArray>{};
    }
    std::unique_ptr<QTemporaryDir> m_folder;
};

void tst_trexctl_record::duration_givesFileAndAnswer()
{
    Simulator simulator;
    const Finished done = run(record(simulator.port(), u"--duration 2"_s));
    QVERIFY2(done.code == 0, done.err);
    const QJsonObject answer = done.object();
    QCOMPARE(answer.keys(), (QStringList{u"file"_s, u"lost"_s, u"samples"_s, u"seconds"_s}));
    QCOMPARE(answer[u"file"_s].toString(), path());
    const int samples = answer[u"samples"_s].toInt();
    QVERIFY2(samples >= 15 && samples <= 41, qPrintable(QString::number(samples)));
    QCOMPARE(answer[u"lost"_s].toInt(), 0);
    QVERIFY(answer[u"seconds"_s].toDouble() > 1.0 && answer[u"seconds"_s].toDouble() < 2.1);
    QVERIFY(!done.err.isEmpty()); // the progress line
    QVERIFY(!QFile::exists(path() + u"-wal"_s));
    const auto rows = exported();
    // One row a sample; more where a busy machine kept two streams more than 100 ms apart.
    QVERIFY2(rows.size() - 1 >= samples && rows.size() - 1 <= samples + 3,
             qPrintable(QString::number(rows.size())));
    QVERIFY(rows[0].startsWith("t_s,motor1_raw,motor2_raw,motor1_A,motor2_A,channel1_raw"));
    QVERIFY(rows[0].contains("channel5_us") && rows[0].endsWith("status_raw,uart_errors_raw"));
    for (qsizetype i = 1; i < rows.size(); ++i) {
        const auto cells = rows[i].split(',');
        QCOMPARE(cells.size(), rows[0].split(',').size());
        QVERIFY(qAbs(cells[3].toDouble() - cells[1].toInt() * 0.04) < 1e-6);
    }
    QVERIFY(rows[1].startsWith("0.00000,"));
}

void tst_trexctl_record::streams_areThoseAskedFor()
{
    Simulator simulator;
    const Finished done = run(record(simulator.port(), u"--duration 1 --streams currents"_s));
    QVERIFY2(done.code == 0, done.err);
    QCOMPARE(exported().value(0), QByteArray("t_s,motor1_raw,motor2_raw,motor1_A,motor2_A"));
    const Finished second =
        run(record(simulator.port(), u"--duration 1 --streams channels --force --rate 5"_s));
    QVERIFY2(second.code == 0, second.err);
    const auto rows = exported();
    QVERIFY(rows.value(0).startsWith("t_s,channel1_raw") && !rows[0].contains("motor"));
    QVERIFY(rows.size() >= 4 && rows.size() <= 7);
}

void tst_trexctl_record::settings_standAtTheHead()
{
    Simulator simulator({u"--param"_s, u"serial-timeout=9"_s});
    const Finished done = run(record(simulator.port(), u"--duration 1 --packets"_s));
    QVERIFY2(done.code == 0, done.err);
    auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    const auto configurations = (*reader)->configurations();
    QCOMPARE(configurations.size(), std::size_t(1));
    QCOMPARE(configurations[0].configuration.parameters.at(7), 9);
    QCOMPARE(configurations[0].configuration.calibrations.at(InputKind::Rc).size(), std::size_t(5));
    QCOMPARE((*reader)->fact("program"), u"trexctl"_s);
    QCOMPARE((*reader)->fact("signature"), u"TReXJr1.2"_s);
    QCOMPARE((*reader)->fact("baud"), u"19200"_s);
    QVERIFY((*reader)->packetCount() > 50);
}

void tst_trexctl_record::badArguments_sendNothing_data()
{
    QTest::addColumn<QString>("options");
    QTest::newRow("no such stream") << u"--streams currents,weather"_s;
    QTest::newRow("empty list") << u"--streams ,"_s;
    QTest::newRow("duration") << u"--duration 0"_s;
    QTest::newRow("rate") << u"--rate -3"_s;
}

void tst_trexctl_record::badArguments_sendNothing()
{
    QFETCH(const QString, options);
    Simulator simulator;
    const Finished done = run(record(simulator.port(), options));
    QCOMPARE(done.code, 2);
    QVERIFY(done.out.isEmpty());
    QCOMPARE(done.errLines().size(), 1);
    QVERIFY(simulator.packets().isEmpty());
    // A file that is there stays as it is.
    QFile file(path(u"there"_s));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
    file.close();
    const QStringList onto{u"--port"_s, simulator.port(), u"record"_s, path(u"there"_s)};
    QCOMPARE(run(onto).code, 2);
    QCOMPARE(file.size(), 4);
    QCOMPARE(run({u"--port"_s, simulator.port(), u"record"_s, path(u"no/folder"_s)}).code, 2);
    QVERIFY(simulator.packets().isEmpty());
}

void tst_trexctl_record::interrupt_endsDone()
{
    Simulator simulator;
    RunningCommand command(record(simulator.port()));
    QTRY_VERIFY_WITH_TIMEOUT(simulator.packets().count(u"8F"_s) > 10, 10'000);
    command.interrupt();
    const Finished done = command.wait(10'000);
    QVERIFY2(done.code == 0, done.err);
    QVERIFY(done.object()[u"samples"_s].toInt() > 5);
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    QVERIFY((*reader)->isFinished());
    QCOMPARE(qint64((*reader)->samples(PollId::Currents)), done.object()[u"samples"_s].toInteger());
}

void tst_trexctl_record::longSilence_endsAndKeeps()
{
    Simulator simulator({u"--fault"_s, u"silent-after=3"_s});
    const Finished done = run(record(simulator.port()));
    QCOMPARE(done.code, 3);
    QVERIFY(done.out.isEmpty());
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    QVERIFY((*reader)->isFinished());
    QVERIFY((*reader)->samples(PollId::Currents) > 5);
}

void tst_trexctl_record::lostPort_endsAndKeeps()
{
    Simulator simulator({u"--fault"_s, u"hangup-after=3"_s});
    const Finished done = run(record(simulator.port()));
    QCOMPARE(done.code, 4);
    QVERIFY(done.out.isEmpty());
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    QVERIFY((*reader)->samples(PollId::Currents) > 5);
}

void tst_trexctl_record::jointMode_leavesCurrentsOut()
{
    Simulator simulator({u"--param"_s, u"motor-mode=1"_s});
    const Finished done = run(record(simulator.port(), u"--duration 0.5"_s));
    QVERIFY2(done.code == 0, done.err);
    QVERIFY(!exported().value(0).contains("motor1")); // conformance C-31
    QVERIFY(!simulator.packets().contains(u"8F"_s));
    const Finished none = run(record(simulator.port(), u"--streams currents --force"_s));
    QCOMPARE(none.code, 1);
}

void tst_trexctl_record::kill_losesASecondAtMost()
{
    const int rounds = qEnvironmentVariableIsSet("TREX_EXHAUSTIVE") ? 100 : 20;
    std::minstd_rand random(17);
    qint64 worst = 0;
    for (int round = 0; round < rounds; ++round) {
        init();
        Simulator simulator;
        RunningCommand command(record(simulator.port(), u"--streams currents --rate 50"_s));
        QTRY_VERIFY_WITH_TIMEOUT(simulator.packets().contains(u"8F"_s), 15'000);
        QTest::qWait(static_cast<int>(random() % 2500));
        command.signal(SIGKILL);
        static_cast<void>(command.wait());
        double lastHeard = 0.0;
        for (const QJsonObject& entry : simulator.log()) {
            if (entry[u"bytes"_s].toString() == u"8F"_s) {
                lastHeard = entry[u"epochMs"_s].toDouble();
            }
        }
        const auto opened = RecordingReader::open(path());
        QVERIFY2(opened, opened ? "" : qPrintable(errorText(opened.error())));
        RecordingReader& reader = **opened;
        QVERIFY(!reader.isFinished());
        TelemetryStore store;
        reader.loadAll(store, Instant());
        QVERIFY2(!reader.remark().contains(u"damaged"_s), qPrintable(reader.remark()));
        QCOMPARE(store.series(0).size(), reader.samples(PollId::Currents));
        const Tick last = reader.range() ? reader.range()->second : 0;
        const double kept = double(reader.started().toMSecsSinceEpoch()) + double(last) / 100.0;
        worst = std::max(worst, qint64(lastHeard - kept));
        QVERIFY2(lastHeard - kept <= 1000.0, qPrintable(QString::number(lastHeard - kept)));
    }
    qInfo("%d kills: at most %lld ms short", rounds, worst);
}

void tst_trexctl_record::fullDisk_isToldAndKeeps()
{
#ifdef Q_OS_UNIX
    const int rounds = qEnvironmentVariableIsSet("TREX_EXHAUSTIVE") ? 25 : 3;
    std::minstd_rand random(5);
    for (int round = 0; round < rounds; ++round) {
        init();
        Simulator simulator;
        QProcess process;
        // The file may not grow beyond this (in half kilobytes); the signal of it is ignored, so
        // that the write fails, as it does on a full disk.
        const int limit = 260 + static_cast<int>(random() % 300);
        process.start(u"/bin/sh"_s,
                      {u"-c"_s, u"trap '' XFSZ; ulimit -f %1; exec \"$0\" \"$@\""_s.arg(limit),
                       QStringLiteral(TREXCTL), u"--port"_s, simulator.port(), u"record"_s, path(),
                       u"--packets"_s, u"--rate"_s, u"200"_s});
        QVERIFY(process.waitForFinished(100'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 2);
        const QByteArray err = process.readAllStandardError();
        QVERIFY2(err.contains("Could not write") && err.contains(path().toUtf8()), err);
        QVERIFY(process.readAllStandardOutput().isEmpty());
        const auto reader = RecordingReader::open(path());
        QVERIFY2(reader, reader ? "" : qPrintable(errorText(reader.error())));
        TelemetryStore store;
        (*reader)->loadAll(store, Instant());
        QVERIFY(store.series(0).size() > 10);
        QVERIFY2(!(*reader)->remark().contains(u"damaged"_s), qPrintable((*reader)->remark()));
        // What the controller had answered a second before the end is there.
        double lastHeard = 0.0;
        for (const QJsonObject& entry : simulator.log()) {
            if (entry[u"bytes"_s].toString() == u"8F"_s) {
                lastHeard = entry[u"epochMs"_s].toDouble();
            }
        }
        const double kept = double((*reader)->started().toMSecsSinceEpoch())
            + double((*reader)->range()->second) / 100.0;
        QVERIFY2(lastHeard - kept <= 1000.0, qPrintable(QString::number(lastHeard - kept)));
    }
#else
    QSKIP("there is no limit of a file's size to set");
#endif
}

void tst_trexctl_record::export_refusesStrangers()
{
    QFile file(path());
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("t_s,motor1_raw\n");
    file.close();
    const Finished done = run({u"export"_s, path(), u"--csv"_s, path(u"o.csv"_s)});
    QCOMPARE(done.code, 2);
    QCOMPARE(done.errLines().size(), 1);
    QVERIFY(done.out.isEmpty() && !QFile::exists(path(u"o.csv"_s)));
    QCOMPARE(run({u"export"_s, path(u"none"_s), u"--csv"_s, path(u"o.csv"_s)}).code, 2);
    QCOMPARE(run({u"simulate"_s, u"--replay"_s, path()}).code, 2);
}

void tst_trexctl_record::replay_givesTheSameChannels()
{
    QFile scenario(path(u"scenario.json"_s));
    QVERIFY(scenario.open(QIODevice::WriteOnly));
    scenario.write(R"({"channels":[{"channel":1,"wave":"hold","value":3333},)"
                   R"({"channel":2,"wave":"hold","value":2777}]})");
    scenario.close();
    {
        Simulator simulator(
            {u"--scenario"_s, scenario.fileName(), u"--param"_s, u"motor1-acceleration=33"_s});
        QCOMPARE(run(record(simulator.port(), u"--duration 1"_s)).code, 0);
    }
    Simulator again({u"--replay"_s, path()});
    QVERIFY(again.isReady());
    const QStringList ask{u"--port"_s, again.port(), u"--json"_s, u"channels"_s};
    QTRY_COMPARE_WITH_TIMEOUT(
        run(ask).object()[u"channels"_s].toArray()[0].toObject()[u"raw"_s].toInt(), 3333, 10'000);
    QCOMPARE(run(ask).object()[u"channels"_s].toArray()[1].toObject()[u"raw"_s].toInt(), 2777);
    // And the settings; what is asked for comes first.
    const auto acceleration = [](const Simulator& simulator) {
        return run({u"--port"_s, simulator.port(), u"--json"_s, u"param"_s, u"get"_s,
                    u"motor1-acceleration"_s})
            .object()[u"value"_s]
            .toInt();
    };
    QCOMPARE(acceleration(again), 33);
    Simulator other({u"--param"_s, u"motor1-acceleration=7"_s, u"--replay"_s, path()});
    QVERIFY(other.isReady());
    QCOMPARE(acceleration(other), 7);
}

QTEST_GUILESS_MAIN(tst_trexctl_record)
#include "tst_trexctl_record.moc"
