// SPDX-License-Identifier: GPL-3.0-or-later
// The course of a bench test on virtual time: what is ordered when, what ends it, and that nothing
// is ordered without fresh readings.
#include "protocol/procedures/benchdryrun.h"
#include "protocol/sim/simulatedline.h"

#include <QTest>

#include <cmath>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr Instant kStart{1h};

BenchProfile profileOf(const QByteArray& steps, const QByteArray& more = {})
{
    const auto profile = parseBenchProfile(
        R"({"format":"trexpanel-bench-profile","version":1,"name":"Test","motor":"1",)" + more
            + R"("steps":[)" + steps + "]}",
        u"test"_s);
    if (!profile) {
        qFatal("%s", qPrintable(profile.error().context));
    }
    return *profile;
}

/// Plays the line's part: readings in their rates, and what they say.
struct Player {
    explicit Player(const BenchProfile& profile) : run(profile, Model::TrexJr)
    {
        run.start(now, 0);
    }
    void sample(PollId poll, std::uint16_t first, std::uint16_t second = 0)
    {
        run.take({poll, {first, second}, now});
    }
    void go(Duration duration)
    {
        for (const Instant end = now + duration; now < end && !run.hasEnded(); now += 5ms) {
            if (readsCurrents) {
                sample(PollId::Currents, raw, raw2);
            }
            if (readsStatus) {
                sample(PollId::Status, std::exchange(status, 0));
            }
            sample(PollId::SerialControl, control);
            const BenchOrders orders = run.advance(now);
            for (std::size_t i = 0; i < orders.size(); ++i) {
                if (orders.at(i)) {
                    given.push_back({std::chrono::duration<double>(now - kStart).count(),
                                     MotorId(i), *orders.at(i)});
                }
            }
        }
    }
    struct Given {
        double seconds;
        MotorId motor;
        MotorOrder order;
    };
    [[nodiscard]] bool hasMoved() const
    {
        return std::ranges::any_of(given, [](const Given& g) { return g.order.amount != 0; });
    }
    Instant now = kStart;
    BenchRun run;
    std::vector<Given> given;
    std::uint16_t raw = 10; ///< 0.4 A
    std::uint16_t raw2 = 0;
    std::uint16_t status = 0;
    std::uint16_t control = 1;
    bool readsCurrents = true;
    bool readsStatus = true;
};

} // namespace

class TestBenchRun : public QObject {
    Q_OBJECT

private slots:
    void steps_areOrderedInTime();
    void ramp_takesEverySpeed();
    void sine_goesAroundItsMiddle();
    void step_goesBack();
    void repetitions_areDoneInFull();
    void wait_endsWithItsCondition_data();
    void wait_endsWithItsCondition();
    void wait_thatDoesNotCome();
    void nothingIsOrdered_withoutFreshReadings_data();
    void nothingIsOrdered_withoutFreshReadings();
    void limit_endsTheTest_data();
    void limit_endsTheTest();
    void limitOfAStep_holdsOnlyThere();
    void oldLatchedBits_areNoReason();
    void overCurrent_mayBeWanted();
    void busyComputer_ends();
    void dryRun_stopsItsMotors_data();
    void dryRun_stopsItsMotors();
    void dryRun_isTheSameEveryTime();
    void dryRun_knowsTheSettings();
};

void TestBenchRun::steps_areOrderedInTime()
{
    Player player(profileOf(R"({"do":"set","speed":40},{"do":"hold","seconds":0.5},
        {"do":"brake","duty":127},{"do":"hold","seconds":0.25},
        {"do":"accelerate","motor":"both","speed":-20},{"do":"set","motor":"aux","speed":9},
        {"do":"hold","seconds":0.1})"));
    player.go(2s);
    QVERIFY(player.run.hasEnded());
    QCOMPARE(player.run.ending().end, BenchEnd::Completed);
    // Motor 1 and 2 and aux are told to rest first, and motor 1 at once to run.
    QCOMPARE(player.given.size(), std::size_t(7));
    QCOMPARE(player.given[0].order, (MotorOrder{MotorOrder::Action::Set, 40}));
    QCOMPARE(player.given[1].order, MotorOrder());
    QCOMPARE(player.given[2].order, MotorOrder());
    QCOMPARE(player.given[3].order, (MotorOrder{MotorOrder::Action::Brake, 127}));
    QCOMPARE(player.given[4].order, (MotorOrder{MotorOrder::Action::Accelerate, -20}));
    QCOMPARE(player.given[5].motor, MotorId::Motor2);
    QCOMPARE(player.given[6].order, (MotorOrder{MotorOrder::Action::Set, 9}));
    const double begin = player.given[0].seconds;
    QVERIFY(std::abs(player.given[3].seconds - begin - 0.5) < 0.006);
    QVERIFY(std::abs(player.given[4].seconds - begin - 0.75) < 0.006);
    QVERIFY(std::abs(player.run.trace().seconds - 0.85) < 0.01);
}

void TestBenchRun::ramp_takesEverySpeed()
{
    Player player(profileOf(
        R"({"do":"ramp","from":0,"to":40,"seconds":2},{"do":"ramp","to":-10,"seconds":1},{"do":"hold","seconds":0.1})"));
    player.go(5s);
    QCOMPARE(player.run.ending().end, BenchEnd::Completed);
    int last = 0;
    int highest = 0;
    for (const auto& given : player.given) {
        QVERIFY(std::abs(given.order.amount - last) <= 2); // 50 a second at 50 orders a second
        last = given.order.amount;
        highest = std::max(highest, last);
    }
    QCOMPARE(highest, 40);
    QCOMPARE(last, -10);
}

void TestBenchRun::sine_goesAroundItsMiddle()
{
    Player player(profileOf(R"({"do":"sine","middle":20,"amplitude":60,"period":1,"seconds":2})"));
    player.go(3s);
    int lowest = 0;
    int highest = 0;
    for (const auto& given : player.given) {
        lowest = std::min(lowest, given.order.amount);
        highest = std::max(highest, given.order.amount);
        QCOMPARE(given.order.action, MotorOrder::Action::Set);
    }
    QVERIFY(highest >= 79 && highest <= 80);
    QVERIFY(lowest <= -39 && lowest >= -40);
}

void TestBenchRun::step_goesBack()
{
    Player player(profileOf(R"({"do":"set","speed":30},{"do":"hold","seconds":0.2},
        {"do":"step","speed":90,"seconds":0.2},{"do":"hold","seconds":0.2})"));
    player.go(2s);
    QCOMPARE(player.given.size(), std::size_t(3));
    QCOMPARE(player.given[0].order.amount, 30);
    QCOMPARE(player.given[1].order.amount, 90);
    QCOMPARE(player.given[2].order.amount, 30);
}

void TestBenchRun::repetitions_areDoneInFull()
{
    Player player(profileOf(R"({"do":"repeat","times":3,"steps":[
        {"do":"repeat","times":2,"steps":[{"do":"set","speed":10},{"do":"hold","seconds":0.05},
                                          {"do":"set","speed":20},{"do":"hold","seconds":0.05}]},
        {"do":"set","speed":0},{"do":"hold","seconds":0.05}]})"));
    player.go(3s);
    QCOMPARE(player.run.ending().end, BenchEnd::Completed);
    QStringList amounts;
    for (const auto& given : player.given) {
        amounts << QString::number(given.order.amount);
    }
    QCOMPARE(amounts.join(u' '), u"10 20 10 20 0 10 20 10 20 0 10 20 10 20 0"_s);
    QVERIFY(std::abs(player.run.trace().seconds - 0.75) < 0.011);
}

void TestBenchRun::wait_endsWithItsCondition_data()
{
    QTest::addColumn<QByteArray>("condition");
    QTest::addColumn<int>("poll");
    QTest::addColumn<int>("before");
    QTest::addColumn<int>("then");
    QTest::newRow("above") << QByteArray(R"("for":"current-above","amperes":2)")
                           << int(PollId::Currents) << 50 << 51;
    QTest::newRow("below") << QByteArray(R"("for":"current-below","amperes":1)")
                           << int(PollId::Currents) << 25 << 24;
    QTest::newRow("status") << QByteArray(R"("for":"status","bit":"uart-error")")
                            << int(PollId::Status) << 0 << 1;
    QTest::newRow("channel above") << QByteArray(R"("for":"channel-above","channel":1,"raw":3800)")
                                   << int(PollId::RawChannels) << 3800 << 3801;
    QTest::newRow("channel, invalid")
        << QByteArray(R"("for":"channel-above","channel":1,"raw":3800)") << int(PollId::RawChannels)
        << 0xFFFF << 4000;
    QTest::newRow("channel below") << QByteArray(R"("for":"channel-below","channel":1,"raw":3000)")
                                   << int(PollId::RawChannels) << 3000 << 2999;
}

void TestBenchRun::wait_endsWithItsCondition()
{
    QFETCH(QByteArray, condition);
    QFETCH(int, poll);
    QFETCH(int, before);
    QFETCH(int, then);
    Player player(
        profileOf(R"({"do":"set","speed":10},{"do":"wait",)" + condition
                  + R"(,"seconds":5},{"do":"set","speed":20},{"do":"hold","seconds":1})"));
    player.readsCurrents = poll != int(PollId::Currents);
    const auto feed = [&](int value) {
        for (int i = 0; i < 20; ++i) {
            player.sample(PollId(poll), std::uint16_t(value));
            player.go(5ms);
        }
    };
    feed(before);
    QCOMPARE(player.given.back().order.amount, 10);
    feed(then);
    QCOMPARE(player.given.back().order.amount, 20);
}

void TestBenchRun::wait_thatDoesNotCome()
{
    Player player(profileOf(
        R"({"do":"set","speed":10},{"do":"wait","for":"current-above","amperes":9,"seconds":0.3},{"do":"hold","seconds":9})"));
    player.go(1s);
    QVERIFY(player.run.hasEnded());
    QCOMPARE(player.run.ending().end, BenchEnd::NotMet);
    QVERIFY(player.run.ending().reason.contains(u"step 2"_s));
    Player patient(profileOf(
        R"({"do":"wait","for":"current-above","amperes":9,"seconds":0.3,"otherwise":"go-on"},{"do":"hold","seconds":0.1})"));
    patient.go(1s);
    QCOMPARE(patient.run.ending().end, BenchEnd::Completed);
}

void TestBenchRun::nothingIsOrdered_withoutFreshReadings_data()
{
    QTest::addColumn<QString>("missing");
    for (const char* missing : {"currents", "status", "both", "old"}) {
        QTest::newRow(missing) << QString::fromLatin1(missing);
    }
}

void TestBenchRun::nothingIsOrdered_withoutFreshReadings()
{
    QFETCH(QString, missing);
    Player player(profileOf(R"({"do":"set","speed":40},{"do":"hold","seconds":5})"));
    player.readsCurrents = missing == u"status"_s;
    player.readsStatus = missing == u"currents"_s;
    if (missing == u"old"_s) { // read before the person started
        player.run.take({PollId::Currents, {10, 10}, kStart - 1ms});
        player.run.take({PollId::Status, {0}, kStart - 2ms});
        player.run.take({PollId::Status, {0}, kStart - 1ms});
    }
    player.go(10s);
    QVERIFY(player.run.hasEnded());
    QCOMPARE(player.run.ending().end, BenchEnd::Stale);
    QVERIFY(!player.run.hasStarted());
    QVERIFY(player.given.empty());
}

void TestBenchRun::limit_endsTheTest_data()
{
    QTest::addColumn<QByteArray>("limits");
    QTest::addColumn<QString>("event");
    QTest::addColumn<int>("end");
    QTest::addColumn<double>("within"); // s after the event
    const auto row = [](const char* name, const char* limits, const char* event, BenchEnd end,
                        double within) {
        QTest::newRow(name) << QByteArray(limits) << QString::fromLatin1(event) << int(end)
                            << within;
    };
    row("current, at once", R"({"amperes":2})", "current", BenchEnd::Limit, 0.011);
    row("current, motor 2", R"({"amperes":2})", "current2", BenchEnd::Limit, 0.011);
    row("current for a time", R"({"amperes":2,"forSeconds":0.2})", "current", BenchEnd::Limit,
        0.22);
    row("current × time", R"({"ampereSeconds":2.2})", "current", BenchEnd::Limit, 0.5);
    row("length", R"({"seconds":1.2})", "", BenchEnd::Limit, 0.25);
    row("link errors", R"({"linkErrors":3})", "errors", BenchEnd::Limit, 0.011);
    row("driver fault", "{}", "fault", BenchEnd::Limit, 0.011);
    row("over current", "{}", "overcurrent", BenchEnd::Limit, 0.011);
    row("currents stay away", "{}", "no currents", BenchEnd::Stale, 0.52);
    row("status stays away", R"({"staleSeconds":0.2})", "no status", BenchEnd::Stale, 0.22);
    row("serial loses control", "{}", "control", BenchEnd::NotInControl, 0.011);
}

void TestBenchRun::limit_endsTheTest()
{
    QFETCH(QByteArray, limits);
    QFETCH(QString, event);
    QFETCH(int, end);
    QFETCH(double, within);
    Player player(profileOf(R"({"do":"set","motor":"both","speed":40},{"do":"hold","seconds":20})",
                            R"("limits":)" + limits + ","));
    player.go(1s);
    QVERIFY(player.hasMoved() && !player.run.hasEnded());
    player.raw = event == u"current"_s ? 100 : player.raw; // 4 A
    player.raw2 = event == u"current2"_s ? 100 : player.raw2;
    player.readsCurrents = event != u"no currents"_s;
    player.readsStatus = event != u"no status"_s;
    player.status = event == u"fault"_s ? 0x40 : event == u"overcurrent"_s ? 0x20 : 0;
    player.control = event == u"control"_s ? 0 : 1;
    if (event == u"errors"_s) {
        player.run.setLinkErrors(3);
        QVERIFY(!player.run.hasEnded());
        player.run.setLinkErrors(4);
    }
    const double before = std::chrono::duration<double>(player.now - kStart).count();
    player.go(10s);
    QVERIFY(player.run.hasEnded());
    QCOMPARE(int(player.run.ending().end), end);
    QVERIFY(!player.run.ending().reason.isEmpty());
    const double took = std::chrono::duration<double>(player.now - kStart).count() - before;
    QVERIFY2(took <= within, qPrintable(QString::number(took)));
    // Whoever drives it stops the motors; the run itself gives no order any more.
    const std::size_t given = player.given.size();
    player.run.take({PollId::Currents, {10, 10}, player.now});
    QVERIFY(player.run.advance(player.now + 10s) == BenchOrders());
    QCOMPARE(player.given.size(), given);
}

void TestBenchRun::limitOfAStep_holdsOnlyThere()
{
    const auto profile = profileOf(R"({"do":"set","speed":40},{"do":"hold","seconds":0.5},
        {"do":"hold","seconds":0.5,"limits":{"amperes":1}},{"do":"hold","seconds":0.5})");
    Player early(profile);
    early.raw = 50;
    early.go(400ms);
    QVERIFY(!early.run.hasEnded());
    early.go(300ms);
    QVERIFY(early.run.hasEnded());
    QVERIFY(early.run.ending().reason.contains(u"limit of a step"_s));
    Player late(profile);
    late.go(1100ms);
    late.raw = 50;
    late.go(1s);
    QCOMPARE(late.run.ending().end, BenchEnd::Completed);
}

void TestBenchRun::oldLatchedBits_areNoReason()
{
    Player player(profileOf(R"({"do":"set","speed":40},{"do":"hold","seconds":0.5})"));
    player.status = 0xF0; // latched since yesterday; the first read clears it
    player.go(1s);
    QCOMPARE(player.run.ending().end, BenchEnd::Completed);
    Player faulty(profileOf(R"({"do":"set","speed":40},{"do":"hold","seconds":0.5})"));
    faulty.status = 0x10;
    faulty.go(5ms);
    faulty.status = 0x10; // still there
    faulty.go(1s);
    QCOMPARE(faulty.run.ending().end, BenchEnd::Limit);
    QVERIFY(!faulty.hasMoved());
}

void TestBenchRun::overCurrent_mayBeWanted()
{
    Player player(profileOf(R"({"do":"set","speed":40},{"do":"hold","seconds":0.5})",
                            R"("limits":{"overCurrent":false},)"));
    player.go(200ms);
    player.status = 0x20;
    player.go(1s);
    QCOMPARE(player.run.ending().end, BenchEnd::Completed);
    QVERIFY(std::ranges::any_of(player.run.trace().events,
                                [](const auto& event) { return event.severity == 1; }));
}

void TestBenchRun::busyComputer_ends()
{
    Player player(profileOf(R"({"do":"ramp","to":100,"seconds":10})"));
    player.go(1s);
    player.now += 2s; // nothing was looked at meanwhile
    player.go(1s);
    QVERIFY(player.run.hasEnded());
    QCOMPARE(player.run.ending().end, BenchEnd::Stale);
    for (const auto& given : player.given) {
        QVERIFY(given.order.amount <= 10);
    }
}

void TestBenchRun::dryRun_stopsItsMotors_data()
{
    QTest::addColumn<QByteArray>("more");
    QTest::addColumn<int>("held");
    QTest::addColumn<bool>("cancelled");
    QTest::addColumn<int>("end");
    QTest::newRow("to its end") << QByteArray() << 0 << false << int(BenchEnd::Completed);
    QTest::newRow("a limit") << QByteArray(R"("limits":{"amperes":2,"forSeconds":0.1},)") << 1
                             << false << int(BenchEnd::Limit);
    QTest::newRow("cancelled") << QByteArray() << 0 << true << int(BenchEnd::Stopped);
}

/// On the wire of the simulator: the last order that each motor hears is neutral.
void TestBenchRun::dryRun_stopsItsMotors()
{
    QFETCH(QByteArray, more);
    QFETCH(int, held);
    QFETCH(bool, cancelled);
    QFETCH(int, end);
    BenchDryRunOptions options;
    options.isHeld[0] = held == 1;
    BenchDryRun dry(
        profileOf(R"({"do":"set","motor":"both","speed":60},{"do":"set","motor":"aux","speed":60},
                                 {"do":"hold","seconds":2})",
                  more),
        options);
    QVERIFY(dry.advance(1s) || held == 1);
    auto& device = dry.line().device();
    if (held == 0) {
        QVERIFY(device.output(MotorId::Motor1).speed == 60
                && device.output(MotorId::Aux).speed == 60);
    }
    if (cancelled) {
        dry.cancel();
    }
    while (dry.advance(1s)) { }
    QCOMPARE(int(dry.run().ending().end), end);
    for (const MotorId motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
        QCOMPARE(device.output(motor), sim::MotorOutput());
    }
    int stops = 0;
    for (auto packet = device.heard().rbegin(); packet != device.heard().rend() && stops < 2;
         ++packet) {
        const auto opcode = std::uint8_t(packet->bytes.front());
        if (opcode >= 0xC0) {
            QVERIFY2(opcode == 0xF0 || (opcode & 0xF0) == 0xD0, packet->bytes.toHex());
            QVERIFY(!packet->bytes.mid(1).contains(char(60)));
            ++stops;
        }
    }
    QCOMPARE(stops, 2);
}

void TestBenchRun::dryRun_isTheSameEveryTime()
{
    const auto profile = profileOf(R"({"do":"set","speed":60},{"do":"hold","seconds":2})");
    BenchDryRun first(profile);
    BenchDryRun second(profile);
    while (first.advance(10s)) { }
    while (second.advance(70ms)) { }
    const auto& a = first.run().trace().samples;
    const auto& b = second.run().trace().samples;
    QVERIFY(a.size() > 140 && a.size() < 180); // 80 a second
    QCOMPARE(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        QCOMPARE(a[i].raw, b[i].raw);
    }
}

void TestBenchRun::dryRun_knowsTheSettings()
{
    BenchDryRunOptions options;
    options.parameters[parameterRow("motor1-acceleration").number] = 10; // 127 in 1.27 s
    options.parameters[parameterRow("device-number").number] = 99; // but we talk as before
    BenchDryRun dry(profileOf(R"({"do":"accelerate","speed":100},{"do":"hold","seconds":2})"),
                    options);
    QVERIFY(dry.advance(700ms));
    const int reached = dry.line().device().output(MotorId::Motor1).speed;
    QVERIFY2(reached > 20 && reached < 70, qPrintable(QString::number(reached)));
    while (dry.advance(1s)) { }
    QCOMPARE(dry.run().ending().end, BenchEnd::Completed);
}

QTEST_GUILESS_MAIN(TestBenchRun)
#include "tst_benchrun.moc"
