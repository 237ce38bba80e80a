// SPDX-License-Identifier: GPL-3.0-or-later
// One fault at every byte of an apply of ten parameters and five calibrations. Whatever it is, in
// the end every field holds its old or its new value, what is said about it is true, and undo
// brings back the start.
#include "tests/support/faultbench.h"

#include <QTest>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using namespace trex::test;

namespace {

/// Values that a damaged packet may mistake for each other: numbers one bit apart get the same new
/// value, and so do two channels.
Configuration wantedFrom(const Configuration& before)
{
    Configuration wanted = before;
    for (const auto& [number, raw] : {std::pair{0x01, 3},
                                      {0x03, 5},
                                      {0x05, 5},
                                      {0x07, 5},
                                      {0x09, 0},
                                      {0x0E, 40},
                                      {0x11, 20},
                                      {0x13, 30},
                                      {0x15, 7},
                                      {0x7B, 1}}) {
        wanted.parameters[static_cast<std::uint8_t>(number)] = raw;
    }
    wanted.calibrations[InputKind::Rc] = {{1, {2400, 3700, 5100, 90}},
                                          {2, {2600, 3800, 4900, 110}},
                                          {3, {2501, 3751, 5001, 101}},
                                          {4, {2450, 3650, 4950, 80}},
                                          {5, {2450, 3650, 4950, 80}}};
    return wanted;
}

struct Figures {
    int cases = 0;
    int allNew = 0;
    int allOld = 0;
    int mixed = 0; ///< old and new: only where the line was gone before all was put back
    int interrupted = 0; ///< some fields may have held either, until they were examined
    int repaired = 0; ///< a damaged packet had reached another setting
    int third = 0;
    int untrue = 0;
    int undone = 0;
};

/// The raw number or calibration behind each key, as text, so that fields compare alike.
std::map<QString, QString> fieldsOf(const Configuration& configuration)
{
    std::map<QString, QString> fields;
    for (const auto& [number, raw] : configuration.parameters) {
        fields[keyText(*findParameter(int{number}))] = QString::number(raw);
    }
    for (const auto& [input, channels] : configuration.calibrations) {
        for (const auto& [channel, c] : channels) {
            fields[u"calibration.%1.%2"_s.arg(keyOf(input)).arg(channel)] =
                u"%1 %2 %3 %4"_s.arg(c.minimum).arg(c.neutral).arg(c.maximum).arg(c.deadband);
        }
    }
    return fields;
}

bool names(const std::vector<SettingWrite>& writes, const QString& key)
{
    return std::ranges::any_of(writes, [&](const SettingWrite& w) { return w.key() == key; });
}

/// What was said of a field against what it holds.
bool isTrue(const TransferOutcome& outcome, const QString& key, bool isNew, bool isOld)
{
    if (names(outcome.notRestored, key)
        || (outcome.failedMayHold && outcome.failed && outcome.failed->key() == key)) {
        return isNew || isOld; // "may hold either"
    }
    return names(outcome.written, key) ? isNew : isOld;
}

QString keyOf(const SettingId& setting)
{
    return setting.row != nullptr
        ? keyText(*setting.row)
        : u"calibration.%1.%2"_s.arg(trex::keyOf(setting.input)).arg(setting.channel);
}

QString textOf(const SettingValue& value)
{
    if (const int* raw = std::get_if<int>(&value)) {
        return QString::number(*raw);
    }
    const auto& c = std::get<Calibration>(value);
    return u"%1 %2 %3 %4"_s.arg(c.minimum).arg(c.neutral).arg(c.maximum).arg(c.deadband);
}

/// What the record of the writes says of a field against what it holds: its latest entry counts.
bool isTrue(const WriteLog& log, const QString& key, const QString& value)
{
    for (auto entry = log.entries.rbegin(); entry != log.entries.rend(); ++entry) {
        if (keyOf(entry->intent.setting) != key) {
            continue;
        }
        const QString before = textOf(*entry->intent.before);
        const QString after = textOf(*entry->intent.after);
        const auto result = entry->conclusion ? entry->conclusion->result : WriteResult::Unknown;
        switch (result) {
        case WriteResult::New:
            return value == after;
        case WriteResult::Old:
        case WriteResult::Refused:
            return value == before;
        case WriteResult::Other:
            return value == textOf(*entry->conclusion->found);
        case WriteResult::Unknown:
        case WriteResult::Answered:
            return value == before || value == after;
        }
    }
    return true; // never written, and then checked with the others
}

/// The value before a field's first write, as the record has it: what undo goes back to.
bool startsAt(const WriteLog& log, const QString& key, const QString& value)
{
    const auto first = std::ranges::find_if(
        log.entries, [&](const auto& entry) { return keyOf(entry.intent.setting) == key; });
    return first == log.entries.end() || textOf(*first->intent.before) == value;
}

using OnFailure = ConfigTransfer::OnFailure;

} // namespace

class TestTransferFaults : public QObject {
    Q_OBJECT

private slots:
    void cleanApply_writesAll();
    void damagedAnswer_isNoRefusal();
    void longerReply_isNotTakenForTwo();
    void faultAtEveryByte_leavesOldOrNew_data();
    void faultAtEveryByte_leavesOldOrNew();
    void cleanupTestCase();

private:
    struct Setup {
        QString more; ///< of the simulator
        LineSettings line;
        OnFailure onFailure = OnFailure::PutBack;
    };
    void count(const Setup& setup, const QString& fault, Figures& figures);
    static void compare(const FaultBench& bench, const TransferOutcome& outcome,
                        const Configuration& before, const Configuration& wanted,
                        const Configuration& now, const QString& fault, Figures& figures);

    int m_cases = 0;
};

void TestTransferFaults::cleanApply_writesAll()
{
    FaultBench bench;
    QVERIFY(bench.open({}, {}, {}));
    const auto before = bench.read();
    QVERIFY(before);
    const auto wanted = wantedFrom(*before);
    const auto plan = planTransfer(*before, wanted, InputKind::Rc);
    QCOMPARE(plan.writes.size(), 15U);
    const auto outcome = bench.write(plan);
    QVERIFY(outcome && !outcome->error && outcome->notes.isEmpty());
    const auto now = bench.read();
    QVERIFY(now);
    QCOMPARE(fieldsOf(*now), fieldsOf(wanted));
    QCOMPARE(bench.log.entries.size(), 15U); // none was written twice
}

void TestTransferFaults::longerReply_isNotTakenForTwo()
{
    // 0x9F becomes 0x8F: two equal bytes come back instead of the parameter.
    FaultBench clean;
    QVERIFY(clean.open({}, {}, {}) && clean.read());
    FaultBench bench;
    QVERIFY(
        bench.open(u"corrupt-at=%1&fault=corrupt-mask=16"_s.arg(clean.wireBytes() + 1), {}, {}));
    const auto before = bench.read();
    QVERIFY(before);
    const auto wanted = wantedFrom(*before);
    const auto outcome = bench.write(planTransfer(*before, wanted, InputKind::Rc));
    QVERIFY(outcome && !outcome->error);
    QCOMPARE(textOf(*bench.log.entries[0].intent.before), u"1"_s);
}

void TestTransferFaults::damagedAnswer_isNoRefusal()
{
    FaultBench clean;
    QVERIFY(clean.open({}, {}, {}) && clean.read());
    // The first parameter is asked for (two bytes and one), then written: five bytes, one answer.
    const qint64 answer = clean.wireBytes() + 2 + 1 + 5 + 1;
    for (const int mask : {0x01, 0x02, 0x03, 0x10}) { // bad parameter, bad value, mode, unknown
        FaultBench bench;
        QVERIFY(bench.open(u"corrupt-at=%1&fault=corrupt-mask=%2"_s.arg(answer).arg(mask), {}, {}));
        const auto before = bench.read();
        QVERIFY(before);
        const auto wanted = wantedFrom(*before);
        const auto outcome = bench.write(planTransfer(*before, wanted, InputKind::Rc));
        QVERIFY2(outcome && !outcome->error, qPrintable(outcome ? outcome->text() : QString()));
        QCOMPARE(outcome->written.size(), 15U);
        QCOMPARE(bench.log.entries.size(), 15U);
        QCOMPARE(bench.log.entries[0].conclusion->result, WriteResult::New);
    }
}

void TestTransferFaults::compare(const FaultBench& bench, const TransferOutcome& outcome,
                                 const Configuration& before, const Configuration& wanted,
                                 const Configuration& now, const QString& fault, Figures& figures)
{
    const auto oldFields = fieldsOf(before);
    const auto newFields = fieldsOf(wanted);
    std::map<QString, QString> titles;
    for (const auto& write : planTransfer({}, before, InputKind::Rc).writes) {
        titles[write.key()] = write.title();
    }
    int olds = 0;
    int news = 0;
    for (const auto& [key, value] : fieldsOf(now)) {
        const bool isOld = value == oldFields.at(key);
        const bool isNew = value == newFields.at(key);
        olds += isOld && !isNew ? 1 : 0;
        news += isNew && !isOld ? 1 : 0;
        if (!isOld && !isNew) {
            ++figures.third;
            qWarning() << fault << key << "third value" << value << outcome.text();
        }
        // A setting that a damaged packet had reached is first written to be put right.
        const bool isStray = outcome.notes.join(u' ').contains(titles.at(key));
        const bool isPlanned = oldFields.at(key) != newFields.at(key) && !isStray;
        if (!isTrue(outcome, key, isNew, isOld) || !isTrue(bench.log, key, value)
            || (isPlanned && !startsAt(bench.log, key, oldFields.at(key)))) {
            ++figures.untrue;
            qWarning() << fault << key << "holds" << value << "but" << outcome.text();
        }
    }
    ++(olds == 0 ? figures.allNew : news == 0 ? figures.allOld : figures.mixed);
}

void TestTransferFaults::count(const Setup& setup, const QString& fault, Figures& figures)
{
    FaultBench bench;
    QVERIFY2(bench.open(fault, setup.more, setup.line), qPrintable(fault));
    const auto before = bench.read();
    QVERIFY2(before, qPrintable(fault));
    const auto wanted = wantedFrom(*before);
    const auto plan = planTransfer(*before, wanted, InputKind::Rc);
    auto outcome = bench.write(plan, setup.onFailure);
    QVERIFY2(outcome && bench.connected(), qPrintable(fault));
    ++figures.cases;
    figures.repaired += outcome->notes.join(u' ').contains(u"damaged packet"_s) ? 1 : 0;
    if (outcome->failedMayHold || !outcome->notRestored.empty()) {
        ++figures.interrupted;
        outcome = bench.examine(); // no "may" is left
        QVERIFY2(outcome && !outcome->failedMayHold && outcome->notRestored.empty(),
                 qPrintable(fault + (outcome ? outcome->text() : QString())));
    }
    const auto now = bench.read();
    QVERIFY2(now, qPrintable(fault));
    compare(bench, *outcome, *before, wanted, *now, fault, figures);
    const auto undo = bench.write(planTransfer(*now, bench.transfer.before(), InputKind::Rc));
    const auto back = bench.read();
    if (undo && !undo->error && back && fieldsOf(*back) == fieldsOf(*before)) {
        ++figures.undone;
    } else {
        qWarning() << fault << "not undone" << (undo ? undo->text() : QString());
    }
}

void TestTransferFaults::faultAtEveryByte_leavesOldOrNew_data()
{
    const bool isExhaustive = qEnvironmentVariableIntValue("TREX_EXHAUSTIVE") != 0;
    QTest::addColumn<QString>("fault"); ///< %1: the byte; %2: one of its bits
    QTest::addColumn<bool>("hasCrc");
    QTest::addColumn<bool>("stops"); ///< the caller decides about putting back
    QTest::addColumn<int>("step"); ///< every so many bytes
    const QString drop = u"drop-at=%1"_s;
    const QString hangUp = u"hangup-at=%1&fault=hangup-for=0.7"_s;
    const QString reset = u"reset-at=%1"_s;
    const QString corrupt = u"corrupt-at=%1&fault=corrupt-mask=%2"_s;
    const int seldom = isExhaustive ? 1 : 7;
    QTest::newRow("drop") << drop << false << false << 1;
    QTest::newRow("hang-up") << hangUp << false << false << 1;
    QTest::newRow("reset") << reset << false << false << 1;
    QTest::newRow("corrupt a bit") << corrupt << false << false << 1;
    QTest::newRow("drop, stop there") << drop << false << true << seldom;
    QTest::newRow("hang-up, stop there") << hangUp << false << true << seldom;
    QTest::newRow("reset, stop there") << reset << false << true << seldom;
    QTest::newRow("corrupt a bit, stop there") << corrupt << false << true << seldom;
    QTest::newRow("drop, CRC-7 and Pololu packets") << drop << true << false << seldom;
    QTest::newRow("corrupt, CRC-7 and Pololu packets") << corrupt << true << false << seldom;
    if (isExhaustive) {
        for (int mask = 1; mask < 256; mask = mask < 128 ? mask * 2 : mask + 0x1B) {
            QTest::addRow("corrupt by 0x%02X", mask)
                << u"corrupt-at=%1&fault=corrupt-mask="_s + QString::number(mask) << false << false
                << 1;
        }
    }
}

void TestTransferFaults::faultAtEveryByte_leavesOldOrNew()
{
    QFETCH(QString, fault);
    QFETCH(bool, hasCrc);
    QFETCH(bool, stops);
    QFETCH(int, step);
    Setup setup;
    setup.onFailure = stops ? OnFailure::Stop : OnFailure::PutBack;
    if (hasCrc) {
        setup.more = u"&error-detection=crc7"_s;
        setup.line.errorDetection = ErrorDetection::Crc7;
        setup.line.form = PacketForm::Pololu;
    }
    FaultBench clean;
    QVERIFY(clean.open({}, setup.more, setup.line));
    const auto before = clean.read();
    QVERIFY(before);
    const qint64 first = clean.wireBytes() + 1;
    const auto outcome = clean.write(planTransfer(*before, wantedFrom(*before), InputKind::Rc));
    QVERIFY(outcome && !outcome->error);
    const qint64 last = clean.wireBytes();
    Figures figures;
    for (qint64 byte = first; byte <= last; byte += step) {
        QString here = fault;
        here.replace(u"%1"_s, QString::number(byte))
            .replace(u"%2"_s, QString::number(1 << byte % 8));
        count(setup, here, figures);
    }
    m_cases += figures.cases;
    qInfo("bytes %lld to %lld, %d cases: all new %d, all old %d, some of both %d; interrupted %d, "
          "another setting put right %d; third values %d, untrue %d; undone %d",
          first, last, figures.cases, figures.allNew, figures.allOld, figures.mixed,
          figures.interrupted, figures.repaired, figures.third, figures.untrue, figures.undone);
    QVERIFY(figures.cases > (last - first) / step);
    QCOMPARE(figures.third, 0);
    QCOMPARE(figures.untrue, 0);
    QCOMPARE(figures.undone, figures.cases);
}

void TestTransferFaults::cleanupTestCase()
{
    qInfo("%d cases", m_cases);
}

QTEST_GUILESS_MAIN(TestTransferFaults)
#include "tst_transferfaults.moc"
