// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/rawspinbox.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kUnknown = -1; ///< stands for "not read" at the low end of the range
constexpr int kTopBit = 0x80;

} // namespace

RawSpinBox::RawSpinBox(const ParameterRow& row, QWidget* parent) : QSpinBox(parent), m_row(row)
{
    usePhysicalUnit();
    setSpecialValueText(u"–"_s);
    setAlignment(Qt::AlignRight);
    setRange(kUnknown, row.maximum);
    setValue(kUnknown);
    // Told before the value follows the text.
    connect(lineEdit(), &QLineEdit::textEdited, this, [this](const QString& text) {
        m_typed = text;
        m_before = m_before.value_or(value());
    });
    connect(this, &QSpinBox::editingFinished, this, &RawSpinBox::onEditingFinished);
}

void RawSpinBox::setModel(Model model)
{
    if (displayUnit(m_row, model).scale != m_unit.scale) {
        const QSignalBlocker blocker(this);
        m_unit = displayUnit(m_row, model);
        usePhysicalUnit();
    }
}

void RawSpinBox::usePhysicalUnit()
{
    if (m_unit.unit.isEmpty()) {
        m_unit = displayUnit(m_row, Model::TrexJr);
    }
    if (!m_unit.unit.isEmpty()) {
        setSuffix(u' ' + m_unit.unit);
    }
    setPrefix(m_unit.isGuess ? u"≈ "_s : QString());
    // As wide as its longest text, whatever it shows now.
    const QString zero = m_row.zeroText == nullptr ? QString() : parameterText(m_row, 0);
    const QString widest = prefix() + textFromValue(m_row.maximum) + suffix() + u"000"_s;
    setMinimumWidth(
        std::max(fontMetrics().horizontalAdvance(widest), fontMetrics().horizontalAdvance(zero))
        + 2 * sizeHint().height());
}

void RawSpinBox::showRaw(std::optional<int> raw)
{
    if (raw && *raw == value() && minimum() == m_row.minimum) {
        return; // perhaps being typed: its text is left alone
    }
    const QSignalBlocker blocker(this);
    // A value beyond the table's range is shown as the controller gave it (conformance C-59).
    const bool hasWord = raw && m_row.zeroText != nullptr;
    setSpecialValueText(!raw ? u"–"_s : hasWord ? parameterText(m_row, 0) : QString());
    setRange(raw ? m_row.minimum : kUnknown, std::max(m_row.maximum, raw.value_or(0)));
    setValue(raw.value_or(kUnknown));
}

QString RawSpinBox::textFromValue(int raw) const
{
    if (isPolynomial()) {
        return parameterText(m_row, raw);
    }
    return locale()
        .toString(raw * m_unit.scale, 'f', m_unit.decimals)
        .remove(locale().groupSeparator());
}

QString RawSpinBox::typedIn(const QString& text) const
{
    QString typed = text.trimmed();
    if (!suffix().isEmpty() && typed.endsWith(suffix())) {
        typed.chop(suffix().size());
    }
    if (!prefix().isEmpty() && typed.startsWith(prefix())) {
        typed = typed.mid(prefix().size());
    }
    return typed.trimmed();
}

std::optional<int> RawSpinBox::parsedPolynomial(const QString& text) const
{
    bool isNumber = false;
    const QString number = text.trimmed();
    const int polynomial = number.toInt(&isNumber, number.startsWith("0x"_L1) ? 16 : 10);
    return isNumber ? std::optional(polynomial) : std::nullopt;
}

std::optional<double> RawSpinBox::parsedPhysical(const QString& text) const
{
    QString number = typedIn(text);
    double factor = 1.0;
    const QString ownUnit = QString::fromLatin1(m_row.unit);
    for (const auto& [unit, scale] :
         {std::pair(ownUnit, m_row.scale), std::pair(m_unit.unit, m_unit.scale)}) {
        if (!unit.isEmpty() && number.endsWith(unit)) {
            number = number.chopped(unit.size()).trimmed();
            factor = unit == m_unit.unit ? 1.0 : m_unit.scale / scale;
            break;
        }
    }
    bool isNumber = false;
    double physical = locale().toDouble(number, &isNumber);
    if (!isNumber) { // a decimal point is understood in every language
        physical = QLocale::c().toDouble(number, &isNumber);
    }
    return isNumber ? std::optional(physical * factor) : std::nullopt;
}

std::optional<int> RawSpinBox::parsed(const QString& text) const
{
    if (isPolynomial()) {
        const auto polynomial = parsedPolynomial(text);
        return polynomial && *polynomial >= 0 && *polynomial <= 0xFF
            ? std::optional(*polynomial & ~kTopBit)
            : std::nullopt;
    }
    if (m_row.zeroText != nullptr && typedIn(text) == parameterText(m_row, 0)) {
        return 0;
    }
    const auto physical = parsedPhysical(text);
    const double nearest = physical ? std::round(*physical / m_unit.scale) : -1.0;
    return nearest >= m_row.minimum && nearest <= maximum()
        ? std::optional(static_cast<int>(nearest))
        : std::nullopt;
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
    // Words and units may be on their way; what they come to is judged when the editing ends.
    const auto mayStand = [](QChar c) {
        return c.isLetterOrNumber() || c.isSpace() || u".,-–≈()"_s.contains(c);
    };
    return std::ranges::all_of(text, mayStand) ? QValidator::Intermediate : QValidator::Invalid;
}

void RawSpinBox::fixup(QString& text) const
{
    const QString typed = typedIn(text);
    if (text == specialValueText() || parsed(text)) {
        return;
    }
    const int before = m_before.value_or(value());
    const bool wasWord = before == minimum() && !specialValueText().isEmpty();
    text = wasWord ? specialValueText() : prefix() + textFromValue(before) + suffix();
    if (typed.isEmpty()) {
        return;
    }
    const QString title = QCoreApplication::translate("Parameters", m_row.title);
    const bool isNumber =
        isPolynomial() ? parsedPolynomial(typed).has_value() : parsedPhysical(typed).has_value();
    emit remarked(
        (isNumber ? tr("%1: %2 is outside of what can be stored, %3; the value stays as it was.")
                  : tr("%1: \"%2\" is no number that can be stored, %3; the value stays as it "
                       "was."))
            .arg(title, typed, rangeText(m_row)));
}

void RawSpinBox::onEditingFinished()
{
    m_before.reset();
    const auto polynomial =
        isPolynomial() ? parsedPolynomial(std::exchange(m_typed, {})) : std::optional<int>();
    if (polynomial && *polynomial >= 0 && *polynomial < kTopBit) {
        emit remarked(tr("%1 has its top bit clear. The top bit of the polynomial is always 1 and "
                         "is not stored, so %1 is taken as what is stored: the polynomial in full "
                         "is %2.")
                          .arg(hexText(*polynomial), hexText(*polynomial | kTopBit)));
    }
}

} // namespace trex
