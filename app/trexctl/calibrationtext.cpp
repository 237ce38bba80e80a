// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/calibrationtext.h"

#include "app/trexctl/controllertext.h"
#include "app/trexctl/failure.h"
#include "protocol/storage/configfile.h"

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

QString valueText(InputKind input, int raw)
{
    return input == InputKind::Rc
        ? u"%1 (%2 ms)"_s.arg(raw).arg(millisecondsFromRaw(raw), 0, 'f', 3)
        : u"%1 (%2 V)"_s.arg(raw).arg(voltsFromRaw(raw), 0, 'f', 2);
}

} // namespace

QJsonObject toJson(const CalibrationEntry& entry)
{
    return {{u"channel"_s, entry.channel},
            {u"input"_s, QString(keyOf(entry.input))},
            {u"minimum"_s, entry.calibration.minimum},
            {u"neutral"_s, entry.calibration.neutral},
            {u"maximum"_s, entry.calibration.maximum},
            {u"deadband"_s, entry.calibration.deadband},
            {u"learned"_s, entry.isLearned}};
}

QJsonArray toJson(const std::vector<CalibrationEntry>& entries)
{
    QJsonArray array;
    for (const auto& entry : entries) {
        array.append(toJson(entry));
    }
    return array;
}

QString toText(const std::vector<CalibrationEntry>& entries, bool isWritten)
{
    std::vector<QString> header{Cli::tr("Channel"), Cli::tr("Input"),   Cli::tr("Minimum"),
                                Cli::tr("Neutral"), Cli::tr("Maximum"), Cli::tr("Deadband")};
    if (isWritten) {
        header.push_back(Cli::tr("Learned"));
    }
    TextTable table(header);
    for (const auto& entry : entries) {
        const auto& [minimum, neutral, maximum, deadband] = entry.calibration;
        std::vector<QString> row{QString::number(entry.channel),  QString(keyOf(entry.input)),
                                 valueText(entry.input, minimum), valueText(entry.input, neutral),
                                 valueText(entry.input, maximum), valueText(entry.input, deadband)};
        if (isWritten) {
            row.push_back(yesNo(entry.isLearned));
        }
        table.add(row);
    }
    return table.text();
}

} // namespace trex
