// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/errortext.h"

#include <QSet>
#include <QTest>

using namespace trex;

namespace {

constexpr int kCodes = static_cast<int>(ErrorCode::FileUnwritable) + 1;

} // namespace

class TstErrorText : public QObject {
    Q_OBJECT

private slots:
    void everyCode_isASentenceOfItsOwn();
    void context_isAlwaysTold();
    void wording_namesThePlaceAndTheCure_data();
    void wording_namesThePlaceAndTheCure();
    void context_cannotBreakTheLine();
    void outOfRange_tellsValueAndRange();
    void loss_isAStateOfTheLine();
};

void TstErrorText::everyCode_isASentenceOfItsOwn()
{
    QSet<QString> seen;
    for (int code = 0; code < kCodes; ++code) {
        const QString text = errorText({static_cast<ErrorCode>(code), {}});
        QVERIFY2(text.endsWith(QLatin1Char('.')), qPrintable(text));
        QVERIFY2(!text.contains(QLatin1Char('%')) && !text.contains(QStringLiteral("()"))
                     && !text.contains(QStringLiteral("  ")) && !text.contains(QLatin1Char('\n')),
                 qPrintable(text));
        QVERIFY2(text.size() > 15 && text.size() < 240, qPrintable(text));
        QVERIFY(text[0].isUpper());
        seen << text;
    }
    QCOMPARE(seen.size(), kCodes);
}

void TstErrorText::context_isAlwaysTold()
{
    for (int code = 0; code < kCodes; ++code) {
        const QString text = errorText({static_cast<ErrorCode>(code), QStringLiteral("/dev/x%1y")});
        QCOMPARE(text.count(QStringLiteral("/dev/x%1y")), 1);
    }
}

void TstErrorText::wording_namesThePlaceAndTheCure_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("start");
    QTest::addColumn<QString>("cure");
    const auto add = [](ErrorCode code, const char* start, const char* cure) {
        QTest::newRow(start) << int(code) << QString::fromUtf8(start) << QString::fromUtf8(cure);
    };
    add(ErrorCode::PortDenied, "No permission to open PLACE.",
        "group dialout (sudo usermod -aG dialout $USER), then log in again");
    add(ErrorCode::EchoOnly, "Only our own bytes came back from PLACE.", "wiring");
    add(ErrorCode::Garbage, "Bytes came from PLACE that are no reply of a TReX.", "baud rate");
    add(ErrorCode::NoReply, "No reply from PLACE.", "Scan");
    add(ErrorCode::NotInSerialMode, "The controller refused: it is not in serial mode (PLACE).",
        "mode jumper");
    add(ErrorCode::BadValue, "The controller refused the value (PLACE).", "range");
    add(ErrorCode::PortBusy, "Another program uses PLACE.", "Close");
    add(ErrorCode::FileMalformed, "The file makes no sense (PLACE).", "Correct");
    add(ErrorCode::OutOfRange, "Out of range: PLACE.", "Nothing was sent");
}

void TstErrorText::wording_namesThePlaceAndTheCure()
{
    QFETCH(int, code);
    QFETCH(QString, start);
    QFETCH(QString, cure);
    const QString text = errorText({static_cast<ErrorCode>(code), QStringLiteral("PLACE")});
    QVERIFY2(text.startsWith(start), qPrintable(text));
    QVERIFY2(text.contains(cure), qPrintable(text));
}

void TstErrorText::context_cannotBreakTheLine()
{
    const QString context = QStringLiteral("a\nb\tc\u0007d\u202Ee\u2028f%1");
    const QString text = errorText({ErrorCode::FileMalformed, context});
    QVERIFY2(text.contains(QStringLiteral("(a b c\uFFFDd\uFFFDe f%1)")), qPrintable(text));
}

void TstErrorText::outOfRange_tellsValueAndRange()
{
    const auto error = outOfRange("speed", 200, -127, 127).value();
    QVERIFY(error.code == ErrorCode::OutOfRange);
    QCOMPARE(error.context, QStringLiteral("speed 200 (-127…127)"));
    QVERIFY(errorText(error).startsWith(QStringLiteral("Out of range: speed 200 (-127…127).")));
}

void TstErrorText::loss_isAStateOfTheLine()
{
    for (const auto code : {ErrorCode::NoReply, ErrorCode::ShortReply, ErrorCode::EchoOnly,
                            ErrorCode::Garbage, ErrorCode::LineLost, ErrorCode::NotConnected}) {
        QVERIFY(isLoss(code));
    }
    for (const auto code :
         {ErrorCode::BadValue, ErrorCode::BadParameterNumber, ErrorCode::NotInSerialMode,
          ErrorCode::UnknownAnswer, ErrorCode::NotTrusted, ErrorCode::Cancelled,
          ErrorCode::OutOfRange, ErrorCode::PortDenied, ErrorCode::FileMalformed}) {
        QVERIFY(!isLoss(code));
    }
}

QTEST_APPLESS_MAIN(TstErrorText)
#include "tst_errortext.moc"
