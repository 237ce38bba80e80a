// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/parameterargument.h"

#include "app/common/numbers.h"
#include "app/trexctl/controllertext.h"
#include "protocol/codec/linesettings.h"
#include "protocol/errortext.h"

#include <cmath>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

/// A unit as typed, in units of a row.
struct UnitRow {
    std::string_view rowUnit;
    QLatin1StringView typed;
    double factor;
};
constexpr auto kUnits = std::to_array<UnitRow>({
    {"ms", QLatin1StringView("ms"), 1.0},
    {"ms", QLatin1StringView("s"), 1000.0},
    {"A", QLatin1StringView("mA"), 0.001},
    {"A", QLatin1StringView("A"), 1.0},
});

/// Number and unit of "2.4 A"; none when there is no unit.
std::optional<std::pair<QString, QString>> splitUnit(const QString& text)
{
    qsizetype end = text.size();
    while (end > 0 && text[end - 1].isLetter()) {
        --end;
    }
    if (end == text.size() || end == 0 || text.startsWith("0x"_L1, Qt::CaseInsensitive)) {
        return std::nullopt;
    }
    return std::pair(text.first(end).trimmed(), text.sliced(end));
}

tl::unexpected<Failure> notAValue(const ParameterRow& row, const QString& text)
{
    const QString range = row.unit.empty() ? u"%1…%2"_s.arg(row.minimum).arg(row.maximum)
                                           : u"%1…%2, %3…%4"_s.arg(row.minimum)
                                                 .arg(row.maximum)
                                                 .arg(physicalFromRaw(row, row.minimum))
                                                 .arg(physicalFromRaw(row, row.maximum))
            + u' ' + latin(row.unit);
    return usage(Cli::tr("'%1' is no value for %2 (%3). Nothing was sent; see: trexctl param list")
                     .arg(text, latin(row.key), range));
}

} // namespace

tl::expected<const ParameterRow*, Failure> parameterFromText(const QString& text)
{
    const auto number = numberFromText(text);
    const ParameterRow* const row = number && *number >= 0 && *number <= 127
        ? findParameter(static_cast<int>(*number))
        : findParameter(QStringView(text));
    if (row == nullptr) {
        return usage(
            Cli::tr("There is no parameter '%1'. Nothing was sent; trexctl param list shows "
                    "all.")
                .arg(text));
    }
    if (row->isTrigger) {
        return usage(Cli::tr("%1 is no value to read or write. Nothing was sent; its command is: "
                             "trexctl param reset --yes")
                         .arg(latin(row->key)));
    }
    return row;
}

tl::expected<TypedValue, Failure> valueFromText(const ParameterRow& row, const QString& text)
{
    if (const auto number = numberFromText(text)) {
        const bool isAccepted =
            *number >= 0 && *number <= 127 && accepts(row, static_cast<int>(*number));
        if (!isAccepted) {
            return notAValue(row, text);
        }
        return TypedValue{static_cast<int>(*number), false};
    }
    const auto parts = splitUnit(text);
    if (!parts) {
        return notAValue(row, text);
    }
    for (const auto& unit : kUnits) {
        bool isNumber = false;
        const double physical = parts->first.toDouble(&isNumber) * unit.factor;
        if (unit.rowUnit != row.unit || unit.typed != parts->second || !isNumber) {
            continue;
        }
        const auto raw = rawFromPhysical(row, physical);
        if (!raw || physical < 0.0) {
            break;
        }
        constexpr double kExact = 1e-6;
        return TypedValue{*raw, std::abs(physicalFromRaw(row, *raw) - physical) > kExact};
    }
    return notAValue(row, text);
}

} // namespace trex
