// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of both tables against bytes that were typed from the vendor's documents.
#include "protocol/codec/packet.h"
#include "protocol/codec/parametertable.h"
#include "protocol/codec/replyparser.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

class TstGoldenPackets : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void everyCommandRow_hasAnEntry_data();
    void everyCommandRow_hasAnEntry();
    void everyOpcode_hasAnEntry();
    void everyParameterRow_hasGetAndSet_data();
    void everyParameterRow_hasGetAndSet(); // C-34, C-38
    void entry_encodesToItsBytes_data();
    void entry_encodesToItsBytes(); // C-01, C-02, C-03, C-13, C-14
    void entry_decodesToItsCommand_data();
    void entry_decodesToItsCommand(); // C-02, C-03, C-13
    void entry_hasTheDocumentsReplyLength_data();
    void entry_hasTheDocumentsReplyLength(); // C-17, C-23, C-27, C-30, C-32, C-46, C-69
    void builders_giveTheEntryOfTheirRow(); // C-34, C-38

private:
    void addEntryRows();
    QJsonArray m_entries;
};

namespace {

QByteArray hexOf(const QJsonObject& entry, QLatin1StringView key)
{
    return QByteArray::fromHex(entry[key].toString().toLatin1());
}

Command commandOf(const QJsonObject& entry)
{
    const QByteArray packet = hexOf(entry, "compact"_L1);
    return {static_cast<std::uint8_t>(packet[0]), packet.sliced(1)};
}

struct Form {
    QLatin1StringView key;
    LineSettings settings;
};

std::vector<Form> forms()
{
    LineSettings compact;
    LineSettings pololu;
    pololu.form = PacketForm::Pololu;
    LineSettings compactCrc = compact;
    compactCrc.errorDetection = ErrorDetection::Crc7;
    LineSettings pololuCrc = pololu;
    pololuCrc.errorDetection = ErrorDetection::Crc7;
    return {{"compact"_L1, compact},
            {"compactCrc"_L1, compactCrc},
            {"pololu"_L1, pololu},
            {"pololuCrc"_L1, pololuCrc}};
}

} // namespace

void TstGoldenPackets::initTestCase()
{
    QFile file(QStringLiteral(TREX_TEST_DATA "/golden_packets.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QJsonParseError error;
    m_entries = QJsonDocument::fromJson(file.readAll(), &error).object()["packets"_L1].toArray();
    QCOMPARE(error.error, QJsonParseError::NoError);
    QVERIFY(!m_entries.isEmpty());
    for (const auto& value : m_entries) {
        QVERIFY(!value.toObject()["source"_L1].toString().isEmpty());
    }
}

void TstGoldenPackets::addEntryRows()
{
    QTest::addColumn<QJsonObject>("entry");
    for (const auto& value : m_entries) {
        const auto entry = value.toObject();
        QTest::addRow("%s %s", qPrintable(entry["row"_L1].toString()),
                      qPrintable(entry["compact"_L1].toString()))
            << entry;
    }
}

void TstGoldenPackets::everyCommandRow_hasAnEntry_data()
{
    QTest::addColumn<QString>("key");
    for (const auto& row : kCommands) {
        const QString key = QString::fromLatin1(row.key);
        QTest::newRow(qPrintable(key)) << key;
    }
}

void TstGoldenPackets::everyCommandRow_hasAnEntry()
{
    QFETCH(QString, key);
    const bool isThere = std::ranges::any_of(
        m_entries, [&](const auto& each) { return each.toObject()["row"_L1].toString() == key; });
    QVERIFY2(isThere, qPrintable(u"no golden packet for the command row "_s + key));
}

void TstGoldenPackets::everyOpcode_hasAnEntry()
{
    QSet<int> opcodes;
    for (const auto& value : m_entries) {
        const auto entry = value.toObject();
        const Command command = commandOf(entry);
        opcodes << command.opcode;
        const CommandRow* const row = findCommand(command.opcode);
        QVERIFY2(row != nullptr, qPrintable(entry["compact"_L1].toString()));
        const QString key = entry["row"_L1].toString();
        if (key != u"pololu-packet") { // the framing row is shown by packets of other rows
            QCOMPARE(key, QString::fromLatin1(row->key));
        }
    }
    for (const auto& row : kCommands) {
        for (int opcode = row.first; opcode <= row.last && row.kind != CommandKind::Framing;
             ++opcode) {
            QVERIFY2(opcodes.contains(opcode),
                     qPrintable(u"no golden packet for opcode 0x"_s + QString::number(opcode, 16)));
        }
    }
}

void TstGoldenPackets::everyParameterRow_hasGetAndSet_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("commandKey");
    for (const auto& row : kParameters) {
        const QString key = QString::fromLatin1(row.key);
        QTest::addRow("get %s", qPrintable(key)) << key << u"get-parameter"_s;
        QTest::addRow("set %s", qPrintable(key)) << key << u"set-parameter"_s;
    }
}

void TstGoldenPackets::everyParameterRow_hasGetAndSet()
{
    QFETCH(QString, key);
    QFETCH(QString, commandKey);
    bool isThere = false;
    for (const auto& value : m_entries) {
        const auto entry = value.toObject();
        if (entry["parameter"_L1].toString() == key && entry["row"_L1].toString() == commandKey) {
            isThere = true;
            QCOMPARE(int{commandOf(entry).data[0]}, int{findParameter(key)->number});
        }
    }
    QVERIFY2(isThere, qPrintable(u"no golden packet for the parameter row "_s + key));
}

void TstGoldenPackets::entry_encodesToItsBytes_data()
{
    addEntryRows();
}

void TstGoldenPackets::entry_encodesToItsBytes()
{
    QFETCH(QJsonObject, entry);
    const Command command = commandOf(entry);
    QVERIFY(validate(command).has_value());
    for (const auto& form : forms()) {
        const QByteArray packet = encode(command, form.settings);
        QCOMPARE(packet.toHex(' ').toUpper(), entry[form.key].toString().toLatin1());
        QVERIFY((packet[0] & 0x80) != 0);
        for (const char byte : packet.sliced(1)) {
            QVERIFY((byte & 0x80) == 0);
        }
    }
}

void TstGoldenPackets::entry_decodesToItsCommand_data()
{
    addEntryRows();
}

void TstGoldenPackets::entry_decodesToItsCommand()
{
    QFETCH(QJsonObject, entry);
    for (const auto& form : forms()) {
        const auto decoded = decodePacket(hexOf(entry, form.key), form.settings);
        QVERIFY2(decoded.has_value(), form.key.data());
        QCOMPARE(decoded->command, commandOf(entry));
        QVERIFY(decoded->form == form.settings.form);
        QCOMPARE(int{decoded->device}, 7);
    }
}

void TstGoldenPackets::entry_hasTheDocumentsReplyLength_data()
{
    addEntryRows();
}

void TstGoldenPackets::entry_hasTheDocumentsReplyLength()
{
    QFETCH(QJsonObject, entry);
    const int bytes = entry["replyBytes"_L1].toInt(-1);
    const Command command = commandOf(entry);
    QCOMPARE(replyLength(command), bytes);
    for (const auto& form : forms()) {
        const ReplyParser parser(command, form.settings);
        QCOMPARE(parser.expectedBytes(), bytes == 0 ? 0 : bytes + (form.settings.hasCrc() ? 1 : 0));
    }
}

void TstGoldenPackets::builders_giveTheEntryOfTheirRow()
{
    int checked = 0;
    for (const auto& value : m_entries) {
        const auto entry = value.toObject();
        const Command command = commandOf(entry);
        const auto& row = command.row();
        if (row.arguments.empty() && row.opcodeBits == OpcodeBits::None) {
            QCOMPARE(query(row.key), command);
        } else if (row.replyRule == ReplyRule::PerMaskBit) {
            QCOMPARE(channelsQuery(row.key, static_cast<std::uint8_t>(command.data[0])), command);
        } else if (row.key == "get-parameter") {
            QCOMPARE(readParameter(static_cast<std::uint8_t>(command.data[0])), command);
        } else if (row.key == "set-parameter") {
            const auto raw = static_cast<std::uint8_t>(command.data[1]);
            QCOMPARE(writeParameter(static_cast<std::uint8_t>(command.data[0]), raw), command);
            QVERIFY(accepts(*findParameter(command.data[0]), raw));
        } else {
            continue;
        }
        ++checked;
    }
    QVERIFY(checked > 70);
}

QTEST_APPLESS_MAIN(TstGoldenPackets)
#include "tst_goldenpackets.moc"
