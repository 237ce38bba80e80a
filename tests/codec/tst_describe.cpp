// SPDX-License-Identifier: GPL-3.0-or-later
// Packets in words, and the generic decoding of fields underneath.
#include "protocol/codec/command.h"
#include "protocol/codec/replyparser.h"

#include <QCoreApplication>
#include <QRandomGenerator>
#include <QTest>
#include <QTranslator>

using namespace trex;

class TstDescribe : public QObject {
    Q_OBJECT

private slots:
    void command_inWords_data();
    void command_inWords();
    void reply_inWords_data();
    void reply_inWords(); // C-20, C-21, C-24, C-25, C-27, C-30, C-33
    void words_areTranslated();
    void everyFieldAndBit_hasALabel();
    void wholeReply_isDecodedByItsRow();
    void anyBytes_neverCrash();
};

namespace {

Command commandOf(const char* hex)
{
    const QByteArray bytes = QByteArray::fromHex(hex);
    return {static_cast<std::uint8_t>(bytes[0]), bytes.sliced(1)};
}

/// Answers every text with itself in brackets.
class BracketTranslator : public QTranslator {
public:
    [[nodiscard]] QString translate(const char* context, const char* text, const char*,
                                    int) const override
    {
        Q_UNUSED(context)
        return QStringLiteral("[%1]").arg(QString::fromUtf8(text));
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

} // namespace

void TstDescribe::command_inWords_data()
{
    QTest::addColumn<QByteArray>("hex");
    QTest::addColumn<QString>("words");
    const auto add = [](const char* hex, const char* words) {
        QTest::newRow(hex) << QByteArray(hex) << QString::fromUtf8(words);
    };
    add("81", "Get signature");
    add("83", "Does serial control the motors?");
    add("8613", "Get raw channel values: 1, 2, 5");
    add("871F", "Get remapped channel values: 1, 2, 3, 4, 5");
    add("8600", "Get raw channel values: none");
    add("94", "Get calibration of channel 5");
    add("9F07", "Get parameter serial-timeout");
    add("9F60", "Get parameter 0x60");
    add("A044132 61D0827 6400 552A",
        "Set calibration of channel 1: minimum: 2500, neutral: 3750, maximum: 5000, deadband: 100");
    add("AF0705552A", "Set parameter serial-timeout to 5 (500 ms)");
    add("AF0008552A", "Set parameter device-number to 8");
    add("AF6001552A", "Set parameter 0x60 to 1");
    add("C240", "Set motor 1 forward 64");
    add("C128", "Set motor 1 reverse 40");
    add("C07F", "Brake motor 1, duty 127");
    add("C37F", "Brake motor 1, duty 127");
    add("C800", "Brake motor 2, duty 0");
    add("C601", "Accelerate motor 1 forward 1");
    add("CF05", "Accelerate motor 2 brake 5");
    add("D64028", "Set motors 1 forward 64, 2 reverse 40");
    add("D97F05", "Set motors 1 reverse 127, 2 forward 5");
    add("D07F7F", "Set motors 1 brake 127, 2 brake 127");
    add("E64028", "Accelerate motors 1 forward 64, 2 reverse 40");
    add("F07F", "Set auxiliary motor 127");
    add("F120", "Accelerate auxiliary motor 32");
    add("FF", "Unknown command FF");
    add("8207", "Get mode, malformed: 07");
    add("C2", "Set motor 1, malformed: ");
}

void TstDescribe::command_inWords()
{
    QFETCH(QByteArray, hex);
    QFETCH(QString, words);
    QCOMPARE(describe(commandOf(hex.constData())), words);
}

void TstDescribe::reply_inWords_data()
{
    QTest::addColumn<QByteArray>("hex");
    QTest::addColumn<QByteArray>("reply");
    QTest::addColumn<QString>("words");
    const auto add = [](const char* hex, const char* reply, const char* words) {
        QTest::addRow("%s %s", hex, reply)
            << QByteArray(hex) << QByteArray::fromHex(reply) << QString::fromUtf8(words);
    };
    add("81", "545265584A72312E32", "TReXJr1.2");
    add("81", "54526558312E32", "TReX1.2");
    add("81", "545265584A72310032", "TReXJr10x002");
    add("82", "72", "r (serial mode, RC inputs)");
    add("82", "41", "A (analog mode)");
    add("82", "7A", "z (unknown mode)");
    add("83", "01", "yes");
    add("83", "00", "no");
    add("83", "05", "5");
    add("84", "00", "none");
    add("84", "81", "UART error, motor 2 over current limit");
    add("84", "32", "bit 1, motor 1 fault, motor 1 over current limit");
    add("85", "C0", "format error, timeout");
    add("8613", "350EFFFF9B0A", "1: 3637, 2: invalid, 5: 2715");
    add("8715", "00FF2D", "1: 0, 3: -127, 5: 45");
    add("8F", "3716", "motor 1: 55, motor 2: 22");
    add("8D", "FF", "255");
    add("90", "C409A60E88136400", "minimum: 2500, neutral: 3750, maximum: 5000, deadband: 100");
    add("95", "15", "channel 1, channel 3, channel 5");
    add("9F07", "05", "5 (500 ms)");
    add("9F7E", "25", "37 (19200 baud, CRC-7, 1 stop bit)");
    add("9F60", "05", "5");
    add("AF0705552A", "00", "done");
    add("AF0705552A", "01", "refused: bad parameter number");
    add("AF0705552A", "02", "refused: bad value");
    add("AF0705552A", "03", "refused: not in serial mode");
    add("AF0705552A", "2A", "unknown answer 42");
    add("8F", "37", "37"); // too short: bytes, not words
    add("C240", "00", "00"); // no reply was due
    add("8613", "", "");
}

void TstDescribe::reply_inWords()
{
    QFETCH(QByteArray, hex);
    QFETCH(QByteArray, reply);
    QFETCH(QString, words);
    QCOMPARE(describeReply(commandOf(hex.constData()), reply), words);
}

void TstDescribe::words_areTranslated()
{
    BracketTranslator translator;
    QVERIFY(QCoreApplication::installTranslator(&translator));
    for (const auto& row : kCommands) {
        Command command{row.first, {}};
        for (const auto& field : row.arguments) {
            command.data.append(QByteArray(field.width(), static_cast<char>(field.minimum)));
        }
        const QString words = describe(command);
        QVERIFY2(words.startsWith(QLatin1Char('[')), qPrintable(words));
    }
    QCOMPARE(describeReply(commandOf("84"), QByteArray(1, '\1')), QStringLiteral("[UART error]"));
    QCOMPARE(describeReply(commandOf("AF0705552A"), QByteArray(1, '\0')), QStringLiteral("[done]"));
    QCoreApplication::removeTranslator(&translator);
}

void TstDescribe::everyFieldAndBit_hasALabel()
{
    BracketTranslator translator;
    QVERIFY(QCoreApplication::installTranslator(&translator));
    for (const auto& row : kCommands) {
        for (const auto fields : {row.arguments, row.reply}) {
            for (const auto& field : fields) {
                QVERIFY2(labelOf(field.key).startsWith(QLatin1Char('[')), field.key.data());
                for (const auto name : field.bitNames) {
                    QVERIFY2(name.empty() || labelOf(name).startsWith(QLatin1Char('[')),
                             name.data());
                }
            }
        }
    }
    QCoreApplication::removeTranslator(&translator);
    QCOMPARE(labelOf("of-a-later-row"), QStringLiteral("of-a-later-row"));
}

void TstDescribe::wholeReply_isDecodedByItsRow()
{
    const auto fields =
        decodeFields(commandRow("get-currents").reply, QByteArray::fromHex("37FF12"));
    QCOMPARE(fields.size(), std::size_t{2});
    QVERIFY(fields[0].key == "motor1-current" && fields[0].raw == 55);
    QVERIFY(fields[1].key == "motor2-current" && fields[1].raw == 255);
    QCOMPARE(decodeFields(commandRow("get-calibration").reply, QByteArray(5, '\1')).size(),
             std::size_t{2});
    const auto written =
        decodeFields(commandRow("set-parameter").arguments, QByteArray::fromHex("0705552A"));
    QCOMPARE(written[2].text, QStringLiteral("0x55"));
    QCOMPARE(written[3].text, QStringLiteral("0x2A"));
}

void TstDescribe::anyBytes_neverCrash()
{
    QRandomGenerator random(5);
    const auto bytes = [&random](int longest) {
        QByteArray made;
        for (int length = random.bounded(longest); length > 0; --length) {
            made.append(static_cast<char>(random.bounded(256)));
        }
        return made;
    };
    for (int i = 0; i < 50'000; ++i) {
        const Command command{static_cast<std::uint8_t>(random.bounded(256)), bytes(12)};
        QVERIFY(!describe(command).isEmpty());
        const QByteArray reply = bytes(12);
        QCOMPARE(describeReply(command, reply).isEmpty(), reply.isEmpty());
        QByteArray right;
        for (int length = replyLength(command); length > 0; --length) {
            right.append(static_cast<char>(random.bounded(256)));
        }
        QCOMPARE(describeReply(command, right).isEmpty(), right.isEmpty());
    }
}

QTEST_GUILESS_MAIN(TstDescribe)
#include "tst_describe.moc"
