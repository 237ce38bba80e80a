// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/indicator.h"
#include "widgets/common/theme.h"

#include <QImage>
#include <QPixmap>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

/// The shape alone, without its colour: pixels that are not the background.
QImage silhouette(Indicator& indicator)
{
    const int size = indicator.fontMetrics().ascent() + 2;
    const QImage image = indicator.grab(QRect(0, 0, size, indicator.height())).toImage();
    QImage mask(image.size(), QImage::Format_Mono);
    mask.fill(0);
    const QColor background = image.pixelColor(image.width() - 1, 0);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            if (std::abs(pixel.lightness() - background.lightness()) > 40) {
                mask.setPixel(x, y, 1);
            }
        }
    }
    return mask;
}

} // namespace

class TestIndicator : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { theme::apply(theme::Choice::Light); }
    void startsUnknown();
    void propertiesAreThoseOfTheState();
    void statesDifferInShape();
    void stateIsSaidToScreenReaders();
    void longLabels_leaveRoomForTheCount();
};

void TestIndicator::startsUnknown()
{
    Indicator indicator(u"Motor 1 fault"_s, Indicator::Meaning::Fault);
    QVERIFY(indicator.property("stale").toBool());
    QVERIFY(!indicator.property("active").toBool());
    QCOMPARE(indicator.property("count").toInt(), 0);
    QCOMPARE(indicator.accessibleName(), u"Motor 1 fault"_s);
}

void TestIndicator::propertiesAreThoseOfTheState()
{
    Indicator indicator(u"CRC"_s, Indicator::Meaning::Warning);
    indicator.setState(true, 3, false);
    QVERIFY(indicator.property("active").toBool());
    QCOMPARE(indicator.property("count").toInt(), 3);
    QVERIFY(!indicator.property("stale").toBool());
}

void TestIndicator::statesDifferInShape()
{
    // Colour is never the only sign.
    QList<QImage> shapes;
    for (const auto meaning :
         {Indicator::Meaning::Ok, Indicator::Meaning::Warning, Indicator::Meaning::Fault}) {
        Indicator indicator(u"x"_s, meaning);
        indicator.resize(indicator.sizeHint());
        indicator.setState(true, 0, false);
        shapes << silhouette(indicator);
    }
    Indicator indicator(u"x"_s, Indicator::Meaning::Fault);
    indicator.resize(indicator.sizeHint());
    shapes << silhouette(indicator); // stale
    indicator.setState(false, 0, false);
    shapes << silhouette(indicator); // off
    for (qsizetype i = 0; i < shapes.size(); ++i) {
        for (qsizetype j = i + 1; j < shapes.size(); ++j) {
            QVERIFY2(shapes.at(i) != shapes.at(j), qPrintable(u"%1 and %2"_s.arg(i).arg(j)));
        }
    }
}

void TestIndicator::stateIsSaidToScreenReaders()
{
    Indicator indicator(u"CRC"_s, Indicator::Meaning::Warning);
    indicator.setState(true, 2, false);
    QVERIFY(indicator.accessibleDescription().contains(u"lit"_s));
    QVERIFY(indicator.accessibleDescription().contains(u'2'));
    indicator.setState(true, 2, true);
    QVERIFY(indicator.accessibleDescription().contains(u"not known"_s));
}

void TestIndicator::longLabels_leaveRoomForTheCount()
{
    Indicator indicator(u"A label that is far too long for the little space there is"_s,
                        Indicator::Meaning::Warning);
    indicator.resize(120, indicator.sizeHint().height());
    indicator.setState(true, 0, false);
    const QImage without = indicator.grab().toImage();
    indicator.setState(true, 42, false);
    QVERIFY(indicator.grab().toImage() != without);
    QVERIFY(indicator.minimumSizeHint().width() < indicator.sizeHint().width());
}

QTEST_MAIN(TestIndicator)
#include "tst_indicator.moc"
