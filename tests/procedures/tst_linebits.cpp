// SPDX-License-Identifier: GPL-3.0-or-later
// Probing at a wrong speed must never be readable as a motor command: the whole search, sent bit by
// bit, to receivers at all speeds and parities.
#include "protocol/codec/packet.h"
#include "protocol/procedures/linesearch.h"
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
// Between the bytes of a packet in bits, and between the packets of a clearing in seconds: a port
// that hands on all at once, and ports that take their time.
struct Gaps {
    double byteBits;
    double packets;
};
constexpr double kRest = std::chrono::duration<double>(LineSearch::kRest).count();
constexpr std::array kGaps{Gaps{0.0, kRest}, Gaps{2.5, kRest + 0.001}, Gaps{200.0, kRest + 0.02}};
constexpr double kWait = 0.06; // for a reply

Parity parityOf(ErrorDetection detection)
{
    return detection == ErrorDetection::Even ? Parity::Even
        : detection == ErrorDetection::Odd   ? Parity::Odd
                                             : Parity::None;
}

/// A try with all that is sent before the next one.
struct Block {
    LineSettings line;
    std::vector<LineSearch::Ask> asks;
};

std::vector<Block> blocksOf(const LineSearchOptions& options)
{
    LineSearch search(options);
    std::vector<Block> blocks;
    while (const auto ask = search.next()) {
        if (ask->isTry) {
            blocks.push_back({ask->line, {}});
        }
        blocks.back().asks.push_back(*ask);
        search.answer({});
    }
    return blocks;
}

Wave waveOf(const Block& block, const Gaps& gaps)
{
    Wave wave;
    double pause = 1.0; // a rest before
    for (const auto& ask : block.asks) {
        for (qsizetype i = 0; i < ask.bytes.size(); ++i) {
            wave.send(static_cast<std::uint8_t>(ask.bytes[i]), ask.line.baud,
                      parityOf(ask.line.errorDetection), ask.line.stopBits,
                      i == 0 ? pause : gaps.byteBits / ask.line.baud);
        }
        pause = ask.replyBytes > 0 ? kWait : gaps.packets;
    }
    return wave;
}

struct Controller {
    int baud = 19200;
    ErrorDetection detection = ErrorDetection::None;
    [[nodiscard]] bool answers(const LineSettings& line) const
    {
        // Odd parity hears the try without: a question with odd parity follows (LineSearch).
        const bool isOdd =
            detection == ErrorDetection::Odd && line.errorDetection == ErrorDetection::None;
        return line.baud == baud && (line.errorDetection == detection || isOdd);
    }
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
    qint64 cases =
        0; ///< a controller, its clock, its way with errors, the gaps: a whole search each
    qint64 commands = 0;
    qint64 moving = 0;
    qint64 leftOpen = 0;
    QString example;
};

/// Plays the search to every controller until that one would have answered. `deaf`: its answers
/// never arrive.
Tally play(const std::vector<Block>& blocks, OnError policy, bool deaf = false,
           bool restartsLow = false, Grid grid = Grid::Fine)
{
    const auto controllers = everyController();
    Tally tally;
    for (const Gaps& gaps : kGaps) {
        std::vector<Wave> waves;
        for (const Block& block : blocks) {
            waves.push_back(waveOf(block, gaps));
        }
        for (const Controller& controller : controllers) {
            forEveryClock(
                controller, restartsLow,
                [&](const Receiver& receiver) {
                    MotorWatch watch(policy);
                    std::size_t i = 0;
                    for (; i < blocks.size() && (deaf || !controller.answers(blocks[i].line));
                         ++i) {
                        watch.feed(receiver.hear(waves[i]));
                        if ((restartsLow ? watch.moving : watch.commands) > 0
                            && tally.example.isEmpty()) {
                            tally.example = u"controller %1 detection %2 clock %3, try %4 baud %5"_s
                                                .arg(controller.baud)
                                                .arg(int(controller.detection))
                                                .arg(receiver.baud / controller.baud)
                                                .arg(blocks[i].line.baud)
                                                .arg(int(blocks[i].line.errorDetection));
                        }
                    }
                    ++tally.cases;
                    tally.commands += watch.commands;
                    tally.moving += watch.moving;
                    tally.leftOpen += i == blocks.size() && watch.isOpen() ? 1 : 0;
                },
                grid);
        }
    }
    return tally;
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

QString nameOf(OnError policy)
{
    return policy == OnError::DropPacket ? u"bad bytes end the packet"_s
        : policy == OnError::SkipByte    ? u"bad bytes are skipped"_s
                                         : u"bad bytes are taken"_s;
}

} // namespace

class TestLineBits : public QObject {
    Q_OBJECT

private slots:
    void model_hearsItsOwnSpeed();
    void model_flagsAnotherParity();
    void plainSignature_opensAMotorCommand();
    void stopPackets_areOrdersAtOtherSpeeds();
    void search_isNeverAMotorCommand_data();
    void search_isNeverAMotorCommand();
    void search_fromEveryRememberedLine_isNeverAMotorCommand();
    void search_withEveryPolynomial_isNeverAMotorCommand();
    void probe_isNoQueryElsewhere();
    void cancelledSearch_leavesNothingOpen();
    void unanswered_movesNothing();
    void lowRestart_movesNothing();
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

void TestLineBits::search_isNeverAMotorCommand_data()
{
    QTest::addColumn<int>("policy");
    QTest::addColumn<int>("baud");
    QTest::addColumn<int>("detection");
    for (const OnError policy : kPolicies) {
        QTest::newRow(qPrintable(u"factory line, "_s + nameOf(policy)))
            << int(policy) << 19200 << int(ErrorDetection::None);
        QTest::newRow(qPrintable(u"115200 CRC-7, "_s + nameOf(policy)))
            << int(policy) << 115200 << int(ErrorDetection::Crc7);
    }
}

void TestLineBits::search_isNeverAMotorCommand()
{
    QFETCH(int, policy);
    QFETCH(int, baud);
    QFETCH(int, detection);
    LineSettings given;
    given.baud = baud;
    given.errorDetection = static_cast<ErrorDetection>(detection);
    const Tally tally = play(blocksOf({.given = given}), static_cast<OnError>(policy));
    print(QString::fromUtf8(QTest::currentDataTag()), tally);
    QVERIFY2(tally.commands == 0, qPrintable(tally.example));
    QCOMPARE(tally.leftOpen, 0);
    QVERIFY(tally.cases > 9'000);
}

void TestLineBits::search_fromEveryRememberedLine_isNeverAMotorCommand()
{
    Tally sum;
    for (const Controller& remembered : everyController()) {
        LineSettings line;
        line.baud = remembered.baud;
        line.errorDetection = remembered.detection;
        // The order differs in its first tries only: those, and what follows until all is closed.
        auto blocks = blocksOf({.given = {}, .remembered = {line}});
        blocks.resize(4);
        for (const OnError policy : kPolicies) {
            const Tally tally = play(blocks, policy, false, false, Grid::Coarse);
            QVERIFY2(tally.commands == 0, qPrintable(tally.example));
            sum.cases += tally.cases;
        }
    }
    print(u"first tries from every remembered line"_s, sum);
}

void TestLineBits::search_withEveryPolynomial_isNeverAMotorCommand()
{
    Tally sum;
    for (int polynomial = 0x80; polynomial <= 0xFF; polynomial += 7) {
        LineSettings line;
        line.polynomial = static_cast<std::uint8_t>(polynomial);
        auto blocks = blocksOf({.given = line});
        std::erase_if(blocks, [](const Block& block) { return !block.line.hasCrc(); });
        // Unclean ones come when faster controllers have answered: those are left out here.
        std::erase_if(blocks, [](const Block& block) {
            return !isCleanCrcProbe(block.line.baud,
                                    static_cast<std::uint8_t>(block.asks.front().bytes.back()));
        });
        for (const OnError policy : {OnError::DropPacket, OnError::TakeByte}) {
            const Tally tally = play(blocks, policy, true, false, Grid::Coarse);
            QVERIFY2(
                tally.commands == 0,
                qPrintable(u"polynomial 0x%1: %2"_s.arg(polynomial, 0, 16).arg(tally.example)));
            sum.cases += tally.cases;
        }
    }
    print(u"CRC tries with 19 polynomials, nobody answers"_s, sum);
}

/// So that 0x81 and 0x83, which follow an answer, are never sent at a wrong speed.
void TestLineBits::probe_isNoQueryElsewhere()
{
    qint64 cases = 0;
    for (const int baud : kBaudRates) {
        Wave wave;
        wave.send(0x84, baud, Parity::None, 2);
        for (const Controller& controller : everyController()) {
            if (controller.baud == baud) {
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
    qInfo().noquote() << u"the probe read as a query at another speed: 0 of %1"_s.arg(cases);
}

void TestLineBits::cancelledSearch_leavesNothingOpen()
{
    const auto blocks = blocksOf({});
    LineSearch search({});
    std::ignore = search.next();
    search.giveUp();
    Block last;
    while (const auto ask = search.next()) {
        QVERIFY(!ask->isTry);
        last.asks.push_back(*ask);
        search.answer({});
    }
    QVERIFY(!last.asks.empty());
    qint64 cases = 0;
    for (const OnError policy : kPolicies) {
        for (const Controller& controller : everyController()) {
            forEveryClock(
                controller, false,
                [&](const Receiver& receiver) {
                    for (const Gaps& gaps : {kGaps[0]}) {
                        const auto closing = receiver.hear(waveOf(last, gaps));
                        MotorWatch watch(policy);
                        for (const Block& block : blocks) {
                            if (controller.answers(block.line)) {
                                break;
                            }
                            // Cancelled before the clearing: only the try itself has gone out.
                            MotorWatch cancelled = watch;
                            cancelled.feed(
                                receiver.hear(waveOf({block.line, {block.asks.front()}}, gaps)));
                            cancelled.feed(closing);
                            QCOMPARE(cancelled.commands, 0);
                            const bool isEven = controller.detection == ErrorDetection::Even;
                            QVERIFY(!cancelled.isOpen() || (isEven && policy == OnError::SkipByte));
                            watch.feed(receiver.hear(waveOf(block, gaps)));
                            ++cases;
                        }
                    }
                },
                Grid::Coarse);
        }
    }
    qInfo().noquote() << u"cancelled after every try: %1 cases"_s.arg(cases);
}

/// A controller whose answers do not arrive (a broken wire, a polynomial nobody knows) hears the
/// search to its end.
void TestLineBits::unanswered_movesNothing()
{
    for (const OnError policy : kPolicies) {
        const Tally tally = play(blocksOf({}), policy, true);
        print(u"nobody answers, "_s + nameOf(policy), tally);
        QCOMPARE(tally.moving, 0);
        QVERIFY2(policy == OnError::TakeByte || tally.commands == 0, qPrintable(tally.example));
    }
}

/// A receiver that takes a line still low for the next start bit, against its family's data sheet:
/// nothing moves but by some of the CRC-7 tries, which are told and counted here.
void TestLineBits::lowRestart_movesNothing()
{
    for (const OnError policy : {OnError::DropPacket, OnError::SkipByte}) {
        auto blocks = blocksOf({});
        print(u"quirk: low restarts, "_s + nameOf(policy), play(blocks, policy, false, true));
        std::erase_if(blocks, [](const Block& block) { return block.line.hasCrc(); });
        const Tally tally = play(blocks, policy, false, true);
        print(u"the same, without the CRC-7 tries"_s, tally);
        QVERIFY2(tally.moving == 0, qPrintable(tally.example));
    }
}

QTEST_GUILESS_MAIN(TestLineBits)
#include "tst_linebits.moc"
