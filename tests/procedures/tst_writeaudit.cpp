// SPDX-License-Identifier: GPL-3.0-or-later
// The journal of a connection, over the real façade against a simulated controller: what is saved
// before the first write, what is recorded of each, what is found out after an interruption, and
// the way back.
#include "protocol/errortext.h"
#include "protocol/procedures/writeaudit.h"

#include <QElapsedTimer>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace trex;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr const ParameterRow& kTimeout = parameterRow("serial-timeout");
constexpr const ParameterRow& kNumber = parameterRow("device-number");
const SettingId kTimeoutId{.row = &kTimeout};
const Calibration kUsual{2500, 3750, 5000, 100}; // conformance C-63
const Calibration kStick{2600, 3700, 4900, 80};

class Bench {
public:
    explicit Bench(const QString& query = {},
                   WriteAudit::WhenUnsaved whenUnsaved = WriteAudit::WhenUnsaved::RefuseOnce)
        : settings(controller)
        , journal(folder.filePath(u"data/journal.sqlite"_s))
        , audit(controller, settings, journal, whenUnsaved)
    {
        options.port = u"sim:?pace=0"_s + (query.isEmpty() ? QString() : u'&' + query);
        QObject::connect(&audit, &WriteAudit::told, &context,
                         [this](int /*severity*/, const QString& text) { told << text; });
        QObject::connect(&controller, &Controller::recordsArrived, &context,
                         [this](const std::vector<TransactionRecord>& records) {
                             for (const auto& record : records) {
                                 opcodes.push_back(record.isRaw ? 0 : record.command.opcode);
                             }
                         });
    }

    void open()
    {
        controller.open(options);
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Connected, 5000);
    }
    void close()
    {
        controller.close();
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), LinkState::Disconnected, 5000);
    }
    template <class T, class F>
    Result<T> wait(const F& start)
    {
        std::optional<Result<T>> answer;
        start([&](const Result<T>& result) { answer = result; });
        [&] { QTRY_VERIFY_WITH_TIMEOUT(answer.has_value(), 10'000); }();
        return answer.value_or(fail(ErrorCode::Cancelled));
    }
    Result<DeviceSettings::ParameterWrite> write(const ParameterRow& row, int raw,
                                                 bool verify = true)
    {
        return wait<DeviceSettings::ParameterWrite>([&](const auto& handler) {
            settings.writeParameter(row, raw, verify, &context, handler);
        });
    }
    Result<DeviceSettings::CalibrationWrite> write(int channel, const Calibration& calibration)
    {
        return wait<DeviceSettings::CalibrationWrite>([&](const auto& handler) {
            settings.writeCalibration(channel, calibration, &context, handler);
        });
    }
    void resolve()
    {
        bool isDone = false;
        audit.resolve(&context, [&] { isDone = true; });
        QTRY_VERIFY_WITH_TIMEOUT(isDone, 10'000);
    }
    Configuration readAll()
    {
        const auto read =
            wait<void>([&](const auto& handler) { settings.readAll(&context, {}, handler); });
        [&] { QVERIFY(read); }();
        return presentConfiguration(controller, settings);
    }
    [[nodiscard]] std::vector<JournalEntry> entries()
    {
        return journal.entries({}).value_or(std::vector<JournalEntry>());
    }
    [[nodiscard]] qsizetype count(std::uint8_t opcode) const
    {
        return std::ranges::count(opcodes, opcode);
    }

    QTemporaryDir folder;
    QObject context;
    Controller controller{nullptr, nullptr};
    DeviceSettings settings;
    Journal journal;
    WriteAudit audit;
    OpenOptions options;
    QStringList told;
    std::vector<std::uint8_t> opcodes;
};

/// Only what the controller holds, not when it was read.
bool isSame(Configuration a, Configuration b)
{
    a.saved = b.saved = {};
    return a == b;
}

} // namespace

class TestWriteAudit : public QObject {
    Q_OBJECT

private slots:
    void write_isRecordedBeforeItIsSentAndConcluded();
    void packetIsOnTheDisk_beforeItIsSent();
    void firstWrite_savesEverythingOnce();
    void nextConnection_savesEverythingAgain();
    void unchangedValue_isNeitherRecordedNorReadFor();
    void calibration_isRecordedWithItsSet();
    void eightBitController_isRecordedAsItIs();
    void refusal_isNamed();
    void unverifiedWrite_isAnsweredOnly();
    void factoryReset_savesFirstAndIsRecorded();
    void lostLine_leavesUnknownAndIsResolved();
    void interruptedWrite_isReadBackAndNamed_data();
    void interruptedWrite_isReadBackAndNamed();
    void interruptedWriteOfTheNumber_isFoundUnderTheNewOne();
    void interruptedReset_isToldAndNotAskedAgain();
    void otherControllersInterruption_isLeftAlone();
    void calibrationOfTheOtherSet_staysOpen();
    void nothingOpen_asksNothing();
    void journalThatCannotBeWritten_stopsTheFirstWrite();
    void journalThatCannotBeWritten_isToldAndTheWriteGoesOn();
    void unreadableSettings_doNotHoldAWriteForLong();
    void rawBytesThatWrite_areRecorded();
    void composedPacketThatWrites_isRecordedAndReadBack();
    void revert_bringsBackTheStart();
    void checkpoint_isRestored();
    void writeGoesOn_whenItsOwnerIsGone();
};

void TestWriteAudit::write_isRecordedBeforeItIsSentAndConcluded()
{
    Bench bench;
    bench.open();
    QVERIFY(bench.write(kTimeout, 5));
    QCOMPARE(bench.entries().size(), std::size_t{1});
    const JournalEntry entry = bench.entries().front();
    QCOMPARE(entry.intent.setting, kTimeoutId);
    QVERIFY(entry.intent.before == SettingValue(0));
    QVERIFY(entry.intent.after == SettingValue(5));
    QCOMPARE(entry.intent.packet.toHex(), QByteArray("af0705552a"));
    QCOMPARE(entry.conclusion.result, WriteResult::New);
    QVERIFY(entry.conclusion.found == SettingValue(5));
    QCOMPARE(entry.controller, (ControllerIdentity{bench.options.port, u"TReXJr1.2"_s, 7}));
    QCOMPARE(titleOf(entry.intent.setting), u"Serial timeout"_s);
    QVERIFY2(changeText(entry).endsWith(u"→ 500 ms"_s), qPrintable(changeText(entry)));
}

void TestWriteAudit::packetIsOnTheDisk_beforeItIsSent()
{
    Bench bench;
    bench.open();
    std::size_t recorded = 0;
    QObject::connect(&bench.controller, &Controller::recordsArrived, &bench.context,
                     [&](const std::vector<TransactionRecord>& records) {
                         for (const auto& record : records) {
                             if (record.command.opcode == 0xAF) {
                                 Journal other(bench.journal.path());
                                 const auto open = other.entries(
                                     {.controller = {}, .setting = {}, .onlyOpen = true});
                                 recorded = open ? open->size() : 0;
                             }
                         }
                     });
    QVERIFY(bench.write(kTimeout, 5));
    QCOMPARE(recorded, std::size_t{1});
}

void TestWriteAudit::firstWrite_savesEverythingOnce()
{
    Bench bench;
    bench.open();
    QVERIFY(bench.write(kTimeout, 5));
    const auto saved = bench.journal.checkpoints(bench.audit.controller());
    QVERIFY(saved);
    QCOMPARE(saved->size(), std::size_t{1});
    QVERIFY(isComplete(saved->front().configuration));
    QCOMPARE(saved->front().configuration.parameters.at(kTimeout.number), 0); // as it was
    QVERIFY(saved->front().name.isEmpty());
    QVERIFY(bench.write(kTimeout, 6));
    QVERIFY(bench.write(1, kStick));
    QCOMPARE(bench.journal.checkpoints(std::nullopt)->size(), std::size_t{1});
}

void TestWriteAudit::nextConnection_savesEverythingAgain()
{
    Bench bench;
    bench.open();
    QVERIFY(bench.write(kTimeout, 5));
    bench.close();
    bench.open();
    QVERIFY(bench.write(kTimeout, 6));
    const auto saved = bench.journal.checkpoints(std::nullopt);
    QCOMPARE(saved->size(), std::size_t{2});
    QCOMPARE(saved->front().configuration.parameters.at(kTimeout.number), 5);
}

void TestWriteAudit::unchangedValue_isNeitherRecordedNorReadFor()
{
    Bench bench;
    bench.open();
    QVERIFY(bench.write(kTimeout, 0));
    QVERIFY(bench.write(1, kUsual));
    QVERIFY(bench.entries().empty());
    QVERIFY(!QFile::exists(bench.journal.path()));
    QVERIFY(bench.count(0x9F) < 5); // not everything
    QCOMPARE(bench.count(0xAF) + bench.count(0xA0), 0);
}

void TestWriteAudit::calibration_isRecordedWithItsSet()
{
    Bench bench;
    bench.open();
    QVERIFY(bench.write(2, kStick));
    const JournalEntry entry = bench.entries().front();
    QCOMPARE(keyOf(entry.intent.setting), u"calibration.rc.2"_s);
    QVERIFY(entry.intent.before == SettingValue(kUsual));
    QVERIFY(entry.valueAfter() == SettingValue(kStick));
    const auto history =
        bench.journal.calibrationHistory(bench.audit.controller(), InputKind::Rc, 2);
    QCOMPARE(history->size(), std::size_t{1});
}

void TestWriteAudit::eightBitController_isRecordedAsItIs()
{
    Bench bench(u"quirk=calibration-bytes=8"_s);
    bench.open();
    const auto written = bench.write(1, {2565, 3700, 4900, 80});
    QVERIFY(written && written->eightBitBytes);
    const auto entries = bench.entries();
    QCOMPARE(entries.size(), std::size_t{2});
    QCOMPARE(entries.back().conclusion.result, WriteResult::Other); // the first try, misread
    QCOMPARE(entries.front().conclusion.result, WriteResult::New);
    QVERIFY(entries.front().valueAfter() == SettingValue(written->readBack));
}

void TestWriteAudit::refusal_isNamed()
{
    Bench bench(u"mode=rc"_s);
    bench.open();
    QVERIFY(!bench.write(kTimeout, 5));
    const JournalEntry entry = bench.entries().front();
    QCOMPARE(entry.conclusion.result, WriteResult::Refused);
    QVERIFY(entry.conclusion.detail.contains(u"serial mode"_s));
    QVERIFY(entry.valueAfter() == SettingValue(0));
}

void TestWriteAudit::unverifiedWrite_isAnsweredOnly()
{
    Bench bench;
    bench.open();
    QVERIFY(bench.write(kTimeout, 5, false));
    QCOMPARE(bench.entries().front().conclusion.result, WriteResult::Answered);
}

void TestWriteAudit::factoryReset_savesFirstAndIsRecorded()
{
    Bench bench;
    bench.open();
    QVERIFY(bench.write(kTimeout, 5));
    const auto reset = bench.wait<void>(
        [&](const auto& handler) { bench.settings.factoryReset(&bench.context, handler); });
    QVERIFY(reset);
    const auto saved = bench.journal.checkpoints(std::nullopt);
    QCOMPARE(saved->size(), std::size_t{2}); // once more, since it changes everything
    QCOMPARE(saved->front().configuration.parameters.at(kTimeout.number), 5);
    QCOMPARE(keyOf(bench.entries().front().intent.setting), u"factory-reset"_s);
    QCOMPARE(bench.entries().front().conclusion.result, WriteResult::Answered);
}

void TestWriteAudit::lostLine_leavesUnknownAndIsResolved()
{
    Bench bench;
    bench.open();
    const auto hangUp =
        QObject::connect(&bench.controller, &Controller::recordsArrived, &bench.context,
                         [&](const std::vector<TransactionRecord>& records) {
                             if (std::ranges::any_of(records, [](const auto& record) {
                                     return record.command.opcode == 0xAF;
                                 })) {
                                 bench.controller.close();
                             }
                         });
    QVERIFY(!bench.write(kTimeout, 5));
    QObject::disconnect(hangUp);
    QVERIFY(bench.entries().front().isOpen());
    QTRY_COMPARE_WITH_TIMEOUT(bench.controller.state(), LinkState::Disconnected, 5000);
    bench.open();
    bench.resolve();
    const JournalEntry entry = bench.entries().front();
    QVERIFY(!entry.isOpen());
    QCOMPARE(entry.conclusion.result, WriteResult::New);
    QVERIFY(entry.resolved.isValid());
    QCOMPARE(bench.told.size(), 1);
    QVERIFY2(bench.told.front().contains(u"Serial timeout"_s)
                 && bench.told.front().contains(u"new value"_s)
                 && bench.told.front().contains(u"500 ms"_s),
             qPrintable(bench.told.front()));
}

void TestWriteAudit::interruptedWrite_isReadBackAndNamed_data()
{
    QTest::addColumn<int>("before");
    QTest::addColumn<int>("after");
    QTest::addColumn<WriteResult>("result");
    QTest::addColumn<QString>("words");
    // The simulated controller holds 0.
    QTest::newRow("old") << 0 << 5 << WriteResult::Old << u"old value"_s;
    QTest::newRow("new") << 5 << 0 << WriteResult::New << u"new value"_s;
    QTest::newRow("other") << 5 << 6 << WriteResult::Other << u"another value"_s;
}

void TestWriteAudit::interruptedWrite_isReadBackAndNamed()
{
    QFETCH(int, before);
    QFETCH(int, after);
    QFETCH(WriteResult, result);
    QFETCH(QString, words);
    Bench bench;
    const ControllerIdentity who{bench.options.port, u"TReXJr1.2"_s, 7};
    QVERIFY(bench.journal.intend(who, {kTimeoutId, before, after, {}})); // then it was killed
    const SettingId channel{.row = nullptr, .input = InputKind::Rc, .channel = 3};
    QVERIFY(bench.journal.intend(who, {channel, kStick, kUsual, {}}));
    bench.audit.resolveWhenConnected();
    bench.open();
    QTRY_COMPARE_WITH_TIMEOUT(bench.told.size(), 2, 5000);
    QVERIFY2(bench.told.at(0).contains(words), qPrintable(bench.told.at(0)));
    QVERIFY2(bench.told.at(1).contains(u"channel 3"_s), qPrintable(bench.told.at(1)));
    const auto entries = bench.entries();
    QCOMPARE(entries.back().conclusion.result, result);
    QCOMPARE(entries.front().conclusion.result, WriteResult::New);
    QCOMPARE(bench.count(0xAF), 0); // nothing is written
}

void TestWriteAudit::interruptedWriteOfTheNumber_isFoundUnderTheNewOne()
{
    Bench bench(u"device=9"_s);
    const ControllerIdentity who{bench.options.port, u"TReXJr1.2"_s, 7};
    QVERIFY(bench.journal.intend(who, {kTimeoutId, 5, 0, {}}));
    QVERIFY(bench.journal.intend(who, {{.row = &kNumber}, 7, 9, {}}));
    bench.open();
    bench.resolve();
    QVERIFY(bench.journal.entries({.controller = {}, .setting = {}, .onlyOpen = true})->empty());
    QCOMPARE(bench.told.size(), 2);
}

void TestWriteAudit::interruptedReset_isToldAndNotAskedAgain()
{
    Bench bench;
    const ControllerIdentity who{bench.options.port, u"TReXJr1.2"_s, 7};
    QVERIFY(bench.journal.intend(who, {{.row = &parameterRow("factory-reset")}, {}, {}, {}}));
    bench.open();
    bench.resolve();
    QCOMPARE(bench.told.size(), 1);
    bench.resolve();
    QCOMPARE(bench.told.size(), 1);
}

void TestWriteAudit::otherControllersInterruption_isLeftAlone()
{
    Bench bench;
    for (const ControllerIdentity& who :
         {ControllerIdentity{bench.options.port, u"TReXJr1.2"_s, 8},
          ControllerIdentity{bench.options.port, u"TReXJr1.3"_s, 7},
          ControllerIdentity{u"/dev/ttyUSB0"_s, u"TReXJr1.2"_s, 7}}) {
        QVERIFY(bench.journal.intend(who, {kTimeoutId, 0, 5, {}}));
    }
    bench.open();
    bench.resolve();
    QVERIFY(bench.told.isEmpty());
    QCOMPARE(bench.journal.entries({.controller = {}, .setting = {}, .onlyOpen = true})->size(),
             std::size_t{3});
}

void TestWriteAudit::calibrationOfTheOtherSet_staysOpen()
{
    Bench bench;
    const ControllerIdentity who{bench.options.port, u"TReXJr1.2"_s, 7};
    const SettingId analog{.row = nullptr, .input = InputKind::Analog, .channel = 1};
    QVERIFY(bench.journal.intend(who, {analog, kUsual, kStick, {}}));
    bench.open();
    bench.resolve();
    QVERIFY(bench.entries().front().isOpen());
}

void TestWriteAudit::nothingOpen_asksNothing()
{
    Bench bench;
    bench.open();
    const auto before = bench.opcodes.size();
    bench.resolve();
    QCOMPARE(bench.opcodes.size(), before);
}

void TestWriteAudit::journalThatCannotBeWritten_stopsTheFirstWrite()
{
    Bench bench;
    QFile inTheWay(bench.folder.filePath(u"data"_s));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    bench.open();
    const auto stopped = bench.write(kTimeout, 5);
    QVERIFY(!stopped);
    QCOMPARE(stopped.error().code, ErrorCode::FileUnwritable);
    QCOMPARE(bench.count(0xAF), 0);
    QCOMPARE(bench.told.size(), 1);
    QVERIFY2(bench.told.front().contains(bench.journal.path()), qPrintable(bench.told.front()));
    QVERIFY(bench.write(kTimeout, 5)); // the person knows now
    QCOMPARE(bench.count(0xAF), 1);
    QVERIFY(bench.write(1, kStick));
    QCOMPARE(bench.told.size(), 1);
}

void TestWriteAudit::journalThatCannotBeWritten_isToldAndTheWriteGoesOn()
{
    Bench bench({}, WriteAudit::WhenUnsaved::GoOn);
    QFile inTheWay(bench.folder.filePath(u"data"_s));
    QVERIFY(inTheWay.open(QIODevice::WriteOnly));
    bench.open();
    QVERIFY(bench.write(kTimeout, 5));
    QVERIFY(bench.write(kTimeout, 6));
    QCOMPARE(bench.told.size(), 1);
}

void TestWriteAudit::unreadableSettings_doNotHoldAWriteForLong()
{
    Bench bench({}, WriteAudit::WhenUnsaved::GoOn);
    bench.options.port += u"&fault=delay=300"_s;
    bench.options.line.timeout = std::chrono::milliseconds(1000);
    bench.open();
    QElapsedTimer timer;
    timer.start();
    QVERIFY(bench.write(kTimeout, 5));
    QVERIFY2(timer.elapsed() < 9000, "everything would take 10 s"); // 34 queries of 300 ms
    QCOMPARE(bench.told.size(), 1);
    QVERIFY(bench.journal.checkpoints(std::nullopt)->empty());
    QCOMPARE(bench.entries().size(), std::size_t{1}); // recorded all the same
}

void TestWriteAudit::rawBytesThatWrite_areRecorded()
{
    Bench bench;
    bench.open();
    const auto reply = bench.wait<Reply>([&](const auto& handler) {
        bench.controller.requestRaw(QByteArray::fromHex("AF0705552A"), 1, &bench.context, handler);
    });
    QVERIFY(reply);
    QCOMPARE(bench.entries().size(), std::size_t{1});
    QVERIFY(bench.entries().front().intent.after == SettingValue(5));
    QCOMPARE(bench.entries().front().conclusion.result, WriteResult::Answered);
    const auto query = bench.wait<Reply>([&](const auto& handler) {
        bench.controller.requestRaw(QByteArray::fromHex("9F07"), 1, &bench.context, handler);
    });
    QVERIFY(query);
    QCOMPARE(bench.entries().size(), std::size_t{1}); // a query writes nothing
}

void TestWriteAudit::composedPacketThatWrites_isRecordedAndReadBack()
{
    Bench bench;
    bench.audit.resolveWhenConnected();
    bench.open();
    QVERIFY(bench.wait<Reply>([&](const auto& handler) {
        bench.controller.request(writeParameter(kTimeout.number, 5), &bench.context, handler);
    }));
    QTRY_COMPARE_WITH_TIMEOUT(bench.entries().front().conclusion.result, WriteResult::New, 5000);
    QCOMPARE(bench.entries().size(), std::size_t{1});
    QCOMPARE(bench.settings.parameter(kTimeout.number), std::optional(5)); // shown as it is
}

void TestWriteAudit::revert_bringsBackTheStart()
{
    Bench bench;
    bench.open();
    const Configuration start = bench.readAll();
    QVERIFY(bench.write(kTimeout, 5));
    QVERIFY(bench.write(1, kStick));
    QVERIFY(bench.write(kTimeout, 6));
    QVERIFY(bench.write(parameterRow("motor1-acceleration"), 9));
    const JournalEntry first = bench.entries().back();
    const auto plan = bench.audit.planRevert(first);
    QVERIFY(plan);
    QCOMPARE(plan->writes.size(), std::size_t{3}); // only what differs
    ConfigTransfer transfer(bench.controller, bench.settings);
    QSignalSpy finished(&transfer, &ConfigTransfer::finished);
    transfer.write(*plan);
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 10'000);
    QVERIFY(isSame(bench.readAll(), start));
    QVERIFY(bench.audit.planRevert(first)->writes.empty());
    QCOMPARE(bench.entries().size(), std::size_t{7}); // the way back is in it, too
}

void TestWriteAudit::checkpoint_isRestored()
{
    Bench bench;
    bench.open();
    QVERIFY(bench.wait<qint64>([&](const auto& handler) {
        bench.audit.saveCheckpoint(u"start"_s, &bench.context, handler);
    }));
    QVERIFY(bench.write(kTimeout, 5));
    const auto kept = bench.journal.checkpoint(bench.audit.controller(), u"start"_s);
    QVERIFY(kept);
    const TransferPlan plan = bench.audit.planRestore(kept->configuration);
    QCOMPARE(plan.writes.size(), std::size_t{1});
    QCOMPARE(plan.writes.front().rawTo, 0);
}

void TestWriteAudit::writeGoesOn_whenItsOwnerIsGone()
{
    Bench bench;
    bench.open();
    auto owner = std::make_unique<QObject>();
    bool wasTold = false;
    bench.settings.writeParameter(kTimeout, 5, true, owner.get(),
                                  [&](const auto& /*result*/) { wasTold = true; });
    owner.reset();
    QTRY_VERIFY_WITH_TIMEOUT(!bench.entries().empty() && bench.entries().front().isConcluded,
                             10'000);
    QCOMPARE(bench.entries().front().conclusion.result, WriteResult::New);
    QVERIFY(!wasTold);
}

QTEST_GUILESS_MAIN(TestWriteAudit)
#include "tst_writeaudit.moc"
