// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/crc7.h"
#include "protocol/codec/replyparser.h"

#include <QRandomGenerator>
#include <QTest>

using namespace trex;
using Verdict = ReplyParser::Verdict;

namespace {

LineSettings settingsWith(bool hasCrc)
{
    LineSettings settings;
    settings.errorDetection = hasCrc ? ErrorDetection::Crc7 : ErrorDetection::None;
    return settings;
}

QByteArray withCrc(QByteArray bytes)
{
    return bytes.append(static_cast<char>(crc7(bytes, kDefaultPolynomial)));
}

} // namespace

class TstReplyParser : public QObject {
    Q_OBJECT

private slots:
    void reply_isCompleteWhereverItIsSplit_data();
    void reply_isCompleteWhereverItIsSplit(); // C-13, C-17, C-25, C-70
    void surplus_isLeft_data();
    void surplus_isLeft();
    void wrongCrc_isNeverComplete(); // C-16
    void polynomial_isTheLines(); // C-13
    void noReplyCommands_areCompleteAtOnce(); // C-46, C-69
    void signature_modelIsKnownByTheFifthByte(); // C-17, C-70
    void signature_ofAnotherDevice_waitsForNine(); // C-70
    void maskDecidesTheLength(); // C-23, C-27, C-69
    void allEightBits_areReplyData(); // C-27, C-30
    void freshParser_isCompleteAndTakesNothing();
    void anyBytesAnySplit_neverTakesMoreThanExpected();
};

void TstReplyParser::reply_isCompleteWhereverItIsSplit_data()
{
    QTest::addColumn<Command>("command");
    QTest::addColumn<QByteArray>("reply");
    QTest::newRow("signature of a TReX Jr") << query("get-signature") << QByteArray("TReXJr1.2");
    QTest::newRow("signature of a TReX") << query("get-signature") << QByteArray("TReX1.2");
    QTest::newRow("mode") << query("get-mode") << QByteArray("r");
    QTest::newRow("the document's raw channels")
        << channelsQuery("get-raw-channels", 0x13) << QByteArray::fromHex("350EFFFF9B0A");
    QTest::newRow("remapped") << channelsQuery("get-remapped-channels", 0x1F)
                              << QByteArray::fromHex("00FF817F80");
    QTest::newRow("currents") << query("get-currents") << QByteArray::fromHex("37FF");
    QTest::newRow("calibration") << readCalibration(1) << QByteArray::fromHex("C409A60E88136400");
    QTest::newRow("answer") << writeParameter(7, 5) << QByteArray(1, '\0');
}

void TstReplyParser::reply_isCompleteWhereverItIsSplit()
{
    QFETCH(Command, command);
    QFETCH(QByteArray, reply);
    for (const bool hasCrc : {false, true}) {
        const QByteArray bytes = hasCrc ? withCrc(reply) : reply;
        for (qsizetype split = 0; split <= bytes.size(); ++split) {
            ReplyParser parser(command, settingsWith(hasCrc));
            QVERIFY(parser.verdict() == Verdict::NeedMore);
            QCOMPARE(parser.feed(bytes.first(split)), int(split));
            QVERIFY(parser.verdict()
                    == (split < bytes.size() ? Verdict::NeedMore : Verdict::Complete));
            QCOMPARE(parser.feed(bytes.sliced(split)), int(bytes.size() - split));
            QVERIFY(parser.verdict() == Verdict::Complete);
            QCOMPARE(parser.payload(), reply);
            QCOMPARE(parser.received(), bytes);
            QCOMPARE(parser.expectedBytes(), int(bytes.size()));
        }
        ReplyParser byteByByte(command, settingsWith(hasCrc));
        for (const char byte : bytes) {
            QVERIFY(byteByByte.verdict() == Verdict::NeedMore);
            QCOMPARE(byteByByte.feed(QByteArrayView(&byte, 1)), 1);
        }
        QVERIFY(byteByByte.verdict() == Verdict::Complete);
        QCOMPARE(byteByByte.payload(), reply);
    }
}

void TstReplyParser::surplus_isLeft_data()
{
    reply_isCompleteWhereverItIsSplit_data();
}

void TstReplyParser::surplus_isLeft()
{
    QFETCH(Command, command);
    QFETCH(QByteArray, reply);
    for (const bool hasCrc : {false, true}) {
        const QByteArray bytes = hasCrc ? withCrc(reply) : reply;
        ReplyParser parser(command, settingsWith(hasCrc));
        QCOMPARE(parser.feed(bytes + QByteArray::fromHex("123456")), int(bytes.size()));
        QVERIFY(parser.verdict() == Verdict::Complete);
        QCOMPARE(parser.payload(), reply);
        QCOMPARE(parser.feed("more"), 0);
        QCOMPARE(parser.received(), bytes);
    }
}

void TstReplyParser::wrongCrc_isNeverComplete()
{
    const QByteArray good = withCrc(QByteArray::fromHex("3716"));
    for (int bit = 0; bit < good.size() * 8; ++bit) {
        QByteArray bad = good;
        bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ 1 << bit % 8);
        ReplyParser parser(query("get-currents"), settingsWith(true));
        QCOMPARE(parser.feed(bad), int(bad.size()));
        QVERIFY(parser.verdict() == Verdict::BadCrc);
        QCOMPARE(parser.feed(good), 0); // judged once: a repeat needs a new parser
        QVERIFY(parser.verdict() == Verdict::BadCrc);
    }
    QByteArray signature = withCrc("TReX1.2");
    signature[4] = '2';
    ReplyParser parser(query("get-signature"), settingsWith(true));
    parser.feed(signature);
    QVERIFY(parser.verdict() == Verdict::BadCrc);
}

void TstReplyParser::polynomial_isTheLines()
{
    LineSettings settings = settingsWith(true);
    settings.polynomial = 0xE5;
    ReplyParser parser(query("get-mode"), settings);
    parser.feed(withCrc("r"));
    QVERIFY(parser.verdict() == Verdict::BadCrc);
    ReplyParser same(query("get-mode"), settings);
    same.feed(QByteArray("r") + static_cast<char>(crc7("r", 0xE5)));
    QVERIFY(same.verdict() == Verdict::Complete);
}

void TstReplyParser::noReplyCommands_areCompleteAtOnce()
{
    const Command silent[]{
        *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 64}),
        *driveBoth({MotorOrder::Action::Accelerate, 1}, {MotorOrder::Action::Accelerate, 2}),
        channelsQuery("get-raw-channels", 0), channelsQuery("get-remapped-channels", 0)};
    for (const auto& command : silent) {
        for (const bool hasCrc : {false, true}) {
            QCOMPARE(replyLength(command), 0);
            ReplyParser parser(command, settingsWith(hasCrc));
            QVERIFY(parser.verdict() == Verdict::Complete);
            QCOMPARE(parser.expectedBytes(), 0);
            QCOMPARE(parser.feed("x"), 0);
            QCOMPARE(parser.payload(), QByteArray());
        }
    }
}

void TstReplyParser::signature_modelIsKnownByTheFifthByte()
{
    for (const bool hasCrc : {false, true}) {
        const int crc = hasCrc ? 1 : 0;
        ReplyParser parser(query("get-signature"), settingsWith(hasCrc));
        parser.feed("TReX");
        QCOMPARE(parser.expectedBytes(), 9 + crc);
        parser.feed("1");
        QCOMPARE(parser.expectedBytes(), 7 + crc);
        ReplyParser jr(query("get-signature"), settingsWith(hasCrc));
        jr.feed("TReXJ");
        QCOMPARE(jr.expectedBytes(), 9 + crc);
    }
}

void TstReplyParser::signature_ofAnotherDevice_waitsForNine()
{
    ReplyParser parser(query("get-signature"), settingsWith(false));
    QCOMPARE(parser.feed("qik2s12"), 7);
    QVERIFY(parser.verdict() == Verdict::NeedMore);
    QCOMPARE(parser.payload(), QByteArray("qik2s12"));
    QCOMPARE(parser.feed("v10"), 2);
    QVERIFY(parser.verdict() == Verdict::Complete);
    QCOMPARE(parser.payload(), QByteArray("qik2s12v1"));
}

void TstReplyParser::maskDecidesTheLength()
{
    for (int mask = 0; mask <= 31; ++mask) {
        const int channels =
            (mask & 1) + (mask >> 1 & 1) + (mask >> 2 & 1) + (mask >> 3 & 1) + (mask >> 4);
        const auto bits = static_cast<std::uint8_t>(mask);
        QCOMPARE(replyLength(channelsQuery("get-raw-channels", bits)), 2 * channels);
        QCOMPARE(replyLength(channelsQuery("get-remapped-channels", bits)), channels);
    }
    QCOMPARE(replyLength(Command{0x86, {}}), 0);
    QCOMPARE(replyLength(Command{0xFF, {}}), 0);
}

void TstReplyParser::allEightBits_areReplyData()
{
    for (int raw = 0; raw < 256; ++raw) {
        ReplyParser parser(query("get-motor1-current"), settingsWith(true));
        const QByteArray reply(1, static_cast<char>(raw));
        parser.feed(withCrc(reply));
        QVERIFY(parser.verdict() == Verdict::Complete);
        QCOMPARE(parser.payload(), reply);
    }
}

void TstReplyParser::freshParser_isCompleteAndTakesNothing()
{
    ReplyParser parser;
    QVERIFY(parser.verdict() == Verdict::Complete);
    QCOMPARE(parser.feed("abc"), 0);
}

void TstReplyParser::anyBytesAnySplit_neverTakesMoreThanExpected()
{
    QRandomGenerator random(4);
    for (int i = 0; i < 20'000; ++i) {
        const auto& row = kCommands[random.bounded(static_cast<quint32>(kCommands.size()))];
        const Command command{row.first, QByteArray(1, static_cast<char>(random.bounded(256)))};
        ReplyParser parser(command, settingsWith(random.bounded(2) == 0));
        int used = 0;
        for (int piece = 0; piece < 6; ++piece) {
            QByteArray bytes;
            for (quint32 length = random.bounded(5U); length > 0; --length) {
                bytes.append(static_cast<char>(random.bounded(256)));
            }
            used += parser.feed(bytes);
            QCOMPARE(parser.received().size(), used);
            QVERIFY(used <= parser.expectedBytes());
            QCOMPARE(parser.verdict() == Verdict::NeedMore, used < parser.expectedBytes());
        }
    }
}

QTEST_APPLESS_MAIN(TstReplyParser)
#include "tst_replyparser.moc"
