// SPDX-License-Identifier: GPL-3.0-or-later
// The search against simulated controllers, on a virtual clock.
#include "protocol/codec/packet.h"
#include "protocol/procedures/linesearch.h"
#include "protocol/sim/simulatedline.h"

#include <QTest>

using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

struct Outcome {
    std::optional<LineFound> found;
    int tries = 0;
    int motorCommands = 0;
    Duration took{0};
};

/// As Scan does it: a fresh line for each question, its answer awaited as long as asked.
Outcome search(sim::SimulatedLine& line, const LineSearchOptions& options = {})
{
    LineSearch search(options);
    const Instant start{std::chrono::hours(1)};
    Instant now = start;
    while (const auto ask = search.next()) {
        line.setHostLine(
            sim::HostLine{ask->line.baud, ask->line.errorDetection, ask->line.stopBits});
        std::ignore = line.read(now);
        line.write(ask->bytes, now);
        now += ask->line.timeOf(static_cast<int>(ask->bytes.size()));
        if (ask->replyBytes > 0) {
            now += ask->line.timeOf(ask->replyBytes) + ask->line.timeout;
        }
        search.answer(line.read(now));
        now += ask->replyBytes > 0 ? 2ms : std::chrono::milliseconds(kWireRest); // to open the port
    }
    Outcome outcome{search.found(), search.done(), 0, now - start};
    for (std::size_t i = 0; i < line.deviceCount(); ++i) {
        outcome.motorCommands += static_cast<int>(std::ranges::count(
            line.device(i).heard(), sim::PacketKind::Motor, &sim::HeardPacket::kind));
    }
    return outcome;
}

Outcome search(const sim::SimOptions& options, const LineSearchOptions& how = {})
{
    sim::SimulatedLine line(options, Instant(std::chrono::hours(1)));
    return search(line, how);
}

constexpr std::array kDetections{ErrorDetection::None, ErrorDetection::Even, ErrorDetection::Odd,
                                 ErrorDetection::Crc7};

} // namespace

class TestLineSearch : public QObject {
    Q_OBJECT

private slots:
    void everyLine_isFound(); // C-53, C-12
    void rememberedLine_isFoundAtTheFirstTry();
    void otherPolynomial_isFound_whenRemembered();
    void oldFirmware_isFoundAtHalfTheSpeed();
    void shorterSignature_isFound(); // C-70
    void severalControllers_areFound();
    void silence_echo_zeros_andGarbage_areTold();
    void plan_asksEveryLineOnce();
    void unclean_isLeftOut();
    void giveUp_clears();
    void network_asksOnlyWhatCanDiffer();
};

void TestLineSearch::everyLine_isFound()
{
    std::vector<int> tries;
    int motorCommands = 0;
    Duration longest{0};
    for (const int baud : kBaudRates) {
        for (const ErrorDetection detection : kDetections) {
            for (const int stopBits : {1, 2}) {
                for (const bool echo : {false, true}) {
                    sim::SimOptions options;
                    options.baud = baud;
                    options.errorDetection = detection;
                    options.stopBits = stopBits;
                    options.echo = echo;
                    options.pace = true;
                    const Outcome outcome = search(options);
                    const QString what = u"%1 baud, detection %2, %3 stop bits, echo %4"_s.arg(baud)
                                             .arg(int(detection))
                                             .arg(stopBits)
                                             .arg(echo);
                    QVERIFY2(outcome.found.has_value(), qPrintable(what));
                    QCOMPARE(outcome.found->line.baud, baud);
                    QVERIFY2(outcome.found->line.errorDetection == detection, qPrintable(what));
                    QVERIFY2(outcome.found->echo == echo, qPrintable(what));
                    QCOMPARE(outcome.found->signature.text(), u"TReXJr1.2"_s);
                    tries.push_back(outcome.tries);
                    motorCommands += outcome.motorCommands;
                    longest = std::max(longest, outcome.took);
                }
            }
        }
    }
    std::ranges::sort(tries);
    qInfo().noquote() << u"%1 of 176 line settings found; tries: median %2, worst %3; longest %4 s "
                         "of line time; motor commands heard %5"_s.arg(tries.size())
                             .arg(tries[tries.size() / 2])
                             .arg(tries.back())
                             .arg(std::chrono::duration<double>(longest).count(), 0, 'f', 1)
                             .arg(motorCommands);
    QCOMPARE(tries.size(), std::size_t(176));
    QCOMPARE(motorCommands, 0);
    QCOMPARE(tries.front(), 1);
    QVERIFY(tries.back() <= 36);
}

void TestLineSearch::rememberedLine_isFoundAtTheFirstTry()
{
    for (const int baud : kBaudRates) {
        for (const ErrorDetection detection : kDetections) {
            sim::SimOptions options;
            options.baud = baud;
            options.errorDetection = detection;
            LineSettings line;
            line.baud = baud;
            line.errorDetection = detection;
            const Outcome outcome = search(options, {.given = {}, .remembered = {line}});
            QVERIFY(outcome.found);
            QCOMPARE(outcome.tries, 1);
        }
    }
}

void TestLineSearch::otherPolynomial_isFound_whenRemembered()
{
    sim::SimOptions options;
    options.baud = 38400;
    options.errorDetection = ErrorDetection::Crc7;
    options.polynomial = 0x91;
    QVERIFY(!search(options).found);
    LineSettings line;
    line.polynomial = 0x91;
    const Outcome outcome = search(options, {.given = {}, .remembered = {line}});
    QVERIFY(outcome.found);
    QCOMPARE(int(outcome.found->line.polynomial), 0x91);
    QCOMPARE(outcome.found->line.baud, 38400);
}

void TestLineSearch::oldFirmware_isFoundAtHalfTheSpeed()
{
    sim::SimOptions options;
    QVERIFY(options.applyFirmware(u"1.1"_s));
    for (const auto& [stored, real] : {std::pair{38400, 19200}, {28800, 14400}}) {
        options.baud = stored;
        const Outcome outcome = search(options);
        QVERIFY(outcome.found);
        QCOMPARE(outcome.found->line.baud, real);
    }
}

void TestLineSearch::shorterSignature_isFound()
{
    for (const ErrorDetection detection : kDetections) {
        sim::SimOptions options;
        options.model = Model::Trex;
        options.errorDetection = detection;
        const Outcome outcome = search(options);
        QVERIFY(outcome.found);
        QVERIFY(outcome.found->signature.model == Model::Trex);
    }
}

void TestLineSearch::severalControllers_areFound()
{
    sim::SimOptions options;
    options.devices = {3, 9};
    options.pace = true;
    QVERIFY(search(options).found); // equal answers, joined
}

void TestLineSearch::silence_echo_zeros_andGarbage_areTold()
{
    const auto heard = [](const QByteArray& answer, bool echo) {
        LineSearch search({});
        while (const auto ask = search.next()) {
            search.answer(echo ? ask->bytes + answer : answer);
        }
        return search.found() ? -1 : int(search.heard());
    };
    QCOMPARE(heard({}, false), int(LineAnswer::Silence));
    QCOMPARE(heard({}, true), int(LineAnswer::EchoOnly));
    QCOMPARE(heard(QByteArray(2, '\0'), false), int(LineAnswer::Zeros));
    QCOMPARE(heard("\xF8\x3C"_ba, false), int(LineAnswer::Garbage));
    QCOMPARE(heard("zz"_ba, true), int(LineAnswer::Garbage));
}

void TestLineSearch::plan_asksEveryLineOnce()
{
    LineSearch search({});
    const int total = search.total();
    QSet<QString> lines;
    QByteArrayList sent;
    int tries = 0;
    while (const auto ask = search.next()) {
        QVERIFY(ask->line.form == PacketForm::Compact);
        QCOMPARE(ask->line.stopBits, 2);
        sent << ask->bytes;
        if (ask->isTry) {
            ++tries;
            lines << u"%1 %2"_s.arg(ask->line.baud).arg(int(ask->line.errorDetection));
        }
        search.answer({});
    }
    QCOMPARE(tries, 33); // none asks odd parity too
    QCOMPARE(total, tries);
    QCOMPARE(lines.size(), tries);
    for (const QByteArray& bytes : sent) {
        QVERIFY(!bytes.startsWith("\x80"_ba) && !bytes.startsWith("\x81"_ba));
    }
}

/// Ten or so polynomials have no question at 14400 baud that is free of orders at other speeds.
void TestLineSearch::unclean_isLeftOut()
{
    for (int polynomial = 0x80; polynomial <= 0xFF; ++polynomial) {
        LineSettings line;
        line.polynomial = static_cast<std::uint8_t>(polynomial);
        line.errorDetection = ErrorDetection::Crc7;
        line.baud = 14400;
        if (lineProbe(line).isClean) {
            continue;
        }
        LineSearch search({.given = line});
        QCOMPARE(search.leftOut().size(), std::size_t(1));
        while (const auto ask = search.next()) {
            QVERIFY(ask->line.baud != 14400 || ask->line.polynomial != polynomial
                    || !ask->line.hasCrc());
            search.answer({});
        }
        const LineSearch only({.given = {}, .only = {line}}); // asked for by name
        QCOMPARE(only.total(), 1);
        return;
    }
    QFAIL("all are clean now: the exception can go");
}

/// After every try the line is cleared, and a search that is given up ends so too.
void TestLineSearch::giveUp_clears()
{
    for (int after = 1; after < 12; ++after) {
        LineSearch search({});
        QByteArrayList sent;
        for (int i = 0; i < after; ++i) {
            sent << search.next()->bytes;
            search.answer({});
        }
        search.giveUp();
        while (const auto ask = search.next()) {
            QVERIFY(!ask->isTry);
            sent << ask->bytes;
        }
        QByteArrayList closing;
        for (const WirePiece& piece : lineClearing()) {
            closing << piece.bytes;
        }
        QCOMPARE(sent.mid(sent.size() - closing.size()), closing);
    }
}

void TestLineSearch::network_asksOnlyWhatCanDiffer()
{
    LineSearch search({.given = {}, .isNetwork = true});
    QCOMPARE(search.total(), 2); // without and with CRC-7
    QByteArrayList sent;
    while (const auto ask = search.next()) {
        sent << ask->bytes;
        search.answer({});
    }
    QCOMPARE(sent, (QByteArrayList{"\x82"_ba, "\x82\x53"_ba}));
}

QTEST_GUILESS_MAIN(TestLineSearch)
#include "tst_linesearch.moc"
