// SPDX-License-Identifier: GPL-3.0-or-later
// The watchdog proof in the real program over a pty: it passes against a controller that stops for
// silence, and fails, in words, against one that has the setting and does not act by it.
#include "tests/support/simwitness.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

class TestWatchdogPanel : public QObject {
    Q_OBJECT

private slots:
    void proof_saysWhatIsSo_data();
    void proof_saysWhatIsSo();
};

void TestWatchdogPanel::proof_saysWhatIsSo_data()
{
    QTest::addColumn<bool>("acts");
    QTest::addColumn<int>("timeout");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("passes") << true << 3
                            << QByteArray("^Watchdog proof passed: serial timeout 300 ms, it "
                                          "stopped between");
    QTest::newRow("fails") << false << 3
                           << QByteArray("^Watchdog proof FAILED: serial timeout 300 ms, the motor "
                                         "still ran after .* The motors may run on");
    QTest::newRow("is off") << true << 0
                            << QByteArray("The serial timeout is off or not known: set it first");
}

void TestWatchdogPanel::proof_saysWhatIsSo()
{
    QFETCH(bool, acts);
    QFETCH(int, timeout);
    QFETCH(QByteArray, words);
    QTemporaryDir folder;
    const QString log = folder.filePath(u"log.jsonl"_s);
    sim::SimOptions options;
    options.parameters[0x07] = timeout;
    options.quirks.serialTimeoutActs = acts;
    test::SimWitness witness(options, folder.filePath(u"port"_s), log);
    QVERIFY(witness.isOk());
    QFile file(folder.filePath(u"script.json"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    const QByteArray script = R"({"steps":[
        {"waitFor":{"object":"connection.state","property":"state","equals":"connected"},
         "timeoutMs":15000},
        {"click":"motors.arm"},{"click":"motors.proof"},
        BEGIN
        {"waitFor":{"object":"motors.proof.WHERE","property":"text","matches":"WORDS"},
         "timeoutMs":60000},
        {"expect":{"object":"motors.arm","property":"checked","equals":OFF}},
        {"screenshot":{"object":"motors.proofDialog","file":"proof-NAME.png"}},
        {"dialog":"reject"},
        {"screenshot":{"object":"log","file":"proof-log-NAME.png"}}]})";
    const QByteArray begin = R"(
        {"waitFor":{"object":"motors.proof.start","property":"enabled","equals":true}},
        {"click":"motors.proof.start"},)";
    // Where there is nothing to prove it cannot be begun, and says why.
    const QByteArray none =
        R"({"expect":{"object":"motors.proof.start","property":"enabled","equals":false}},)";
    const bool isSet = timeout > 0;
    file.write(QByteArray(script)
                   .replace("BEGIN", isSet ? begin : none)
                   .replace("WHERE", isSet ? "result" : "text")
                   .replace("OFF", isSet ? "false" : "true")
                   .replace("WORDS", words)
                   .replace("NAME", QByteArray(QTest::currentDataTag()).replace(' ', '-')));
    file.close();
    QProcess program;
    program.setProcessChannelMode(QProcess::MergedChannels);
    program.start(u"" TREX_PANEL_PROGRAM ""_s,
                  {u"--offscreen"_s, u"--port"_s, folder.filePath(u"port"_s), u"--script"_s,
                   file.fileName(), u"--screenshots"_s,
                   qEnvironmentVariable("TREX_PICTURES", folder.filePath(u"pictures"_s)),
                   u"--settings"_s, folder.filePath(u"settings.ini"_s)});
    QVERIFY(program.waitForFinished(90'000));
    QVERIFY2(program.exitCode() == 0, program.readAll().constData());
    witness.end();
    const test::SimRecord record = test::readSimRecord(log);
    QCOMPARE(record.speeds, (std::array{0, 0, 0})); // the proof ends in a stop
    QCOMPARE(record.moved.at(0), timeout > 0); // and begins with none where there is none to prove
    QCOMPARE(record.moved.at(1) || record.moved.at(2), false);
}

QTEST_GUILESS_MAIN(TestWatchdogPanel)
#include "tst_watchdogpanel.moc"
