// SPDX-License-Identifier: GPL-3.0-or-later
// Stop latency as the law of the line has it, on virtual time: from the request to the moment when
// the last stop byte has been handed to the line. What the program's own threads add is measured by
// `./dev bench stop`.
#include "protocol/codec/lineprobe.h"
#include "protocol/codec/packet.h"
#include "tests/support/simulatedlink.h"

#include <QTest>

#include <algorithm>
#include <cstdio>

using namespace trex;
using namespace std::chrono_literals;

namespace {

constexpr int kStops = 400;
constexpr auto kProgram = 2ms; ///< not used up here: there are no threads
constexpr int kRequestBytes = 2; // of the longest poll
constexpr int kReplyBytes = 10;

enum class Load { Idle, Polling, Drops, SentDrops, Silence };

double milliseconds(Duration duration)
{
    return std::chrono::duration<double, std::milli>(duration).count();
}

/// The transaction in flight, the stop packets on the wire, 2 ms.
Duration boundOf(const LineSettings& line, Load load)
{
    Duration bound = kProgram;
    for (const Command& command : stopCommands(false)) {
        bound += line.timeOf(static_cast<int>(encode(command, line).size()));
    }
    const int crc = line.hasCrc() ? 2 : 0;
    if (load == Load::Silence) { // lost: the line may be set otherwise, to close open packets
        Duration longest{0};
        for (const WirePiece& piece : lineClearing()) {
            longest = std::max(longest, piece.line.timeOf(static_cast<int>(piece.bytes.size())));
        }
        bound += longest + kWireRest;
    }
    return load == Load::Idle ? bound : bound + line.timeOf(kRequestBytes + kReplyBytes + crc);
}

} // namespace

class TestStopLatency : public QObject {
    Q_OBJECT

private slots:
    void stop_isWithinItsBound_data()
    {
        QTest::addColumn<int>("baud");
        QTest::addColumn<int>("load");
        QTest::addColumn<bool>("crc");
        for (const int baud : {1200, 19200, 115200}) {
            for (const auto& [load, name] :
                 {std::pair{Load::Idle, "idle"}, std::pair{Load::Polling, "full polling"},
                  std::pair{Load::Drops, "full polling, 10 % drops"},
                  std::pair{Load::SentDrops, "full polling, 10 % drops, sent"},
                  std::pair{Load::Silence, "full polling, no replies"}}) {
                for (const bool crc : {false, true}) {
                    QTest::addRow("%d baud, %s%s", baud, name, crc ? ", CRC-7" : "")
                        << baud << static_cast<int>(load) << crc;
                }
            }
        }
    }

    void stop_isWithinItsBound()
    {
        QFETCH(int, baud);
        QFETCH(int, load);
        QFETCH(bool, crc);
        const auto kind = static_cast<Load>(load);
        LineSettings line;
        line.baud = baud;
        sim::SimOptions simulated;
        simulated.baud = baud;
        simulated.pace = true;
        line.errorDetection = simulated.errorDetection =
            crc ? ErrorDetection::Crc7 : ErrorDetection::None;
        test::SimulatedLink link(simulated, line);
        link.open();
        link.run(2s);
        QCOMPARE(link.engine.state(), LinkState::Connected);
        if (kind != Load::Idle) {
            PollWishes wishes{};
            for (const PollRow& row : kPolls) {
                wishes.at(static_cast<std::size_t>(row.id)) = row.hertz;
            }
            link.engine.setWishes(wishes, link.now);
        }
        sim::Faults faults;
        faults.drop = kind == Load::Drops ? 0.1 : 0.0;
        faults.dropSent = kind == Load::SentDrops ? 0.1 : 0.0;
        if (kind == Load::Silence) {
            faults.silentFor = sim::Faults::kNever;
        }
        link.line.setFaults(faults, link.now);
        std::vector<double> latencies;
        sim::Random random(3);
        for (int i = 0; i < kStops; ++i) {
            link.run(Duration(static_cast<qint64>(random.unit() * 3e8)));
            const Instant asked = link.now;
            std::vector<Transaction> packets;
            for (const Command& command : stopCommands(false)) {
                packets.push_back({.id = static_cast<quint64>(2 * i + 1) + packets.size(),
                                   .command = command,
                                   .priority = Priority::Stop});
            }
            const quint64 last = packets.back().id;
            link.engine.stop(packets, asked);
            for (int step = 0; step < 2000 && !link.outcomes.contains(last); ++step) {
                link.run(1ms);
            }
            const auto outcome = link.outcomes.find(last);
            QVERIFY(outcome != link.outcomes.end() && outcome->second.has_value());
            latencies.push_back(milliseconds(outcome->second->sent - asked));
        }
        std::sort(latencies.begin(), latencies.end());
        const double bound = milliseconds(boundOf(line, kind));
        const auto at = [&latencies](double share) {
            return latencies.at(
                static_cast<std::size_t>(share * static_cast<double>(latencies.size() - 1)));
        };
        std::printf("%-38s p50 %7.2f  p99 %7.2f  max %7.2f  bound %7.2f ms\n",
                    QTest::currentDataTag(), at(0.5), at(0.99), at(1.0), bound);
        QVERIFY2(at(0.99) <= bound, qPrintable(QString::number(at(0.99))));
        QVERIFY2(at(1.0) <= bound, qPrintable(QString::number(at(1.0))));
    }
};

QTEST_GUILESS_MAIN(TestStopLatency)
#include "tst_stoplatency.moc"
