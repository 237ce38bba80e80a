// SPDX-License-Identifier: GPL-3.0-or-later
// How parameters read: the words of the model.
#include "widgets/parameters/parametermodel.h"

#include <QCoreApplication>

using namespace Qt::Literals::StringLiterals;

namespace trex {
QString ParameterModel::stateText(std::uint8_t number) const
{
    switch (state(number)) {
    case State::AtDefault: // which may be no more than what we take for it
        return isGuess(findParameter(int{number})->defaultGrade) ? tr("≈ default") : tr("default");
    case State::Unread:
        return tr("not read");
    case State::Differs:
        return tr("not default");
    case State::Advised:
        return tr("note");
    case State::Pending:
        return tr("power cycle");
    case State::Edited:
        return advice(number).isEmpty() ? tr("edited") : tr("edited ▲");
    case State::Refused:
        return tr("refused");
    }
    return {};
}

QString ParameterModel::text(const ParameterRow& row, int column) const
{
    switch (column) {
    case TitleColumn: {
        const QString title = QCoreApplication::translate("Parameters", row.title);
        return isGuess(row.meaningGrade) ? title + u" ≈"_s : title;
    }
    case DeviceColumn:
        return device(row.number) ? valueWithRaw(row, *device(row.number), deviceContext(row))
                                  : u"–"_s;
    case DefaultColumn:
        return defaultText(row, context(row));
    case RangeColumn:
        return rangeText(row, m_controllerModel);
    case SourceColumn:
        return gradeInShort(weakestGrade(row));
    case StateColumn:
        return stateText(row.number);
    default: // the editor stands there
        return {};
    }
}

QString ParameterModel::toolTip(const ParameterRow& row) const
{
    QStringList lines{u"<b>%1</b> · %2 · %3"_s.arg(
        QCoreApplication::translate("Parameters", row.title), keyText(row), hexText(row.number))};
    // What the cells say, where they are cut.
    lines << tr("%1 · in controller: %2 · default: %3")
                 .arg(stateText(row.number), text(row, DeviceColumn), text(row, DefaultColumn));
    lines += remarks(row.number);
    lines << QCoreApplication::translate("Parameters", row.help);
    lines << tr("Meaning: %1. Default: %2.")
                 .arg(gradeWithSign(row.meaningGrade), gradeWithSign(row.defaultGrade));
    if (displayUnit(row, m_controllerModel).isGuess) {
        lines << tr("≈ The scale in amperes is inferred for the TReX.");
    }
    lines << tr("Source: %1").arg(QString::fromLatin1(row.source));
    return u"<qt>%1</qt>"_s.arg(lines.join(u"<br>"_s));
}

} // namespace trex
