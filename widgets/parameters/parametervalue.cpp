// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/parametervalue.h"

#include <QCoreApplication>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct ParameterText {
    Q_DECLARE_TR_FUNCTIONS(ParameterText)
};

/// "19.5 kHz", "≈ 610 Hz". Prescalers 2 and 3 are inferred (facts.md 2.1).
QString frequencyText(int prescaler, int pwmMaximum)
{
    constexpr double kKilo = 1000.0;
    const double hertz = pwmHertz(prescaler, pwmMaximum);
    const QString text = hertz < kKilo ? u"%1 Hz"_s.arg(QString::number(hertz, 'f', 0))
                                       : u"%1 kHz"_s.arg(QString::number(hertz / kKilo, 'f', 2));
    return prescaler >= 2 ? u"≈ "_s + text : text;
}

QString signOf(Grade grade)
{
    return isGuess(grade) ? u"≈ "_s : grade == Grade::Observed ? u"○ "_s : u"✓ "_s;
}

QString quantityText(const ParameterRow& row, int raw, const DisplayUnit& unit)
{
    if (raw == 0 && row.zeroText != nullptr) {
        return QCoreApplication::translate("Parameters", row.zeroText);
    }
    QString text = QString::number(raw * unit.scale, 'f', unit.decimals);
    if (!unit.unit.isEmpty()) {
        text += u' ' + unit.unit;
    }
    return unit.isGuess ? u"≈ "_s + text : text;
}

} // namespace

DisplayUnit displayUnit(const ParameterRow& row, Model model)
{
    if (&row == &parameterRow("serial-timeout")) { // up to 12.7 s: seconds read better
        return {u"s"_s, row.scale / 1000.0, 1, false};
    }
    if (row.unit == "A") { // half of the 8-bit reading (facts.md 2, 0x13), in counts of the model
        return {u"A"_s, 2.0 * amperesPerCount(model), row.decimals, isGuess(amperesGrade(model))};
    }
    return {QString::fromLatin1(row.unit), row.scale, row.decimals, false};
}

const ParameterRow* pwmMaximumFor(const ParameterRow& row)
{
    if (&row == &parameterRow("motor1-pwm-prescaler")) {
        return &parameterRow("motor1-pwm-maximum");
    }
    return &row == &parameterRow("motor2-pwm-prescaler") ? &parameterRow("motor2-pwm-maximum")
                                                         : nullptr;
}

QString valueText(const ParameterRow& row, int raw, const ValueContext& context)
{
    if (row.editor == ParameterEditor::Prescaler && context.pwmMaximum
        && pwmHertz(raw, *context.pwmMaximum) > 0.0) {
        return u"%1: %2"_s.arg(QString::number(raw), frequencyText(raw, *context.pwmMaximum));
    }
    return row.editor == ParameterEditor::Number
        ? quantityText(row, raw, displayUnit(row, context.model))
        : parameterText(row, raw);
}

QString valueWithRaw(const ParameterRow& row, int raw, const ValueContext& context)
{
    const QString number = QString::number(raw);
    if (!accepts(row, raw)) { // shown as the controller gave it (conformance C-59)
        return ParameterText::tr("%1 (unexpected)").arg(number);
    }
    const QString text = valueText(row, raw, context);
    // A choice's text may begin with its number ("1: 2.4 kHz"): not twice.
    return text == number || text.startsWith(number + u':') ? text : u"%1 (%2)"_s.arg(text, number);
}

QString changeText(const ParameterRow& row, const std::optional<ValueInContext>& from,
                   const ValueInContext& to)
{
    const QString after = valueText(row, to.raw, to.context);
    QString before = !from        ? u"–"_s
        : accepts(row, from->raw) ? valueText(row, from->raw, from->context)
                                  : QString::number(from->raw);
    const QString unit = u' ' + displayUnit(row, to.context.model).unit;
    if (unit.size() > 1 && before.endsWith(unit) && after.endsWith(unit)) {
        before.chop(unit.size());
    }
    return u"%1 → %2"_s.arg(before, after);
}

QString rangeText(const ParameterRow& row, Model model)
{
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
    const auto unit = displayUnit(row, model);
    const auto number = [&unit](int raw) {
        return QString::number(raw * unit.scale, 'f', unit.decimals);
    };
    QString range = ParameterText::tr("%1 to %2").arg(number(row.minimum), number(row.maximum));
    if (!unit.unit.isEmpty()) {
        range += u' ' + unit.unit;
    }
    return unit.isGuess ? u"≈ "_s + range : range;
}

QString defaultText(const ParameterRow& row, const ValueContext& context)
{
    const QString text = valueWithRaw(row, row.defaultRaw, context);
    return isGuess(row.defaultGrade) && !text.startsWith(u'≈') ? u"≈ "_s + text : text;
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

Grade weakestGrade(const ParameterRow& row)
{
    return std::max(row.meaningGrade, row.defaultGrade);
}

QString gradeWithSign(Grade grade)
{
    return signOf(grade) + gradeText(grade);
}

QString gradeInShort(Grade grade)
{
    const auto words = [grade] {
        switch (grade) {
        case Grade::Documented:
            return ParameterText::tr("documented");
        case Grade::Observed:
            return ParameterText::tr("observed");
        case Grade::InferredStrong:
            return ParameterText::tr("quite sure");
        case Grade::Inferred:
            return ParameterText::tr("unsure");
        case Grade::InferredWeak:
            return ParameterText::tr("a guess");
        }
        return QString();
    };
    return signOf(grade) + words();
}

QString hexText(int number)
{
    return u"0x%1"_s.arg(QString::number(number, 16).toUpper(), 2, u'0');
}

} // namespace trex
