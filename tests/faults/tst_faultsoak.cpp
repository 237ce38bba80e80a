// SPDX-License-Identifier: GPL-3.0-or-later
// Hours of full polling with a fault of the line every minute: nothing wrong with CRC-7, nothing
// that does not come back, nothing that moves, no memory that grows. A short run with all other
// tests; the day with `./dev soak`.
#include "tests/faults/faultcell.h"

#include <QFile>
#include <QTest>

#include <cstdio>

using namespace trex;
using namespace trex::test;
using namespace std::chrono_literals;

namespace {

constexpr int kShortMinutes = 10;

std::chrono::minutes soakLength()
{
    bool isNumber = false;
    const int minutes = qEnvironmentVariableIntValue("TREX_SOAK_MINUTES", &isNumber);
    return std::chrono::minutes(isNumber ? minutes : kShortMinutes);
}

/// Resident memory of this process, in MiB.
double residentMiB()
{
    QFile file(QStringLiteral("/proc/self/statm"));
    if (!file.open(QIODevice::ReadOnly)) {
        return 0.0;
    }
    return double(file.readAll().split(' ').value(1).toULongLong()) * 4096.0 / 1048576.0;
}

} // namespace

class TestFaultSoak : public QObject {
    Q_OBJECT

public:
    static void initMain() { qputenv("QTEST_FUNCTION_TIMEOUT", "3600000"); }

private slots:
    void randomFaults_leaveNothingBehind_data()
    {
        QTest::addColumn<ErrorDetection>("detection");
        QTest::newRow("CRC-7") << ErrorDetection::Crc7;
        QTest::newRow("none") << ErrorDetection::None;
    }
    void randomFaults_leaveNothingBehind()
    {
        QFETCH(ErrorDetection, detection);
        const bool hasCrc = detection == ErrorDetection::Crc7;
        FaultCell cell({}, PacketForm::Compact, detection, Asked::Poll, hasCrc ? 7 : 8);
        std::ignore = cell.soak(5min); // what is allocated once
        const double before = residentMiB();
        const CellCounts counts = cell.soak(soakLength());
        const double grown = residentMiB() - before;
        const auto n = [](quint64 value) { return static_cast<unsigned long long>(value); };
        std::printf(
            "%s, %lld minutes: %d faults, %llu packets, %llu of %llu samples, %llu values "
            "compared, %llu wrong; %llu without a reply, %llu bad, %llu CRC; %llu misheard, "
            "%llu unstopped, %llu running, %llu unrecovered, worst %.0f ms; %.2f MiB more\n",
            hasCrc ? "CRC-7" : "no CRC", static_cast<long long>(soakLength().count()),
            cell.episodes(), n(counts.packets), n(cell.samples()), n(cell.sent()),
            n(counts.right + counts.wrong), n(counts.wrong), n(counts.noReply),
            n(counts.badReplies), n(counts.crcErrors), n(counts.misheard), n(counts.unstopped),
            n(counts.running), n(counts.unrecovered),
            std::chrono::duration<double, std::milli>(counts.worstRecovery).count(), grown);
        QCOMPARE(counts.hanging, 0U);
        QCOMPARE(counts.unrecovered, 0U);
        QCOMPARE(counts.running, 0U);
        QCOMPARE(counts.noReply + counts.badReplies + counts.crcErrors, counts.recorded);
        QVERIFY(double(cell.samples()) > 0.98 * double(cell.sent()));
        QVERIFY(grown < 4.0);
        if (hasCrc) {
            QVERIFY(counts.wrong <= 1 + counts.crcErrors / 64);
            QCOMPARE(counts.misheard, 0U);
        } else {
            QVERIFY(counts.wrong <= counts.right / 1000 + 10);
        }
    }
};

QTEST_APPLESS_MAIN(TestFaultSoak)
#include "tst_faultsoak.moc"
