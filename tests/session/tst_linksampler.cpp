// SPDX-License-Identifier: GPL-3.0-or-later
// What is sampled of orders and of the line's health, out of the batches of a real engine on a
// virtual line, and of batches made by hand.
#include "protocol/codec/packet.h"
#include "protocol/session/linksampler.h"
#include "protocol/telemetry/streamtable.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/simulatedlink.h"

#include <QTest>

using namespace trex;
using namespace std::chrono_literals;

namespace {

const Instant kStart{100s};

LinkBatch connectedBatch(Instant time)
{
    LinkBatch batch;
    batch.events.push_back({.kind = LinkEvent::Kind::StateChanged,
                            .state = LinkState::Connected,
                            .error = {},
                            .signature = {},
                            .time = time});
    return batch;
}

TransactionRecord order(const Command& command, Instant sent)
{
    TransactionRecord record;
    record.command = command;
    record.priority = Priority::Motor;
    record.sentBytes = encode(command, {});
    record.sent = sent;
    record.ended = sent;
    return record;
}

TransactionRecord reply(Instant sent, Duration trip)
{
    TransactionRecord record;
    record.command = query("get-mode");
    record.receivedBytes = "r";
    record.sent = sent;
    record.ended = sent + trip;
    return record;
}

LinkBatch of(const TransactionRecord& record)
{
    LinkBatch batch;
    batch.records.push_back(record);
    return batch;
}

/// Physical values of a stream, oldest first; what is unknown is 999.
std::vector<double> valuesOf(const TelemetryStore& store, std::string_view key)
{
    const TimeSeries& series = store.series(key);
    const StreamRow& row = streams()[std::size_t(streamIndex(key))];
    std::vector<double> values;
    for (std::size_t i = 0; i < series.size(); ++i) {
        values.push_back(series.isValid(i) ? physicalFromStored(row, series.value(i)) : 999.0);
    }
    return values;
}

using Values = std::vector<double>;

} // namespace

class tst_linksampler : public QObject {
    Q_OBJECT

private slots:
    void order_isAStepAtItsTime()
    {
        TelemetryStore store;
        LinkSampler sampler(store);
        sampler.take(connectedBatch(kStart), {});
        QVERIFY(store.series("motor1-command").isEmpty()); // nothing was told yet
        const Instant first = kStart + 1s;
        sampler.take(of(order(*driveMotor(MotorId::Motor1, {.amount = -64}), first)), {});
        QCOMPARE(valuesOf(store, "motor1-command"), Values{-64});
        QCOMPARE(valuesOf(store, "motor2-command"), Values{999}); // told by nobody we know
        const Instant second = first + 100ms;
        sampler.take(of(order(*driveBoth({.amount = 10}, {.amount = -127}), second)), {});
        QCOMPARE(valuesOf(store, "motor1-command"), (Values{-64, -64, 10}));
        QCOMPARE(valuesOf(store, "motor2-command"), (Values{999, 999, -127}));
        const TimeSeries& series = store.series("motor1-command");
        QCOMPARE(series.time(1), second - TimeAxis::kTick);
        QCOMPARE(series.time(2), second);
        // The same again is no news.
        sampler.take(of(order(*driveBoth({.amount = 10}, {.amount = -127}), second + 10ms)), {});
        QCOMPARE(series.size(), std::size_t(3));
    }

    void everyMotorCommand_isUnderstood_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<Values>("orders");
        const auto packet = [](const Result<Command>& command) { return encode(*command, {}); };
        using Action = MotorOrder::Action;
        QTest::newRow("set 1") << packet(driveMotor(MotorId::Motor1, {Action::Set, 5}))
                               << Values{5, 999, 999};
        QTest::newRow("accelerate 2")
            << packet(driveMotor(MotorId::Motor2, {Action::Accelerate, -7}))
            << Values{999, -7, 999};
        QTest::newRow("brake 1") << packet(driveMotor(MotorId::Motor1, {Action::Brake, 90}))
                                 << Values{0, 999, 999};
        QTest::newRow("aux") << packet(driveMotor(MotorId::Aux, {Action::Set, 33}))
                             << Values{999, 999, 33};
        QTest::newRow("accelerate both")
            << packet(driveBoth({Action::Accelerate, -1}, {Action::Accelerate, 127}))
            << Values{-1, 127, 999};
        QTest::newRow("brake both")
            << packet(driveBoth({Action::Brake, 127}, {Action::Set, 3})) << Values{0, 3, 999};
    }
    void everyMotorCommand_isUnderstood() // sent as raw bytes: the same
    {
        QFETCH(QByteArray, bytes);
        QFETCH(Values, orders);
        TelemetryStore store;
        LinkSampler sampler(store);
        sampler.take(connectedBatch(kStart), {});
        TransactionRecord record;
        record.isRaw = true;
        record.sentBytes = bytes;
        record.sent = kStart + 1s;
        record.ended = record.sent;
        sampler.take(of(record), {});
        QCOMPARE(valuesOf(store, "motor1-command"), Values{orders[0]});
        QCOMPARE(valuesOf(store, "motor2-command"), Values{orders[1]});
        QCOMPARE(valuesOf(store, "aux-command"), Values{orders[2]});
        record.sentBytes += bytes + '\x00'; // nobody can tell what was made of this
        record.sent += 1s;
        sampler.take(of(record), {});
        QCOMPARE(valuesOf(store, "aux-command").back(), 999.0);
        QCOMPARE(valuesOf(store, "motor1-command").back(), 999.0);
    }

    void heartbeat_goesOnWhileTheLineLives()
    {
        TelemetryStore store;
        LinkSampler sampler(store);
        sampler.take(connectedBatch(kStart), {});
        sampler.take(of(order(*driveMotor(MotorId::Aux, {.amount = 5}), kStart)), {});
        for (int i = 1; i <= 100; ++i) { // ten seconds
            sampler.take(of(reply(kStart + i * 100ms, 1ms)), {});
        }
        const TimeSeries& series = store.series("aux-command");
        QVERIFY(series.size() > 30 && series.size() < 42);
        QVERIFY(series.axis().gaps().empty());
        QCOMPARE(valuesOf(store, "aux-command").back(), 5.0);
    }

    void loss_endsTheCurveAndWhatADeadLineIsTold()
    {
        TelemetryStore store;
        LinkSampler sampler(store);
        sampler.take(connectedBatch(kStart), {});
        sampler.take(of(order(*driveMotor(MotorId::Aux, {.amount = 5}), kStart + 1s)), {});
        LinkBatch lost = connectedBatch(kStart + 2s);
        lost.events.front().state = LinkState::Lost;
        // In one batch: the loss, and the stop that nobody may have heard.
        lost.records.push_back(order(stopCommands(false)[1], kStart + 2s));
        sampler.take(lost, {});
        sampler.take(of(order(stopCommands(false)[1], kStart + 3s)), {});
        QCOMPARE(store.series("aux-command").size(), std::size_t(1));
        sampler.take(connectedBatch(kStart + 4s), {});
        sampler.take(of(order(stopCommands(false)[1], kStart + 4s)), {});
        QCOMPARE(valuesOf(store, "aux-command"), (Values{5, 0}));
        QCOMPARE(store.series("aux-command").axis().gaps(), std::vector<std::size_t>{1});
        // A restart has made the controller forget.
        sampler.forgetOrders();
        sampler.take(of(reply(kStart + 10s, 1ms)), {});
        QCOMPARE(store.series("aux-command").size(), std::size_t(2));
    }

    void health_countsTransactionsTripsAndErrors()
    {
        TelemetryStore store;
        LinkSampler sampler(store);
        sampler.take(connectedBatch(kStart), {});
        LinkStats stats;
        for (int i = 0; i <= 20; ++i) { // 10 a second; the median of 4, 4, 9 is 4
            LinkBatch batch = of(reply(kStart + i * 100ms, i % 3 == 0 ? 9ms : 4ms));
            stats.transactions = quint64(i) + 1;
            stats.timeouts = i > 15 ? 3 : 0;
            batch.stats = stats;
            sampler.take(batch, {});
        }
        QCOMPARE(store.series("link-rate").size(), std::size_t(1));
        LinkBatch batch = of(reply(kStart + 3s, 4ms));
        batch.stats = stats;
        sampler.take(batch, {});
        QCOMPARE(store.series("link-rate").size(), std::size_t(2));
        QVERIFY(qAbs(valuesOf(store, "link-rate")[0] - 10.0) < 0.3);
        QCOMPARE(valuesOf(store, "link-latency"), (Values{4, 4}));
        QCOMPARE(valuesOf(store, "link-errors")[0], 0.0);
        QVERIFY(valuesOf(store, "link-errors")[1] >= 1.0);
        // Nothing answered: no round trip, which is not a short one.
        LinkBatch silent = of(order(*driveMotor(MotorId::Aux, {.amount = 5}), kStart + 6s));
        silent.stats = stats;
        sampler.take(silent, {});
        QCOMPARE(valuesOf(store, "link-latency").back(), 999.0);
    }

    void simulatedMinute_agreesWithTheEngine()
    {
        sim::SimOptions options;
        options.pace = true;
        test::SimulatedLink link(options, {});
        TelemetryStore store;
        LinkSampler sampler(store);
        link.onBatch = [&](const LinkBatch& batch) { sampler.take(batch, {}); };
        link.open();
        PollWishes wishes{};
        wishes.fill(10.0);
        link.engine.setWishes(wishes, link.now);
        link.run(20s);
        link.engine.submit(
            {.command = *driveMotor(MotorId::Motor2, {.amount = 50}), .priority = Priority::Motor});
        link.run(20s);
        std::vector<Transaction> stops;
        for (const Command& command : stopCommands(false)) {
            stops.push_back({.command = command, .priority = Priority::Stop});
        }
        link.engine.stop(stops, link.now);
        link.run(20s);
        const Values orders = valuesOf(store, "motor2-command");
        QCOMPARE(orders.front(), 50.0);
        QCOMPARE(orders.back(), 0.0);
        QVERIFY(std::is_sorted(orders.rbegin(), orders.rend()));
        const Values rates = valuesOf(store, "link-rate");
        QVERIFY(rates.size() > 50 && rates.size() <= 60);
        QVERIFY(qAbs(rates[30] - link.stats.transactionsPerSecond) < 5.0);
        QVERIFY(store.series("link-latency").axis().gaps().empty());
        for (const double trip : valuesOf(store, "link-latency")) {
            QVERIFY(trip > 1.0 && trip < 10.0); // two to eleven bytes at 19200 baud
        }
    }
};

QTEST_GUILESS_MAIN(tst_linksampler)
#include "tst_linksampler.moc"
