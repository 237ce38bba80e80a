// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings: what goes in comes out, and what is damaged or hostile is told and never believed.
#include "protocol/errortext.h"
#include "protocol/procedures/recordingmarks.h"
#include "protocol/storage/recordingcsv.h"
#include "protocol/storage/recordingplayer.h"
#include "protocol/storage/recordingreader.h"
#include "protocol/storage/recordingwriter.h"
#include "protocol/storage/sampletap.h"
#include "tests/support/spoiltfiles.h"

#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using namespace trex::test;
using namespace std::chrono_literals;

namespace {

constexpr Instant kStart(1000s);
const SampleTap::Wanted kAllPolls = [] {
    SampleTap::Wanted all;
    all.fill(true);
    return all;
}();

/// A session with noise, invalid pulses, gaps of both kinds and unequal rates.
void fill(TelemetryStore& store, int seconds, unsigned seed)
{
    std::minstd_rand random(seed);
    const auto upTo = [&random](unsigned most) {
        return static_cast<std::uint16_t>(random() % (most + 1));
    };
    Instant time = kStart;
    const Instant end = kStart + std::chrono::seconds(seconds);
    while (time < end) {
        time += std::chrono::microseconds(3000 + upTo(4000));
        PollSample sample{};
        sample.poll = PollId(upTo(4));
        sample.time = time;
        for (auto& raw : sample.raw) {
            switch (sample.poll) {
            case PollId::RawChannels:
                raw = upTo(9) == 0 ? kInvalidPulse : upTo(6250);
                break;
            case PollId::RemappedChannels: // sign and magnitude; −0 is 0
                raw = upTo(127);
                raw = raw > 0 && upTo(1) == 1 ? std::uint16_t(raw | 0x80U) : raw;
                break;
            default:
                raw = upTo(255);
            }
        }
        store.append(sample);
        if (upTo(49) == 0) {
            const std::array<std::uint16_t, 3> own{upTo(255), upTo(255), upTo(255)};
            store.append(upTo(1) == 0 ? Source::orders() : Source::linkHealth(), own, time);
        }
        if (upTo(999) == 0) {
            store.markGap(time);
        } else if (upTo(1999) == 0) {
            time += 3s; // a silence that is a gap by itself
        }
    }
}

Result<void> writeStore(const QString& path, const TelemetryStore& store, std::size_t atATime,
                        bool isFinished = true)
{
    auto writer = RecordingWriter::create(path, {{u"program"_s, u"tst_recording"_s}});
    if (!writer) {
        return tl::make_unexpected(writer.error());
    }
    SampleTap tap(store);
    for (;;) {
        RecordingBatch batch;
        if (tap.take(kAllPolls, TimeAxis::ticksOf(kStart), atATime, batch.runs) == 0) {
            break;
        }
        if (auto written = (*writer)->write(batch); !written) {
            return written;
        }
    }
    return isFinished ? (*writer)->finish() : Result<void>();
}

void compareStores(const TelemetryStore& actual, const TelemetryStore& expected)
{
    for (std::size_t i = 0; i < streams().size(); ++i) {
        const TimeSeries& a = actual.series(static_cast<int>(i));
        const TimeSeries& e = expected.series(static_cast<int>(i));
        QCOMPARE(a.size(), e.size());
        QCOMPARE(a.axis().gaps(), e.axis().gaps());
        for (std::size_t k = 0; k < a.size(); ++k) {
            QCOMPARE(a.axis().tick(k), e.axis().tick(k));
            QCOMPARE(a.value(k), e.value(k));
            QCOMPARE(a.isValid(k), e.isValid(k));
        }
    }
}

/// A window's way through it: loaded, scrubbed, stepped, played.
void playEverything(const QString& path)
{
    auto reader = RecordingReader::open(path);
    TelemetryStore store;
    StatusLatch latch;
    Controller controller(&store, nullptr);
    controller.becomeRecording();
    DeviceSettings settings(controller);
    RecordingPlayer player(std::move(*reader), {controller, settings, store, latch});
    while (player.loader().loadSlice(std::chrono::milliseconds(50))) { }
    for (const double part : {0.0, 1.0, 0.5, 0.7, 0.2}) {
        const auto whole = double(player.last() - player.first());
        player.seek(player.first() + Tick(part * whole));
        player.stepSample(1);
        player.stepSample(-1);
        player.stepEvent(1);
        player.stepEvent(-1);
    }
    player.play(Instant());
    player.setSpeed(1000.0, Instant());
    player.advance(Instant(std::chrono::seconds(1)));
    MarkTrack marks;
    fillMarks(marks, player.history(), store);
    QVERIFY(!controller.isArmed());
}

/// Everything that a reader offers, asked for.
void readEverything(const QString& path)
{
    const auto reader = RecordingReader::open(path);
    if (!reader) {
        const QString sentence = errorText(reader.error());
        QVERIFY(sentence.size() > 10 && !sentence.contains(u'\n'));
        return;
    }
    TelemetryStore store;
    (*reader)->loadAll(store, kStart);
    QVERIFY(store.series(0).size() < 1'000'000);
    for (std::size_t i = 0; i < streams().size(); ++i) {
        static_cast<void>((*reader)->overview(static_cast<int>(i)));
    }
    static_cast<void>((*reader)->events());
    static_cast<void>((*reader)->health());
    static_cast<void>((*reader)->configurations());
    static_cast<void>((*reader)->packets(0, 100'000));
    static_cast<void>((*reader)->remark());
    playEverything(path);
}

} // namespace

class tst_recording : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void block_roundTrips_data();
    void block_roundTrips();
    void block_refusesWhatItNeverWrites();
    void crc_isTheCommonOne();
    void samples_roundTripExactly_data();
    void samples_roundTripExactly();
    void rest_roundTripsExactly();
    void overview_agreesWithSamples();
    void unfinished_opensWithWal();
    void unfinished_opensWhereNothingCanBeWritten();
    void finished_isOneFile();
    void reader_leavesFileAlone();
    void strangers_areRefused_data();
    void strangers_areRefused();
    void damagedBlock_leavesGapAndIsTold();
    void hostileRows_areLeftOut();
    void earlierFile_opensWithoutRemark();
    void mutatedBytes_neverCrash();
    void truncated_neverCrashes();
    void writeError_keepsWhatWasWritten();
    void csv_hasEverySampleOnce();
    void day_opensInASecond();

private:
    QString path(const QString& name = u"r.trexrec"_s) const { return m_folder->filePath(name); }
    std::unique_ptr<QTemporaryDir> m_folder;
};

void tst_recording::block_roundTrips_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<bool>("isFinal");
    for (const int samples : {1, 2, 3, 127, 1024}) {
        QTest::addRow("%d plain", samples) << samples << false;
        QTest::addRow("%d final", samples) << samples << true;
    }
}

void tst_recording::block_roundTrips()
{
    QFETCH(const int, samples);
    QFETCH(const bool, isFinal);
    std::minstd_rand random(7);
    SampleRun run;
    Tick tick = -500;
    for (int i = 0; i < samples; ++i) {
        tick += Tick(random() % 3000);
        run.ticks.push_back(tick);
        if (i % 50 == 3) {
            run.gaps.push_back(std::size_t(i));
        }
        for (int column = 0; column < kChannelCount; ++column) {
            run.values.push_back(column == 4 ? std::uint16_t(0xFFFF * (i % 2))
                                             : std::uint16_t(random() % 65536));
        }
    }
    const QByteArray data = encodeBlock(PollId::RawChannels, run, isFinal);
    const auto back = decodeBlock(PollId::RawChannels, data, run.size());
    QVERIFY(back.has_value());
    QCOMPARE(*back, run);
    QVERIFY(!decodeBlock(PollId::RawChannels, data, run.size() + 1));
    QVERIFY(run.size() == 1 || !decodeBlock(PollId::RawChannels, data, run.size() - 1));
}

void tst_recording::block_refusesWhatItNeverWrites()
{
    const auto refuses = [](const QByteArray& data, std::size_t samples = 1) {
        return !decodeBlock(PollId::Status, data, samples).has_value();
    };
    QVERIFY(!refuses(QByteArray::fromHex("01000000"))); // tick 0, no gaps, value 0
    QVERIFY(refuses({}));
    QVERIFY(refuses(QByteArray::fromHex("01")));
    QVERIFY(refuses(QByteArray::fromHex("03000000"))); // no such form
    QVERIFY(refuses(QByteArray::fromHex("0100000000"))); // one byte too many
    QVERIFY(refuses(QByteArray::fromHex("01000001"))); // value −1
    QVERIFY(refuses(QByteArray::fromHex("010000808008"))); // value beyond a byte
    QVERIFY(refuses(QByteArray::fromHex("0100050000"))); // more gaps than samples
    QVERIFY(refuses(QByteArray::fromHex("010001000000"), 2)); // time runs backwards
    QVERIFY(refuses(QByteArray::fromHex("01ffffffffffffffffff010000"))); // tick beyond all time
    QVERIFY(refuses(QByteArray::fromHex("02ffffffff789c0300000000010000"))); // 4 GB, it says
    QVERIFY(refuses(QByteArray::fromHex("01000000"), 100'000'000));
    QVERIFY(refuses(QByteArray(1'000'000, '\1'), 1024));
}

void tst_recording::crc_isTheCommonOne()
{
    QCOMPARE(crc32("123456789"), 0xCBF43926U); // the check value of CRC-32/ISO-HDLC
    QCOMPARE(crc32({}), 0U);
}

void tst_recording::samples_roundTripExactly_data()
{
    QTest::addColumn<int>("atATime");
    QTest::newRow("one by one") << 1;
    QTest::newRow("as they come") << 24;
    QTest::newRow("all at once") << 1'000'000;
}

void tst_recording::samples_roundTripExactly()
{
    QFETCH(const int, atATime);
    TelemetryStore store;
    fill(store, atATime == 1 ? 8 : 300, 11);
    QVERIFY(atATime == 1 || store.series("channel1-raw").axis().gaps().size() > 10);
    const auto written = writeStore(path(), store, std::size_t(atATime));
    QVERIFY2(written, written ? "" : qPrintable(errorText(written.error())));
    const auto reader = RecordingReader::open(path());
    QVERIFY2(reader, reader ? "" : qPrintable(errorText(reader.error())));
    TelemetryStore back;
    (*reader)->loadAll(back, kStart);
    compareStores(back, store);
    QCOMPARE(back.start(), std::optional(TimeAxis::instantOf(TimeAxis::ticksOf(*store.start()))));
    for (const SourceRow& row : kSources) {
        const auto& columns = streamsOf(row.source);
        QCOMPARE((*reader)->samples(row.source),
                 columns.empty() ? 0 : store.series(columns.front()).size());
    }
    QCOMPARE((*reader)->progress(), 1.0);
}

void tst_recording::rest_roundTripsExactly()
{
    RecordingBatch batch;
    batch.facts = {{u"signature"_s, u"TReX1.2"_s}, {u"mode"_s, u"serial-analog"_s}};
    batch.events = {{10, 0, u"armed"_s, u"true"_s}, {20, 2, u"log"_s, u"Ünïcode — ✓"_s}};
    batch.packets = {{5, 6, 3, 1, -1, "\x8f", QByteArray("\0\xff", 2)},
                     {7, 9, 2, 2, static_cast<int>(ErrorCode::NoReply), "\x81", {}}};
    batch.health = {{100, 1, 2, 3, 4, 5, 6, 7, 8, 9, 1.5, 300.25}};
    Configuration configuration;
    configuration.signature = u"TReXJr1.2"_s;
    configuration.saved = QDateTime::fromSecsSinceEpoch(1'700'000'000, Qt::UTC);
    for (const ParameterRow& row : kParameters) {
        if (!row.isTrigger) {
            configuration.parameters[row.number] = row.defaultRaw;
        }
    }
    configuration.calibrations[InputKind::Rc][3] = {2500, 3750, 5000, 100};
    batch.configurations = {{1, configuration}};
    auto writer = RecordingWriter::create(path(), {{u"port"_s, u"sim:"_s}});
    QVERIFY(writer.has_value());
    QVERIFY((*writer)->write(batch).has_value());
    QVERIFY((*writer)->finish().has_value());
    auto opened = RecordingReader::open(path());
    QVERIFY2(opened, opened ? "" : qPrintable(errorText(opened.error())));
    RecordingReader& reader = **opened;
    QCOMPARE(reader.fact("port"), u"sim:"_s);
    QCOMPARE(reader.model(), Model::Trex);
    QCOMPARE(reader.input(), std::optional(InputKind::Analog));
    QCOMPARE(reader.events(), batch.events);
    QCOMPARE(reader.packetCount(), std::size_t(2));
    QCOMPARE(reader.packets(0, 10), batch.packets);
    QCOMPARE(reader.packets(1, 10).size(), std::size_t(1));
    QCOMPARE(reader.health(), batch.health);
    const auto back = reader.configurations();
    QCOMPARE(back.size(), std::size_t(1));
    QVERIFY(back[0].configuration == configuration);
    QVERIFY(!reader.isFinished());
}

void tst_recording::overview_agreesWithSamples()
{
    TelemetryStore store;
    fill(store, 200, 5);
    QVERIFY(writeStore(path(), store, 100).has_value());
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    for (std::size_t i = 0; i < streams().size(); ++i) {
        const TimeSeries& series = store.series(static_cast<int>(i));
        std::size_t begin = 0;
        for (const RecordingSpan& span : (*reader)->overview(static_cast<int>(i))) {
            QVERIFY(span.samples >= 1 && begin + span.samples <= series.size());
            const std::size_t end = begin + span.samples;
            QCOMPARE(span.first, series.axis().tick(begin) - TimeAxis::ticksOf(kStart));
            QCOMPARE(span.extent, series.extent(begin, end));
            QCOMPARE(span.mean, series.mean(begin, end).value_or(0.0));
            begin = end;
        }
        QCOMPARE(begin, series.size());
    }
}

void tst_recording::unfinished_opensWithWal()
{
    TelemetryStore store;
    fill(store, 30, 3);
    const QString copy = path(u"copy"_s);
    {
        auto writer = RecordingWriter::create(path(), {});
        QVERIFY(writer.has_value());
        SampleTap tap(store);
        RecordingBatch batch;
        tap.take(kAllPolls, TimeAxis::ticksOf(kStart), 1'000'000, batch.runs);
        QVERIFY((*writer)->write(batch).has_value());
        // As a kill leaves it: nothing was closed.
        QVERIFY(QFile::copy(path(), copy));
        QVERIFY(QFile::copy(path() + u"-wal"_s, copy + u"-wal"_s));
    }
    const auto beside = [&] {
        return QDir(QFileInfo(copy).path()).entryList({QFileInfo(copy).fileName() + u'*'});
    };
    const QStringList before = beside();
    {
        const auto reader = RecordingReader::open(copy);
        QVERIFY2(reader, reader ? "" : qPrintable(errorText(reader.error())));
        TelemetryStore back;
        (*reader)->loadAll(back, kStart);
        compareStores(back, store);
        QVERIFY((*reader)->remark().contains(u"not ended"_s));
    }
    QCOMPARE(beside(), before); // nothing of SQLite's is left there
    QVERIFY(QFile::remove(copy + u"-wal"_s));
    (void)RecordingReader::open(copy); // whatever is in it without
    QCOMPARE(beside().size(), 1);
}

void tst_recording::unfinished_opensWhereNothingCanBeWritten()
{
    TelemetryStore store;
    fill(store, 5, 3);
    const QString copy = path(u"copy"_s);
    auto writer = RecordingWriter::create(path(), {});
    SampleTap tap(store);
    RecordingBatch batch;
    tap.take(kAllPolls, TimeAxis::ticksOf(kStart), 1'000'000, batch.runs);
    QVERIFY((*writer)->write(batch).has_value());
    QVERIFY(QFile::copy(path(), copy));
    QVERIFY(QFile::copy(path() + u"-wal"_s, copy + u"-wal"_s));
    // Whoever runs this may be allowed to write anywhere; a folder in the way stops everyone.
    QVERIFY(QDir().mkdir(copy + u"-shm"_s));
    const auto reader = RecordingReader::open(copy);
    QVERIFY2(reader, reader ? "" : qPrintable(errorText(reader.error())));
    TelemetryStore back;
    (*reader)->loadAll(back, kStart);
    compareStores(back, store);
}

void tst_recording::finished_isOneFile()
{
    TelemetryStore store;
    fill(store, 5, 3);
    QVERIFY(writeStore(path(), store, 50).has_value());
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), QStringList{u"r.trexrec"_s});
    readEverything(path());
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files), QStringList{u"r.trexrec"_s});
}

void tst_recording::reader_leavesFileAlone()
{
    TelemetryStore store;
    fill(store, 5, 3);
    QVERIFY(writeStore(path(), store, 50).has_value());
    const QByteArray before = contents(path());
    readEverything(path());
    QCOMPARE(contents(path()), before);
}

void tst_recording::strangers_areRefused_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QStringList>("statements");
    QTest::addColumn<QString>("word");
    QTest::newRow("empty") << QByteArray() << QStringList() << u"not a recording"_s;
    QTest::newRow("text") << QByteArray(5000, 'x') << QStringList() << u"not a recording"_s;
    QTest::newRow("header only") << QByteArray("SQLite format 3\0", 16) << QStringList()
                                 << u"not a recording"_s;
    QTest::newRow("another program's database")
        << QByteArray() << QStringList{u"CREATE TABLE a(b)"_s} << u"not a recording"_s;
    QTest::newRow("newer") << QByteArray()
                           << QStringList{u"PRAGMA application_id=1414682706"_s,
                                          u"PRAGMA user_version=2"_s, u"CREATE TABLE a(b)"_s}
                           << u"another version"_s;
    QTest::newRow("no tables") << QByteArray()
                               << QStringList{u"PRAGMA application_id=1414682706"_s,
                                              u"PRAGMA user_version=1"_s, u"CREATE TABLE a(b)"_s}
                               << u"tables"_s;
}

void tst_recording::strangers_areRefused()
{
    QFETCH(const QByteArray, bytes);
    QFETCH(const QStringList, statements);
    QFETCH(const QString, word);
    if (statements.isEmpty()) {
        put(path(), bytes);
    } else {
        tamper(path(), statements);
    }
    const auto reader = RecordingReader::open(path());
    QVERIFY(!reader.has_value());
    QCOMPARE(reader.error().code, ErrorCode::FileMalformed);
    QVERIFY2(errorText(reader.error()).contains(word), qPrintable(errorText(reader.error())));
    QCOMPARE(RecordingReader::open(path(u"none"_s)).error().code, ErrorCode::FileUnreadable);
    QCOMPARE(RecordingReader::open(m_folder->path()).error().code, ErrorCode::FileUnreadable);
}

void tst_recording::damagedBlock_leavesGapAndIsTold()
{
    TelemetryStore store;
    for (int i = 0; i < 5000; ++i) {
        store.append({PollId::Currents, {std::uint16_t(i % 200), 1}, kStart + i * 12ms});
    }
    QVERIFY(writeStore(path(), store, 100).has_value());
    tamper(path(),
           {u"UPDATE data SET samples=zeroblob(100) WHERE block=2"_s,
            u"UPDATE block SET crc=crc+1 WHERE id=4"_s});
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    TelemetryStore back;
    (*reader)->loadAll(back, kStart);
    const TimeSeries& series = back.series("motor1-current");
    QCOMPARE(series.size(), std::size_t(5000 - 2 * 1024));
    QCOMPARE(series.axis().gaps(), (std::vector<std::size_t>{1024, 2048}));
    QVERIFY((*reader)->remark().contains(u"damaged"_s));
}

void tst_recording::hostileRows_areLeftOut()
{
    TelemetryStore store;
    fill(store, 30, 9);
    QVERIFY(writeStore(path(), store, 1000).has_value());
    const QByteArray good = contents(path());
    const QStringList attacks{
        u"UPDATE block SET samples=9223372036854775807"_s,
        u"UPDATE block SET samples=-1"_s,
        u"UPDATE block SET samples='many'"_s,
        u"UPDATE block SET first=9223372036854775807, last=-9223372036854775808"_s,
        u"UPDATE block SET first='x'"_s,
        u"UPDATE block SET poll=NULL"_s,
        u"UPDATE block SET poll='status'"_s,
        u"UPDATE block SET crc=NULL"_s,
        u"UPDATE data SET samples=zeroblob(50000000)"_s,
        u"UPDATE data SET samples='text'"_s,
        u"UPDATE data SET samples=NULL"_s,
        u"DELETE FROM data"_s,
        u"DELETE FROM summary"_s,
        u"UPDATE summary SET stream=stream+900"_s,
        u"UPDATE summary SET valid=9223372036854775807, total=-1"_s,
        u"UPDATE stream SET position=-5"_s,
        u"UPDATE stream SET bytes=8"_s,
        u"UPDATE stream SET poll='of the future'"_s,
        u"DELETE FROM stream"_s,
        u"INSERT INTO event VALUES(NULL,9223372036854775807,900,'k','t'),(NULL,'a',NULL,NULL,NULL)"_s,
        u"INSERT INTO packet VALUES(NULL,1,2,-7,'x',99999,zeroblob(9000000),'t')"_s,
        u"INSERT INTO packet VALUES(9223372036854775807,5,1,0,1,NULL,x'8F',x'00')"_s,
        u"INSERT INTO packet VALUES(NULL,5,9,0,1,NULL,x'8F',x'0102030405060708')"_s,
        u"INSERT INTO packet VALUES(NULL,-5,9,0,1,NULL,x'80078F',NULL)"_s,
        u"INSERT INTO event VALUES(NULL,5,0,'link','gone'),(NULL,6,0,'mode',x'00ff'),(NULL,7,0,'learned','99999999999')"_s,
        u"INSERT OR REPLACE INTO fact VALUES('baud','-1'),('device','4000000000'),('started-utc','never'),('signature','TReXJr9999999999.99')"_s,
        u"INSERT INTO health VALUES(NULL,1,-1,-1,'a',NULL,5,6,7,8,9,'x',1e308)"_s,
        u"INSERT INTO configuration VALUES(NULL,1,'{\"format\":')"_s,
        u"UPDATE fact SET value=zeroblob(9000000)"_s,
        u"DROP TABLE event; "_s,
        u"CREATE TRIGGER t AFTER INSERT ON event BEGIN DELETE FROM data; END"_s,
    };
    for (const QString& attack : attacks) {
        put(path(), good);
        tamper(path(), {attack});
        readEverything(path());
    }
    // A view in the place of a table would run whatever it says.
    put(path(), good);
    tamper(
        path(),
        {u"DROP TABLE event"_s,
         u"CREATE VIEW event AS WITH RECURSIVE n(tick) AS (SELECT 1 UNION ALL SELECT tick+1 FROM n) SELECT 1 AS id, tick, 0 AS severity, 'k' AS kind, 't' AS text FROM n"_s});
    QVERIFY(!RecordingReader::open(path()).has_value());
}

/// Before there were orders and link health.
void tst_recording::earlierFile_opensWithoutRemark()
{
    TelemetryStore store;
    fill(store, 20, 8);
    QVERIFY(writeStore(path(), store, 300).has_value());
    const QString own = u" WHERE poll IN ('orders','link-health')"_s;
    tamper(path(),
           {u"DELETE FROM summary WHERE block IN (SELECT id FROM block"_s + own + u')',
            u"DELETE FROM data WHERE block IN (SELECT id FROM block"_s + own + u')',
            u"DELETE FROM block"_s + own, u"DELETE FROM stream"_s + own});
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    TelemetryStore back;
    (*reader)->loadAll(back, kStart);
    QVERIFY(!(*reader)->remark().contains(u"does not know"_s));
    QCOMPARE(back.series("motor1-current").size(), store.series("motor1-current").size());
    QVERIFY(back.series("motor1-command").isEmpty() && back.series("link-rate").isEmpty());
}

void tst_recording::mutatedBytes_neverCrash()
{
    TelemetryStore store;
    fill(store, 20, 21);
    QVERIFY(writeStore(path(), store, 300).has_value());
    const QByteArray good = contents(path());
    std::minstd_rand random(99);
    const int rounds = qEnvironmentVariableIsSet("TREX_EXHAUSTIVE") ? 5000 : 400;
    for (int round = 0; round < rounds; ++round) {
        QByteArray bad = good;
        const auto changes = 1 + random() % 20;
        for (unsigned long i = 0; i < changes; ++i) {
            // Half of them in the first pages, where the structure is.
            const auto range = random() % 2 == 0 ? qsizetype(8192) : bad.size();
            const auto at = static_cast<qsizetype>(random()) % std::min(range, bad.size());
            bad[at] = static_cast<char>(random());
        }
        put(path(u"bad"_s), bad);
        readEverything(path(u"bad"_s));
    }
}

void tst_recording::truncated_neverCrashes()
{
    TelemetryStore store;
    fill(store, 20, 22);
    QVERIFY(writeStore(path(), store, 300).has_value());
    const QByteArray good = contents(path());
    for (int round = 0; round < 60; ++round) {
        put(path(u"bad"_s), good.left(good.size() * round / 60));
        readEverything(path(u"bad"_s));
    }
}

void tst_recording::writeError_keepsWhatWasWritten()
{
    QVERIFY(!RecordingWriter::create(path(u"no/such/folder"_s), {}).has_value());
    QVERIFY(!RecordingWriter::create(m_folder->path(), {}).has_value());
    const auto full = RecordingWriter::create(u"/dev/full"_s, {});
    QVERIFY(!full.has_value());
    QCOMPARE(full.error().code, ErrorCode::FileUnwritable);
}

void tst_recording::csv_hasEverySampleOnce()
{
    TelemetryStore store;
    std::size_t channels = 0;
    for (int i = 0; i < 200; ++i) {
        const Instant time = kStart + i * 50ms;
        store.append({PollId::Currents, {std::uint16_t(i), 3}, time});
        if (i % 3 != 2) {
            store.append({PollId::RawChannels, {3750, kInvalidPulse, 1, 2, 3}, time + 4ms});
            ++channels;
        }
        if (i % 5 == 0) { // twice in one round
            store.append({PollId::Status, {1}, time + 10ms});
            store.append({PollId::Status, {2}, time + 20ms});
        }
    }
    CsvOptions options{.input = InputKind::Rc};
    options.polls.fill(true);
    const auto rows = exportSamplesCsv(path(u"o.csv"_s), store, options);
    QVERIFY(rows.has_value());
    const QList<QByteArray> lines = contents(path(u"o.csv"_s)).trimmed().split('\n');
    QCOMPARE(lines.front(),
             QByteArray("t_s,motor1_raw,motor2_raw,motor1_A,motor2_A,channel1_raw,channel2_raw,"
                        "channel3_raw,channel4_raw,channel5_raw,channel1_us,channel2_us,"
                        "channel3_us,channel4_us,channel5_us,status_raw"));
    QCOMPARE(std::size_t(lines.size()), *rows + 1);
    QCOMPARE(*rows, std::size_t(200 + 40)); // the second status of a round is a row of its own
    int motor = 0;
    std::size_t seen = 0;
    int statuses = 0;
    double last = -1.0;
    for (qsizetype i = 1; i < lines.size(); ++i) {
        const QList<QByteArray> cells = lines[i].split(',');
        QCOMPARE(cells.size(), 16);
        QVERIFY(cells[0].toDouble() >= last);
        last = cells[0].toDouble();
        if (!cells[1].isEmpty()) {
            QCOMPARE(cells[1].toInt(), motor);
            QCOMPARE(cells[3].toDouble(), motor * 0.04);
            QVERIFY(qAbs(last - motor * 0.05) < 1e-9);
            ++motor;
        }
        if (!cells[5].isEmpty()) {
            ++seen;
            QCOMPARE(cells[6].toInt(), 65535);
            QCOMPARE(cells[10], QByteArray("1500.0"));
            QVERIFY(cells[11].isEmpty());
        }
        statuses += cells[15].isEmpty() ? 0 : 1;
    }
    QCOMPARE(motor, 200);
    QCOMPARE(seen, channels);
    QCOMPARE(statuses, 80);
}

void tst_recording::day_opensInASecond()
{
    // A day in summaries: blocks as full as they get. Written in one transaction, read as it is.
    const int minutes = qEnvironmentVariableIsSet("TREX_EXHAUSTIVE") ? 24 * 60 : 60;
    TelemetryStore store;
    std::minstd_rand random(1);
    for (int i = 0; i < minutes * 60 * 80; ++i) {
        const Instant time = kStart + i * 12'500us + std::chrono::microseconds(random() % 800);
        const auto noisy = [&](double centre) {
            return static_cast<std::uint16_t>(centre + double(random() % 5));
        };
        const double wave = std::sin(i * 0.002);
        store.append({PollId::Currents, {noisy(60 + 40 * wave), noisy(30)}, time});
        if (i % 8 < 5) {
            const auto a = noisy(3750 + 1000 * wave);
            store.append(
                {PollId::RawChannels, {a, noisy(3700), a, noisy(2500), noisy(5000)}, time});
            store.append({PollId::RemappedChannels, {std::uint16_t(a % 100), 0, 3, 4, 5}, time});
        }
        if (i % 8 == 0) {
            store.append({PollId::Status, {0}, time});
            store.append({PollId::UartErrors, {0}, time});
        }
    }
    QVERIFY(writeStore(path(), store, 100'000).has_value());
    QElapsedTimer timer;
    timer.start();
    const auto reader = RecordingReader::open(path());
    const qint64 openMs = timer.restart();
    QVERIFY(reader.has_value());
    const std::size_t spans = (*reader)->overview(0).size();
    TelemetryStore back;
    (*reader)->loadAll(back, kStart);
    const qint64 loadMs = timer.elapsed();
    QCOMPARE(back.series(0).size(), store.series(0).size());
    const double values = double(minutes) * 60 * (80 * 2 + 50 * 10 + 10 * 2);
    qInfo("%d min: %lld bytes (%.2f a value), open %lld ms (%zu spans), load %lld ms", minutes,
          QFileInfo(path()).size(), double(QFileInfo(path()).size()) / values, openMs, spans,
          loadMs);
    QVERIFY(openMs < 5000);
}

QTEST_GUILESS_MAIN(tst_recording)
#include "tst_recording.moc"
