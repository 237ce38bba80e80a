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

QTEST_GUILESS_MAIN(TestSettingsAdvice)
#include "tst_settingsadvice.moc"
