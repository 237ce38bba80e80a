// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/command.h"
#include "protocol/codec/packet.h"
#include "protocol/codec/replies.h"

#include <QRandomGenerator>
#include <QTest>

using namespace trex;
using Action = MotorOrder::Action;

class TstCommand : public QObject {
    Q_OBJECT

private slots:
    void driveMotor_givesTheDocumentsBytes_data();
    void driveMotor_givesTheDocumentsBytes(); // C-41, C-42, C-45
    void driveMotor_outOfRange_isRefused_data();
    void driveMotor_outOfRange_isRefused();
    void driveBoth_givesTheDocumentsBytes_data();
    void driveBoth_givesTheDocumentsBytes(); // C-43, C-44
    void driveBoth_mixedActions_areRefused();
    void everySpeed_isValidAndDistinct(); // C-41
    void channelCommands_countFromOne(); // C-32, C-35
    void noSuchChannel_isNeverAnotherCommand();
    void writeCalibration_splitsIntoSevenBitHalves_data();
    void writeCalibration_splitsIntoSevenBitHalves(); // C-35
    void writeCalibration_everyValue_roundTrips(); // C-35
    void writeCalibration_unsendableValue_isRefused_data();
    void writeCalibration_unsendableValue_isRefused(); // C-35
    void calibrationRule_isTheDocuments_data();
    void calibrationRule_isTheDocuments(); // C-36
    void writeParameter_endsWithTheFormatBytes(); // C-38
    void validate_refusesWhatTheRowForbids_data();
    void validate_refusesWhatTheRowForbids(); // C-01, C-23, C-35, C-38
    void settings_waitAsTheDocumentSays(); // C-37, C-38
    void motorCommands_expectNoReply(); // C-46
    void latchedReads_sayThatReadingClears(); // C-22
};

namespace {

QByteArray bytesOf(const Command& command)
{
    return encode(command, {}).toHex().toUpper();
}

} // namespace

void TstCommand::driveMotor_givesTheDocumentsBytes_data()
{
    QTest::addColumn<MotorId>("motor");
    QTest::addColumn<Action>("action");
    QTest::addColumn<int>("amount");
    QTest::addColumn<QByteArray>("bytes");
    const auto add = [](const char* name, MotorId motor, Action action, int amount,
                        const char* bytes) {
        QTest::newRow(name) << motor << action << amount << QByteArray(bytes);
    };
    add("set 1 forward", MotorId::Motor1, Action::Set, 64, "C240");
    add("set 1 full forward", MotorId::Motor1, Action::Set, 127, "C27F");
    add("set 1 reverse", MotorId::Motor1, Action::Set, -40, "C128");
    add("set 1 full reverse", MotorId::Motor1, Action::Set, -127, "C17F");
    add("set 1 to 0", MotorId::Motor1, Action::Set, 0, "C200");
    add("brake 1 fully", MotorId::Motor1, Action::Brake, 127, "C07F");
    add("coast 1", MotorId::Motor1, Action::Brake, 0, "C000");
    add("accelerate 1 forward", MotorId::Motor1, Action::Accelerate, 1, "C601");
    add("accelerate 1 reverse", MotorId::Motor1, Action::Accelerate, -1, "C501");
    add("set 2 forward", MotorId::Motor2, Action::Set, 64, "CA40");
    add("set 2 reverse", MotorId::Motor2, Action::Set, -40, "C928");
    add("brake 2", MotorId::Motor2, Action::Brake, 5, "C805");
    add("accelerate 2 forward", MotorId::Motor2, Action::Accelerate, 127, "CE7F");
    add("accelerate 2 reverse", MotorId::Motor2, Action::Accelerate, -127, "CD7F");
    add("set aux", MotorId::Aux, Action::Set, 127, "F07F");
    add("set aux to 0", MotorId::Aux, Action::Set, 0, "F000");
    add("accelerate aux", MotorId::Aux, Action::Accelerate, 32, "F120");
}

void TstCommand::driveMotor_givesTheDocumentsBytes()
{
    QFETCH(MotorId, motor);
    QFETCH(Action, action);
    QFETCH(int, amount);
    QFETCH(QByteArray, bytes);
    const auto command = driveMotor(motor, {action, amount});
    QVERIFY(command);
    QCOMPARE(bytesOf(*command), bytes);
}

void TstCommand::driveMotor_outOfRange_isRefused_data()
{
    QTest::addColumn<MotorId>("motor");
    QTest::addColumn<Action>("action");
    QTest::addColumn<int>("amount");
    for (const int far : {128, 255, 256, 1'000'000, INT_MAX, -128, -129, INT_MIN}) {
        for (const auto motor : {MotorId::Motor1, MotorId::Motor2, MotorId::Aux}) {
            for (const auto action : {Action::Set, Action::Accelerate, Action::Brake}) {
                QTest::addRow("motor %d action %d %d", int(motor), int(action), far)
                    << motor << action << far;
            }
        }
    }
    QTest::newRow("negative duty") << MotorId::Motor1 << Action::Brake << -1;
    QTest::newRow("aux backwards") << MotorId::Aux << Action::Set << -1;
    QTest::newRow("aux accelerates backwards") << MotorId::Aux << Action::Accelerate << -1;
    QTest::newRow("aux brake") << MotorId::Aux << Action::Brake << 0;
}

void TstCommand::driveMotor_outOfRange_isRefused()
{
    QFETCH(MotorId, motor);
    QFETCH(Action, action);
    QFETCH(int, amount);
    const auto command = driveMotor(motor, {action, amount});
    QVERIFY(!command);
    QVERIFY(command.error().code == ErrorCode::OutOfRange);
    QVERIFY(!command.error().context.isEmpty());
    if (motor != MotorId::Aux) {
        QVERIFY(!driveBoth({action, amount}, {action, 0}));
        QVERIFY(!driveBoth({action, 0}, {action, amount}));
    }
}

void TstCommand::driveBoth_givesTheDocumentsBytes_data()
{
    QTest::addColumn<Action>("action1");
    QTest::addColumn<int>("amount1");
    QTest::addColumn<Action>("action2");
    QTest::addColumn<int>("amount2");
    QTest::addColumn<QByteArray>("bytes");
    const auto set = Action::Set;
    const auto accelerate = Action::Accelerate;
    const auto brake = Action::Brake;
    // command documentation, 0xD0: 0xD0 | motor 2 direction * 4 | motor 1 direction
    QTest::newRow("forward, reverse") << set << 64 << set << -40 << QByteArray("D64028");
    QTest::newRow("reverse, forward") << set << -40 << set << 64 << QByteArray("D92840");
    QTest::newRow("both forward") << set << 1 << set << 2 << QByteArray("DA0102");
    QTest::newRow("both to 0") << set << 0 << set << 0 << QByteArray("DA0000");
    QTest::newRow("both brake") << brake << 127 << brake << 3 << QByteArray("D07F03");
    QTest::newRow("brake, forward") << brake << 127 << set << 5 << QByteArray("D87F05");
    QTest::newRow("reverse, brake") << set << -5 << brake << 127 << QByteArray("D1057F");
    // conformance C-44: 0xE0, whatever the formula prints
    QTest::newRow("accelerate") << accelerate << 64 << accelerate << -40 << QByteArray("E64028");
    QTest::newRow("accelerate back")
        << accelerate << -1 << accelerate << -2 << QByteArray("E50102");
}

void TstCommand::driveBoth_givesTheDocumentsBytes()
{
    QFETCH(Action, action1);
    QFETCH(int, amount1);
    QFETCH(Action, action2);
    QFETCH(int, amount2);
    QFETCH(QByteArray, bytes);
    const auto command = driveBoth({action1, amount1}, {action2, amount2});
    QVERIFY(command);
    QCOMPARE(bytesOf(*command), bytes);
}

void TstCommand::driveBoth_mixedActions_areRefused()
{
    for (const auto other : {Action::Set, Action::Brake}) {
        QVERIFY(driveBoth({Action::Accelerate, 1}, {other, 1}).error().code
                == ErrorCode::BadCommand);
        QVERIFY(driveBoth({other, 1}, {Action::Accelerate, 1}).error().code
                == ErrorCode::BadCommand);
    }
}

void TstCommand::everySpeed_isValidAndDistinct()
{
    for (const auto action : {Action::Set, Action::Accelerate}) {
        QSet<QByteArray> seen;
        for (int speed = -127; speed <= 127; ++speed) {
            for (const auto motor : {MotorId::Motor1, MotorId::Motor2}) {
                const auto command = driveMotor(motor, {action, speed});
                QVERIFY(command && validate(*command));
                seen << bytesOf(*command);
            }
        }
        QCOMPARE(seen.size(), 2 * 255);
    }
}

void TstCommand::channelCommands_countFromOne()
{
    for (int channel = 1; channel <= 5; ++channel) {
        QCOMPARE(int{readCalibration(channel).opcode}, 0x90 + channel - 1);
        QCOMPARE(int{writeCalibration(channel, {0, 1, 2, 0}).opcode}, 0xA0 + channel - 1);
    }
}

void TstCommand::noSuchChannel_isNeverAnotherCommand()
{
#ifdef QT_NO_DEBUG // an assertion stops a debug build earlier
    for (const int channel : {-1, 0, 6, 256}) {
        QVERIFY(!validate(readCalibration(channel)));
        QVERIFY(!validate(writeCalibration(channel, {0, 1, 2, 0})));
    }
    QVERIFY(!validate(query("no-such-command")));
#else
    QSKIP("asserted in debug builds");
#endif
}

void TstCommand::writeCalibration_splitsIntoSevenBitHalves_data()
{
    QTest::addColumn<int>("value");
    QTest::addColumn<QByteArray>("halves");
    QTest::newRow("0") << 0 << QByteArray("0000");
    QTest::newRow("127, the last of one half") << 127 << QByteArray("7F00");
    QTest::newRow("128, the first of two") << 128 << QByteArray("0001");
    QTest::newRow("255") << 255 << QByteArray("7F01");
    QTest::newRow("256") << 256 << QByteArray("0002");
    QTest::newRow("3637 of the document") << 3637 << QByteArray("351C");
    QTest::newRow("3750") << 3750 << QByteArray("261D");
    QTest::newRow("16383, the largest") << 16383 << QByteArray("7F7F");
}

void TstCommand::writeCalibration_splitsIntoSevenBitHalves()
{
    QFETCH(int, value);
    QFETCH(QByteArray, halves);
    QCOMPARE(bytesOf(writeCalibration(2, {value, value, value, value})),
             QByteArray("A1") + halves.repeated(4) + "552A");
}

void TstCommand::writeCalibration_everyValue_roundTrips()
{
    const auto& fields = commandRow("set-calibration").arguments;
    for (int value = 0; value <= kLargestCalibrationValue; ++value) {
        const Calibration wanted{value, kLargestCalibrationValue - value, value ^ 0x155, value / 2};
        const Command command = writeCalibration(5, wanted);
        QVERIFY(validate(command));
        const auto decoded = decodeFields(fields, command.data);
        QCOMPARE((Calibration{decoded[0].raw, decoded[1].raw, decoded[2].raw, decoded[3].raw}),
                 wanted);
    }
}

void TstCommand::writeCalibration_unsendableValue_isRefused_data()
{
    QTest::addColumn<int>("value");
    for (const int value : {-1, -128, -32768, 16384, 32768, 65535, 65536, INT_MAX, INT_MIN}) {
        QTest::addRow("%d", value) << value;
    }
}

void TstCommand::writeCalibration_unsendableValue_isRefused()
{
    QFETCH(int, value);
    const Calibration inEach[]{
        {value, 1, 2, 0}, {0, value, 2, 0}, {0, 1, value, 0}, {0, 1, 2, value}};
    for (const auto& calibration : inEach) {
        QVERIFY(validate(writeCalibration(1, calibration)).error().code == ErrorCode::OutOfRange);
        QVERIFY(validate(calibration).error().code == ErrorCode::OutOfRange);
    }
}

void TstCommand::calibrationRule_isTheDocuments_data()
{
    QTest::addColumn<Calibration>("calibration");
    QTest::addColumn<QString>("wrong");
    QTest::newRow("usual") << Calibration{2500, 3750, 5000, 100} << QString();
    QTest::newRow("neutral at minimum") << Calibration{10, 10, 11, 0} << QString();
    QTest::newRow("neutral at maximum") << Calibration{10, 11, 11, 0} << QString();
    QTest::newRow("whole range") << Calibration{0, 1, 16383, 16383} << QString();
    QTest::newRow("maximum = minimum") << Calibration{10, 10, 10, 0} << QStringLiteral("maximum");
    QTest::newRow("maximum below") << Calibration{10, 10, 9, 0} << QStringLiteral("maximum");
    QTest::newRow("neutral below") << Calibration{10, 9, 20, 0} << QStringLiteral("neutral");
    QTest::newRow("neutral above") << Calibration{10, 21, 20, 0} << QStringLiteral("neutral");
    QTest::newRow("minimum too high")
        << Calibration{16383, 16383, 16383, 0} << QStringLiteral("minimum");
}

void TstCommand::calibrationRule_isTheDocuments()
{
    QFETCH(Calibration, calibration);
    QFETCH(QString, wrong);
    const auto result = validate(calibration);
    QCOMPARE(result.has_value(), wrong.isEmpty());
    if (!result) {
        QVERIFY(result.error().code == ErrorCode::OutOfRange);
        QVERIFY2(result.error().context.startsWith(wrong), qPrintable(result.error().context));
    }
}

void TstCommand::writeParameter_endsWithTheFormatBytes()
{
    QCOMPARE(bytesOf(writeParameter(0x7E, 0x0A)), QByteArray("AF7E0A552A"));
    QVERIFY(validate(writeParameter(127, 127)));
    QVERIFY(!validate(writeParameter(128, 0)));
    QVERIFY(!validate(writeParameter(0, 255)));
    QVERIFY(!validate(readParameter(128)));
}

void TstCommand::validate_refusesWhatTheRowForbids_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("code"); // -1: fine
    const auto add = [](const char* name, const char* bytes, int code) {
        QTest::newRow(name) << QByteArray::fromHex(bytes) << code;
    };
    const int isBad = int(ErrorCode::BadCommand);
    const int isOut = int(ErrorCode::OutOfRange);
    add("framing", "8007", isBad);
    add("a data byte", "00", isBad);
    add("a gap of the table", "A5", isBad);
    add("query with data", "8200", isBad);
    add("mask missing", "86", isBad);
    add("mask of all channels", "861F", -1);
    add("mask bit 5", "8620", isOut);
    add("mask bit 6", "8740", isOut);
    add("mask with its top bit", "8681", isOut);
    add("speed with its top bit", "C280", isOut);
    add("one speed missing", "D640", isBad);
    add("second speed with its top bit", "D640FF", isOut);
    add("first format byte wrong", "AF0705542A", isBad);
    add("second format byte wrong", "AF0705552B", isBad);
    add("format byte with its top bit", "AF0705D52A", isBad);
    add("format bytes swapped", "AF07052A55", isBad);
    add("value with its top bit", "AF0785552A", isOut);
    add("calibration high byte with its top bit", "A00080000000000000552A", isOut);
    add("calibration low byte with its top bit", "A08000000000000000552A", isOut);
    add("calibration short", "A0000000000000000055", isBad);
    add("calibration fine", "A00000000000000000552A", -1);
}

void TstCommand::validate_refusesWhatTheRowForbids()
{
    QFETCH(QByteArray, bytes);
    QFETCH(int, code);
    const auto result = validate({static_cast<std::uint8_t>(bytes[0]), bytes.sliced(1)});
    QCOMPARE(result ? -1 : int(result.error().code), code);
}

void TstCommand::settings_waitAsTheDocumentSays()
{
    using std::chrono::milliseconds;
    QVERIFY(commandRow("set-calibration").processing == milliseconds(32));
    QVERIFY(commandRow("set-calibration").giveUp == milliseconds(100));
    QVERIFY(commandRow("set-parameter").processing == milliseconds(4));
    QVERIFY(commandRow("set-parameter").giveUp == milliseconds(50));
    for (const auto& row : kCommands) {
        QCOMPARE(row.needsSerialMode, row.kind == CommandKind::Setting);
        QCOMPARE(row.retry == Retry::Never, row.kind == CommandKind::Setting);
    }
}

void TstCommand::motorCommands_expectNoReply()
{
    for (const auto& row : kCommands) {
        if (row.kind == CommandKind::Motor) {
            QVERIFY(row.replyRule == ReplyRule::None);
            QVERIFY(row.first >= 0xC0);
        }
    }
}

void TstCommand::latchedReads_sayThatReadingClears()
{
    for (const auto& row : kCommands) {
        QCOMPARE(row.retry == Retry::ReadClears, row.first == 0x84 || row.first == 0x85);
    }
}

QTEST_APPLESS_MAIN(TstCommand)
#include "tst_command.moc"
