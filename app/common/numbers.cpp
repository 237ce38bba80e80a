// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/numbers.h"

#include "protocol/errortext.h"

#include <QCoreApplication>

#include <cmath>

namespace trex {

std::optional<qint64> numberFromText(QStringView text)
{
    const bool isNegative = text.startsWith(u'-');
    const QStringView digits = isNegative ? text.sliced(1) : text;
    const bool isHex = digits.startsWith(u"0x", Qt::CaseInsensitive);
    const QStringView plain = isHex ? digits.sliced(2) : digits;
    // toLongLong() alone would also take blanks, signs and (with base 0) octal.
    const auto isDigit = [isHex](QChar c) {
        const char16_t u = c.unicode();
        return (u >= u'0' && u <= u'9')
            || (isHex && ((u >= u'a' && u <= u'f') || (u >= u'A' && u <= u'F')));
    };
    if (plain.isEmpty() || !std::ranges::all_of(plain, isDigit)) {
        return std::nullopt;
    }
    bool ok = false;
    const qint64 magnitude = plain.toLongLong(&ok, isHex ? 16 : 10);
    return ok ? std::optional(isNegative ? -magnitude : magnitude) : std::nullopt;
}

Result<int> numberInRange(std::string_view what, const QString& text, int minimum, int maximum)
{
    const auto number = numberFromText(text);
    if (!number) {
        return fail(
            ErrorCode::OutOfRange,
            QCoreApplication::translate("Options", "%1 '%2' is not a whole number (%3…%4)")
                .arg(QString::fromUtf8(what.data(), static_cast<qsizetype>(what.size())), text)
                .arg(minimum)
                .arg(maximum));
    }
    if (*number < minimum || *number > maximum) {
        return outOfRange(what, *number, minimum, maximum);
    }
    return static_cast<int>(*number);
}

Result<double> positiveNumber(std::string_view what, const QString& text, double maximum)
{
    bool ok = false;
    const double number = text.toDouble(&ok);
    if (ok && std::isfinite(number) && number > 0.0 && number <= maximum) {
        return number;
    }
    return fail(ErrorCode::OutOfRange,
                QCoreApplication::translate("Options", "%1 '%2' (a number above 0, at most %3)")
                    .arg(QString::fromUtf8(what.data(), static_cast<qsizetype>(what.size())), text,
                         QString::number(maximum, 'g', 10)));
}

} // namespace trex
