// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/configadapt.h"

#include <QCoreApplication>

#include <cmath>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr std::array kCurrentLimits{&parameterRow("motor1-current-limit"),
                                    &parameterRow("motor2-current-limit")};
constexpr std::array kGains{&parameterRow("motor1-current-limit-p"),
                            &parameterRow("motor2-current-limit-p")};

struct Adapt {
    Q_DECLARE_TR_FUNCTIONS(ConfigFile)
};

QString titleOf(const ParameterRow& row)
{
    return QCoreApplication::translate("Parameters", row.title);
}

QString amperes(const ParameterRow& row, int raw, Model model)
{
    const QString text = QString::number(physicalFromRaw(row, raw, model), 'f', 2) + u" A"_s;
    return isGuess(amperesGrade(model)) ? Adapt::tr("about %1 (inferred)").arg(text) : text;
}

/// The same current in the other model's steps; 0 stays 0, which is probably no limit.
void adaptCurrentLimit(AdaptedConfiguration& adapted, const ParameterRow& row, Model from, Model to)
{
    const auto found = adapted.configuration.parameters.find(row.number);
    if (found == adapted.configuration.parameters.end() || found->second == 0) {
        return;
    }
    const int before = found->second;
    const double wanted = physicalFromRaw(row, before, from) / physicalFromRaw(row, 1, to);
    const int after = std::clamp(static_cast<int>(std::lround(wanted)), 1, row.maximum);
    found->second = after;
    adapted.notes << (wanted > row.maximum + 0.5
                          ? Adapt::tr("%1: %2 is more than this controller can be set to; taken is "
                                      "its most, %3 (raw %4).")
                          : Adapt::tr("%1: adapted from %2 to %3 (raw %4), since the two models "
                                      "count currents in different steps."))
                         .arg(titleOf(row), amperes(row, before, from), amperes(row, after, to),
                              QString::number(after));
}

void adaptModel(AdaptedConfiguration& adapted, const Signature& from, const Signature& to)
{
    adapted.notes << Adapt::tr("The file is of a %1, the controller is a %2.")
                         .arg(from.modelName(), to.modelName());
    for (const auto* row : kCurrentLimits) {
        adaptCurrentLimit(adapted, *row, from.model, to.model);
    }
    for (const auto* row : kGains) {
        if (adapted.configuration.parameters.contains(row->number)) {
            adapted.notes << Adapt::tr("%1: taken as it is, though it acts on current in the other "
                                       "model's steps; try it with care.")
                                 .arg(titleOf(*row));
        }
    }
}

} // namespace

AdaptedConfiguration adaptedTo(const Signature& controller, const Configuration& file)
{
    AdaptedConfiguration adapted{file, {}};
    const auto from = parseSignature(file.signature.toUtf8());
    if (from && from->model != controller.model) {
        adaptModel(adapted, *from, controller);
    }
    // facts.md 2, 0x17: firmware 1.2 and later.
    const auto& delay = parameterRow("uart-response-delay");
    const bool isOld = controller.major == 1 && controller.minor < 2;
    if (isOld && adapted.configuration.parameters.erase(delay.number) > 0) {
        adapted.notes << Adapt::tr("%1: left out, since firmware %2 does not have it.")
                             .arg(titleOf(delay), controller.firmware());
    }
    return adapted;
}

Model modelOf(const QString& signature)
{
    const auto parsed = parseSignature(signature.toUtf8());
    return parsed ? parsed->model : Model::TrexJr;
}

double physicalFromRaw(const ParameterRow& row, int raw, Model model)
{
    const bool isLimit = std::ranges::find(kCurrentLimits, &row) != kCurrentLimits.end();
    return isLimit ? raw * 2 * amperesPerCount(model) : physicalFromRaw(row, raw);
}

Configuration defaultConfiguration()
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
