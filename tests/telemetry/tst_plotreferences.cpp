// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/plotreferences.h"
#include "protocol/telemetry/streamtable.h"

#include <QSignalSpy>
#include <QTest>

using namespace trex;
using namespace std::chrono_literals;

namespace {

const Instant kStart{1000s};

std::unique_ptr<TelemetryStore> run(Instant start, int samples = 100)
{
    auto store = std::make_unique<TelemetryStore>();
    for (int i = 0; i < samples; ++i) {
        store->append({PollId::Currents, {std::uint16_t(i), 7}, start + i * 10ms});
    }
    return store;
}

} // namespace

class TestPlotReferences : public QObject {
    Q_OBJECT

private slots:
    void run_isAddedShownAndRemoved()
    {
        PlotReferences references;
        QSignalSpy changed(&references, &PlotReferences::changed);
        const int first = references.add(run(kStart), QStringLiteral("Yesterday"), kStart);
        const int second = references.add(run(kStart), QStringLiteral("Today"), kStart);
        QVERIFY(first != second);
        QCOMPARE(references.runs().size(), std::size_t(2));
        QCOMPARE(references.run(first)->name, QStringLiteral("Yesterday"));
        references.setVisible(first, false);
        references.rename(second, QStringLiteral("New"));
        QVERIFY(!references.run(first)->isVisible);
        QCOMPARE(references.run(second)->name, QStringLiteral("New"));
        QCOMPARE(changed.size(), 4);
        references.remove(first);
        QVERIFY(references.run(first) == nullptr);
        references.remove(first); // again: nothing to tell
        QCOMPARE(changed.size(), 5);
        QVERIFY(references.add(run(kStart), QStringLiteral("Third"), kStart) > second);
    }
    void shift_liesTheOriginOnTheAnchor()
    {
        PlotReferences references;
        const int id = references.add(run(kStart), QStringLiteral("a"), kStart);
        references.setAlignment(Alignment::Start);
        QVERIFY(!references.shiftOf(*references.run(id))); // the run looked at has no start yet
        references.setAnchor(Alignment::Start, kStart + 90s);
        QCOMPARE(references.shiftOf(*references.run(id)), std::optional<Duration>(90s));
        QSignalSpy moved(&references, &PlotReferences::moved);
        references.setOffset(id, -250ms);
        QCOMPARE(moved.size(), 1);
        QCOMPARE(references.shiftOf(*references.run(id)), std::optional<Duration>(89'750ms));
    }
    void alignment_needsTheMomentOnBothSides()
    {
        PlotReferences references;
        const int id = references.add(run(kStart), QStringLiteral("a"), kStart);
        references.setAlignment(Alignment::Trigger);
        references.setAnchor(Alignment::Trigger, kStart + 10s);
        QVERIFY(!references.shiftOf(*references.run(id)));
        references.setTrigger(id, kStart + 500ms);
        QCOMPARE(references.shiftOf(*references.run(id)), std::optional<Duration>(9'500ms));
        references.setAnchor(Alignment::Trigger, {});
        QVERIFY(!references.shiftOf(*references.run(id)));
    }
    void commandStep_isWhereASpeedLeavesZero()
    {
        TelemetryStore store;
        const auto order = [&](int motor1, int motor2, Duration after) {
            const auto stored = [](int speed) { return std::uint16_t(speed + kFullSpeed); };
            const std::array raw{stored(motor1), stored(motor2), stored(0)};
            store.append(Source::orders(), raw, kStart + after);
        };
        order(0, 0, 0s);
        QVERIFY(!firstCommandStep(store, kStart));
        QVERIFY(!lastCommandStep(store, kStart + 100s));
        order(0, 0, 1s);
        order(0, 50, 1s);
        order(0, 80, 2s); // faster: it was running
        order(0, 0, 3s);
        order(-20, 0, 4s);
        order(-20, 30, 5s); // the other motor begins
        QCOMPARE(firstCommandStep(store, kStart), std::optional(kStart + 1s));
        QCOMPARE(firstCommandStep(store, kStart + 2s), std::optional(kStart + 4s));
        QCOMPARE(lastCommandStep(store, kStart + 100s), std::optional(kStart + 5s));
        QCOMPARE(lastCommandStep(store, kStart + 3s), std::optional(kStart + 1s));
    }
    void copy_holdsTheSamplesOfItsPartAndTheirGaps()
    {
        TelemetryStore store;
        for (int i = 0; i < 200; ++i) {
            const Instant time = kStart + i * 10ms;
            store.append({PollId::Currents, {std::uint16_t(i), std::uint16_t(200 - i)}, time});
            store.append({PollId::RawChannels, {3000, 3100, 3200, std::uint16_t(i), 0}, time});
            store.append(
                {PollId::RemappedChannels, {std::uint16_t(0x80 | 20), 20, 127, 0, 5}, time});
            if (i == 120) {
                store.markGap(time);
            }
        }
        const auto copy = copyOf(store, kStart + 1s, kStart + 1500ms);
        for (const StreamRow& row : streams()) {
            const TimeSeries& from = store.series(row.key);
            const TimeSeries& to = copy->series(row.key);
            if (from.isEmpty()) {
                QVERIFY(to.isEmpty());
                continue;
            }
            QCOMPARE(to.size(), std::size_t(50));
            for (std::size_t i = 0; i < to.size(); ++i) {
                QCOMPARE(to.value(i), from.value(100 + i));
                QCOMPARE(to.axis().tick(i), from.axis().tick(100 + i));
            }
            QCOMPARE(to.axis().gaps(), std::vector<std::size_t>{21});
        }
        store.clear();
        QCOMPARE(copy->series("motor1-current").size(), std::size_t(50)); // its own
    }
};

QTEST_GUILESS_MAIN(TestPlotReferences)
#include "tst_plotreferences.moc"
