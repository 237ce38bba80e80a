// SPDX-License-Identifier: GPL-3.0-or-later
// What the line's law says about stop: past a reply that is overdue, once more in doubt, and what a
// controller makes of stop packets of which it hears only a part.
#include "protocol/codec/crc7.h"
#include "protocol/codec/packet.h"
#include "protocol/sim/packetreader.h"
#include "tests/support/virtualline.h"

#include <QTest>

#include <cstdio>

using namespace trex;
using namespace trex::test;
using namespace std::chrono_literals;

namespace {

const QByteArrayList kStop{QByteArray::fromHex("da0000"), QByteArray::fromHex("f000")};

/// Connected; from then on nobody answers.
VirtualLine silentLine(bool stopsInDoubt = true)
{
    VirtualLine line({}, true, true, stopsInDoubt);
    line.peer = [](const QByteArray& packet) {
        return packet == QByteArray::fromHex("81") ? QByteArray("TReXJr1.2") : QByteArray("r");
    };
    line.open();
    line.run(200ms);
    line.peer = [](const QByteArray&) { return QByteArray(); };
    line.sent.clear();
    line.outcomes.clear();
    return line;
}

/// A stop is asked for after a command's reply has been due for so long.
VirtualLine stoppedAfter(const Command& command, Duration overdue)
{
    VirtualLine line = silentLine();
    line.engine.submit({.id = 1, .command = command});
    line.run(overdue);
    line.sent.clear();
    line.engine.stop(stopPackets(), line.now);
    return line;
}

/// Motor orders that move, in what a controller hears.
int motionsIn(QByteArrayView heard, const LineSettings& line)
{
    sim::PacketReader reader;
    reader.configure(line.hasCrc(), line.polynomial);
    reader.setDevice(line.device);
    int motions = 0;
    for (const char each : heard) {
        if (!reader.feed(static_cast<std::uint8_t>(each)).isComplete || reader.command() < 0xC0) {
            continue;
        }
        const auto speeds = std::size_t(sim::dataBytesOf(reader.command()));
        for (std::size_t i = 0; i < speeds; ++i) {
            motions += reader.data(i) != 0 ? 1 : 0;
        }
    }
    return motions;
}

/// Whatever the controller may have heard the beginning of, before the stop.
std::vector<Command> everyCommand()
{
    std::vector<Command> all{
        channelsQuery("get-raw-channels", 31),
        channelsQuery("get-remapped-channels", 31),
        readParameter(0x13),
        writeParameter(0x13, 99),
        writeCalibration(3, {2500, 3751, 5002, 103}),
        *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 64}),
        *driveMotor(MotorId::Aux, {MotorOrder::Action::Accelerate, 33}),
        *driveBoth({MotorOrder::Action::Set, 64}, {MotorOrder::Action::Set, -17})};
    for (const char* key : {"get-signature", "get-mode", "get-status", "get-currents",
                            "get-calibration", "get-learned"}) {
        all.push_back(query(key));
    }
    return all;
}

} // namespace

class TestEngineStop : public QObject {
    Q_OBJECT

private slots:
    void overdueReply_isNotWaitedFor()
    {
        VirtualLine line = stoppedAfter(query("get-mode"), 20ms);
        const Instant asked = line.now;
        line.run(50ms);
        QCOMPARE(line.sentPackets(), kStop);
        QCOMPARE(line.sent.back().at, asked);
        QCOMPARE(line.outcomes.size(),
                 std::size_t(2)); // the stop's; the query is asked again later
        // Nothing else until the reply cannot come any more; then stop again, then the rest.
        line.run(200ms);
        QCOMPARE(line.sentPackets().mid(0, 5), kStop + kStop + QByteArrayList{"\x82"});
        QVERIFY(line.sent[2].at - asked >= 75ms);
        QVERIFY(line.sent[2].at - asked <= 101ms);
        QCOMPARE(line.outcomes.size(), std::size_t(2)); // nobody is told twice
    }

    void replyInTime_isWaitedFor()
    {
        VirtualLine line = silentLine();
        line.peer = [](const QByteArray&) { return QByteArray("r"); };
        line.engine.submit({.id = 1, .command = query("get-mode")});
        line.run(200us);
        line.sent.clear();
        line.engine.stop(stopPackets(), line.now);
        line.run(100ms);
        QCOMPARE(line.sentPackets(), kStop); // once: nothing is in doubt
        QCOMPARE(line.outcomes.front().id, quint64(1));
        QVERIFY(line.outcomes.front().reply.has_value());
        QCOMPARE(line.stats.resyncs, quint64(0));
    }

    void replyUnderWay_isWaitedForWhileItsBytesCome()
    {
        VirtualLine line = silentLine();
        line.engine.submit({.id = 1, .command = query("get-signature")});
        line.run(6ms); // 1 + 9 bytes
        line.sent.clear();
        for (int i = 0; i < 6; ++i) {
            line.incoming.push_back({line.now + i * line.line.timeOf(1), QByteArray(1, 'T')});
        }
        const Instant last = line.incoming.back().at;
        line.engine.stop(stopPackets(), line.now);
        line.run(50ms);
        QCOMPARE(line.sentPackets().mid(0, 2), kStop);
        QVERIFY(line.sent.front().at > last); // before, the controller had been deaf
        QVERIFY(line.sent.front().at - last < line.line.timeOf(1) + 1ms);
    }

    void lateReply_isNobodysAndStopIsSaidAgainBehindIt()
    {
        VirtualLine line = stoppedAfter(readParameter(0x13), 20ms);
        const Instant late = line.now + 30ms;
        line.incoming.push_back({late, QByteArray(1, '\x55')});
        line.run(60ms);
        QCOMPARE(line.sentPackets(), kStop + kStop);
        QVERIFY(line.sent[2].at >= late + line.line.timeOf(1));
        QVERIFY(line.sent[2].at <= late + 3ms);
        line.peer = [](const QByteArray& packet) {
            return packet == QByteArray::fromHex("82") ? QByteArray("r") : QByteArray(1, '\x13');
        };
        line.run(300ms);
        const auto read = std::ranges::find(line.outcomes, quint64(1), &Outcome::id);
        QVERIFY(read != line.outcomes.end() && read->reply.has_value());
        QCOMPARE(read->reply->payload, QByteArray(1, '\x13'));
        QCOMPARE(line.stats.resyncs, quint64(1)); // before the next answer was believed
    }

    void write_hasTheTimeThatItNeeds()
    {
        VirtualLine line = stoppedAfter(writeCalibration(1, {2500, 3750, 5000, 100}), 50ms);
        const Instant asked = line.now;
        line.run(150ms);
        QCOMPARE(line.sentPackets().mid(0, 2), kStop);
        // 100 ms is the document's limit; the request had 11 bytes, the answer has one.
        const Duration wire = line.line.timeOf(12);
        QVERIFY(line.sent.front().at - asked >= 50ms + wire - 1ms);
        QVERIFY(line.sent.front().at - asked <= 50ms + wire + 1ms);
    }

    void doubtfulLine_hearsStopTwice()
    {
        VirtualLine line = silentLine();
        line.engine.stop(stopPackets(), line.now);
        line.run(300ms);
        QCOMPARE(line.sentPackets(), kStop); // a line without an error
        line.engine.submit({.id = 1, .command = writeParameter(0x13, 1)});
        line.run(1s);
        line.sent.clear();
        line.engine.stop(stopPackets(), line.now);
        line.run(300ms);
        QCOMPARE(line.sentPackets().mid(0, 4), kStop + kStop);
    }

    /// A program that only looks leaves motors as another one has told them.
    void questionThatMayHaveBeenAnOrder_isFollowedByStopWhereMotorsAreInOurCare()
    {
        for (const bool isInOurCare : {true, false}) {
            VirtualLine line = silentLine(isInOurCare);
            line.engine.submit({.id = 1, .command = channelsQuery("get-raw-channels", 0x1F)});
            line.run(120ms); // once without an answer
            line.peer = [](const QByteArray& packet) {
                return packet.startsWith('\x86') ? QByteArray::fromHex("a60ea60ea60ea60ea60e")
                                                 : QByteArray("r");
            };
            line.run(500ms);
            QVERIFY(!line.outcomes.empty() && line.outcomes.front().reply);
            QCOMPARE(line.sentPackets().count(kStop.front()) > 0, isInOurCare);
        }
    }

    void doubtfulWriteWithCrc_isFollowedByStopWhereMotorsAreInOurCare()
    {
        for (const bool isInOurCare : {true, false}) {
            const LineSettings settings{.errorDetection = ErrorDetection::Crc7};
            VirtualLine line(settings, true, true, isInOurCare);
            const auto closed = [&](const QByteArray& reply) {
                return reply + char(crc7(reply, settings.polynomial));
            };
            line.peer = [&](const QByteArray& packet) {
                return packet.startsWith('\x81') ? closed("TReXJr1.2") : closed("r");
            };
            line.open();
            line.run(400ms);
            QCOMPARE(line.engine.state(), LinkState::Connected);
            line.sent.clear();
            line.peer = [](const QByteArray&) { return QByteArray(); };
            line.engine.submit({.id = 1, .command = writeParameter(0x13, 1)});
            line.run(400ms); // without an answer
            const QByteArray stop = encode(stopCommands(false).front(), settings);
            QCOMPARE(line.sentPackets().contains(stop), isInOurCare);
        }
    }

    void orderAfterStop_isNotStoppedByTheRepetition()
    {
        VirtualLine line = stoppedAfter(query("get-mode"), 20ms);
        line.run(5ms);
        line.engine.submit({.id = 7,
                            .command = *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 10}),
                            .priority = Priority::Motor});
        line.run(300ms);
        const QByteArrayList sent = line.sentPackets();
        QCOMPARE(sent.mid(0, 3), kStop + QByteArrayList{QByteArray::fromHex("c20a")});
        QCOMPARE(sent.count(kStop.front()), 1);
    }

    /// A controller is deaf while it sends (C-11): one gap, anywhere in the bytes of a command and
    /// the stop behind it. Is what it hears of them an order that moves?
    void partOfAStop_movesNothing_data()
    {
        QTest::addColumn<PacketForm>("form");
        QTest::addColumn<ErrorDetection>("detection");
        QTest::addColumn<int>("most");
        QTest::newRow("compact") << PacketForm::Compact << ErrorDetection::None << 0;
        QTest::newRow("compact, CRC") << PacketForm::Compact << ErrorDetection::Crc7 << 0;
        // Device number and command of the second packet as the speeds of the first: only where a
        // gap begins in one and ends in the other. The repetition ends it.
        QTest::newRow("pololu") << PacketForm::Pololu << ErrorDetection::None << 59;
        QTest::newRow("pololu, CRC") << PacketForm::Pololu << ErrorDetection::Crc7 << 0;
    }
    void partOfAStop_movesNothing()
    {
        QFETCH(PacketForm, form);
        QFETCH(ErrorDetection, detection);
        QFETCH(int, most);
        LineSettings line;
        line.form = form;
        line.errorDetection = detection;
        QByteArray stop;
        for (const Command& command : stopCommands(false)) {
            stop += encode(command, line);
        }
        int cases = 0;
        int moving = 0;
        for (const Command& command : everyCommand()) {
            const QByteArray before = encode(command, line);
            const QByteArray all = before + stop;
            const int own = motionsIn(before, line); // ordered, and heard as ordered
            for (qsizetype from = 0; from < all.size(); ++from) {
                for (qsizetype to = from; to <= all.size(); ++to) {
                    // The order itself in pieces is not the stop's doing.
                    if (from < before.size() && own > 0) {
                        continue;
                    }
                    ++cases;
                    const QByteArray heard = all.first(from) + all.sliced(to);
                    moving += motionsIn(heard, line) > own ? 1 : 0;
                    // Whole again, behind a gap of any kind: all stands.
                    QCOMPARE(motionsIn(heard + stop, line), motionsIn(heard, line));
                }
            }
        }
        std::printf("%s: %d cases, %d are heard as motion\n", QTest::currentDataTag(), cases,
                    moving);
        QVERIFY(moving <= most);
    }
};

QTEST_APPLESS_MAIN(TestEngineStop)
#include "tst_enginestop.moc"
