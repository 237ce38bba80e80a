// SPDX-License-Identifier: GPL-3.0-or-later
// Line options as typed, numbers as typed, and what is kept of them between runs.
#include "app/common/lineoptions.h"
#include "app/common/numbers.h"
#include "protocol/storage/linesettingsstore.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

class tst_lineoptions : public QObject {
    Q_OBJECT

private slots:
    void numbers_data();
    void numbers();
    void defaults_areTheContracts();
    void everyOption_isTaken();
    void device_impliesPololu();
    void port_fallsBackToTheLast();
    void store_keepsWhatWasGood();
    void store_ignoresNonsense();
    void damagedFile_isKeptAside_data();
    void damagedFile_isKeptAside();
    void unreadableFile_isLeftAlone();
};

void tst_lineoptions::numbers_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isNumber");
    QTest::addColumn<int>("number");
    QTest::newRow("decimal") << u"12"_s << true << 12;
    QTest::newRow("no octal") << u"010"_s << true << 10;
    QTest::newRow("hex") << u"0x1f"_s << true << 31;
    QTest::newRow("HEX") << u"0X1F"_s << true << 31;
    QTest::newRow("minus") << u"-7"_s << true << -7;
    QTest::newRow("minus hex") << u"-0x10"_s << true << -16;
    for (const char* bad : {"", "-", "0x", "1.0", "1e3", " 1", "1 ", "--1", "+1", "0xG", "ten",
                            "99999999999999999999"}) {
        QTest::newRow(bad) << QString::fromLatin1(bad) << false << 0;
    }
    QTest::newRow("other digits") << u"١٢"_s << false << 0;
}

void tst_lineoptions::numbers()
{
    QFETCH(QString, text);
    QFETCH(bool, isNumber);
    QFETCH(int, number);
    const auto got = numberFromText(text);
    QCOMPARE(got.has_value(), isNumber);
    QCOMPARE(got.value_or(0), number);
}

void tst_lineoptions::defaults_areTheContracts()
{
    const LineSettings line = toLineSettings({}).value(); // contracts/cli.md, global options
    QCOMPARE(line.baud, 19200);
    QCOMPARE(line.errorDetection, ErrorDetection::None);
    QCOMPARE(line.polynomial, 0x89);
    QCOMPARE(line.stopBits, 1);
    QCOMPARE(line.form, PacketForm::Compact);
    QCOMPARE(line.device, 7);
    QCOMPARE(line.echo, EchoMode::Auto);
    QCOMPARE(line.timeout, std::chrono::milliseconds(100));
}

void tst_lineoptions::everyOption_isTaken()
{
    const LineSettings line = toLineSettings({.port = {},
                                              .baud = u"0x2580"_s,
                                              .protocol = u"pololu"_s,
                                              .device = u"0x11"_s,
                                              .errorDetection = u"crc7"_s,
                                              .polynomial = u"0xE5"_s,
                                              .stopBits = u"2"_s,
                                              .echo = u"off"_s,
                                              .timeout = u"250"_s})
                                  .value();
    QVERIFY((line
             == LineSettings{.baud = 9600,
                             .errorDetection = ErrorDetection::Crc7,
                             .polynomial = 0xE5,
                             .stopBits = 2,
                             .form = PacketForm::Pololu,
                             .device = 17,
                             .echo = EchoMode::Off,
                             .timeout = std::chrono::milliseconds(250)}));
}

void tst_lineoptions::device_impliesPololu()
{
    LineOptionValues values;
    values.device = u"7"_s;
    QCOMPARE(toLineSettings(values)->form, PacketForm::Pololu);
    values.protocol = u"compact"_s; // would reach every device on the line
    QVERIFY(!toLineSettings(values));
}

void tst_lineoptions::port_fallsBackToTheLast()
{
    QTemporaryDir folder;
    SettingsFile file(folder.filePath(u"s.ini"_s));
    QCOMPARE(toOpenOptions({}, file)->port, u"sim:"_s);
    LineSettingsStore(file).remember(u"/dev/ttyUSB7"_s, {});
    QCOMPARE(toOpenOptions({}, file)->port, u"/dev/ttyUSB7"_s);
    LineOptionValues values;
    values.port = u"tcp://h:1"_s;
    QCOMPARE(toOpenOptions(values, file)->port, u"tcp://h:1"_s);
    values.port = QString();
    QCOMPARE(toOpenOptions(values, file).error().code, ErrorCode::PortAddress);
}

void tst_lineoptions::store_keepsWhatWasGood()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(u"deep/er/s.ini"_s);
    const LineSettings fast{.baud = 115200,
                            .errorDetection = ErrorDetection::Odd,
                            .polynomial = 0x91,
                            .stopBits = 2,
                            .form = PacketForm::Pololu,
                            .device = 99,
                            .echo = EchoMode::On,
                            .timeout = std::chrono::milliseconds(333)};
    {
        SettingsFile file(path);
        QVERIFY(!file.problem());
        LineSettingsStore store(file);
        store.remember(u"tcp://10.0.0.1:3001"_s, fast);
        store.remember(u"/dev/serial/by-id/usb-a b%2F"_s, {});
    }
    SettingsFile file(path);
    const LineSettingsStore store(file);
    QCOMPARE(store.lastPort(), u"/dev/serial/by-id/usb-a b%2F"_s);
    QVERIFY(store.lastGood(u"tcp://10.0.0.1:3001"_s) == fast);
    QVERIFY(store.lastGood(u"/dev/serial/by-id/usb-a b%2F"_s) == LineSettings{});
    QVERIFY(!store.lastGood(u"/dev/ttyUSB0"_s));
}

void tst_lineoptions::store_ignoresNonsense()
{
    QTemporaryDir folder;
    SettingsFile file(folder.filePath(u"s.ini"_s));
    for (const QString& text :
         {u""_s, u"19200"_s, u"19201 none 137 1 compact 7 auto 100"_s,
          u"19200 none 9 1 compact 7 auto 100"_s, u"19200 none 137 1 compact 700 auto 100"_s,
          u"19200 none 137 1 compact 7 maybe 100"_s, u"19200 none 137 1 compact 7 auto 0"_s}) {
        file.setVariant(u"linePorts/x"_s, text);
        QVERIFY2(!LineSettingsStore(file).lastGood(u"x"_s), qPrintable(text));
    }
    file.setVariant(u"linePorts/x"_s, u"19200 none 137 1 compact 7 auto 100"_s);
    QVERIFY(LineSettingsStore(file).lastGood(u"x"_s) == LineSettings{});
}

void tst_lineoptions::damagedFile_isKeptAside_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("place");
    QTest::newRow("a line without sense") << QByteArray("[a]\nb=1\nnonsense\n") << u":3"_s;
    QTest::newRow("zero bytes") << QByteArray("a=\0\n", 4) << u":1"_s;
    QTest::newRow("noise") << QByteArray("\x80\xff\x01\x02") << u":1"_s;
}

void tst_lineoptions::damagedFile_isKeptAside()
{
    QFETCH(QByteArray, content);
    QFETCH(QString, place);
    QTemporaryDir folder;
    const QString path = folder.filePath(u"s.ini"_s);
    const auto write = [&] {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    };
    for (const QString& kept : {path + u".damaged"_s, path + u".damaged.2"_s}) {
        write();
        {
            SettingsFile file(path);
            QVERIFY(file.problem());
            QCOMPARE(file.problem()->code, ErrorCode::FileMalformed);
            QVERIFY(file.problem()->context.endsWith(place));
            QCOMPARE(file.variant(u"a/b"_s, 5), 5); // as if it were empty
            file.setVariant(u"x"_s, 1);
        }
        QFile aside(kept);
        QVERIFY(aside.open(QIODevice::ReadOnly));
        QCOMPARE(aside.readAll(), content);
        QVERIFY(!SettingsFile(path).problem()); // and a sound file stands in its place
    }
}

void tst_lineoptions::unreadableFile_isLeftAlone()
{
    QTemporaryDir folder;
    for (const QString& path : {folder.path(), u"/dev/zero"_s}) {
        SettingsFile file(path);
        QVERIFY(file.problem());
        QCOMPARE(file.problem()->code, ErrorCode::FileUnreadable);
        file.setVariant(u"a"_s, 1);
        file.sync();
        QCOMPARE(file.variant(u"a"_s, 7), 7);
    }
}

QTEST_GUILESS_MAIN(tst_lineoptions)
#include "tst_lineoptions.moc"
