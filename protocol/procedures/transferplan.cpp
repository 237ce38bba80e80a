// SPDX-License-Identifier: GPL-3.0-or-later
// The pure half of configtransfer.h: what to write, in which order, and how it reads.
#include "protocol/errortext.h"
#include "protocol/procedures/configtransfer.h"

#include <QCoreApplication>

#include <algorithm>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

struct Transfer {
    Q_DECLARE_TR_FUNCTIONS(Transfer)
};

/// The order of writing: ordinary parameters, calibrations, then what the line depends on.
int rankOf(const SettingWrite& write)
{
    if (write.row == nullptr) {
        return 1;
    }
    if (write.row == &parameterRow("crc7-polynomial")) {
        return 2;
    }
    if (write.row == &parameterRow("uart-settings")) {
        return 3;
    }
    return write.row == &parameterRow("device-number") ? 4 : 0;
}

QString inputText(InputKind input)
{
    return input == InputKind::Rc ? Transfer::tr("RC") : Transfer::tr("analog");
}

/// "200 → 500 ms": the unit once, when both sides carry it.
QString changeText(const ParameterRow& row, const std::optional<int>& from, int to)
{
    const QString unit = row.unit.empty() ? QString() : u' ' + QString::fromLatin1(row.unit);
    QString before = !from    ? u"–"_s
        : accepts(row, *from) ? parameterText(row, *from)
                              : QString::number(*from);
    const QString after = parameterText(row, to);
    if (!unit.isEmpty() && before.endsWith(unit) && after.endsWith(unit)) {
        before.chop(unit.size());
    }
    return u"%1 → %2"_s.arg(before, after);
}

QString titlesOf(const std::vector<SettingWrite>& writes)
{
    QStringList titles;
    for (const auto& write : writes) {
        titles << write.title();
    }
    return titles.join(u", "_s);
}

QString writtenText(const std::vector<SettingWrite>& written)
{
    constexpr std::size_t kMostNamed = 4;
    if (written.empty()) {
        return Transfer::tr("Nothing had to be written.");
    }
    return written.size() > kMostNamed
        ? Transfer::tr("%1 settings are written and read back.").arg(written.size())
        : Transfer::tr("Written and read back: %1.").arg(titlesOf(written));
}

void planParameters(TransferPlan& plan, const Configuration& present, const Configuration& wanted)
{
    for (const auto& [number, raw] : wanted.parameters) {
        const auto* const row = findParameter(number);
        const auto found = present.parameters.find(number);
        if (row == nullptr || row->isTrigger
            || (found != present.parameters.end() && found->second == raw)) {
            continue;
        }
        SettingWrite write;
        write.row = row;
        write.rawTo = raw;
        if (found != present.parameters.end()) {
            write.rawFrom = found->second;
        }
        plan.writes.push_back(write);
    }
}

void planCalibrations(TransferPlan& plan, const Configuration& present, const Configuration& wanted,
                      std::optional<InputKind> inForce)
{
    for (const auto& [input, channels] : wanted.calibrations) {
        if (!channels.empty() && input != inForce) {
            plan.leftOut << (inForce
                                 ? Transfer::tr("The %1 calibration is left out: the controller "
                                                "uses the %2 one now and takes no other.")
                                       .arg(inputText(input), inputText(*inForce))
                                 : Transfer::tr("The %1 calibration is left out: it is not known "
                                                "which one the controller uses now.")
                                       .arg(inputText(input)));
            continue;
        }
        const auto set = present.calibrations.find(input);
        for (const auto& [channel, calibration] : channels) {
            SettingWrite write;
            write.input = input;
            write.channel = channel;
            write.calibrationTo = calibration;
            if (set != present.calibrations.end() && set->second.contains(channel)) {
                write.calibrationFrom = set->second.at(channel);
            }
            if (write.calibrationFrom != calibration) {
                plan.writes.push_back(write);
            }
        }
    }
}

} // namespace

QString SettingWrite::key() const
{
    return row != nullptr ? keyText(*row) : u"calibration.%1.%2"_s.arg(keyOf(input)).arg(channel);
}

QString SettingWrite::title() const
{
    return row != nullptr ? QCoreApplication::translate("Parameters", row->title)
                          : Transfer::tr("Calibration of channel %1 (%2)")
                                .arg(QString::number(channel), inputText(input));
}

QString SettingWrite::text() const
{
    if (row != nullptr) {
        return u"%1: %2"_s.arg(title(), changeText(*row, rawFrom, rawTo));
    }
    const auto numbers = [](const Calibration& calibration) {
        return u"%1/%2/%3 ±%4"_s.arg(calibration.minimum)
            .arg(calibration.neutral)
            .arg(calibration.maximum)
            .arg(calibration.deadband);
    };
    return u"%1: %2 → %3"_s.arg(title(), calibrationFrom ? numbers(*calibrationFrom) : u"–"_s,
                                numbers(calibrationTo));
}

Command SettingWrite::command() const
{
    return row != nullptr ? writeParameter(row->number, static_cast<std::uint8_t>(rawTo))
                          : writeCalibration(channel, calibrationTo);
}

bool TransferPlan::needsReset() const
{
    return std::ranges::any_of(writes, &SettingWrite::needsReset);
}

std::vector<ConfigurationChange> TransferPlan::changes() const
{
    std::vector<ConfigurationChange> all;
    for (const auto& write : writes) {
        if (write.row != nullptr) {
            all.push_back({write.key(), write.rawFrom, write.rawTo});
            continue;
        }
        const auto fields = calibrationDifferences(write.input, write.channel,
                                                   write.calibrationFrom, write.calibrationTo);
        all.insert(all.end(), fields.begin(), fields.end());
    }
    return all;
}

std::vector<Command> TransferPlan::commands() const
{
    std::vector<Command> all;
    for (const auto& write : writes) {
        all.push_back(write.command());
    }
    return all;
}

TransferPlan planTransfer(const Configuration& present, const Configuration& wanted,
                          std::optional<InputKind> inForce)
{
    TransferPlan plan;
    planParameters(plan, present, wanted);
    planCalibrations(plan, present, wanted, inForce);
    std::ranges::stable_sort(plan.writes, {}, rankOf);
    return plan;
}

QString TransferOutcome::text() const
{
    QStringList sentences;
    const bool isPuttingBack = !restored.empty() || !notRestored.empty();
    if (error) {
        sentences << (failed ? u"%1: %2"_s.arg(failed->title(), errorText(*error))
                             : errorText(*error));
        if (failedMayHold) {
            sentences << Transfer::tr("Whether it is changed is not known.");
        }
        if (!written.empty()) {
            sentences << Transfer::tr("Written before that, and in the controller now: %1.")
                             .arg(titlesOf(written));
        } else if (!isPuttingBack && !failedMayHold) {
            sentences << Transfer::tr("Nothing is changed in the controller.");
        }
    } else if (!isPuttingBack) {
        sentences << writtenText(written);
    }
    if (!restored.empty()) {
        sentences << Transfer::tr("Put back as before: %1.").arg(titlesOf(restored));
    }
    if (!notRestored.empty()) {
        sentences << Transfer::tr("Could not be put back, read them again: %1.")
                         .arg(titlesOf(notRestored));
    }
    std::vector<SettingWrite> late;
    std::ranges::copy_if(written, std::back_inserter(late), &SettingWrite::needsReset);
    if (!late.empty()) {
        sentences << Transfer::tr("Switch the controller's power off and on for: %1.")
                         .arg(titlesOf(late));
    }
    return (sentences + notes).join(u' ');
}

std::vector<SettingWrite> TransferOutcome::toPutBack() const
{
    auto writes = written;
    if (failed && failedMayHold) {
        writes.push_back(*failed);
    }
    return writes;
}

Configuration presentConfiguration(const Controller& controller, const DeviceSettings& settings)
{
    Configuration present;
    present.saved = QDateTime::fromSecsSinceEpoch(QDateTime::currentSecsSinceEpoch(), Qt::UTC);
    const auto& device = controller.device();
    if (device.signature) {
        present.signature = device.signature->text();
        present.firmware = device.signature->firmware();
    }
    for (const auto& row : kParameters) {
        const auto raw = row.isTrigger ? std::nullopt : settings.parameter(row.number);
        if (raw) {
            present.parameters[row.number] = *raw;
        }
    }
    const auto number = settings.parameter(parameterRow("device-number").number);
    if (number) {
        present.deviceNumber = *number;
    }
    for (const auto input : {InputKind::Rc, InputKind::Analog}) {
        for (int channel = 1; channel <= kChannelCount; ++channel) {
            if (const auto calibration = settings.calibration(input, channel)) {
                present.calibrations[input][channel] = *calibration;
            }
        }
    }
    return present;
}

bool isComplete(const Configuration& configuration)
{
    // Firmware before 1.2 has no reply delay (facts.md 2, 0x17).
    const auto* const newest = &parameterRow("uart-response-delay");
    const bool hasParameters = std::ranges::all_of(kParameters, [&](const ParameterRow& row) {
        return row.isTrigger || &row == newest || configuration.parameters.contains(row.number);
    });
    return hasParameters && std::ranges::any_of(configuration.calibrations, [](const auto& set) {
               return std::ssize(set.second) == kChannelCount;
           });
}

} // namespace trex
