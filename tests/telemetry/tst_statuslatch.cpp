// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/replies.h"
#include "protocol/telemetry/statuslatch.h"

#include <QSignalSpy>
#include <QTest>

using namespace trex;

namespace {

using Byte = StatusLatch::Byte;
constexpr int kFault1 = 4; // bit of statusbit::kMotor1Fault
constexpr int kTimeout = 7; // bit of uartbit::kTimeout
const Instant kNow{std::chrono::seconds(100)};

} // namespace

class TestStatusLatch : public QObject {
    Q_OBJECT

private slots:
    void bitThatWasReadOnce_staysInTheHistory() // C-22
    {
        StatusLatch latch;
        const QDateTime before = QDateTime::currentDateTime();
        latch.record(Byte::Status, statusbit::kMotor1Fault, kNow);
        latch.record(Byte::Status, 0, kNow); // reading has cleared it in the controller
        const auto& entry = latch.entry(Byte::Status, kFault1);
        QVERIFY(!entry.lit);
        QCOMPARE(entry.count, 1);
        QVERIFY(entry.firstSeen >= before);
        QCOMPARE(entry.lastSeen, entry.firstSeen);
    }

    void eachRead_countsEachBit_data()
    {
        QTest::addColumn<int>("byte");
        QTest::newRow("status") << int(Byte::Status);
        QTest::newRow("uart") << int(Byte::Uart);
    }
    void eachRead_countsEachBit() // C-20 C-21 C-22
    {
        QFETCH(int, byte);
        const auto which = static_cast<Byte>(byte);
        const auto other = which == Byte::Status ? Byte::Uart : Byte::Status;
        StatusLatch latch;
        for (int value = 0; value < 256; ++value) {
            latch.record(which, static_cast<std::uint8_t>(value), kNow);
        }
        for (int bit = 0; bit < 8; ++bit) {
            QCOMPARE(latch.entry(which, bit).count, 128);
            QVERIFY(latch.entry(which, bit).lit); // 0xFF came last
            QCOMPARE(latch.entry(other, bit).count, 0);
            QVERIFY(!latch.entry(other, bit).firstSeen.isValid());
        }
        QVERIFY(latch.lastRead(which).has_value());
        QVERIFY(!latch.lastRead(other).has_value());
    }

    void firstSeen_staysAndLastSeenMoves()
    {
        StatusLatch latch;
        latch.record(Byte::Uart, uartbit::kTimeout, kNow);
        const QDateTime first = latch.entry(Byte::Uart, kTimeout).firstSeen;
        QTRY_VERIFY(QDateTime::currentDateTime() > first);
        latch.record(Byte::Uart, uartbit::kTimeout, kNow);
        QCOMPARE(latch.entry(Byte::Uart, kTimeout).firstSeen, first);
        QVERIFY(latch.entry(Byte::Uart, kTimeout).lastSeen > first);
        QCOMPARE(latch.entry(Byte::Uart, kTimeout).count, 2);
    }

    void lostLink_forgetsWhatIsLitButNotWhatWas()
    {
        StatusLatch latch;
        latch.record(Byte::Status, statusbit::kMotor1Fault, kNow);
        QCOMPARE(latch.lastRead(Byte::Status), std::optional(kNow));
        QSignalSpy changed(&latch, &StatusLatch::changed);
        latch.linkLost();
        QCOMPARE(changed.count(), 1);
        QVERIFY(!latch.lastRead(Byte::Status).has_value());
        QCOMPARE(latch.entry(Byte::Status, kFault1).count, 1);
    }

    void clear_forgetsCountsNotWhatIsLit()
    {
        StatusLatch latch;
        latch.record(Byte::Status, statusbit::kMotor1Fault, kNow);
        latch.clear();
        QCOMPARE(latch.entry(Byte::Status, kFault1).count, 0);
        QVERIFY(!latch.entry(Byte::Status, kFault1).firstSeen.isValid());
        QVERIFY(latch.entry(Byte::Status, kFault1).lit);
        QVERIFY(latch.lastRead(Byte::Status).has_value());
    }
};

QTEST_APPLESS_MAIN(TestStatusLatch)
#include "tst_statuslatch.moc"
