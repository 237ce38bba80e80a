// SPDX-License-Identifier: GPL-3.0-or-later
// Full polling for hours of virtual time: a real engine on a paced, simulated line, into the store
// and past a recorder. The simulated controller keeps a tally of every reply that it sent; what the
// store holds and what the recorder was given must be the same, byte for byte and stream by stream.
#include "protocol/session/linksampler.h"
#include "protocol/storage/sampletap.h"
#include "protocol/telemetry/streamtable.h"
#include "tests/support/simulatedlink.h"

#include <QFile>
#include <QTest>

using namespace trex;
using namespace std::chrono_literals;
using trex::sim::SentTally;

namespace {

constexpr int kShortMinutes = 4;
constexpr double kMostBytes = 6.0; ///< of the currents: value, time and pyramid
constexpr auto kOrderInterval = 5s;

std::chrono::minutes soakLength()
{
    bool isNumber = false;
    const int minutes = qEnvironmentVariableIntValue("TREX_SOAK_MINUTES", &isNumber);
    return std::chrono::minutes(isNumber ? minutes : kShortMinutes);
}

/// Resident memory of this process, in bytes.
std::size_t residentBytes()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly)) {
        return 0;
    }
    constexpr std::size_t kPage = 4096;
    return file.readAll().split(' ').value(1).toULongLong() * kPage;
}

/// One stream's samples, digested as the simulated controller digests what it sends.
class StreamDigest {
public:
    explicit StreamDigest(const StreamRow& row) : m_row(row) { }
    void add(std::uint16_t stored)
    {
        std::uint16_t raw = stored;
        if (m_row.encoding == StreamEncoding::SignMagnitude) {
            const int speed = stored - kFullSpeed;
            raw = static_cast<std::uint16_t>(speed < 0 ? 0x80 - speed : speed);
        }
        m_low = SentTally::step(m_low, static_cast<std::uint8_t>(raw & 0xFFU));
        m_high = SentTally::step(m_high, static_cast<std::uint8_t>(raw >> 8U));
        ++m_count;
    }
    void compare(const SentTally::Replies& sent) const
    {
        const QByteArray name(m_row.key.data(), qsizetype(m_row.key.size()));
        const std::size_t width = m_row.width == ValueWidth::Word ? 2 : 1;
        const std::size_t place = std::size_t(m_row.field) * width;
        QVERIFY2(m_count == sent.count,
                 name + ": " + QByteArray::number(m_count) + " of "
                     + QByteArray::number(quint64(sent.count)) + " samples");
        QVERIFY2(m_low == sent.digests[place], name + ": other values than were sent");
        QVERIFY2(width == 1 || m_high == sent.digests[place + 1],
                 name + ": other values than were sent");
    }

private:
    const StreamRow& m_row;
    quint64 m_count = 0;
    std::uint64_t m_low = 0;
    std::uint64_t m_high = 0;
};

/// A session: the line, a store that keeps everything, and one with a ceiling past which a recorder
/// takes every sample.
class Session {
public:
    Session() : link(simulator(), LineSettings{})
    {
        for (const StreamRow& row : streams()) {
            m_recorded.emplace_back(row);
        }
        bounded.setMemoryLimit(kCeiling);
        m_tap.startNow();
        m_wanted.fill(true);
        link.onBatch = [this](const LinkBatch& batch) { take(batch); };
        link.open();
        PollWishes wishes{};
        for (const PollRow& row : kPolls) {
            wishes.at(std::size_t(row.id)) = row.hertz;
        }
        link.engine.setWishes(wishes, link.now);
    }
    Q_DISABLE_COPY_MOVE(Session)

    void run(Duration length)
    {
        for (const Instant end = link.now + length; link.now < end;) {
            const int speed = m_orders % 255 - kFullSpeed;
            link.engine.submit({.command = *driveBoth({.amount = speed}, {.amount = -speed / 2}),
                                .priority = Priority::Motor});
            ++m_orders;
            link.run(std::min<Duration>(kOrderInterval, end - link.now));
            record();
        }
        // What is under way arrives, and nothing more is asked.
        link.engine.setWishes({}, link.now);
        link.run(1s);
        record();
    }
    void compareWithSimulator()
    {
        const SentTally& sent = link.line.device().firmware().sent();
        int compared = 0;
        for (std::size_t i = 0; i < streams().size(); ++i) {
            const StreamRow& row = streams()[i];
            if (!row.source.poll()) {
                continue;
            }
            StreamDigest kept(row);
            const TimeSeries& series = store.series(int(i));
            for (std::size_t s = series.first(); s < series.size(); ++s) {
                kept.add(static_cast<std::uint16_t>(series.value(s)));
            }
            const auto& replies = sent.of(pollCommand(*row.source.poll()).opcode);
            QVERIFY(replies.count > 0);
            kept.compare(replies);
            m_recorded[i].compare(replies);
            ++compared;
        }
        QCOMPARE(compared, 14);
    }
    [[nodiscard]] std::size_t samples() const
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i < streams().size(); ++i) {
            count += store.series(int(i)).size();
        }
        return count;
    }
    [[nodiscard]] int orders() const { return m_orders; }

    test::SimulatedLink link;
    TelemetryStore store;
    TelemetryStore bounded;

    static constexpr std::size_t kCeiling = 512U << 10U;

private:
    static sim::SimOptions simulator()
    {
        sim::SimOptions options;
        options.pace = true;
        return options;
    }
    void take(const LinkBatch& batch)
    {
        for (TelemetryStore* each : {&store, &bounded}) {
            for (const PollSample& sample : batch.samples) {
                each->append(sample);
            }
        }
        m_sampler.take(batch, {});
        m_boundedSampler.take(batch, {});
    }
    void record()
    {
        std::array<SampleRun, kSourceCount> runs;
        m_tap.take(m_wanted, 0, std::numeric_limits<std::int32_t>::max(), runs);
        for (const SourceRow& source : kSources) {
            const auto& columns = streamsOf(source.source);
            const SampleRun& run = runs[source.source.index()];
            for (std::size_t i = 0; i < run.values.size(); ++i) {
                m_recorded[std::size_t(columns[i % columns.size()])].add(run.values[i]);
            }
        }
    }

    LinkSampler m_sampler{store};
    LinkSampler m_boundedSampler{bounded};
    SampleTap m_tap{bounded};
    SampleTap::Wanted m_wanted{};
    std::vector<StreamDigest> m_recorded;
    int m_orders = 0;
};

} // namespace

class tst_soak : public QObject {
    Q_OBJECT

public:
    /// A day takes longer than QTest's five minutes for a function.
    static void initMain() { qputenv("QTEST_FUNCTION_TIMEOUT", "3600000"); }

private slots:
    void fullPolling_losesAndDoublesNothing()
    {
        const auto length = soakLength();
        const auto before = residentBytes();
        Session session;
        session.run(length);
        session.compareWithSimulator();

        // The rates that were asked for, all the time.
        const double seconds = std::chrono::duration<double>(length).count();
        const TelemetryStore& store = session.store;
        const double currents = double(store.series("motor1-current").size());
        QVERIFY2(currents > 79.0 * seconds, qPrintable(QString::number(currents / seconds)));
        QCOMPARE(session.link.stats.timeouts + session.link.stats.crcErrors
                     + session.link.stats.badReplies,
                 quint64(0));
        QVERIFY(store.series("motor1-current").axis().gaps().empty());
        // Each order is a step: two samples; between them a heartbeat, and nothing is unknown.
        const TimeSeries& orders = store.series("motor1-command");
        QVERIFY(orders.size() > std::size_t(session.orders()) * 2 - 2);
        QVERIFY(orders.axis().gaps().empty());
        QVERIFY(double(store.series("link-rate").size()) > 0.95 * seconds);

        // Memory: within the bytes a sample, and nothing grows beside it.
        const double bytes = double(store.memoryBytes()) / double(session.samples());
        const auto grown = double(residentBytes() - before);
        qInfo("%lld minutes, %zu samples, %.2f bytes a sample, %.1f MiB resident more",
              static_cast<long long>(length.count()), session.samples(), bytes, grown / 1048576.0);
        QVERIFY(session.bounded.memoryBytes() <= Session::kCeiling);
        QVERIFY(session.bounded.hasDropped());
        if (length >= 30min) { // before, the first chunk of each stream counts more
            QVERIFY2(bytes <= kMostBytes, qPrintable(QString::number(bytes)));
            constexpr double kRest = 48.0 * 1048576.0;
            QVERIFY(grown < double(store.memoryBytes()) * 1.1 + kRest);
        }
    }
};

QTEST_GUILESS_MAIN(tst_soak)
#include "tst_soak.moc"
