// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/marktrack.h"

#include <QTest>

using namespace trex;
using namespace std::chrono_literals;

namespace {

const Instant kStart{1000s};

} // namespace

class TestMarkTrack : public QObject {
    Q_OBJECT

private slots:
    void lateMark_isPutWhereItsTimeBelongs()
    {
        MarkTrack track;
        track.append({kStart + 1s, MarkKind::Armed, {}});
        track.append({kStart + 3s, MarkKind::Stop, {}});
        track.append({kStart + 2s, MarkKind::Fault, {}});
        QCOMPARE(track.marks().size(), std::size_t(3));
        QCOMPARE(track.marks()[1].kind, MarkKind::Fault);
        QCOMPARE(track.revision(), quint64(3));
    }
    void sameTime_keepsTheOrderOfTelling()
    {
        MarkTrack track;
        track.append({kStart, MarkKind::Disarmed, {}});
        track.append({kStart, MarkKind::Stop, {}});
        QCOMPARE(track.marks()[0].kind, MarkKind::Disarmed);
        QCOMPARE(track.marks()[1].kind, MarkKind::Stop);
    }
    void neighbours_areStrictlyLaterAndEarlier()
    {
        MarkTrack track;
        QVERIFY(track.after(kStart) == nullptr);
        QVERIFY(track.before(kStart) == nullptr);
        for (int i = 0; i < 5; ++i) {
            track.append({kStart + i * 10s, MarkKind::Note, QString::number(i)});
        }
        QCOMPARE(track.after(kStart + 10s)->text, QStringLiteral("2"));
        QCOMPARE(track.before(kStart + 10s)->text, QStringLiteral("0"));
        QCOMPARE(track.after(kStart + 9s)->text, QStringLiteral("1"));
        QVERIFY(track.after(kStart + 40s) == nullptr);
        QVERIFY(track.before(kStart) == nullptr);
        QCOMPARE(track.lowerBound(kStart + 11s), std::size_t(2));
        QCOMPARE(track.lowerBound(kStart + 10s), std::size_t(1));
    }
    void kinds_haveKeysThatReadBack()
    {
        for (const MarkRow& row : markRows()) {
            QCOMPARE(markKind(row.key), std::optional(row.kind));
            QVERIFY(row.title != nullptr && *row.title != '\0');
        }
        QVERIFY(!markKind("no-such-kind"));
    }
    void text_isTheKindsTitleWhereThereIsNone()
    {
        QCOMPARE(markText({kStart, MarkKind::Stop, {}}), QStringLiteral("Stop"));
        QCOMPARE(markText({kStart, MarkKind::Stop, QStringLiteral("by hand")}),
                 QStringLiteral("by hand"));
    }
};

QTEST_GUILESS_MAIN(TestMarkTrack)
#include "tst_marktrack.moc"
