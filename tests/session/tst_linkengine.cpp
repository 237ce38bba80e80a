// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/crc7.h"
#include "protocol/codec/lineprobe.h"
#include "protocol/codec/packet.h"
#include "tests/support/virtualline.h"

#include <QTest>

using namespace trex;
using namespace trex::test;
using namespace std::chrono_literals;

namespace {

/// A controller in a few lines, from the documents: enough for the rules of the line.
QByteArray trexAnswers(const QByteArray& packet)
{
    switch (static_cast<std::uint8_t>(packet.front())) {
    case 0x81:
        return "TReXJr1.2";
    case 0x82:
        return "r";
    case 0x83:
        return QByteArray(1, '\x01');
    case 0x84:
    case 0x85:
    case 0x95:
        return QByteArray(1, '\0');
    case 0x86:
        return QByteArray::fromHex("a60ea60ea60ea60ea60e");
    case 0x87:
        return QByteArray(5, '\0');
    case 0x8F:
        return QByteArray::fromHex("3716");
    case 0x9F:
        return QByteArray(1, packet[1]);
    case 0xAF:
        return QByteArray(1, '\0');
    default:
        return {};
    }
}

Transaction user(quint64 id, const Command& command)
{
    return {.id = id, .command = command};
}

Transaction motor(quint64 id, const Command& command)
{
    return {.id = id, .command = command, .priority = Priority::Motor};
}

QByteArray withCrc(const QByteArray& reply, bool hasCrc)
{
    return hasCrc && !reply.isEmpty() ? reply + char(crc7(reply, kDefaultPolynomial)) : reply;
}

VirtualLine connectedLine(const LineSettings& settings = {})
{
    VirtualLine line(settings);
    line.peer = [hasCrc = settings.hasCrc()](const QByteArray& packet) {
        return withCrc(trexAnswers(packet), hasCrc);
    };
    line.open();
    line.run(200ms);
    return line;
}

PollWishes currentsAt(double hertz)
{
    PollWishes wishes{};
    wishes.at(static_cast<std::size_t>(PollId::Currents)) = hertz;
    return wishes;
}

} // namespace

class TestLinkEngine : public QObject {
    Q_OBJECT

private slots:
    void open_asksForTheSignatureWhereSomebodyAnswers()
    {
        const VirtualLine line = connectedLine();
        QCOMPARE(line.sentPackets().mid(0, 2),
                 (QByteArrayList{QByteArray::fromHex("82"), QByteArray::fromHex("81")}));
        QCOMPARE(line.engine.state(), LinkState::Connected);
        const auto identified =
            std::find_if(line.events.begin(), line.events.end(),
                         [](const LinkEvent& e) { return e.kind == LinkEvent::Kind::Identified; });
        QVERIFY(identified != line.events.end());
        QCOMPARE(identified->signature->text(), QStringLiteral("TReXJr1.2"));
    }

    void replyDue_nothingIsSent() // C-10
    {
        VirtualLine line = connectedLine();
        line.sent.clear();
        line.peer = [](const QByteArray&) { return QByteArray(); };
        line.engine.submit(user(1, query("get-mode")));
        line.engine.submit(user(2, query("get-mode")));
        line.engine.submit(motor(3, *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 10})));
        line.run(1ms); // the motor order goes first and needs no reply; then one query
        line.run(60ms);
        QCOMPARE(line.sentPackets(),
                 (QByteArrayList{QByteArray::fromHex("c20a"), QByteArray::fromHex("82")}));
        QVERIFY(line.engine.isReplyDue());
    }

    void noReply_isGivenUpAfterItsTimeAndTheTimeout() // C-10
    {
        VirtualLine line = connectedLine();
        line.peer = [](const QByteArray&) { return QByteArray(); };
        line.records.clear();
        const Instant asked = line.now;
        line.engine.submit(user(1, query("get-mode")));
        line.run(150ms);
        QVERIFY(!line.records.empty());
        const TransactionRecord& first = line.records.front();
        QCOMPARE(*first.error, ErrorCode::NoReply);
        const Duration wire = line.line.timeOf(2);
        QVERIFY(first.ended - asked >= wire + 100ms);
        QVERIFY(first.ended - asked <= wire + 101ms);
    }

    void priorities_stopThenMotorThenUserThenPoll()
    {
        VirtualLine line = connectedLine();
        line.engine.setWishes(currentsAt(80), line.now);
        line.sent.clear();
        line.engine.submit(user(1, query("get-mode")));
        line.engine.submit(motor(2, *driveMotor(MotorId::Aux, {MotorOrder::Action::Set, 5})));
        line.run(100ms);
        QCOMPARE(line.sentPackets().mid(0, 3),
                 (QByteArrayList{QByteArray::fromHex("f005"), QByteArray::fromHex("82"),
                                 QByteArray::fromHex("8f")}));
        line.sent.clear();
        line.engine.submit(motor(3, *driveMotor(MotorId::Aux, {MotorOrder::Action::Set, 6})));
        line.engine.stop(stopPackets(), line.now);
        line.run(50ms);
        QCOMPARE(line.sentPackets().mid(0, 2),
                 (QByteArrayList{QByteArray::fromHex("da0000"), QByteArray::fromHex("f000")}));
        QVERIFY2(!line.sentPackets().contains(QByteArray::fromHex("f006")),
                 "stop throws queued orders away");
    }

    void motorOrders_latestWins()
    {
        VirtualLine line = connectedLine();
        line.sent.clear();
        for (int speed = 1; speed <= 20; ++speed) {
            line.engine.submit(
                motor(static_cast<quint64>(speed),
                      *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, speed})));
        }
        line.engine.submit(motor(30, *driveMotor(MotorId::Motor2, {MotorOrder::Action::Set, 7})));
        line.run(50ms);
        QCOMPARE(line.sentPackets(),
                 (QByteArrayList{QByteArray::fromHex("c214"), QByteArray::fromHex("ca07")}));
        const MotorOrder zero{MotorOrder::Action::Set, 0};
        line.sent.clear();
        line.engine.submit(motor(40, *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 9})));
        line.engine.submit(motor(41, *driveBoth(zero, zero)));
        line.run(50ms);
        QCOMPARE(line.sentPackets(), QByteArrayList{QByteArray::fromHex("da0000")});
    }

    void lostReply_queryIsAskedAgain_writeIsNot()
    {
        VirtualLine line = connectedLine();
        int dropped = 0;
        line.peer = [&](const QByteArray& packet) {
            const auto opcode = static_cast<std::uint8_t>(packet.front());
            if ((opcode == 0x9F || opcode == 0xAF) && dropped < 2) {
                ++dropped;
                return QByteArray();
            }
            return trexAnswers(packet);
        };
        line.sent.clear();
        line.engine.submit(user(1, readParameter(5)));
        line.run(1s);
        QCOMPARE(line.outcomes.back().id, 1U);
        QVERIFY(line.outcomes.back().reply.has_value());
        QCOMPARE(line.sentPackets().count(QByteArray::fromHex("9f05")), 3);
        dropped = 0;
        line.sent.clear();
        line.engine.submit(user(2, writeParameter(7, 5)));
        line.run(1s);
        QVERIFY(!line.outcomes.back().reply.has_value());
        QCOMPARE(line.sentPackets().count(QByteArray::fromHex("af0705552a")), 1);
    }

    void doubtfulWrite_isFollowedByStop_data()
    {
        QTest::addColumn<QByteArray>("answer");
        QTest::addColumn<bool>("hasCrc");
        QTest::addColumn<bool>("stops");
        QTest::newRow("done") << QByteArray(1, '\0') << false << false;
        QTest::newRow("not in serial mode") << QByteArray(1, '\3') << false << false;
        QTest::newRow("bad value") << QByteArray(1, '\2') << false << true;
        QTest::newRow("no such answer") << QByteArray("x") << false << true;
        QTest::newRow("silence") << QByteArray() << false << true;
        QTest::newRow("two bytes") << QByteArray(2, '\0') << false << true;
        QTest::newRow("silence, CRC-7") << QByteArray() << true << false;
    }
    void doubtfulWrite_isFollowedByStop()
    {
        QFETCH(QByteArray, answer);
        QFETCH(bool, hasCrc);
        QFETCH(bool, stops);
        LineSettings settings;
        settings.errorDetection = hasCrc ? ErrorDetection::Crc7 : ErrorDetection::None;
        VirtualLine line = connectedLine(settings);
        line.peer = [&](const QByteArray& packet) {
            return packet.startsWith('\xAF') ? answer : withCrc(trexAnswers(packet), hasCrc);
        };
        line.sent.clear();
        line.engine.submit(user(1, writeParameter(7, 5)));
        line.engine.submit(user(2, query("get-uart-errors")));
        line.run(300ms);
        const qsizetype at = line.sentPackets().indexOf(QByteArray::fromHex("da0000"));
        QCOMPARE(at >= 0, stops);
        if (stops) { // before anything else that waits
            QCOMPARE(at, 1);
            QCOMPARE(line.sentPackets()[at + 1], QByteArray::fromHex("f000"));
        }
    }

    void lateReply_isNeverTakenForTheNext_data()
    {
        QTest::addColumn<int>("delay");
        for (int delay = 95; delay <= 340; delay += 5) {
            QTest::addRow("%d ms", delay) << delay;
        }
    }
    void lateReply_isNeverTakenForTheNext()
    {
        // Each 0x9F answers its own number, about or after the time-out of 100 ms. Whatever is
        // reported must be the right one.
        QFETCH(int, delay);
        VirtualLine line = connectedLine();
        line.replyDelay = std::chrono::milliseconds(delay);
        for (quint64 id = 1; id <= 20; ++id) {
            line.engine.submit(user(id, readParameter(static_cast<std::uint8_t>(id))));
        }
        line.run(30s);
        for (const Outcome& outcome : line.outcomes) {
            if (outcome.reply) {
                QCOMPARE(quint64(static_cast<std::uint8_t>(outcome.reply->payload[0])), outcome.id);
            }
        }
        QCOMPARE(line.stats.surplusBytes > 0, delay > 100);
    }

    void surplusBytes_spoilTheReply()
    {
        VirtualLine line = connectedLine();
        bool spoil = true;
        line.peer = [&](const QByteArray& packet) {
            if (static_cast<std::uint8_t>(packet.front()) == 0x8F && std::exchange(spoil, false)) {
                return QByteArray::fromHex("373716"); // the first byte twice
            }
            return trexAnswers(packet);
        };
        line.engine.submit(user(1, query("get-currents")));
        line.run(1s);
        QVERIFY(line.outcomes.back().reply.has_value());
        QCOMPARE(line.outcomes.back().reply->payload, QByteArray::fromHex("3716"));
        QCOMPARE(line.stats.badReplies, 1U);
    }

    void wrongCrc_isCountedAndAskedAgain() // C-16
    {
        LineSettings settings;
        settings.errorDetection = ErrorDetection::Crc7;
        VirtualLine line(settings);
        bool corrupt = true;
        line.peer = [&](const QByteArray& packet) {
            QByteArray reply = trexAnswers(packet);
            const std::uint8_t crc = crc7(reply, 0x89);
            const bool spoil =
                static_cast<std::uint8_t>(packet.front()) == 0x8F && std::exchange(corrupt, false);
            return reply + static_cast<char>(spoil ? crc ^ 1U : crc);
        };
        line.open();
        line.run(200ms);
        line.engine.submit(user(1, query("get-currents")));
        line.run(1s);
        QCOMPARE(line.stats.crcErrors, 1U);
        QVERIFY(line.outcomes.back().reply.has_value());
    }

    void echo_isFoundAndDropped_data()
    {
        QTest::addColumn<bool>("echoes");
        QTest::newRow("RS-232") << true;
        QTest::newRow("TTL") << false;
    }
    void echo_isFoundAndDropped() // C-12
    {
        QFETCH(bool, echoes);
        VirtualLine line({}, false);
        line.peer = [echoes](const QByteArray& packet) {
            return echoes ? packet + trexAnswers(packet) : trexAnswers(packet);
        };
        line.open();
        line.run(10ms);
        line.engine.submit(motor(1, *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 3})));
        line.engine.submit(user(2, query("get-serial-control")));
        line.engine.submit(user(3, query("get-currents")));
        line.run(1s);
        QCOMPARE(line.stats.echo, echoes);
        QCOMPARE(line.stats.timeouts, 0U);
        QCOMPARE(line.stats.bytesReceived, 3U); // echo left out
        QCOMPARE(line.outcomes.back().reply->payload, QByteArray::fromHex("3716"));
        QVERIFY2(!line.sentPackets().contains(QByteArray::fromHex("ff")),
                 "the null command is never sent");
    }

    void echoOnly_isTold()
    {
        VirtualLine line;
        line.peer = [](const QByteArray& packet) { return packet; };
        line.open();
        line.run(2s);
        QVERIFY(line.engine.state() != LinkState::Connected);
        const auto told =
            std::any_of(line.events.begin(), line.events.end(), [](const LinkEvent& e) {
                return e.error && e.error->code == ErrorCode::EchoOnly;
            });
        QVERIFY(told);
    }

    void silence_isNoticedWithinASecond_andTheLinkComesBack()
    {
        VirtualLine line = connectedLine();
        line.engine.setWishes(currentsAt(80), line.now);
        line.run(1s);
        line.peer = [](const QByteArray&) { return QByteArray(); };
        const Instant silent = line.now;
        line.events.clear();
        line.run(3s);
        QVERIFY(!line.events.empty());
        QCOMPARE(line.events.front().state, LinkState::Lost);
        QVERIFY(line.events.front().time - silent < 1s);
        line.peer = trexAnswers;
        line.samples.clear();
        line.run(2s);
        QCOMPARE(line.engine.state(), LinkState::Connected);
        QVERIFY(line.samples.size() > 20);
    }

    void lostWhileMotorsRun_stopIsTheFirstThingARegainedLineHears()
    {
        VirtualLine line = connectedLine();
        line.engine.setWishes(currentsAt(80), line.now);
        line.engine.submit(motor(1, *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 64})));
        line.run(500ms);
        line.engine.lineFailed({ErrorCode::LineLost, {}}, line.now);
        line.run(2s);
        line.sent.clear();
        line.open();
        line.run(300ms);
        QCOMPARE(line.sentPackets().mid(0, 2),
                 (QByteArrayList{QByteArray::fromHex("da0000"), QByteArray::fromHex("f000")}));
        QVERIFY(!line.sentPackets().contains(QByteArray::fromHex("c240")));
        QCOMPARE(line.engine.state(), LinkState::Connected);
    }

    void lostWithoutMotion_noMotorCommandIsSent()
    {
        VirtualLine line = connectedLine();
        line.engine.setWishes(currentsAt(80), line.now);
        line.run(500ms);
        line.peer = [](const QByteArray&) { return QByteArray(); };
        line.run(3s);
        for (const QByteArray& packet : line.sentPackets()) {
            QVERIFY2(static_cast<std::uint8_t>(packet.front()) < 0xC0, packet.toHex());
        }
    }

    void lostReplyOfLatchedBits_isTold()
    {
        VirtualLine line = connectedLine();
        bool drop = true;
        line.peer = [&](const QByteArray& packet) {
            return static_cast<std::uint8_t>(packet.front()) == 0x84 && std::exchange(drop, false)
                ? QByteArray()
                : trexAnswers(packet);
        };
        line.engine.submit(user(1, query("get-status")));
        line.run(1s);
        QCOMPARE(line.stats.lostLatchReads, 1U);
        QVERIFY(line.outcomes.back().reply.has_value());
    }

    void implausibleReply_isNoValue_data()
    {
        QTest::addColumn<QByteArray>("query");
        QTest::addColumn<QByteArray>("reply");
        QTest::newRow("mode") << QByteArray::fromHex("82") << QByteArray("x");
        QTest::newRow("control") << QByteArray::fromHex("83") << QByteArray("\x02");
        QTest::newRow("status") << QByteArray::fromHex("84") << QByteArray("\x02");
        QTest::newRow("raw") << QByteArray::fromHex("861f")
                             << QByteArray::fromHex("a60ea60ea60ea60ea6fe");
    }
    void implausibleReply_isNoValue()
    {
        QFETCH(QByteArray, query);
        QFETCH(QByteArray, reply);
        const auto packet = decodePacket(query, {});
        QVERIFY(packet.has_value());
        QVERIFY(!isPlausible(packet->command, reply));
        QVERIFY(isPlausible(packet->command, trexAnswers(query)));
    }

    void stop_whileTheLineIsGivenUp_leavesAllTheSame()
    {
        VirtualLine line({}, true, false); // silent, and not to be tried again
        line.open();
        line.run(550ms); // the third question is out
        QCOMPARE(line.engine.state(), LinkState::Connecting);
        line.sent.clear();
        line.engine.stop(stopPackets(), line.now);
        line.run(300ms);
        QCOMPARE(line.engine.state(), LinkState::Disconnected);
        QCOMPARE(line.sentPackets().mid(0, 2),
                 (QByteArrayList{QByteArray::fromHex("da0000"), QByteArray::fromHex("f000")}));
        QCOMPARE(line.outcomes.size(), std::size_t{2});
        QVERIFY(line.outcomes[0].reply && line.outcomes[1].reply);
        line.engine.stop(stopPackets(), line.now); // now there is nobody
        line.run(300ms);
        QCOMPARE(line.outcomes.size(), std::size_t{4});
        QCOMPARE(line.outcomes[3].reply.error().code, ErrorCode::NotConnected);
    }

    void reply_isNotWhatCameBeforeItsQuestion()
    {
        for (const bool isEcho : {true, false}) {
            VirtualLine line({}, false);
            line.open();
            line.engine.submit(
                motor(1, *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 64})));
            line.run(5ms);
            // Two bytes that may be the echo of the order, before currents (two bytes) are asked.
            line.engine.received(QByteArray::fromHex("c240"), line.now);
            line.engine.submit(user(2, query("get-currents")));
            line.run(5ms);
            if (!isEcho) {
                line.engine.received(QByteArray::fromHex("9f"), line.now); // nor is that the rest
            }
            line.run(90ms);
            QVERIFY(line.samples.empty());
            QVERIFY(std::ranges::none_of(line.outcomes, [](const Outcome& each) {
                return each.id == 2 && each.reply.has_value();
            }));
        }
    }

    void probe_damagedAnswerIsNoStatus()
    {
        LineSettings settings{.errorDetection = ErrorDetection::Crc7,
                              .form = PacketForm::Pololu,
                              .echo = EchoMode::Off};
        for (int polynomial = 0x80; polynomial < 0x100; ++polynomial) {
            settings.polynomial = static_cast<std::uint8_t>(polynomial);
            if (lineProbe(settings).query == query("get-status")) {
                break;
            }
        }
        QVERIFY(lineProbe(settings).query == query("get-status"));
        for (const bool isDamaged : {false, true}) {
            VirtualLine line(settings);
            line.peer = [&](const QByteArray&) {
                QByteArray reply(1, '\x20');
                return reply + char(crc7(reply, settings.polynomial) ^ (isDamaged ? 1 : 0));
            };
            line.open();
            line.run(50ms);
            QCOMPARE(line.samples.size(), std::size_t{isDamaged ? 0U : 1U});
            QVERIFY(line.sent.size() > 1); // somebody is there, either way
        }
    }

    void shutDown_sendsNothingButStop()
    {
        VirtualLine line = connectedLine();
        line.engine.setWishes(currentsAt(80), line.now);
        line.engine.submit(user(1, query("get-mode")));
        line.sent.clear();
        line.engine.shutDown();
        line.engine.stop(stopPackets(), line.now);
        line.run(1s);
        QCOMPARE(line.sentPackets(),
                 (QByteArrayList{QByteArray::fromHex("da0000"), QByteArray::fromHex("f000")}));
    }
};

QTEST_APPLESS_MAIN(TestLinkEngine)
#include "tst_linkengine.moc"
