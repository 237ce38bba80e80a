// SPDX-License-Identifier: GPL-3.0-or-later
// What LinkEngine counts about the line: the histogram's arithmetic, the meter's slices, and the
// figures against a simulated line whose faults and times are known.
#include "protocol/session/linkhealth.h"
#include "tests/support/simulatedlink.h"
#include "tests/support/virtualline.h"

#include <QTest>

#include <algorithm>

using namespace trex;
using namespace std::chrono_literals;

namespace {

constexpr Instant kStart{std::chrono::hours(1)};

/// A simulated line on virtual time, and the latest health that crossed.
struct Bench {
    explicit Bench(const sim::SimOptions& options, const LineSettings& settings = {})
        : link(options, settings)
    {
        link.onBatch = [this](const LinkBatch& batch) {
            if (!batch.health.empty()) {
                health = batch.health.back();
                ++told;
            }
        };
        PollWishes wishes{};
        for (const PollRow& row : kPolls) {
            wishes.at(static_cast<std::size_t>(row.id)) = row.hertz;
        }
        link.engine.setWishes(wishes, link.now);
        link.open();
    }
    test::SimulatedLink link;
    LinkHealth health;
    int told = 0;
};

sim::SimOptions paced()
{
    sim::SimOptions options;
    options.pace = true;
    return options;
}

} // namespace

class TestLinkHealth : public QObject {
    Q_OBJECT

private slots:
    void histogram_edgesEncloseTheirBin()
    {
        for (const Duration duration :
             {Duration(64us), Duration(65us), Duration(127us), Duration(128us), Duration(999us),
              Duration(1ms), Duration(2600us), Duration(16ms), Duration(1s)}) {
            const int bin = LatencyHistogram::binOf(duration);
            QVERIFY2(LatencyHistogram::edge(bin) <= duration, qPrintable(QString::number(bin)));
            QVERIFY2(duration < LatencyHistogram::edge(bin + 1), qPrintable(QString::number(bin)));
        }
        for (int bin = 0; bin < LatencyHistogram::kBins; ++bin) { // no gap, no overlap
            QCOMPARE(LatencyHistogram::binOf(LatencyHistogram::edge(bin)), bin);
            QCOMPARE(LatencyHistogram::binOf(LatencyHistogram::edge(bin + 1) - 1us), bin);
        }
        QCOMPARE(LatencyHistogram::binOf(0us), 0);
        QCOMPARE(LatencyHistogram::binOf(-1ms), 0);
        QCOMPARE(LatencyHistogram::binOf(1h), LatencyHistogram::kBins - 1);
    }

    void histogram_quantilesAreWithinABin()
    {
        LatencyHistogram histogram;
        QVERIFY(!histogram.quantile(0.5));
        std::vector<Duration> all;
        std::uint32_t seed = 7;
        for (int i = 0; i < 10'000; ++i) {
            seed = seed * 1664525U + 1013904223U;
            all.emplace_back(1ms + std::chrono::microseconds(seed % 30'000U));
            histogram.add(all.back());
        }
        std::sort(all.begin(), all.end());
        for (const double part : {0.01, 0.5, 0.9, 0.99}) {
            const auto truth = static_cast<double>(
                all.at(static_cast<std::size_t>(part * static_cast<double>(all.size()))).count());
            const auto found = static_cast<double>(histogram.quantile(part)->count());
            QVERIFY2(std::abs(found - truth) <= truth * 0.03, qPrintable(QString::number(part)));
        }
        QCOMPARE(histogram.longest(), all.back());
        QCOMPARE(histogram.shortest(), all.front());
        QCOMPARE(*histogram.quantile(1.0), all.back());
        QCOMPARE(histogram.total(), quint64{10'000});
    }

    void histogram_beyondItsEndsStaysExact()
    {
        LatencyHistogram histogram;
        histogram.add(10us);
        histogram.add(20s);
        QCOMPARE(histogram.shortest(), Duration(10us));
        QCOMPARE(histogram.longest(), Duration(20s));
        QCOMPARE(*histogram.quantile(1.0), Duration(20s));
        LatencyHistogram sum;
        sum += histogram;
        sum += LatencyHistogram{};
        QCOMPARE(sum.total(), quint64{2});
        QCOMPARE(sum.shortest(), Duration(10us));
        QCOMPARE(sum.mean(), Duration(10us + 20s) / 2);
    }

    void meter_recentForgetsAndTotalDoesNot()
    {
        LinkHealthMeter meter;
        meter.opened(kStart, {});
        for (int second = 0; second < 30; ++second) {
            meter.at(kStart + second * 1s).addFailure(ErrorCode::BadReplyCrc);
        }
        QCOMPARE(meter.take(kStart + 31s)->recent.crcErrors, quint64{30});
        for (int second = 31; second < 95; ++second) {
            meter.at(kStart + second * 1s).addFailure(ErrorCode::NoReply);
        }
        const auto health = meter.take(kStart + 95s);
        QVERIFY(health.has_value());
        QCOMPARE(health->recent.crcErrors, quint64{0});
        QVERIFY(health->recent.timeouts >= 30 && health->recent.timeouts <= 64);
        QCOMPARE(health->total.crcErrors, quint64{30});
        QCOMPARE(health->total.timeouts, quint64{64});
        QCOMPARE(health->total.covered, Duration(95s));
        // Nothing for long: the past minute was empty.
        const auto later = meter.take(kStart + 400s);
        QCOMPARE(later->recent.timeouts, quint64{0});
        QCOMPARE(later->total.timeouts, quint64{64});
    }

    void meter_tellsFourTimesASecondAndCountsOpenTimeOnly()
    {
        LinkHealthMeter meter;
        meter.opened(kStart, {.kind = AdapterFacts::Kind::Network});
        int told = 0;
        for (int ms = 0; ms < 10'000; ms += 5) {
            told += meter.take(kStart + ms * 1ms).has_value() ? 1 : 0;
        }
        QCOMPARE(told, 40);
        meter.closed(kStart + 10s);
        const auto closed = meter.take(kStart + 60s);
        QCOMPARE(closed->total.covered, Duration(10s));
        QCOMPARE(closed->adapter.kind, AdapterFacts::Kind::Network);
        meter.reset(kStart + 60s);
        const auto reset = meter.take(kStart + 60s); // at once: somebody waits to see it
        QVERIFY(reset.has_value());
        QCOMPARE(reset->total.covered, Duration(0));
        QCOMPARE(reset->adapter.kind, AdapterFacts::Kind::Network);
    }

    void healthyLine_countsWhatTheWireCarries()
    {
        Bench bench(paced());
        bench.link.run(20s);
        const HealthCounts& counts = bench.health.total;
        QCOMPARE(bench.link.stats.timeouts, quint64{0});
        QVERIFY(counts.replies > 4000);
        QCOMPARE(counts.damaged() + counts.timeouts + counts.unaskedBytes + counts.lateBytes,
                 quint64{0});
        QCOMPARE(counts.trips.total(), counts.ideal.total());
        QVERIFY(counts.replies - counts.trips.total() <= 2); // the signature's and the first one's
        // 19200 baud, one start and one stop bit: a byte takes 520.8 µs. Every transaction but the
        // first took exactly two to twelve bytes, and no reply came sooner than that.
        QVERIFY(counts.ideal.shortest() >= Duration(1041us));
        QVERIFY(counts.ideal.longest() <= Duration(6251us));
        QVERIFY(counts.trips.shortest() >= counts.ideal.shortest());
        QVERIFY(*counts.trips.quantile(0.5) < *counts.ideal.quantile(0.5) + 1ms);
        // All panels' polls: 80 × 3, 50 × 12, 50 × 7, 20 × 2 and 8 × 2 bytes a second, of 1,920.
        constexpr double kBytes = 80 * 3 + 50 * 12 + 50 * 7 + 20 * 2 + 8 * 2;
        const double got = bench.health.recent.bytesPerSecond();
        QVERIFY2(std::abs(got - kBytes) < 0.03 * kBytes, qPrintable(QString::number(got)));
        const double share = bench.health.recent.wireShare();
        QVERIFY2(std::abs(share - kBytes / 1920) < 0.02, qPrintable(QString::number(share)));
    }

    void tellsAtMostFourTimesASecond()
    {
        Bench bench(paced());
        bench.link.run(10s);
        QVERIFY(bench.told >= 38 && bench.told <= 42);
    }

    void delayedReplies_showInTheDifference()
    {
        sim::SimOptions options = paced();
        options.faults.delayMs = 12.0;
        Bench bench(options);
        bench.link.run(10s);
        const HealthCounts& counts = bench.health.recent;
        QVERIFY(counts.replies > 100);
        QVERIFY(counts.extra.shortest() >= Duration(12ms));
        QVERIFY(*counts.extra.quantile(0.5) < Duration(14ms));
    }

    void faults_areCountedByKind_data()
    {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<bool>("crc");
        QTest::newRow("corrupt, CRC") << QStringLiteral("corrupt=0.02") << true;
        QTest::newRow("drop") << QStringLiteral("drop=0.02") << false;
        QTest::newRow("drop, CRC") << QStringLiteral("drop=0.02") << true;
        QTest::newRow("garbage") << QStringLiteral("garbage=3") << false;
    }
    void faults_areCountedByKind()
    {
        QFETCH(QString, fault);
        QFETCH(bool, crc);
        sim::SimOptions options = paced();
        LineSettings line;
        line.errorDetection = options.errorDetection =
            crc ? ErrorDetection::Crc7 : ErrorDetection::None;
        QVERIFY(options.applyFault(fault).has_value());
        Bench bench(options, line);
        bench.link.run(20s);
        const HealthCounts& counts = bench.health.total;
        const LinkStats& stats = bench.link.stats;
        QVERIFY(counts.damaged() + counts.timeouts > 20);
        if (fault.startsWith(QLatin1StringView("corrupt"))) {
            QVERIFY(counts.crcErrors > 50);
        } else if (fault.startsWith(QLatin1StringView("drop"))) {
            QVERIFY(counts.shortReplies > 20); // of the longer replies
            QVERIFY(crc || counts.timeouts > 10); // of those of one byte
        } else {
            QVERIFY(counts.badReplies > 50);
        }
        // The same events as LinkStats counts, told apart further; those while there is no
        // connection stand there alone.
        QVERIFY(counts.crcErrors <= stats.crcErrors);
        QVERIFY(counts.badReplies <= stats.badReplies);
        QVERIFY(counts.timeouts + counts.shortReplies <= stats.timeouts);
        QVERIFY(counts.answersDue() <= stats.transactions);
        QVERIFY(counts.retries <= stats.retries);
        QVERIFY(counts.retries > 0);
    }

    void uartBits_areCountedPerRead() // C-21
    {
        Bench bench(paced());
        bench.link.run(2s);
        for (int i = 0; i < 5; ++i) {
            bench.link.engine.submit({.priority = Priority::User,
                                      .rawBytes = QByteArray::fromHex("b5")}); // no such command
            bench.link.run(1s);
        }
        QCOMPARE(bench.health.total.uart.at(6), quint32{5}); // format
        QCOMPARE(bench.health.total.uart.at(7), quint32{0}); // timeout
    }

    void secondMaster_isTrafficNobodyAskedFor()
    {
        // Somebody else's questions and their answers, in the pauses of a line that is asked five
        // times a second.
        test::VirtualLine line;
        line.peer = [](const QByteArray& packet) {
            return packet == QByteArray("\x81") ? QByteArray("TReXJr1.2") : QByteArray("r");
        };
        PollWishes wishes{};
        wishes.at(static_cast<std::size_t>(PollId::Mode)) = 5.0;
        line.engine.setWishes(wishes, line.now);
        line.open();
        line.run(3s);
        QCOMPARE(line.engine.state(), LinkState::Connected);
        const quint64 before = line.health.total.unaskedBursts;
        QCOMPARE(before, quint64{0});
        for (int i = 0; i < 8; ++i) {
            line.run(930ms);
            line.incoming.push_back({line.now, QByteArray("\x12\x34")});
            line.run(30ms);
        }
        QVERIFY2(line.health.total.unaskedBursts >= 6,
                 qPrintable(QString::number(line.health.total.unaskedBursts)));
        QCOMPARE(line.health.total.unaskedBytes, 2 * line.health.total.unaskedBursts);
        QCOMPARE(line.health.total.timeouts, quint64{0});
    }

    void losses_areCountedAndReset()
    {
        sim::SimOptions options = paced();
        options.faults.hangupAfter = 2.0;
        options.faults.hangupFor = 1.0;
        Bench bench(options);
        bench.link.run(8s);
        QCOMPARE(bench.link.engine.state(), LinkState::Connected);
        QCOMPARE(bench.health.total.losses, quint64{1});
        QCOMPARE(bench.health.total.timeouts, quint64{0}); // looking for it is no fault of the line
        bench.link.engine.resetHealth(bench.link.now);
        bench.link.run(300ms);
        QCOMPARE(bench.health.total.losses, quint64{0});
        QVERIFY(bench.health.total.covered <= Duration(301ms));
        QVERIFY(bench.link.stats.transactions > bench.health.total.transactions);
    }
};

QTEST_GUILESS_MAIN(TestLinkHealth)
#include "tst_linkhealth.moc"
