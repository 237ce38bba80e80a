// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/comparison.h"

#include "protocol/procedures/configtransfer.h"
#include "widgets/parameters/parametervalue.h"

#include <QCoreApplication>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr QChar kAbsent = u'–';

template <class Key, class Value>
std::optional<Value> valueIn(const std::map<Key, Value>& map, const Key& key)
{
    const auto found = map.find(key);
    return found == map.end() ? std::nullopt : std::optional(found->second);
}

std::optional<Calibration> calibrationIn(const Configuration& configuration, InputKind input,
                                         int channel)
{
    const auto set = valueIn(configuration.calibrations, input);
    return set ? valueIn(*set, channel) : std::nullopt;
}

QString parameterIn(const Configuration& configuration, SettingsOrigin origin,
                    const ParameterRow& row, Model model)
{
    ValueContext context{model, {}};
    if (const auto* const maximum = pwmMaximumFor(row)) {
        context.pwmMaximum = valueIn(configuration.parameters, maximum->number);
    }
    const auto raw = valueIn(configuration.parameters, row.number);
    if (raw && origin == SettingsOrigin::Factory) {
        return defaultText(row, context);
    }
    return raw ? valueWithRaw(row, *raw, context) : QString(kAbsent);
}

} // namespace

QString calibrationText(const Calibration& calibration)
{
    return u"%1 / %2 / %3 ± %4"_s.arg(calibration.minimum)
        .arg(calibration.neutral)
        .arg(calibration.maximum)
        .arg(calibration.deadband);
}

std::vector<ComparedSetting> compare(const Configuration& left, const Configuration& right,
                                     Model model, SettingsOrigin leftOrigin,
                                     SettingsOrigin rightOrigin)
{
    std::vector<ComparedSetting> settings;
    for (const auto& row : kParameters) {
        if (valueIn(left.parameters, row.number) == valueIn(right.parameters, row.number)) {
            continue;
        }
        settings.push_back({keyText(row), QCoreApplication::translate("Parameters", row.title),
                            parameterIn(left, leftOrigin, row, model),
                            parameterIn(right, rightOrigin, row, model)});
    }
    for (const auto input : {InputKind::Rc, InputKind::Analog}) {
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            const auto before = calibrationIn(left, input, channel);
            const auto after = calibrationIn(right, input, channel);
            if (before == after) {
                continue;
            }
            SettingWrite name; // has the key and title of a calibration
            name.input = input;
            name.channel = channel;
            settings.push_back({name.key(), name.title(),
                                before ? calibrationText(*before) : QString(kAbsent),
                                after ? calibrationText(*after) : QString(kAbsent)});
        }
    }
    return settings;
}

QString comparisonText(const std::vector<ComparedSetting>& settings, const QString& leftName,
                       const QString& rightName)
{
    QStringList lines{QStringList{QCoreApplication::translate("Comparison", "Key"),
                                  QCoreApplication::translate("Comparison", "Setting"), leftName,
                                  rightName}
                          .join(u'\t')};
    for (const auto& each : settings) {
        lines << QStringList{each.key, each.title, each.left, each.right}.join(u'\t');
    }
    return lines.join(u'\n') + u'\n';
}

Configuration factoryDefaults()
{
    Configuration defaults;
    for (const auto& row : kParameters) {
        if (!row.isTrigger) {
            defaults.parameters[row.number] = row.defaultRaw;
        }
    }
    return defaults;
}

} // namespace trex
