// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/panelbench.h"
#include "widgets/health/advicelist.h"
#include "widgets/health/healthpanel.h"
#include "widgets/health/latencyview.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSplitter>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

constexpr int kLongMs = 20'000;

void wantAll(Controller& controller, const QObject* who)
{
    for (const PollRow& row : kPolls) {
        controller.want(who, row.id, row.hertz);
    }
}

} // namespace

class TestHealthPanel : public QObject {
    Q_OBJECT

private slots:
    void unconnected_saysSo()
    {
        test::PanelBench<HealthPanel> bench;
        auto* advice = bench.part<AdviceList>(u"health.advice"_s);
        QCOMPARE(advice->kinds(), u"notConnected"_s);
        QCOMPARE(bench.part<LatencyView>(u"health.histogram"_s)->answers(), 0);
        QCOMPARE(bench.part<QLabel>(u"health.median"_s)->text(), u"–"_s);
        QCOMPARE(bench.part<QLabel>(u"health.echo"_s)->text(), u"–"_s);
        QSignalSpy asked(&bench.panel, &Panel::panelRequested);
        bench.part<QPushButton>(u"health.advice.1.go"_s)->click();
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked.front().front().toString(), u"connection"_s);
    }

    void noisyLine_advisesCrc_andTheButtonGoesThere()
    {
        test::PanelBench<HealthPanel> bench;
        wantAll(bench.controller, this);
        QVERIFY(bench.connectTo(u"sim:?fault=garbage=3"_s));
        auto* advice = bench.part<AdviceList>(u"health.advice"_s);
        QTRY_VERIFY_WITH_TIMEOUT(advice->kinds().contains(u"damagedWithoutCrc"_s), kLongMs);
        const qsizetype place = advice->kinds().split(u',').indexOf(u"damagedWithoutCrc"_s) + 1;
        const QString name = u"health.advice.%1"_s.arg(place);
        QVERIFY(bench.part<QLabel>(name + u".text"_s)->text().contains(u"CRC-7"_s));
        auto* go = bench.part<QPushButton>(name + u".go"_s);
        QCOMPARE(go->text(), u"Go to Parameters"_s);
        QSignalSpy asked(&bench.panel, &Panel::panelRequested);
        go->click();
        QCOMPARE(asked.front().front().toString(), u"parameters/parameters.uart-settings.editor"_s);
        QVERIFY(bench.part<QLabel>(u"health.badReplies"_s)->text().toInt() > 0);
    }

    void figures_areCountedAnew_andCopied()
    {
        test::PanelBench<HealthPanel> bench;
        wantAll(bench.controller, this);
        QVERIFY(bench.connectTo(u"sim:"_s));
        auto* view = bench.part<LatencyView>(u"health.histogram"_s);
        QTRY_VERIFY_WITH_TIMEOUT(view->answers() > 200, kLongMs);
        QVERIFY(view->medianMs() > 1.0); // two bytes at 19200 baud at the very least
        QVERIFY(view->accessibleDescription().contains(u"answers"_s));
        bench.part<QPushButton>(u"health.copy"_s)->click();
        const QString text = QGuiApplication::clipboard()->text();
        QVERIFY(text.contains(u"Wire alone"_s));
        QVERIFY(text.contains(u"19200 baud"_s));
        bench.part<QPushButton>(u"health.reset"_s)->click();
        QCOMPARE(view->answers(), 0);
        QCOMPARE(bench.part<QLabel>(u"health.retries.total"_s)->text(), u"0"_s);
        QTRY_VERIFY_WITH_TIMEOUT(view->answers() > 10, kLongMs);
    }

    void rows_stayWhileTheKindsDo()
    {
        AdviceList list;
        LinkAdvice one{
            .kind = LinkAdviceKind::NoAnswers, .sentence = u"1 of 2"_s, .panel = "connection"_L1};
        list.show({one});
        const auto* button = list.findChild<QPushButton*>(u"health.advice.1.go"_s);
        one.sentence = u"2 of 3"_s;
        list.show({one});
        QCOMPARE(list.findChild<QPushButton*>(u"health.advice.1.go"_s), button);
        QCOMPARE(list.findChild<QLabel*>(u"health.advice.1.text"_s)->text(), u"2 of 3"_s);
    }

    void command_isCopied()
    {
        AdviceList list;
        list.show({LinkAdvice{
            .kind = LinkAdviceKind::LatencyTimer, .sentence = u"slow"_s, .command = u"echo 1"_s}});
        list.findChild<QPushButton*>(u"health.advice.1.go"_s)->click();
        QCOMPARE(QGuiApplication::clipboard()->text(), u"echo 1"_s);
    }

    void narrowPanel_standsUpright()
    {
        test::PanelBench<HealthPanel> bench;
        bench.panel.resize(900, 400);
        auto* splitter = bench.panel.findChild<QSplitter*>();
        QTRY_COMPARE(splitter->orientation(), Qt::Horizontal);
        bench.panel.resize(320, 700);
        QTRY_COMPARE(splitter->orientation(), Qt::Vertical);
    }
};

QTEST_MAIN(TestHealthPanel)
#include "tst_healthpanel.moc"
