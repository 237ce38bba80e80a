// SPDX-License-Identifier: GPL-3.0-or-later
// Every advice about the line, from the figures that bear it out, and not from those just below.
#include "protocol/session/linkadvice.h"

#include <QSet>
#include <QTest>

#include <functional>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

using Kind = LinkAdviceKind;
using Look = LinkAdvice::Look;

/// A minute at 19200 baud without a fault: answers in 4.1 ms, of which the wire needs 3.6.
LinkFacts well(int answers = 3000)
{
    LinkFacts facts;
    facts.state = LinkState::Connected;
    HealthCounts& recent = facts.health.recent;
    recent.covered = 45s;
    recent.transactions = recent.replies = static_cast<quint64>(answers);
    for (int i = 0; i < answers; ++i) {
        recent.addReply(4100us, 3600us);
    }
    facts.health.total = recent;
    facts.health.now.covered = 1s;
    facts.health.now.wire = 400ms;
    return facts;
}

LinkFacts with(void (*change)(LinkFacts&))
{
    LinkFacts facts = well();
    change(facts);
    return facts;
}

template <std::uint8_t bit>
LinkFacts withUart()
{
    LinkFacts facts = well();
    for (int i = 0; i < 4; ++i) {
        facts.health.recent.addUartErrors(bit);
    }
    return facts;
}

LinkFacts heldBack(Duration extra)
{
    LinkFacts facts = well(0);
    facts.health.recent.replies = 500;
    for (int i = 0; i < 500; ++i) {
        facts.health.recent.addReply(3600us + extra, 3600us);
    }
    return facts;
}

struct Row {
    const char* name;
    Kind kind;
    Look look;
    const char* part; ///< of the sentence
    const char* control; ///< "panel/control"
    std::function<LinkFacts()> facts;
};

const std::array kRows{
    Row{"not connected", Kind::NotConnected, Look::Off, "nothing to judge", "connection/",
        [] { return with([](LinkFacts& f) { f.state = LinkState::Lost; }); }},
    Row{"too early", Kind::TooEarly, Look::Off, "49 of at least 50", "/", [] { return well(49); }},
    Row{"line lost", Kind::LineLost, Look::Warning, "began: 2.", "log/",
        [] { return with([](LinkFacts& f) { f.health.total.losses = 2; }); }},
    Row{"foreign traffic", Kind::ForeignTraffic, Look::Fault,
        "3 times in the last minute (6 bytes)", "connection/connection.protocol",
        [] {
            return with([](LinkFacts& f) {
                f.health.recent.unaskedBursts = 3;
                f.health.recent.unaskedBytes = 6;
            });
        }},
    Row{"damaged, no CRC", Kind::DamagedWithoutCrc, Look::Fault,
        "30 of 3030 answers came damaged in the last minute (1.0 %)",
        "parameters/parameters.uart-settings.editor",
        [] { return with([](LinkFacts& f) { f.health.recent.badReplies = 30; }); }},
    Row{"broken off, no CRC", Kind::DamagedWithoutCrc, Look::Fault, "CRC-7",
        "parameters/parameters.uart-settings.editor",
        [] { return with([](LinkFacts& f) { f.health.recent.shortReplies = 4; }); }},
    Row{"damaged, CRC", Kind::DamagedDespiteCrc, Look::Warning, "CRC-7 found them",
        "parameters/parameters.uart-settings.editor",
        [] {
            return with([](LinkFacts& f) {
                f.line.errorDetection = ErrorDetection::Crc7;
                f.health.recent.crcErrors = 30;
            });
        }},
    Row{"no answers", Kind::NoAnswers, Look::Warning,
        "30 of 3030 questions got no answer within 100 ms", "connection/connection.timeout",
        [] { return with([](LinkFacts& f) { f.health.recent.timeouts = 30; }); }},
    Row{"frame", Kind::ControllerFrame, Look::Warning, "4 times", "connection/connection.baud",
        withUart<uartbit::kFrame>},
    Row{"parity", Kind::ControllerFrame, Look::Warning, "parity", "connection/connection.baud",
        withUart<uartbit::kParity>},
    Row{"overrun", Kind::ControllerOverrun, Look::Warning, "stop bits",
        "parameters/parameters.uart-settings.editor", withUart<uartbit::kOverrun>},
    Row{"read buffer", Kind::ControllerOverrun, Look::Warning, "4 times",
        "parameters/parameters.uart-settings.editor", withUart<uartbit::kReadBufferOverrun>},
    Row{"format", Kind::ControllerFormat, Look::Warning, "4 times", "packets/",
        withUart<uartbit::kFormat>},
    Row{"CRC at the controller", Kind::ControllerFormat, Look::Warning, "CRC was wrong", "packets/",
        withUart<uartbit::kCrc>},
    Row{"send buffer", Kind::ControllerSendBuffer, Look::Warning, "another master", "status/",
        withUart<uartbit::kSendBufferOverrun>},
    Row{"serial timeout", Kind::ControllerTimeout, Look::Warning, "serial timeout passed 4 times",
        "parameters/parameters.serial-timeout.editor", withUart<uartbit::kTimeout>},
    Row{"late", Kind::LateAnswers, Look::Warning,
        "after the 100 ms that are waited for them, 5 times", "connection/connection.timeout",
        [] {
            return with([](LinkFacts& f) {
                f.health.recent.lateReplies = 5;
                f.health.patience = 200ms;
            });
        }},
    Row{"latency timer", Kind::LatencyTimer, Look::Warning, "up to 16 ms", "/",
        [] {
            LinkFacts facts = heldBack(15ms);
            facts.health.adapter = {.kind = AdapterFacts::Kind::Serial,
                                    .lowLatency = AdapterFacts::LowLatency::Refused,
                                    .port = u"ttyUSB0"_s,
                                    .driver = u"ftdi_sio"_s,
                                    .latencyTimerMs = 16,
                                    .timerFile = u"/sys/x/latency_timer"_s};
            return facts;
        }},
    Row{"held back", Kind::HeldBack, Look::Warning, "(inferred)", "/",
        [] { return heldBack(12ms); }},
    Row{"line too slow", Kind::LineTooSlow, Look::Warning, "Set 38400 baud",
        "parameters/parameters.uart-settings.editor",
        [] {
            return with([](LinkFacts& f) {
                f.stats.pollScale = 0.6;
                f.health.now.wire = 930ms;
            });
        }},
    Row{"waiting too long", Kind::WaitingTooLong, Look::Warning, "60 % of the rates", "/",
        [] { return with([](LinkFacts& f) { f.stats.pollScale = 0.6; }); }},
    Row{"full at the highest rate", Kind::WaitingTooLong, Look::Warning, "busy 95 %", "/",
        [] {
            return with([](LinkFacts& f) {
                f.line.baud = 115200;
                f.stats.pollScale = 0.6;
                f.health.now.wire = 950ms;
            });
        }},
    Row{"echo", Kind::Echo, Look::Note, "dropped", "connection/connection.echo",
        [] { return with([](LinkFacts& f) { f.stats.echo = true; }); }},
    Row{"well", Kind::Well, Look::Ok, "3000 answers in the last minute, 0 damaged or missing", "/",
        [] { return well(); }},
};

bool has(const std::vector<LinkAdvice>& advice, Kind kind)
{
    return std::any_of(advice.begin(), advice.end(),
                       [kind](const LinkAdvice& a) { return a.kind == kind; });
}

} // namespace

class TestLinkAdvice : public QObject {
    Q_OBJECT

private slots:
    void advice_isGivenFromItsFigures_data()
    {
        QTest::addColumn<int>("row");
        for (std::size_t i = 0; i < kRows.size(); ++i) {
            QTest::newRow(kRows.at(i).name) << static_cast<int>(i);
        }
    }
    void advice_isGivenFromItsFigures()
    {
        QFETCH(int, row);
        const Row& wanted = kRows.at(static_cast<std::size_t>(row));
        const std::vector<LinkAdvice> advice = linkAdvice(wanted.facts());
        const bool isNote = wanted.look == Look::Note;
        QCOMPARE(advice.size(), isNote ? std::size_t{2} : std::size_t{1}); // and nothing else
        const LinkAdvice& found = advice.front();
        QCOMPARE(keyOf(found.kind), keyOf(wanted.kind));
        QCOMPARE(found.look, wanted.look);
        QVERIFY2(found.sentence.contains(QLatin1StringView(wanted.part)),
                 qPrintable(found.sentence));
        QVERIFY2(!found.sentence.contains(QRegularExpression(u"%[0-9]"_s)),
                 qPrintable(found.sentence));
        QCOMPARE(found.panel + u'/' + found.control, QLatin1StringView(wanted.control));
        QCOMPARE(found.isGuess, found.sentence.contains(u"(inferred)"_s));
        QCOMPARE(has(advice, Kind::Well), isNote || wanted.kind == Kind::Well);
    }

    void everyAdvice_hasARowHere()
    {
        QSet<int> covered;
        for (const Row& row : kRows) {
            covered.insert(static_cast<int>(row.kind));
        }
        QCOMPARE(covered.size(), kLinkAdviceCount);
        QSet<QString> keys;
        for (int kind = 0; kind < kLinkAdviceCount; ++kind) {
            keys.insert(keyOf(static_cast<Kind>(kind)));
        }
        QCOMPARE(keys.size(), kLinkAdviceCount);
    }

    void littleIsNoFault_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QString>("what");
        QTest::newRow("two damaged") << static_cast<int>(Kind::DamagedWithoutCrc) << u"damaged 2"_s;
        QTest::newRow("three of very many")
            << static_cast<int>(Kind::DamagedWithoutCrc) << u"damaged 3 of 6000"_s;
        QTest::newRow("two silent") << static_cast<int>(Kind::NoAnswers) << u"silent 2"_s;
        QTest::newRow("two bursts") << static_cast<int>(Kind::ForeignTraffic) << u"bursts 2"_s;
        QTest::newRow("bursts of a noisy line")
            << static_cast<int>(Kind::ForeignTraffic) << u"noise"_s;
        QTest::newRow("timer at 1") << static_cast<int>(Kind::LatencyTimer) << u"timer 1"_s;
        QTest::newRow("answers 5 ms late") << static_cast<int>(Kind::HeldBack) << u"held 5"_s;
        QTest::newRow("first second") << static_cast<int>(Kind::WaitingTooLong) << u"first"_s;
        QTest::newRow("96 % of the rates") << static_cast<int>(Kind::LineTooSlow) << u"scale"_s;
    }
    void littleIsNoFault()
    {
        QFETCH(int, kind);
        QFETCH(QString, what);
        LinkFacts facts = what == u"held 5"_s ? heldBack(5ms)
            : what.endsWith(u"6000"_s)        ? well(6000)
                                              : well();
        HealthCounts& recent = facts.health.recent;
        if (what.startsWith(u"damaged"_s)) {
            recent.badReplies = what.endsWith(u"6000"_s) ? 3 : 2;
        } else if (what == u"silent 2"_s) {
            recent.timeouts = 2;
        } else if (what == u"bursts 2"_s) {
            recent.unaskedBursts = 2;
        } else if (what == u"noise"_s) {
            recent.unaskedBursts = 10;
            recent.badReplies = 40;
        } else if (what == u"timer 1"_s) {
            facts.health.adapter.latencyTimerMs = 1;
        } else if (what == u"first"_s) {
            facts.stats.pollScale = 0.5;
            facts.health.now = {};
        } else if (what == u"scale"_s) {
            facts.stats.pollScale = 0.96;
            facts.health.now.wire = 990ms;
        }
        QVERIFY(!has(linkAdvice(facts), static_cast<Kind>(kind)));
    }

    void damagedLineWithoutCrc_isNotBelievedAboutTheController()
    {
        LinkFacts facts = withUart<uartbit::kFrame>();
        facts.health.recent.badReplies = 50;
        QVERIFY(!has(linkAdvice(facts), Kind::ControllerFrame));
        facts.line.errorDetection = ErrorDetection::Crc7;
        QVERIFY(has(linkAdvice(facts), Kind::ControllerFrame));
    }

    void aFewErrors_areToldWithWell()
    {
        LinkFacts facts = well();
        facts.health.recent.badReplies = 1;
        facts.health.recent.timeouts = 1;
        const auto advice = linkAdvice(facts);
        QCOMPARE(advice.size(), std::size_t{1});
        QCOMPARE(advice.front().kind, Kind::Well);
        QVERIFY2(advice.front().sentence.contains(u"2 damaged or missing"_s),
                 qPrintable(advice.front().sentence));
    }

    void severalCauses_comeByWeight()
    {
        LinkFacts facts = well();
        facts.health.total.losses = 1;
        facts.health.recent.badReplies = 50;
        facts.health.recent.timeouts = 50;
        facts.stats.echo = true;
        const auto advice = linkAdvice(facts);
        QCOMPARE(advice.size(), std::size_t{4});
        QCOMPARE(advice.at(0).kind, Kind::LineLost);
        QCOMPARE(advice.at(1).kind, Kind::DamagedWithoutCrc);
        QCOMPARE(advice.at(2).kind, Kind::NoAnswers);
        QCOMPARE(advice.at(3).kind, Kind::Echo);
    }

    void latencyTimer_hasTheCommandThatSetsIt()
    {
        const auto advice = linkAdvice(std::find_if(kRows.begin(), kRows.end(), [](const Row& row) {
                                           return row.kind == Kind::LatencyTimer;
                                       })->facts());
        QCOMPARE(advice.front().command, u"echo 1 | sudo tee /sys/x/latency_timer"_s);
    }

    void baud_isTheNextThatCarriesAll()
    {
        LinkFacts facts = well();
        facts.line.baud = 9600;
        facts.health.now.wire = 1000ms; // all of the time
        facts.stats.pollScale = 0.55; // 1.82 times what 9600 carry
        QCOMPARE(linkfacts::sufficientBaud(facts), std::optional(19200));
        facts.stats.pollScale = 0.45; // 2.2 times
        QCOMPARE(linkfacts::sufficientBaud(facts), std::optional(28800));
        facts.stats.pollScale = 0.01;
        QCOMPARE(linkfacts::sufficientBaud(facts), std::optional(115200));
        facts.health.now.wire = 300ms; // the speed is not what limits
        QCOMPARE(linkfacts::sufficientBaud(facts), std::optional<int>());
    }

    void adapter_isToldInTheLog()
    {
        AdapterFacts facts{.kind = AdapterFacts::Kind::Serial, .driver = u"ftdi_sio"_s};
        QVERIFY(adapterText(facts).isEmpty());
        facts.lowLatency = AdapterFacts::LowLatency::Refused;
        facts.latencyTimerMs = 16;
        QVERIFY(adapterText(facts).contains(u"ftdi_sio did not permit it"_s));
        QVERIFY(adapterText(facts).contains(u"16 ms"_s));
        facts.lowLatency = AdapterFacts::LowLatency::Granted;
        facts.latencyTimerMs = 1;
        QVERIFY(adapterText(facts).contains(u"does so"_s));
        facts.lowLatency = AdapterFacts::LowLatency::Unknown;
        facts.driver.clear();
        QVERIFY(adapterText(facts).contains(u"its driver does not know of it"_s));
    }
};

QTEST_GUILESS_MAIN(TestLinkAdvice)
#include "tst_linkadvice.moc"
