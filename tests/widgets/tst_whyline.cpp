// SPDX-License-Identifier: GPL-3.0-or-later
// The why-line over a real façade: what it says of a stop, and that its button is the next thing to
// do. The sentences themselves: tst_motionreason.
#include "tests/support/panelbench.h"
#include "widgets/common/whyline.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

using Bench = test::PanelBench<WhyLine>;

class TestWhyLine : public QObject {
    Q_OBJECT

private slots:
    void stop_isToldWithItsRecords_andNotDoubtedLater()
    {
        Bench bench;
        QVERIFY(bench.panel.text().startsWith(u"Not connected"_s));
        bench.controller.stop(); // as Esc does it, with nobody there
        QVERIFY(bench.panel.text().startsWith(u"Not connected"_s));
        QVERIFY(bench.connectTo(u"sim:"_s));
        QTRY_VERIFY(bench.panel.text().startsWith(u"Stopped"_s)
                    || bench.panel.text().startsWith(u"Disarmed"_s));
        QTRY_VERIFY(bench.part<QPushButton>(u"why.remedy"_s)->isEnabled());
        bench.part<QPushButton>(u"why.remedy"_s)->click();
        QVERIFY(bench.controller.isArmed());
        bench.controller.stop();
        QVERIFY(bench.panel.text().startsWith(u"Stopping"_s));
        QTRY_VERIFY(bench.panel.text().startsWith(u"Stopped"_s));
        QVERIFY(!bench.part<QPushButton>(u"why.remedy"_s)->isEnabled()); // the lock-out
        QTRY_VERIFY(bench.part<QPushButton>(u"why.remedy"_s)->isEnabled());
    }

    void stop_thatFails_isDoubtedUntilTheLineIsBack()
    {
        Bench bench;
        QVERIFY(bench.connectTo(u"sim:?fault=hangup-after=1&fault=hangup-for=3"_s));
        QVERIFY(bench.controller.arm().has_value());
        QTRY_VERIFY_WITH_TIMEOUT(bench.controller.state() != LinkState::Connected, 10'000);
        bench.controller.stop();
        QTRY_VERIFY(bench.panel.text().contains(u"NOT be confirmed"_s));
        QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Connected, 15'000);
        QTRY_VERIFY(bench.panel.text().startsWith(u"Disarmed: the link was lost"_s));
    }

    void fault_opensThePanelThatTells()
    {
        Bench bench;
        QSignalSpy wanted(&bench.panel, &WhyLine::panelRequested);
        QVERIFY(bench.connectTo(u"sim:?mode=rc"_s));
        QTRY_VERIFY(bench.panel.text().contains(u"channels"_s));
        bench.part<QPushButton>(u"why.remedy"_s)->click();
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.first().first().toString(), u"channels"_s);
    }
};

QTEST_MAIN(TestWhyLine)
#include "tst_whyline.moc"
