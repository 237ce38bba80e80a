// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/scriptactions.h"
#include "app/script/scriptfile.h"

#include <QTemporaryDir>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

class TestScriptFile : public QObject {
    Q_OBJECT

private slots:
    void parse_takesEveryActionOfTheContract();
    void parse_keepsTimeoutNoteAndInnerSteps();
    void parse_saysWhereAndWhatIsWrong_data();
    void parse_saysWhereAndWhatIsWrong();
    void parse_refusalIsShort();
    void read_saysWhyAFileCannotBeRead();
    void demonstrationAndStories_areScripts_data();
    void demonstrationAndStories_areScripts();
};

void TestScriptFile::parse_takesEveryActionOfTheContract()
{
    // The examples of the contract of the offscreen test mode.
    const QByteArray json = R"json({"steps":[
        {"click":"connection.connect"},
        {"set":{"object":"motors.motor1.slider","value":64}},
        {"set":{"object":"parameters.serial-timeout.editor","property":"raw","value":5}},
        {"key":{"object":"mainWindow","sequence":"Space"}},
        {"waitFor":{"object":"status.mode","property":"text","equals":"Serial (RC)"}},
        {"waitFor":{"object":"status.mode","property":"text","matches":"^Serial"}},
        {"expect":{"object":"currents.motor1.value","property":"amperes","min":0.1,"max":2}},
        {"sleepMs":500},
        {"repeat":{"until":{"object":"calibration.wizard","property":"page","equals":"review"},"max":20,"steps":[{"click":"calibration.next"}]}},
        {"screenshot":{"object":"mainWindow","file":"main.png"}},
        {"dialog":"accept"},
        {"dialog":"reject"},
        {"file":{"object":"parameters.save","path":"backup.json"}},
        {"quit":true}]})json";
    const Result<Script> script = parseScript(json, u"contract.json"_s);
    QVERIFY2(script, script ? "" : qPrintable(script.error().context));
    QCOMPARE(script->steps.size(), 14);
    QCOMPARE(script->steps.at(3).action, findAction(u"key"));
}

void TestScriptFile::parse_keepsTimeoutNoteAndInnerSteps()
{
    const Result<Script> script = parseScript(
        R"({"steps":[{"repeat":{"until":{"object":"a","property":"b","equals":true},"max":2,
            "steps":[{"sleepMs":1},{"click":"x"}]},"timeoutMs":700,"note":"why"}, {"sleepMs":1}]})",
        u"x"_s);
    QVERIFY(script);
    QCOMPARE(script->steps.at(0).timeoutMs, 700);
    QCOMPARE(script->steps.at(0).note, u"why"_s);
    QCOMPARE(script->steps.at(0).steps.size(), 2);
    QCOMPARE(script->steps.at(0).steps.at(1).argument.toString(), u"x"_s);
    QVERIFY(!script->steps.at(1).timeoutMs);
}

void TestScriptFile::parse_saysWhereAndWhatIsWrong_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* name, const char* json, const QString& said) {
        QTest::newRow(name) << QByteArray(json) << said;
    };
    row("empty", "", u"line 1, column 1"_s);
    row("cut off", "{\"steps\":[\n {\"click\":", u"line 2"_s);
    row("binary", "\x01\x02\xff", u"line 1"_s);
    row("not an object", "[1]", u"no \"steps\""_s);
    row("no steps", "{\"step\":[]}", u"no \"steps\""_s);
    row("steps no list", R"({"steps":{}})", u"\"steps\" is not a list"_s);
    row("step no object", R"({"steps":[{"sleepMs":1},7]})", u"step 1: not an object"_s);
    row("no action", R"({"steps":[{"note":"x"}]})", u"step 0: no action"_s);
    row("unknown action", R"({"steps":[{"sleepMs":1},{"clik":"x"}]})",
        u"step 1: there is no action \"clik\""_s);
    row("two actions", R"({"steps":[{"click":"a","sleepMs":1}]})",
        u"step 0: more than one action"_s);
    row("bad timeout", R"({"steps":[{"click":"a","timeoutMs":-1}]})", u"timeoutMs"_s);
    row("text timeout", R"({"steps":[{"click":"a","timeoutMs":"5"}]})", u"timeoutMs"_s);
    row("click no name", R"({"steps":[{"click":7}]})", u"click: not an object's name"_s);
    row("set no value", R"({"steps":[{"set":{"object":"a"}}]})", u"set: \"value\""_s);
    row("set list", R"({"steps":[{"set":{"object":"a","value":[1]}}]})", u"set: \"value\""_s);
    row("set no object", R"({"steps":[{"set":{"value":1}}]})", u"set: \"object\" is missing"_s);
    row("set unknown field", R"({"steps":[{"set":{"object":"a","value":1,"x":1}}]})",
        u"set: there is no field \"x\""_s);
    row("key unknown", R"({"steps":[{"key":{"object":"a","sequence":"Hyperspace"}}]})",
        u"key: there is no key"_s);
    row("waitFor nothing asked", R"({"steps":[{"waitFor":{"object":"a","property":"b"}}]})",
        u"waitFor: neither"_s);
    row("waitFor no property", R"({"steps":[{"waitFor":{"object":"a","equals":1}}]})",
        u"\"property\" is missing"_s);
    row("expect bad pattern",
        R"({"steps":[{"expect":{"object":"a","property":"b","matches":"("}}]})",
        u"expect: \"matches\""_s);
    row("expect text bound", R"({"steps":[{"expect":{"object":"a","property":"b","min":"1"}}]})",
        u"expect: \"min\""_s);
    row("sleep text", R"({"steps":[{"sleepMs":"x"}]})", u"sleepMs: not a number"_s);
    row("sleep negative", R"({"steps":[{"sleepMs":-5}]})", u"sleepMs: not a number"_s);
    row("repeat without max",
        R"({"steps":[{"repeat":{"until":{"object":"a","property":"b","equals":1},"steps":[]}}]})",
        u"repeat: \"max\""_s);
    row("repeat bad until", R"({"steps":[{"repeat":{"until":{"object":"a"},"max":1,"steps":[]}}]})",
        u"repeat: until:"_s);
    row("repeat inner",
        R"({"steps":[{"repeat":{"until":{"object":"a","property":"b","equals":1},"max":1,"steps":[{"zoom":1}]}}]})",
        u"step 0, step 0: there is no action \"zoom\""_s);
    row("quit false", R"({"steps":[{"quit":false}]})", u"quit: only true"_s);
    row("screenshot no file", R"({"steps":[{"screenshot":{"object":"a"}}]})",
        u"screenshot: \"file\""_s);
    row("dialog maybe", R"({"steps":[{"dialog":"maybe"}]})", u"dialog: neither"_s);
    row("file no path", R"({"steps":[{"file":{"object":"a"}}]})", u"file: \"path\""_s);
}

void TestScriptFile::parse_saysWhereAndWhatIsWrong()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, said);
    const Result<Script> script = parseScript(json, u"bad.json"_s);
    QVERIFY(!script);
    QCOMPARE(script.error().code, ErrorCode::FileMalformed);
    QVERIFY2(script.error().context.startsWith(u"bad.json"_s), qPrintable(script.error().context));
    QVERIFY2(script.error().context.contains(said), qPrintable(script.error().context));
}

void TestScriptFile::parse_refusalIsShort()
{
    const QByteArray name(100'000, 'x');
    const auto script = parseScript("{\"steps\":[{\"" + name + "\":1}]}", u"x"_s);
    QVERIFY(!script && script.error().context.startsWith(u"x, step 0: there is no action \"xxx"_s));
    QVERIFY(script.error().context.size() < 300);
}

void TestScriptFile::read_saysWhyAFileCannotBeRead()
{
    const QTemporaryDir folder;
    const Result<Script> missing = readScript(folder.filePath(u"missing.json"_s));
    QVERIFY(!missing);
    QCOMPARE(missing.error().code, ErrorCode::FileUnreadable);
    QVERIFY(missing.error().context.contains(u"missing.json"_s));
    const Result<Script> isFolder = readScript(folder.path());
    QVERIFY(!isFolder);
    QCOMPARE(isFolder.error().code, ErrorCode::FileUnreadable);
}

void TestScriptFile::demonstrationAndStories_areScripts_data()
{
    QTest::addColumn<QString>("path");
    QTest::newRow("demonstration") << u":/script/demo.json"_s;
    const QDir stories(QStringLiteral(TREX_SOURCE_DIR "/tests/scripts"));
    const QStringList files = stories.entryList({u"*.json"_s}, QDir::Files);
    QVERIFY(!files.isEmpty());
    for (const QString& file : files) {
        QTest::newRow(qPrintable(file)) << stories.filePath(file);
    }
}

void TestScriptFile::demonstrationAndStories_areScripts()
{
    QFETCH(QString, path);
    const Result<Script> script = readScript(path);
    QVERIFY2(script, script ? "" : qPrintable(script.error().context));
    QVERIFY(script->steps.size() > 3);
}

QTEST_GUILESS_MAIN(TestScriptFile)
#include "tst_scriptfile.moc"
