// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/rawspinbox.h"

#include <QSignalBlocker>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kUnknown = -1; ///< stands for "not read" at the low end of the range

} // namespace

RawSpinBox::RawSpinBox(const ParameterRow& row, QWidget* parent) : QSpinBox(parent), m_row(row)
{
    if (!row.unit.empty()) {
        setSuffix(u' ' + QString::fromLatin1(row.unit));
    }
    setSpecialValueText(u"–"_s);
    setAlignment(Qt::AlignRight);
    setCorrectionMode(QAbstractSpinBox::CorrectToNearestValue);
    setRange(kUnknown, row.maximum);
    setValue(kUnknown);
    // As wide as its longest value, whatever it shows now.
    const QString widest = textFromValue(row.maximum) + suffix() + u"000"_s;
    setMinimumWidth(fontMetrics().horizontalAdvance(widest) + 2 * sizeHint().height());
}

void RawSpinBox::showRaw(std::optional<int> raw)
{
    if (raw && *raw == value() && minimum() == m_row.minimum) {
        return; // perhaps being typed: its text is left alone
    }
    const QSignalBlocker blocker(this);
    // A value beyond the table's range is shown as the controller gave it (conformance C-59).
    setSpecialValueText(raw ? QString() : u"–"_s);
    setRange(raw ? m_row.minimum : kUnknown, std::max(m_row.maximum, raw.value_or(0)));
    setValue(raw.value_or(kUnknown));
}

QString RawSpinBox::textFromValue(int raw) const
{
    if (m_row.editor == ParameterEditor::Polynomial) {
        return parameterText(m_row, raw);
    }
    return locale()
        .toString(physicalFromRaw(m_row, raw), 'f', m_row.decimals)
        .remove(locale().groupSeparator());
}

std::optional<int> RawSpinBox::parsed(const QString& text) const
{
    QString number = text;
    if (!suffix().isEmpty() && number.endsWith(suffix().trimmed())) {
        number.chop(suffix().trimmed().size());
    }
    number = number.trimmed();
    bool isNumber = false;
    if (m_row.editor == ParameterEditor::Polynomial) {
        const int polynomial = number.toInt(&isNumber, number.startsWith("0x"_L1) ? 16 : 10);
        return isNumber && polynomial >= 0 && polynomial <= 0xFF ? std::optional(polynomial & 0x7F)
                                                                 : std::nullopt;
    }
    double physical = locale().toDouble(number, &isNumber);
    if (!isNumber) { // a decimal point is understood in every language
        physical = QLocale::c().toDouble(number, &isNumber);
    }
    return isNumber ? rawFromPhysical(m_row, physical) : std::nullopt;
}

int RawSpinBox::valueFromText(const QString& text) const
{
    return parsed(text).value_or(value());
}

QValidator::State RawSpinBox::validate(QString& text, int& /*position*/) const
{
    if (parsed(text) || (!text.isEmpty() && text == specialValueText())) {
        return QValidator::Acceptable;
    }
    const auto mayStand = [](QChar c) {
        return c.isDigit() || c.isSpace() || u"xXabcdefABCDEF.,-–"_s.contains(c);
    };
    QString number = text;
    number.remove(suffix().trimmed());
    return std::ranges::all_of(number, mayStand) ? QValidator::Intermediate : QValidator::Invalid;
}

} // namespace trex
