// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/trigger.h"

#include <QTest>

using namespace trex;
using namespace std::chrono_literals;

namespace {

const Instant kStart{1000s};
constexpr Duration kStep = 10ms;
constexpr ValueScale kPlain{};
using Mode = TriggerSettings::Mode;
using Edge = TriggerSettings::Edge;
using State = Trigger::State;

TriggerSettings settings(Mode mode, Edge edge = Edge::Rising)
{
    TriggerSettings result;
    result.mode = mode;
    result.edge = edge;
    result.level = 100.0;
    result.before = 50ms;
    result.after = 100ms;
    return result;
}

/// Samples 10 ms apart; the trigger looks after each.
struct Bench {
    explicit Bench(const TriggerSettings& with) : trigger(with) { }
    bool add(std::uint16_t value)
    {
        axis.append(now);
        series.append(value);
        const bool told = trigger.advance(series, kPlain, now);
        now += kStep;
        return told;
    }
    void add(std::uint16_t value, int times)
    {
        for (int i = 0; i < times; ++i) {
            add(value);
        }
    }
    TimeAxis axis;
    TimeSeries series{axis, ValueWidth::Word, std::uint16_t(0xFFFF)};
    Trigger trigger;
    Instant now = kStart;
};

} // namespace

class TestTrigger : public QObject {
    Q_OBJECT

private slots:
    void risingEdge_isTheFirstSampleAtTheLevel()
    {
        Bench bench(settings(Mode::Normal));
        bench.add(10, 5);
        QVERIFY(!bench.trigger.crossing());
        const Instant expected = bench.now;
        QVERIFY(bench.add(100));
        QCOMPARE(bench.trigger.crossing(), std::optional(expected));
        QCOMPARE(bench.trigger.state(), State::Capturing);
    }
    void beginningAboveTheLevel_isNoCrossing()
    {
        Bench bench(settings(Mode::Normal));
        bench.add(200, 20);
        QVERIFY(!bench.trigger.crossing());
    }
    void edges_countAsChosen_data()
    {
        QTest::addColumn<int>("edge");
        QTest::addColumn<int>("count");
        QTest::newRow("rising") << int(Edge::Rising) << 2;
        QTest::newRow("falling") << int(Edge::Falling) << 1;
        QTest::newRow("both") << int(Edge::Both) << 3;
    }
    void edges_countAsChosen()
    {
        QFETCH(int, edge);
        QFETCH(int, count);
        Bench bench(settings(Mode::Normal, Edge(edge)));
        for (const int value : {0, 200, 0, 200}) { // each longer than what is shown after
            bench.add(std::uint16_t(value), 15);
        }
        QCOMPARE(bench.trigger.count(), count);
    }
    void hysteresis_keepsNoiseOut()
    {
        TriggerSettings with = settings(Mode::Normal);
        with.after = 0ms;
        with.hysteresis = 20.0;
        Bench bench(with);
        bench.add(50);
        bench.add(105);
        for (int i = 0; i < 20; ++i) {
            bench.add(i % 2 == 0 ? 95 : 105);
        }
        QCOMPARE(bench.trigger.count(), 1);
        bench.add(79);
        bench.add(105);
        QCOMPARE(bench.trigger.count(), 2);
        with.hysteresis = 0.0;
        Bench nervous(with);
        for (int i = 0; i < 20; ++i) {
            nervous.add(i % 2 == 0 ? 95 : 105);
        }
        QVERIFY(nervous.trigger.count() > 5);
    }
    void single_holdsUntilArmed()
    {
        Bench bench(settings(Mode::Single));
        bench.add(0, 3);
        const Instant first = bench.now;
        bench.add(200, 9);
        QCOMPARE(bench.trigger.state(), State::Capturing);
        bench.add(200, 3);
        QCOMPARE(bench.trigger.state(), State::Holding);
        bench.add(0, 20);
        bench.add(200, 20);
        QCOMPARE(bench.trigger.crossing(), std::optional(first));
        bench.trigger.arm(bench.now);
        QVERIFY(!bench.trigger.crossing());
        bench.add(0, 2);
        bench.add(200, 1);
        QCOMPARE(bench.trigger.count(), 1);
    }
    void single_isCompleteEvenWhenNoSampleComes()
    {
        Bench bench(settings(Mode::Single));
        bench.add(0);
        bench.add(200);
        QVERIFY(bench.trigger.advance(bench.series, kPlain, bench.now + 200ms));
        QCOMPARE(bench.trigger.state(), State::Holding);
    }
    void crossingWhileCapturing_doesNotCount()
    {
        Bench bench(settings(Mode::Normal));
        bench.add(0, 2);
        const Instant first = bench.now;
        bench.add(200, 2);
        bench.add(0, 2);
        bench.add(200, 2); // 40 ms after the first
        QCOMPARE(bench.trigger.crossing(), std::optional(first));
        QCOMPARE(bench.trigger.count(), 1);
    }
    void arming_ignoresWhatWasBefore()
    {
        Bench bench(settings(Mode::Normal));
        bench.trigger.arm(kStart + 1s);
        bench.add(0, 10);
        bench.add(200, 10);
        QVERIFY(!bench.trigger.crossing());
    }
    void gap_isNoCrossing_data()
    {
        QTest::addColumn<bool>("isInvalid");
        QTest::newRow("gap") << false;
        QTest::newRow("invalid sample") << true;
    }
    void gap_isNoCrossing()
    {
        QFETCH(bool, isInvalid);
        Bench bench(settings(Mode::Normal));
        bench.add(0, 5);
        if (isInvalid) {
            bench.add(0xFFFF);
        } else {
            bench.axis.markGap();
        }
        bench.add(200, 5);
        QVERIFY(!bench.trigger.crossing());
        bench.add(0);
        bench.add(200);
        QVERIFY(bench.trigger.crossing().has_value());
    }
    void automatic_runsFreelyWhileNothingComes()
    {
        Bench bench(settings(Mode::Auto));
        QVERIFY(bench.trigger.runsFreely(bench.now));
        bench.add(0, 2);
        bench.add(200);
        QVERIFY(!bench.trigger.runsFreely(bench.now));
        bench.add(200, 12);
        QVERIFY(!bench.trigger.runsFreely(bench.now)); // it is looked at for a while
        QVERIFY(bench.trigger.runsFreely(bench.now + 1s));
        Bench normal(settings(Mode::Normal));
        QVERIFY(!normal.trigger.runsFreely(normal.now + 100s));
    }
    void firstCrossing_searchesFromAMoment()
    {
        Bench bench(settings(Mode::Normal));
        for (int i = 0; i < 3; ++i) {
            bench.add(0, 50);
            bench.add(200, 50);
        }
        const auto found = [&](Instant from) {
            return firstCrossing(bench.series, kPlain, settings(Mode::Normal), from);
        };
        QCOMPARE(found(kStart), std::optional(kStart + 500ms));
        QCOMPARE(found(kStart + 600ms), std::optional(kStart + 1500ms));
        QVERIFY(!found(kStart + 2600ms));
    }
};

QTEST_GUILESS_MAIN(TestTrigger)
#include "tst_trigger.moc"
