// SPDX-License-Identifier: GPL-3.0-or-later
// Settings over the real façade and link thread, against a simulated controller whose EEPROM file
// is looked at afterwards.
#include "protocol/session/devicesettings.h"
#include "protocol/sim/eeprom.h"
#include "protocol/telemetry/statuslatch.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

/// A connection to a simulated controller, and what its settings answered.
class Bench {
public:
    explicit Bench(const QString& query = {}, const LineSettings& line = {})
        : controller(&store, &latch), settings(controller)
    {
        options.port = u"sim:?pace=0&state=%1"_s.arg(stateFile());
        options.port += query.isEmpty() ? QString() : u'&' + query;
        options.line = line;
    }

    void open()
    {
        controller.open(options);
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Connected, 5000);
        QTRY_VERIFY_WITH_TIMEOUT(controller.device().mode.has_value(), 5000);
    }
    /// The file is written when the simulated controller goes.
    sim::Eeprom closeAndLook()
    {
        controller.close();
        [&] { QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Disconnected, 5000); }();
        OpenOptions another; // another controller: the first one goes
        another.port = u"sim:?pace=0"_s;
        controller.open(another);
        [&] { QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Connected, 5000); }();
        const auto eeproms = sim::loadEeproms(stateFile());
        return eeproms && !eeproms->empty() ? eeproms->front() : sim::Eeprom{};
    }

    Result<DeviceSettings::ParameterWrite> write(const ParameterRow& row, int raw,
                                                 bool verify = true)
    {
        return wait<DeviceSettings::ParameterWrite>([&](const auto& handler) {
            settings.writeParameter(row, raw, verify, &context, handler);
        });
    }
    Result<int> read(const ParameterRow& row)
    {
        return wait<int>(
            [&](const auto& handler) { settings.readParameter(row, &context, handler); });
    }
    Result<DeviceSettings::CalibrationWrite> write(int channel, const Calibration& calibration)
    {
        return wait<DeviceSettings::CalibrationWrite>([&](const auto& handler) {
            settings.writeCalibration(channel, calibration, &context, handler);
        });
    }
    Result<Calibration> readCalibration(int channel)
    {
        return wait<Calibration>(
            [&](const auto& handler) { settings.readCalibration(channel, &context, handler); });
    }
    /// Calls `start` with a handler and waits for its answer; it comes exactly once.
    template <class T, class F>
    Result<T> wait(const F& start)
    {
        std::optional<Result<T>> answer;
        int answers = 0;
        start([&](const Result<T>& result) {
            answer = result;
            ++answers;
        });
        [&] { QTRY_VERIFY_WITH_TIMEOUT(answer.has_value(), 10'000); }();
        [&] { QCOMPARE(answers, 1); }();
        return answer.value_or(fail(ErrorCode::Cancelled));
    }

    QTemporaryDir folder;
    [[nodiscard]] QString stateFile() const { return folder.filePath(u"state.json"_s); }
    QObject context;
    TelemetryStore store;
    StatusLatch latch;
    Controller controller;
    DeviceSettings settings;
    OpenOptions options;
};

constexpr const ParameterRow& kTimeout = parameterRow("serial-timeout");
constexpr const ParameterRow& kMotorMode = parameterRow("motor-mode");

} // namespace

class TestDeviceSettings : public QObject {
    Q_OBJECT

private slots:
    void write_isReadBackAndKept() // C-38 C-39 C-40
    {
        Bench bench;
        bench.open();
        QSignalSpy changed(&bench.settings, &DeviceSettings::parameterChanged);
        QVERIFY(!bench.settings.parameter(kTimeout.number));
        const auto written = bench.write(kTimeout, 5);
        QVERIFY(written.has_value());
        QCOMPARE(written->from, 0);
        QCOMPARE(written->to, 5);
        QVERIFY(written->verified);
        QCOMPARE(bench.settings.parameter(kTimeout.number), std::optional(5));
        QVERIFY(!bench.settings.isPending(kTimeout.number));
        QVERIFY(changed.count() >= 1);
        QCOMPARE(bench.closeAndLook().at(kTimeout.number), std::uint8_t{5});
    }

    void unchangedValue_isNotWrittenAgain()
    {
        Bench bench;
        bench.open();
        QVERIFY(bench.write(kTimeout, 5).has_value());
        for (int i = 0; i < 5; ++i) {
            const auto again = bench.write(kTimeout, 5);
            QVERIFY(again.has_value() && again->verified);
        }
        const Calibration stick{2600, 3700, 4900, 80};
        QVERIFY(bench.write(1, stick).has_value());
        QVERIFY(bench.write(1, stick).has_value());
        const sim::Eeprom eeprom = bench.closeAndLook();
        QCOMPARE(eeprom.writeCount(kTimeout.number), 1);
        QCOMPARE(eeprom.totalWrites(), 1 + 8);
    }

    void valueOutOfRange_isNotSent() // C-59
    {
        Bench bench;
        bench.open();
        const auto refused = bench.write(parameterRow("motor1-pwm-prescaler"), 4);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::OutOfRange);
        QCOMPARE(bench.write(parameterRow("factory-reset"), 127).error().code,
                 ErrorCode::OutOfRange);
        QCOMPARE(bench.write(1, {3000, 2999, 4000, 10}).error().code,
                 ErrorCode::OutOfRange); // C-36
        QCOMPARE(bench.write(1, {3000, 3000, 3000, 10}).error().code, ErrorCode::OutOfRange);
        QCOMPARE(bench.write(1, {3000, 3500, 16384, 10}).error().code, ErrorCode::OutOfRange);
        QCOMPARE(bench.closeAndLook().totalWrites(), 0);
    }

    void outsideSerialMode_theRefusalIsNamed() // C-58 C-38 C-37
    {
        Bench bench(u"mode=rc"_s);
        bench.open();
        const auto refused = bench.write(kTimeout, 5);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::NotInSerialMode);
        QCOMPARE(refused.error().context, u"serial-timeout"_s);
        QCOMPARE(bench.write(2, {2600, 3700, 4900, 80}).error().code, ErrorCode::NotInSerialMode);
        QVERIFY2(bench.read(kTimeout).has_value(), "reading works in any mode");
        QCOMPARE(bench.settings.parameter(kTimeout.number), std::optional(0));
    }

    void lostAnswer_isReadBackNotRepeated_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 1; seed <= 3; ++seed) {
            QTest::addRow("seed %d", seed) << seed;
        }
    }
    void lostAnswer_isReadBackNotRepeated() // C-37 C-38
    {
        QFETCH(int, seed);
        Bench bench(u"fault=drop=0.15&seed=%1"_s.arg(seed));
        bench.open();
        int writes = 0;
        int lost = 0;
        connect(&bench.controller, &Controller::recordsArrived, &bench.context,
                [&](const std::vector<TransactionRecord>& records) {
                    for (const TransactionRecord& record : records) {
                        if (record.command.opcode == 0xAF && !record.isRaw) {
                            ++writes;
                            lost += record.error ? 1 : 0;
                        }
                    }
                });
        int asked = 0;
        int current = 0;
        for (int raw = 1; raw <= 10; ++raw) {
            const auto written = bench.write(kTimeout, raw);
            asked += 1;
            if (written) {
                QCOMPARE(written->to, raw);
                QVERIFY(written->verified);
                current = raw;
            }
        }
        QVERIFY2(writes <= asked, "a write is never sent twice");
        QVERIFY2(current > 0, "a lost answer is no lost write");
        const sim::Eeprom eeprom = bench.closeAndLook();
        QVERIFY(eeprom.writeCount(kTimeout.number) <= asked);
    }

    void lostLink_leavesNothingOldToShow()
    {
        Bench bench(u"fault=silent-after=1.2"_s);
        bench.open();
        QVERIFY(bench.read(kTimeout).has_value());
        QTRY_VERIFY_WITH_TIMEOUT(bench.controller.state() != LinkState::Connected, 5000);
        QVERIFY(!bench.settings.parameter(kTimeout.number));
        QCOMPARE(bench.write(kTimeout, 9).error().code, ErrorCode::NotConnected);
    }

    void discardedWrite_isNotTrustedAndExplained() // C-37 C-38
    {
        // A controller that discards settings as untrustworthy, as after a damaged byte, and tells
        // so in its UART error byte only.
        int writes = 0;
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        connect(&server, &QTcpServer::newConnection, &server, [&] {
            QTcpSocket* peer = server.nextPendingConnection();
            connect(peer, &QTcpSocket::readyRead, peer, [peer, &writes] {
                QByteArray packet = peer->readAll(); // one at a time: the host waits, but for stops
                packet.replace(QByteArray::fromHex("da0000"), QByteArray());
                packet.replace(QByteArray::fromHex("f000"), QByteArray());
                if (packet.isEmpty()) {
                    return;
                }
                switch (static_cast<std::uint8_t>(packet.front())) {
                case 0x81:
                    peer->write("TReXJr1.2");
                    break;
                case 0x82:
                    peer->write("r");
                    break;
                case 0x85:
                    peer->write("\x10"); // frame error
                    break;
                case 0xA0:
                case 0xAF:
                    ++writes;
                    break;
                case 0x90:
                    peer->write(QByteArray::fromHex("c409a60e88136400"));
                    break;
                default:
                    peer->write(QByteArray(1, '\0'));
                }
                peer->flush();
            });
        });
        Bench bench;
        bench.options.port = u"tcp://127.0.0.1:%1"_s.arg(server.serverPort());
        bench.open();
        for (const Error& error :
             {bench.write(kTimeout, 5).error(), bench.write(1, {2600, 3700, 4900, 80}).error()}) {
            QCOMPARE(error.code, ErrorCode::NotTrusted);
            QVERIFY2(error.context.contains(u"frame"_s), qPrintable(error.context));
        }
        QCOMPARE(writes, 2); // never repeated blindly
        QCOMPARE(bench.settings.parameter(kTimeout.number), std::optional(0));
    }

    void calibration_isWrittenAsTheControllerReadsIt_data()
    {
        QTest::addColumn<QString>("quirk");
        QTest::addColumn<Calibration>("wanted");
        QTest::addColumn<bool>("verified");
        QTest::addColumn<bool>("eightBit");
        const Calibration even{2560 + 100, 3584 + 5, 4864 + 127, 100};
        const Calibration odd{2560 + 200, 3584 + 130, 4864 + 250, 100}; // low bytes above 127
        QTest::newRow("seven bits") << u"7"_s << odd << true << false;
        QTest::newRow("eight bits, can be sent") << u"8"_s << even << true << true;
        QTest::newRow("eight bits, nearest") << u"8"_s << odd << false << true;
        QTest::newRow("eight bits, small") << u"8"_s << Calibration{0, 50, 100, 5} << true << false;
    }
    void calibration_isWrittenAsTheControllerReadsIt() // C-35
    {
        QFETCH(QString, quirk);
        QFETCH(Calibration, wanted);
        QFETCH(bool, verified);
        QFETCH(bool, eightBit);
        Bench bench(u"quirk=calibration-bytes=%1"_s.arg(quirk));
        bench.open();
        const auto written = bench.write(3, wanted);
        QVERIFY(written.has_value());
        QCOMPARE(written->verified, verified);
        QCOMPARE(written->eightBitBytes, eightBit);
        QCOMPARE(bench.readCalibration(3), Result<Calibration>(written->readBack));
        QCOMPARE(bench.settings.calibration(InputKind::Rc, 3), std::optional(written->readBack));
        const auto near = [](int a, int b) { return std::abs(a - b) <= 64; };
        QVERIFY(near(written->readBack.minimum, wanted.minimum));
        QVERIFY(near(written->readBack.neutral, wanted.neutral));
        QVERIFY(near(written->readBack.maximum, wanted.maximum));
    }

    void readAll_bringsEverything() // C-32 C-34
    {
        Bench bench;
        bench.open();
        std::vector<int> steps;
        int total = 0;
        const auto done = bench.wait<void>([&](const auto& handler) {
            bench.settings.readAll(
                &bench.context,
                [&](int at, int of) {
                    steps.push_back(at);
                    total = of;
                },
                handler);
        });
        QVERIFY(done.has_value());
        QVERIFY(std::is_sorted(steps.begin(), steps.end()));
        QCOMPARE(steps.back(), total);
        for (const ParameterRow& row : kParameters) {
            QCOMPARE(bench.settings.parameter(row.number).has_value(), !row.isTrigger);
        }
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            QVERIFY(bench.settings.calibration(InputKind::Rc, channel).has_value());
            QVERIFY(!bench.settings.calibration(InputKind::Analog, channel).has_value());
        }
    }

    void readAll_ofOldFirmware_doesWithoutTheReplyDelay()
    {
        Bench bench(u"firmware=1.0"_s);
        bench.open();
        const auto done = bench.wait<void>(
            [&](const auto& handler) { bench.settings.readAll(&bench.context, {}, handler); });
        QVERIFY(done.has_value());
        QVERIFY(!bench.settings.parameter(parameterRow("uart-response-delay").number));
    }

    void powerCycleParameter_isPendingUntilThen() // C-39
    {
        Bench bench;
        bench.open();
        QVERIFY(bench.write(kMotorMode, 1).has_value());
        QVERIFY(bench.settings.isPending(kMotorMode.number));
        QVERIFY(bench.write(kMotorMode, 0).has_value());
        QVERIFY2(!bench.settings.isPending(kMotorMode.number), "back to what is in force");
        QVERIFY(bench.write(kMotorMode, 1).has_value());
        bench.controller.powerCycleSimulator();
        QVERIFY(bench.read(kMotorMode).has_value());
        QVERIFY(!bench.settings.isPending(kMotorMode.number));
    }

    void evidence_showsWhatIsInForce() // C-39 C-53
    {
        // The line answers at 19200 without CRC, and the mode says RC inputs: whatever is stored.
        Bench bench(u"param=channel-input-source=0"_s);
        bench.open();
        const ParameterRow& uart = parameterRow("uart-settings");
        const ParameterRow& input = parameterRow("channel-input-source");
        QVERIFY(bench.read(uart).has_value());
        QVERIFY(!bench.settings.isPending(uart.number));
        QVERIFY(bench.write(uart, 0x0A).has_value());
        QVERIFY(bench.write(input, 1).has_value());
        QVERIFY(bench.settings.isPending(uart.number));
        QVERIFY(bench.settings.isPending(input.number));
        // Connected again without a power cycle: still pending.
        bench.controller.close();
        QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
        QVERIFY(!bench.settings.parameter(uart.number));
        bench.open();
        QVERIFY(bench.read(uart).has_value());
        QVERIFY(bench.read(input).has_value());
        QVERIFY(bench.settings.isPending(uart.number));
        QVERIFY(bench.settings.isPending(input.number));
    }

    /// Switched off and on while it was disconnected: nobody was there to see it.
    void whatWaited_andIsInForce_provesARestart() // C-39
    {
        Bench bench;
        bench.open();
        const ParameterRow& uart = parameterRow("uart-settings");
        QVERIFY(bench.write(uart, 0x0A).has_value());
        QVERIFY(bench.write(kMotorMode, 1).has_value());
        bench.closeAndLook();
        bench.controller.close();
        QTRY_COMPARE(bench.controller.state(), LinkState::Disconnected);
        const QSignalSpy restarted(&bench.controller, &Controller::restarted);
        bench.options.line.baud = 115200;
        bench.open();
        QVERIFY(bench.read(kMotorMode).has_value());
        QVERIFY(bench.settings.isPending(kMotorMode.number)); // it may be, as yet
        QCOMPARE(restarted.size(), 0);
        QVERIFY(bench.read(uart).has_value());
        QCOMPARE(restarted.size(), 1);
        QVERIFY(!bench.settings.isPending(kMotorMode.number));
    }

    void whatWasInForceAllAlong_provesNothing() // C-39
    {
        Bench bench(u"param=uart-settings=10"_s, {.baud = 115200});
        bench.open();
        const ParameterRow& uart = parameterRow("uart-settings");
        QVERIFY(bench.write(uart, 0x05).has_value()); // by another program, say
        DeviceSettings ours(bench.controller);
        const QSignalSpy restarted(&bench.controller, &Controller::restarted);
        const auto back = bench.wait<DeviceSettings::ParameterWrite>([&](const auto& handler) {
            ours.writeParameter(uart, 0x0A, true, &bench.context, handler);
        });
        QVERIFY(back.has_value());
        QCOMPARE(restarted.size(), 0);
        QVERIFY(!ours.isPending(uart.number));
    }

    void factoryReset_forgetsAndWaitsForThePower() // C-60
    {
        Bench bench;
        bench.open();
        QVERIFY(bench.write(kMotorMode, 1).has_value());
        bench.controller.powerCycleSimulator();
        QCOMPARE(bench.read(kMotorMode), Result<int>(1));
        const Calibration stick{2600, 3700, 4900, 80};
        QVERIFY(bench.write(1, stick).has_value());
        QSignalSpy forgotten(&bench.settings, &DeviceSettings::forgotten);
        const auto done = bench.wait<void>(
            [&](const auto& handler) { bench.settings.factoryReset(&bench.context, handler); });
        QVERIFY(done.has_value());
        QVERIFY(forgotten.count() >= 1);
        QVERIFY(!bench.settings.parameter(kMotorMode.number));
        QCOMPARE(bench.readCalibration(1), Result<Calibration>(stick)); // calibrations stay
        const auto now = bench.read(kMotorMode);
        QVERIFY(now.has_value());
        QCOMPARE(bench.settings.isPending(kMotorMode.number), *now != 1);
        bench.controller.powerCycleSimulator();
        QCOMPARE(bench.read(kMotorMode), Result<int>(0));
    }

    void notConnected_isSaid()
    {
        Bench bench;
        QCOMPARE(bench.read(kTimeout).error().code, ErrorCode::NotConnected);
        QCOMPARE(bench.write(kTimeout, 5).error().code, ErrorCode::NotConnected);
        QCOMPARE(bench.readCalibration(1).error().code, ErrorCode::NotConnected);
        QCOMPARE(bench.read(parameterRow("factory-reset")).error().code,
                 ErrorCode::BadParameterNumber);
    }
};

QTEST_GUILESS_MAIN(TestDeviceSettings)
#include "tst_devicesettings.moc"
