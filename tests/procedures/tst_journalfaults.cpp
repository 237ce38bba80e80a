// SPDX-License-Identifier: GPL-3.0-or-later
// One fault in an apply of ten parameters and five calibrations, with the journal in its file: what
// it says afterwards is what the controller holds, and it leads back to the start. Sampled; every
// byte is tst_transferfaults'.
#include "protocol/procedures/writeaudit.h"
#include "tests/support/faultbench.h"

#include <QTemporaryDir>
#include <QTest>

using namespace Qt::Literals::StringLiterals;
using namespace trex;
using namespace trex::test;

namespace {

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

SettingValue valueOf(const Configuration& configuration, const SettingId& setting)
{
    if (setting.row != nullptr) {
        return configuration.parameters.at(setting.row->number);
    }
    return configuration.calibrations.at(setting.input).at(setting.channel);
}

struct JournalBench {
    JournalBench() : journal(folder.filePath(u"journal.sqlite"_s)) { }
    void resolve()
    {
        bool isDone = false;
        audit.resolve(&bench, [&isDone] { isDone = true; });
        QVERIFY(bench.until([&isDone] { return isDone; }));
    }
    QTemporaryDir folder;
    FaultBench bench;
    Journal journal;
    WriteAudit audit{bench.controller, bench.settings, journal, WriteAudit::WhenUnsaved::GoOn};
};

} // namespace

class TestJournalFaults : public QObject {
    Q_OBJECT

private slots:
    void fault_leavesWhatTheJournalSays_data();
    void fault_leavesWhatTheJournalSays();

private:
    static void check(const QString& fault, int& open);
};

void TestJournalFaults::check(const QString& fault, int& open)
{
    JournalBench it;
    QVERIFY2(it.bench.open(fault, {}, {}), qPrintable(fault));
    const auto before = it.bench.read();
    QVERIFY2(before, qPrintable(fault));
    const auto wanted = wantedFrom(*before);
    QVERIFY(it.bench.write(planTransfer(*before, wanted, InputKind::Rc)));
    QVERIFY2(it.bench.connected(), qPrintable(fault));
    it.resolve();
    const auto now = it.bench.read();
    QVERIFY2(now, qPrintable(fault));
    const auto entries = it.journal.entries({});
    QVERIFY(entries);
    std::map<QString, const JournalEntry*> latest;
    const JournalEntry* first = nullptr;
    for (const JournalEntry& entry : *entries) {
        const SettingId& setting = entry.intent.setting;
        const QString key = setting.row != nullptr
            ? QString::fromLatin1(setting.row->key)
            : u"%1 %2"_s.arg(keyOf(setting.input)).arg(setting.channel);
        const JournalEntry*& newest = latest[key];
        newest = newest == nullptr || newest->number < entry.number ? &entry : newest;
        first = first == nullptr || entry.number < first->number ? &entry : first;
    }
    for (const auto& [key, entry] : latest) {
        const SettingValue held = valueOf(*now, entry->intent.setting);
        const auto said = entry->valueAfter();
        open += said ? 0 : 1;
        QVERIFY2(said && held == *said, qPrintable(fault + u' ' + key));
        const bool isOldOrNew = held == valueOf(*before, entry->intent.setting)
            || held == valueOf(wanted, entry->intent.setting);
        QVERIFY2(isOldOrNew, qPrintable(fault + u' ' + key));
    }
    if (first == nullptr) {
        return; // nothing was written at all
    }
    const auto start = it.journal.stateBefore(*first);
    QVERIFY2(start, qPrintable(fault));
    const auto undone = it.bench.write(planTransfer(*now, *start, InputKind::Rc));
    QVERIFY2(undone && !undone->error, qPrintable(fault));
    const auto back = it.bench.read();
    QVERIFY2(back && back->parameters == before->parameters
                 && back->calibrations == before->calibrations,
             qPrintable(fault));
}

void TestJournalFaults::fault_leavesWhatTheJournalSays_data()
{
    QTest::addColumn<QString>("fault"); ///< %1: the byte; %2: one of its bits
    QTest::newRow("drop") << u"drop-at=%1"_s;
    QTest::newRow("corrupt") << u"corrupt-at=%1&fault=corrupt-mask=%2"_s;
    QTest::newRow("hang-up") << u"hangup-at=%1&fault=hangup-for=0.7"_s;
    QTest::newRow("reset") << u"reset-at=%1"_s;
}

void TestJournalFaults::fault_leavesWhatTheJournalSays()
{
    QFETCH(QString, fault);
    JournalBench clean;
    QVERIFY(clean.bench.open({}, {}, {}));
    const auto before = clean.bench.read();
    QVERIFY(before);
    const qint64 begin = clean.bench.wireBytes() + 1;
    const auto outcome =
        clean.bench.write(planTransfer(*before, wantedFrom(*before), InputKind::Rc));
    QVERIFY(outcome && !outcome->error);
    QCOMPARE(clean.journal.entries({})->size(), std::size_t(15));
    const qint64 end = clean.bench.wireBytes();
    int cases = 0;
    int open = 0;
    for (qint64 byte = begin; byte <= end; byte += 23, ++cases) {
        QString here = fault;
        here.replace(u"%1"_s, QString::number(byte))
            .replace(u"%2"_s, QString::number(1 << byte % 8));
        check(here, open);
        if (QTest::currentTestFailed()) {
            return;
        }
    }
    qInfo("bytes %lld to %lld, %d cases; entries left open %d", begin, end, cases, open);
    QVERIFY(cases > 15);
}

QTEST_GUILESS_MAIN(TestJournalFaults)
#include "tst_journalfaults.moc"
