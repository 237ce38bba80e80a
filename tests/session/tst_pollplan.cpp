// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/pollplan.h"

#include <QTest>

using namespace trex;
using namespace std::chrono_literals;

namespace {

constexpr PollWishes kEverything{80.0, 50.0, 50.0, 10.0, 10.0, 0.0, 0.0, 0.0};

/// How often each poll was sent in `duration` when each occupies the line for its cost.
std::array<int, kPollCount> play(PollPlan& plan, Duration duration)
{
    std::array<int, kPollCount> counts{};
    Instant now{1h};
    plan.restart(now);
    const Instant end = now + duration;
    while (now < end) {
        if (const auto due = plan.due(now)) {
            ++counts.at(static_cast<std::size_t>(*due));
            plan.sent(*due, now);
            now += plan.cost(*due);
        } else {
            now = std::min(end, plan.nextDue().value_or(end));
        }
    }
    return counts;
}

} // namespace

class TestPollPlan : public QObject {
    Q_OBJECT

private slots:
    void allStreamsAtDefaultBaud_runAtTheirRates()
    {
        PollPlan plan;
        plan.setLine({});
        plan.setWishes(kEverything, {});
        QCOMPARE(plan.scale(), 1.0);
        const auto counts = play(plan, 10s);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            QVERIFY2(std::abs(counts.at(i) - kEverything.at(i) * 10) <= 2.0,
                     qPrintable(QStringLiteral("poll %1: %2").arg(i).arg(counts.at(i))));
        }
    }

    void slowLine_everyStreamSlowsInProportion()
    {
        LineSettings line;
        line.baud = 2400;
        PollPlan plan;
        plan.setLine(line);
        plan.setWishes(kEverything, {});
        QVERIFY(plan.scale() < 0.5);
        const auto counts = play(plan, 60s);
        for (std::size_t i = 0; i < 5; ++i) {
            const double share = counts.at(i) / (kEverything.at(i) * 60.0);
            QVERIFY2(std::abs(share - plan.scale()) < 0.15 * plan.scale(),
                     qPrintable(
                         QStringLiteral("poll %1: %2 of %3").arg(i).arg(share).arg(plan.scale())));
        }
    }

    void nothingWanted_nothingDue()
    {
        PollPlan plan;
        plan.setLine({});
        plan.restart(Instant(1h));
        QVERIFY(!plan.due(Instant(2h)));
        QVERIFY(!plan.nextDue());
    }

    void afterAPause_nothingIsCaughtUp()
    {
        PollPlan plan;
        plan.setLine({});
        PollWishes wishes{};
        wishes.at(0) = 10.0;
        plan.setWishes(wishes, Instant(1h));
        Instant now(2h); // an hour late
        int sent = 0;
        for (; sent < 10 && plan.due(now); ++sent) {
            plan.sent(PollId::Currents, now);
        }
        QVERIFY2(sent <= 3, qPrintable(QString::number(sent)));
    }

    void responseDelay_isCountedIntoTheLoad()
    {
        PollPlan plan;
        plan.setLine({});
        plan.setWishes(kEverything, {});
        plan.setOverhead(5ms); // a slow adapter
        QVERIFY(plan.scale() < 0.8);
    }
};

QTEST_APPLESS_MAIN(TestPollPlan)
#include "tst_pollplan.moc"
