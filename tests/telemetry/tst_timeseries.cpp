// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/timeseries.h"

#include <QtTest>

#include <algorithm>
#include <random>

using namespace trex;
using namespace std::chrono_literals;

namespace {

constexpr std::uint16_t kInvalid = 0xFFFF;
const Instant kStart{1'000'000s};

/// The same samples, kept as plainly as can be.
struct Reference {
    std::vector<TimeAxis::Tick> ticks;
    std::vector<int> values;
    std::vector<bool> valid;
    [[nodiscard]] std::size_t lowerBound(TimeAxis::Tick wanted) const
    {
        return std::size_t(std::lower_bound(ticks.begin(), ticks.end(), wanted) - ticks.begin());
    }
    [[nodiscard]] Extent extent(std::size_t begin, std::size_t end) const
    {
        Extent result;
        for (std::size_t i = begin; i < end; ++i) {
            if (valid[i]) {
                result.add({values[i], values[i]});
            }
        }
        return result;
    }
    [[nodiscard]] std::optional<double> mean(std::size_t begin, std::size_t end) const
    {
        double sum = 0.0;
        int count = 0;
        for (std::size_t i = begin; i < end; ++i) {
            sum += valid[i] ? values[i] : 0;
            count += valid[i] ? 1 : 0;
        }
        return count == 0 ? std::nullopt : std::optional(sum / count);
    }
};

/// A series and its reference, filled alike: irregular steps, spikes, invalid values, pauses.
struct Pair {
    TimeAxis axis;
    TimeSeries series;
    Reference reference;
    std::mt19937 random;

    Pair(ValueWidth width, bool hasInvalid, unsigned seed)
        : series(axis, width, hasInvalid ? std::optional(kInvalid) : std::nullopt), random(seed)
    {
    }
    void fill(std::size_t count, int highest, int invalidPercent, int pausePerMille)
    {
        Instant time = kStart;
        for (std::size_t i = 0; i < count; ++i) {
            time += std::chrono::microseconds(10 * (random() % 2500));
            if (int(random() % 1000) < pausePerMille) {
                time += std::chrono::milliseconds(1000 + random() % 60'000);
            }
            const bool isInvalid = int(random() % 100) < invalidPercent;
            const auto value =
                isInvalid ? kInvalid : std::uint16_t(random() % unsigned(highest + 1));
            add(time, value);
        }
    }
    void add(Instant time, std::uint16_t value)
    {
        axis.append(time);
        series.append(value);
        reference.ticks.push_back(TimeAxis::ticksOf(time));
        reference.values.push_back(value);
        reference.valid.push_back(series.isValid(reference.values.size() - 1));
    }
};

} // namespace

class TestTimeSeries : public QObject {
    Q_OBJECT

private slots:
    void empty_hasNothing();
    void values_comeBackAsWritten_data();
    void values_comeBackAsWritten();
    void lowerBound_agreesWithReference();
    void extentAndMean_agreeWithReference_data();
    void extentAndMean_agreeWithReference();
    void columns_areExactAndLoseNothing_data();
    void columns_areExactAndLoseNothing();
    void columns_showEverySpikeOfAMillion();
    void gaps_areKept();
    void longSilence_keepsTimesNearEnough();
    void timesThatRunBackwards_areClamped();
    void clear_forgetsEverything();
    void memory_isAtMostSixBytesASample();
};

void TestTimeSeries::empty_hasNothing()
{
    const Pair pair(ValueWidth::Byte, false, 1);
    QVERIFY(pair.series.isEmpty());
    QVERIFY(pair.series.extent(0, 0).isEmpty());
    QVERIFY(!pair.series.mean(0, 0));
    std::vector<PlotColumn> columns;
    pair.series.columns({kStart, 1ms, 50}, columns);
    QCOMPARE(columns.size(), std::size_t(50));
    QVERIFY(std::all_of(columns.begin(), columns.end(),
                        [](const PlotColumn& column) { return column.begin == column.end; }));
}

void TestTimeSeries::values_comeBackAsWritten_data()
{
    QTest::addColumn<ValueWidth>("width");
    QTest::addColumn<int>("count");
    for (const int count : {1, 7, 8, 9, 4095, 4096, 4097, 20'000}) {
        QTest::addRow("8 bit, %d", count) << ValueWidth::Byte << count;
        QTest::addRow("16 bit, %d", count) << ValueWidth::Word << count;
    }
}

void TestTimeSeries::values_comeBackAsWritten()
{
    QFETCH(ValueWidth, width);
    QFETCH(int, count);
    Pair pair(width, false, 2);
    pair.fill(std::size_t(count), width == ValueWidth::Byte ? 255 : 65535, 0, 1);
    QCOMPARE(pair.series.size(), std::size_t(count));
    for (std::size_t i = 0; i < std::size_t(count); ++i) {
        QCOMPARE(pair.series.value(i), pair.reference.values[i]);
        QCOMPARE(pair.axis.tick(i), pair.reference.ticks[i]);
    }
}

void TestTimeSeries::lowerBound_agreesWithReference()
{
    Pair pair(ValueWidth::Byte, false, 3);
    pair.fill(30'000, 255, 0, 3);
    const auto& ticks = pair.reference.ticks;
    for (int round = 0; round < 20'000; ++round) {
        const auto near = ticks[pair.random() % ticks.size()];
        const TimeAxis::Tick wanted = near + TimeAxis::Tick(pair.random() % 5) - 2;
        const std::size_t hint = pair.random() % (ticks.size() + 1);
        QCOMPARE(pair.axis.lowerBound(wanted, hint), pair.reference.lowerBound(wanted));
    }
    QCOMPARE(pair.axis.lowerBound(ticks.front() - 1), std::size_t(0));
    QCOMPARE(pair.axis.lowerBound(ticks.back() + 1), ticks.size());
}

void TestTimeSeries::extentAndMean_agreeWithReference_data()
{
    QTest::addColumn<ValueWidth>("width");
    QTest::addColumn<int>("highest");
    QTest::addColumn<int>("invalidPercent");
    QTest::newRow("currents") << ValueWidth::Byte << 255 << 0;
    QTest::newRow("channels, all valid") << ValueWidth::Word << 6250 << 0;
    QTest::newRow("channels, some invalid") << ValueWidth::Word << 6250 << 30;
    QTest::newRow("channels, nearly all invalid") << ValueWidth::Word << 6250 << 99;
}

void TestTimeSeries::extentAndMean_agreeWithReference()
{
    QFETCH(ValueWidth, width);
    QFETCH(int, highest);
    QFETCH(int, invalidPercent);
    Pair pair(width, width == ValueWidth::Word, 4);
    pair.fill(13'000, highest, invalidPercent, 0);
    for (int round = 0; round < 1500; ++round) {
        std::size_t begin = pair.random() % pair.series.size();
        std::size_t end = pair.random() % (pair.series.size() + 1);
        if (begin > end) {
            std::swap(begin, end);
        }
        QCOMPARE(pair.series.extent(begin, end), pair.reference.extent(begin, end));
        const auto mean = pair.series.mean(begin, end);
        const auto expected = pair.reference.mean(begin, end);
        QCOMPARE(mean.has_value(), expected.has_value());
        QVERIFY(!mean || qAbs(*mean - *expected) < 1e-6);
    }
}

void TestTimeSeries::columns_areExactAndLoseNothing_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("pausePerMille");
    QTest::newRow("sparse") << 300 << 900 << 0;
    QTest::newRow("dense") << 60'000 << 300 << 0;
    QTest::newRow("very dense") << 60'000 << 7 << 0;
    QTest::newRow("dense with pauses") << 60'000 << 500 << 3;
    QTest::newRow("one column") << 9000 << 1 << 1;
}

void TestTimeSeries::columns_areExactAndLoseNothing()
{
    QFETCH(int, samples);
    QFETCH(int, columns);
    QFETCH(int, pausePerMille);
    Pair pair(ValueWidth::Byte, false, 5);
    pair.fill(std::size_t(samples), 255, 0, pausePerMille);
    const auto& ticks = pair.reference.ticks;
    const TimeAxis::Tick span = ticks.back() - ticks.front() + 1;
    const TimeAxis::Tick width = span / columns + 1;
    const ColumnGrid grid{TimeAxis::instantOf(ticks.front()), width * TimeAxis::kTick, columns};
    std::vector<PlotColumn> result;
    pair.series.columns(grid, result);

    std::size_t next = 0;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const PlotColumn& column = result[i];
        QCOMPARE(column.begin, next); // each sample in exactly one column
        next = column.end;
        QCOMPARE(column.extent, pair.reference.extent(column.begin, column.end));
        // A border moves by at most an eighth of the samples of its thinner neighbour.
        const std::size_t trueEnd =
            pair.reference.lowerBound(ticks.front() + TimeAxis::Tick(i + 1) * width);
        QVERIFY(column.end <= trueEnd);
        QVERIFY((trueEnd - column.end) * 8
                <= std::max<std::size_t>(column.end - column.begin, 1) + 8);
    }
    QCOMPARE(next, std::size_t(samples));
}

void TestTimeSeries::columns_showEverySpikeOfAMillion()
{
    Pair pair(ValueWidth::Byte, false, 6);
    constexpr std::size_t kSamples = 1'000'000;
    std::vector<std::size_t> spikes;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const bool isSpike = pair.random() % 100'000 == 0;
        pair.add(kStart + std::int64_t(i) * 12'500us, isSpike ? 200 : std::uint16_t(20 + i % 5));
        if (isSpike) {
            spikes.push_back(i);
        }
    }
    QVERIFY(!spikes.empty());
    std::vector<PlotColumn> columns;
    pair.series.columns({kStart, 12'500us * (kSamples / 900 + 1), 900}, columns);
    std::size_t columnsWithSpike = 0;
    for (const PlotColumn& column : columns) {
        const bool holdsSpike = std::any_of(spikes.begin(), spikes.end(), [&](std::size_t i) {
            return i >= column.begin && i < column.end;
        });
        QCOMPARE(column.extent.high == 200, holdsSpike);
        columnsWithSpike += holdsSpike ? 1 : 0;
    }
    QVERIFY(columnsWithSpike > 0);
}

void TestTimeSeries::gaps_areKept()
{
    Pair pair(ValueWidth::Byte, false, 7);
    for (int i = 0; i < 10; ++i) {
        pair.add(kStart + i * 10ms, 1);
    }
    pair.axis.markGap(); // the link was lost for a moment
    pair.add(kStart + 120ms, 2);
    pair.add(kStart + 130ms, 2);
    pair.add(kStart + 5s, 3); // nobody asked for a while
    const std::vector<std::size_t> expected{10, 12};
    QCOMPARE(pair.axis.gaps(), expected);
    QVERIFY(pair.axis.hasGapBetween(9, 10));
    QVERIFY(!pair.axis.hasGapBetween(10, 11));
    QVERIFY(pair.axis.hasGapBetween(11, 12));
    QVERIFY(!pair.axis.hasGapBetween(0, 9));
}

void TestTimeSeries::longSilence_keepsTimesNearEnough()
{
    Pair pair(ValueWidth::Byte, false, 8);
    pair.add(kStart, 1);
    pair.add(kStart + 10ms, 2);
    pair.add(kStart + 24h * 30, 3); // beyond 32 bits of 10 µs
    pair.add(kStart + 24h * 30 + 10s, 4);
    QVERIFY(pair.axis.time(1) - kStart <= 10ms && pair.axis.time(1) - kStart > 9ms);
    const Duration error = kStart + 24h * 30 - pair.axis.time(2);
    QVERIFY(error >= 0s && error < 5ms);
    QCOMPARE(pair.axis.lowerBound(TimeAxis::ticksOf(kStart + 24h)), std::size_t(2));
    QCOMPARE(pair.axis.lowerBound(TimeAxis::ticksOf(kStart + 24h * 30 + 5s)), std::size_t(3));
}

void TestTimeSeries::timesThatRunBackwards_areClamped()
{
    Pair pair(ValueWidth::Byte, false, 9);
    pair.add(kStart + 1s, 1);
    pair.add(kStart, 2);
    QCOMPARE(pair.axis.tick(1), pair.axis.tick(0));
}

void TestTimeSeries::clear_forgetsEverything()
{
    Pair pair(ValueWidth::Word, true, 10);
    pair.fill(5000, 6250, 10, 5);
    pair.axis.clear();
    pair.series.clear();
    QVERIFY(pair.series.isEmpty());
    QVERIFY(pair.axis.gaps().empty());
    pair.axis.append(kStart);
    pair.series.append(77);
    QCOMPARE(pair.series.extent(0, 1), (Extent{77, 77}));
    QCOMPARE(*pair.series.mean(0, 1), 77.0);
}

void TestTimeSeries::memory_isAtMostSixBytesASample()
{
    TimeAxis axis;
    TimeSeries series(axis, ValueWidth::Byte);
    constexpr std::size_t kSamples = 1'000'000;
    for (std::size_t i = 0; i < kSamples; ++i) {
        axis.append(kStart + std::int64_t(i) * 12'500us);
        series.append(std::uint16_t(i & 0xFFU));
    }
    const double bytes = double(axis.memoryBytes() + series.memoryBytes()) / double(kSamples);
    QVERIFY2(bytes <= 6.0, qPrintable(QString::number(bytes)));
    QVERIFY2(bytes >= 5.0, qPrintable(QString::number(bytes))); // 4 of time and 1 of value
}

QTEST_APPLESS_MAIN(TestTimeSeries)
#include "tst_timeseries.moc"
