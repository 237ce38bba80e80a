// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/linesettings.h"

#include <QSet>
#include <QTest>

#include <functional>

using namespace trex;
using namespace std::chrono_literals;

class TstLineSettings : public QObject {
    Q_OBJECT

private slots:
    void defaults_areTheControllers(); // C-06, C-14, C-53
    void bauds_areTheDocumentsEleven(); // C-53
    void byteTime_followsTheSettings(); // C-10, C-53
    void validate_namesTheFirstWrongField_data();
    void validate_namesTheFirstWrongField();
    void keys_roundTrip();
    void uartSettings_giveTheDocumentedBytes_data();
    void uartSettings_giveTheDocumentedBytes(); // C-53
    void uartSettings_allCombinations_roundTrip(); // C-53
    void uartSettings_everyByte_isReadOrRefused(); // C-59
};

void TstLineSettings::defaults_areTheControllers()
{
    const LineSettings settings;
    QCOMPARE(settings.baud, 19200);
    QVERIFY(settings.errorDetection == ErrorDetection::None);
    QCOMPARE(int{settings.polynomial}, 0x89);
    QCOMPARE(settings.stopBits, 1);
    QCOMPARE(int{settings.device}, 7);
    QVERIFY(validate(settings));
}

void TstLineSettings::bauds_areTheDocumentsEleven()
{
    const std::array<int, 11> wanted{1200,  2400,  4800,  9600,  14400, 19200,
                                     28800, 38400, 57600, 76800, 115200};
    QCOMPARE(kBaudRates, wanted);
    QCOMPARE(baudIndex(19200), 5);
    QCOMPARE(baudIndex(115200), 10);
    QCOMPARE(baudIndex(300), -1);
}

void TstLineSettings::byteTime_followsTheSettings()
{
    LineSettings settings;
    QCOMPARE(settings.bitsPerByte(), 10);
    settings.stopBits = 2;
    QCOMPARE(settings.bitsPerByte(), 11);
    settings.errorDetection = ErrorDetection::Even;
    QVERIFY(settings.hasParity());
    QCOMPARE(settings.bitsPerByte(), 12);
    settings.errorDetection = ErrorDetection::Odd;
    QCOMPARE(settings.bitsPerByte(), 12);
    settings.errorDetection = ErrorDetection::Crc7; // a byte more a packet, not a bit more a byte
    QVERIFY(!settings.hasParity() && settings.hasCrc());
    QCOMPARE(settings.bitsPerByte(), 11);

    settings = {};
    settings.baud = 1200;
    QVERIFY(settings.timeOf(120) == 1s);
    QVERIFY(settings.timeOf(0) == 0ns);
    settings.baud = 115200;
    QVERIFY(settings.timeOf(1) == 86'806ns); // rounded up: never shorter than the wire takes
    QVERIFY(settings.timeOf(1'000'000'000) > 86'000s); // no overflow
}

void TstLineSettings::validate_namesTheFirstWrongField_data()
{
    QTest::addColumn<LineSettings>("settings");
    QTest::addColumn<QString>("field");
    const auto add = [](const char* name, const QString& field,
                        const std::function<void(LineSettings&)>& change) {
        LineSettings settings;
        change(settings);
        QTest::newRow(name) << settings << field;
    };
    add("default", {}, [](LineSettings&) {});
    add("last baud", {}, [](LineSettings& each) { each.baud = 115200; });
    add("unknown baud", QStringLiteral("baud"), [](LineSettings& each) { each.baud = 19201; });
    add("baud 0", QStringLiteral("baud"), [](LineSettings& each) { each.baud = 0; });
    add("polynomial without its top bit", QStringLiteral("crc-polynomial"),
        [](LineSettings& each) { each.polynomial = 0x09; });
    add("no stop bit", QStringLiteral("stop-bits"), [](LineSettings& each) { each.stopBits = 0; });
    add("two stop bits", {}, [](LineSettings& each) { each.stopBits = 2; });
    add("three stop bits", QStringLiteral("stop-bits"),
        [](LineSettings& each) { each.stopBits = 3; });
    add("device 127", {}, [](LineSettings& each) { each.device = 127; });
    add("device 128", QStringLiteral("device"), [](LineSettings& each) { each.device = 128; });
    add("no timeout", QStringLiteral("timeout"), [](LineSettings& each) { each.timeout = 0ms; });
    add("negative timeout", QStringLiteral("timeout"),
        [](LineSettings& each) { each.timeout = -1ms; });
    add("timeout of an hour", QStringLiteral("timeout"),
        [](LineSettings& each) { each.timeout = 1h; });
}

void TstLineSettings::validate_namesTheFirstWrongField()
{
    QFETCH(LineSettings, settings);
    QFETCH(QString, field);
    const auto result = validate(settings);
    QCOMPARE(result.has_value(), field.isEmpty());
    if (!result) {
        QVERIFY(result.error().code == ErrorCode::OutOfRange);
        QVERIFY2(result.error().context.startsWith(field + QLatin1Char(' ')),
                 qPrintable(result.error().context));
    }
}

void TstLineSettings::keys_roundTrip()
{
    const struct {
        ErrorDetection detection;
        std::string_view key;
    } detections[]{{ErrorDetection::None, "none"},
                   {ErrorDetection::Even, "even"},
                   {ErrorDetection::Odd, "odd"},
                   {ErrorDetection::Crc7, "crc7"}};
    for (const auto& each : detections) {
        QVERIFY(keyOf(each.detection) == each.key);
        QVERIFY(errorDetectionFromKey(QString::fromLatin1(each.key)) == each.detection);
    }
    QVERIFY(keyOf(PacketForm::Compact) == "compact");
    QVERIFY(keyOf(PacketForm::Pololu) == "pololu");
    QVERIFY(packetFormFromKey(u"compact") == PacketForm::Compact);
    QVERIFY(packetFormFromKey(u"pololu") == PacketForm::Pololu);
    QVERIFY(!errorDetectionFromKey(u"CRC7"));
    QVERIFY(!errorDetectionFromKey(u""));
    QVERIFY(!packetFormFromKey(u"pololu "));
}

void TstLineSettings::uartSettings_giveTheDocumentedBytes_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("detection");
    QTest::addColumn<int>("stopBits");
    QTest::addColumn<int>("raw");
    // facts.md 2.3, examples
    QTest::newRow("default") << 19200 << int(ErrorDetection::None) << 1 << 0x05;
    QTest::newRow("115200") << 115200 << int(ErrorDetection::None) << 1 << 0x0A;
    QTest::newRow("19200, CRC-7") << 19200 << int(ErrorDetection::Crc7) << 1 << 0x25;
    QTest::newRow("19200, even") << 19200 << int(ErrorDetection::Even) << 1 << 0x45;
    QTest::newRow("19200, odd") << 19200 << int(ErrorDetection::Odd) << 1 << 0x65;
    QTest::newRow("two stop bits") << 19200 << int(ErrorDetection::None) << 2 << 0x15;
    QTest::newRow("all at once") << 1200 << int(ErrorDetection::Odd) << 2 << 0x70;
}

void TstLineSettings::uartSettings_giveTheDocumentedBytes()
{
    QFETCH(int, baud);
    QFETCH(int, detection);
    QFETCH(int, stopBits);
    QFETCH(int, raw);
    const UartSettings settings{baudIndex(baud), static_cast<ErrorDetection>(detection), stopBits};
    QCOMPARE(int{settings.toRaw()}, raw);
}

void TstLineSettings::uartSettings_allCombinations_roundTrip()
{
    QSet<int> seen;
    for (int index = 0; index < 11; ++index) {
        for (const auto detection : {ErrorDetection::None, ErrorDetection::Even,
                                     ErrorDetection::Odd, ErrorDetection::Crc7}) {
            for (const int stopBits : {1, 2}) {
                const int raw = UartSettings{index, detection, stopBits}.toRaw();
                seen << raw;
                const auto read = UartSettings::fromRaw(raw);
                QVERIFY(read);
                QCOMPARE(read->baudIndex, index);
                QVERIFY(read->errorDetection == detection);
                QCOMPARE(read->stopBits, stopBits);
            }
        }
    }
    QCOMPARE(seen.size(), 11 * 4 * 2);
}

void TstLineSettings::uartSettings_everyByte_isReadOrRefused()
{
    for (int raw = -2; raw < 300; ++raw) {
        const auto read = UartSettings::fromRaw(raw);
        QCOMPARE(read.has_value(), raw >= 0 && raw <= 127 && (raw & 15) <= 10);
        if (read) {
            QCOMPARE(int{read->toRaw()}, raw);
        }
    }
}

QTEST_APPLESS_MAIN(TstLineSettings)
#include "tst_linesettings.moc"
