// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/settingsadvice.h"

#include <QTest>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

class TestSettingsAdvice : public QObject {
    Q_OBJECT

private slots:
    void advice_comesWithItsRow_data();
    void advice_comesWithItsRow();
    void quietValues_getNone();
    void fastPwm_isFineOnATrex();
    void deviceNumber_actsAtOnceOnPololuLines();
    void deviceNumber_inUseIsTold();
    void timeout_isComparedWithOurOwnWaiting();
    void limit_isSeenTogetherWithTheRest_data();
    void limit_isSeenTogetherWithTheRest();
    void polynomial_isToldAsStoredAndInFull();
    void polynomial_isWeighedWhenItIsUsed_data();
    void polynomial_isWeighedWhenItIsUsed();
};

namespace {

const ParameterValues kQuiet{{0x00, 7}, {0x01, 1}, {0x02, 0},    {0x07, 5},
                             {0x09, 1}, {0x0A, 1}, {0x0B, 127},  {0x0C, 127},
                             {0x7B, 0}, {0x7C, 0}, {0x7D, 0x09}, {0x7E, 0x05}};

std::vector<Advice> adviceAfter(int number, int raw, const LineSettings& line = {},
                                Model model = Model::TrexJr)
{
    auto wanted = kQuiet;
    wanted[static_cast<std::uint8_t>(number)] = raw;
    return adviceOn(kQuiet, wanted, line, model);
}

} // namespace

void TestSettingsAdvice::advice_comesWithItsRow_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("raw");
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isAboutChange");
    QTest::newRow("timeout off") << 0x07 << 0 << u"keep running if the line is lost"_s << false;
    QTest::newRow("fast PWM 1") << 0x09 << 0 << u"Motor 1 gets 19.5 kHz"_s << false;
    QTest::newRow("fast PWM 2") << 0x0A << 0 << u"Motor 2 gets 19.5 kHz"_s << false;
    QTest::newRow("joint mode") << 0x7B << 1 << u"no current readings"_s << false;
    QTest::newRow("required and ignored") << 0x02 << 1 << u"channel 1"_s << false;
    QTest::newRow("polynomial") << 0x7D << 0x0B << u"polynomial 0x8B"_s << true;
    QTest::newRow("UART") << 0x7E << 0x2A << u"115200 baud, CRC-7, 1 stop bit"_s << true;
    QTest::newRow("slow firmware") << 0x7E << 7 << u"half of 38400"_s << true;
    QTest::newRow("short timeout") << 0x07 << 1 << u"one lost reply may stop"_s << false;
    QTest::newRow("limit that cannot act")
        << 0x13 << 127 << u"motor 1 is one byte and ends at 10.20 A"_s << false;
    QTest::newRow("input source") << 0x7C << 1 << u"calibration of their own"_s << true;
    QTest::newRow("device number") << 0x00 << 9 << u"number 9"_s << true;
}

void TestSettingsAdvice::advice_comesWithItsRow()
{
    QFETCH(int, number);
    QFETCH(int, raw);
    QFETCH(QString, text);
    QFETCH(bool, isAboutChange);
    const auto all = adviceAfter(number, raw);
    const auto found =
        std::ranges::find_if(all, [&](const Advice& advice) { return advice.text.contains(text); });
    QVERIFY(found != all.end());
    QCOMPARE(int{found->parameter}, number == 0x02 ? 0x01 : number);
    QCOMPARE(found->isAboutChange, isAboutChange);
}

void TestSettingsAdvice::quietValues_getNone()
{
    QVERIFY(adviceOn(kQuiet, kQuiet, {}, Model::TrexJr).empty());
    QVERIFY(adviceOn({}, {}, {}, Model::TrexJr).empty());
}

void TestSettingsAdvice::fastPwm_isFineOnATrex()
{
    QVERIFY(adviceAfter(0x09, 0, {}, Model::Trex).empty());
}

void TestSettingsAdvice::deviceNumber_actsAtOnceOnPololuLines()
{
    LineSettings pololu;
    pololu.form = PacketForm::Pololu;
    QVERIFY(adviceAfter(0x00, 9, pololu).at(0).text.contains(u"at once"_s));
}

void TestSettingsAdvice::deviceNumber_inUseIsTold()
{
    const auto says = [](int number, const std::set<int>& inUse) {
        auto wanted = kQuiet;
        wanted[0x00] = number;
        const auto all = adviceOn(kQuiet, wanted, {}, Model::TrexJr, inUse);
        return std::ranges::any_of(
            all, [](const Advice& each) { return each.text.contains(u"already"_s); });
    };
    QVERIFY(says(9, {7, 9}));
    QVERIFY(!says(10, {7, 9}));
    QVERIFY(!says(7, {7, 9})); // its own
}

void TestSettingsAdvice::timeout_isComparedWithOurOwnWaiting()
{
    LineSettings patient;
    patient.timeout = std::chrono::milliseconds(700);
    QVERIFY(adviceAfter(0x07, 2).empty()); // 200 ms against 100 ms and a packet
    const auto all = adviceAfter(0x07, 5, patient);
    QCOMPARE(all.size(), 1U);
    QVERIFY(all.at(0).text.contains(u"500 ms"_s));
    QVERIFY(all.at(0).text.contains(u"(703 ms)"_s)); // four bytes at 19200 baud take 2.1 ms
}

void TestSettingsAdvice::limit_isSeenTogetherWithTheRest_data()
{
    QTest::addColumn<int>("other");
    QTest::addColumn<int>("raw");
    QTest::addColumn<QString>("text");
    QTest::newRow("acceleration") << 0x0E << 0 << u"unlimited acceleration"_s;
    QTest::newRow("gain") << 0x15 << 0 << u"With gain 0, motor 1"_s;
    QTest::newRow("joint mode") << 0x7B << 1 << u"the limit of motor 1 cannot act"_s;
}

void TestSettingsAdvice::limit_isSeenTogetherWithTheRest()
{
    QFETCH(int, other);
    QFETCH(int, raw);
    QFETCH(QString, text);
    const auto says = [&](int limit, int value) {
        ParameterValues wanted{{0x13, limit}, {0x0E, 10}, {0x15, 5}, {0x7B, 0}};
        wanted[static_cast<std::uint8_t>(other)] = value;
        const auto all = adviceOn(wanted, wanted, {}, Model::TrexJr);
        return std::ranges::any_of(all, [&](const Advice& each) {
            return each.parameter == 0x13 && each.text.contains(text) && !each.isAboutChange;
        });
    };
    QVERIFY(says(30, raw));
    QVERIFY(!says(0, raw)); // no limit: nothing to say
    QVERIFY(!says(30, other == 0x7B ? 0 : 9));
}

void TestSettingsAdvice::polynomial_isToldAsStoredAndInFull()
{
    const auto all = adviceAfter(0x7D, 0x0B);
    QCOMPARE(all.size(), 1U);
    QVERIFY2(all.at(0).text.contains(u"Stored is 0x0b, used is 0x8B"_s, Qt::CaseInsensitive),
             qPrintable(all.at(0).text));
    QVERIFY(all.at(0).text.contains(u"top bit is always 1"_s));
}

void TestSettingsAdvice::polynomial_isWeighedWhenItIsUsed_data()
{
    QTest::addColumn<int>("uart");
    QTest::addColumn<int>("polynomial");
    QTest::addColumn<QString>("text"); ///< none: nothing about its quality
    QTest::newRow("usual") << 0x25 << 0x09 << QString();
    QTest::newRow("0x80 with CRC") << 0x25 << 0x00 << u"no error at all"_s;
    QTest::newRow("0x80 without CRC") << 0x05 << 0x00 << QString();
    QTest::newRow("even with CRC") << 0x25 << 0x0A << u"finds fewer errors"_s;
    QTest::newRow("even without CRC") << 0x05 << 0x0A << QString();
}

void TestSettingsAdvice::polynomial_isWeighedWhenItIsUsed()
{
    QFETCH(int, uart);
    QFETCH(int, polynomial);
    QFETCH(QString, text);
    const ParameterValues values{{0x7D, polynomial}, {0x7E, uart}};
    const auto all = adviceOn(values, values, {}, Model::TrexJr);
    QCOMPARE(all.size(), text.isEmpty() ? 0U : 1U);
    QVERIFY(all.empty() || all.at(0).text.contains(text));
}

QTEST_GUILESS_MAIN(TestSettingsAdvice)
#include "tst_settingsadvice.moc"
