// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/restartevidence.h"

#include <QTest>

#include <random>

using namespace std::chrono_literals;
using namespace trex;

namespace {

constexpr MotorOrder kHalf{MotorOrder::Action::Set, 64};

/// Readings every 50 ms of virtual time.
class Readings {
public:
    /// True: a restart is told.
    bool next(int counts, bool isReplyLost = false, const MotorOrder& order = kHalf)
    {
        m_at += isReplyLost ? 350ms : 50ms;
        m_timeouts += isReplyLost ? 1 : 0;
        return m_evidence.take({m_at, {MotorOrder{}, order}, {0, counts}, m_timeouts}) == 1U;
    }
    bool next(int times, int counts)
    {
        bool isTold = false;
        for (int i = 0; i < times; ++i) {
            isTold = next(counts) || isTold;
        }
        return isTold;
    }
    void forget() { m_evidence.forget(m_timeouts); }

private:
    RestartEvidence m_evidence;
    Instant m_at{};
    quint64 m_timeouts = 0;
};

} // namespace

class TestRestartEvidence : public QObject {
    Q_OBJECT

private slots:
    void lostReplyAndCurrentGone_tell_data()
    {
        QTest::addColumn<int>("counts");
        QTest::addColumn<int>("readings");
        QTest::addColumn<bool>("isTold");
        QTest::addRow("a current") << 12 << 5 << true;
        QTest::addRow("a small motor: one count, but steadily") << 1 << 70 << true;
        QTest::addRow("one count, for a moment") << 1 << 5 << false;
        QTest::addRow("an inrush of two readings") << 40 << 2 << false;
    }
    void lostReplyAndCurrentGone_tell()
    {
        QFETCH(const int, counts);
        QFETCH(const int, readings);
        QFETCH(const bool, isTold);
        Readings line;
        QVERIFY(!line.next(readings, counts));
        QVERIFY(!line.next(0, true));
        QCOMPARE(line.next(10, 0), isTold);
    }

    void eitherAlone_tellsNothing()
    {
        Readings line;
        QVERIFY(!line.next(40, 12));
        QVERIFY(!line.next(12, true));
        QVERIFY(!line.next(40, 12));
        QVERIFY(!line.next(40, 0)); // the load drives it
        QVERIFY(!line.next(40, 12));
        QVERIFY(!line.next(12, true));
        QVERIFY(!line.next(10, 12));
        QVERIFY(!line.next(40, 0)); // half a second later: another matter
    }

    void shortDip_tellsNothing()
    {
        Readings line;
        QVERIFY(!line.next(40, 12));
        QVERIFY(!line.next(0, true));
        QVERIFY(!line.next(3, 0));
        QVERIFY(!line.next(40, 12));
    }

    void newOrder_beginsAnew()
    {
        Readings line;
        QVERIFY(!line.next(40, 12));
        QVERIFY(!line.next(0, true, {MotorOrder::Action::Set, 0}));
        QVERIFY(!line.next(0, false, {MotorOrder::Action::Brake, 127}));
        QVERIFY(!line.next(0, false, {MotorOrder::Action::Set, 10}));
        QVERIFY(!line.next(20, 0)); // driven again, but it has drawn nothing yet
        QVERIFY(!line.next(40, 12));
        line.forget(); // disarmed, armed again
        QVERIFY(!line.next(0, true));
        QVERIFY(!line.next(20, 0));
    }

    /// A motor at the edge of what the controller can measure, on a line that loses replies: a day.
    void noise_isNoRestart_data()
    {
        QTest::addColumn<double>("aboveZero");
        QTest::addRow("seldom above zero") << 0.2;
        QTest::addRow("half") << 0.5;
        QTest::addRow("mostly") << 0.8;
        QTest::addRow("nearly always") << 0.9;
    }
    void noise_isNoRestart()
    {
        QFETCH(const double, aboveZero);
        std::mt19937 random(4711);
        std::bernoulli_distribution isAbove(aboveZero);
        std::bernoulli_distribution isLost(0.02);
        Readings line;
        for (int i = 0; i < 1'728'000; ++i) { // 24 h at 20 a second
            QVERIFY(!line.next(isAbove(random) ? 1 : 0, isLost(random)));
        }
    }
};

QTEST_APPLESS_MAIN(TestRestartEvidence)
#include "tst_restartevidence.moc"
