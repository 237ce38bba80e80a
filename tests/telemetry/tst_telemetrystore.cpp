// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/streamtable.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QtTest>

#include <random>

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
    void ceiling_dropsTheOldestAndNothingElse();
    void ceiling_spareWhatAHolderNeeds();
    void ceiling_canBeLoweredAndTakenAway();
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

/// Two hours of two sources at 80 and 50 Hz, with invalid pulses and gaps.
template <class F>
void play(int seconds, F&& append)
{
    std::minstd_rand random(3);
    for (int i = 0; i < seconds * 80; ++i) {
        const Instant time = kStart + i * 12'500us + std::chrono::microseconds(random() % 3000);
        append(sample(PollId::Currents, time,
                      {std::uint16_t(random() % 256), std::uint16_t(random() % 9)}));
        if (i % 8 < 5) {
            const auto pulse = random() % 7 == 0 ? kInvalidPulse : std::uint16_t(random() % 6000);
            append(sample(PollId::RawChannels, time + 3ms, {pulse, 1, 2, 3, 4}));
        }
        if (i % 800 == 0) {
            append(sample(PollId::Status, time + 5ms, {std::uint16_t(random() % 256)}));
        }
    }
}

/// What is there is as in a store that keeps everything.
void compare(const TimeSeries& series, const TimeSeries& whole)
{
    QCOMPARE(series.size(), whole.size());
    const std::size_t first = series.first();
    for (std::size_t i = first; i < series.size(); ++i) {
        if (series.value(i) != whole.value(i) || series.time(i) != whole.time(i)
            || series.isValid(i) != whole.isValid(i)) {
            QFAIL(qPrintable(QString::number(i)));
        }
    }
    std::minstd_rand random(5);
    for (int i = 0; i < 300 && first < series.size(); ++i) {
        const std::size_t begin = first + random() % (series.size() - first);
        const std::size_t end = begin + random() % (series.size() - begin + 1);
        QCOMPARE(series.extent(begin, end), whole.extent(begin, end));
        QCOMPARE(series.mean(begin, end), whole.mean(begin, end));
        QCOMPARE(series.sum(begin, end).squares, whole.sum(begin, end).squares);
        QCOMPARE(series.doubleArea(begin, end), whole.doubleArea(begin, end));
        QCOMPARE(series.range(series.time(begin), series.time(end - (end > begin ? 1 : 0))),
                 whole.range(series.time(begin), series.time(end - (end > begin ? 1 : 0))));
        QCOMPARE(series.axis().hasGapBetween(begin, end), whole.axis().hasGapBetween(begin, end));
    }
    // Asked from the session's start on: only what is there.
    QCOMPARE(series.range(kStart, Instant::max()), (std::pair{first, series.size()}));
    QCOMPARE(series.extent(0, series.size()), whole.extent(first, series.size()));
    QCOMPARE(series.mean(0, series.size()), whole.mean(first, series.size()));
    QCOMPARE(series.doubleArea(0, series.size()), whole.doubleArea(first, series.size()));
    std::vector<PlotColumn> columns;
    series.columns({kStart, 10s, 720}, columns);
    std::size_t next = first;
    for (const PlotColumn& column : columns) {
        QCOMPARE(column.begin, next);
        QCOMPARE(column.extent, whole.extent(column.begin, column.end));
        next = column.end;
    }
    QCOMPARE(next, series.size());
}

void TestTelemetryStore::ceiling_dropsTheOldestAndNothingElse()
{
    constexpr std::size_t kLimit = 2'000'000;
    TelemetryStore store;
    TelemetryStore whole;
    store.setMemoryLimit(kLimit);
    std::size_t most = 0;
    play(7200, [&](const PollSample& each) {
        store.append(each);
        whole.append(each);
        most = std::max(most, store.memoryBytes());
    });
    QVERIFY(whole.memoryBytes() > 2 * kLimit);
    QVERIFY2(most < kLimit + 200'000, qPrintable(QString::number(most))); // a chunk of each stream
    QVERIFY(store.memoryBytes() <= kLimit);
    QVERIFY(store.hasDropped() && !whole.hasDropped());
    for (int i = 0; i < int(streams().size()); ++i) {
        compare(store.series(i), whole.series(i));
    }
    // All streams begin at about the same time; few samples may stay for long.
    const TimeSeries& currents = store.series("motor1-current");
    const TimeSeries& channels = store.series("channel1-raw");
    QVERIFY(currents.first() > 0 && currents.first() % kChunkSize == 0);
    const auto apart = currents.time(currents.first()) - channels.time(channels.first());
    QVERIFY(std::chrono::abs(apart) < 150s);
    QCOMPARE(store.start(), whole.start()); // second 0 stays second 0
    QVERIFY(*store.oldest() > *store.start() || store.series("status").first() == 0);
    store.clear();
    QVERIFY(!store.hasDropped());
    QVERIFY(!store.oldest());
    QCOMPARE(store.series(0).first(), std::size_t(0));
    store.append(sample(PollId::Currents, kStart, {7, 8}));
    QCOMPARE(store.series(0).value(0), 7);
}

void TestTelemetryStore::ceiling_spareWhatAHolderNeeds()
{
    struct Holder : SampleHolder {
        std::size_t next = 0;
        [[nodiscard]] std::size_t firstNeeded(Source source) const override
        {
            return source == PollId::Currents ? next : std::numeric_limits<std::size_t>::max();
        }
    };
    constexpr std::size_t kLimit = 1'000'000;
    TelemetryStore store;
    store.setMemoryLimit(kLimit);
    Holder holder;
    store.addHolder(holder);
    play(3600, [&](const PollSample& each) { store.append(each); });
    QCOMPARE(store.series("motor1-current").first(), std::size_t(0));
    QVERIFY(store.memoryBytes() > kLimit);
    holder.next = 100'000;
    play(60, [&](PollSample each) {
        each.time += 2h;
        store.append(each);
    });
    const std::size_t first = store.series("motor1-current").first();
    QVERIFY(first > 100'000 - 2 * kChunkSize && first <= 100'000);
    store.removeHolder(holder);
    play(60, [&](PollSample each) {
        each.time += 3h;
        store.append(each);
    });
    QVERIFY(store.memoryBytes() <= kLimit);
}

void TestTelemetryStore::ceiling_canBeLoweredAndTakenAway()
{
    TelemetryStore store;
    play(3600, [&](const PollSample& each) { store.append(each); });
    const std::size_t all = store.memoryBytes();
    store.setMemoryLimit(all / 2);
    QVERIFY(store.memoryBytes() <= all / 2);
    QVERIFY(store.memoryBytes() > all / 3);
    store.setMemoryLimit(1); // the newest chunk of each stays
    QVERIFY(!store.series("motor1-current").isEmpty());
    QVERIFY(store.series("motor1-current").first() < store.series("motor1-current").size());
    store.setMemoryLimit(0);
    const std::size_t first = store.series("motor1-current").first();
    play(600, [&](PollSample each) {
        each.time += 2h;
        store.append(each);
    });
    QCOMPARE(store.series("motor1-current").first(), first);
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
