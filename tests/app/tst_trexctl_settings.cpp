// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters, whole configurations, guided calibration, and what trexctl remembers.
#include "tests/app/commandrunner.h"

#include <QDir>
#include <QFile>
#include <QTest>

using namespace Qt::Literals::StringLiterals;

class tst_trexctl_settings : public QObject {
    Q_OBJECT

private slots:
    void list_hasAllButTheTrigger();
    void list_knowsOldFirmware();
    void get_byKeyAndNumber();
    void set_takesUnits_data();
    void set_takesUnits();
    void set_withoutVerify();
    void reset_resets();
    void config_roundTrip();
    void config_dryRunWritesNothing();
    void config_refusalPutsAllBack();
    void whatIsThereAlready_isNotWritten();
    void configDiff_ofTwoFilesNeedsNoController();
    void configDiff_againstDefaultsNamesGuesses();
    void configFile_ofTheOtherModelIsAdapted();
    void learn_learnsAllFive();
    void learn_interruptedChangesNothing();
    void port_isRemembered();
    void damagedSettings_areKeptAside();
    void settingsDamagedAndNoPort_isRefused();
    void verbose_logsToStderr();

private:
    static QStringList ask(const Simulator& simulator, const QString& command)
    {
        return QStringList{u"--port"_s, simulator.port(), u"--json"_s} + words(command);
    }
    static QString settingsPath()
    {
        return qEnvironmentVariable("XDG_CONFIG_HOME") + u"/trexpanel/trexpanel.ini"_s;
    }
};

void tst_trexctl_settings::list_hasAllButTheTrigger()
{
    Simulator simulator;
    const QJsonArray list = run(ask(simulator, u"param list"_s)).array();
    QCOMPARE(list.size(), 28);
    int last = -1;
    for (const QJsonValue& row : list) {
        for (const auto& key : {"number"_L1, "key"_L1, "name"_L1, "value"_L1, "default"_L1,
                                "unit"_L1, "physical"_L1, "needsReset"_L1, "pending"_L1}) {
            QVERIFY2(!row[key].isUndefined(), key.data());
        }
        QVERIFY(row["number"_L1].toInt() > last);
        last = row["number"_L1].toInt();
        QCOMPARE(row["needsReset"_L1].toBool(), last >= 0x7B); // C-39
        QCOMPARE(row["pending"_L1], false);
        QVERIFY(row["key"_L1] != "factory-reset"_L1);
    }
}

void tst_trexctl_settings::list_knowsOldFirmware()
{
    Simulator simulator({u"--firmware"_s, u"1.1"_s});
    const Finished done = run(ask(simulator, u"param list"_s));
    QVERIFY2(done.code == 0, done.err);
    QCOMPARE(done.array().size(), 27); // 0x17 came with 1.2
}

void tst_trexctl_settings::get_byKeyAndNumber()
{
    Simulator simulator({u"--param"_s, u"serial-timeout=5"_s});
    const QJsonObject byKey = run(ask(simulator, u"param get serial-timeout"_s)).object();
    QCOMPARE(byKey["number"_L1], 7);
    QCOMPARE(byKey["value"_L1], 5);
    QCOMPARE(byKey["unit"_L1], "ms"_L1);
    QCOMPARE(byKey["physical"_L1], 500);
    QCOMPARE(run(ask(simulator, u"param get 7"_s)).object(), byKey);
    QCOMPARE(run(ask(simulator, u"param get 0x07"_s)).object(), byKey);
}

void tst_trexctl_settings::set_takesUnits_data()
{
    QTest::addColumn<QString>("arguments");
    QTest::addColumn<int>("raw");
    QTest::addColumn<bool>("isNoted");
    QTest::newRow("raw") << u"serial-timeout 5"_s << 5 << false;
    QTest::newRow("hex") << u"0x07 0x06"_s << 6 << false;
    QTest::newRow("ms") << u"serial-timeout 700ms"_s << 7 << false;
    QTest::newRow("s") << u"serial-timeout 0.8s"_s << 8 << false;
    QTest::newRow("A") << u"motor1-current-limit 2.4A"_s << 30 << false;
    QTest::newRow("mA") << u"motor1-current-limit 2480mA"_s << 31 << false;
    QTest::newRow("between two") << u"motor1-current-limit 2.5A"_s << 31 << true;
    QTest::newRow("10 ms") << u"motor2-brake-duration 120ms"_s << 12 << false;
}

void tst_trexctl_settings::set_takesUnits()
{
    QFETCH(QString, arguments);
    QFETCH(int, raw);
    QFETCH(bool, isNoted);
    Simulator simulator;
    const Finished done = run(ask(simulator, u"param set "_s + arguments));
    QVERIFY2(done.code == 0, done.err);
    QCOMPARE(done.object().keys(),
             (QStringList{u"from"_s, u"key"_s, u"needsReset"_s, u"to"_s, u"verified"_s}));
    QCOMPARE(done.object()["from"_L1], 0);
    QCOMPARE(done.object()["to"_L1], raw);
    QCOMPARE(done.object()["verified"_L1], true);
    QCOMPARE(done.object()["needsReset"_L1], false);
    QCOMPARE(done.errLines().size(), isNoted ? 1 : 0);
    const QString key = words(arguments).front();
    QCOMPARE(run(ask(simulator, u"param get "_s + key)).object()["value"_L1], raw);
}

void tst_trexctl_settings::set_withoutVerify()
{
    Simulator simulator;
    const Finished done = run(ask(simulator, u"param set 0x0E 20 --no-verify"_s));
    QCOMPARE(done.code, 0);
    QCOMPARE(done.object()["verified"_L1], false);
    QCOMPARE(simulator.packets().last(), u"AF0E14552A"_s); // not asked for again
}

void tst_trexctl_settings::reset_resets()
{
    Simulator simulator({u"--param"_s, u"motor1-acceleration=9"_s});
    QCOMPARE(run(ask(simulator, u"calibration set 1 2510 3710 4910 77"_s)).code, 0);
    const Finished done = run(ask(simulator, u"param reset --yes"_s));
    QVERIFY2(done.code == 0, done.err);
    QCOMPARE(done.object(), (QJsonObject{{u"reset"_s, true}, {u"needsReset"_s, true}}));
    simulator.powerCycle();
    QTRY_COMPARE(run(ask(simulator, u"param get 0x0E"_s)).object()["value"_L1], 0);
    const QJsonArray kept = run(ask(simulator, u"calibration get 1"_s)).array(); // C-60
    QCOMPARE(kept[0]["deadband"_L1], 77);
}

void tst_trexctl_settings::config_roundTrip()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"c.json"_s);
    Simulator first(
        {u"--param"_s, u"serial-timeout=5"_s, u"--param"_s, u"motor2-acceleration=40"_s});
    QCOMPARE(run(ask(first, u"calibration set 1 2600 3700 4900 60"_s)).code, 0);
    QCOMPARE(run(ask(first, u"config save "_s + path)).code, 0);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject saved = QJsonDocument::fromJson(file.readAll()).object();
    QCOMPARE(saved["format"_L1], "trexpanel-configuration"_L1);
    QCOMPARE(saved["parameters"_L1].toObject().size(), 28);
    QCOMPARE(saved["parameters"_L1]["serial-timeout"_L1]["physical"_L1], 500);
    QCOMPARE(saved["calibration"_L1]["rc"_L1]["1"_L1]["neutral"_L1], 3700);
    QCOMPARE(run(ask(first, u"config diff "_s + path)).object()["changed"_L1].toArray().size(), 0);

    Simulator second;
    const Finished diff = run(ask(second, u"config diff "_s + path));
    QCOMPARE(diff.code, 0);
    QCOMPARE(diff.object().keys(), (QStringList{u"changed"_s, u"needsReset"_s}));
    QCOMPARE(diff.object()["changed"_L1].toArray().size(), 2 + 4);
    const Finished load = run(ask(second, u"config load "_s + path));
    QVERIFY2(load.code == 0, load.err);
    QCOMPARE(load.object()["changed"_L1], diff.object()["changed"_L1]);
    QStringList keys;
    for (const QJsonValue& change : load.object()["changed"_L1].toArray()) {
        keys << change["key"_L1].toString();
    }
    QVERIFY2(keys.contains(u"calibration.rc.1.minimum"_s), qPrintable(keys.join(u' ')));
    QCOMPARE(load.object()["needsReset"_L1], false);
    QCOMPARE(run(ask(second, u"config diff "_s + path)).object()["changed"_L1].toArray().size(), 0);
    QCOMPARE(run(ask(second, u"param get 7"_s)).object()["value"_L1], 5);
}

void tst_trexctl_settings::config_dryRunWritesNothing()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"c.json"_s);
    Simulator other({u"--param"_s, u"serial-timeout=5"_s});
    QCOMPARE(run(ask(other, u"config save "_s + path)).code, 0);
    Simulator simulator;
    const Finished done = run(ask(simulator, u"config load --dry-run "_s + path));
    QCOMPARE(done.code, 0);
    QCOMPARE(done.object()["changed"_L1].toArray().size(), 1);
    QCOMPARE(done.object()["packets"_L1].toArray(), QJsonArray{u"AF0705552A"_s});
    QVERIFY(simulator.packets(u"setting"_s).isEmpty());
}

void tst_trexctl_settings::config_refusalPutsAllBack()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"c.json"_s);
    Simulator other({u"--param"_s, u"serial-timeout=5"_s});
    QCOMPARE(run(ask(other, u"config save "_s + path)).code, 0);
    Simulator simulator({u"--mode"_s, u"rc"_s});
    const Finished done = run(ask(simulator, u"config load "_s + path));
    QCOMPARE(done.code, 1);
    QVERIFY(done.out.isEmpty());
    QCOMPARE(done.errLines().size(), 1);
    QCOMPARE(run(ask(simulator, u"param get 7"_s)).object()["value"_L1], 0);
}

void tst_trexctl_settings::whatIsThereAlready_isNotWritten()
{
    const auto bytesWritten = [](const Simulator& simulator) {
        int sum = 0;
        for (const QJsonObject& entry : simulator.log()) {
            sum += entry["event"_L1] == "eeprom"_L1 ? entry["writes"_L1].toInt() : 0;
        }
        return sum;
    };
    QTemporaryDir folder;
    const QString path = folder.filePath(u"c.json"_s);
    Simulator simulator;
    QCOMPARE(run(ask(simulator, u"param set serial-timeout 500ms"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"calibration set 1 2600 3700 4900 60"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"config save "_s + path)).code, 0);
    QTRY_COMPARE(bytesWritten(simulator), 1 + 8); // so the counter counts
    QCOMPARE(run(ask(simulator, u"config load "_s + path)).code, 0);
    QCOMPARE(run(ask(simulator, u"param set serial-timeout 5"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"calibration set 1 2600 3700 4900 60"_s)).code, 0);
    QCOMPARE(run(ask(simulator, u"info"_s)).code, 0);
    QCOMPARE(simulator.packets(u"setting"_s).size(), 2);
    QCOMPARE(bytesWritten(simulator), 1 + 8);
}

void tst_trexctl_settings::configDiff_ofTwoFilesNeedsNoController()
{
    QTemporaryDir folder;
    const auto file = [&folder](const QString& name, const QByteArray& members) {
        QFile written(folder.filePath(name));
        const bool isOpen = written.open(QIODevice::WriteOnly);
        written.write(R"({"format":"trexpanel-configuration","version":1,)" + members + '}');
        return isOpen ? written.fileName() : QString();
    };
    const QString first = file(
        u"a.json"_s, R"("parameters":{"serial-timeout":{"raw":5},"aux-acceleration":{"raw":1}})");
    const QString second = file(
        u"b.json"_s,
        R"("parameters":{"serial-timeout":{"raw":8}},"calibration":{"analog":{"2":{"minimum":0,"neutral":500,"maximum":1000,"deadband":9}}})");
    const Finished done =
        run(u"--json --port /dev/none config diff %1 %2"_s.arg(first, second).split(u' '));
    QVERIFY2(done.code == 0, done.err);
    const QJsonArray changed = done.object()["changed"_L1].toArray();
    QCOMPARE(changed.size(), 1 + 4);
    QCOMPARE(changed[0].toObject(),
             (QJsonObject{{u"key"_s, u"serial-timeout"_s}, {u"from"_s, 5}, {u"to"_s, 8}}));
    QCOMPARE(changed[1]["key"_L1], "calibration.analog.2.minimum"_L1);
    QCOMPARE(done.object()["onlyInFirst"_L1].toArray(), QJsonArray{u"aux-acceleration"_s});
    QCOMPARE(run({u"config"_s, u"diff"_s}).code, 2);
    QCOMPARE(run({u"config"_s, u"diff"_s, u"--defaults"_s, first}).code, 2);
    QCOMPARE(run({u"config"_s, u"diff"_s, first, u"/no/such"_s}).code, 2);
}

void tst_trexctl_settings::configDiff_againstDefaultsNamesGuesses()
{
    Simulator simulator(
        {u"--param"_s, u"serial-timeout=5"_s, u"--param"_s, u"motor1-pwm-prescaler=2"_s});
    const Finished done = run(ask(simulator, u"config diff --defaults"_s));
    QVERIFY2(done.code == 0, done.err);
    QCOMPARE(done.object()["changed"_L1].toArray().size(), 2);
    QCOMPARE(done.object()["changed"_L1][0],
             (QJsonObject{{u"key"_s, u"serial-timeout"_s}, {u"from"_s, 5}, {u"to"_s, 0}}));
    QVERIFY2(done.err.contains("guesses: serial-timeout."),
             done.err); // the prescaler's is documented
}

void tst_trexctl_settings::configFile_ofTheOtherModelIsAdapted()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"c.json"_s);
    Simulator jr(
        {u"--param"_s, u"motor1-current-limit=30"_s, u"--param"_s, u"uart-response-delay=1"_s});
    QCOMPARE(run(ask(jr, u"config save "_s + path)).code, 0);
    Simulator trex({u"--model"_s, u"trex"_s, u"--firmware"_s, u"1.1"_s});
    const Finished done = run(ask(trex, u"config load "_s + path));
    QVERIFY2(done.code == 0, done.err);
    QCOMPARE(run(ask(trex, u"param get motor1-current-limit"_s)).object()["value"_L1], 8); // 2.4 A
    for (const char* sentence :
         {"is of a TReX Jr, the controller is a TReX", "about 2.40 A (inferred) (raw 8)",
          "left out, since firmware 1.1"}) {
        QVERIFY2(done.err.contains(sentence), done.err);
    }
}

void tst_trexctl_settings::learn_learnsAllFive()
{
    QTemporaryDir folder;
    QFile scenario(folder.filePath(u"s.json"_s));
    QVERIFY(scenario.open(QIODevice::WriteOnly));
    scenario.write(R"({"stick":{"neutralSeconds":3,"sweepSeconds":5}})");
    scenario.close();
    Simulator simulator({u"--scenario"_s, scenario.fileName()});
    const Finished done = run(ask(simulator,
                                  u"calibration learn --yes --neutral-seconds 1 "
                                  "--sweep-seconds 5"_s),
                              60'000);
    QVERIFY2(done.code == 0, done.err);
    QVERIFY2(done.err.isEmpty(), done.err);
    QCOMPARE(done.array().size(), 5);
    const QJsonArray read = run(ask(simulator, u"calibration get"_s)).array();
    QCOMPARE(read, done.array());
    for (const QJsonValue& row : read) {
        QCOMPARE(row["learned"_L1], true);
        QVERIFY(row["minimum"_L1].toInt() <= row["neutral"_L1].toInt());
        QVERIFY(row["neutral"_L1].toInt() <= row["maximum"_L1].toInt());
    }
}

void tst_trexctl_settings::learn_interruptedChangesNothing()
{
    Simulator simulator;
    const QByteArray before = run(ask(simulator, u"calibration get"_s)).out;
    RunningCommand command(ask(simulator, u"calibration learn --yes"_s));
    QTRY_VERIFY(simulator.packets().filter(u"861F"_s).size() > 5); // it collects
    command.interrupt();
    const Finished done = command.wait(3000);
    QCOMPARE(done.code, 130);
    QVERIFY(done.out.isEmpty());
    QVERIFY(simulator.packets(u"setting"_s).isEmpty());
    QCOMPARE(run(ask(simulator, u"calibration get"_s)).out, before);
}

void tst_trexctl_settings::port_isRemembered()
{
    QFile::remove(settingsPath());
    QCOMPARE(run({u"info"_s}).code, 0); // nothing remembered: the built-in simulator
    Simulator simulator;
    const auto heard = [&] { return simulator.packets().size(); };
    QCOMPARE(run({u"--port"_s, simulator.port(), u"info"_s}).code, 0);
    const qsizetype first = heard();
    QVERIFY(first > 0);
    QCOMPARE(run({u"info"_s}).code, 0);
    QTRY_VERIFY(heard() > first); // the same one again
    QCOMPARE(run({u"--port"_s, u"/dev/ttyNothing9"_s, u"info"_s}).code, 4);
    const qsizetype second = heard();
    QCOMPARE(run({u"info"_s}).code, 0);
    QTRY_VERIFY(heard() > second); // what failed is not remembered
    QFile::remove(settingsPath());
}

void tst_trexctl_settings::damagedSettings_areKeptAside()
{
    QFile::remove(settingsPath() + u".damaged"_s);
    QFile file(settingsPath());
    QDir().mkpath(QFileInfo(file).absolutePath());
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    const QByteArray damaged("\0\x01garbage\nline/lastPort=sim:\n", 29);
    file.write(damaged);
    file.close();
    const Finished done = run({u"--port"_s, u"sim:"_s, u"info"_s});
    QVERIFY2(done.code == 0, done.err);
    QFile kept(settingsPath() + u".damaged"_s);
    QVERIFY(kept.open(QIODevice::ReadOnly));
    QCOMPARE(kept.readAll(), damaged);
    kept.remove();
    QFile::remove(settingsPath());
}

void tst_trexctl_settings::settingsDamagedAndNoPort_isRefused()
{
    QFile file(settingsPath());
    QDir().mkpath(QFileInfo(file).absolutePath());
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write("[line]\nnonsense\n");
    file.close();
    // Driving the simulator in place of the controller that was meant would be a lie.
    const Finished done = run(words(u"motor 1 set 5"_s));
    QCOMPARE(done.code, 2);
    QVERIFY(done.out.isEmpty());
    QCOMPARE(done.errLines().size(), 1);
    QVERIFY2(done.err.contains(":2"), done.err); // the line
    QFile::remove(settingsPath() + u".damaged"_s);
    QFile::remove(settingsPath());
}

void tst_trexctl_settings::verbose_logsToStderr()
{
    const Finished plain = run({u"--port"_s, u"sim:"_s, u"--json"_s, u"info"_s});
    const Finished one = run({u"--port"_s, u"sim:"_s, u"--json"_s, u"-v"_s, u"info"_s});
    const Finished two = run({u"--port"_s, u"sim:"_s, u"--json"_s, u"-vv"_s, u"info"_s});
    QCOMPARE(one.out, plain.out);
    QCOMPARE(two.out, plain.out);
    QVERIFY(plain.err.isEmpty());
    QVERIFY(one.errLines().size() >= 4);
    QVERIFY(!one.err.contains("> 82"));
    QVERIFY2(two.err.contains("> 82  < 72"), two.err);
}

QTEST_GUILESS_MAIN(tst_trexctl_settings)
#include "tst_trexctl_settings.moc"
