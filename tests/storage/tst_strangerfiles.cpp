// SPDX-License-Identifier: GPL-3.0-or-later
// Files from others: what they hold is shown, and nothing that they say is done. No path of theirs
// is opened or removed, nothing in them is run, and no text of theirs becomes part of a page.
#include "protocol/errortext.h"
#include "protocol/procedures/benchdryrun.h"
#include "protocol/procedures/benchreport.h"
#include "protocol/sim/scenario.h"
#include "protocol/storage/benchprofile.h"
#include "protocol/storage/configfile.h"
#include "protocol/storage/recordingcsv.h"
#include "protocol/storage/recordingreader.h"
#include "protocol/storage/recordingwriter.h"
#include "protocol/storage/sampletap.h"
#include "tests/support/spoiltfiles.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using namespace trex::test;
using namespace std::chrono_literals;

namespace {

constexpr Instant kStart(1000s);
const QString kScript = u"<script>alert('x')</script>\" onload=\"x"_s;

void record(const QString& path)
{
    TelemetryStore store;
    for (int i = 0; i < 100; ++i) {
        store.append(PollSample{.poll = PollId::Currents,
                                .raw = {static_cast<std::uint16_t>(i), 5},
                                .time = kStart + i * 10ms});
    }
    auto writer = RecordingWriter::create(path, {});
    QVERIFY(writer.has_value());
    SampleTap::Wanted all;
    all.fill(true);
    SampleTap tap(store);
    RecordingBatch batch;
    tap.take(all, TimeAxis::ticksOf(kStart), 1'000'000, batch.runs);
    QVERIFY((*writer)->write(batch).has_value());
    QVERIFY((*writer)->finish().has_value());
}

std::size_t samplesIn(const QString& path)
{
    const auto reader = RecordingReader::open(path);
    if (!reader) {
        qInfo("%s", qPrintable(errorText(reader.error())));
        return 0;
    }
    TelemetryStore store;
    (*reader)->loadAll(store, kStart);
    return store.series("motor1-current").size();
}

/// A rollback journal as a crash leaves it, with nothing to play back, that names `master`: SQLite
/// removes the file of that name once it has played a journal back (sqlite.org/fileformat2.html).
QByteArray hotJournal(const QByteArray& master)
{
    constexpr qsizetype kSector = 512;
    const QByteArray magic = QByteArray::fromHex("d9d505f920a163d7");
    const auto word = [](quint32 value) {
        QByteArray bytes(4, '\0');
        qToBigEndian(value, bytes.data());
        return bytes;
    };
    QByteArray journal = magic + word(0) + word(1) + word(100) + word(kSector) + word(4096);
    journal.append(kSector - journal.size(), '\0');
    quint32 sum = 0;
    for (const char letter : master) {
        sum += static_cast<quint32>(static_cast<signed char>(letter));
    }
    constexpr quint32 kPendingPage = 0x40000000 / 4096 + 1;
    return journal + word(kPendingPage) + master + word(quint32(master.size())) + word(sum) + magic;
}

} // namespace

class TestStrangerFiles : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void recordingWithMore_isReadAllTheSame_data();
    void recordingWithMore_isReadAllTheSame();
    void recordingWithViewForTable_isRefused();
    void journalBesideRecording_removesNoFile();
    void hugeValues_areCutShort();
    void csv_isNumbersOnly();
    void report_isTextOnly();
    void profile_namesNoFile_data();
    void profile_namesNoFile();

private:
    [[nodiscard]] QString path(const QString& name = u"r.trexrec"_s) const
    {
        return m_folder->filePath(name);
    }
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestStrangerFiles::recordingWithMore_isReadAllTheSame_data()
{
    QTest::addColumn<QString>("statement");
    QTest::newRow("view") << u"CREATE VIEW v AS SELECT load_extension('/tmp/x.so')"_s;
    QTest::newRow("trigger")
        << u"CREATE TRIGGER t AFTER INSERT ON event BEGIN DELETE FROM data; END"_s;
    QTest::newRow("index with an expression")
        << u"CREATE INDEX i ON event(lower(text)) WHERE abs(tick) > 3"_s;
    QTest::newRow("table") << u"CREATE TABLE stranger(a, b)"_s;
    QTest::newRow("virtual table") << u"CREATE VIRTUAL TABLE f USING fts5(a)"_s;
}

void TestStrangerFiles::recordingWithMore_isReadAllTheSame()
{
    QFETCH(QString, statement);
    record(path());
    tamper(path(), {statement});
    const QByteArray before = contents(path());
    QCOMPARE(samplesIn(path()), std::size_t(100));
    QCOMPARE(contents(path()), before);
}

void TestStrangerFiles::recordingWithViewForTable_isRefused()
{
    record(path());
    tamper(path(),
           {u"ALTER TABLE event RENAME TO hidden"_s,
            u"CREATE VIEW event AS SELECT 1 AS id, 1 AS tick, 0 AS severity, 'log' AS kind, "
            "load_extension('/tmp/x.so') AS text"_s});
    const auto reader = RecordingReader::open(path());
    QVERIFY(!reader);
    QCOMPARE(reader.error().code, ErrorCode::FileMalformed);
}

void TestStrangerFiles::journalBesideRecording_removesNoFile()
{
    record(path());
    const QString victim = path(u"important.txt"_s);
    put(victim, "/nowhere/at/all\0");
    put(path() + u"-journal"_s, hotJournal(victim.toUtf8()));
    QVERIFY(samplesIn(path()) == 100);
    QVERIFY2(QFile::exists(victim), "a file that a stranger named is gone");
    QVERIFY(QFile::exists(path() + u"-journal"_s)); // what lies beside it is not ours to tidy
}

void TestStrangerFiles::hugeValues_areCutShort()
{
    record(path());
    tamper(path(),
           {u"UPDATE fact SET value = CAST(zeroblob(200000000) AS TEXT) WHERE name = 'port'"_s,
            u"INSERT OR REPLACE INTO fact VALUES('mode', hex(zeroblob(50000000)))"_s,
            u"INSERT INTO event VALUES(7, 7, 0, 'log', hex(zeroblob(50000000)))"_s,
            u"UPDATE data SET samples = zeroblob(300000000)"_s});
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    QVERIFY((*reader)->fact("mode").size() <= 4096);
    for (const auto& event : (*reader)->events()) {
        QVERIFY(event.text.size() <= 100'000);
    }
    TelemetryStore store;
    (*reader)->loadAll(store, kStart);
    QCOMPARE(store.series("motor1-current").size(), std::size_t(0)); // a gap, and told
    QVERIFY((*reader)->remark().contains(u"damaged"_s));
}

/// Nothing that a spreadsheet would take for a formula can stand in a cell: names are ours, and
/// what is measured is a number. So no text has to be protected, which would spoil it for others.
void TestStrangerFiles::csv_isNumbersOnly()
{
    record(path());
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    TelemetryStore store;
    (*reader)->loadAll(store, kStart);
    CsvOptions options;
    options.polls.fill(true);
    QVERIFY(exportSamplesCsv(path(u"a.csv"_s), store, options).has_value());
    static const QRegularExpression name(u"^[a-zA-Z][a-zA-Z0-9_]*$"_s);
    static const QRegularExpression number(u"^(-?[0-9]+(\\.[0-9]+)?)?$"_s);
    const QList<QByteArray> lines = contents(path(u"a.csv"_s)).trimmed().split('\n');
    QVERIFY(lines.size() > 50);
    for (qsizetype i = 0; i < lines.size(); ++i) {
        for (const QByteArray& cell : lines[i].split(',')) {
            const auto& rule = i == 0 ? name : number;
            QVERIFY2(rule.match(QString::fromUtf8(cell)).hasMatch(), cell.constData());
        }
    }
}

void TestStrangerFiles::report_isTextOnly()
{
    BenchProfile profile;
    profile.name = kScript;
    profile.description = u"</title></style>"_s + kScript + QChar(0) + QChar(0x1B);
    BenchStep set;
    set.action = BenchAction::Set;
    set.label = kScript;
    set.speed = 20;
    BenchStep hold;
    hold.seconds = 0.5;
    hold.label = kScript;
    profile.steps = {set, hold};
    BenchDryRun dryRun(profile, {});
    while (dryRun.advance(500ms)) { }
    BenchReport report;
    report.program = kScript;
    report.port = kScript;
    report.line = report.model = report.firmware = report.mode = kScript;
    const QByteArray html = reportHtml(evaluate(dryRun.run(), true), report);
    QVERIFY(html.contains("&lt;script&gt;"));
    QVERIFY(!html.contains("<script"));
    QCOMPARE(html.count("</style>"), 1);
    QVERIFY(!html.contains("</title></style>"));
    QVERIFY(!html.contains('\0') && !html.contains('\x1B'));
    static const QRegularExpression handler(u"<[^>]*\\son[a-z]+="_s);
    QVERIFY(!handler.match(QString::fromUtf8(html)).hasMatch());
    static const QRegularExpression address(u"(src|href|url)\\s*[=(]"_s);
    QVERIFY(!address.match(QString::fromUtf8(html)).hasMatch()); // nothing is fetched, either
}

void TestStrangerFiles::profile_namesNoFile_data()
{
    QTest::addColumn<QByteArray>("more");
    for (const char* key : {"record", "report", "include", "run", "exec", "path", "extends"}) {
        QTest::addRow("%s", key) << "\"" + QByteArray(key) + R"(":["FOLDER/x"],)";
    }
}

/// Whatever a file would like to name has no place in any of the formats: a key that is not known
/// is refused, where it is no plain text (a comment), and nothing but its own path is opened.
void TestStrangerFiles::profile_namesNoFile()
{
    QFETCH(QByteArray, more);
    more.replace("FOLDER", m_folder->path().toUtf8());
    put(path(u"p.json"_s),
        R"({"format":"trexpanel-bench-profile","version":1,"name":"x",)" + more
            + R"("steps":[{"do":"hold","seconds":1}]})");
    QVERIFY(!loadBenchProfile(path(u"p.json"_s)));
    put(path(u"s.json"_s), "{" + more + R"("channels":[]})");
    QVERIFY(!sim::readScenario(path(u"s.json"_s)));
    put(path(u"c.json"_s),
        R"({"format":"trexpanel-configuration","version":1,)" + more + R"("parameters":{}})");
    const auto configuration = loadConfiguration(path(u"c.json"_s));
    QVERIFY(!configuration || configuration->parameters.empty());
    QVERIFY(!QFile::exists(path(u"x"_s)));
}

QTEST_GUILESS_MAIN(TestStrangerFiles)
#include "tst_strangerfiles.moc"
