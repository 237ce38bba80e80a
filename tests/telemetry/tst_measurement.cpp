// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/measurement.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace trex;
using namespace std::chrono_literals;

namespace {

const Instant kStart{1000s};
constexpr ValueScale kAmperes{0.04, 0};
constexpr std::uint16_t kInvalid = 0xFFFF;

struct Samples {
    TimeAxis axis;
    TimeSeries series;
    Instant now = kStart;
    explicit Samples(ValueWidth width = ValueWidth::Byte, std::optional<std::uint16_t> invalid = {})
        : series(axis, width, invalid)
    {
    }
    void add(std::uint16_t value, Duration step = 12'500us)
    {
        axis.append(now);
        series.append(value);
        now += step;
    }
};

/// The same numbers, worked out sample by sample.
Measurement plainly(const TimeSeries& series, const ValueScale& scale, std::size_t begin,
                    std::size_t end)
{
    Measurement all;
    all.minimum = 1e9;
    all.maximum = -1e9;
    double sum = 0.0;
    double squares = 0.0;
    double area = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        if (!series.isValid(i)) {
            continue;
        }
        const double value = scale.physical(series.value(i));
        ++all.samples;
        all.minimum = std::min(all.minimum, value);
        all.maximum = std::max(all.maximum, value);
        sum += value;
        squares += value * value;
        if (i > begin && series.isValid(i - 1) && !series.axis().hasGapBetween(i - 1, i)) {
            const double before = scale.physical(series.value(i - 1));
            const std::chrono::duration<double> step = series.time(i) - series.time(i - 1);
            area += (value + before) / 2 * step.count();
        }
    }
    all.mean = sum / double(all.samples);
    all.rms = std::sqrt(squares / double(all.samples));
    all.integral = area;
    return all;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

} // namespace

class TestMeasurement : public QObject {
    Q_OBJECT

private slots:
    void nothingBetween_isNone()
    {
        Samples samples;
        QVERIFY(!measure(samples.series, kAmperes, kStart, kStart + 1s));
        samples.add(10);
        QVERIFY(!measure(samples.series, kAmperes, kStart + 1ms, kStart + 1s));
        QCOMPARE(measure(samples.series, kAmperes, kStart, kStart + 1ms)->samples, std::size_t(1));
    }
    void steadyCurrent_givesItsCharge()
    {
        Samples samples;
        for (int i = 0; i <= 80 * 60; ++i) { // a minute and its last sample
            samples.add(50);
        }
        const auto found = measure(samples.series, kAmperes, kStart, samples.now);
        QVERIFY(found.has_value());
        QCOMPARE(found->samples, std::size_t(4801));
        QVERIFY(isNear(found->mean, 2.0));
        QVERIFY(isNear(found->rms, 2.0));
        QVERIFY(isNear(milliampereHours(*found->integral), 2000.0 / 60.0));
    }
    void signedValues_areMeasuredAboutZero()
    {
        Samples samples;
        for (int i = 0; i < 100; ++i) {
            samples.add(i % 2 == 0 ? 127 + 100 : 127 - 100);
        }
        const auto found = measure(samples.series, {1.0, -127}, kStart, samples.now);
        QVERIFY(isNear(found->mean, 0.0));
        QVERIFY(isNear(found->rms, 100.0));
        QCOMPARE(found->minimum, -100.0);
        QCOMPARE(found->maximum, 100.0);
        QVERIFY(!found->integral); // zero is not stored as zero
    }
    void everyRange_agreesWithThePlainSum_data()
    {
        QTest::addColumn<bool>("isWord");
        QTest::newRow("bytes") << false;
        QTest::newRow("words, some invalid") << true;
    }
    void everyRange_agreesWithThePlainSum()
    {
        QFETCH(bool, isWord);
        Samples samples(isWord ? ValueWidth::Word : ValueWidth::Byte,
                        isWord ? std::optional(kInvalid) : std::nullopt);
        std::mt19937 random(7);
        for (std::size_t i = 0; i < 3 * kChunkSize + 77; ++i) {
            const auto value = static_cast<std::uint16_t>(random() % (isWord ? 5000 : 256));
            samples.add(isWord && random() % 50 == 0 ? kInvalid : value,
                        std::chrono::microseconds(1000 + 10 * (random() % 2000)));
            if (random() % 900 == 0) {
                samples.now += 5s; // by silence
            }
            if (random() % 900 == 0) {
                samples.axis.markGap(); // the link was lost, however short
            }
        }
        const TimeSeries& series = samples.series;
        for (int round = 0; round < 300; ++round) {
            std::size_t begin = random() % series.size();
            std::size_t end = random() % series.size();
            if (round % 5 == 0) {
                begin = begin / kChunkSize * kChunkSize; // a chunk's border
            }
            if (round % 7 == 0) {
                end = series.size();
            }
            if (begin >= end) {
                continue;
            }
            const Instant to = end == series.size() ? samples.now : series.time(end);
            const auto found = measure(series, kAmperes, series.time(begin), to);
            const Measurement expected = plainly(series, kAmperes, begin, end);
            QVERIFY(found.has_value() == (expected.samples > 0));
            if (!found) {
                continue;
            }
            QCOMPARE(found->samples, expected.samples);
            QVERIFY(isNear(found->minimum, expected.minimum));
            QVERIFY(isNear(found->maximum, expected.maximum));
            QVERIFY(isNear(found->mean, expected.mean));
            QVERIFY(isNear(found->rms, expected.rms));
            QVERIFY2(isNear(*found->integral, *expected.integral),
                     qPrintable(QStringLiteral("%1 %2: %3, expected %4")
                                    .arg(begin)
                                    .arg(end)
                                    .arg(*found->integral)
                                    .arg(*expected.integral)));
        }
    }
    void sampleAt_takesTheNearer()
    {
        Samples samples;
        for (int i = 0; i < 10; ++i) {
            samples.add(std::uint16_t(i), 100ms);
        }
        QCOMPARE(sampleAt(samples.series, kStart + 340ms), std::optional<std::size_t>(3));
        QCOMPARE(sampleAt(samples.series, kStart + 360ms), std::optional<std::size_t>(4));
        QCOMPARE(sampleAt(samples.series, kStart + 400ms), std::optional<std::size_t>(4));
        QVERIFY(!sampleAt(samples.series, kStart - 1ms));
        QCOMPARE(sampleAt(samples.series, kStart + 1100ms), std::optional<std::size_t>(9));
        QVERIFY(!sampleAt(samples.series, kStart + 1500ms)); // nothing is known that late
    }
    void sampleAt_isNoneInAGap()
    {
        Samples samples(ValueWidth::Word, kInvalid);
        samples.add(1, 100ms);
        samples.add(2, 100ms);
        samples.axis.markGap();
        samples.add(3, 100ms);
        samples.add(kInvalid, 100ms);
        QVERIFY(!sampleAt(samples.series, kStart + 150ms));
        QCOMPARE(sampleAt(samples.series, kStart + 100ms), std::optional<std::size_t>(1));
        QVERIFY(!sampleAt(samples.series, kStart + 290ms)); // the nearer is no value
    }
};

QTEST_GUILESS_MAIN(TestMeasurement)
#include "tst_measurement.moc"
