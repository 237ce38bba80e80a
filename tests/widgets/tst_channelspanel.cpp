// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/panelbench.h"
#include "widgets/channels/channelbar.h"
#include "widgets/channels/channelspanel.h"
#include "widgets/common/theme.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kLongMs = 30'000;

struct Bench : test::PanelBench<ChannelsPanel> {
    [[nodiscard]] ChannelBar* bar(int channel) const
    {
        return part<ChannelBar>(u"channels.%1.bar"_s.arg(channel));
    }
    [[nodiscard]] QString text(int channel) const
    {
        return part<QLabel>(u"channels.%1.text"_s.arg(channel))->text();
    }
    [[nodiscard]] QString scenario(const QByteArray& channels) const
    {
        QFile written(folder.filePath(u"scenario.json"_s));
        if (written.open(QIODevice::WriteOnly)) {
            written.write("{\"channels\":[" + channels + "]}");
        }
        return u"sim:?mode=rc&scenario="_s + written.fileName();
    }
};

/// The horizontal place of the bar's marker, as a part of its width; −1 when there is none.
double markerPlace(ChannelBar& bar, const QColor& colour)
{
    const QImage image = bar.grab().toImage();
    for (int x = image.width() - 1; x >= 0; --x) {
        if (image.pixelColor(x, 3) == colour) { // above the deviation, within the raw lane
            return double(x) / image.width();
        }
    }
    return -1.0;
}

} // namespace

class TestChannelsPanel : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { theme::apply(theme::Choice::Light); }
    void parts_haveTheirNames();
    void text_saysUnitAndRaw_data();
    void text_saysUnitAndRaw();
    void invalid_isNeverAValue();
    void marker_standsAtTheValue();
    void stale_looksStale();
    void calibration_isDrawn();
    void panel_showsLiveChannels();
    void panel_readsTheCalibration();
    void panel_turnsStaleWhenTheLinkCloses();
    void calibrate_isAsked();
};

void TestChannelsPanel::parts_haveTheirNames()
{
    const Bench bench;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        QVERIFY(bench.bar(channel) != nullptr);
        QCOMPARE(bench.bar(channel)->property("valid").toBool(), false);
        QCOMPARE(bench.text(channel), u"–"_s);
    }
    QVERIFY(bench.part<QPushButton>(u"channels.calibrate"_s) != nullptr);
}

void TestChannelsPanel::text_saysUnitAndRaw_data()
{
    QTest::addColumn<InputKind>("input");
    QTest::addColumn<int>("raw");
    QTest::addColumn<QString>("text");
    QTest::newRow("pulse") << InputKind::Rc << 3637 << u"1.455 ms (3637)"_s; // C-25
    QTest::newRow("1.5 ms") << InputKind::Rc << 3750 << u"1.500 ms (3750)"_s; // C-24
    QTest::newRow("no pulse") << InputKind::Rc << 0xFFFF << u"– no pulse"_s;
    QTest::newRow("volts") << InputKind::Analog << 493 << u"2.41 V (493)"_s; // C-26
    QTest::newRow("zero volts") << InputKind::Analog << 0 << u"0.00 V (0)"_s;
}

void TestChannelsPanel::text_saysUnitAndRaw()
{
    QFETCH(InputKind, input);
    QFETCH(int, raw);
    QFETCH(QString, text);
    ChannelBar bar(1);
    bar.setInput(input);
    bar.setRaw(raw);
    QCOMPARE(bar.text(), text);
    QVERIFY(bar.accessibleDescription().startsWith(text) || bar.isStale());
}

void TestChannelsPanel::invalid_isNeverAValue()
{
    // C-24
    ChannelBar bar(1);
    bar.resize(220, 30);
    bar.setStale(false);
    bar.setRaw(3750);
    QVERIFY(bar.isValid());
    QVERIFY(markerPlace(bar, theme::channelColour(1)) > 0.0);
    bar.setRaw(kInvalidPulse);
    QVERIFY(!bar.isValid());
    QCOMPARE(bar.property("raw").toInt(), 0xFFFF);
    QCOMPARE(markerPlace(bar, theme::channelColour(1)), -1.0);
    QVERIFY(!bar.text().contains(u"65535"));
}

void TestChannelsPanel::marker_standsAtTheValue()
{
    ChannelBar bar(2);
    bar.resize(400, 30);
    bar.setStale(false);
    const auto [low, high] = ChannelBar::scaleOf(InputKind::Rc);
    for (const double part : {0.1, 0.5, 0.9}) {
        bar.setRaw(low + int(part * (high - low)));
        const double place = markerPlace(bar, theme::channelColour(2));
        QVERIFY2(qAbs(place - part) < 0.02, qPrintable(QString::number(place)));
    }
}

void TestChannelsPanel::stale_looksStale()
{
    ChannelBar bar(1);
    bar.resize(220, 30);
    bar.setRaw(3750);
    bar.setStale(false);
    QVERIFY(markerPlace(bar, theme::channelColour(1)) > 0.0);
    bar.setStale(true);
    QVERIFY(!bar.isValid());
    QCOMPARE(markerPlace(bar, theme::channelColour(1)), -1.0);
    QVERIFY(markerPlace(bar, theme::colour(ColourRole::Stale)) > 0.0);
    QCOMPARE(bar.raw(), 3750); // the last value stays, marked
}

void TestChannelsPanel::calibration_isDrawn()
{
    ChannelBar bar(1);
    bar.resize(404, 30);
    bar.setStale(false);
    const QImage before = bar.grab().toImage();
    bar.setCalibration(Calibration{2500, 3750, 5000, 250});
    const QImage after = bar.grab().toImage();
    const auto x = [](int raw) { return 2 + qRound((raw - 1250) / 5000.0 * 400); };
    QCOMPARE(after.pixelColor(x(2000), 10), before.pixelColor(x(2000), 10)); // below the minimum
    QCOMPARE(after.pixelColor(x(3000), 10), theme::colour(ColourRole::Grid)); // in its range
    QCOMPARE(after.pixelColor(x(3600), 10), theme::colour(ColourRole::Border)); // in the deadband
    QVERIFY(after.pixelColor(x(3750), 10) != theme::colour(ColourRole::Border)); // neutral
    QVERIFY(bar.toolTip().contains(u"2500") && bar.toolTip().contains(u"±250"));
}

void TestChannelsPanel::panel_showsLiveChannels()
{
    Bench bench;
    QVERIFY(bench.connectTo(bench.scenario(
        R"({"channel":1,"wave":"hold","minimum":4375,"maximum":4375},{"channel":2,"wave":"missing"})")));
    QTRY_VERIFY_WITH_TIMEOUT(bench.bar(1)->isValid(), kLongMs);
    QVERIFY(bench.text(1).contains(u" ms ("));
    QTRY_VERIFY_WITH_TIMEOUT(bench.bar(1)->property("remapped").toInt() > 30, kLongMs);
    QTRY_COMPARE_WITH_TIMEOUT(bench.bar(2)->raw(), int(kInvalidPulse), kLongMs);
    QCOMPARE(bench.bar(2)->property("valid").toBool(), false);
    QVERIFY(bench.text(2).contains(u"no pulse"));
    QCOMPARE(bench.part<QLabel>(u"channels.2.remapped"_s)->text(), u"–"_s);
}

void TestChannelsPanel::panel_readsTheCalibration()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?mode=rc"_s));
    for (int channel = 1; channel <= kChannelCount; ++channel) { // C-32
        QTRY_VERIFY_WITH_TIMEOUT(bench.bar(channel)->toolTip().contains(u"neutral 3750"), kLongMs);
    }
}

void TestChannelsPanel::panel_turnsStaleWhenTheLinkCloses()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?mode=rc"_s));
    QTRY_VERIFY_WITH_TIMEOUT(
        bench.bar(1)->property("valid").toBool() || bench.bar(1)->raw() == kInvalidPulse, kLongMs);
    bench.controller.close();
    QTRY_VERIFY_WITH_TIMEOUT(bench.bar(1)->isStale(), kLongMs);
    QVERIFY(!bench.bar(1)->isValid());
}

void TestChannelsPanel::calibrate_isAsked()
{
    const Bench bench;
    QSignalSpy spy(&bench.panel, &Panel::panelRequested);
    QTest::mouseClick(bench.part<QPushButton>(u"channels.calibrate"_s), Qt::LeftButton);
    QCOMPARE(spy.size(), 1);
    QCOMPARE(spy.front().front().toString(), u"calibration"_s);
}

QTEST_MAIN(TestChannelsPanel)
#include "tst_channelspanel.moc"
