// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the report, for HTML and PDF alike.
#include "protocol/procedures/benchreport.h"
#include "protocol/procedures/configtransfer.h"
#include "protocol/procedures/linetext.h"
#include "protocol/storage/benchtext.h"
#include "protocol/storage/configadapt.h"

using namespace Qt::Literals::StringLiterals;

namespace trex {

namespace {

QString modeText(Mode mode)
{
    switch (mode) {
    case Mode::Rc:
        return Bench::tr("RC mode");
    case Mode::Analog:
        return Bench::tr("analog mode");
    case Mode::SerialRc:
        return Bench::tr("serial mode, RC inputs");
    case Mode::SerialAnalog:
        return Bench::tr("serial mode, analog inputs");
    }
    return {};
}

} // namespace

BenchReport reportOn(const Controller& controller, const DeviceSettings& settings,
                     const QString& program, const QDateTime& started)
{
    const DeviceInfo& device = controller.device();
    return {.program = program,
            .started = started,
            .port = controller.options().port,
            .line = lineText(controller.options().line),
            .model = device.signature ? device.signature->modelName() : QString(),
            .firmware = device.signature ? device.signature->firmware() : QString(),
            .mode = device.mode ? modeText(*device.mode) : QString(),
            .settings = presentConfiguration(controller, settings)};
}

QString parameterText(const ParameterRow& row, int raw, Model model)
{
    const auto unit = QString::fromLatin1(row.unit);
    if (raw == 0 && row.zeroText != nullptr) {
        return QCoreApplication::translate("Parameters", row.zeroText);
    }
    for (const ParameterChoice& choice : row.choices) {
        if (choice.raw == raw && choice.title != nullptr) {
            return QCoreApplication::translate("Parameters", choice.title);
        }
    }
    return unit.isEmpty()
        ? QString::number(raw)
        : QString::number(physicalFromRaw(row, raw, model), 'f', row.decimals) + u' ' + unit;
}

std::vector<std::pair<QString, QString>> factsOf(const BenchOutcome& outcome,
                                                 const BenchReport& report)
{
    const QString notKnown = Bench::tr("not known");
    const auto orNot = [&](const QString& text) { return text.isEmpty() ? notKnown : text; };
    std::vector<std::pair<QString, QString>> facts{
        {Bench::tr("Started"), report.started.toString(u"yyyy-MM-dd HH:mm:ss 'UTC'"_s)},
        {Bench::tr("Length"), Bench::tr("%1 s").arg(outcome.trace.seconds, 0, 'f', 1)},
        {Bench::tr("Ended"),
         outcome.ending.end == BenchEnd::Completed ? Bench::tr("all steps done")
                                                   : outcome.ending.reason},
        {Bench::tr("Controller"), orNot(report.model)},
        {Bench::tr("Firmware"), orNot(report.firmware)},
        {Bench::tr("Mode"), orNot(report.mode)},
        {Bench::tr("Port"),
         report.port.startsWith("sim:"_L1)
             ? Bench::tr("%1 (a simulated controller)").arg(report.port)
             : orNot(report.port)},
        {Bench::tr("Line"), orNot(report.line)},
        {Bench::tr("Supply"),
         outcome.profile.supplyVolts
             ? Bench::tr("%1 V, as stated").arg(*outcome.profile.supplyVolts)
             : notKnown},
        {Bench::tr("Current scale"),
         outcome.trace.model == Model::TrexJr
             ? Bench::tr("40 mA a step (documented, without a tolerance)")
             : Bench::tr("150 mA a step (inferred, about ±20 %)")},
        {Bench::tr("Program"), report.program}};
    if (outcome.isDryRun) {
        std::erase_if(facts, [](const auto& fact) {
            return fact.first == Bench::tr("Port") || fact.first == Bench::tr("Line")
                || fact.first == Bench::tr("Mode");
        });
    }
    return facts;
}

std::vector<ProposalText> proposalsOf(const BenchOutcome& outcome)
{
    std::vector<ProposalText> texts;
    for (const BenchProposal& proposal : outcome.proposals) {
        if (const ParameterRow* row = findParameter(proposal.parameter)) {
            texts.push_back({QCoreApplication::translate("Parameters", row->title),
                             parameterText(*row, proposal.raw, outcome.trace.model),
                             proposal.reason});
        }
    }
    return texts;
}

QString knowledgeText()
{
    return Bench::tr(
        "The controller measures only its motor currents, in steps, about 80 times a second, and "
        "no "
        "speed. Everything beyond currents is reasoned from them by the equations of a brushed "
        "motor "
        "with dry friction. Uncertainties are about two standard deviations; the tolerance of the "
        "current scale itself is not documented and not in them.");
}

QString signOf(BenchVerdict verdict)
{
    switch (verdict) {
    case BenchVerdict::Passed:
        return u"✔"_s;
    case BenchVerdict::Failed:
        return u"✖"_s;
    case BenchVerdict::NotMeasured:
        return u"▲"_s;
    case BenchVerdict::NotJudged:
        break;
    }
    return u"○"_s;
}

QString printable(const QString& text)
{
    QString tame = text;
    for (QChar& character : tame) {
        const bool isControl = character.category() == QChar::Other_Control && character != u'\n';
        if (isControl || character.unicode() >= 0xFFFE) {
            character = QChar::ReplacementCharacter;
        }
    }
    // Half a surrogate pair is no text, either.
    return QString::fromUtf8(tame.toUtf8());
}

} // namespace trex
