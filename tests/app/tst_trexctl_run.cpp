// SPDX-License-Identifier: GPL-3.0-or-later
// `trexctl run`: the real program against a simulated controller, whose own record is the witness.
#include "tests/app/commandrunner.h"

#include <QFile>
#include <QTest>

using namespace Qt::Literals::StringLiterals;

namespace {

const QByteArray kShort = R"({"format":"trexpanel-bench-profile","version":1,"name":"Short",
    "expect":{"motor1.mean-current":{"maximum":MOST}},"limits":{"staleSeconds":5LIMITS},
    "steps":[{"do":"set","speed":60},{"do":"set","motor":"aux","speed":30},{"do":"hold","seconds":1}]})";

} // namespace

class TestTrexctlRun : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void passed_isZero();
    void failedVerdict_isFive();
    void limit_isFive();
    void notInControl_isOne();
    void interrupt_stopsTheMotors();
    void recordAndReport_areWritten();
    void badProfile_sendsNothing();
    void readyProfile_isFoundByName();

private:
    QString write(const QByteArray& most, const QByteArray& limits = {});
    [[nodiscard]] static bool endsStopped(const Simulator& simulator);
    QTemporaryDir m_folder;
    int m_files = 0;
};

void TestTrexctlRun::initTestCase()
{
    QVERIFY(m_folder.isValid());
}

QString TestTrexctlRun::write(const QByteArray& most, const QByteArray& limits)
{
    QFile file(m_folder.filePath(u"p%1.json"_s.arg(++m_files)));
    if (file.open(QIODevice::WriteOnly)) {
        file.write(QByteArray(kShort).replace("MOST", most).replace("LIMITS", limits));
    }
    return file.fileName();
}

bool TestTrexctlRun::endsStopped(const Simulator& simulator)
{
    const QStringList motors = simulator.packets(u"motor"_s);
    return motors.size() > 3 && motors.last().toUpper() == u"F000"_s
        && motors.at(motors.size() - 2).toUpper().endsWith(u"0000"_s);
}

void TestTrexctlRun::passed_isZero()
{
    const Simulator simulator;
    const Finished done = run({u"--port"_s, simulator.port(), u"--json"_s, u"run"_s, write("3")});
    QVERIFY2(done.code == 0, done.err);
    const QJsonObject answer = done.object();
    QCOMPARE(answer[u"passed"].toBool(), true);
    QCOMPARE(answer[u"ended"].toString(), u"completed"_s);
    const QJsonObject first = answer[u"results"].toArray().at(0).toObject();
    QCOMPARE(first[u"key"].toString(), u"motor1.mean-current"_s);
    QCOMPARE(first[u"verdict"].toString(), u"passed"_s);
    QVERIFY(first[u"value"].toDouble() > 0.1 && first[u"value"].toDouble() < 3.0);
    QVERIFY(endsStopped(simulator));
}

void TestTrexctlRun::failedVerdict_isFive()
{
    const Simulator simulator;
    const Finished done =
        run({u"--port"_s, simulator.port(), u"--json"_s, u"run"_s, write("0.01")});
    QCOMPARE(done.code, 5);
    QCOMPARE(done.object()[u"passed"].toBool(true), false);
    QVERIFY(!done.err.isEmpty());
    QVERIFY(endsStopped(simulator));
}

void TestTrexctlRun::limit_isFive()
{
    const Simulator simulator;
    const Finished done = run(
        {u"--port"_s, simulator.port(), u"--json"_s, u"run"_s, write("3", R"(,"amperes":0.1)")});
    QCOMPARE(done.code, 5);
    QCOMPARE(done.object()[u"ended"].toString(), u"limit"_s);
    QVERIFY2(done.err.contains("drew"), done.err);
    QVERIFY(endsStopped(simulator));
}

void TestTrexctlRun::notInControl_isOne()
{
    const Simulator simulator({u"--mode"_s, u"rc"_s});
    const Finished done = run({u"--port"_s, simulator.port(), u"run"_s, write("3")});
    QVERIFY2(done.code == 1, done.err);
    QVERIFY(done.out.isEmpty());
    for (const QString& packet : simulator.packets(u"motor"_s)) {
        QVERIFY2(packet.endsWith(u"00"_s), qPrintable(packet));
    }
}

void TestTrexctlRun::interrupt_stopsTheMotors()
{
    const Simulator simulator;
    RunningCommand command({u"--port"_s, simulator.port(), u"run"_s, u"endurance"_s});
    QTRY_VERIFY_WITH_TIMEOUT(!simulator.packets(u"motor"_s).isEmpty(), 20'000);
    command.interrupt();
    const Finished done = command.wait();
    QVERIFY2(done.code == 130, done.err);
    QVERIFY(done.out.isEmpty());
    QVERIFY(endsStopped(simulator));
}

void TestTrexctlRun::recordAndReport_areWritten()
{
    const Simulator simulator;
    const QString record = m_folder.filePath(u"r.trexrec"_s);
    const QString report = m_folder.filePath(u"r.html"_s);
    const QStringList arguments{u"--port"_s,   simulator.port(), u"run"_s,      write("3"),
                                u"--record"_s, record,           u"--report"_s, report};
    const Finished done = run(arguments);
    QVERIFY2(done.code == 0, done.err);
    QFile html(report);
    QVERIFY(html.open(QIODevice::ReadOnly));
    const QByteArray text = html.readAll();
    QVERIFY(text.contains("TReX Jr") && text.contains("<svg") && text.contains("Serial timeout"));
    const QString csv = m_folder.filePath(u"r.csv"_s);
    const Finished exported = run({u"--json"_s, u"export"_s, record, u"--csv"_s, csv});
    QVERIFY2(exported.code == 0, exported.err);
    QVERIFY(exported.object()[u"rows"].toInt() > 20);
    // A second run overwrites nothing unasked, and sends nothing.
    const auto heard = simulator.packets().size();
    QCOMPARE(run(arguments).code, 2);
    QCOMPARE(simulator.packets().size(), heard);
}

void TestTrexctlRun::badProfile_sendsNothing()
{
    const Simulator simulator;
    QFile file(m_folder.filePath(u"bad.json"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("{\"format\":\"trexpanel-bench-profile\",\"version\":1,\"name\":\"x\",\n"
               "\"steps\":[{\"do\":\"set\",\"speed\":500}]}");
    file.close();
    for (const QString& path : {file.fileName(), u"/no/such/file"_s, u"/dev/zero"_s, u"ramp"_s}) {
        const Finished done = run({u"--port"_s, simulator.port(), u"run"_s, path});
        QCOMPARE(done.code, 2);
        QVERIFY(done.out.isEmpty());
        QCOMPARE(done.errLines().size(), 1);
    }
    QVERIFY(simulator.packets().isEmpty());
}

void TestTrexctlRun::readyProfile_isFoundByName()
{
    const Finished help = run({u"run"_s, u"--help"_s});
    QCOMPARE(help.code, 0);
    for (const char* key :
         {"step-response", "slow-ramp", "current-speed", "left-right", "braking", "endurance"}) {
        QVERIFY2(help.out.contains(key), help.out);
    }
}

QTEST_GUILESS_MAIN(TestTrexctlRun)
#include "tst_trexctl_run.moc"
