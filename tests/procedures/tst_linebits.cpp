// SPDX-License-Identifier: GPL-3.0-or-later
// Probing at a wrong speed must never be readable as a motor command: the whole search, sent bit by
// bit, to receivers at all speeds and parities.
#include "protocol/codec/lineprobe.h"
#include "protocol/codec/packet.h"
#include "protocol/procedures/linesearch.h"
#include "protocol/session/linkengine.h"
#include "tests/support/linebits.h"

#include <QTest>

#include <cmath>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using test::HeardByte;
using test::MotorWatch;
using test::OnError;
using test::Parity;
using test::Receiver;
using test::Wave;

namespace {

constexpr std::array kParities{Parity::None, Parity::Even, Parity::Odd};
constexpr std::array kPolicies{OnError::DropPacket, OnError::SkipByte, OnError::TakeByte};
constexpr std::array kClockErrors{-0.02, -0.015, -0.01, -0.005, 0.0, 0.005, 0.01, 0.015, 0.02};
constexpr std::array kPhases{0.0, 0.33, 0.67, 0.99};
enum class Grid : std::uint8_t { Fine, Coarse }; ///< coarse: the ends and the middle of the clock
// Between the bytes of a packet, in bits: a port that hands on all at once, and ports that take
// their time.
constexpr std::array kGaps{0.0, 2.5, 200.0};
constexpr double kRest = std::chrono::duration<double>(kWireRest).count();

Parity parityOf(ErrorDetection detection)
{
    return detection == ErrorDetection::Even ? Parity::Even
        : detection == ErrorDetection::Odd   ? Parity::Odd
                                             : Parity::None;
}

/// Pieces with rests between them, as they leave a port.
Wave waveOf(const std::vector<WirePiece>& pieces, double gapBits)
{
    Wave wave;
    double pause = 1.0; // a rest before
    for (const WirePiece& piece : pieces) {
        for (qsizetype i = 0; i < piece.bytes.size(); ++i) {
            wave.send(static_cast<std::uint8_t>(piece.bytes[i]), piece.line.baud,
                      parityOf(piece.line.errorDetection), piece.line.stopBits,
                      i == 0 ? pause : gapBits / piece.line.baud);
        }
        pause = kRest;
    }
    return wave;
}

struct Controller {
    int baud = 19200;
    ErrorDetection detection = ErrorDetection::None;
};

std::vector<Controller> everyController()
{
    std::vector<Controller> all;
    for (const int baud : kBaudRates) {
        for (const auto detection : {ErrorDetection::None, ErrorDetection::Even,
                                     ErrorDetection::Odd, ErrorDetection::Crc7}) {
            all.push_back({baud, detection});
        }
    }
    return all;
}

template <class Each>
void forEveryClock(const Controller& controller, bool restartsLow, const Each& each,
                   Grid grid = Grid::Fine)
{
    for (std::size_t i = 0; i < kClockErrors.size(); i += grid == Grid::Fine ? 1 : 4) {
        const double error = kClockErrors[i];
        for (const double phase : kPhases) {
            for (const int samples : {16, 8}) {
                each(Receiver{controller.baud * (1.0 + error), parityOf(controller.detection),
                              samples, phase, restartsLow});
            }
        }
    }
}

struct Tally {
    qint64 cases = 0;
    qint64 commands = 0;
    qint64 moving = 0;
    qint64 leftOpen = 0;
    QString example;
};

LineSettings lineOf(const Controller& controller, int stopBits = 1)
{
    LineSettings line;
    line.baud = controller.baud;
    line.errorDetection = controller.detection;
    line.stopBits = stopBits;
    return line;
}

/// A question as receivers may hear it: in all the ways that a port may pace it.
struct Question {
    QString name;
    std::vector<std::vector<WirePiece>> parts; ///< what is out when it ends or is cancelled
    bool mayRepeat = true;
};

Question questionOf(const LineSettings& line)
{
    const LineProbe probe = lineProbe(line);
    Question question{
        u"%1 baud, %2"_s.arg(line.baud).arg(int(line.errorDetection)), {}, probe.mayRepeat};
    for (std::size_t i = 1; i <= probe.pieces.size(); ++i) {
        question.parts.emplace_back(probe.pieces.begin(), probe.pieces.begin() + int(i));
    }
    return question;
}

/// All questions in any order and number, each followed by the clearing: what a receiver can come
/// to, to the last reachable state. This is the induction over all searches and connections.
Tally exhaust(const std::vector<Question>& questions, bool restartsLow, Grid grid)
{
    struct Heard {
        std::vector<HeardByte> bytes;
        int repeats;
        const QString* name;
    };
    Tally tally;
    for (const Controller& controller : everyController()) {
        if (controller.detection == ErrorDetection::Crc7) {
            continue; // on the wire as without
        }
        forEveryClock(
            controller, restartsLow,
            [&](const Receiver& receiver) {
                const auto clearing = receiver.hear(waveOf(lineClearing(), 0.0));
                std::vector<Heard> all;
                for (const Question& question : questions) {
                    for (const auto& part : question.parts) {
                        const bool isWhole = &part == &question.parts.back();
                        for (const double gap : kGaps) {
                            all.push_back({receiver.hear(waveOf(part, gap)),
                                           isWhole && question.mayRepeat ? 4 : 1, &question.name});
                            if (part.back().bytes.size() == 1) {
                                break; // nothing to pace
                            }
                        }
                    }
                }
                for (const OnError policy : kPolicies) {
                    std::vector<MotorWatch> states{MotorWatch(policy)};
                    for (std::size_t at = 0; at < states.size(); ++at) {
                        for (const Heard& heard : all) {
                            MotorWatch watch = states[at];
                            for (int i = 0; i < heard.repeats; ++i) {
                                watch.feed(heard.bytes);
                                MotorWatch cleared = watch;
                                cleared.feed(clearing);
                                ++tally.cases;
                                if (cleared.commands > 0) {
                                    tally.commands += cleared.commands;
                                    tally.moving += cleared.moving;
                                    tally.example =
                                        u"%1 at %2 baud, parity %3, policy %4"_s.arg(*heard.name)
                                            .arg(receiver.baud)
                                            .arg(int(receiver.parity))
                                            .arg(int(policy));
                                    cleared.commands = cleared.moving = 0;
                                }
                                if (std::ranges::none_of(states, [&](const MotorWatch& known) {
                                        return known.state() == cleared.state();
                                    })) {
                                    states.push_back(cleared);
                                }
                            }
                        }
                    }
                    tally.leftOpen += std::ranges::count_if(states, &MotorWatch::isOpen);
                }
            },
            grid);
    }
    return tally;
}

/// What a connection sends, at its own times, until it is given up: nobody answers.
struct Sent {
    LineSettings line;
    QByteArray bytes;
    double at = 0.0; ///< seconds
};
std::vector<Sent> connection(const LineSettings& line, bool reconnect, bool canSetLine = true)
{
    LinkEngine engine(line, true, reconnect, canSetLine);
    const Instant begin{std::chrono::hours(1)};
    const Instant end = begin + std::chrono::seconds(2);
    Instant now = begin;
    LineSettings set = line;
    std::vector<Sent> sent;
    engine.opened(now);
    for (bool isOver = false;;) {
        if (!isOver && now >= end) {
            engine.shutDown();
            isOver = true;
        }
        const LinkEngine::Action action = engine.next(now);
        if (action.kind == LinkEngine::Action::Kind::Send) {
            set = action.line.value_or(set);
            sent.push_back({set, action.bytes, std::chrono::duration<double>(now - begin).count()});
        } else if (action.kind == LinkEngine::Action::Kind::Wait) {
            now = std::max(now, isOver ? action.until : std::min(action.until, end));
        } else if (isOver) {
            return sent;
        } else {
            now = end;
        }
        std::ignore = engine.takeBatch(now);
    }
}

Wave waveOf(const std::vector<Sent>& sent)
{
    Wave wave;
    double end = 0.0;
    for (const Sent& packet : sent) {
        for (qsizetype i = 0; i < packet.bytes.size(); ++i) {
            wave.send(static_cast<std::uint8_t>(packet.bytes[i]), packet.line.baud,
                      parityOf(packet.line.errorDetection), packet.line.stopBits,
                      i == 0 ? packet.at - end : 0.0);
        }
        end = packet.at
            + std::chrono::duration<double>(packet.line.timeOf(int(packet.bytes.size()))).count();
    }
    return wave;
}

void count(Tally& tally, const Receiver& receiver, const Wave& wave)
{
    const auto heard = receiver.hear(wave);
    for (const OnError policy : kPolicies) {
        MotorWatch watch(policy);
        watch.feed(heard);
        ++tally.cases;
        tally.commands += watch.commands;
        tally.moving += watch.moving;
        tally.leftOpen += watch.isOpen() ? 1 : 0;
    }
}

/// One packet, sent once to every receiver at another speed.
Tally playOnce(const QByteArray& bytes, int stopBits, OnError policy)
{
    Tally tally;
    for (const int baud : kBaudRates) {
        Wave wave;
        for (const char byte : bytes) {
            wave.send(static_cast<std::uint8_t>(byte), baud, Parity::None, stopBits);
        }
        for (const Controller& controller : everyController()) {
            if (controller.baud == baud) {
                continue;
            }
            forEveryClock(controller, false, [&](const Receiver& receiver) {
                MotorWatch watch(policy);
                watch.feed(receiver.hear(wave));
                ++tally.cases;
                tally.commands += watch.commands;
                tally.moving += watch.moving;
                tally.leftOpen += watch.isOpen() ? 1 : 0;
            });
        }
    }
    return tally;
}

void print(const QString& what, const Tally& tally)
{
    qInfo().noquote() << u"%1 | %2 cases | motor commands %3, moving %4 | left open %5"_s
                             .arg(what, -52)
                             .arg(tally.cases, 9)
                             .arg(tally.commands)
                             .arg(tally.moving)
                             .arg(tally.leftOpen);
}

} // namespace

class TestLineBits : public QObject {
    Q_OBJECT

private slots:
    void model_hearsItsOwnSpeed();
    void model_flagsAnotherParity();
    void plainSignature_opensAMotorCommand();
    void stopPackets_areOrdersAtOtherSpeeds();
    void question_isNoQueryElsewhere();
    void anyOrder_isNeverAMotorCommand();
    void everyPolynomial_isNeverAMotorCommand();
    void connection_isNeverAMotorCommand();
    void search_isNeverAMotorCommand();
    void network_isTold();
    void lowRestart_isTold();
};

void TestLineBits::model_hearsItsOwnSpeed()
{
    for (const int baud : kBaudRates) {
        for (const Parity parity : kParities) {
            for (const int stopBits : {1, 2}) {
                Wave wave;
                for (int byte = 0; byte < 256; ++byte) {
                    wave.send(byte, baud, parity, stopBits);
                }
                for (const double error : kClockErrors) {
                    const Receiver receiver{baud * (1.0 + error), parity, 16, 0.5, false};
                    const auto heard = receiver.hear(wave);
                    QCOMPARE(heard.size(), std::size_t(256));
                    for (int byte = 0; byte < 256; ++byte) {
                        const HeardByte& one = heard[std::size_t(byte)];
                        QVERIFY(one.value == byte && !one.frameError && !one.parityError);
                    }
                }
            }
        }
    }
}

void TestLineBits::model_flagsAnotherParity()
{
    Wave wave;
    wave.send(0x83, 9600, Parity::None, 2);
    QVERIFY(Receiver({9600, Parity::Odd}).hear(wave).front().parityError); // three ones
    QVERIFY(!Receiver({9600, Parity::Even}).hear(wave).front().parityError);
    Wave even;
    even.send(0x84, 9600, Parity::Even, 1);
    QVERIFY(Receiver({9600, Parity::None}).hear(even).front().frameError);
}

/// Why the search does not begin with 0x81, and that the model finds what there is to find.
void TestLineBits::plainSignature_opensAMotorCommand()
{
    Wave wave;
    wave.send(0x81, 19200, Parity::None, 1);
    const auto heard = Receiver({115200, Parity::None}).hear(wave);
    QCOMPARE(heard.front().value, 0xE0);
    QVERIFY(!heard.front().frameError);
    const Tally plain = playOnce("\x81"_ba, 1, OnError::DropPacket);
    print(u"0x81 alone, bad bytes end the packet"_s, plain);
    QVERIFY(plain.leftOpen > 0);
    const Tally crc = playOnce("\x81\x48"_ba, 1, OnError::DropPacket);
    print(u"81 48, bad bytes end the packet"_s, crc);
    QVERIFY(crc.leftOpen > 0);
    const Tally taken = playOnce("\x81\x48"_ba, 1, OnError::TakeByte);
    print(u"81 48, bad bytes are taken"_s, taken);
    QVERIFY(taken.commands > 0);
    const Tally pololu = playOnce("\x80\x07\x01"_ba, 1, OnError::DropPacket);
    print(u"80 07 01, bad bytes end the packet"_s, pololu);
    QVERIFY(pololu.leftOpen > 0);
}

/// Why nothing is said at the end of a connection on which nobody has answered.
void TestLineBits::stopPackets_areOrdersAtOtherSpeeds()
{
    const QByteArray packets = QByteArray::fromHex("DA0000F000");
    const Tally ended = playOnce(packets, 1, OnError::DropPacket);
    print(u"the stop packets, bad bytes end the packet"_s, ended);
    QVERIFY(ended.leftOpen > 0);
    const Tally taken = playOnce(packets, 1, OnError::TakeByte);
    print(u"the stop packets, bad bytes are taken"_s, taken);
    QVERIFY(taken.commands > 0);
}

/// So that 0x81 and 0x83, which follow an answer, are never sent at a wrong speed.
void TestLineBits::question_isNoQueryElsewhere()
{
    qint64 cases = 0;
    for (const Controller& host : everyController()) {
        if (host.detection == ErrorDetection::Crc7) {
            continue; // an answer there would have to have our CRC byte
        }
        const Wave wave = waveOf(lineProbe(lineOf(host)).pieces, 0.0);
        for (const Controller& controller : everyController()) {
            if (controller.baud == host.baud) {
                continue;
            }
            forEveryClock(controller, false, [&](const Receiver& receiver) {
                for (const HeardByte& byte : receiver.hear(wave)) {
                    QVERIFY(byte.value < 0x81 || byte.value > 0x9F);
                }
                ++cases;
            });
        }
    }
    qInfo().noquote() << u"the question read as a query at another speed: 0 of %1"_s.arg(cases);
}

void TestLineBits::anyOrder_isNeverAMotorCommand()
{
    std::vector<Question> questions;
    for (const Controller& host : everyController()) {
        questions.push_back(questionOf(lineOf(host)));
        if (host.detection == ErrorDetection::Crc7) {
            questions.push_back(questionOf(lineOf(host, 2)));
        }
    }
    const Tally tally = exhaust(questions, false, Grid::Fine);
    print(u"any questions in any order, each cleared after"_s, tally);
    QVERIFY2(tally.commands == 0, qPrintable(tally.example));
    QVERIFY(tally.cases > 500'000);
}

void TestLineBits::everyPolynomial_isNeverAMotorCommand()
{
    Tally sum;
    int unclean = 0;
    for (int polynomial = 0x80; polynomial <= 0xFF; ++polynomial) {
        std::vector<Question> questions;
        for (const int baud : kBaudRates) {
            LineSettings line = lineOf({baud, ErrorDetection::Crc7});
            line.polynomial = static_cast<std::uint8_t>(polynomial);
            const bool isClean = lineProbe(line).isClean;
            QVERIFY(isClean || baud == 14400);
            unclean += isClean ? 0 : 1;
            if (isClean && polynomial % 7 == 0) {
                questions.push_back(questionOf(line));
            }
        }
        const Tally tally = exhaust(questions, false, Grid::Coarse);
        QVERIFY2(tally.commands == 0, qPrintable(tally.example));
        sum.cases += tally.cases;
    }
    print(u"the same with 18 polynomials"_s, sum);
    qInfo().noquote() << u"no clean question: %1 of 1408 (speed, polynomial), at 14400 baud"_s.arg(
        unclean);
    QVERIFY(unclean <= 16);
}

/// The connection itself, as LinkEngine sends it, to everybody else.
void TestLineBits::connection_isNeverAMotorCommand()
{
    Tally tally;
    for (const Controller& host : everyController()) {
        for (const bool reconnect : {false, true}) {
            const auto sent = connection(lineOf(host, host.baud % 2 + 1), reconnect);
            const auto clearing = lineClearing();
            QVERIFY(sent.size() > clearing.size() + 2);
            for (std::size_t i = 0; i < clearing.size(); ++i) { // it ends so, given up or closed
                const Sent& last = sent[sent.size() - clearing.size() + i];
                QCOMPARE(last.bytes, clearing[i].bytes);
                QCOMPARE(last.line.baud, clearing[i].line.baud);
            }
            const Wave wave = waveOf(sent);
            for (const Controller& controller : everyController()) {
                if (controller.baud != host.baud) {
                    forEveryClock(
                        controller, false,
                        [&](const Receiver& receiver) { count(tally, receiver, wave); },
                        Grid::Coarse);
                }
            }
        }
    }
    print(u"Connect, given up and cancelled"_s, tally);
    QCOMPARE(tally.commands, 0);
}

/// The search to its end, for controllers whose answers do not arrive; it is the longest.
void TestLineBits::search_isNeverAMotorCommand()
{
    Tally tally;
    LineSearch search({});
    std::vector<WirePiece> pieces;
    while (const auto ask = search.next()) {
        pieces.push_back({ask->line, ask->bytes});
        search.answer({});
    }
    for (const double gap : kGaps) {
        const Wave wave = waveOf(pieces, gap);
        for (const Controller& controller : everyController()) {
            forEveryClock(controller, false,
                          [&](const Receiver& receiver) { count(tally, receiver, wave); });
        }
    }
    print(u"a whole search that nobody answers"_s, tally);
    QCOMPARE(tally.commands, 0);
}

/// Over a serial server the speed is not ours to set, so that nothing can be cleared. Told here,
/// and in the manual page.
void TestLineBits::network_isTold()
{
    Tally plain;
    Tally crc;
    for (const Controller& host : everyController()) {
        if (lineOf(host).hasParity()) {
            continue; // the server's too
        }
        const Wave wave = waveOf(connection(lineOf(host), true, false));
        for (const Controller& controller : everyController()) {
            if (controller.baud != host.baud) {
                forEveryClock(
                    controller, false,
                    [&](const Receiver& receiver) {
                        count(host.detection == ErrorDetection::Crc7 ? crc : plain, receiver, wave);
                    },
                    Grid::Coarse);
            }
        }
    }
    print(u"Connect over a network, no CRC-7"_s, plain);
    print(u"Connect over a network, CRC-7"_s, crc);
    QCOMPARE(plain.moving + crc.moving, 0);
}

/// A receiver that takes a line still low for the next start bit, against its family's data sheet.
void TestLineBits::lowRestart_isTold()
{
    Tally search;
    LineSearch asked({});
    std::vector<WirePiece> pieces;
    while (const auto ask = asked.next()) {
        pieces.push_back({ask->line, ask->bytes});
        asked.answer({});
    }
    const Wave wave = waveOf(pieces, 0.0);
    for (const Controller& controller : everyController()) {
        forEveryClock(controller, true,
                      [&](const Receiver& receiver) { count(search, receiver, wave); });
    }
    print(u"quirk: low restarts, a whole search"_s, search);
    QVERIFY(search.cases > 9'000);
}

QTEST_GUILESS_MAIN(TestLineBits)
#include "tst_linebits.moc"
