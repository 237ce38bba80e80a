// SPDX-License-Identifier: GPL-3.0-or-later
// Recording a live session on the simulated controller: what the store saw is what the file has.
#include "protocol/storage/flightrecorder.h"
#include "protocol/storage/recordingreader.h"
#include "protocol/storage/sessionrecorder.h"
#include "protocol/telemetry/statuslatch.h"
#include "tests/support/simwitness.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using namespace std::chrono_literals;

namespace {

constexpr int kPatience = 20'000; // ms

SampleTap::Wanted allPolls()
{
    SampleTap::Wanted all;
    all.fill(true);
    return all;
}

/// A controller on the simulator, polled as a window with all panels would.
class Bench : public QObject {
public:
    explicit Bench(const QString& port = u"sim:"_s)
    {
        for (const PollId poll :
             {PollId::Currents, PollId::RawChannels, PollId::RemappedChannels}) {
            controller.want(this, poll, pollRow(poll).hertz);
        }
        OpenOptions options;
        options.port = port;
        controller.open(options);
    }
    [[nodiscard]] std::size_t samples() const { return store.series(0).size(); }

    TelemetryStore store;
    StatusLatch latch;
    Controller controller{&store, &latch};
};

} // namespace

class tst_sessionrecorder : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void session_isRecordedExactly();
    void history_goesBefore();
    void clearedStore_losesNothing();
    void restart_makesTwoFiles();
    void pulledAdapter_leavesAGapAndTheRecordingGoesOn();
    void destruction_finishesFile();
    void unwritable_isToldOnce();
    void flight_freezesOnArmedStop();
    void flight_freezesOnLoss();
    void flight_keepsNewestFiles();
    void flight_knowsItsPolicy();

private:
    QString path(const QString& name = u"r.trexrec"_s) const { return m_folder->filePath(name); }
    std::unique_ptr<QTemporaryDir> m_folder;
};

void tst_sessionrecorder::session_isRecordedExactly()
{
    Bench bench;
    SessionRecorder recorder(bench.controller, bench.store);
    QSignalSpy finished(&recorder, &SessionRecorder::finished);
    QSignalSpy failed(&recorder, &SessionRecorder::failed);
    recorder.start({.path = path(), .polls = allPolls(), .hasPackets = true});
    Configuration configuration;
    configuration.parameters[7] = 5;
    recorder.addConfiguration(configuration);
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 100, kPatience);
    QVERIFY(bench.controller.arm().has_value());
    QVERIFY(bench.controller.driveMotor(MotorId::Motor1, MotorOrder{MotorOrder::Action::Set, 40}));
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 150, kPatience);
    bench.controller.stop();
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 200, kPatience);
    recorder.stop();
    const std::size_t atStop = bench.samples();
    QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, kPatience);
    QVERIFY(failed.isEmpty());
    QVERIFY(!recorder.isRecording());
    QCOMPARE(recorder.samples(), atStop);
    QCOMPARE(recorder.dropped(), std::size_t(0));

    auto opened = RecordingReader::open(path());
    QVERIFY(opened.has_value());
    RecordingReader& reader = **opened;
    QVERIFY(reader.isFinished() && reader.remark().isEmpty());
    TelemetryStore back;
    reader.loadAll(back, Instant(1000s));
    const TimeSeries& ours = bench.store.series(0);
    const TimeSeries& theirs = back.series(0);
    QCOMPARE(theirs.size(), atStop);
    for (std::size_t i = 0; i < atStop; ++i) {
        QCOMPARE(theirs.value(i), ours.value(i));
        QCOMPARE(theirs.axis().tick(i) - theirs.axis().tick(0),
                 ours.axis().tick(i) - ours.axis().tick(0));
    }
    QVERIFY(back.series("status").size() > 5);
    QStringList kinds;
    for (const RecordedEvent& event : reader.events()) {
        kinds << event.kind;
    }
    for (const QString& kind : {u"link"_s, u"armed"_s, u"stop"_s, u"order"_s, u"log"_s}) {
        QVERIFY2(kinds.contains(kind), qPrintable(kind));
    }
    QVERIFY(reader.packetCount() > atStop);
    QVERIFY(!reader.health().empty());
    QCOMPARE(reader.configurations().size(), std::size_t(1));
    QCOMPARE(reader.fact("signature"), u"TReXJr1.2"_s);
    QCOMPARE(reader.fact("port"), u"sim:"_s);
    QVERIFY(reader.input().has_value());
    QVERIFY(qAbs(reader.started().secsTo(QDateTime::currentDateTimeUtc())) < 120);
}

void tst_sessionrecorder::history_goesBefore()
{
    Bench bench;
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 60, kPatience);
    const std::size_t before = bench.samples();
    SessionRecorder recorder(bench.controller, bench.store);
    QSignalSpy finished(&recorder, &SessionRecorder::finished);
    recorder.start({.path = path(), .polls = allPolls(), .history = 60s});
    recorder.stop();
    QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, kPatience);
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    QVERIFY((*reader)->samples(PollId::Currents) >= before);
}

void tst_sessionrecorder::clearedStore_losesNothing()
{
    Bench bench;
    SessionRecorder recorder(bench.controller, bench.store);
    QSignalSpy finished(&recorder, &SessionRecorder::finished);
    SampleTap::Wanted currents{};
    currents[std::size_t(PollId::Currents)] = true;
    recorder.start({.path = path(), .polls = currents});
    std::size_t total = 0;
    for (int i = 0; i < 3; ++i) {
        QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 20, kPatience);
        total += bench.samples();
        bench.store.clear();
    }
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 20, kPatience);
    total += bench.samples();
    recorder.stop();
    QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, kPatience);
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    QCOMPARE((*reader)->samples(PollId::Currents), total);
    QCOMPARE((*reader)->samples(PollId::Status), std::size_t(0)); // not asked for
}

void tst_sessionrecorder::restart_makesTwoFiles()
{
    Bench bench;
    SessionRecorder recorder(bench.controller, bench.store);
    QSignalSpy finished(&recorder, &SessionRecorder::finished);
    recorder.start({.path = path(u"a"_s), .polls = allPolls()});
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 20, kPatience);
    recorder.start({.path = path(u"b"_s), .polls = allPolls()});
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 60, kPatience);
    recorder.stop();
    QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, kPatience);
    QCOMPARE(finished[0][0].toString(), path(u"b"_s));
    for (const QString& name : {u"a"_s, u"b"_s}) {
        const auto reader = RecordingReader::open(path(name));
        QVERIFY(reader.has_value());
        QVERIFY((*reader)->isFinished() && (*reader)->samples(PollId::Currents) > 10);
    }
}

/// Nothing is invented for the time without a line, nothing before or after it is lost, and nothing
/// moves when it is back.
void tst_sessionrecorder::pulledAdapter_leavesAGapAndTheRecordingGoesOn()
{
    const QString log = path(u"witness.jsonl"_s);
    test::SimWitness witness({}, path(u"port"_s), log);
    QVERIFY(witness.isOk());
    Bench bench(path(u"port"_s));
    SessionRecorder recorder(bench.controller, bench.store);
    QSignalSpy finished(&recorder, &SessionRecorder::finished);
    QSignalSpy failed(&recorder, &SessionRecorder::failed);
    recorder.start({.path = path(), .polls = allPolls(), .hasPackets = true});
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 40, kPatience);
    QVERIFY(bench.controller.arm().has_value());
    QVERIFY(bench.controller.driveMotor(MotorId::Motor1, MotorOrder{MotorOrder::Action::Set, 40}));
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 80, kPatience);
    QSignalSpy reconnected(&bench.controller, &Controller::reconnected);
    witness.hangUp(0.8);
    QTRY_VERIFY_WITH_TIMEOUT(bench.controller.state() != LinkState::Connected, kPatience);
    const std::size_t lost = bench.samples();
    QTRY_COMPARE_WITH_TIMEOUT(reconnected.size(), 1, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > lost + 40, kPatience);
    QVERIFY(!bench.controller.isArmed());
    recorder.stop();
    const std::size_t atStop = bench.samples();
    QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, kPatience);
    QVERIFY(failed.isEmpty());
    witness.end();

    const auto opened = RecordingReader::open(path());
    QVERIFY(opened.has_value());
    TelemetryStore back;
    (*opened)->loadAll(back, Instant(1000s));
    const TimeSeries& ours = bench.store.series(0);
    const TimeSeries& theirs = back.series(0);
    QCOMPARE(theirs.size(), atStop);
    Duration longest{0};
    std::size_t place = 0;
    for (std::size_t i = 1; i < theirs.size(); ++i) {
        QCOMPARE(theirs.value(i), ours.value(i));
        const Duration step = theirs.time(i) - theirs.time(i - 1);
        place = step > longest ? i : place;
        longest = std::max(longest, step);
    }
    QVERIFY(longest > 400ms); // without a line there is nothing
    QVERIFY(place > 0 && place < theirs.size() - 20);
    const test::SimRecord record = test::readSimRecord(log);
    QCOMPARE(record.speeds, (std::array{0, 0, 0}));
    QVERIFY(record.moved.front());
}

void tst_sessionrecorder::destruction_finishesFile()
{
    Bench bench;
    {
        SessionRecorder recorder(bench.controller, bench.store);
        recorder.start({.path = path(), .polls = allPolls()});
        QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 20, kPatience);
    }
    const auto reader = RecordingReader::open(path());
    QVERIFY(reader.has_value());
    QVERIFY((*reader)->isFinished());
    QVERIFY(!QFile::exists(path() + u"-wal"_s));
}

void tst_sessionrecorder::unwritable_isToldOnce()
{
    Bench bench;
    SessionRecorder recorder(bench.controller, bench.store);
    QSignalSpy finished(&recorder, &SessionRecorder::finished);
    QSignalSpy failed(&recorder, &SessionRecorder::failed);
    recorder.start({.path = path(u"no/such/folder/x"_s), .polls = allPolls()});
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
    QCOMPARE(failed[0][0].value<Error>().code, ErrorCode::FileUnwritable);
    QVERIFY(!recorder.isRecording());
    recorder.stop();
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 50, kPatience);
    QCOMPARE(failed.size(), 1);
    QVERIFY(finished.isEmpty());
}

void tst_sessionrecorder::flight_freezesOnArmedStop()
{
    Bench bench;
    FlightRecorder flight(bench.controller, bench.store);
    flight.setPolicy({.folder = path(u"flight"_s), .after = 50ms});
    QSignalSpy frozen(&flight, &FlightRecorder::frozen);
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 40, kPatience);
    bench.controller.stop(); // nothing was armed: nothing to keep
    QTRY_VERIFY_WITH_TIMEOUT(bench.controller.arm().has_value(), kPatience);
    const std::size_t before = bench.samples();
    QVERIFY(bench.controller.driveMotor(MotorId::Motor1, MotorOrder{MotorOrder::Action::Set, 20}));
    bench.controller.stop();
    QTRY_COMPARE_WITH_TIMEOUT(frozen.size(), 1, kPatience);
    QVERIFY(frozen[0][0].toString().endsWith(u"-stop.trexrec"_s));
    auto reader = RecordingReader::open(frozen[0][0].toString());
    QVERIFY(reader.has_value());
    QVERIFY((*reader)->samples(PollId::Currents) >= before); // what was before the stop
    QVERIFY((*reader)->packetCount() > 0);
    QCOMPARE((*reader)->fact("reason"), u"stop"_s);
    flight.freeze(u"again"_s); // too soon
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > before + 60, kPatience);
    QCOMPARE(frozen.size(), 1);
}

void tst_sessionrecorder::flight_freezesOnLoss()
{
    Bench bench(u"sim:?fault=silent-after=1"_s);
    FlightRecorder flight(bench.controller, bench.store);
    flight.setPolicy({.folder = path(u"flight"_s), .after = 50ms});
    QSignalSpy frozen(&flight, &FlightRecorder::frozen);
    QTRY_COMPARE_WITH_TIMEOUT(frozen.size(), 1, kPatience);
    QVERIFY(frozen[0][0].toString().endsWith(u"-loss.trexrec"_s));
    const auto reader = RecordingReader::open(frozen[0][0].toString());
    QVERIFY(reader.has_value());
    QVERIFY((*reader)->samples(PollId::Currents) > 0);
}

void tst_sessionrecorder::flight_keepsNewestFiles()
{
    Bench bench;
    FlightRecorder flight(bench.controller, bench.store);
    flight.setPolicy({.folder = path(u"flight"_s), .after = 1ms, .distance = 0s, .files = 3});
    QSignalSpy frozen(&flight, &FlightRecorder::frozen);
    for (int i = 1; i <= 5; ++i) {
        flight.freeze(u"test"_s);
        QTRY_COMPARE_WITH_TIMEOUT(frozen.size(), i, kPatience);
    }
    const QStringList files = QDir(path(u"flight"_s)).entryList(QDir::Files, QDir::Name);
    QCOMPARE(files.size(), 3);
    QVERIFY(frozen[4][0].toString().endsWith(files.back()));
}

void tst_sessionrecorder::flight_knowsItsPolicy()
{
    Bench bench;
    FlightRecorder flight(bench.controller, bench.store);
    QSignalSpy frozen(&flight, &FlightRecorder::frozen);
    flight.freeze(u"test"_s); // no folder
    flight.setPolicy({.isEnabled = false, .folder = path(u"flight"_s), .after = 1ms});
    flight.freeze(u"test"_s);
    QTRY_VERIFY_WITH_TIMEOUT(bench.samples() > 20, kPatience);
    QVERIFY(frozen.isEmpty());
    QVERIFY(!QDir(path(u"flight"_s)).exists());
}

QTEST_GUILESS_MAIN(tst_sessionrecorder)
#include "tst_sessionrecorder.moc"
