// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/crc7.h"
#include "protocol/codec/packet.h"

#include <QRandomGenerator>
#include <QTest>

using namespace trex;

namespace {

LineSettings pololu(std::uint8_t device)
{
    LineSettings settings;
    settings.form = PacketForm::Pololu;
    settings.device = device;
    return settings;
}

LineSettings withCrc(LineSettings settings = {}, std::uint8_t polynomial = kDefaultPolynomial)
{
    settings.errorDetection = ErrorDetection::Crc7;
    settings.polynomial = polynomial;
    return settings;
}

Command randomCommand(QRandomGenerator& random)
{
    for (;;) {
        const auto& row = kCommands[random.bounded(static_cast<quint32>(kCommands.size()))];
        if (row.kind == CommandKind::Framing) {
            continue;
        }
        Command command{
            static_cast<std::uint8_t>(row.first + random.bounded(row.last - row.first + 1)), {}};
        for (const auto& field : row.arguments) {
            const int raw = field.minimum + random.bounded(field.maximum - field.minimum + 1);
            command.data.append(static_cast<char>(raw & 0x7F));
            if (field.width() == 2) {
                command.data.append(static_cast<char>(raw >> 7));
            }
        }
        return command;
    }
}

} // namespace

class TstPacket : public QObject {
    Q_OBJECT

private slots:
    void documentsExamples_areTheSameCommand(); // C-03
    void deviceNumber_isTheSecondByte(); // C-03, C-06
    void crc_coversTheWholePololuPacket(); // C-13
    void polynomial_isTheLines(); // C-13, C-14
    void anyCommand_roundTripsInEveryForm(); // C-01, C-02, C-03, C-13
    void badPackets_areRefused_data();
    void badPackets_areRefused();
    void wrongCrc_isTold(); // C-13
    void anyBytes_neverCrash();
    void nullCommand_isNoCommandOfOurs(); // C-56
    void toHex_isUpperCaseWithoutSpaces();
};

void TstPacket::documentsExamples_areTheSameCommand()
{
    const auto compact = decodePacket(QByteArray::fromHex("861F"), {});
    const auto expanded = decodePacket(QByteArray::fromHex("8007061F"), {});
    QVERIFY(compact && expanded);
    QCOMPARE(compact->command, expanded->command);
    QVERIFY(compact->form == PacketForm::Compact);
    QVERIFY(expanded->form == PacketForm::Pololu);
    QCOMPARE(decodePacket(QByteArray::fromHex("F07F"), {})->command,
             decodePacket(QByteArray::fromHex("8007707F"), {})->command);
}

void TstPacket::deviceNumber_isTheSecondByte()
{
    for (int device = 0; device <= 127; ++device) {
        const auto settings = pololu(static_cast<std::uint8_t>(device));
        const QByteArray packet = encode(query("get-mode"), settings);
        QCOMPARE(packet, QByteArray::fromHex("80") + static_cast<char>(device) + '\x02');
        QCOMPARE(int{decodePacket(packet, {})->device}, device);
    }
    QCOMPARE(encode(query("get-mode"), pololu(LineSettings{}.device)),
             QByteArray::fromHex("800702"));
}

void TstPacket::crc_coversTheWholePololuPacket()
{
    QCOMPARE(toHex(encode(query("get-signature"), withCrc(pololu(7)))), QStringLiteral("8007017D"));
    QVERIFY(encode(query("get-signature"), withCrc(pololu(8))).back() != 0x7D);
}

void TstPacket::polynomial_isTheLines()
{
    const QByteArray packet = encode(query("get-mode"), withCrc({}, 0xE5));
    QCOMPARE(int{packet.back()}, int{crc7(QByteArrayView("\x82"), 0xE5)});
    QVERIFY(packet != encode(query("get-mode"), withCrc()));
    QVERIFY(decodePacket(packet, withCrc({}, 0xE5)));
    QVERIFY(decodePacket(packet, withCrc()).error().code == ErrorCode::BadReplyCrc);
}

void TstPacket::anyCommand_roundTripsInEveryForm()
{
    QRandomGenerator random(2);
    for (int i = 0; i < 20'000; ++i) {
        const Command command = randomCommand(random);
        QVERIFY2(validate(command), qPrintable(toHex(command.data)));
        LineSettings settings;
        settings.form = random.bounded(2) == 0 ? PacketForm::Compact : PacketForm::Pololu;
        settings.device = static_cast<std::uint8_t>(random.bounded(128));
        if (random.bounded(2) == 0) {
            settings = withCrc(settings, static_cast<std::uint8_t>(0x80 + random.bounded(128)));
        }
        const QByteArray packet = encode(command, settings);
        const auto decoded = decodePacket(packet, settings);
        QVERIFY2(decoded, qPrintable(toHex(packet)));
        QCOMPARE(decoded->command, command);
        QVERIFY(decoded->form == settings.form);
        QVERIFY(decoded->device == settings.device);
        QVERIFY((packet[0] & 0x80) != 0);
        QVERIFY(std::none_of(packet.begin() + 1, packet.end(),
                             [](char byte) { return (byte & 0x80) != 0; }));
    }
}

void TstPacket::badPackets_areRefused_data()
{
    QTest::addColumn<QByteArray>("packet");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("a data byte first") << QByteArray::fromHex("01");
    QTest::newRow("no such command") << QByteArray::fromHex("88");
    QTest::newRow("null command 0xFF") << QByteArray::fromHex("FF");
    QTest::newRow("0xF2, one past the last") << QByteArray::fromHex("F240");
    QTest::newRow("mask missing") << QByteArray::fromHex("86");
    QTest::newRow("one byte too many") << QByteArray::fromHex("8200");
    QTest::newRow("command byte as data") << QByteArray::fromHex("8682");
    QTest::newRow("framing alone") << QByteArray::fromHex("80");
    QTest::newRow("framing and device") << QByteArray::fromHex("8007");
    QTest::newRow("framing inside framing") << QByteArray::fromHex("800700");
    QTest::newRow("device above 127") << QByteArray::fromHex("808702");
    QTest::newRow("command bit not cleared") << QByteArray::fromHex("800781");
    QTest::newRow("framing, no such command") << QByteArray::fromHex("800708");
}

void TstPacket::badPackets_areRefused()
{
    QFETCH(QByteArray, packet);
    const auto decoded = decodePacket(packet, {});
    QVERIFY(!decoded);
    QVERIFY(decoded.error().code == ErrorCode::BadCommand);
    QCOMPARE(decoded.error().context, toHex(packet));
    const char crc = static_cast<char>(crc7(packet, kDefaultPolynomial));
    QVERIFY(!decodePacket(packet + crc, withCrc()));
}

void TstPacket::wrongCrc_isTold()
{
    const QByteArray good = QByteArray::fromHex("861F07");
    QVERIFY(decodePacket(good, withCrc()));
    for (int bit = 0; bit < 24; ++bit) {
        QByteArray bad = good;
        bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ 1 << bit % 8);
        QVERIFY(decodePacket(bad, withCrc()).error().code == ErrorCode::BadReplyCrc);
    }
}

void TstPacket::anyBytes_neverCrash()
{
    QRandomGenerator random(3);
    for (int i = 0; i < 50'000; ++i) {
        QByteArray bytes;
        for (quint32 length = random.bounded(16U); length > 0; --length) {
            bytes.append(static_cast<char>(random.bounded(256)));
        }
        const auto settings = random.bounded(2) == 0 ? LineSettings{} : withCrc();
        const auto decoded = decodePacket(bytes, settings);
        if (decoded) { // whatever was understood can be said again in the same bytes
            auto same = settings;
            same.form = decoded->form;
            same.device = decoded->device;
            QCOMPARE(encode(decoded->command, same), bytes);
        }
    }
}

void TstPacket::nullCommand_isNoCommandOfOurs()
{
    QVERIFY(findCommand(std::uint8_t{0xFF}) == nullptr);
    QVERIFY(validate(Command{0xFF, {}}).error().code == ErrorCode::BadCommand);
}

void TstPacket::toHex_isUpperCaseWithoutSpaces()
{
    QCOMPARE(toHex(QByteArray::fromHex("af7e0a552a")), QStringLiteral("AF7E0A552A"));
    QCOMPARE(toHex({}), QString());
}

QTEST_APPLESS_MAIN(TstPacket)
#include "tst_packet.moc"
