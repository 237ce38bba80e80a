// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a bench test: well-formed, self-contained, harmless whatever stands in the profile,
// and with all that it has to say.
#include "protocol/procedures/benchdryrun.h"
#include "protocol/procedures/benchreport.h"
#include "protocol/storage/readyprofiles.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

using namespace trex;
using namespace std::chrono_literals;
using namespace Qt::Literals::StringLiterals;

namespace {

const QString kHostile =
    u"<script>alert('x')</script> & \"quoted\" </style></pre> \u0001\u0008 \uFFFE \u202E ünï"_s;

BenchOutcome outcomeOf(const BenchProfile& profile)
{
    BenchDryRun dry(profile);
    while (dry.advance(10s)) { }
    return evaluate(dry.run(), true);
}

BenchReport someReport()
{
    BenchReport report{.program = u"Test 1.0"_s,
                       .started = QDateTime(QDate(2026, 11, 27), QTime(12, 30), Qt::UTC),
                       .port = u"/dev/ttyUSB0"_s,
                       .line = u"19200 baud"_s,
                       .model = u"TReX Jr"_s,
                       .firmware = u"1.2"_s,
                       .mode = u"serial mode, RC inputs"_s,
                       .settings = {}};
    report.settings.parameters[parameterRow("serial-timeout").number] = 5;
    return report;
}

/// All text of the document, and the names of its elements; empty names: it is not well-formed.
struct Parsed {
    QString text;
    QStringList elements;
    QString error;
};
Parsed parse(QByteArray html)
{
    Parsed parsed;
    QXmlStreamReader xml(html.replace("<!DOCTYPE html>\n", ""));
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement()) {
            parsed.elements << xml.name().toString();
        } else if (xml.isCharacters()) {
            parsed.text += xml.text();
        }
    }
    parsed.error = xml.hasError() ? xml.errorString() : QString();
    return parsed;
}

} // namespace

class TestBenchReport : public QObject {
    Q_OBJECT

private slots:
    void everyReadyTest_hasAWholeReport_data();
    void everyReadyTest_hasAWholeReport();
    void hostileText_isOnlyText();
    void longTest_staysSmall();
    void file_isWrittenWhole();
};

void TestBenchReport::everyReadyTest_hasAWholeReport_data()
{
    QTest::addColumn<QByteArray>("key");
    for (const ReadyProfileRow& row : readyProfiles()) {
        QTest::newRow(row.key.data()) << QByteArray(row.key.data());
    }
}

void TestBenchReport::everyReadyTest_hasAWholeReport()
{
    QFETCH(QByteArray, key);
    const BenchOutcome outcome = outcomeOf(readyProfile(key.toStdString()).value());
    const QByteArray html = reportHtml(outcome, someReport());
    const Parsed parsed = parse(html);
    QVERIFY2(parsed.error.isEmpty(), qPrintable(parsed.error));
    for (const BenchResult& result : outcome.results) {
        QVERIFY2(parsed.text.contains(result.title) && parsed.text.contains(result.key),
                 qPrintable(result.key));
    }
    for (const BenchProposal& proposal : outcome.proposals) {
        QVERIFY(parsed.text.contains(proposal.reason));
    }
    for (const QString& fact : {u"TReX Jr"_s, u"2026-11-27 12:30:00"_s, u"500 ms"_s, u"Dry run"_s,
                                u"Test 1.0"_s, u"All steps done"_s}) {
        QVERIFY2(parsed.text.contains(fact), qPrintable(fact));
    }
    BenchOutcome real = outcome;
    real.isDryRun = false;
    const QString realText = parse(reportHtml(real, someReport())).text;
    QVERIFY(realText.contains(u"/dev/ttyUSB0"_s) && !realText.contains(u"Dry run"_s));
    QVERIFY(parsed.elements.contains(u"svg"_s) && parsed.elements.contains(u"path"_s));
    // The profile in it can be run again.
    static const QRegularExpression pre(u"\\{\\s+\"format\": \"trexpanel-bench-profile\".*\\n\\}"_s,
                                        QRegularExpression::DotMatchesEverythingOption);
    const auto again = parseBenchProfile(pre.match(parsed.text).captured().toUtf8(), u"report"_s);
    QVERIFY2(again, again ? "" : qPrintable(again.error().context));
    // Self-contained: nothing is fetched, nothing runs.
    static const QRegularExpression outside(
        u"(src|href|url\\(|@import|<script|<link|http(?!://www.w3.org/2000/svg))"_s);
    const auto found = outside.match(QString::fromUtf8(html));
    QVERIFY2(!found.hasMatch(), qPrintable(found.captured()));
    // Elements that HTML does not let be closed in themselves.
    static const QRegularExpression closed(
        u"<(?!meta|br|line|path|circle|rect)[a-z0-9]+[^<>]*/>"_s);
    QVERIFY2(!closed.match(QString::fromUtf8(html)).hasMatch(),
             qPrintable(closed.match(QString::fromUtf8(html)).captured()));
}

void TestBenchReport::hostileText_isOnlyText()
{
    BenchProfile profile = readyProfile("left-right").value();
    profile.name = kHostile;
    profile.description = kHostile;
    profile.steps.front().label = kHostile;
    profile.expect[kHostile] = {.minimum = 1.0, .maximum = {}};
    profile.comments.push_back({u"why"_s, u"name"_s, "\"</pre><script>x</script>\""});
    BenchReport report = someReport();
    for (QString* text : {&report.port, &report.line, &report.model, &report.firmware, &report.mode,
                          &report.program}) {
        *text = kHostile;
    }
    const QByteArray html = reportHtml(outcomeOf(profile), report);
    const Parsed parsed = parse(html);
    QVERIFY2(parsed.error.isEmpty(), qPrintable(parsed.error));
    QVERIFY(!parsed.elements.contains(u"script"_s));
    QCOMPARE(parsed.elements.count(u"style"_s), 1);
    QVERIFY(!html.contains("<script") && !html.contains('\x01') && !html.contains('\x08'));
    QVERIFY(parsed.text.contains(u"<script>alert('x')</script>"_s)); // shown, not run
}

void TestBenchReport::longTest_staysSmall()
{
    const BenchOutcome outcome = outcomeOf(readyProfile("endurance").value());
    QVERIFY(outcome.trace.samples.size() > 60'000);
    const QByteArray html = reportHtml(outcome, someReport());
    QVERIFY2(html.size() < 300'000, qPrintable(QString::number(html.size())));
}

void TestBenchReport::file_isWrittenWhole()
{
    const QTemporaryDir folder;
    const BenchOutcome outcome = outcomeOf(readyProfile("left-right").value());
    QVERIFY(saveReport(folder.filePath(u"r.html"_s), outcome, someReport()));
    QCOMPARE(saveReport(folder.filePath(u"no/r.html"_s), outcome, someReport()).error().code,
             ErrorCode::FileUnwritable);
}

QTEST_GUILESS_MAIN(TestBenchReport)
#include "tst_benchreport.moc"
