// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of the line against a controller that was written from the same documents by another
// reading, on virtual time: hours in seconds.
#include "protocol/codec/packet.h"
#include "protocol/codec/parametertable.h"
#include "protocol/codec/replies.h"
#include "tests/support/simulatedlink.h"

#include <QElapsedTimer>
#include <QTest>

#include <bit>

using namespace trex;
using namespace trex::test;
using namespace std::chrono_literals;

namespace {

struct Line {
    sim::SimOptions options;
    LineSettings settings;
};

Line lineOf(PacketForm form, ErrorDetection detection, std::uint8_t polynomial = 0x89,
            int baud = 19200)
{
    Line line;
    line.settings.form = form;
    line.settings.baud = line.options.baud = baud;
    line.settings.errorDetection = line.options.errorDetection = detection;
    line.settings.polynomial = line.options.polynomial = polynomial;
    line.options.pace = true;
    return line;
}

void addLines()
{
    QTest::addColumn<PacketForm>("form");
    QTest::addColumn<ErrorDetection>("detection");
    QTest::addColumn<int>("polynomial");
    QTest::newRow("compact") << PacketForm::Compact << ErrorDetection::None << 0x89;
    QTest::newRow("pololu") << PacketForm::Pololu << ErrorDetection::None << 0x89;
    QTest::newRow("compact, odd parity") << PacketForm::Compact << ErrorDetection::Odd << 0x89;
    QTest::newRow("compact, CRC") << PacketForm::Compact << ErrorDetection::Crc7 << 0x89;
    QTest::newRow("pololu, CRC") << PacketForm::Pololu << ErrorDetection::Crc7 << 0x89;
    QTest::newRow("compact, CRC 0x91") << PacketForm::Compact << ErrorDetection::Crc7 << 0x91;
    QTest::newRow("pololu, CRC 0xFF") << PacketForm::Pololu << ErrorDetection::Crc7 << 0xFF;
}

/// The line of the current data row.
Line fetchLine()
{
    QFETCH(PacketForm, form);
    QFETCH(ErrorDetection, detection);
    QFETCH(int, polynomial);
    return lineOf(form, detection, static_cast<std::uint8_t>(polynomial));
}

PollWishes fullMix()
{
    PollWishes wishes{};
    for (const PollRow& row : kPolls) {
        if (row.id <= PollId::UartErrors) {
            wishes.at(static_cast<std::size_t>(row.id)) = row.hertz;
        }
    }
    return wishes;
}

double seconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

/// Query and reply on the wire.
int bytesOf(const PollRow& row, const LineSettings& settings)
{
    const int reply = row.values * (row.id == PollId::RawChannels ? 2 : 1);
    return static_cast<int>(encode(pollCommand(row.id), settings).size()) + reply
        + (settings.hasCrc() ? 1 : 0);
}

int byteAt(const QByteArray& bytes, int index)
{
    return static_cast<std::uint8_t>(bytes[index]);
}

/// Asks and expects an answer.
QByteArray ask(SimulatedLink& link, const Command& command)
{
    static quint64 id = 1000;
    const auto reply = link.ask({.id = ++id, .command = command});
    return reply && *reply ? (*reply)->payload : QByteArray("no reply");
}

/// Sends motor packets and lets the controller obey them.
void drive(SimulatedLink& link, const Command& command)
{
    static quint64 id = 500'000;
    link.engine.submit({.id = ++id, .command = command, .priority = Priority::Motor});
    link.run(100ms);
}

} // namespace

class TestEngineVsSimulator : public QObject {
    Q_OBJECT

private slots:
    void damagedSetting_endsInStoppedMotors_data();
    void damagedSetting_endsInStoppedMotors(); // C-08 C-38
    void queries_haveTheControllersValues_data() { addLines(); }
    void queries_haveTheControllersValues() // C-01 C-02 C-03 C-13 C-17 C-18 C-23 C-34
    {
        const Line line = fetchLine();
        SimulatedLink link(line.options, line.settings);
        link.open();
        link.run(500ms);
        QCOMPARE(link.engine.state(), LinkState::Connected);
        QCOMPARE(ask(link, query("get-signature")), QByteArray("TReXJr1.2"));
        QCOMPARE(ask(link, query("get-mode")), QByteArray("r"));
        QCOMPARE(ask(link, query("get-serial-control")), QByteArray(1, '\x01'));
        QCOMPARE(ask(link, query("get-status")), QByteArray(1, '\0'));
        QCOMPARE(ask(link, query("get-uart-errors")), QByteArray(1, '\0'));
        for (const char* one : {"get-motor1-current", "get-motor2-current", "get-learned"}) {
            QCOMPARE(ask(link, query(one)).size(), 1);
        }
        QCOMPARE(ask(link, query("get-currents")).size(), 2);
        for (int mask = 0; mask <= 31; ++mask) { // mask 0: no reply, not even a CRC byte (C-69)
            const auto bits = std::popcount(static_cast<unsigned>(mask));
            const auto byte = static_cast<std::uint8_t>(mask);
            QCOMPARE(ask(link, channelsQuery("get-raw-channels", byte)).size(), 2 * bits);
            QCOMPARE(ask(link, channelsQuery("get-remapped-channels", byte)).size(), bits);
        }
        for (const ParameterRow& row : kParameters) {
            if (!row.isTrigger) {
                QCOMPARE(byteAt(ask(link, readParameter(row.number)), 0),
                         link.line.device().storedParameter(row.number));
            }
        }
        QCOMPARE(link.stats.timeouts + link.stats.crcErrors + link.stats.badReplies, 0U);
        QCOMPARE(link.line.device().firmware().uartErrorByte(), 0);
    }

    void settings_areStoredAndReadBack_data() { addLines(); }
    void settings_areStoredAndReadBack() // C-35 C-37 C-38
    {
        const Line line = fetchLine();
        SimulatedLink link(line.options, line.settings);
        link.open();
        link.run(500ms);
        const QByteArray done(1, '\0');
        for (const ParameterRow& row : kParameters) {
            if (row.isTrigger || row.key == "device-number") { // would leave this line's number
                continue;
            }
            const int before = link.line.device().storedParameter(row.number);
            const int raw = before == row.minimum ? row.minimum + 1 : row.minimum;
            const auto value = static_cast<std::uint8_t>(raw);
            QCOMPARE(ask(link, writeParameter(row.number, value)), done);
            QCOMPARE(link.line.device().storedParameter(row.number), raw);
            QCOMPARE(byteAt(ask(link, readParameter(row.number)), 0), raw);
            ask(link, writeParameter(row.number, static_cast<std::uint8_t>(before)));
        }
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            const Calibration wanted{2400 + channel, 3700 + channel, 5100 + channel, 90 + channel};
            QCOMPARE(ask(link, writeCalibration(channel, wanted)), done);
            QCOMPARE(parseCalibration(ask(link, readCalibration(channel))), wanted);
        }
        QCOMPARE(link.stats.timeouts + link.stats.crcErrors + link.stats.badReplies, 0U);
    }

    void motorCommands_areObeyed_data() { addLines(); }
    void motorCommands_areObeyed() // C-41 C-42 C-43 C-44 C-45 C-46
    {
        const Line line = fetchLine();
        SimulatedLink link(line.options, line.settings);
        link.open();
        link.run(500ms);
        using Action = MotorOrder::Action;
        using Output = sim::MotorOutput;
        const sim::Device& device = link.line.device();
        for (const Action action : {Action::Set, Action::Accelerate}) {
            drive(link, *driveMotor(MotorId::Motor1, {action, 40}));
            drive(link, *driveMotor(MotorId::Motor2, {action, -127}));
            drive(link, *driveMotor(MotorId::Aux, {action, 99}));
            QCOMPARE(device.output(MotorId::Motor1).speed, 40);
            QCOMPARE(device.output(MotorId::Motor2).speed, -127);
            QCOMPARE(device.output(MotorId::Aux).speed, 99);
            drive(link, *driveBoth({action, -11}, {action, 12}));
            QCOMPARE(device.output(MotorId::Motor1).speed, -11);
            QCOMPARE(device.output(MotorId::Motor2).speed, 12);
            for (const Command& stop : stopCommands(false)) {
                drive(link, stop);
            }
            for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
                QCOMPARE(device.output(motor), Output{});
            }
        }
        drive(link, *driveMotor(MotorId::Motor1, {Action::Brake, 77}));
        QCOMPARE(device.output(MotorId::Motor1).brake, 77);
        drive(link, stopCommands(true).front());
        QCOMPARE(device.output(MotorId::Motor2).brake, 127);
        QCOMPARE(link.line.device().firmware().uartErrorByte(), 0);
    }

    void fullPollMix_reachesItsRates_data() { addLines(); }
    void fullPollMix_reachesItsRates()
    {
        const Line line = fetchLine();
        SimulatedLink link(line.options, line.settings);
        link.engine.setWishes(fullMix(), link.now);
        link.open();
        link.run(2s);
        link.sampleCounts = {};
        constexpr int kSeconds = 20;
        link.run(std::chrono::seconds(kSeconds));
        for (const PollRow& row : kPolls) {
            const double hertz =
                link.sampleCounts.at(static_cast<std::size_t>(row.id)) / double(kSeconds);
            const double wanted = fullMix().at(static_cast<std::size_t>(row.id));
            const double asked = wanted * link.stats.pollScale;
            QVERIFY2(std::abs(hertz - asked) <= asked * 0.03,
                     qPrintable(QStringLiteral("%1: %2 Hz of %3")
                                    .arg(QLatin1StringView(row.key.data()))
                                    .arg(hertz)
                                    .arg(asked)));
        }
        // The Pololu form with CRC is a little more than 19200 baud can carry, the others are not.
        QCOMPARE(link.stats.pollScale == 1.0,
                 line.settings.form == PacketForm::Compact || !line.settings.hasCrc());
        QVERIFY(link.stats.pollScale > 0.85);
        QCOMPARE(link.stats.timeouts, 0U);
    }

    void slowLine_slowsAllStreamsInProportion()
    {
        const Line line = lineOf(PacketForm::Compact, ErrorDetection::None, 0x89, 2400);
        SimulatedLink link(line.options, line.settings);
        link.engine.setWishes(fullMix(), link.now);
        link.open();
        link.run(10s);
        link.sampleCounts = {};
        link.run(60s);
        QVERIFY(link.stats.pollScale < 0.5);
        double total = 0.0;
        for (const PollRow& row : kPolls) {
            const double asked = fullMix().at(static_cast<std::size_t>(row.id));
            const double share = link.sampleCounts.at(static_cast<std::size_t>(row.id)) / 60.0;
            QVERIFY2(std::abs(share - asked * link.stats.pollScale)
                         <= asked * link.stats.pollScale * 0.1,
                     QByteArray::number(share) + " of " + QByteArray::number(asked) + " at "
                         + QByteArray::number(link.stats.pollScale));
            total += share * bytesOf(row, line.settings) * seconds(line.settings.timeOf(1));
        }
        QVERIFY2(total > 0.9, "the line is not left idle");
        QCOMPARE(link.stats.timeouts, 0U);
    }

    void fault_neverHangsNorLies_data()
    {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<double>("amount");
        QTest::addColumn<bool>("crc");
        QTest::addColumn<bool>("echo");
        for (const bool crc : {true, false}) {
            for (const bool echo : {false, true}) {
                const auto add = [&](const char* name, double amount) {
                    QTest::addRow("%s %g%s%s", name, amount, crc ? ", CRC" : "",
                                  echo ? ", echo" : "")
                        << QString::fromLatin1(name) << amount << crc << echo;
                };
                for (const double chance : {0.002, 0.02, 0.1}) {
                    add("drop", chance);
                    if (crc) { // nothing can tell a wrong bit, or one byte twice, without
                        add("corrupt", chance);
                        add("duplicate", chance);
                    }
                }
                for (const double ms : {5.0, 60.0, 99.0, 130.0, 190.0}) {
                    add("delay", ms);
                }
                if (crc) {
                    add("garbage", 1);
                    add("garbage", 7);
                    add("garbage", 100);
                }
                add("silent-for", 0.3);
                add("silent-for", 3.0);
                add("hangup-for", 1.0);
                add("reset-after", 0.5);
            }
        }
    }
    void fault_neverHangsNorLies() // C-16
    {
        QFETCH(QString, fault);
        QFETCH(double, amount);
        QFETCH(bool, crc);
        QFETCH(bool, echo);
        Line line = lineOf(PacketForm::Compact, crc ? ErrorDetection::Crc7 : ErrorDetection::None,
                           0x89, 115200);
        line.options.echo = echo;
        const std::vector<int> numbers{0x0E, 0x0F, 0x10, 0x11, 0x12, 0x13, 0x14};
        for (const int number : numbers) { // each its own value, so that a mixed-up reply shows
            line.options.parameters[number] = 0x20 + number;
        }
        SimulatedLink link(line.options, line.settings);
        PollWishes wishes = fullMix();
        link.engine.setWishes(wishes, link.now);
        link.open();
        link.run(1s);
        QCOMPARE(link.engine.state(), LinkState::Connected);

        sim::Faults faults;
        QVERIFY(faults.apply(fault, amount));
        const bool once = fault.contains(QLatin1Char('-'));
        QElapsedTimer clock;
        clock.start();
        const Instant begin = link.now;
        quint64 id = 0;
        for (int round = 0; round < 8; ++round) {
            link.line.setFaults(faults, link.now);
            for (int i = 0; i < 150; ++i) {
                const auto number = static_cast<std::size_t>(++id) % numbers.size();
                link.engine.submit(
                    {.id = id,
                     .command = readParameter(static_cast<std::uint8_t>(numbers[number]))});
                link.run(40ms);
            }
            if (once) { // it was over seconds ago
                QCOMPARE(link.engine.state(), LinkState::Connected);
            }
        }
        link.line.setFaults({}, link.now);
        link.run(2s);
        QCOMPARE(link.engine.state(), LinkState::Connected);
        link.run(20s); // whatever still waits
        int wrong = 0;
        int right = 0;
        for (quint64 each = 1; each <= id; ++each) {
            const auto found = link.outcomes.find(each);
            QVERIFY2(found != link.outcomes.end(), "somebody waits for ever");
            if (found->second) {
                const int expected =
                    0x20 + numbers[static_cast<std::size_t>(each) % numbers.size()];
                ++(byteAt(found->second->payload, 0) == expected ? right : wrong);
            }
        }
        QCOMPARE(link.doubleOutcomes, 0);
        QVERIFY(link.packets > 2000);
        QVERIFY2(right > 0, "not one came through");
        // One in eight replies with garbage before it, one in 128 of those by chance with its CRC.
        QVERIFY2(wrong <= (fault == QStringLiteral("garbage") ? 8 : 0), QByteArray::number(wrong));
        const double virtualSeconds = std::chrono::duration<double>(link.now - begin).count();
        qDebug("%d packets, %d right, %d wrong, %.0f s in %.2f s: factor %.0f", link.packets, right,
               wrong, virtualSeconds, double(clock.elapsed()) / 1000.0,
               virtualSeconds * 1000.0 / double(std::max<qint64>(1, clock.elapsed())));
    }

    void lostController_isRegainedWithinTwoSecondsOfItsReturn_data()
    {
        QTest::addColumn<QString>("fault");
        QTest::newRow("silence") << QStringLiteral("silent-for");
        QTest::newRow("hang-up") << QStringLiteral("hangup-for");
    }
    void lostController_isRegainedWithinTwoSecondsOfItsReturn()
    {
        QFETCH(QString, fault);
        const Line line = lineOf(PacketForm::Compact, ErrorDetection::None);
        SimulatedLink link(line.options, line.settings);
        link.engine.setWishes(fullMix(), link.now);
        link.open();
        link.run(1s);
        for (const double away : {1.5, 7.3, 100.0}) {
            sim::Faults faults;
            QVERIFY(faults.apply(fault, away));
            link.line.setFaults(faults, link.now);
            link.run(1s);
            QVERIFY2(link.engine.state() != LinkState::Connected, "noticed within a second");
            link.run(std::chrono::duration_cast<Duration>(std::chrono::duration<double>(away))
                     + 1s);
            QCOMPARE(link.engine.state(), LinkState::Connected);
            link.sampleCounts = {};
            link.run(1s);
            QVERIFY2(link.sampleCounts.front() > 70, "polling goes on as before");
        }
    }

    void lostController_hearsStopWhenItIsBack() // a cable pulled out and in, motors running
    {
        const Line line = lineOf(PacketForm::Compact, ErrorDetection::None);
        SimulatedLink link(line.options, line.settings);
        link.engine.setWishes(fullMix(), link.now);
        link.open();
        link.run(1s);
        drive(link, *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 90}));
        drive(link, *driveMotor(MotorId::Aux, {MotorOrder::Action::Accelerate, 90}));
        // Both directions are cut, without the port noticing: what is sent goes nowhere.
        const auto run = [&](Duration duration) {
            for (const Instant end = link.now + duration; link.now < end;) {
                static_cast<void>(link.engine.next(link.now));
                link.now += 1ms;
            }
            link.take();
        };
        run(3s);
        QVERIFY(link.engine.state() != LinkState::Connected);
        QCOMPARE(link.line.device().output(MotorId::Motor1).speed, 90);
        link.run(2s);
        QCOMPARE(link.engine.state(), LinkState::Connected);
        for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
            QCOMPARE(link.line.device().output(motor), sim::MotorOutput{});
        }
    }

    void endlessNoise_isALossAndStopGoesThrough()
    {
        // Every reply drowns, and rubbish comes faster than the line could ever carry it.
        const Line line = lineOf(PacketForm::Compact, ErrorDetection::None);
        SimulatedLink link(line.options, line.settings);
        link.engine.setWishes(fullMix(), link.now);
        link.open();
        link.run(1s);
        drive(link, *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 90}));
        const QByteArray rubbish(64, '\x5A');
        std::optional<Instant> lost;
        const Instant begin = link.now;
        std::optional<Instant> stopSent;
        bool isStopAsked = false;
        while (link.now < begin + 3s) {
            link.now += 1ms;
            link.engine.received(rubbish, link.now);
            if (!isStopAsked && link.now >= begin + 200ms) {
                isStopAsked = true;
                std::vector<Transaction> packets;
                for (const Command& command : stopCommands(false)) {
                    packets.push_back({.command = command, .priority = Priority::Stop});
                }
                link.engine.stop(packets, link.now);
            }
            const LinkEngine::Action action = link.engine.next(link.now);
            if (action.kind == LinkEngine::Action::Kind::Send) {
                link.line.write(action.bytes, link.now);
                if (action.bytes == QByteArray::fromHex("f000") && !stopSent) {
                    stopSent = link.now;
                }
            }
            if (!lost && link.engine.state() != LinkState::Connected) {
                lost = link.now;
            }
        }
        QVERIFY(stopSent.has_value());
        QVERIFY(*stopSent - begin < 500ms);
        QVERIFY(lost.has_value());
        QVERIFY2(*lost - begin < 1200ms, "noise is not mistaken for a working link");
        link.run(2s);
        QCOMPARE(link.engine.state(), LinkState::Connected);
    }

    void longTimeout_doesNotHoldAStopBack()
    {
        Line line = lineOf(PacketForm::Compact, ErrorDetection::None);
        line.settings.timeout = 10s;
        SimulatedLink link(line.options, line.settings);
        link.open();
        link.run(1s);
        drive(link, *driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 90}));
        sim::Faults faults;
        faults.silentFor = 100.0;
        link.line.setFaults(faults, link.now);
        link.engine.submit({.id = 1, .command = query("get-mode")});
        link.run(50ms);
        QVERIFY(link.engine.isReplyDue());
        std::vector<Transaction> packets;
        for (const Command& command : stopCommands(false)) {
            packets.push_back({.command = command, .priority = Priority::Stop});
        }
        link.engine.stop(packets, link.now);
        link.run(250ms);
        QCOMPARE(link.line.device().output(MotorId::Motor1), sim::MotorOutput{});
    }
};

void TestEngineVsSimulator::damagedSetting_endsInStoppedMotors_data()
{
    QTest::addColumn<bool>("isCalibration");
    QTest::newRow("parameter") << false;
    QTest::newRow("calibration") << true;
}

/// Every byte of a setting's packet, its top bit turned over and others with it: some are motor
/// orders, and all end in stopped motors.
void TestEngineVsSimulator::damagedSetting_endsInStoppedMotors()
{
    QFETCH(bool, isCalibration);
    const Command command = isCalibration
        ? writeCalibration(1, {2501, 3751, 5001, 101})
        : writeParameter(parameterRow("serial-timeout").number, 5);
    const auto length = encode(command, {}).size();
    int moved = 0;
    for (qsizetype at = 0; at < length; ++at) {
        for (int mask = 0x01; mask <= 0xFF; mask += at == 0 ? 1 : mask < 0x80 ? 0x7F : 1) {
            sim::SimOptions options;
            options.pace = true;
            SimulatedLink link(options, {});
            link.open();
            link.run(100ms);
            QCOMPARE(link.engine.state(), LinkState::Connected);
            sim::Faults faults;
            faults.corruptAt = link.line.wireBytes() + at + 1;
            faults.corruptMask = static_cast<std::uint8_t>(mask);
            link.line.setFaults(faults, link.now);
            link.engine.submit({.id = 1, .command = command});
            link.run(900ms);
            bool moves = false; // by the latest motor packet that was heard
            bool everMoved = false;
            for (const sim::HeardPacket& packet : link.line.device().heard()) {
                if (packet.kind == sim::PacketKind::Motor) {
                    const QByteArrayView speeds = QByteArrayView(packet.bytes).sliced(1);
                    moves = std::ranges::any_of(speeds, [](char c) { return c != 0; });
                    everMoved = everMoved || moves;
                }
            }
            moved += everMoved ? 1 : 0;
            QVERIFY2(!moves, qPrintable(QStringLiteral("byte %1, mask %2").arg(at).arg(mask)));
        }
    }
    qInfo("%d damages were heard as a motor order; all were stopped", moved);
    QVERIFY(moved > 0);
}

QTEST_APPLESS_MAIN(TestEngineVsSimulator)
#include "tst_enginevssimulator.moc"
