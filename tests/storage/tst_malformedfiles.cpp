// SPDX-License-Identifier: GPL-3.0-or-later
// Hundreds of spoilt configuration files, made from a good one: each is refused as a whole, with
// one sentence that names the place. What only looks different is read as the same configuration.
#include "protocol/errortext.h"
#include "protocol/storage/configdiff.h"
#include "protocol/storage/configfile.h"

#include <QFile>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

const QString kName = u"spoilt.json"_s;

QByteArray goodFile()
{
    QFile file(QStringLiteral(TREX_TEST_DATA "/configuration-v1.json"));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The good file with one text replaced, which must be there once.
QByteArray with(const QByteArray& before, const QByteArray& after)
{
    const QByteArray good = goodFile();
    const bool isThere = good.count(before) == 1;
    return isThere ? QByteArray(good).replace(before, after)
                   : QByteArray("TEST IS WRONG: ") + before;
}

QByteArray lineOf(const QByteArray& key)
{
    const QByteArray good = goodFile();
    const qsizetype start = good.indexOf('"' + key + '"');
    return good.mid(start, good.indexOf('\n', start) - start);
}

int lineNumber(const QByteArray& json, const QByteArray& text)
{
    return static_cast<int>(json.first(json.indexOf(text)).count('\n')) + 1;
}

QByteArray keyBytes(const ParameterRow& row)
{
    return {row.key.data(), static_cast<qsizetype>(row.key.size())};
}

} // namespace

class TestMalformedFiles : public QObject {
    Q_OBJECT

private slots:
    void spoiltFile_isRefusedWithOneSentence_data();
    void spoiltFile_isRefusedWithOneSentence();
    void sameConfiguration_isReadWhateverItLooks_data();
    void sameConfiguration_isReadWhateverItLooks();
    void cleanupTestCase();

private:
    void addParameters();
    void addCalibrations();
    void addSyntax();
    void addEncodings();
    int m_files = 0;
};

void TestMalformedFiles::spoiltFile_isRefusedWithOneSentence_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("place"); ///< empty: some line
    addParameters();
    addCalibrations();
    addSyntax();
    addEncodings();
}

/// Each parameter's line, spoilt in every way that a hand can.
void TestMalformedFiles::addParameters()
{
    for (const auto& row : kParameters) {
        if (row.isTrigger) {
            continue;
        }
        const QByteArray key = keyBytes(row);
        const QByteArray line = lineOf(key);
        const QByteArray raw =
            line.mid(line.indexOf("raw"), line.indexOf(',') - line.indexOf("raw"));
        const QString number = u"line %1"_s.arg(lineNumber(goodFile(), line));
        const auto add = [&](const char* what, const QByteArray& changed, const QString& member) {
            QTest::addRow("%s: %s", key.constData(), what)
                << with(line, changed)
                << (member.isEmpty() ? number
                                     : u"%1, parameters.%2%3"_s.arg(number, keyText(row), member));
        };
        const auto rawBecomes = [&](const QByteArray& value) {
            return QByteArray(line).replace(raw, "raw\": " + value);
        };
        add("one too many", rawBecomes(QByteArray::number(row.maximum + 1)), u".raw"_s);
        add("huge", rawBecomes("123456789012345678901234567890"), u".raw"_s);
        add("a text", rawBecomes("\"5\""), u".raw"_s);
        add("a list", rawBecomes("[5]"), u".raw"_s);
        add("not a number", rawBecomes("NaN"), {});
        add("infinity", rawBecomes("-Infinity"), {});
        add("1e999", rawBecomes("1e999"), {});
        add("no value", rawBecomes(""), {});
        add("twice", line.chopped(line.endsWith(',') ? 1 : 0) + ", " + line, {});
        QTest::addRow("%s: slip of the key", key.constData())
            << with(line, QByteArray(line).replace('"' + key, "\"x" + key))
            << u"%1, parameters.x%2: is not known; is %2 meant?"_s.arg(number, keyText(row));
        add("unknown key", QByteArray(line).replace(key, "warp-" + key), {});
        add("wrong unit", QByteArray(line).replace("\"unit\": \"", "\"unit\": \"k"), u".unit"_s);
        add("wrong physical", QByteArray(line).replace("\"physical\": ", "\"physical\": 9"),
            u".physical"_s);
    }
}

void TestMalformedFiles::addCalibrations()
{
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        const QByteArray line = lineOf(QByteArray::number(channel));
        const QString number =
            u"line %1, calibration.rc.%2"_s.arg(lineNumber(goodFile(), line)).arg(channel);
        const auto add = [&](const char* what, const char* before, const char* after,
                             const char* member) {
            QTest::addRow("channel %d: %s", channel, what)
                << with(line, QByteArray(line).replace(before, after))
                << number + QLatin1StringView(member);
        };
        add("minimum above neutral", "\"minimum\": ", "\"minimum\": 1", ".minimum");
        add("neutral above maximum", "\"neutral\": ", "\"neutral\": 1", ".neutral");
        add("maximum below", "\"maximum\": ", "\"maximum\": 0.", ".maximum");
        add("deadband below 0", "\"deadband\": ", "\"deadband\": -", ".deadband");
        add("a fifth number", "\"deadband\": ", "\"gain\": 2, \"deadband\": ", ".gain");
        add("slip of a name", "neutral", "netural", ".netural");
        add("a sixth channel", "\": {", "6\": {", "6");
    }
}

/// Truncated everywhere, one sign too few or too many, nested too deep.
void TestMalformedFiles::addSyntax()
{
    const QByteArray good = goodFile();
    for (qsizetype size = 1; size < good.size() - 2; size += 23) {
        QTest::addRow("cut at %lld", static_cast<long long>(size)) << good.first(size) << QString();
    }
    std::minstd_rand random(20'26);
    for (const char sign : {'{', '}', ':', ',', '"'}) {
        for (int round = 0; round < 12; ++round) {
            std::vector<qsizetype> places;
            for (qsizetype at = good.indexOf(sign); at >= 0; at = good.indexOf(sign, at + 1)) {
                places.push_back(at);
            }
            const qsizetype at = places[random() % places.size()];
            QTest::addRow("%c left out at %lld", sign, static_cast<long long>(at))
                << QByteArray(good).remove(at, 1) << QString();
            QTest::addRow("%c twice at %lld", sign, static_cast<long long>(at))
                << QByteArray(good).insert(at, sign) << QString();
        }
    }
    for (qsizetype at = good.indexOf('}'); at >= 0; at = good.indexOf('}', at + 120)) {
        QTest::addRow("comma before } at %lld", static_cast<long long>(at))
            << QByteArray(good).insert(at, ',') << QString();
    }
    QTest::newRow("// comment") << with("\"parameters\"", "// mine\n    \"parameters\"")
                                << u"line 6"_s;
    QTest::newRow("# comment") << with("\"parameters\"", "# mine\n    \"parameters\"")
                               << u"line 6"_s;
    QTest::newRow("nested deeply") << with("\"parameters\"",
                                           "\"deep\": " + QByteArray(100'000, '[')
                                               + QByteArray(100'000, ']') + ",\n    \"parameters\"")
                                   << QString();
    QTest::newRow("more behind it") << good + "{}" << QString();
}

void TestMalformedFiles::addEncodings()
{
    const QByteArray good = goodFile();
    const QString text = QString::fromUtf8(good);
    const QByteArray utf16(reinterpret_cast<const char*>(text.utf16()), text.size() * 2);
    QTest::newRow("UTF-16") << "\xFF\xFE" + utf16 << u"UTF-16"_s;
    QTest::newRow("UTF-16 without a mark") << utf16 << u"NUL"_s;
    std::minstd_rand random(7);
    for (int round = 0; round < 12; ++round) {
        const auto at = static_cast<qsizetype>(random() % static_cast<unsigned>(good.size() - 2));
        QTest::addRow("NUL at %lld", static_cast<long long>(at))
            << QByteArray(good).insert(at, '\0') << u"NUL"_s;
        const qsizetype key = good.indexOf('"', at) + 1;
        QTest::addRow("invalid UTF-8 at %lld", static_cast<long long>(key))
            << QByteArray(good).insert(key, '\xFF') << QString();
    }
    // Qt's parser takes any byte after a backslash; in a comment nobody else would mind it.
    QTest::newRow("invalid UTF-8 behind a backslash")
        << "{ \"comment\": \"a\",\n\"note\": \"b\\\xD0\"," + good.sliced(1) << u"line 2"_s;
}

void TestMalformedFiles::spoiltFile_isRefusedWithOneSentence()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, place);
    QVERIFY2(!json.startsWith("TEST IS WRONG"), json.constData());
    const auto parsed = parseConfiguration(json, kName);
    QVERIFY2(!parsed, "taken");
    ++m_files;
    const QString& context = parsed.error().context;
    QCOMPARE(parsed.error().code, ErrorCode::FileMalformed);
    static const QRegularExpression named(u"^spoilt\\.json, line \\d+, [^\\n]+: [^\\n]+$"_s);
    QVERIFY2(named.match(context).hasMatch(), qPrintable(context));
    QVERIFY2(context.contains(place), qPrintable(context + u" does not name "_s + place));
    QVERIFY2(context.size() < 300 && errorText(parsed.error()).count(context) == 1,
             qPrintable(context));
}

void TestMalformedFiles::sameConfiguration_isReadWhateverItLooks_data()
{
    QTest::addColumn<QByteArray>("json");
    const QByteArray good = goodFile();
    const auto document = QJsonDocument::fromJson(good);
    QTest::newRow("on one line, keys in another order") << document.toJson(QJsonDocument::Compact);
    QTest::newRow("indented, keys in another order") << document.toJson();
    QTest::newRow("lines of Windows") << QByteArray(good).replace("\n", "\r\n");
    QTest::newRow("tabs") << QByteArray(good).replace("    ", "\t");
    QTest::newRow("byte order mark") << "\xEF\xBB\xBF" + good;
    QTest::newRow("blank lines") << "\n\n" + QByteArray(good).replace("\n", "\n\n");
    QTest::newRow("whole numbers with a fraction")
        << QByteArray(good).replace("\"raw\": 5,", "\"raw\": 5.0,");
    QTest::newRow("without physical values")
        << QByteArray(good).replace(", \"physical\": 500, \"unit\": \"ms\"", "");
    QTest::newRow("escaped key") << QByteArray(good).replace("\"version\"", "\"v\\u0065rsion\"");
    std::minstd_rand random(3);
    for (int round = 0; round < 30; ++round) {
        QByteArray spaced;
        for (const char sign : good) {
            const bool isBetween = sign == '{' || sign == '}' || sign == ',';
            spaced += sign;
            if (isBetween) {
                spaced += QByteArray(static_cast<qsizetype>(random() % 4), " \n\t\r"[random() % 4]);
            }
        }
        QTest::addRow("spaces %d", round) << spaced;
    }
}

void TestMalformedFiles::sameConfiguration_isReadWhateverItLooks()
{
    QFETCH(QByteArray, json);
    const auto good = parseConfiguration(goodFile(), kName);
    const auto parsed = parseConfiguration(json, kName);
    QVERIFY2(parsed, qPrintable(parsed ? QString() : parsed.error().context));
    QVERIFY(good && *parsed == *good);
    QCOMPARE(writeConfiguration(*parsed), goodFile());
}

void TestMalformedFiles::cleanupTestCase()
{
    qInfo("%d spoilt files", m_files);
    QVERIFY(m_files >= 200);
}

QTEST_GUILESS_MAIN(TestMalformedFiles)
#include "tst_malformedfiles.moc"
