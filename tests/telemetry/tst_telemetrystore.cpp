// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/streamtable.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QtTest>

using namespace trex;
using namespace std::chrono_literals;

namespace {
const Instant kStart{5000s};

PollSample sample(PollId poll, Instant time, std::array<std::uint16_t, kChannelCount> raw)
{
    return {poll, raw, time};
}
} // namespace

class TestTelemetryStore : public QObject {
    Q_OBJECT

private slots:
    void streams_haveRowsThatAreFound();
    void append_fillsEveryStreamOfThePoll();
    void remapped_isStoredAsNumberThatOrders();
    void invalidPulse_isNeverAValue();
    void latest_isGoneAfterAGap();
    void revision_growsWithEachChange();
    void clear_startsAnew();
    void currents_takeAtMostSixBytes();
};

void TestTelemetryStore::streams_haveRowsThatAreFound()
{
    QVERIFY(streams().size() >= 12);
    for (std::size_t i = 0; i < streams().size(); ++i) {
        QCOMPARE(streamIndex(streams()[i].key), int(i));
    }
    QCOMPARE(streamIndex("no-such-stream"), -1);
}

void TestTelemetryStore::append_fillsEveryStreamOfThePoll()
{
    TelemetryStore store;
    QVERIFY(!store.start());
    store.append(sample(PollId::Currents, kStart, {55, 22}));
    store.append(sample(PollId::RawChannels, kStart + 1ms, {2500, 3750, 5000, 3637, 2715}));
    QCOMPARE(*store.start(), kStart);
    QCOMPARE(store.series("motor1-current").value(0), 55);
    QCOMPARE(store.series("motor2-current").value(0), 22);
    QCOMPARE(store.series("channel5-raw").value(0), 2715); // C-25
    QVERIFY(store.series("channel1-remapped").isEmpty());
    const StreamRow& row = streams()[std::size_t(streamIndex("motor1-current"))];
    QCOMPARE(physicalFromStored(row, 55), 2.2); // C-30
    // The times are the poll's own, shared by its streams.
    QCOMPARE(&store.series("channel1-raw").axis(), &store.series("channel5-raw").axis());
    QCOMPARE(store.series("channel1-raw").time(0), kStart + 1ms);
}

void TestTelemetryStore::remapped_isStoredAsNumberThatOrders()
{
    // C-27: bit 7 is the direction; −12 is 0x8C, full reverse 0xFF
    TelemetryStore store;
    store.append(sample(PollId::RemappedChannels, kStart, {0x8C, 0, 127, 0xFF, 0x80}));
    const auto physical = [&store](std::string_view key) {
        const StreamRow& row = streams()[std::size_t(streamIndex(key))];
        return physicalFromStored(row, store.series(key).value(0));
    };
    QCOMPARE(physical("channel1-remapped"), -12.0);
    QCOMPARE(physical("channel2-remapped"), 0.0);
    QCOMPARE(physical("channel3-remapped"), 127.0);
    QCOMPARE(physical("channel4-remapped"), -127.0);
    QCOMPARE(physical("channel5-remapped"), 0.0);
}

void TestTelemetryStore::invalidPulse_isNeverAValue()
{
    // C-24
    TelemetryStore store;
    for (int i = 0; i < 100; ++i) {
        const std::uint16_t first = i % 2 == 0 ? kInvalidPulse : std::uint16_t(3000 + i);
        store.append(sample(PollId::RawChannels, kStart + i * 20ms,
                            {first, kInvalidPulse, 3750, 3750, 3750}));
    }
    QCOMPARE(store.series("channel1-raw").extent(0, 100), (Extent{3001, 3099}));
    QVERIFY(store.series("channel2-raw").extent(0, 100).isEmpty());
    QVERIFY(!store.series("channel2-raw").mean(0, 100));
    QVERIFY(!store.series("channel2-raw").isValid(5));
}

void TestTelemetryStore::latest_isGoneAfterAGap()
{
    TelemetryStore store;
    QVERIFY(store.latest(PollId::Mode) == nullptr);
    store.append(sample(PollId::Mode, kStart, {'r'}));
    store.append(sample(PollId::Currents, kStart, {1, 2}));
    QCOMPARE(store.latest(PollId::Mode)->raw[0], std::uint16_t('r'));
    store.markGap(kStart + 1s);
    QVERIFY(store.latest(PollId::Mode) == nullptr);
    QVERIFY(store.latest(PollId::Currents) == nullptr);
    store.append(sample(PollId::Currents, kStart + 20ms, {1, 2}));
    QVERIFY(store.latest(PollId::Currents) != nullptr);
    QVERIFY(store.series("motor1-current").axis().hasGapBetween(0, 1));
}

void TestTelemetryStore::revision_growsWithEachChange()
{
    TelemetryStore store;
    quint64 before = store.revision();
    const auto grew = [&] { return std::exchange(before, store.revision()) < store.revision(); };
    store.append(sample(PollId::Currents, kStart, {1, 2}));
    QVERIFY(grew());
    store.append(sample(PollId::SerialControl, kStart, {1}));
    QVERIFY(grew());
    store.markGap(kStart);
    QVERIFY(grew());
    store.clear();
    QVERIFY(grew());
    QVERIFY(!grew());
}

void TestTelemetryStore::clear_startsAnew()
{
    TelemetryStore store;
    store.append(sample(PollId::Currents, kStart, {1, 2}));
    const int clears = store.clears();
    store.clear();
    QCOMPARE(store.clears(), clears + 1);
    QVERIFY(!store.start());
    QVERIFY(store.series("motor1-current").isEmpty());
    store.append(sample(PollId::Currents, kStart + 9s, {3, 4}));
    QCOMPARE(*store.start(), kStart + 9s);
    QCOMPARE(store.series("motor2-current").value(0), 4);
    QVERIFY(store.series("motor2-current").axis().gaps().empty());
}

void TestTelemetryStore::currents_takeAtMostSixBytes()
{
    TelemetryStore store;
    const std::size_t before = store.memoryBytes();
    constexpr int kReplies = 500'000;
    for (int i = 0; i < kReplies; ++i) {
        store.append(sample(PollId::Currents, kStart + i * 12'500us, {std::uint16_t(i % 200), 7}));
    }
    const double bytes = double(store.memoryBytes() - before) / (2.0 * kReplies);
    QVERIFY2(bytes <= 6.0 && bytes >= 3.0, qPrintable(QString::number(bytes)));
}

QTEST_APPLESS_MAIN(TestTelemetryStore)
#include "tst_telemetrystore.moc"
