// SPDX-License-Identifier: GPL-3.0-or-later
// A recording on a stage: at every moment the façade, the store and the latch say what they said
// then, and nothing that is asked of them reaches a line.
#include "protocol/codec/packet.h"
#include "protocol/errortext.h"
#include "protocol/storage/recordingplayer.h"
#include "protocol/storage/recordingwriter.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using namespace std::chrono_literals;

namespace {

constexpr Tick kSecond = std::chrono::seconds(1) / TimeAxis::kTick;

/// Ten seconds: currents that count up ten times a second, status each second with a fault in
/// second 4, a link that is lost at 6 s and back at 8 s, settings that change at 3 s, packets ten
/// times a second.
RecordingBatch tenSeconds()
{
    RecordingBatch batch;
    SampleRun& currents = batch.runs[std::size_t(PollId::Currents)];
    for (int i = 0; i <= 100; ++i) {
        currents.ticks.push_back(i * kSecond / 10);
        currents.values.push_back(static_cast<std::uint16_t>(i));
        currents.values.push_back(7);
        batch.packets.push_back({.sent = i * kSecond / 10,
                                 .ended = i * kSecond / 10 + 200,
                                 .priority = 3,
                                 .sentBytes = encode(query("get-currents"), {}),
                                 .receivedBytes = QByteArray::fromHex("0507")});
    }
    SampleRun& status = batch.runs[std::size_t(PollId::Status)];
    for (int i = 0; i <= 10; ++i) {
        status.ticks.push_back(i * kSecond);
        status.values.push_back(i == 4 ? statusbit::kMotor1Fault : 0);
        batch.health.push_back({.tick = i * kSecond, .transactions = quint64(i) * 10});
    }
    batch.events = {
        {0, 0, u"link"_s, u"connected"_s},           {0, 0, u"mode"_s, u"serial-rc"_s},
        {0, 0, u"serial-control"_s, u"true"_s},      {2 * kSecond, 0, u"armed"_s, u"true"_s},
        {2 * kSecond, 0, u"log"_s, u"Armed."_s},     {5 * kSecond, 1, u"stop"_s, {}},
        {5 * kSecond, 0, u"armed"_s, u"false"_s},    {6 * kSecond, 2, u"link"_s, u"lost"_s},
        {8 * kSecond, 0, u"link"_s, u"connected"_s}, {8 * kSecond, 0, u"mode"_s, u"rc"_s}};
    Configuration before;
    before.parameters[parameterRow("serial-timeout").number] = 5;
    Configuration after = before;
    after.parameters[parameterRow("serial-timeout").number] = 9;
    batch.configurations = {{0, before}, {3 * kSecond, after}};
    return batch;
}

class Bench {
public:
    Bench()
    {
        controller.becomeRecording();
        auto writer = RecordingWriter::create(path(),
                                              {{u"signature"_s, u"TReXJr1.2"_s},
                                               {u"baud"_s, u"19200"_s},
                                               {u"stop-bits"_s, u"1"_s},
                                               {u"started-utc"_s, u"2026-11-22T12:00:00.000Z"_s}});
        if (writer && (*writer)->write(tenSeconds()) && (*writer)->finish()) {
            if (auto reader = RecordingReader::open(path())) {
                player = std::make_unique<RecordingPlayer>(
                    std::move(*reader), RecordingStage{controller, settings, store, latch});
                while (player->loader().loadSlice(50ms)) { }
                player->seek(player->first());
            }
        }
    }
    [[nodiscard]] QString path() const { return m_folder.filePath(u"r.trexrec"_s); }
    [[nodiscard]] int motor1() const
    {
        const PollSample* latest = store.latest(PollId::Currents);
        return latest == nullptr ? -1 : latest->raw[0];
    }
    [[nodiscard]] std::optional<int> timeout() const
    {
        return settings.parameter(parameterRow("serial-timeout").number);
    }

    QTemporaryDir m_folder;
    TelemetryStore store;
    StatusLatch latch;
    Controller controller{&store, nullptr};
    DeviceSettings settings{controller};
    std::unique_ptr<RecordingPlayer> player;
};

Instant at(double seconds)
{
    return Instant(std::chrono::milliseconds(qRound(seconds * 1000.0)));
}

} // namespace

class tst_recordingplayer : public QObject {
    Q_OBJECT

private slots:
    void seek_showsThatMoment();
    void lostLink_isNotBridged();
    void latch_countsAsThen();
    void packets_areThoseBefore();
    void packets_followWithoutDoubles();
    void play_runsAtItsSpeed();
    void play_startsAgainAtTheEnd();
    void steps_findSamplesAndEvents();
    void events_passOnce();
    void facade_reachesNoLine();
    void writing_isRefused();
    void emptyRecording_opens();
};

void tst_recordingplayer::seek_showsThatMoment()
{
    Bench bench;
    QVERIFY(bench.player);
    QCOMPARE(bench.player->first(), Tick(0));
    QCOMPARE(bench.player->last(), 10 * kSecond);
    bench.player->seek(2 * kSecond + kSecond / 20); // between two samples
    QCOMPARE(bench.motor1(), 20);
    QCOMPARE(bench.store.now(), RecordingPlayer::instantOf(2 * kSecond + kSecond / 20));
    QCOMPARE(bench.controller.state(), LinkState::Connected);
    QCOMPARE(bench.controller.device().mode, Mode::SerialRc);
    QCOMPARE(bench.controller.device().serialControls, true);
    QCOMPARE(bench.controller.device().signature->text(), u"TReXJr1.2"_s);
    QCOMPARE(bench.controller.stats().transactions, quint64(20));
    QVERIFY(bench.player->wasArmed());
    QVERIFY(!bench.controller.isArmed()); // that was then
    QCOMPARE(bench.timeout(), std::optional(5));
    QCOMPARE(bench.player->wallClock().toUTC().toString(Qt::ISODate), u"2026-11-22T12:00:02Z"_s);
    bench.player->seek(4 * kSecond);
    QCOMPARE(bench.timeout(), std::optional(9));
    bench.player->seek(kSecond);
    QCOMPARE(bench.timeout(), std::optional(5));
    QCOMPARE(bench.motor1(), 10);
    QVERIFY(!bench.player->wasArmed());
    bench.player->seek(100 * kSecond); // kept within
    QCOMPARE(bench.player->playhead(), 10 * kSecond);
    QCOMPARE(bench.motor1(), 100);
}

void tst_recordingplayer::lostLink_isNotBridged()
{
    Bench bench;
    QVERIFY(bench.player);
    bench.player->seek(6 * kSecond - 1);
    QCOMPARE(bench.controller.state(), LinkState::Connected);
    QCOMPARE(bench.motor1(), 59);
    bench.player->seek(6 * kSecond + 1);
    QCOMPARE(bench.controller.state(), LinkState::Lost);
    QCOMPARE(bench.controller.device().mode, std::nullopt);
    QVERIFY(bench.controller.device().signature); // scales the currents of the whole recording
    QCOMPARE(bench.timeout(), std::nullopt); // as live: a lost link forgets
    bench.player->seek(9 * kSecond);
    QCOMPARE(bench.controller.device().mode, Mode::Rc);
    QCOMPARE(bench.controller.device().serialControls, std::nullopt); // not heard again
    QCOMPARE(bench.timeout(), std::optional(9));
}

void tst_recordingplayer::latch_countsAsThen()
{
    Bench bench;
    QVERIFY(bench.player);
    constexpr auto kByte = StatusLatch::Byte::Status;
    int bit = 0;
    while ((statusbit::kMotor1Fault >> bit & 1) == 0) {
        ++bit;
    }
    bench.player->seek(4 * kSecond - 1);
    QCOMPARE(bench.latch.entry(kByte, bit).count, 0);
    bench.player->seek(4 * kSecond);
    QVERIFY(bench.latch.entry(kByte, bit).lit);
    QCOMPARE(bench.latch.entry(kByte, bit).count, 1);
    bench.player->seek(5 * kSecond);
    QVERIFY(!bench.latch.entry(kByte, bit).lit);
    QCOMPARE(bench.latch.entry(kByte, bit).count, 1);
    QCOMPARE(bench.latch.entry(kByte, bit).lastSeen.msecsTo(bench.latch.now()), 1000);
    bench.player->seek(0);
    QCOMPARE(bench.latch.entry(kByte, bit).count, 0);
}

void tst_recordingplayer::packets_areThoseBefore()
{
    Bench bench;
    QVERIFY(bench.player);
    QSignalSpy forgotten(&bench.controller, &Controller::recordsForgotten);
    std::size_t shown = 0;
    connect(&bench.controller, &Controller::recordsForgotten, this, [&] { shown = 0; });
    connect(&bench.controller, &Controller::recordsArrived, this,
            [&](const std::vector<TransactionRecord>& records) {
                shown += records.size();
                QVERIFY(!records.back().isRaw && !records.back().error);
                QCOMPARE(std::string_view(records.back().command.row().key), "get-currents");
            });
    bench.player->seek(9 * kSecond);
    QCOMPARE(shown + 1, std::size_t(91)); // the first was shown before we listened
    bench.player->seek(3 * kSecond); // backwards: anew
    QVERIFY(!forgotten.isEmpty());
    QCOMPARE(shown, std::size_t(31));
}

void tst_recordingplayer::packets_followWithoutDoubles()
{
    Bench bench;
    QVERIFY(bench.player);
    std::vector<Instant> sent;
    connect(&bench.controller, &Controller::recordsArrived, this,
            [&](const std::vector<TransactionRecord>& records) {
                for (const TransactionRecord& record : records) {
                    sent.push_back(record.sent);
                }
            });
    bench.player->play(at(0));
    for (int i = 1; i <= 200; ++i) {
        bench.player->advance(at(i * 0.033));
    }
    QCOMPARE(sent.size() + 1, std::size_t(67)); // 6.6 s
    QVERIFY(std::is_sorted(sent.begin(), sent.end()));
    QVERIFY(std::adjacent_find(sent.begin(), sent.end()) == sent.end());
}

void tst_recordingplayer::play_runsAtItsSpeed()
{
    Bench bench;
    QVERIFY(bench.player);
    QSignalSpy playing(&bench.player.operator*(), &RecordingPlayer::playingChanged);
    bench.player->play(at(100));
    bench.player->advance(at(101));
    QCOMPARE(bench.player->playhead(), kSecond);
    bench.player->setSpeed(4.0, at(101));
    bench.player->advance(at(102));
    QCOMPARE(bench.player->playhead(), 5 * kSecond);
    bench.player->seek(kSecond); // and on from there
    bench.player->advance(at(102.5));
    QCOMPARE(bench.player->playhead(), 3 * kSecond);
    bench.player->setSpeed(0.1, at(102.5));
    bench.player->advance(at(103.5));
    QCOMPARE(bench.player->playhead(), 3 * kSecond + kSecond / 10);
    bench.player->pause();
    bench.player->advance(at(200));
    QCOMPARE(bench.player->playhead(), 3 * kSecond + kSecond / 10);
    QCOMPARE(playing.size(), 2);
}

void tst_recordingplayer::play_startsAgainAtTheEnd()
{
    Bench bench;
    QVERIFY(bench.player);
    bench.player->play(at(0));
    bench.player->advance(at(1000));
    QCOMPARE(bench.player->playhead(), 10 * kSecond);
    QVERIFY(!bench.player->isPlaying());
    bench.player->play(at(1000));
    QCOMPARE(bench.player->playhead(), Tick(0));
    QVERIFY(bench.player->isPlaying());
}

void tst_recordingplayer::steps_findSamplesAndEvents()
{
    Bench bench;
    QVERIFY(bench.player);
    bench.player->seek(kSecond + 3);
    bench.player->stepSample(1);
    QCOMPARE(bench.player->playhead(), kSecond + kSecond / 10);
    bench.player->stepSample(-1);
    QCOMPARE(bench.player->playhead(), kSecond);
    bench.player->stepEvent(1);
    QCOMPARE(bench.player->playhead(), 2 * kSecond);
    bench.player->stepEvent(1);
    QCOMPARE(bench.player->playhead(), 5 * kSecond);
    bench.player->stepEvent(-1);
    QCOMPARE(bench.player->playhead(), 2 * kSecond);
    bench.player->seek(10 * kSecond);
    bench.player->stepSample(1); // nothing further
    bench.player->stepEvent(1);
    QCOMPARE(bench.player->playhead(), 10 * kSecond);
}

void tst_recordingplayer::events_passOnce()
{
    Bench bench;
    QVERIFY(bench.player);
    QSignalSpy passed(bench.player.get(), &RecordingPlayer::eventsPassed);
    bench.player->seek(3 * kSecond);
    QCOMPARE(passed.size(), 1);
    QCOMPARE(passed[0][0].toULongLong(), 3ULL);
    QCOMPARE(passed[0][1].toULongLong(), 5ULL);
    QCOMPARE(passed[0][2].toBool(), false);
    bench.player->seek(4 * kSecond);
    QCOMPARE(passed.size(), 1); // nothing happened
    bench.player->seek(kSecond);
    QCOMPARE(passed.size(), 2);
    QCOMPARE(passed[1][0].toULongLong(), 0ULL);
    QCOMPARE(passed[1][1].toULongLong(), 3ULL);
    QCOMPARE(passed[1][2].toBool(), true);
}

void tst_recordingplayer::facade_reachesNoLine()
{
    Bench bench;
    QVERIFY(bench.player);
    Controller& controller = bench.controller;
    QSignalSpy states(&controller, &Controller::stateChanged);
    QSignalSpy records(&controller, &Controller::recordsArrived);
    QSignalSpy stops(&controller, &Controller::lockedOut);
    QSignalSpy logged(&controller, &Controller::eventLogged);
    const auto armed = controller.arm();
    QVERIFY(!armed);
    QCOMPARE(armed.error().code, ErrorCode::IsRecording);
    QVERIFY(errorText(armed.error()).contains(u"recording"_s));
    QCOMPARE(controller.driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 50}).error().code,
             ErrorCode::IsRecording);
    QCOMPARE(controller.driveBoth({}, {}).error().code, ErrorCode::IsRecording);
    controller.open({.port = u"sim:"_s, .line = {}}); // refused, with a sentence
    QCOMPARE(logged.size(), 1);
    controller.close();
    controller.stop();
    QCOMPARE(stops.size(), 1); // whoever connects a live controller stops that one
    std::optional<ErrorCode> raw;
    std::optional<ErrorCode> query;
    controller.requestRaw(QByteArray::fromHex("c240"), 0, this, [&](const Result<Reply>& reply) {
        raw = reply ? std::nullopt : std::optional(reply.error().code);
    });
    controller.request(trex::query("get-mode"), this, [&](const Result<Reply>& reply) {
        query = reply ? std::nullopt : std::optional(reply.error().code);
    });
    QTRY_COMPARE(query, ErrorCode::IsRecording);
    QCOMPARE(raw, ErrorCode::IsRecording);
    QTest::qWait(200); // time for a link thread to answer, if anything had reached it
    QVERIFY(states.isEmpty() && records.isEmpty());
    QVERIFY(!controller.isArmed());
}

void tst_recordingplayer::writing_isRefused()
{
    Bench bench;
    QVERIFY(bench.player);
    std::optional<Error> error;
    bench.settings.writeParameter(parameterRow("serial-timeout"), 77, true, this,
                                  [&](const Result<DeviceSettings::ParameterWrite>& written) {
                                      error =
                                          written ? std::nullopt : std::optional(written.error());
                                  });
    QTRY_VERIFY(error);
    QCOMPARE(error->code, ErrorCode::IsRecording);
    QCOMPARE(bench.timeout(), std::optional(5));
    bool isRead = false;
    bench.settings.readAll(this, {}, [&](const Result<void>& read) { isRead = bool(read); });
    QTRY_VERIFY(isRead);
}

void tst_recordingplayer::emptyRecording_opens()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"empty"_s);
    {
        auto writer = RecordingWriter::create(path, {});
        QVERIFY(writer);
    }
    auto reader = RecordingReader::open(path);
    QVERIFY(reader);
    TelemetryStore store;
    StatusLatch latch;
    Controller controller(&store, nullptr);
    controller.becomeRecording();
    DeviceSettings settings(controller);
    RecordingPlayer player(std::move(*reader), {controller, settings, store, latch});
    player.play(at(0));
    player.advance(at(1));
    player.stepSample(1);
    player.stepEvent(-1);
    QCOMPARE(player.first(), player.last());
    QVERIFY(!player.isPlaying());
}

QTEST_GUILESS_MAIN(tst_recordingplayer)
#include "tst_recordingplayer.moc"
