// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parameterhelp.h"

#include "widgets/common/theme.h"

#include <QCoreApplication>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct ParameterHelp {
    Q_DECLARE_TR_FUNCTIONS(ParameterHelp)
};

QString coloured(const QString& text, ColourRole role)
{
    return u"<span style=\"color:%1\">%2</span>"_s.arg(theme::colour(role).name(),
                                                       text.toHtmlEscaped());
}

} // namespace

QString parameterHelp(const ParameterModel& model, const ParameterRow& row)
{
    const QString number = hexText(row.number);
    QStringList lines{u"<b>%1</b> &nbsp;%2"_s.arg(
        QCoreApplication::translate("Parameters", row.title).toHtmlEscaped(),
        coloured(u"%1 · %2 · %3"_s.arg(keyText(row), number, model.stateText(row.number)),
                 ColourRole::DimText))};
    const bool isRefused = model.state(row.number) == ParameterModel::State::Refused;
    for (const auto& remark : model.remarks(row.number)) {
        lines << coloured(u"▲ "_s + remark, isRefused ? ColourRole::Fault : ColourRole::Warning);
    }
    QString help = QCoreApplication::translate("Parameters", row.help).toHtmlEscaped();
    if (isGuess(row.meaningGrade)) {
        help += ParameterHelp::tr(" (Unsure: the vendor does not state it.)").toHtmlEscaped();
    }
    lines << help;
    lines << ParameterHelp::tr("Range: %1. Default: %2, %3.")
                 .arg(rangeText(row, model.controllerModel()), defaultText(row, model.context(row)),
                      gradeText(row.defaultGrade))
                 .toHtmlEscaped()
            + u' '
            + (row.needsReset ? ParameterHelp::tr("Acts after a power cycle.")
                              : ParameterHelp::tr("Acts at once."))
                  .toHtmlEscaped();
    if (displayUnit(row, model.controllerModel()).isGuess) {
        lines << ParameterHelp::tr("≈ The scale in amperes is inferred for the TReX.");
    }
    lines << coloured(ParameterHelp::tr("Meaning %1. Source: %2")
                          .arg(gradeText(row.meaningGrade), QString::fromLatin1(row.source)),
                      ColourRole::DimText);
    return lines.join(u"<br>"_s);
}

} // namespace trex
