// SPDX-License-Identifier: GPL-3.0-or-later
// Bars filled row by row look as the lines that they stand for.
#include "widgets/common/plotbars.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include <cmath>

using namespace trex;

namespace {

constexpr int kColumns = 200;

/// Bars side by side, from short ones to such as are as high as the picture, and one slanted line.
QList<QLineF> bars(double height, double ratio)
{
    QList<QLineF> lines;
    for (int i = 0; i < kColumns; ++i) {
        if (i % 50 == 49) {
            continue; // nothing known here
        }
        const double middle = 100.0 + 30.0 * std::sin(i * 0.05);
        const double x = 12.3 + (i + 0.5) / ratio;
        lines.append(QLineF(x, middle - height, x, middle + height));
    }
    lines.append(QLineF(20.0, 10.0, 100.0, 15.0));
    return lines;
}

/// First and last inked row of each column; −1: none.
std::vector<std::pair<int, int>> spansOf(const QImage& image)
{
    std::vector<std::pair<int, int>> spans(std::size_t(image.width()), {-1, -1});
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixel(x, y) != qRgb(255, 255, 255)) {
                auto& [first, last] = spans[std::size_t(x)];
                first = first < 0 ? y : first;
                last = y;
            }
        }
    }
    return spans;
}

template <class F>
QImage painted(double ratio, F&& paint)
{
    QImage image(QSize(260, 220) * int(ratio), QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.translate(3.0, 5.0);
    paint(painter);
    return image;
}

} // namespace

class tst_plotbars : public QObject {
    Q_OBJECT

private slots:
    void bars_coverWhatTheirLinesCover_data()
    {
        QTest::addColumn<double>("height");
        QTest::addColumn<double>("ratio");
        for (const double height : {1.0, 30.0, 65.0}) {
            for (const double ratio : {1.0, 2.0}) {
                QTest::addRow("%g high, at %g", height, ratio) << height << ratio;
            }
        }
    }
    void bars_coverWhatTheirLinesCover()
    {
        QFETCH(double, height);
        QFETCH(double, ratio);
        const QList<QLineF> lines = bars(height, ratio);
        const QColor colour(200, 80, 20, 190);
        const QImage plain = painted(ratio, [&](QPainter& painter) {
            QPen pen(colour, 1.0);
            pen.setCosmetic(true);
            pen.setCapStyle(Qt::FlatCap);
            painter.setPen(pen);
            painter.drawLines(lines);
        });
        PlotBars drawn;
        const QImage ours =
            painted(ratio, [&](QPainter& painter) { drawn.draw(painter, lines, colour); });
        const auto wanted = spansOf(plain);
        const auto seen = spansOf(ours);
        int inked = 0;
        for (std::size_t x = 0; x < wanted.size(); ++x) {
            const QByteArray where = QByteArray::number(qulonglong(x));
            QVERIFY2((wanted[x].first < 0) == (seen[x].first < 0), where);
            QVERIFY2(std::abs(wanted[x].first - seen[x].first) <= 1, where);
            QVERIFY2(std::abs(wanted[x].second - seen[x].second) <= 1, where);
            inked += seen[x].first >= 0 ? 1 : 0;
        }
        QVERIFY(inked >= kColumns - 4);
        // The colour is blended over what was there, not put in its place.
        const int middle = int((5.0 + 100.0) * ratio);
        const int left = int((3.0 + 12.3) * ratio) + 1;
        QCOMPARE(ours.pixelColor(left, middle), plain.pixelColor(left, middle));
    }

    void nothing_isDrawnOfNothing()
    {
        PlotBars drawn;
        const QImage image =
            painted(1.0, [&](QPainter& painter) { drawn.draw(painter, {}, Qt::red); });
        for (const auto& span : spansOf(image)) {
            QCOMPARE(span.first, -1);
        }
    }
};

QTEST_MAIN(tst_plotbars)
#include "tst_plotbars.moc"
