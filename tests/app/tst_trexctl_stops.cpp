// SPDX-License-Identifier: GPL-3.0-or-later
// Every way in which a trexctl that has motors in its care can be ended: the simulated controller's
// own record says that all three stand. And commands that care for no motor touch none.
#include "protocol/codec/packet.h"
#include "protocol/session/linkengine.h"
#include "tests/app/commandrunner.h"
#include "tests/support/simwitness.h"

#include <QDateTime>
#include <QTest>

#include <csignal>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

constexpr int kLongest = 20'000;
constexpr double kStatedMs = 200.0;
constexpr double kLoad = 5.0; ///< times the stated time, in the test's one run

const QByteArray kProfile = R"({"format":"trexpanel-bench-profile","version":1,"name":"Long",
    "limits":{"staleSeconds":5},"steps":[
    {"do":"set","motor":"aux","speed":30},{"do":"set","motor":"both","speed":40},
    {"do":"sine","motor":"both","middle":50,"amplitude":30,"period":1,"seconds":SECONDS}]})";

bool isCrash(int number)
{
    return number != SIGINT && number != SIGTERM && number != SIGHUP && number != SIGTSTP;
}

struct Bench {
    Bench() : witness({}, folder.filePath(u"port"_s), folder.filePath(u"log"_s)) { }
    [[nodiscard]] QString port() const { return folder.filePath(u"port"_s); }
    [[nodiscard]] test::SimRecord record() const
    {
        return test::readSimRecord(folder.filePath(u"log"_s));
    }
    QString profile(const QByteArray& seconds)
    {
        QFile file(folder.filePath(u"profile.json"_s));
        if (file.open(QIODevice::WriteOnly)) {
            file.write(QByteArray(kProfile).replace("SECONDS", seconds));
        }
        return file.fileName();
    }
    QTemporaryDir folder;
    test::SimWitness witness;
};

} // namespace

class TestTrexctlStops : public QObject {
    Q_OBJECT

private slots:
    void ended_leavesAllMotorsNeutral_data();
    void ended_leavesAllMotorsNeutral();
    void driveWithDuration_stopsAtItsEnd();
    void driveWithDuration_outlivesTheSerialTimeout();
    void driveWithDuration_isRefusedWithoutControl();
    void interruptedOrder_isTakenBack();
    void unreadOutput_isNoEnd();
    void noMotorInItsCare_noneIsTouched_data();
    void noMotorInItsCare_noneIsTouched();
    void suspended_standsStillAndGoesOn();
    void hangUp_isIgnoredUnderNohup();
};

void TestTrexctlStops::ended_leavesAllMotorsNeutral_data()
{
    QTest::addColumn<bool>("isRun");
    QTest::addColumn<int>("number");
    const auto row = [](const char* name, bool isRun, int number) {
        QTest::addRow("%s, %s", isRun ? "run" : "motor --duration", name) << isRun << number;
    };
    row("SIGINT", true, SIGINT);
    row("SIGTERM", true, SIGTERM);
    row("SIGHUP", true, SIGHUP);
    row("SIGTSTP", true, SIGTSTP);
    row("SIGQUIT", true, SIGQUIT);
    row("SIGSEGV", true, SIGSEGV);
    row("SIGABRT", true, SIGABRT);
    row("SIGUSR2", true, SIGUSR2);
    row("SIGINT", false, SIGINT);
    row("SIGHUP", false, SIGHUP);
    row("SIGTSTP", false, SIGTSTP);
    row("SIGSEGV", false, SIGSEGV);
    row("SIGXCPU", false, SIGXCPU);
}

void TestTrexctlStops::ended_leavesAllMotorsNeutral()
{
    QFETCH(bool, isRun);
    QFETCH(int, number);
    Bench bench;
    QVERIFY(bench.witness.isOk());
    QStringList arguments{u"--port"_s, bench.port()};
    arguments << (isRun ? QStringList{u"run"_s, bench.profile("60")}
                        : words(u"motor both set 40 --duration 60"_s));
    RunningCommand command(arguments);
    const std::array moving{true, true, isRun};
    QTRY_COMPARE_WITH_TIMEOUT(bench.record().moved, moving, kLongest);
    QTest::qWait(50); // in the midst of it, not on its first packet
    const auto causeMs = static_cast<double>(QDateTime::currentMSecsSinceEpoch());
    command.signal(number);
    const Finished done = command.wait(kLongest);
    QCOMPARE(done.code, isCrash(number) ? -1 : 130);
    if (!isCrash(number)) {
        QCOMPARE(done.errLines(), QList<QByteArray>{"Interrupted; the motors were told to stop."});
        QVERIFY(done.out.isEmpty());
    }
    bench.witness.end();
    const test::SimRecord record = bench.record();
    QCOMPARE(record.speeds, (std::array{0, 0, 0}));
    QVERIFY(record.restedMs.has_value());
    QVERIFY2(*record.restedMs - causeMs < kLoad * kStatedMs,
             qPrintable(u"%1 ms"_s.arg(*record.restedMs - causeMs)));
    // All three were told, those that stood still, too; and nothing came after it.
    QVERIFY(record.motorPackets.size() > 2);
    QByteArray last = record.motorPackets.at(record.motorPackets.size() - 2).bytes;
    last += record.motorPackets.back().bytes;
    QByteArray stop;
    for (const Command& packet : stopCommands(false)) {
        stop += encode(packet, LineSettings{});
    }
    QCOMPARE(last.toHex(), stop.toHex());
}

void TestTrexctlStops::driveWithDuration_stopsAtItsEnd()
{
    Bench bench;
    const Finished done = run(QStringList{u"--json"_s, u"--port"_s, bench.port()}
                              + words(u"motor 1 set -30 --duration 0.3"_s));
    QVERIFY2(done.code == 0, done.err);
    QCOMPARE(done.object()["seconds"_L1], 0.3);
    QCOMPARE(done.object()["sent"_L1], u"C11EDA0000F000"_s);
    bench.witness.end();
    const test::SimRecord record = bench.record();
    QCOMPARE(record.speeds, (std::array{0, 0, 0}));
    QCOMPARE(record.moved, (std::array{true, false, false}));
    QVERIFY(record.restedMs.has_value());
    QVERIFY(*record.restedMs - record.lastMovedMs > 250.0);
    for (const char* text : {"0", "-1", "4000", "x"}) { // found before a byte is sent
        const Finished bad =
            run(QStringList{u"--port"_s, bench.port()} + words(u"motor 1 set 30 --duration "_s)
                << QLatin1StringView(text));
        QCOMPARE(bad.code, 2);
        QCOMPARE(bad.errLines().size(), 1);
    }
}

/// The shortest serial timeout there is: it is kept from acting for as long as was asked.
void TestTrexctlStops::driveWithDuration_outlivesTheSerialTimeout()
{
    QTemporaryDir folder;
    sim::SimOptions options;
    options.parameters[0x07] = 5;
    test::SimWitness witness(options, folder.filePath(u"port"_s), folder.filePath(u"log"_s));
    const Finished done = run(QStringList{u"--port"_s, folder.filePath(u"port"_s)}
                              + words(u"motor both set 30 --duration 1.5"_s));
    QVERIFY2(done.code == 0, done.err);
    witness.end();
    const test::SimRecord record = test::readSimRecord(folder.filePath(u"log"_s));
    QCOMPARE(record.speeds, (std::array{0, 0, 0}));
    QVERIFY(*record.restedMs - record.lastMovedMs > 1400.0);
}

void TestTrexctlStops::driveWithDuration_isRefusedWithoutControl()
{
    Simulator simulator({u"--mode"_s, u"rc"_s});
    const Finished done =
        run(QStringList{u"--port"_s, simulator.port()} + words(u"motor 1 set 30 --duration 5"_s));
    QCOMPARE(done.code, 1);
    QCOMPARE(done.errLines().size(), 1);
    // Nothing is left waiting in the controller.
    QTRY_COMPARE(simulator.packets(u"motor"_s).last().toUpper(), u"F000"_s);
}

/// Ctrl+C between an order and its confirmation.
void TestTrexctlStops::interruptedOrder_isTakenBack()
{
    Bench bench;
    sim::Faults faults;
    faults.silentFor = 3.0; // it hears, and does not answer
    bench.witness.setFaults(faults);
    RunningCommand command(QStringList{u"--timeout"_s, u"3000"_s, u"--port"_s, bench.port()}
                           + words(u"motor both set 40"_s));
    QTRY_COMPARE_WITH_TIMEOUT(bench.record().speeds, (std::array{40, 40, 0}), kLongest);
    command.interrupt();
    const Finished done = command.wait(kLongest);
    QCOMPARE(done.code, 130);
    bench.witness.end();
    QCOMPARE(bench.record().speeds, (std::array{0, 0, 0}));
}

/// What is written to nobody is no reason to leave a test, and motors, alone.
void TestTrexctlStops::unreadOutput_isNoEnd()
{
    Bench bench;
    const QString code = bench.folder.filePath(u"code"_s);
    QProcess shell;
    shell.start(u"sh"_s,
                {u"-c"_s,
                 u"{ \"$0\" -vv --port \"$1\" run \"$2\"; echo $? >\"$3\"; } 2>&1 | true"_s,
                 QStringLiteral(TREXCTL), bench.port(), bench.profile("1"), code});
    QVERIFY(shell.waitForFinished(kLongest));
    QFile told(code);
    QVERIFY(told.open(QIODevice::ReadOnly));
    QCOMPARE(told.readAll(), "141\n"); // its answer was for nobody
    bench.witness.end();
    const test::SimRecord record = bench.record();
    QCOMPARE(record.speeds, (std::array{0, 0, 0}));
    QVERIFY(record.moved == (std::array{true, true, true}));
    QVERIFY(record.lastMovedMs - record.motorPackets.front().epochMs > 700.0); // to its end
}

void TestTrexctlStops::noMotorInItsCare_noneIsTouched_data()
{
    QTest::addColumn<QString>("verb");
    QTest::addColumn<int>("number");
    QTest::newRow("currents, SIGINT") << u"currents --watch"_s << SIGINT;
    QTest::newRow("currents, SIGHUP") << u"currents --watch"_s << SIGHUP;
    QTest::newRow("currents, SIGSEGV") << u"currents --watch"_s << SIGSEGV;
    QTest::newRow("learn, SIGINT") << u"calibration learn --yes --neutral-seconds 20"_s << SIGINT;
    QTest::newRow("learn, SIGSEGV") << u"calibration learn --yes --neutral-seconds 20"_s << SIGSEGV;
}

/// `motor` leaves the motors as told (the contract), and who looks on changes nothing about it.
void TestTrexctlStops::noMotorInItsCare_noneIsTouched()
{
    QFETCH(QString, verb);
    QFETCH(int, number);
    Bench bench;
    QCOMPARE(run({u"--port"_s, bench.port(), u"motor"_s, u"1"_s, u"set"_s, u"20"_s}).code, 0);
    const auto orders = bench.record().motorPackets.size();
    RunningCommand command(QStringList{u"--json"_s, u"--port"_s, bench.port()} + words(verb));
    QTest::qWait(700);
    command.signal(number);
    QVERIFY(command.wait(kLongest).code != 0 || verb.startsWith(u"currents"_s));
    bench.witness.end();
    QCOMPARE(bench.record().motorPackets.size(), orders);
    QCOMPARE(bench.record().speeds, (std::array{20, 0, 0}));
}

void TestTrexctlStops::suspended_standsStillAndGoesOn()
{
    Bench bench;
    RunningCommand command(QStringList{u"--json"_s, u"--port"_s, bench.port()}
                           + words(u"currents --watch"_s));
    QVERIFY(command.waitForLine("{"));
    command.signal(SIGTSTP);
    QTest::qWait(300);
    QVERIFY(command.isRunning());
    command.signal(SIGCONT);
    QVERIFY(command.waitForLine("{"));
    command.interrupt();
    QCOMPARE(command.wait(kLongest).code, 0);
}

void TestTrexctlStops::hangUp_isIgnoredUnderNohup()
{
    Bench bench;
    QProcess shell;
    shell.start(u"sh"_s,
                {u"-c"_s, u"trap '' HUP; exec \"$0\" --port \"$1\" currents --watch"_s,
                 QStringLiteral(TREXCTL), bench.port()});
    QVERIFY(shell.waitForReadyRead(kLongest));
    ::kill(static_cast<pid_t>(shell.processId()), SIGHUP);
    QVERIFY(!shell.waitForFinished(300));
    ::kill(static_cast<pid_t>(shell.processId()), SIGINT);
    QVERIFY(shell.waitForFinished(kLongest));
    QCOMPARE(shell.exitCode(), 0);
}

QTEST_GUILESS_MAIN(TestTrexctlStops)
#include "tst_trexctl_stops.moc"
