// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/theme.h"

#include <QApplication>
#include <QDir>
#include <QFontMetricsF>
#include <QSignalSpy>
#include <QTest>
#include <QWidget>

#include <cmath>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

/// Relative luminance and contrast as WCAG 2 defines them.
double luminance(const QColor& colour)
{
    const auto linear = [](double part) {
        return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF())
        + 0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b)
{
    const double light = std::max(luminance(a), luminance(b));
    const double dark = std::min(luminance(a), luminance(b));
    return (light + 0.05) / (dark + 0.05);
}

struct PaletteWatcher : QWidget {
    int changes = 0;
    void changeEvent(QEvent* event) override
    {
        changes += event->type() == QEvent::PaletteChange ? 1 : 0;
        QWidget::changeEvent(event);
    }
};

} // namespace

class TestTheme : public QObject {
    Q_OBJECT

private slots:
    void cleanupTestCase() { theme::apply(theme::Choice::Light); }
    void rolesAreReadable_data();
    void rolesAreReadable();
    void channelColoursDiffer();
    void choice_isInForceAtOnce();
    void system_followsTheDesktopAfterAChoice();
    void widgetsAreTold();
    void fontSteps_scaleTheDesktopsFont();
    void tabularDigits_haveOneWidth();
    void icon_hasTheColourOfItsRoleInTheThemeInForce();
    void icon_isSharpOnDenseScreens();
    void everyIconFile_isDrawn();
};

void TestTheme::rolesAreReadable_data()
{
    QTest::addColumn<theme::Choice>("choice");
    QTest::addColumn<ColourRole>("role");
    QTest::addColumn<ColourRole>("background");
    for (const auto choice : {theme::Choice::Light, theme::Choice::Dark}) {
        for (const auto role :
             {ColourRole::Text, ColourRole::DimText, ColourRole::Motor1, ColourRole::Motor2,
              ColourRole::Aux, ColourRole::Ok, ColourRole::Warning, ColourRole::Fault,
              ColourRole::Stale, ColourRole::Accent}) {
            QTest::addRow("%d on panel, theme %d", static_cast<int>(role), static_cast<int>(choice))
                << choice << role << ColourRole::Panel;
        }
        QTest::addRow("text on STOP, theme %d", static_cast<int>(choice))
            << choice << ColourRole::OnFault << ColourRole::Fault;
    }
}

void TestTheme::rolesAreReadable()
{
    QFETCH(theme::Choice, choice);
    QFETCH(ColourRole, role);
    QFETCH(ColourRole, background);
    theme::apply(choice);
    QVERIFY(contrast(theme::colour(role), theme::colour(background)) >= 4.45);
}

void TestTheme::channelColoursDiffer()
{
    for (const auto choice : {theme::Choice::Light, theme::Choice::Dark}) {
        theme::apply(choice);
        QSet<QRgb> colours;
        for (int channel = 1; channel <= 5; ++channel) {
            colours.insert(theme::channelColour(channel).rgb());
            QVERIFY(contrast(theme::channelColour(channel), theme::colour(ColourRole::Panel))
                    >= 4.45);
        }
        QCOMPARE(colours.size(), 5);
    }
}

void TestTheme::choice_isInForceAtOnce()
{
    theme::apply(theme::Choice::Dark);
    QVERIFY(theme::isDark());
    QCOMPARE(QApplication::palette().color(QPalette::Base), theme::colour(ColourRole::Panel));
    QCOMPARE(theme::colour(ColourRole::Text), QColor(0xE6, 0xEA, 0xEF));
    theme::apply(theme::Choice::Light);
    QVERIFY(!theme::isDark());
    QCOMPARE(theme::colour(ColourRole::Text), QColor(0x1F, 0x23, 0x28));
}

void TestTheme::system_followsTheDesktopAfterAChoice()
{
    // The offscreen platform has a light palette: after dark, the system's choice is light again.
    theme::apply(theme::Choice::Dark);
    theme::apply(theme::Choice::System);
    QVERIFY(!theme::isDark());
}

void TestTheme::widgetsAreTold()
{
    theme::apply(theme::Choice::Light);
    PaletteWatcher widget;
    widget.show();
    QCoreApplication::sendPostedEvents();
    const int before = widget.changes;
    theme::apply(theme::Choice::Dark);
    QCoreApplication::sendPostedEvents();
    QVERIFY(widget.changes > before);
    QCOMPARE(widget.palette().color(QPalette::WindowText), theme::colour(ColourRole::Text));
}

void TestTheme::fontSteps_scaleTheDesktopsFont()
{
    const double body = theme::font(1).pointSizeF();
    QCOMPARE(body, QApplication::font().pointSizeF());
    QCOMPARE(theme::font(2).pointSizeF(), 2 * body);
    QCOMPARE(theme::font(1.25).pointSizeF(), 1.25 * body);
}

void TestTheme::tabularDigits_haveOneWidth()
{
    const QFontMetricsF metrics(theme::font(2, true));
    const double width = metrics.horizontalAdvance(u'0');
    for (char16_t digit = u'1'; digit <= u'9'; ++digit) {
        QVERIFY(std::abs(metrics.horizontalAdvance(digit) - width) < 0.05);
    }
}

void TestTheme::icon_hasTheColourOfItsRoleInTheThemeInForce()
{
    const QIcon icon = theme::icon(u"stop"_s, ColourRole::Fault);
    for (const auto choice : {theme::Choice::Light, theme::Choice::Dark, theme::Choice::Light}) {
        theme::apply(choice);
        const QImage image = icon.pixmap(QSize(64, 64), 1.0).toImage();
        bool found = false;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor pixel = image.pixelColor(x, y);
                found =
                    found || (pixel.alpha() == 255 && pixel == theme::colour(ColourRole::Fault));
            }
        }
        QVERIFY(found);
    }
}

void TestTheme::icon_isSharpOnDenseScreens()
{
    const QPixmap pixmap = theme::icon(u"stop"_s).pixmap(QSize(20, 20), 2.0);
    QCOMPARE(pixmap.size(), QSize(40, 40));
    QCOMPARE(pixmap.devicePixelRatio(), 2.0);
}

void TestTheme::everyIconFile_isDrawn()
{
    const QStringList files = QDir(u":/icons"_s).entryList({u"*.svg"_s});
    QVERIFY(files.size() > 10);
    for (const QString& file : files) {
        const QImage image = theme::icon(file.chopped(4)).pixmap(QSize(24, 24), 1.0).toImage();
        bool isEmpty = true;
        for (int y = 0; y < image.height() && isEmpty; ++y) {
            for (int x = 0; x < image.width() && isEmpty; ++x) {
                isEmpty = qAlpha(image.pixel(x, y)) == 0;
            }
        }
        QVERIFY2(!isEmpty, qPrintable(file));
    }
}

QTEST_MAIN(TestTheme)
#include "tst_theme.moc"
