// SPDX-License-Identifier: GPL-3.0-or-later
// The façade with its real thread, against simulated controllers in real time.
#include "protocol/session/controller.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr MotorOrder kHalf{MotorOrder::Action::Set, 64};

/// A façade, what it fills, and everything that it did on the line.
class Bench {
public:
    explicit Bench(const QString& port = u"sim:"_s) : controller(&store, &latch)
    {
        options.port = port;
        QObject::connect(&controller, &Controller::recordsArrived, &context,
                         [this](const std::vector<TransactionRecord>& arrived) {
                             records.insert(records.end(), arrived.begin(), arrived.end());
                         });
        QObject::connect(&controller, &Controller::stateChanged, &context,
                         [this](LinkState state) { states.push_back(state); });
    }
    void open() { controller.open(options); }
    [[nodiscard]] bool connected()
    {
        open();
        return QTest::qWaitFor([this] { return controller.state() == LinkState::Connected; }, 5000);
    }
    [[nodiscard]] QByteArrayList motorPackets() const
    {
        QByteArrayList packets;
        for (const TransactionRecord& record : records) {
            if (record.isRaw || record.command.row().kind == CommandKind::Motor) {
                packets.append(record.sentBytes);
            }
        }
        return packets;
    }
    [[nodiscard]] ErrorCode codeOf(const Result<void>& result) const
    {
        return result ? ErrorCode::Cancelled : result.error().code;
    }
    /// Asks with `start` and gives the error's code, or none when it was answered.
    std::optional<ErrorCode> errorOf(const std::function<void(Controller::ReplyHandler)>& start)
    {
        std::optional<Result<Reply>> answer;
        start([&](const Result<Reply>& reply) { answer = reply; });
        [&] { QTRY_VERIFY_WITH_TIMEOUT(answer.has_value(), 5000); }();
        return !answer || *answer ? std::nullopt : std::optional(answer->error().code);
    }

    QObject context;
    TelemetryStore store;
    StatusLatch latch;
    std::vector<TransactionRecord> records;
    std::vector<LinkState> states;
    Controller controller;
    OpenOptions options;
};

const QByteArrayList kStop{QByteArray::fromHex("da0000"), QByteArray::fromHex("f000")};

} // namespace

class TestController : public QObject {
    Q_OBJECT

private slots:
    void connect_identifiesAndPolls()
    {
        Bench bench;
        QVERIFY(bench.connected());
        QCOMPARE(bench.controller.device().signature->text(), u"TReXJr1.2"_s);
        QTRY_COMPARE(bench.controller.device().mode, std::optional(Mode::SerialRc));
        QTRY_COMPARE(bench.controller.device().serialControls, std::optional(true));
        QTRY_VERIFY(bench.controller.device().learnedMask.has_value());
        QTRY_VERIFY(bench.latch.lastRead(StatusLatch::Byte::Status).has_value());
        QTRY_VERIFY(bench.latch.lastRead(StatusLatch::Byte::Uart).has_value());
        QCOMPARE(bench.states, (std::vector{LinkState::Connecting, LinkState::Connected}));
        QVERIFY2(bench.motorPackets().isEmpty(), "nothing moves unasked");
    }

    void want_polls_wantNothing_ends()
    {
        Bench bench;
        QVERIFY(bench.connected());
        QVERIFY(bench.store.latest(PollId::Currents) == nullptr);
        QObject panel;
        QObject other;
        bench.controller.want(&panel, PollId::Currents, 20.0);
        bench.controller.want(&other, PollId::Currents, 80.0);
        QTRY_VERIFY(bench.store.latest(PollId::Currents) != nullptr);
        QTRY_COMPARE(bench.controller.stats().askedHertz.front(), 80.0); // the highest counts
        bench.controller.wantNothing(&other);
        QTRY_COMPARE(bench.controller.stats().askedHertz.front(), 20.0);
        bench.controller.wantNothing(&panel);
        QTRY_COMPARE(bench.controller.stats().askedHertz.front(), 0.0);
        QTRY_VERIFY(bench.controller.stats().askedHertz.at(std::size_t(PollId::Status)) > 0.0);
    }

    void gate_refusesUntilArmed() // the only way to a motor
    {
        Bench bench;
        QCOMPARE(bench.codeOf(bench.controller.arm()), ErrorCode::NotConnected);
        QCOMPARE(bench.codeOf(bench.controller.driveMotor(MotorId::Motor1, kHalf)),
                 ErrorCode::NotConnected);
        QVERIFY(bench.connected());
        QVERIFY(!bench.controller.isArmed());
        QCOMPARE(bench.codeOf(bench.controller.driveMotor(MotorId::Motor1, kHalf)),
                 ErrorCode::Disarmed);
        QCOMPARE(bench.codeOf(bench.controller.driveBoth(kHalf, kHalf)), ErrorCode::Disarmed);
        const auto raw = [&](const char* hex) {
            return bench.errorOf([&](const Controller::ReplyHandler& handler) {
                bench.controller.requestRaw(QByteArray::fromHex(hex), 0, &bench.context, handler);
            });
        };
        for (const char* hex : {"c240", "80074240", "8007707f", "8007", "80", "82c240", "f07f"}) {
            QCOMPARE(raw(hex), std::optional(ErrorCode::Disarmed));
        }
        const auto motor = bench.errorOf([&](const Controller::ReplyHandler& handler) {
            bench.controller.request(*driveMotor(MotorId::Motor1, kHalf), &bench.context, handler);
        });
        QCOMPARE(motor, std::optional(ErrorCode::BadCommand));
        QVERIFY(bench.motorPackets().isEmpty());

        QVERIFY(bench.controller.arm().has_value());
        QVERIFY(bench.controller.driveMotor(MotorId::Motor1, kHalf).has_value());
        QCOMPARE(bench.controller.lastOrder(MotorId::Motor1), kHalf);
        QTRY_VERIFY(bench.motorPackets().contains(QByteArray::fromHex("c240")));
        QCOMPARE(bench.codeOf(
                     bench.controller.driveMotor(MotorId::Motor1, {MotorOrder::Action::Set, 128})),
                 ErrorCode::OutOfRange);
    }

    void stop_goesOutDisarmsAndLocks_data()
    {
        QTest::addColumn<bool>("brake");
        QTest::addColumn<QByteArray>("first");
        QTest::newRow("coast") << false << QByteArray::fromHex("da0000");
        QTest::newRow("brake") << true << QByteArray::fromHex("d07f7f");
    }
    void stop_goesOutDisarmsAndLocks()
    {
        QFETCH(bool, brake);
        QFETCH(QByteArray, first);
        Bench bench;
        QVERIFY(bench.connected());
        QVERIFY(bench.controller.arm().has_value());
        QSignalSpy stopped(&bench.controller, &Controller::stopped);
        for (int speed = 1; speed <= 100; ++speed) {
            QVERIFY(bench.controller
                        .driveMotor(MotorId::Motor1, {MotorOrder::Action::Accelerate, speed})
                        .has_value());
        }
        bool told = false;
        bench.controller.stop(brake ? Controller::StopKind::Brake : Controller::StopKind::Coast,
                              &bench.context,
                              [&](const Result<Reply>& r) { told = r.has_value(); });
        QVERIFY(!bench.controller.isArmed());
        QCOMPARE(bench.controller.lastOrder(MotorId::Motor1), MotorOrder{});
        QCOMPARE(bench.codeOf(bench.controller.driveMotor(MotorId::Motor1, kHalf)),
                 ErrorCode::LockedOut);
        QCOMPARE(bench.codeOf(bench.controller.arm()), ErrorCode::LockedOut);
        QTRY_COMPARE(stopped.count(), 1);
        QVERIFY(told);
        QVERIFY(bench.controller.stopLatencyMsMax() > 0.0);
        const QByteArrayList packets = bench.motorPackets();
        QVERIFY(packets.size() >= 2);
        const QByteArrayList last = packets.last(2);
        const bool isFirst = static_cast<std::uint8_t>(last.front()[0]) >> 4 == 0xD
            && last.front().mid(1) == first.mid(1);
        QVERIFY2(isFirst, last.front().toHex());
        QCOMPARE(last.back(), kStop.back());
        QTRY_VERIFY(bench.controller.arm().has_value()); // by hand, after the lock-out
        QVERIFY(bench.controller.isArmed());
    }

    void stop_whileNotConnected_isAnswered()
    {
        Bench bench;
        const auto error = bench.errorOf([&](const Controller::ReplyHandler& handler) {
            bench.controller.stop(Controller::StopKind::Coast, &bench.context, handler);
        });
        QCOMPARE(error, std::optional(ErrorCode::NotConnected));
    }

    void close_sendsStop_orNot_data()
    {
        QTest::addColumn<bool>("stopOnClose");
        QTest::newRow("stops") << true;
        QTest::newRow("leaves the motors") << false;
    }
    void close_sendsStop_orNot()
    {
        QFETCH(bool, stopOnClose);
        Bench bench;
        bench.options.stopOnClose = stopOnClose;
        QVERIFY(bench.connected());
        QSignalSpy closed(&bench.controller, &Controller::closed);
        bench.controller.close();
        bench.controller.close(); // once more makes no difference
        QTRY_COMPARE(closed.count(), 1);
        QCOMPARE(bench.controller.state(), LinkState::Disconnected);
        QCOMPARE(bench.motorPackets(), stopOnClose ? kStop : QByteArrayList{});
        QVERIFY(!bench.controller.device().signature);
    }

    void lostLink_isNoticedDisarmedAndRegained_data()
    {
        QTest::addColumn<QString>("fault");
        QTest::newRow("silence") << u"fault=silent-after=1&fault=silent-for=1.5"_s;
        QTest::newRow("hang-up") << u"fault=hangup-after=1&fault=hangup-for=1.5"_s;
    }
    void lostLink_isNoticedDisarmedAndRegained()
    {
        QFETCH(QString, fault);
        Bench bench(u"sim:?"_s + fault);
        QElapsedTimer clock;
        clock.start();
        QVERIFY(bench.connected());
        QVERIFY(bench.controller.arm().has_value());
        QVERIFY(bench.controller.driveMotor(MotorId::Motor1, kHalf).has_value());
        QSignalSpy reconnected(&bench.controller, &Controller::reconnected);
        QTRY_VERIFY_WITH_TIMEOUT(bench.controller.state() != LinkState::Connected, 5000);
        QVERIFY2(clock.elapsed() < 2600, "noticed within a second, and some slack of this machine");
        QVERIFY(!bench.controller.isArmed());
        QVERIFY(!bench.controller.device().signature);
        QVERIFY(bench.store.latest(PollId::Status) == nullptr);
        QCOMPARE(bench.controller.lastOrder(MotorId::Motor1), MotorOrder{});
        QCOMPARE(bench.codeOf(bench.controller.arm()), ErrorCode::NotConnected);
        const auto asked = bench.errorOf([&](const Controller::ReplyHandler& handler) {
            bench.controller.request(query("get-mode"), &bench.context, handler);
        });
        QCOMPARE(asked, std::optional(ErrorCode::NotConnected));
        QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Connected, 6000);
        QCOMPARE(reconnected.count(), 1);
        QVERIFY2(!bench.controller.isArmed(), "never armed again by itself");
        QTRY_COMPARE(bench.motorPackets().mid(bench.motorPackets().size() - 2), kStop);
        QCOMPARE(bench.motorPackets().count(QByteArray::fromHex("c240")), 1);
    }

    void lostLinkWithoutReconnect_ends()
    {
        Bench bench(u"sim:?fault=hangup-after=0.3"_s);
        bench.options.reconnect = false;
        QVERIFY(bench.connected());
        QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Disconnected, 5000);
        QCOMPARE(bench.controller.lastError()->code, ErrorCode::LineLost);
    }

    void badAddress_isSaidOnceAndNotTriedAgain()
    {
        Bench bench(u"sim:?colour=red"_s);
        bench.open();
        QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
        QVERIFY(bench.controller.lastError().has_value());
        bench.options.port = u"sim:"_s;
        QVERIFY(bench.connected());
    }

    void silentController_endsOrIsTriedAgain()
    {
        Bench bench(u"sim:?fault=silent-for=1"_s);
        bench.options.reconnect = false;
        bench.open();
        QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Disconnected, 5000);
        QCOMPARE(bench.controller.lastError()->code, ErrorCode::NoReply);
        // Given up, and not closed by anyone: opening again must work all the same.
        bench.options.reconnect = true;
        bench.open();
        QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Connected, 5000);
    }

    void requests_failCleanlyWhenNotConnected()
    {
        Bench bench;
        const auto error = [&] {
            return bench.errorOf([&](const Controller::ReplyHandler& handler) {
                bench.controller.request(query("get-mode"), &bench.context, handler);
            });
        };
        QCOMPARE(error(), std::optional(ErrorCode::NotConnected));
        QVERIFY(bench.connected());
        QCOMPARE(error(), std::nullopt);
        // Asked, and closed at once: an answer or an error, never silence.
        std::optional<Result<Reply>> answer;
        bench.controller.request(query("get-mode"), &bench.context,
                                 [&](const Result<Reply>& reply) { answer = reply; });
        bench.controller.close();
        QTRY_VERIFY(answer.has_value());
        QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
        QCOMPARE(error(), std::optional(ErrorCode::NotConnected));
    }

    void deadContext_isNotCalled()
    {
        Bench bench;
        QVERIFY(bench.connected());
        auto panel = std::make_unique<QObject>();
        bool isCalled = false;
        bench.controller.request(query("get-mode"), panel.get(),
                                 [&](const Result<Reply>&) { isCalled = true; });
        panel.reset();
        const auto next = bench.errorOf([&](const Controller::ReplyHandler& handler) {
            bench.controller.request(query("get-mode"), &bench.context, handler);
        });
        QCOMPARE(next, std::nullopt); // the first has been answered by now
        QVERIFY(!isCalled);
    }

    void openWhileOpen_closesTheFirst()
    {
        Bench bench;
        QVERIFY(bench.connected());
        bench.options.port = u"sim:?firmware=1.3"_s;
        QVERIFY(bench.connected() || true);
        QTRY_VERIFY(bench.controller.device().signature
                    && bench.controller.device().signature->minor == 3);
        QCOMPARE(bench.motorPackets(), kStop); // the first was left stopped
    }

    void closeAfterOpenWhileOpen_ends()
    {
        Bench bench;
        QVERIFY(bench.connected());
        QSignalSpy closed(&bench.controller, &Controller::closed);
        bench.options.port = u"sim:?firmware=1.3"_s;
        bench.open();
        bench.controller.close(); // changed their mind
        QTRY_COMPARE(closed.count(), 1);
        const auto error = bench.errorOf([&](const Controller::ReplyHandler& handler) {
            bench.controller.request(query("get-mode"), &bench.context, handler);
        });
        QCOMPARE(error, std::optional(ErrorCode::NotConnected));
        QCOMPARE(bench.controller.state(), LinkState::Disconnected);
    }

    void destructionWhileConnected_isClean()
    {
        for (int i = 0; i < 5; ++i) {
            auto bench = std::make_unique<Bench>();
            QVERIFY(bench->connected());
            bench->controller.want(&bench->context, PollId::Currents, 80.0);
            bench->controller.request(query("get-mode"), nullptr, [](const Result<Reply>&) {});
            bench.reset();
        }
        Bench connecting(u"sim:?fault=silent-for=100"_s);
        connecting.open();
    }

    void fiftyCycles_leaveNothingBehind()
    {
        Bench bench(u"sim:?pace=0"_s);
        for (int i = 0; i < 50; ++i) {
            QVERIFY(bench.connected());
            bench.controller.close();
            QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
        }
        QCOMPARE(bench.states.size(), std::size_t{50 * 3});
        QCOMPARE(bench.motorPackets().size(), 50 * 2);
    }

    void storedMotorOrder_isVisibleAsNotInControl() // C-50
    {
        // In RC mode the controller stores an order and obeys it once serial override starts: the
        // façade takes the order, keeps it as the last one, and says that serial has no control.
        Bench bench(u"sim:?mode=rc"_s);
        QVERIFY(bench.connected());
        QTRY_COMPARE(bench.controller.device().serialControls, std::optional(false));
        QVERIFY(bench.controller.arm().has_value());
        QVERIFY(bench.controller.driveMotor(MotorId::Motor1, kHalf).has_value());
        QTRY_VERIFY(bench.motorPackets().contains(QByteArray::fromHex("c240")));
        QCOMPARE(bench.controller.lastOrder(MotorId::Motor1), kHalf);
        QCOMPARE(bench.controller.device().serialControls, std::optional(false));
    }

    void latchedBits_ofAskedRepliesAreKept() // C-20 C-21 C-22
    {
        Bench bench;
        QVERIFY(bench.connected());
        QVERIFY(bench.controller.arm().has_value()); // raw bytes that might be a motor's
        const auto& format = bench.latch.entry(StatusLatch::Byte::Uart, 6);
        QCOMPARE(format.count, 0);
        // An unknown command latches a format error; whoever reads it, the history has it.
        bench.controller.requestRaw(QByteArray::fromHex("b0"), 0, &bench.context, {});
        bench.controller.request(query("get-uart-errors"), &bench.context, {});
        QTRY_VERIFY(format.count >= 1);
        QTRY_VERIFY(!format.lit); // cleared by that very reading
        QVERIFY(format.firstSeen.isValid());
    }

    void echo_isFoundAndSaid() // C-12
    {
        Bench bench(u"sim:?echo=1"_s);
        QSignalSpy log(&bench.controller, &Controller::eventLogged);
        QVERIFY(bench.connected());
        QTRY_VERIFY(bench.controller.stats().echo);
        QTRY_VERIFY(bench.controller.device().mode.has_value());
        QCOMPARE(bench.controller.stats().timeouts, 0U);
        QVERIFY(std::any_of(log.begin(), log.end(), [](const QList<QVariant>& event) {
            return event.at(1).toString().contains(u"echo"_s);
        }));
    }

    void longTimeout_doesNotHoldAStopBack()
    {
        Bench bench(u"sim:?fault=silent-after=0.7"_s);
        bench.options.line.timeout = std::chrono::seconds(30);
        QVERIFY(bench.connected());
        QVERIFY(bench.controller.arm().has_value());
        QVERIFY(bench.controller.driveMotor(MotorId::Motor1, kHalf).has_value());
        QTest::qWait(1000); // a poll now waits half a minute for its reply
        QElapsedTimer clock;
        clock.start();
        QSignalSpy stopped(&bench.controller, &Controller::stopped);
        bench.controller.stop();
        QTRY_COMPARE(stopped.count(), 1);
        QVERIFY(clock.elapsed() < 2000);
        QCOMPARE(bench.motorPackets().mid(bench.motorPackets().size() - 2), kStop);
    }
};

QTEST_GUILESS_MAIN(TestController)
#include "tst_controller.moc"
