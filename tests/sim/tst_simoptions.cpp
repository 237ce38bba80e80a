// SPDX-License-Identifier: GPL-3.0-or-later
#include "simbench.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace trex;
using namespace trex::sim;

class TstSimOptions : public QObject {
    Q_OBJECT
private slots:
    void address_isTakenApart();
    void address_mistakesAreNamed_data();
    void address_mistakesAreNamed();
    void assignments_mistakesChangeNothing();
    void parameters_byKeyOrNumber();
    void scenario_isReadWhole();
    void scenario_mistakesAreNamed_data();
    void scenario_mistakesAreNamed();
    void scenario_refusalNamesTheFileAndIsShort();
    void scenario_fileMustBeThere();
    void state_outlivesTheLine();
    void state_decidesTheLine();
    void state_thatMakesNoSenseIsLeftAlone();
};

void TstSimOptions::address_isTakenApart()
{
    const auto plain = simOptionsFromUrl(QStringLiteral("sim:"));
    QVERIFY(plain);
    QCOMPARE(plain->mode, JumperMode::Serial);
    const auto options = simOptionsFromUrl(QStringLiteral(
        "sim:?mode=rc&seed=3&state=/a%20b&baud=115200&pace=1&echo=1&fault=drop=0.1&quirk="
        "null-command=error&param=serial-timeout=5&model=trex&mix=1&error-detection=crc7&"
        "crc-polynomial=0x91&stop-bits=2&device=3&device=4&speed=2&firmware=1.1&fault=delay=5"));
    QVERIFY(options);
    QCOMPARE(options->mode, JumperMode::Rc);
    QCOMPARE(options->seed, quint64(3));
    QCOMPARE(options->stateFile, QStringLiteral("/a b"));
    QCOMPARE(options->baud, 115200);
    QVERIFY(options->pace && options->echo && options->mix);
    QCOMPARE(options->faults.drop, 0.1);
    QCOMPARE(options->faults.delayMs, 5.0);
    QVERIFY(options->quirks.nullCommandIsError);
    QCOMPARE(options->parameters, (std::map<int, int>{{7, 5}}));
    QCOMPARE(options->model, Model::Trex);
    QCOMPARE(options->errorDetection, ErrorDetection::Crc7);
    QCOMPARE(int(options->polynomial), 0x91);
    QCOMPARE(options->stopBits, 2);
    QCOMPARE(options->devices, (std::vector<int>{3, 4}));
    QCOMPARE(options->speed, 2.0);
    QCOMPARE(options->firmware.minor, 1);
}

void TstSimOptions::address_mistakesAreNamed_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("named");
    const auto row = [](const char* address, const char* named) {
        QTest::newRow(address) << QString::fromLatin1(address) << QString::fromLatin1(named);
    };
    row("tcp:", "sim:");
    row("sim:x", "\"x\"");
    row("sim:?colour=red", "colour");
    row("sim:?mode", "mode");
    row("sim:?mode=boat", "boat");
    row("sim:?model=boat", "boat");
    row("sim:?firmware=2.0", "2.0");
    row("sim:?seed=x", "seed");
    row("sim:?baud=1", "baud");
    row("sim:?baud=1201", "1201");
    row("sim:?pace=2", "pace");
    row("sim:?device=128", "device");
    row("sim:?crc-polynomial=0x7F", "crc-polynomial");
    row("sim:?stop-bits=3", "stop-bits");
    row("sim:?error-detection=some", "some");
    row("sim:?speed=0", "speed");
    row("sim:?speed=nan", "speed");
    row("sim:?fault=fire=1", "fire");
    row("sim:?fault=drop=1.5", "drop");
    row("sim:?fault=drop=-1", "drop");
    row("sim:?fault=drop=x", "drop");
    row("sim:?fault=drop", "drop");
    row("sim:?quirk=odd=1", "odd");
    row("sim:?quirk=null-command=maybe", "silent or error");
    row("sim:?param=speed=1", "speed");
    row("sim:?param=serial-timeout=128", "0 to 127");
    row("sim:?param=serial-timeout=x", "serial-timeout");
    row("sim:?param=uart-settings=11", "uart-settings");
    row("sim:?param=factory-reset=127", "factory-reset");
    row("sim:?scenario=/nowhere.json", "/nowhere.json");
}

void TstSimOptions::address_mistakesAreNamed()
{
    QFETCH(QString, address);
    QFETCH(QString, named);
    const auto options = simOptionsFromUrl(address);
    QVERIFY(!options);
    QVERIFY2(options.error().context.contains(named), qPrintable(options.error().context));
}

void TstSimOptions::assignments_mistakesChangeNothing()
{
    SimOptions options;
    QVERIFY(!options.applyFault(QStringLiteral("drop=2")));
    QVERIFY(!options.applyQuirk(QStringLiteral("safe-start=maybe")));
    QVERIFY(!options.applyParameter(QStringLiteral("device-number=200")));
    QCOMPARE(options.faults, Faults{});
    QCOMPARE(options.quirks, Quirks{});
    QVERIFY(options.parameters.empty());
}

void TstSimOptions::parameters_byKeyOrNumber()
{
    SimOptions options;
    QVERIFY(options.applyParameter(QStringLiteral("serial-timeout=0x10")));
    QVERIFY(options.applyParameter(QStringLiteral("0x08=1")));
    QVERIFY(options.applyParameter(QStringLiteral("14=3")));
    QCOMPARE(options.parameters, (std::map<int, int>{{7, 16}, {8, 1}, {14, 3}}));
}

void TstSimOptions::scenario_isReadWhole()
{
    const auto scenario = parseScenario(
        R"({"channels":[{"channel":1,"wave":"sine","minimum":2500,"maximum":5000,"period":2.0,
            "from":0,"to":10,"jitter":2,"missing":0.1}],
            "stick":{"neutralSeconds":3,"sweepSeconds":6},
            "events":[{"t":1.0,"set":{"load1":0.4,"stall2":true,"mode":"rc","mix":true,
            "parameter":{"serial-timeout":5},"powerCycle":true}},
            {"t":2.0,"fault":{"silent-for":2}}]})",
        QStringLiteral("s.json"));
    QVERIFY2(scenario, scenario ? "" : qPrintable(scenario.error().context));
    QCOMPARE(scenario->channels.size(), std::size_t(1));
    QCOMPARE(scenario->channels[0].wave, Wave::Sine);
    QCOMPARE(scenario->channels[0].missing, 0.1);
    QCOMPARE(scenario->stick->sweepSeconds, 6.0);
    QCOMPARE(scenario->events.size(), std::size_t(2));
    QCOMPARE(scenario->events[0].load[0], std::optional(0.4));
    QCOMPARE(scenario->events[0].stall[1], std::optional(true));
    QCOMPARE(scenario->events[0].parameters, (std::map<int, int>{{7, 5}}));
    QVERIFY(scenario->events[0].powerCycle);
    QCOMPARE(scenario->events[1].faults.at(0).first, QStringLiteral("silent-for"));
}

void TstSimOptions::scenario_mistakesAreNamed_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("named");
    const auto row = [](const char* json, const char* named) {
        QTest::newRow(json) << QByteArray(json) << QString::fromLatin1(named);
    };
    row("{\n\n \"channels\": }", "line 3");
    row("[]", "object");
    row(R"({"canals":[]})", "canals");
    row(R"({"channels":{}})", "channels");
    row(R"({"channels":[{"wave":"sine"}]})", "channels[0].channel");
    row(R"({"channels":[{"channel":6,"wave":"sine"}]})", "channels[0].channel");
    row(R"({"channels":[{"channel":1.5,"wave":"sine"}]})", "channels[0].channel");
    row(R"({"channels":[{"channel":1}]})", "channels[0].wave");
    row(R"({"channels":[{"channel":1,"wave":"saw"}]})", "channels[0].wave");
    row(R"({"channels":[{"channel":1,"wave":"sine","minimum":"a"}]})", "channels[0].minimum");
    row(R"({"channels":[{"channel":1,"wave":"sine","minimum":9,"maximum":8}]})", "minimum");
    row(R"({"channels":[{"channel":1,"wave":"sine","period":0}]})", "channels[0].period");
    row(R"({"channels":[{"channel":1,"wave":"sine","phase":0}]})", "channels[0].phase");
    row(R"({"stick":3})", "stick");
    row(R"({"stick":{"sweepSeconds":-1}})", "stick.sweepSeconds");
    row(R"({"events":[{"set":{}}]})", "events[0].t");
    row(R"({"events":[{"t":-1}]})", "events[0].t");
    row(R"({"events":[{"t":1,"set":{"load1":2}}]})", "events[0].set.load1");
    row(R"({"events":[{"t":1,"set":{"stall1":1}}]})", "events[0].set.stall1");
    row(R"({"events":[{"t":1,"set":{"mode":"boat"}}]})", "events[0].set.mode");
    row(R"({"events":[{"t":1,"set":{"parameter":{"x":1}}}]})", "events[0].set.parameter.x");
    row(R"({"events":[{"t":1,"set":{"parameter":{"serial-timeout":200}}}]})", "serial-timeout");
    row(R"({"events":[{"t":1,"fault":{"fire":1}}]})", "events[0].fault.fire");
    row(R"({"events":[{"t":1,"fault":{"drop":2}}]})", "events[0].fault.drop");
}

void TstSimOptions::scenario_mistakesAreNamed()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, named);
    const auto scenario = parseScenario(json, QStringLiteral("s.json"));
    QVERIFY(!scenario);
    QCOMPARE(scenario.error().code, ErrorCode::FileMalformed);
    QVERIFY2(scenario.error().context.contains(named), qPrintable(scenario.error().context));
    QVERIFY(scenario.error().context.startsWith(QLatin1String("s.json")));
}

void TstSimOptions::scenario_refusalNamesTheFileAndIsShort()
{
    const QString name = QStringLiteral("50%2.json");
    const auto syntax = parseScenario("{\n,", name);
    QVERIFY(!syntax && syntax.error().context.startsWith(QStringLiteral("50%2.json, line 2: ")));
    const auto key = parseScenario("{\"" + QByteArray(100'000, 'x') + "\":1}", name);
    QVERIFY(!key && key.error().context.startsWith(QStringLiteral("50%2.json: \"xxx")));
    QVERIFY(key.error().context.size() < 300);
}

void TstSimOptions::scenario_fileMustBeThere()
{
    SimOptions options;
    const auto loaded = options.loadScenario(QStringLiteral("/nowhere/s.json"));
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, ErrorCode::FileUnreadable);
}

// C-40
void TstSimOptions::state_outlivesTheLine()
{
    QTemporaryDir folder;
    SimOptions options;
    options.stateFile = folder.filePath(QStringLiteral("state.json"));
    options.devices = {7, 8};
    {
        SimBench bench(options);
        QCOMPARE(bench.askByte("80 08 2F 07 05 55 2A", 10), 0);
        QCOMPARE(bench.askByte("80 07 20 3C 13 35 1C 08 27 7D 00 55 2A", 50), 0);
        QVERIFY(!QFile::exists(options.stateFile));
        QVERIFY(bench.line.saveState());
        QVERIFY(QFile::exists(options.stateFile));
        QCOMPARE(bench.askByte("80 08 2F 07 06 55 2A", 10), 0);
    }
    SimBench again(options);
    QVERIFY(!again.line.stateError());
    QCOMPARE(again.askByte("80 08 1F 07"), 6);
    QCOMPARE(again.askByte("80 07 1F 07"), 0);
    QCOMPARE(again.ask("80 07 10"), QByteArray("BC09350E88137D00"));
    QCOMPARE(again.device(1).eeprom().writeCount(0x07), 2);
}

// C-39, C-53
void TstSimOptions::state_decidesTheLine()
{
    QTemporaryDir folder;
    SimOptions options;
    options.stateFile = folder.filePath(QStringLiteral("state.json"));
    options.baud = 9600;
    {
        SimBench bench(options);
        QCOMPARE(bench.device().uart().baud, 9600);
        QCOMPARE(bench.askByte("AF 7E 0A 55 2A", 10), 0);
        QCOMPARE(bench.device().uart().baud, 9600);
    }
    SimBench again(options);
    QCOMPARE(again.device().uart().baud, 115200);
}

void TstSimOptions::state_thatMakesNoSenseIsLeftAlone()
{
    QTemporaryDir folder;
    SimOptions options;
    options.stateFile = folder.filePath(QStringLiteral("state.json"));
    for (const char* text : {"{", "{}",
                             R"({"format":"trexpanel-simulator-eeprom","version":1,)"
                             R"("controllers":[{"bytes":"00"}]})"}) {
        QFile file(options.stateFile);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        {
            SimBench bench(options);
            QVERIFY(bench.line.stateError());
            QCOMPARE(bench.line.stateError()->code, ErrorCode::FileMalformed);
            QCOMPARE(bench.askByte("AF 07 05 55 2A", 10), 0);
        }
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray(text));
    }
}

QTEST_GUILESS_MAIN(TstSimOptions)
#include "tst_simoptions.moc"
