// SPDX-License-Identifier: GPL-3.0-or-later
// How parameters read: the words of the model.
#include "widgets/parameters/parametermodel.h"

#include <QCoreApplication>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct ParameterText {
    Q_DECLARE_TR_FUNCTIONS(ParameterText)
};

QString hexText(std::uint8_t number)
{
    return u"0x%1"_s.arg(QString::number(number, 16).toUpper(), 2, u'0');
}

} // namespace

QString valueWithRaw(const ParameterRow& row, int raw)
{
    const QString number = QString::number(raw);
    if (!accepts(row, raw)) { // shown as the controller gave it (conformance C-59)
        return ParameterText::tr("%1 (unexpected)").arg(number);
    }
    const QString text = parameterText(row, raw);
    // A choice's text may begin with its number ("1: 2.4 kHz"): not twice.
    return text == number || text.startsWith(number + u':') ? text : u"%1 (%2)"_s.arg(text, number);
}

QString rangeText(const ParameterRow& row)
{
    const auto number = [&row](int raw) {
        return QString::number(physicalFromRaw(row, raw), 'f', row.decimals);
    };
    switch (row.editor) {
    case ParameterEditor::ChannelBits:
        return ParameterText::tr("channels 1 to 5");
    case ParameterEditor::Toggle:
        return ParameterText::tr("off, on");
    case ParameterEditor::Choice:
    case ParameterEditor::Prescaler:
        return ParameterText::tr("%1 to %2").arg(row.minimum).arg(row.maximum);
    case ParameterEditor::Polynomial:
        return ParameterText::tr("0x80 to 0xFF");
    case ParameterEditor::UartSettings:
        return ParameterText::tr("1200 to 115200 baud");
    case ParameterEditor::Number:
    case ParameterEditor::Trigger:
        break;
    }
    const QString range =
        ParameterText::tr("%1 to %2").arg(number(row.minimum), number(row.maximum));
    return row.unit.empty() ? range : range + u' ' + QString::fromLatin1(row.unit);
}

QString defaultText(const ParameterRow& row)
{
    const QString text = valueWithRaw(row, row.defaultRaw);
    return isGuess(row.defaultGrade) ? u"≈ "_s + text : text;
}

QString gradeText(Grade grade)
{
    switch (grade) {
    case Grade::Documented:
        return ParameterText::tr("documented");
    case Grade::Observed:
        return ParameterText::tr("observed on controllers");
    case Grade::InferredStrong:
        return ParameterText::tr("inferred, quite sure");
    case Grade::Inferred:
        return ParameterText::tr("inferred, unsure");
    case Grade::InferredWeak:
        return ParameterText::tr("a guess");
    }
    return {};
}

QString ParameterModel::stateText(std::uint8_t number) const
{
    switch (state(number)) {
    case State::AtDefault:
        return {};
    case State::Unread:
        return tr("not read");
    case State::Differs:
        return tr("not default");
    case State::Advised:
        return tr("note");
    case State::Pending:
        return tr("power cycle");
    case State::Edited:
        return tr("edited");
    case State::Refused:
        return tr("refused");
    }
    return {};
}

QString ParameterModel::text(const ParameterRow& row, int column) const
{
    switch (column) {
    case TitleColumn:
        return QCoreApplication::translate("Parameters", row.title);
    case DeviceColumn:
        return device(row.number) ? valueWithRaw(row, *device(row.number)) : u"–"_s;
    case DefaultColumn:
        return defaultText(row);
    case RangeColumn:
        return rangeText(row);
    case StateColumn:
        return stateText(row.number);
    default: // the editor stands there
        return {};
    }
}

QString ParameterModel::toolTip(const ParameterRow& row) const
{
    QStringList lines{
        u"<b>%1</b> · %2 · %3"_s.arg(text(row, TitleColumn), keyText(row), hexText(row.number))};
    lines += remarks(row.number);
    lines << QCoreApplication::translate("Parameters", row.help);
    if (isGuess(row.defaultGrade)) {
        lines
            << tr("≈ The vendor does not state the default: %1.").arg(gradeText(row.defaultGrade));
    }
    if (isGuess(row.meaningGrade)) {
        lines << tr("(unsure) The meaning is not stated by the vendor: %1.")
                     .arg(gradeText(row.meaningGrade));
    }
    lines << tr("Source: %1").arg(QString::fromLatin1(row.source));
    return u"<qt>%1</qt>"_s.arg(lines.join(u"<br>"_s));
}

} // namespace trex
