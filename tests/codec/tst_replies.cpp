// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/polltable.h"
#include "protocol/codec/replies.h"
#include "protocol/codec/replyparser.h"

#include <QTest>

using namespace trex;
using namespace std::chrono_literals;

class TstReplies : public QObject {
    Q_OBJECT

private slots:
    void signature_isTakenApart_data();
    void signature_isTakenApart(); // C-17, C-70
    void signature_ofNoTrex_isRefused_data();
    void signature_ofNoTrex_isRefused(); // C-17, C-70
    void mode_hasFourLetters(); // C-18
    void mode_otherByte_isRefused(); // C-18
    void statusBits_standWhereTheDocumentSays(); // C-20
    void uartBits_standWhereTheDocumentSays(); // C-21
    void calibration_isFourWordsLowFirst(); // C-32
    void answer_isSuccessOrItsRefusal(); // C-37, C-38
    void poll_asksWhatItsRowSays(); // C-23
    void poll_documentsExample_isDecoded(); // C-24, C-25
    void poll_keepsRawNumbers(); // C-19, C-26, C-27, C-30, C-33
    void poll_shortPayload_readsNothingBeyond();
};

void TstReplies::signature_isTakenApart_data()
{
    QTest::addColumn<QByteArray>("payload");
    QTest::addColumn<QString>("modelName");
    QTest::addColumn<QString>("firmware");
    QTest::newRow("TReX Jr 1.2") << QByteArray("TReXJr1.2") << QStringLiteral("TReX Jr")
                                 << QStringLiteral("1.2");
    QTest::newRow("TReX Jr 1.0") << QByteArray("TReXJr1.0") << QStringLiteral("TReX Jr")
                                 << QStringLiteral("1.0");
    QTest::newRow("TReX 1.2") << QByteArray("TReX1.2") << QStringLiteral("TReX")
                              << QStringLiteral("1.2");
    QTest::newRow("TReX 1.3") << QByteArray("TReX1.3") << QStringLiteral("TReX")
                              << QStringLiteral("1.3");
}

void TstReplies::signature_isTakenApart()
{
    QFETCH(QByteArray, payload);
    QFETCH(QString, modelName);
    QFETCH(QString, firmware);
    const auto signature = parseSignature(payload);
    QVERIFY(signature);
    QCOMPARE(signature->modelName(), modelName);
    QCOMPARE(signature->firmware(), firmware);
    QCOMPARE(signature->text(), QString::fromLatin1(payload));
}

void TstReplies::signature_ofNoTrex_isRefused_data()
{
    QTest::addColumn<QByteArray>("payload");
    QTest::addColumn<bool>("isTrex");
    QTest::newRow("nothing") << QByteArray() << false;
    QTest::newRow("another device") << QByteArray("qik2s12v1") << false;
    QTest::newRow("first letter lost") << QByteArray("ReXJr1.2\x01") << false;
    QTest::newRow("zeros") << QByteArray(9, '\0') << false;
    QTest::newRow("lower case") << QByteArray("trexjr1.2") << false;
    QTest::newRow("no version") << QByteArray("TReX") << true;
    QTest::newRow("no digits") << QByteArray("TReXJrx.y") << true;
    QTest::newRow("no point") << QByteArray("TReXJr102") << true;
    QTest::newRow("too long") << QByteArray("TReXJr1.23") << true;
    QTest::newRow("another family member") << QByteArray("TReXJx1.2") << true;
}

void TstReplies::signature_ofNoTrex_isRefused()
{
    QFETCH(QByteArray, payload);
    QFETCH(bool, isTrex);
    const auto signature = parseSignature(payload);
    QVERIFY(!signature);
    QVERIFY(signature.error().code == (isTrex ? ErrorCode::BadReply : ErrorCode::NotATrex));
    QCOMPARE(signature.error().context, QString::fromLatin1(payload.toHex().toUpper()));
}

void TstReplies::mode_hasFourLetters()
{
    const struct {
        const char* letter;
        Mode mode;
        std::string_view key;
        bool isSerial;
        InputKind input;
    } expected[]{{"R", Mode::Rc, "rc", false, InputKind::Rc},
                 {"A", Mode::Analog, "analog", false, InputKind::Analog},
                 {"r", Mode::SerialRc, "serial-rc", true, InputKind::Rc},
                 {"a", Mode::SerialAnalog, "serial-analog", true, InputKind::Analog}};
    for (const auto& each : expected) {
        const auto mode = parseMode(each.letter);
        QVERIFY(mode && *mode == each.mode);
        QCOMPARE(letterOf(*mode), *each.letter);
        QVERIFY(keyOf(*mode) == each.key);
        QCOMPARE(isSerial(*mode), each.isSerial);
        QVERIFY(inputOf(*mode) == each.input);
    }
}

void TstReplies::mode_otherByte_isRefused()
{
    for (int byte = 0; byte < 256; ++byte) {
        const QByteArray payload(1, static_cast<char>(byte));
        QCOMPARE(parseMode(payload).has_value(), QByteArray("RAra").contains(payload));
    }
    QVERIFY(parseMode({}).error().code == ErrorCode::BadReply);
    QVERIFY(parseMode("rr").error().code == ErrorCode::BadReply);
}

void TstReplies::statusBits_standWhereTheDocumentSays()
{
    using namespace statusbit;
    QCOMPARE(int{kMotor2OverCurrent}, 1 << 7);
    QCOMPARE(int{kMotor2Fault}, 1 << 6);
    QCOMPARE(int{kMotor1OverCurrent}, 1 << 5);
    QCOMPARE(int{kMotor1Fault}, 1 << 4);
    QCOMPARE(int{kUartError}, 1 << 0);
    const auto& names = commandRow("get-status").reply.front().bitNames;
    const std::array<std::string_view, 8> wanted{
        "uart-error",         "", "", "", "motor1-fault", "motor1-over-current", "motor2-fault",
        "motor2-over-current"};
    QVERIFY(std::ranges::equal(names, wanted));
}

void TstReplies::uartBits_standWhereTheDocumentSays()
{
    using namespace uartbit;
    QCOMPARE(int{kTimeout}, 1 << 7);
    QCOMPARE(int{kFormat}, 1 << 6);
    QCOMPARE(int{kCrc}, 1 << 5);
    QCOMPARE(int{kFrame}, 1 << 4);
    QCOMPARE(int{kOverrun}, 1 << 3);
    QCOMPARE(int{kParity}, 1 << 2);
    QCOMPARE(int{kReadBufferOverrun}, 1 << 1);
    QCOMPARE(int{kSendBufferOverrun}, 1 << 0);
    const auto& names = commandRow("get-uart-errors").reply.front().bitNames;
    const std::array<std::string_view, 8> wanted{"send-buffer-overrun",
                                                 "read-buffer-overrun",
                                                 "parity",
                                                 "overrun",
                                                 "frame",
                                                 "crc",
                                                 "format",
                                                 "timeout"};
    QVERIFY(std::ranges::equal(names, wanted));
}

void TstReplies::calibration_isFourWordsLowFirst()
{
    QCOMPARE(parseCalibration(QByteArray::fromHex("C409A60E88136400")),
             (Calibration{2500, 3750, 5000, 100}));
    // Replies use all eight bits, unlike what is sent (conformance C-35).
    QCOMPARE(parseCalibration(QByteArray::fromHex("FF00008034128000")),
             (Calibration{255, 0x8000, 0x1234, 128}));
}

void TstReplies::answer_isSuccessOrItsRefusal()
{
    const auto answer = [](int byte) {
        return parseAnswer(QByteArray(1, static_cast<char>(byte)));
    };
    QVERIFY(answer(0).has_value());
    QVERIFY(answer(1).error().code == ErrorCode::BadParameterNumber);
    QVERIFY(answer(2).error().code == ErrorCode::BadValue);
    QVERIFY(answer(3).error().code == ErrorCode::NotInSerialMode);
    for (int byte = 4; byte < 256; ++byte) {
        QVERIFY(answer(byte).error().code == ErrorCode::UnknownAnswer);
    }
    QVERIFY(parseAnswer({}).error().code == ErrorCode::BadReply);
    QVERIFY(parseAnswer(QByteArray(2, '\0')).error().code == ErrorCode::BadReply);
}

void TstReplies::poll_asksWhatItsRowSays()
{
    const std::array<const char*, kPollCount> bytes{"8F", "861F", "871F", "84",
                                                    "85", "82",   "83",   "95"};
    for (const auto& row : kPolls) {
        const Command command = pollCommand(row.id);
        QVERIFY(validate(command));
        const QByteArray sent = QByteArray(1, static_cast<char>(command.opcode)) + command.data;
        QCOMPARE(sent.toHex().toUpper(), QByteArray(bytes[static_cast<std::size_t>(row.id)]));
        QCOMPARE(&pollRow(row.id), &row);
        QCOMPARE(replyLength(command), row.values * command.row().reply.front().width());
    }
}

void TstReplies::poll_documentsExample_isDecoded()
{
    // The document's bytes with channels 3 and 4 put between; it prints 2716 for 0x0A9B (C-25).
    const auto sample = decodePoll(PollId::RawChannels,
                                   QByteArray::fromHex("350EFFFF00000104"
                                                       "9B0A"),
                                   Instant(5s));
    QCOMPARE(int{sample.raw[0]}, 3637);
    QVERIFY(sample.raw[1] == kInvalidPulse);
    QCOMPARE(int{sample.raw[2]}, 0);
    QCOMPARE(int{sample.raw[3]}, 1025);
    QCOMPARE(int{sample.raw[4]}, 2715);
    QVERIFY(sample.time == Instant(5s));
    QVERIFY(sample.poll == PollId::RawChannels);
}

void TstReplies::poll_keepsRawNumbers()
{
    const auto currents = decodePoll(PollId::Currents, QByteArray::fromHex("37FF"), {});
    QCOMPARE(int{currents.raw[0]}, 55);
    QCOMPARE(int{currents.raw[1]}, 255);
    const auto remapped =
        decodePoll(PollId::RemappedChannels, QByteArray::fromHex("00817FFF80"), {});
    QCOMPARE(remapped.raw, (std::array<std::uint16_t, 5>{0, 0x81, 0x7F, 0xFF, 0x80}));
    const auto status = decodePoll(PollId::Status, QByteArray::fromHex("81"), {});
    QCOMPARE(status.raw, (std::array<std::uint16_t, 5>{0x81, 0, 0, 0, 0}));
    QCOMPARE(int{decodePoll(PollId::Mode, "r", {}).raw[0]}, int{'r'});
    QCOMPARE(int{decodePoll(PollId::SerialControl, QByteArray(1, '\1'), {}).raw[0]}, 1);
    QCOMPARE(int{decodePoll(PollId::Learned, QByteArray(1, '\x15'), {}).raw[0]}, 0x15);
}

void TstReplies::poll_shortPayload_readsNothingBeyond()
{
    const auto sample = decodePoll(PollId::RawChannels, QByteArray::fromHex("350EFF"), {});
    QCOMPARE(sample.raw, (std::array<std::uint16_t, 5>{3637, 0, 0, 0, 0}));
}

QTEST_APPLESS_MAIN(TstReplies)
#include "tst_replies.moc"
