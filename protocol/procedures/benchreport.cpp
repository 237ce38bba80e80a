// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedures/benchreport.h"

#include "protocol/savefile.h"
#include "protocol/storage/benchtext.h"

#include <QBuffer>
#include <QSysInfo>
#include <QXmlStreamWriter>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

/// No character here that XML would have to escape: the text of a style element is taken as it is.
constexpr auto kStyle = R"(
:root { color-scheme: light dark; --page: #f4f6f8; --paper: #ffffff; --ink: #1f2328; --dim: #59636e; --rule: #d8dee4;
  --grid: #dfe3e8; --zero: #8c959f; --m1: #0063a6; --m2: #b84a00; --aux: #00735a; --ok: #1a7f37; --bad: #c4232b; --warn: #8a5a00; --head: #eef1f4; }
@media (prefers-color-scheme: dark) { :root { --page: #15181c; --paper: #1e2227; --ink: #e6eaef; --dim: #9aa4af; --rule: #3a424b;
  --grid: #2f363e; --zero: #6e7781; --m1: #58b4f0; --m2: #f0a03c; --aux: #3ccfa6; --ok: #4cc38a; --bad: #ff6b6b; --warn: #e3b341; --head: #262c33; } }
@media print { :root { --page: #ffffff; --paper: #ffffff; --ink: #1f2328; --dim: #59636e; --rule: #d8dee4; --grid: #dfe3e8; --zero: #8c959f;
  --m1: #0063a6; --m2: #b84a00; --aux: #00735a; --ok: #1a7f37; --bad: #c4232b; --warn: #8a5a00; --head: #eef1f4; }
  body { font-size: 10pt; padding: 0; } main { box-shadow: none; padding: 0; max-width: none; } details summary { display: none; }
  section, figure, tr { break-inside: avoid; } h2 { break-after: avoid; } @page { margin: 16mm; } }
* { box-sizing: border-box; }
body { margin: 0; padding: 24px 12px; background: var(--page); color: var(--ink); font: 15px/1.5 system-ui, sans-serif; }
main { max-width: 980px; margin: 0 auto; background: var(--paper); padding: 32px 36px; border-radius: 6px; box-shadow: 0 1px 4px rgba(0,0,0,.18); }
h1 { margin: 0 0 4px; font-size: 1.7em; line-height: 1.2; } h2 { margin: 32px 0 10px; font-size: 1.15em; border-bottom: 1px solid var(--rule); padding-bottom: 4px; }
p { margin: 6px 0; max-width: 75ch; } .dim { color: var(--dim); fill: var(--dim); } .ink { fill: var(--ink); }
.verdict { margin: 18px 0; padding: 10px 14px; border-left: 5px solid; font-weight: 600; background: var(--head); }
.passed { color: var(--ok); } .failed, .not-measured { color: var(--bad); } .not-judged { color: var(--dim); } .note { color: var(--warn); }
table { border-collapse: collapse; width: 100%; font-size: .93em; } th, td { text-align: left; vertical-align: top; padding: 5px 10px 5px 0; border-bottom: 1px solid var(--rule); }
th { font-weight: 600; color: var(--dim); } td.num, th.num { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; padding-right: 18px; } td.word { white-space: nowrap; }
table.facts { width: auto; } table.facts th { padding-right: 24px; font-weight: 400; } table.facts td, table.facts th { border: 0; padding-top: 2px; padding-bottom: 2px; }
figure { margin: 14px 0; } figure svg { width: 100%; height: auto; display: block; } figcaption { font-weight: 600; margin-bottom: 4px; }
pre { background: var(--head); padding: 12px; overflow-x: auto; font-size: .82em; line-height: 1.4; white-space: pre-wrap; overflow-wrap: anywhere; }
.grid { stroke: var(--grid); } .zero, .mark { stroke: var(--zero); } .bad { stroke: var(--bad); } .m1 { stroke: var(--m1); } .m2 { stroke: var(--m2); } .aux { stroke: var(--aux); }
.m1f { fill: var(--m1); } .m2f { fill: var(--m2); } .auxf { fill: var(--aux); } code { font-size: .92em; color: var(--dim); } summary { cursor: pointer; color: var(--dim); }
)";

class Html {
public:
    Html(const BenchOutcome& outcome, const BenchReport& report)
        : m_outcome(outcome), m_report(report), m_xml(&m_buffer)
    {
        m_buffer.open(QIODevice::WriteOnly);
    }
    QByteArray write()
    {
        open("html");
        m_xml.writeAttribute(u"lang"_s, Bench::tr("en", "language of the report, as in HTML"));
        writeHead();
        open("body");
        open("main");
        writeSummary();
        writeResults();
        writePlots();
        writeProposals();
        writeSettings();
        writeProfile();
        writeEvents();
        element("h2", Bench::tr("What such a test can know"));
        element("p", knowledgeText());
        element("p",
                Bench::tr("Written by %1 on %2, Qt %3.")
                    .arg(m_report.program, QSysInfo::prettyProductName(),
                         QLatin1StringView(qVersion())),
                "dim");
        m_xml.writeEndDocument();
        return "<!DOCTYPE html>\n" + m_buffer.data() + '\n';
    }

private:
    void open(const char* name, const char* className = nullptr)
    {
        m_xml.writeStartElement(QLatin1StringView(name));
        if (className != nullptr) {
            m_xml.writeAttribute(u"class"_s, QLatin1StringView(className));
        }
    }
    void close() { m_xml.writeEndElement(); }
    /// An element without text would be closed in itself, which HTML does not know.
    void element(const char* name, const QString& text, const char* className = nullptr)
    {
        open(name, className);
        m_xml.writeCharacters(text.isEmpty() ? u"\u00A0"_s : printable(text));
        close();
    }
    void header(std::initializer_list<std::pair<QString, const char*>> cells)
    {
        open("thead");
        open("tr");
        for (const auto& [text, className] : cells) {
            element("th", text, className);
        }
        close();
        close();
    }
    void writeHead();
    void writeSummary();
    void writeResults();
    void writePlots();
    void writeProposals();
    void writeSettings();
    void writeProfile();
    void writeEvents();

    const BenchOutcome& m_outcome;
    const BenchReport& m_report;
    QBuffer m_buffer;
    QXmlStreamWriter m_xml;
};

void Html::writeHead()
{
    open("head");
    m_xml.writeEmptyElement(u"meta"_s);
    m_xml.writeAttribute(u"charset"_s, u"utf-8"_s);
    m_xml.writeEmptyElement(u"meta"_s);
    m_xml.writeAttribute(u"name"_s, u"viewport"_s);
    m_xml.writeAttribute(u"content"_s, u"width=device-width, initial-scale=1"_s);
    element("title", Bench::tr("Bench test: %1").arg(m_outcome.profile.name));
    element("style", QString::fromLatin1(kStyle));
    close();
}

void Html::writeSummary()
{
    element("h1", m_outcome.profile.name);
    if (!m_outcome.profile.description.isEmpty()) {
        element("p", m_outcome.profile.description, "dim");
    }
    const BenchVerdict verdict = m_outcome.verdict();
    open("p");
    m_xml.writeAttribute(u"class"_s, u"verdict "_s + keyOf(verdict));
    m_xml.writeCharacters(signOf(verdict) + u' ' + printable(m_outcome.verdictText()));
    close();
    if (m_outcome.isDryRun) {
        element("p",
                Bench::tr("▲ Dry run on the simulated controller and its motors: a prediction. No "
                          "real motor was moved or measured."),
                "note");
    }
    open("table", "facts");
    open("tbody");
    for (const auto& [label, value] : factsOf(m_outcome, m_report)) {
        open("tr");
        element("th", label);
        element("td", value);
        close();
    }
    close();
    close();
}

void Html::writeResults()
{
    if (m_outcome.results.empty()) {
        return;
    }
    element("h2", Bench::tr("Results"));
    open("table");
    header({{Bench::tr("Result"), nullptr},
            {Bench::tr("Value"), "num"},
            {Bench::tr("Expected"), nullptr},
            {Bench::tr("Verdict"), nullptr},
            {Bench::tr("Rests on"), nullptr}});
    open("tbody");
    for (const BenchResult& result : m_outcome.results) {
        open("tr");
        open("td");
        m_xml.writeCharacters(printable(result.title));
        m_xml.writeEmptyElement(u"br"_s);
        element("code", result.key);
        close();
        element("td", valueText(result), "num");
        element("td", expectedText(result), "word");
        open("td");
        m_xml.writeAttribute(u"class"_s, u"word "_s + keyOf(result.verdict));
        m_xml.writeCharacters(signOf(result.verdict) + u' ' + textOf(result.verdict));
        close();
        element("td", result.note, "dim");
        close();
    }
    close();
    close();
}

void Html::writePlots()
{
    const auto plots = plotsOf(m_outcome);
    if (!plots.empty()) {
        element("h2", Bench::tr("Plots"));
    }
    for (const BenchPlot& plot : plots) {
        open("figure");
        element("figcaption", plot.title);
        m_xml.writeCharacters(QString()); // ends the start tag
        m_buffer.write(plot.svg); // written by plotsOf(), escaped there
        close();
    }
    if (!plots.empty()) {
        element("p",
                Bench::tr("Speeds as told: motor 1 solid, motor 2 dashed, the auxiliary motor "
                          "dotted; braking is drawn as 0. Where readings are missing, the line is "
                          "broken."),
                "dim");
    }
}

void Html::writeProposals()
{
    const auto proposals = proposalsOf(m_outcome);
    if (proposals.empty()) {
        return;
    }
    element("h2", Bench::tr("Proposed settings"));
    element(
        "p",
        Bench::tr("What follows from the results. Nothing of it was written to the controller."));
    open("table");
    header({{Bench::tr("Parameter"), nullptr},
            {Bench::tr("Proposal"), "num"},
            {Bench::tr("Reason"), nullptr}});
    open("tbody");
    for (const ProposalText& proposal : proposals) {
        open("tr");
        element("td", proposal.title);
        element("td", proposal.value, "num");
        element("td", proposal.reason, "dim");
        close();
    }
    close();
    close();
}

void Html::writeSettings()
{
    element("h2", Bench::tr("Settings of the controller"));
    if (m_report.settings.parameters.empty()) {
        element("p", Bench::tr("They were not read."), "dim");
        return;
    }
    open("table");
    header({{Bench::tr("Parameter"), nullptr},
            {Bench::tr("Value"), "num"},
            {Bench::tr("Raw"), "num"}});
    open("tbody");
    for (const auto& [number, raw] : m_report.settings.parameters) {
        const ParameterRow* row = findParameter(number);
        if (row == nullptr || row->isTrigger) {
            continue;
        }
        open("tr");
        element("td", QCoreApplication::translate("Parameters", row->title));
        element("td", parameterText(*row, raw, m_outcome.trace.model), "num");
        element("td", QString::number(raw), "num");
        close();
    }
    close();
    close();
}

void Html::writeProfile()
{
    element("h2", Bench::tr("The test as it was run"));
    element("pre", QString::fromUtf8(writeBenchProfile(m_outcome.profile)).trimmed());
}

void Html::writeEvents()
{
    element("h2", Bench::tr("Events"));
    open("table");
    header({{Bench::tr("Time, s"), "num"}, {Bench::tr("Event"), nullptr}});
    open("tbody");
    constexpr std::size_t kMost = 500;
    const auto& events = m_outcome.trace.events;
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (events.size() > kMost && i == kMost / 2) {
            i = events.size() - kMost / 2;
            open("tr");
            element("td", u"…"_s, "num");
            element("td", Bench::tr("%1 events are left out here").arg(events.size() - kMost));
            close();
        }
        open("tr");
        element("td", QString::number(events[i].seconds, 'f', 2), "num");
        element("td", events[i].text, events[i].severity > 0 ? "failed" : nullptr);
        close();
    }
    close();
    close();
}

} // namespace

QByteArray reportHtml(const BenchOutcome& outcome, const BenchReport& report)
{
    return Html(outcome, report).write();
}

Result<void> saveReport(const QString& path, const BenchOutcome& outcome, const BenchReport& report)
{
    SaveFile file(path);
    const QByteArray html = reportHtml(outcome, report);
    if (!file.open(QIODevice::WriteOnly) || file.write(html) != html.size() || !file.commit()) {
        return fail(ErrorCode::FileUnwritable, u"%1: %2"_s.arg(path, file.errorString()));
    }
    return {};
}

} // namespace trex
