// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/errortext.h"
#include "protocol/storage/configdiff.h"
#include "protocol/storage/configfile.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

const QString kName = u"bench.json"_s;

/// The example of the command line's contract, as it stands there.
const QByteArray kContractExample =
    R"({"format":"trexpanel-configuration","version":1,"saved":"2026-11-22T14:00:00Z","device":{"signature":"TReXJr1.2","number":7},"parameters":{"serial-timeout":{"raw":5,"physical":500,"unit":"ms"}},"calibration":{"rc":{"1":{"minimum":2500,"neutral":3750,"maximum":5000,"deadband":100}}}})";

Configuration fullConfiguration(int seed)
{
    std::minstd_rand random(static_cast<unsigned>(seed) + 1);
    const auto upTo = [&random](int most) {
        return static_cast<int>(random() % (static_cast<unsigned>(most) + 1));
    };
    Configuration full;
    full.saved = QDateTime::fromSecsSinceEpoch(1'700'000'000 + upTo(1'000'000'000), Qt::UTC);
    full.signature = seed % 3 == 0 ? u"TReX1.2"_s : u"TReXJr1.2"_s;
    if (seed % 2 == 0) { // older files do not say it
        full.firmware = u"1.2"_s;
    }
    full.deviceNumber = upTo(127);
    for (const auto& row : kParameters) {
        int raw = row.minimum + upTo(row.maximum - row.minimum);
        while (!accepts(row, raw)) {
            --raw;
        }
        if (!row.isTrigger) {
            full.parameters[row.number] = raw;
        }
    }
    for (const auto input : {InputKind::Rc, InputKind::Analog}) {
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            const int minimum = upTo(8000);
            const int neutral = minimum + upTo(4000);
            full.calibrations[input][channel] = {minimum, neutral, neutral + 1 + upTo(4000),
                                                 upTo(500)};
        }
    }
    return full;
}

/// The text between the braces of a parameter's object, changed.
QByteArray withParameter(const ParameterRow& row, const QByteArray& members)
{
    return R"({"format":"trexpanel-configuration","version":1,"parameters":{")"
        + QByteArray(row.key.data(), static_cast<qsizetype>(row.key.size())) + R"(":{)" + members
        + "}}}";
}

QByteArray withCalibration(const QByteArray& members)
{
    return R"({"format":"trexpanel-configuration","version":1,"calibration":{"rc":{"3":{)" + members
        + "}}}}";
}

void verifyRefused(const QByteArray& json, const QString& place)
{
    const auto parsed = parseConfiguration(json, kName);
    QVERIFY2(!parsed, "taken: " + json.left(300));
    const auto& context = parsed.error().context;
    QCOMPARE(parsed.error().code, ErrorCode::FileMalformed);
    QVERIFY2(context.startsWith(kName), qPrintable(context));
    QVERIFY2(context.contains(place), qPrintable(context + u" does not name "_s + place));
    QVERIFY2(!context.contains(u'\n') && context.size() < 300, qPrintable(context));
    QVERIFY(!errorText(parsed.error()).contains(u'\n'));
}

} // namespace

class TestConfigFile : public QObject {
    Q_OBJECT

private slots:
    void contractExample_isRead();
    void roundTrip_isByteStable_data();
    void roundTrip_isByteStable();
    void physical_isWrittenInItsUnit();
    void malformedParameter_isRefusedByKey_data();
    void malformedParameter_isRefusedByKey();
    void malformedFile_isRefusedWithItsPlace_data();
    void malformedFile_isRefusedWithItsPlace();
    void truncatedFile_isRefusedWithItsLine();
    void damagedFile_isRefusedOrUnderstood();
    void newerVersion_isKeptAndTold();
    void previousVersion_isOpened();
    void unexpectedValue_spoilsNoFile();
    void comments_stayWhereTheyAre();
    void comments_survivePuttingAnotherFileInPlace();
    void whatIsNeitherOursNorComment_isTold();
    void load_refusesWhatIsNoFile();
    void save_replacesWholeFilesOnly();
    void differences_nameEachNumber();
};

void TestConfigFile::contractExample_isRead()
{
    const auto parsed = parseConfiguration(kContractExample, kName);
    QVERIFY2(parsed.has_value(), qPrintable(parsed ? QString() : parsed.error().context));
    QCOMPARE(parsed->parameters, (ParameterValues{{0x07, 5}}));
    QCOMPARE(parsed->calibrations.at(InputKind::Rc).at(1), (Calibration{2500, 3750, 5000, 100}));
    QCOMPARE(parsed->saved, QDateTime({2026, 11, 22}, {14, 0}, Qt::UTC));
    QCOMPARE(parsed->signature, u"TReXJr1.2"_s);
    QCOMPARE(parsed->deviceNumber, 7);
    QVERIFY(remarkOn(*parsed).isEmpty());
}

void TestConfigFile::roundTrip_isByteStable_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 0; seed < 50; ++seed) {
        QTest::addRow("configuration %d", seed) << seed;
    }
}

void TestConfigFile::roundTrip_isByteStable()
{
    QFETCH(int, seed);
    const auto written = fullConfiguration(seed);
    const QByteArray bytes = writeConfiguration(written);
    const auto parsed = parseConfiguration(bytes, kName);
    QVERIFY2(parsed.has_value(), qPrintable(parsed ? QString() : parsed.error().context));
    QVERIFY(*parsed == written);
    QCOMPARE(writeConfiguration(*parsed), bytes);
    QVERIFY(
        bytes.startsWith("{\n    \"format\": \"trexpanel-configuration\",\n    \"version\": 1,\n"));
}

void TestConfigFile::physical_isWrittenInItsUnit()
{
    Configuration configuration;
    configuration.parameters = {{0x07, 5}, {0x13, 30}, {0x0B, 127}};
    const QByteArray bytes = writeConfiguration(configuration);
    QVERIFY(bytes.contains(R"("serial-timeout": { "raw": 5, "physical": 500, "unit": "ms" })"));
    QVERIFY(
        bytes.contains(R"("motor1-current-limit": { "raw": 30, "physical": 2.4, "unit": "A" })"));
    QVERIFY(bytes.contains(R"("motor1-pwm-maximum": { "raw": 127, "physical": 127, "unit": "" })"));
}

void TestConfigFile::malformedParameter_isRefusedByKey_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("place");
    for (const auto& row : kParameters) {
        const QByteArray key(row.key.data(), static_cast<qsizetype>(row.key.size()));
        if (row.isTrigger) {
            QTest::addRow("trigger") << withParameter(row, R"("raw":127)") << u"factory-reset"_s;
            continue;
        }
        const QString raw = u"parameters.%1.raw"_s.arg(keyText(row));
        const QByteArray beyond = QByteArray::number(row.maximum + 1);
        for (const QByteArray& value :
             {QByteArray("\"5\""), QByteArray("null"), QByteArray("true"), QByteArray("[1]"),
              QByteArray("{}"), QByteArray("0.5"), QByteArray("-1"), beyond, QByteArray("1e300")}) {
            QTest::addRow("%s raw %s", key.constData(), value.constData())
                << withParameter(row, "\"raw\":" + value) << raw;
        }
        const QByteArray good = "\"raw\":" + QByteArray::number(row.defaultRaw);
        QTest::addRow("%s raw missing", key.constData()) << withParameter(row, {}) << raw;
        QTest::addRow("%s physical", key.constData()) << withParameter(
            row,
            good + R"(,"physical":)"
                + QByteArray::number(physicalFromRaw(row, row.defaultRaw) + row.scale, 'f',
                                     2)) << u"parameters.%1.physical"_s.arg(keyText(row));
        QTest::addRow("%s physical text", key.constData())
            << withParameter(row, good + R"(,"physical":"much")")
            << u"parameters.%1.physical"_s.arg(keyText(row));
        QTest::addRow("%s unit", key.constData())
            << withParameter(row, good + R"(,"unit":"furlongs")")
            << u"parameters.%1.unit"_s.arg(keyText(row));
        QTest::addRow("%s misspelt member", key.constData())
            << withParameter(row, good + R"(,"Units":"A")")
            << u"parameters.%1.Units: is not known; is unit meant?"_s.arg(keyText(row));
        QTest::addRow("%s raw twice", key.constData())
            << withParameter(row, good + ',' + good) << raw + u": stands twice"_s;
    }
    QTest::addRow("no such baud") << withParameter(parameterRow("uart-settings"), R"("raw":11)")
                                  << u"parameters.uart-settings.raw"_s;
}

void TestConfigFile::malformedParameter_isRefusedByKey()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, place);
    verifyRefused(json, place);
}

void TestConfigFile::malformedFile_isRefusedWithItsPlace_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("place");
    const auto row = [](const char* name, const QByteArray& json, const char* place) {
        QTest::newRow(name) << json << QString::fromUtf8(place);
    };
    const QByteArray head = R"({"format":"trexpanel-configuration","version":1,)";
    row("empty", "", "line 1, column 1");
    row("blank", " \n \n", "empty");
    row("text", "hello", "line 1");
    row("list", "[]", "line 1, column 1");
    row("number", "5", "line 1");
    row("comma", "{\n  \"format\": \"trexpanel-configuration\",,\n}", "line 2");
    row("unquoted", "{\n\n  format: 1}", "line 3");
    row("garbage at end", kContractExample + "\n\n}", "line 3");
    row("invalid UTF-8", head + "\"\xff\":1}", "line 1");
    row("another format", R"({"format":"trexpanel-profile","version":1,"parameters":{}})",
        "format");
    row("no format", R"({"version":1,"parameters":{}})", "format");
    row("format is a number", R"({"format":1,"version":1,"parameters":{}})", "format");
    row("no version", R"({"format":"trexpanel-configuration","parameters":{}})", "version");
    row("version 0", R"({"format":"trexpanel-configuration","version":0,"parameters":{}})",
        "version");
    row("version text", R"({"format":"trexpanel-configuration","version":"1","parameters":{}})",
        "version");
    row("version 1.5", R"({"format":"trexpanel-configuration","version":1.5,"parameters":{}})",
        "version");
    row("nothing in it", R"({"format":"trexpanel-configuration","version":1})", "parameters");
    row("misspelt key", head + R"("parameters":{},"Calibrations":{}})",
        "Calibrations: is not known; is calibration meant?");
    row("format twice", head + R"("format":"trexpanel-configuration","parameters":{}})",
        "format: stands twice");
    row("twice, escaped", head + R"("parameters":{},"par\u0061meters":{}})",
        "parameters: stands twice");
    row("saved is a number", head + R"("saved":5,"parameters":{}})", "saved");
    row("saved is no time", head + R"("saved":"yesterday","parameters":{}})", "saved");
    row("saved on day 45", head + R"("saved":"2026-11-45T14:00:00Z","parameters":{}})", "saved");
    row("device is a text", head + R"("device":"TReXJr1.2","parameters":{}})", "device");
    row("signature", head + R"("device":{"signature":"Arduino"},"parameters":{}})",
        "device.signature");
    row("firmware number", head + R"("device":{"firmware":1.2},"parameters":{}})",
        "device.firmware");
    row("firmware name", head + R"("device":{"firmware":"newest"},"parameters":{}})",
        "device.firmware");
    row("firmware of another",
        head + R"("device":{"signature":"TReXJr1.2","firmware":"1.1"},"parameters":{}})",
        "device.firmware");
    row("signature number", head + R"("device":{"signature":1},"parameters":{}})",
        "device.signature");
    row("device 128", head + R"("device":{"number":128},"parameters":{}})", "device.number");
    row("device -1", head + R"("device":{"number":-1},"parameters":{}})", "device.number");
    row("device key", head + R"("device":{"numbr":7},"parameters":{}})", "device.numbr");
    row("parameters is a list", head + R"("parameters":[]})", "parameters");
    row("parameters is null", head + R"("parameters":null})", "parameters");
    row("unknown parameter", head + R"("parameters":{"serial-time":{"raw":5}}})",
        "parameters.serial-time");
    row("number as key", head + R"("parameters":{"7":{"raw":5}}})", "parameters.7");
    row("parameter is a number", head + R"("parameters":{"serial-timeout":5}})",
        "parameters.serial-timeout");
    row("parameter twice",
        head + "\"parameters\":{\"serial-timeout\":{\"raw\":5},\n\"serial-timeout\":{\"raw\":6}}}",
        "line 2, parameters.serial-timeout: stands twice");
    row("control characters in a key", head + R"("parameters":{"\u0000\n\u001b[31m":1}})",
        "parameters.");
    row("BOM of UTF-16", QByteArray("\xFF\xFE{\0}\0", 6), "UTF-16");
    row("BOM of big UTF-16", QByteArray("\xFE\xFF\0{\0}", 6), "UTF-16");
    row("NUL", head + "\n\"parameters\":{" + QByteArray(1, '\0') + "}}", "line 2, column 15");
    row("comment in slashes", head + "\n// mine\n\"parameters\":{}}", "\"comment\"");
    row("comment with a hash", head + "\n# mine\n\"parameters\":{}}", "line 2");
    row("endless key", head + "\"parameters\":{\"" + QByteArray(5000, 'x') + "\":1}}",
        "parameters.xxx");
    row("calibration is a text", head + R"("calibration":"good"})", "calibration");
    row("unknown input", head + R"("calibration":{"pwm":{}}})", "calibration.pwm");
    row("set is a list", head + R"("calibration":{"rc":[]}})", "calibration.rc");
    row("channel 0", head + R"("calibration":{"rc":{"0":{}}}})", "calibration.rc.0");
    row("channel 6", head + R"("calibration":{"analog":{"6":{}}}})", "calibration.analog.6");
    row("channel is a number", head + R"("calibration":{"rc":{"1":5}}})", "calibration.rc.1");
    const QByteArrayList names{"minimum", "neutral", "maximum", "deadband"};
    for (const auto& name : names) {
        for (const auto& bad : {QByteArray("\"9\""), QByteArray("null"), QByteArray("-1"),
                                QByteArray("16384"), QByteArray("9.5"), QByteArray("true")}) {
            QByteArrayList members;
            for (const auto& each : names) {
                members << '"' + each
                        + "\":" + (each == name ? bad : QByteArray::number(members.size() * 100));
            }
            row((name + " is " + bad).constData(), withCalibration(members.join(',')),
                ("calibration.rc.3." + name).constData());
        }
        QByteArrayList rest;
        for (const auto& each : names) {
            rest << (each == name ? QByteArray("\"note\":\"\"")
                                  : '"' + each + "\":" + QByteArray::number(rest.size() * 100));
        }
        row((name + " is missing").constData(), withCalibration(rest.join(',')),
            ("calibration.rc.3." + name).constData());
    }
    // Conformance C-36
    row("minimum above neutral",
        withCalibration(R"("minimum":9,"neutral":8,"maximum":10,"deadband":0)"),
        "calibration.rc.3.minimum");
    row("neutral above maximum",
        withCalibration(R"("minimum":1,"neutral":11,"maximum":10,"deadband":0)"),
        "calibration.rc.3.neutral");
    row("minimum is maximum",
        withCalibration(R"("minimum":5,"neutral":5,"maximum":5,"deadband":0)"),
        "calibration.rc.3.maximum");
    row("fifth number",
        withCalibration(R"("minimum":1,"neutral":2,"maximum":3,"deadband":0,"gain":1)"),
        "calibration.rc.3.gain");
    row("nested deeply", QByteArray(5000, '[') + QByteArray(5000, ']'), "line 1");
    row("huge", head + "\"parameters\":{}" + QByteArray(1024 * 1024, ' ') + '}', "1 MiB");
}

void TestConfigFile::malformedFile_isRefusedWithItsPlace()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, place);
    verifyRefused(json, place);
}

void TestConfigFile::truncatedFile_isRefusedWithItsLine()
{
    const QByteArray whole = writeConfiguration(fullConfiguration(1));
    for (qsizetype size = 0; size < whole.size() - 1; ++size) {
        const auto parsed = parseConfiguration(whole.first(size), kName);
        QVERIFY2(!parsed, QByteArray::number(size));
        QVERIFY2(parsed.error().context.contains(u"line "_s), qPrintable(parsed.error().context));
    }
}

void TestConfigFile::damagedFile_isRefusedOrUnderstood()
{
    const QByteArray whole = writeConfiguration(fullConfiguration(2));
    std::minstd_rand random(7);
    for (int round = 0; round < 4000; ++round) {
        QByteArray damaged = whole;
        for (auto hits = 1 + random() % 3; hits > 0; --hits) {
            damaged[static_cast<qsizetype>(random() % static_cast<unsigned>(whole.size()))] =
                static_cast<char>(random() % 256);
        }
        const auto parsed = parseConfiguration(damaged, kName);
        if (!parsed) {
            QVERIFY(parsed.error().context.startsWith(kName));
            continue;
        }
        for (const auto& [number, raw] : parsed->parameters) {
            QVERIFY(accepts(*findParameter(int{number}), raw));
        }
        const auto again = parseConfiguration(writeConfiguration(*parsed), kName);
        QVERIFY(again && *again == *parsed);
    }
}

void TestConfigFile::newerVersion_isKeptAndTold()
{
    const QByteArray newer =
        R"({"format":"trexpanel-configuration","version":3,"mood":[1,{"a":"ü"}],"device":{"serial":"X1"},)"
        R"("parameters":{"serial-timeout":{"raw":5,"reason":"bench"},"warp":{"raw":900}},)"
        R"("calibration":{"rc":{"9":{"minimum":1}},"dmx":{}}})";
    const auto parsed = parseConfiguration(newer, kName);
    QVERIFY2(parsed.has_value(), qPrintable(parsed ? QString() : parsed.error().context));
    QCOMPARE(parsed->parameters, (ParameterValues{{0x07, 5}}));
    const QString remark = remarkOn(*parsed);
    for (const auto& key :
         {u"version 3"_s, u"mood"_s, u"device.serial"_s, u"parameters.warp"_s,
          u"parameters.serial-timeout.reason"_s, u"calibration.dmx"_s, u"calibration.rc.9"_s}) {
        QVERIFY2(remark.contains(key), qPrintable(remark));
    }
    const QByteArray written = writeConfiguration(*parsed);
    QVERIFY(written.contains("\"mood\": [1,{\"a\":\"ü\"}]"));
    QVERIFY(written.contains("\"reason\": \"bench\""));
    QVERIFY(written.contains("\"version\": 3"));
    QVERIFY(written.contains("\"9\": {\"minimum\":1}")); // though the set has nothing else
    const auto again = parseConfiguration(written, kName);
    QVERIFY(again && *again == *parsed);
    // What is known must still make sense.
    verifyRefused(
        R"({"format":"trexpanel-configuration","version":3,"parameters":{"serial-timeout":{"raw":500}}})",
        u"parameters.serial-timeout.raw"_s);
}

void TestConfigFile::previousVersion_isOpened()
{
    // Stays as it is whatever the format becomes.
    const auto old = loadConfiguration(QStringLiteral(TREX_TEST_DATA "/configuration-v1.json"));
    QVERIFY2(old, qPrintable(old ? QString() : old.error().context));
    QCOMPARE(old->version, 1);
    QCOMPARE(old->parameters.size(), kParameters.size() - 1);
    QCOMPARE(old->parameters.at(0x07), 5);
    QCOMPARE(old->parameters.at(0x13), 30);
    QCOMPARE(old->calibrations.at(InputKind::Rc).at(5), (Calibration{2501, 3751, 5001, 101}));
    QCOMPARE(old->signature, u"TReXJr1.2"_s);
    QCOMPARE(old->firmware, QString()); // it does not say so, and is not given what it did not say
    QCOMPARE(old->saved, QDateTime({2026, 11, 22}, {14, 0}, Qt::UTC));
    QCOMPARE(remarkOn(*old), QString());
}

void TestConfigFile::unexpectedValue_spoilsNoFile() // C-59
{
    Configuration present;
    present.parameters = {{0x07, 5}, {0x17, 255}}; // as firmware before 1.2 may answer
    const auto again = parseConfiguration(writeConfiguration(present), kName);
    QVERIFY2(again, qPrintable(again ? QString() : again.error().context));
    QCOMPARE(again->parameters, (ParameterValues{{0x07, 5}}));
}

void TestConfigFile::comments_stayWhereTheyAre()
{
    const QByteArray text = R"({
    "comment": ["the bench", "in the cellar: \u00fc \" \\ { ] ,"],
    "format": "trexpanel-configuration",
    "why now": "new wheels",
    "version": 1,
    "device": { "owner": "Ada", "signature": "TReXJr1.2", "number": 7, "shelf": {"row":  3 , "bin":[1,2.50]} },
    "parameters": {
        "note on the next": "found by trying",
        "second": "and another",
        "serial-timeout": { "raw": 5, "note": "half a second", "physical": 500, "unit": "ms" },
        "motor1-acceleration": { "raw": 40, "physical": 40, "unit": "" },
        "last": "the end"
    },
    "calibration": {
        "rc": {
            "comment": "with the old transmitter",
            "1": { "minimum": 2500, "stick": "left", "neutral": 3750, "maximum": 5000, "deadband": 100 }
        }
    },
    "z": "at the end"
}
)";
    const auto parsed = parseConfiguration(text, kName);
    QVERIFY2(parsed, qPrintable(parsed ? QString() : parsed.error().context));
    QCOMPARE(writeConfiguration(*parsed), text);
    QCOMPARE(remarkOn(*parsed), u"Not understood and left alone in the file: device.shelf."_s);

    // In another order and spacing it says the same, and the comments keep their neighbours.
    QByteArray shuffled = text;
    shuffled.replace("    \"version\": 1,\n", "").replace("\n    \"z\"", "\n\"version\":1, \"z\"");
    const auto other = parseConfiguration(shuffled, kName);
    QVERIFY2(other, qPrintable(other ? QString() : other.error().context));
    const QByteArray once = writeConfiguration(*other);
    const auto again = parseConfiguration(once, kName);
    QVERIFY(again && *again == *other);
    QCOMPARE(writeConfiguration(*again), once);
}

void TestConfigFile::comments_survivePuttingAnotherFileInPlace()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"mine.json"_s);
    auto commented = fullConfiguration(3);
    commented.unknown[{u"parameters.serial-timeout"_s, u"note"_s}] = {u"raw"_s, "\"mine\""};
    commented.unknown[{QString(), u"mood"_s}] = {u"version"_s, "{\"a\":1}"};
    QVERIFY(saveConfiguration(commented, path));
    QVERIFY(saveConfiguration(fullConfiguration(4), path));
    const auto loaded = loadConfiguration(path);
    QVERIFY(loaded);
    QCOMPARE(loaded->parameters, fullConfiguration(4).parameters);
    QCOMPARE(loaded->unknown.size(), 1U); // what is no comment belonged to the other values
    QCOMPARE(loaded->unknown.begin()->second.json, QByteArray("\"mine\""));
}

void TestConfigFile::whatIsNeitherOursNorComment_isTold()
{
    const auto parsed = parseConfiguration(
        R"({"format":"trexpanel-configuration","version":1,"mood":{"a":1},"parameters":{}})",
        kName);
    QVERIFY(parsed);
    QVERIFY(remarkOn(*parsed).contains(u"mood"_s));
}

void TestConfigFile::load_refusesWhatIsNoFile()
{
    QTemporaryDir folder;
    QCOMPARE(loadConfiguration(folder.filePath(u"none.json"_s)).error().code,
             ErrorCode::FileUnreadable);
    QCOMPARE(loadConfiguration(folder.path()).error().code, ErrorCode::FileUnreadable);
#ifdef Q_OS_UNIX
    QCOMPARE(loadConfiguration(u"/dev/zero"_s).error().code, ErrorCode::FileUnreadable);
#endif
    QFile huge(folder.filePath(u"huge.json"_s));
    QVERIFY(huge.open(QIODevice::WriteOnly) && huge.resize(kLargestConfigurationBytes * 3));
    huge.close();
    const auto loaded = loadConfiguration(huge.fileName());
    QCOMPARE(loaded.error().code, ErrorCode::FileMalformed);
    QVERIFY(loaded.error().context.contains(huge.fileName()));
}

void TestConfigFile::save_replacesWholeFilesOnly()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"mine.json"_s);
    QVERIFY(saveConfiguration(fullConfiguration(1), path).has_value());
    QVERIFY(saveConfiguration(fullConfiguration(2), path).has_value());
    const auto loaded = loadConfiguration(path);
    QVERIFY(loaded && *loaded == fullConfiguration(2));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{u"mine.json"_s});
    const auto nowhere =
        saveConfiguration(fullConfiguration(1), folder.filePath(u"no/such/x.json"_s));
    QCOMPARE(nowhere.error().code, ErrorCode::FileUnwritable);
    QCOMPARE(saveConfiguration(fullConfiguration(1), folder.path()).error().code,
             ErrorCode::FileUnwritable);
}

void TestConfigFile::differences_nameEachNumber()
{
    const auto present = fullConfiguration(4);
    QVERIFY(differences(present, present).empty());
    auto wanted = present;
    wanted.parameters.erase(0x01); // not mentioned: no difference
    wanted.parameters[0x07] = present.parameters.at(0x07) ^ 1;
    wanted.calibrations[InputKind::Rc][1].minimum += 1;
    wanted.calibrations[InputKind::Analog][5].deadband += 2;
    const auto changes = differences(present, wanted);
    QCOMPARE(changes.size(), 3U);
    QCOMPARE(changes[0],
             (ConfigurationChange{u"serial-timeout"_s, present.parameters.at(0x07),
                                  wanted.parameters.at(0x07)}));
    QCOMPARE(changes[1].key, u"calibration.rc.1.minimum"_s);
    QCOMPARE(changes[2].key, u"calibration.analog.5.deadband"_s);
    QCOMPARE(*changes[2].from + 2, changes[2].to);
    Configuration nothing;
    QCOMPARE(differences(nothing, present).size(), present.parameters.size() + 10 * 4);
    QVERIFY(!differences(nothing, present)[0].from);
}

QTEST_GUILESS_MAIN(TestConfigFile)
#include "tst_configfile.moc"
