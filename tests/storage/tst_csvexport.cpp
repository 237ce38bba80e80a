// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/csvexport.h"
#include "protocol/storage/csvrecorder.h"
#include "protocol/storage/sampletap.h"

#include <QTemporaryDir>
#include <QtTest>

#ifdef Q_OS_UNIX
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#endif

using namespace trex;
using namespace std::chrono_literals;

namespace {

const Instant kStart{7000s};
constexpr double kJr = amperesPerCount(Model::TrexJr);

void append(TelemetryStore& store, Duration since, std::uint16_t motor1, std::uint16_t motor2)
{
    store.append({PollId::Currents, {motor1, motor2}, kStart + since});
}

/// While it lives, files of this process cannot grow beyond a size: what a full disk is like.
class SmallDisk {
public:
    explicit SmallDisk(quint64 bytes)
    {
#ifdef Q_OS_UNIX
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
#else
        Q_UNUSED(bytes);
#endif
    }
    ~SmallDisk()
    {
#ifdef Q_OS_UNIX
        setrlimit(RLIMIT_FSIZE, &m_before);
#endif
    }
    Q_DISABLE_COPY_MOVE(SmallDisk)

private:
#ifdef Q_OS_UNIX
    rlimit m_before{};
#endif
};

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestCsvExport : public QObject {
    Q_OBJECT

private slots:
    void row_hasSiUnitsAndAPoint();
    void export_writesEverySample();
    void export_ofARangeWritesOnlyIt();
    void export_ofNothingIsAHeader();
    void export_toNowhereSaysWhy();
    void export_leavesTheOldFileWhenItFails();
    void export_toWhatIsNoFileIsRefused();
    void recorder_writesOnlyWhatComesAfterTheStart();
    void recorder_isOnDiskWhileItRuns();
    void recorder_goesOnOverAClear();
    void recorder_endsWhenTheDiskIsFull();
    void recorder_toNowhereSaysWhy();
    void recorders_areNotRobbedByTheCeiling();

private:
    QTemporaryDir m_folder;
};

void TestCsvExport::row_hasSiUnitsAndAPoint()
{
    QCOMPARE(currentsCsvRow(1.234, 55, 255, kJr),
             QByteArray("1.23400,55,255,2.200,10.200\n")); // C-30
}

void TestCsvExport::export_writesEverySample()
{
    TelemetryStore store;
    constexpr int kCount = 5000; // more than a plot has columns
    for (int i = 0; i < kCount; ++i) {
        append(store, i * 12'500us, std::uint16_t(i % 256), std::uint16_t((i * 7) % 256));
    }
    const QString path = m_folder.filePath(QStringLiteral("all.csv"));
    const auto rows = exportCurrentsCsv(path, store, kJr);
    QVERIFY(rows);
    QCOMPARE(*rows, std::size_t(kCount));
    const auto lines = contents(path).split('\n');
    QCOMPARE(lines.size(), kCount + 2); // the header, and what follows the last line feed
    QCOMPARE(lines.first(), QByteArray("t_s,motor1_raw,motor2_raw,motor1_A,motor2_A"));
    for (int i = 0; i < kCount; ++i) {
        const auto fields = lines[i + 1].split(',');
        QCOMPARE(fields.size(), 5);
        QVERIFY(qAbs(fields[0].toDouble() - i * 0.0125) < 2e-5);
        QCOMPARE(fields[1].toInt(), i % 256);
        QCOMPARE(fields[2].toInt(), (i * 7) % 256);
        QVERIFY(qAbs(fields[4].toDouble() - fields[2].toInt() * kJr) < 1e-9);
    }
}

void TestCsvExport::export_ofARangeWritesOnlyIt()
{
    TelemetryStore store;
    for (int i = 0; i < 100; ++i) {
        append(store, i * 10ms, std::uint16_t(i), 0);
    }
    const QString path = m_folder.filePath(QStringLiteral("range.csv"));
    const auto rows =
        exportCurrentsCsv(path, store, kJr, TimeRange{kStart + 200ms, kStart + 300ms});
    QVERIFY(rows);
    QCOMPARE(*rows, std::size_t(10));
    const auto lines = contents(path).split('\n');
    QCOMPARE(lines[1], QByteArray("0.20000,20,0,0.800,0.000")); // seconds count from the start
    QCOMPARE(lines[10], QByteArray("0.29000,29,0,1.160,0.000"));
}

void TestCsvExport::export_ofNothingIsAHeader()
{
    const TelemetryStore store;
    const QString path = m_folder.filePath(QStringLiteral("empty.csv"));
    QCOMPARE(exportCurrentsCsv(path, store, kJr).value(), std::size_t(0));
    QCOMPARE(contents(path), currentsCsvHeader());
}

void TestCsvExport::export_toNowhereSaysWhy()
{
    const TelemetryStore store;
    const QString path = m_folder.filePath(QStringLiteral("no/such/folder/x.csv"));
    const auto rows = exportCurrentsCsv(path, store, kJr);
    QVERIFY(!rows);
    QCOMPARE(rows.error().code, ErrorCode::FileUnwritable);
    QVERIFY(rows.error().context.startsWith(path));
}

void TestCsvExport::export_leavesTheOldFileWhenItFails()
{
#ifndef Q_OS_UNIX
    QSKIP("limits the size of files the Unix way");
#endif
    TelemetryStore store;
    append(store, 0s, 1, 2);
    const QString path = m_folder.filePath(QStringLiteral("old.csv"));
    QVERIFY(exportCurrentsCsv(path, store, kJr));
    const QByteArray before = contents(path);
    for (int i = 0; i < 10'000; ++i) {
        append(store, i * 1ms, 1, 2);
    }
    const SmallDisk disk(20'000);
    const auto rows = exportCurrentsCsv(path, store, kJr);
    QVERIFY(!rows);
    QCOMPARE(rows.error().code, ErrorCode::FileUnwritable);
    QCOMPARE(contents(path), before);
}

void TestCsvExport::export_toWhatIsNoFileIsRefused()
{
#ifdef Q_OS_UNIX
    const TelemetryStore store;
    const QString path = m_folder.filePath(QStringLiteral("pipe"));
    QCOMPARE(mkfifo(qPrintable(path), 0600), 0);
    QVERIFY(!exportCurrentsCsv(path, store, kJr));
    CsvRecorder recorder(store);
    QVERIFY(!recorder.start(path, kJr)); // opening it would wait for a reader
    struct stat state { };
    QCOMPARE(stat(qPrintable(path), &state), 0);
    QVERIFY(S_ISFIFO(state.st_mode));
#endif
}

void TestCsvExport::recorder_writesOnlyWhatComesAfterTheStart()
{
    TelemetryStore store;
    append(store, 0s, 1, 1);
    CsvRecorder recorder(store);
    const QString path = m_folder.filePath(QStringLiteral("record.csv"));
    QVERIFY(recorder.start(path, kJr));
    QVERIFY(recorder.isRecording());
    append(store, 5s, 10, 20);
    append(store, 6s, 11, 21);
    QVERIFY(recorder.pump(kStart + 6s));
    QVERIFY(recorder.stop());
    QVERIFY(!recorder.isRecording());
    QCOMPARE(recorder.samples(), std::size_t(2));
    QCOMPARE(contents(path),
             currentsCsvHeader() + "0.00000,10,20,0.400,0.800\n1.00000,11,21,0.440,0.840\n");
}

void TestCsvExport::recorder_isOnDiskWhileItRuns()
{
    TelemetryStore store;
    CsvRecorder recorder(store);
    const QString path = m_folder.filePath(QStringLiteral("running.csv"));
    QVERIFY(recorder.start(path, kJr));
    for (int i = 0; i < 300; ++i) { // 3.75 s at 80 Hz
        append(store, i * 12'500us, 1, 2);
        QVERIFY(recorder.pump(kStart + i * 12'500us));
    }
    // What a crash would leave: nothing older than a second is missing.
    const auto lines = contents(path).count('\n') - 1;
    QVERIFY2(lines >= 300 - 80, qPrintable(QString::number(lines)));
}

void TestCsvExport::recorder_goesOnOverAClear()
{
    TelemetryStore store;
    CsvRecorder recorder(store);
    const QString path = m_folder.filePath(QStringLiteral("cleared.csv"));
    QVERIFY(recorder.start(path, kJr));
    append(store, 1s, 1, 1);
    QVERIFY(recorder.pump(kStart + 1s));
    store.clear();
    append(store, 2s, 2, 2);
    append(store, 3s, 3, 3);
    QVERIFY(recorder.stop());
    QCOMPARE(contents(path),
             currentsCsvHeader()
                 + "0.00000,1,1,0.040,0.040\n1.00000,2,2,0.080,0.080\n"
                   "2.00000,3,3,0.120,0.120\n");
}

void TestCsvExport::recorder_endsWhenTheDiskIsFull()
{
#ifndef Q_OS_UNIX
    QSKIP("limits the size of files the Unix way");
#endif
    TelemetryStore store;
    CsvRecorder recorder(store);
    const QString path = m_folder.filePath(QStringLiteral("full.csv"));
    QVERIFY(recorder.start(path, kJr));
    const SmallDisk disk(20'000);
    Result<void> pumped;
    for (int i = 0; i < 10'000 && pumped; ++i) {
        append(store, i * 12'500us, 1, 2);
        pumped = recorder.pump(kStart + i * 12'500us);
    }
    QVERIFY(!pumped);
    QCOMPARE(pumped.error().code, ErrorCode::FileUnwritable);
    QVERIFY(!recorder.isRecording());
    QVERIFY(contents(path).startsWith(currentsCsvHeader())); // what was written stays
    QVERIFY(contents(path).size() > 10'000);
}

void TestCsvExport::recorder_toNowhereSaysWhy()
{
    const TelemetryStore store;
    CsvRecorder recorder(store);
    const auto started = recorder.start(m_folder.filePath(QStringLiteral("no/folder/x.csv")), kJr);
    QVERIFY(!started);
    QCOMPARE(started.error().code, ErrorCode::FileUnwritable);
    QVERIFY(!recorder.isRecording());
}

/// What they have not taken yet stays, whatever the ceiling.
void TestCsvExport::recorders_areNotRobbedByTheCeiling()
{
    constexpr int kSamples = 200'000;
    constexpr std::size_t kLimit = 300'000;
    TelemetryStore store;
    store.setMemoryLimit(kLimit);
    CsvRecorder recorder(store);
    const QString path = m_folder.filePath(QStringLiteral("held.csv"));
    QVERIFY(recorder.start(path, kJr).has_value());
    SampleTap tap(store);
    tap.startNow();
    SampleTap::Wanted wanted{};
    wanted[Source(PollId::Currents).index()] = true;
    std::array<SampleRun, kSourceCount> runs;
    const auto takeAll = [&] {
        QVERIFY(recorder.pump(kStart).has_value());
        tap.take(wanted, 0, kSamples, runs);
    };
    for (int i = 0; i < kSamples; ++i) {
        append(store, i * 12'500us, std::uint16_t(i % 251), 3);
        if (i == 100 || i == kSamples / 2) { // now and then, as with a slow disk
            takeAll();
        }
    }
    QVERIFY(store.memoryBytes() > kLimit && store.hasDropped());
    takeAll();
    append(store, kSamples * 12'500us, 1, 1);
    QVERIFY(recorder.stop().has_value());
    QCOMPARE(contents(path).count('\n'), qsizetype(kSamples + 2)); // header and the last one
    const SampleRun& run = runs[Source(PollId::Currents).index()];
    QCOMPARE(run.size(), std::size_t(kSamples));
    for (int i = 0; i < kSamples; ++i) {
        if (run.values[std::size_t(i) * 2] != i % 251) {
            QFAIL("lost or doubled");
        }
    }
    tap.stop();
    for (int i = 1; i <= int(kChunkSize); ++i) {
        append(store, (kSamples + i) * 12'500us, 1, 1);
    }
    QVERIFY(store.memoryBytes() <= kLimit);
}

QTEST_APPLESS_MAIN(TestCsvExport)
#include "tst_csvexport.moc"
