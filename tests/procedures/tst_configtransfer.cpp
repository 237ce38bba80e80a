// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/configtransfer.h"

#include <QSignalSpy>
#include <QTest>

using namespace Qt::Literals::StringLiterals;
using namespace trex;

namespace {

constexpr int kLongMs = 20'000;
constexpr std::uint8_t kSetParameter = 0xAF;
constexpr std::uint8_t kSetCalibration1 = 0xA0;

/// A connected controller of the simulator, with what it heard.
class Bench : public QObject {
public:
    Bench() : settings(controller), transfer(controller, settings)
    {
        connect(&controller, &Controller::recordsArrived, this,
                [this](const std::vector<TransactionRecord>& records) {
                    for (const auto& record : records) {
                        const bool isSetting =
                            record.command.opcode >= 0xA0 && record.command.opcode <= kSetParameter;
                        if (isSetting) {
                            written.push_back(record.command);
                        }
                    }
                });
        connect(&transfer, &ConfigTransfer::readFinished, this,
                [this](const Result<Configuration>& result) { read = result; });
        connect(&transfer, &ConfigTransfer::finished, this,
                [this](const TransferOutcome& result) { outcome = result; });
    }

    bool connectTo(const QString& port, const LineSettings& line = {})
    {
        OpenOptions options;
        options.port = port;
        options.line = line;
        options.reconnect = false;
        controller.open(options);
        return QTest::qWaitFor([this] { return controller.state() == LinkState::Connected; },
                               kLongMs);
    }
    bool readAll()
    {
        read.reset();
        transfer.read();
        return QTest::qWaitFor([this] { return read.has_value(); }, kLongMs) && read->has_value();
    }
    bool finish()
    {
        return QTest::qWaitFor([this] { return outcome.has_value(); }, kLongMs);
    }
    TransferPlan planFor(const Configuration& wanted) const
    {
        return planTransfer(**read, wanted, InputKind::Rc);
    }
    bool write(const Configuration& wanted)
    {
        outcome.reset();
        transfer.write(planFor(wanted));
        return finish();
    }

    Controller controller{nullptr, nullptr};
    DeviceSettings settings;
    ConfigTransfer transfer;
    std::vector<Command> written;
    std::optional<Result<Configuration>> read;
    std::optional<TransferOutcome> outcome;
};

QStringList keysOf(const std::vector<SettingWrite>& writes)
{
    QStringList keys;
    for (const auto& write : writes) {
        keys << write.key();
    }
    return keys;
}

} // namespace

class TestConfigTransfer : public QObject {
    Q_OBJECT

private slots:
    void plan_putsTheLineLast();
    void plan_leavesOutTheOtherInputSet();
    void plan_neverResetsToFactory();
    void read_bringsEverything();
    void write_sendsOnlyWhatDiffers();
    void refusal_putsBackWhatWasWritten();
    void refusal_canLeaveWhatWasWritten();
    void notInSerialMode_changesNothing();
    void cancel_putsBackWhatWasWritten();
    void lostLine_saysWhatWasNotPutBack();
    void deviceNumber_isWrittenOverPololuPackets();
};

void TestConfigTransfer::plan_putsTheLineLast()
{
    Configuration wanted;
    wanted.parameters = {{0x00, 9}, {0x7E, 0x0A}, {0x7D, 0x0B}, {0x7B, 1}, {0x07, 5}};
    wanted.calibrations[InputKind::Rc][2] = {2500, 3750, 5000, 100};
    const auto plan = planTransfer({}, wanted, InputKind::Rc);
    QCOMPARE(keysOf(plan.writes),
             (QStringList{u"serial-timeout"_s, u"motor-mode"_s, u"calibration.rc.2"_s,
                          u"crc7-polynomial"_s, u"uart-settings"_s, u"device-number"_s}));
    QVERIFY(plan.needsReset());
    QCOMPARE(plan.commands().front(), writeParameter(0x07, 5));
    QCOMPARE(plan.changes().size(), 5U + 4U);
    QCOMPARE(plan.writes.front().text(), u"Serial timeout: – → 500 ms"_s);
}

void TestConfigTransfer::plan_leavesOutTheOtherInputSet()
{
    Configuration wanted;
    wanted.calibrations[InputKind::Analog][1] = {0, 500, 1000, 10};
    for (const auto inForce : {std::optional(InputKind::Rc), std::optional<InputKind>()}) {
        const auto plan = planTransfer({}, wanted, inForce);
        QVERIFY(plan.writes.empty());
        QCOMPARE(plan.leftOut.size(), 1);
    }
    QCOMPARE(planTransfer({}, wanted, InputKind::Analog).writes.size(), 1U);
}

void TestConfigTransfer::plan_neverResetsToFactory()
{
    Configuration wanted;
    wanted.parameters = {{0x7F, 0x7F}};
    QVERIFY(planTransfer({}, wanted, InputKind::Rc).writes.empty());
}

void TestConfigTransfer::read_bringsEverything()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5"_s));
    QSignalSpy progress(&bench.transfer, &ConfigTransfer::progressed);
    QVERIFY(bench.readAll());
    const Configuration& all = **bench.read;
    QVERIFY(isComplete(all));
    QCOMPARE(all.parameters.size(), kParameters.size() - 1);
    QCOMPARE(all.parameters.at(0x07), 5);
    QCOMPARE(all.calibrations.at(InputKind::Rc).at(3), (Calibration{2500, 3750, 5000, 100}));
    QCOMPARE(all.signature, u"TReXJr1.2"_s);
    QCOMPARE(all.deviceNumber, 7);
    QVERIFY(progress.count() >= 28);
    QVERIFY(bench.written.empty());
}

void TestConfigTransfer::write_sendsOnlyWhatDiffers()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?param=serial-timeout=5"_s));
    QVERIFY(bench.readAll());
    auto wanted = **bench.read;
    QVERIFY(bench.write(wanted));
    QVERIFY(!bench.outcome->error);
    QVERIFY(bench.written.empty()); // everything is there already

    wanted.parameters[0x07] = 8;
    wanted.parameters[0x7C] = 1;
    wanted.calibrations[InputKind::Rc][1].minimum = 2600;
    QVERIFY(bench.write(wanted));
    QVERIFY2(!bench.outcome->error, qPrintable(bench.outcome->text()));
    QCOMPARE(bench.written.size(), 3U);
    QCOMPARE(bench.written[0], writeParameter(0x07, 8));
    QCOMPARE(bench.written[1], writeParameter(0x7C, 1));
    QCOMPARE(bench.written[2].opcode, kSetCalibration1);
    QVERIFY(bench.outcome->needsReset);
    QVERIFY(bench.outcome->text().contains(u"Switch the controller's power off and on"_s));

    QVERIFY(bench.readAll());
    QCOMPARE((*bench.read)->parameters.at(0x07), 8);
    QCOMPARE((*bench.read)->calibrations.at(InputKind::Rc).at(1).minimum, 2600);
}

void TestConfigTransfer::refusal_putsBackWhatWasWritten()
{
    // Firmware 1.0 has no parameter 0x17; it is written after 0x07 and 0x13.
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?firmware=1.0&quirk=unknown-parameter=ff"_s));
    QVERIFY(bench.readAll());
    const auto before = **bench.read;
    auto wanted = before;
    wanted.parameters[0x07] = 8;
    wanted.parameters[0x13] = 30;
    wanted.parameters[0x17] = 1;
    wanted.parameters[0x7B] = 1; // after the refusal: never sent
    QVERIFY(bench.write(wanted));
    QVERIFY(bench.outcome->error.has_value());
    QCOMPARE(bench.outcome->error->code, ErrorCode::BadParameterNumber);
    QCOMPARE(bench.outcome->failed->key(), u"uart-response-delay"_s);
    QVERIFY(bench.outcome->written.empty());
    QVERIFY(bench.outcome->notRestored.empty());
    QCOMPARE(keysOf(bench.outcome->restored),
             (QStringList{u"motor1-current-limit"_s, u"serial-timeout"_s}));
    QCOMPARE(bench.written.size(), 5U); // two, the refused one, two back
    QVERIFY(bench.readAll());
    QCOMPARE((*bench.read)->parameters, before.parameters);
    QVERIFY(bench.outcome->text().startsWith(u"Reply delay of 1 ms: "_s));
}

void TestConfigTransfer::refusal_canLeaveWhatWasWritten()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?firmware=1.0&quirk=unknown-parameter=ff"_s));
    QVERIFY(bench.readAll());
    const auto before = **bench.read;
    auto wanted = before;
    wanted.parameters[0x07] = 8;
    wanted.parameters[0x17] = 1;
    wanted.parameters[0x7B] = 1; // after the refusal: never sent
    bench.transfer.write(bench.planFor(wanted), ConfigTransfer::OnFailure::Stop);
    QVERIFY(bench.finish());
    QCOMPARE(bench.outcome->error->code, ErrorCode::BadParameterNumber);
    QCOMPARE(keysOf(bench.outcome->written), QStringList{u"serial-timeout"_s});
    QVERIFY(bench.outcome->restored.empty());
    QVERIFY(!bench.outcome->failedMayHold); // a refusal is certain
    QCOMPARE(bench.written.size(), 2U);
    QCOMPARE(bench.settings.parameter(0x07), 8);
    QVERIFY(bench.outcome->text().contains(u"in the controller now: Serial timeout."_s));

    const auto written = bench.outcome->toPutBack();
    bench.outcome.reset();
    bench.transfer.putBack(written);
    QVERIFY(bench.finish());
    QVERIFY(!bench.outcome->error);
    QCOMPARE(keysOf(bench.outcome->restored), QStringList{u"serial-timeout"_s});
    QCOMPARE(bench.outcome->text(), u"Put back as before: Serial timeout."_s);
    QVERIFY(bench.readAll());
    QCOMPARE((*bench.read)->parameters, before.parameters);
}

void TestConfigTransfer::notInSerialMode_changesNothing()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:?mode=rc"_s));
    QVERIFY(bench.readAll());
    auto wanted = **bench.read;
    wanted.parameters[0x07] = 8;
    wanted.parameters[0x13] = 30;
    QVERIFY(bench.write(wanted));
    QCOMPARE(bench.outcome->error->code, ErrorCode::NotInSerialMode);
    QVERIFY(bench.outcome->restored.empty() && bench.outcome->notRestored.empty());
    QCOMPARE(bench.written.size(), 1U); // stopped at the first refusal
    QVERIFY(bench.outcome->text().contains(u"Nothing is changed"_s));
}

void TestConfigTransfer::cancel_putsBackWhatWasWritten()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.readAll());
    const auto before = **bench.read;
    auto wanted = before;
    for (const int number : {0x07, 0x0E, 0x0F, 0x10}) {
        wanted.parameters[static_cast<std::uint8_t>(number)] = 33;
    }
    connect(&bench.transfer, &ConfigTransfer::progressed, &bench, [&bench](int done) {
        if (done == 2) {
            bench.transfer.cancel();
        }
    });
    QVERIFY(bench.write(wanted));
    QCOMPARE(bench.outcome->error->code, ErrorCode::Cancelled);
    QCOMPARE(bench.outcome->restored.size(), 2U);
    QCOMPARE(bench.written.size(), 4U);
    QVERIFY(bench.readAll());
    QCOMPARE((*bench.read)->parameters, before.parameters);
}

void TestConfigTransfer::lostLine_saysWhatWasNotPutBack()
{
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s));
    QVERIFY(bench.readAll());
    auto wanted = **bench.read;
    for (const int number : {0x07, 0x0E, 0x0F, 0x10}) {
        wanted.parameters[static_cast<std::uint8_t>(number)] = 33;
    }
    connect(&bench.transfer, &ConfigTransfer::progressed, &bench, [&bench](int done) {
        if (done == 2) {
            bench.controller.close();
        }
    });
    QVERIFY(bench.write(wanted));
    QVERIFY(bench.outcome->error.has_value());
    QVERIFY(bench.outcome->restored.empty());
    QVERIFY(bench.outcome->notRestored.size() >= 2U);
    QVERIFY(bench.outcome->text().contains(u"Could not be put back"_s));
    QVERIFY(!bench.transfer.isBusy());
}

void TestConfigTransfer::deviceNumber_isWrittenOverPololuPackets()
{
    // The number acts at once (C-39), so that the old one would hear no read-back.
    LineSettings pololu;
    pololu.form = PacketForm::Pololu;
    Bench bench;
    QVERIFY(bench.connectTo(u"sim:"_s, pololu));
    QVERIFY(bench.readAll());
    auto wanted = **bench.read;
    wanted.parameters[0x00] = 9;
    QVERIFY(bench.write(wanted));
    QVERIFY2(!bench.outcome->error, qPrintable(bench.outcome->text()));
    QCOMPARE(bench.written.size(), 1U);
}

QTEST_GUILESS_MAIN(TestConfigTransfer)
#include "tst_configtransfer.moc"
