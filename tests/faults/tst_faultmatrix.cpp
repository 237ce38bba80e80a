// SPDX-License-Identifier: GPL-3.0-or-later
// Every fault of the line × packet form × error detection × kind of command, as a table. The whole
// (TREX_EXHAUSTIVE=1, or `./dev soak`) has ten million transactions, all on virtual time.
//
// "silent", "bad" and "crc" are failed attempts as the engine counts them; "misher": motors that
// did what no order said; "unstop": stops after which a motor still ran; "runs": motors that ran,
// unasked, when the line was whole again; "unrec": links not back within 2 s.
#include "protocol/codec/crc7.h"
#include "tests/faults/faultcell.h"

#include <QTest>

#include <cmath>
#include <cstdio>
#include <map>

using namespace trex;
using namespace trex::test;
using namespace std::chrono_literals;

namespace {

constexpr std::array kForms{PacketForm::Compact, PacketForm::Pololu};
constexpr std::array kDetections{ErrorDetection::None, ErrorDetection::Crc7};
constexpr int kCells =
    int(kLineFaults.size() * kForms.size() * kDetections.size() * kAskedNames.size());
constexpr quint64 kWanted = 10'000'000; ///< transactions of the whole
constexpr quint64 kSample = 400; ///< of a cell
// Seven bits let one in 128 of the replies through that are not what was sent.
constexpr double kCrcLets = 1.0 / 128.0;

bool isExhaustive()
{
    return qEnvironmentVariableIsSet("TREX_EXHAUSTIVE");
}

quint64 packetsOfACell()
{
    return isExhaustive() ? kWanted / quint64(kCells) + 1 : kSample;
}

double milliseconds(Duration duration)
{
    return std::chrono::duration<double, std::milli>(duration).count();
}

const char* nameOf(ErrorDetection detection)
{
    return detection == ErrorDetection::Crc7 ? "CRC-7" : "none";
}

const char* nameOf(PacketForm form)
{
    return form == PacketForm::Compact ? "compact" : "pololu";
}

void printHead()
{
    std::printf("%-17s %-7s %-5s %-14s %8s %8s %6s %6s %6s %6s %6s %6s %6s %5s %8s\n", "fault",
                "form", "check", "command", "packets", "right", "wrong", "silent", "bad", "crc",
                "misher", "unstop", "runs", "unrec", "worst ms");
}

void print(const char* fault, const char* form, const char* detection, const char* asked,
           const CellCounts& counts)
{
    const auto n = [](quint64 value) { return static_cast<unsigned long long>(value); };
    std::printf("%-17s %-7s %-5s %-14s %8llu %8llu %6llu %6llu %6llu %6llu %6llu %6llu %6llu %5llu "
                "%8.1f\n",
                fault, form, detection, asked, n(counts.packets), n(counts.right), n(counts.wrong),
                n(counts.noReply), n(counts.badReplies), n(counts.crcErrors), n(counts.misheard),
                n(counts.unstopped), n(counts.running), n(counts.unrecovered),
                milliseconds(counts.worstRecovery));
}

} // namespace

class TestFaultMatrix : public QObject {
    Q_OBJECT

public:
    static void initMain() { qputenv("QTEST_FUNCTION_TIMEOUT", "3600000"); }

private slots:
    void initTestCase() { printHead(); }

    void everyFault_isBoundedAndCounted_data()
    {
        QTest::addColumn<int>("fault");
        QTest::addColumn<PacketForm>("form");
        QTest::addColumn<ErrorDetection>("detection");
        for (std::size_t fault = 0; fault < kLineFaults.size(); ++fault) {
            for (const PacketForm form : kForms) {
                for (const ErrorDetection detection : kDetections) {
                    QTest::addRow("%s, %s, %s", kLineFaults.at(fault).name, nameOf(form),
                                  nameOf(detection))
                        << int(fault) << form << detection;
                }
            }
        }
    }
    void everyFault_isBoundedAndCounted()
    {
        QFETCH(int, fault);
        QFETCH(PacketForm, form);
        QFETCH(ErrorDetection, detection);
        const LineFault& row = kLineFaults.at(std::size_t(fault));
        CellCounts all;
        for (std::size_t asked = 0; asked < kAskedNames.size(); ++asked) {
            FaultCell cell(row, form, detection, static_cast<Asked>(asked),
                           quint64(fault) * 100 + asked + 1);
            const CellCounts counts = cell.run(packetsOfACell());
            if (isExhaustive()) {
                print(row.name, nameOf(form), nameOf(detection), kAskedNames.at(asked), counts);
            }
            all += counts;
        }
        print(row.name, nameOf(form), nameOf(detection), "all", all);
        m_sums[{fault, detection}] += all;
        QCOMPARE(all.hanging, 0U);
        QCOMPARE(all.unrecovered, 0U);
        QCOMPARE(all.running, 0U);
        QCOMPARE(all.noReply + all.badReplies + all.crcErrors, all.recorded); // nothing uncounted
        const auto wrong = double(all.wrong);
        const bool hasCrc = detection == ErrorDetection::Crc7;
        const double suspect =
            hasCrc ? wrong + double(all.crcErrors + all.badReplies) : wrong + double(all.right);
        const double most = suspect * (hasCrc ? kCrcLets : row.mostWrong);
        QVERIFY2(wrong <= most + 3.0 * std::sqrt(most), qPrintable(QString::number(wrong)));
        const quint64 share = hasCrc ? 10'000 : 20; // of the packets
        QVERIFY2(all.misheard <= (row.mayMove ? 1 + all.packets / share : 0),
                 qPrintable(QString::number(all.misheard)));
    }

    void crc_letsNoOneAndNoTwoWrongBitsThrough()
    {
        LineSettings line;
        line.errorDetection = ErrorDetection::Crc7;
        sim::Random random(11);
        qint64 tried = 0;
        for (const Command& command :
             {query("get-mode"), query("get-currents"), query("get-calibration"),
              channelsQuery("get-remapped-channels", 31), channelsQuery("get-raw-channels", 31)}) {
            QByteArray good;
            for (int i = 0; i < replyLength(command); ++i) {
                good.append(static_cast<char>(random.next() >> 56U));
            }
            good.append(static_cast<char>(crc7(good, line.polynomial)));
            const qsizetype bits = good.size() * 8;
            const auto flip = [](QByteArray bytes, qsizetype bit) {
                bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
                return bytes;
            };
            for (qsizetype first = 0; first < bits; ++first) {
                for (qsizetype second = first; second < bits; ++second, ++tried) {
                    QByteArray bad = flip(good, first);
                    bad = second == first ? bad : flip(bad, second);
                    ReplyParser parser(command, line);
                    parser.feed(bad);
                    QCOMPARE(parser.verdict(), ReplyParser::Verdict::BadCrc);
                }
            }
        }
        qInfo("%lld wrong replies, none accepted", static_cast<long long>(tried));
    }

    void cleanupTestCase()
    {
        CellCounts all;
        for (const auto& [key, counts] : m_sums) {
            print(kLineFaults.at(std::size_t(key.first)).name, "both", nameOf(key.second), "all",
                  counts);
            all += counts;
        }
        print("all", "", "", "", all);
    }

private:
    std::map<std::pair<int, ErrorDetection>, CellCounts> m_sums;
};

QTEST_APPLESS_MAIN(TestFaultMatrix)
#include "tst_faultmatrix.moc"
