// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/crc7.h"
#include "protocol/codec/linesettings.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRandomGenerator>
#include <QTest>

#include <vector>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

/// The definition itself, written as division on a list of bits: nothing shared with the code.
std::uint8_t byLongDivision(const QByteArray& bytes, std::uint8_t polynomial)
{
    std::vector<int> bits;
    for (const char byte : bytes) {
        for (int bit = 7; bit >= 0; --bit) {
            bits.push_back(static_cast<std::uint8_t>(byte) >> bit & 1);
        }
    }
    bits.insert(bits.end(), 7, 0);
    for (std::size_t at = 0; at + 8 <= bits.size(); ++at) {
        if (bits[at] == 1) {
            for (std::size_t i = 0; i < 8; ++i) {
                bits[at + i] ^= polynomial >> (7 - i) & 1;
            }
        }
    }
    int remainder = 0;
    for (std::size_t i = bits.size() - 7; i < bits.size(); ++i) {
        remainder = remainder << 1 | bits[i];
    }
    return static_cast<std::uint8_t>(remainder);
}

} // namespace

class TstCrc7 : public QObject {
    Q_OBJECT

private slots:
    void defaultPolynomial_givesThePublishedValues_data(); // C-14
    void defaultPolynomial_givesThePublishedValues();
    void anyPolynomial_equalsLongDivision(); // C-14
    void anyBytes_leaveTheTopBitClear(); // C-01, C-14
    void anySingleBitError_isFound();
};

void TstCrc7::defaultPolynomial_givesThePublishedValues_data()
{
    QTest::addColumn<QByteArray>("message");
    QTest::addColumn<int>("crc");
    QFile file(QStringLiteral(TREX_TEST_DATA "/golden_packets.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto entries = QJsonDocument::fromJson(file.readAll())["crc"_L1].toArray();
    QVERIFY(entries.size() >= 20);
    for (const auto& value : entries) {
        const auto entry = value.toObject();
        const QByteArray message = entry["message"_L1].toString().toLatin1();
        QTest::newRow(message.constData())
            << QByteArray::fromHex(message) << entry["crc"_L1].toString().toInt(nullptr, 16);
    }
}

void TstCrc7::defaultPolynomial_givesThePublishedValues()
{
    QFETCH(QByteArray, message);
    QFETCH(int, crc);
    QCOMPARE(int{crc7(message, kDefaultPolynomial)}, crc);
}

void TstCrc7::anyPolynomial_equalsLongDivision()
{
    QRandomGenerator random(1);
    for (int polynomial = 0x80; polynomial <= 0xFF; ++polynomial) {
        for (int length = 0; length <= 12; ++length) {
            QByteArray message;
            for (int i = 0; i < length; ++i) {
                message.append(static_cast<char>(random.bounded(256)));
            }
            const auto eightBits = static_cast<std::uint8_t>(polynomial);
            QCOMPARE(int{crc7(message, eightBits)}, int{byLongDivision(message, eightBits)});
        }
    }
}

void TstCrc7::anyBytes_leaveTheTopBitClear()
{
    for (int first = 0; first < 256; ++first) {
        for (int second = 0; second < 256; ++second) {
            const char message[]{static_cast<char>(first), static_cast<char>(second)};
            QVERIFY(crc7(QByteArrayView(message, 2), kDefaultPolynomial) < 0x80);
            QVERIFY(crc7(QByteArrayView(message, 2), 0xFF) < 0x80);
        }
    }
}

void TstCrc7::anySingleBitError_isFound()
{
    const QByteArray good = QByteArray::fromHex("AF7E0A552A");
    for (int bit = 0; bit < good.size() * 8; ++bit) {
        QByteArray bad = good;
        bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ 1 << bit % 8);
        QVERIFY(crc7(bad, kDefaultPolynomial) != crc7(good, kDefaultPolynomial));
    }
}

QTEST_APPLESS_MAIN(TstCrc7)
#include "tst_crc7.moc"
