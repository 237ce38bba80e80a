// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/codec/parametertable.h"

#include "protocol/codec/linesettings.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace trex {
namespace {

QString channelsText(int mask)
{
    QStringList numbers;
    for (int channel = 1; channel <= kChannelCount; ++channel) {
        if ((mask >> (channel - 1) & 1) != 0) {
            numbers << QString::number(channel);
        }
    }
    if (numbers.isEmpty()) {
        return QCoreApplication::translate("Parameters", "no channel");
    }
    return (numbers.size() == 1 ? QCoreApplication::translate("Parameters", "channel %1")
                                : QCoreApplication::translate("Parameters", "channels %1"))
        .arg(numbers.join(QStringLiteral(", ")));
}

QString choiceText(const ParameterRow& row, int raw)
{
    for (const auto& choice : row.choices) {
        if (choice.raw == raw) {
            return QCoreApplication::translate("Parameters", choice.title);
        }
    }
    return QString::number(raw);
}

QString detectionText(ErrorDetection detection)
{
    switch (detection) {
    case ErrorDetection::None:
        break;
    case ErrorDetection::Even:
        return QCoreApplication::translate("Parameters", "even parity");
    case ErrorDetection::Odd:
        return QCoreApplication::translate("Parameters", "odd parity");
    case ErrorDetection::Crc7:
        return QCoreApplication::translate("Parameters", "CRC-7");
    }
    return QCoreApplication::translate("Parameters", "no error detection");
}

QString uartText(int raw)
{
    const auto settings = UartSettings::fromRaw(raw);
    if (!settings) {
        return QCoreApplication::translate("Parameters", "%1: no such baud rate").arg(raw);
    }
    const int baud = kBaudRates[static_cast<std::size_t>(settings->baudIndex)];
    return (settings->stopBits == 1
                ? QCoreApplication::translate("Parameters", "%1 baud, %2, 1 stop bit")
                : QCoreApplication::translate("Parameters", "%1 baud, %2, 2 stop bits"))
        .arg(QString::number(baud), detectionText(settings->errorDetection));
}

QString numberText(const ParameterRow& row, int raw)
{
    if (raw == 0 && row.zeroText != nullptr) {
        return QCoreApplication::translate("Parameters", row.zeroText);
    }
    const QString number = QString::number(physicalFromRaw(row, raw), 'f', row.decimals);
    return row.unit.empty() ? number
                            : QStringLiteral("%1 %2").arg(number, QString::fromLatin1(row.unit));
}

} // namespace

const ParameterRow* findParameter(int number)
{
    const auto* const row =
        std::ranges::find(kParameters, number, [](const auto& each) { return +each.number; });
    return row == kParameters.end() ? nullptr : row;
}

const ParameterRow* findParameter(QStringView key)
{
    for (const auto& row : kParameters) {
        if (key == QLatin1StringView(row.key.data(), static_cast<qsizetype>(row.key.size()))) {
            return &row;
        }
    }
    return nullptr;
}

bool accepts(const ParameterRow& row, int raw)
{
    return raw >= row.minimum && raw <= row.maximum
        && (row.editor != ParameterEditor::UartSettings || UartSettings::fromRaw(raw).has_value());
}

double physicalFromRaw(const ParameterRow& row, int raw)
{
    return raw * row.scale;
}

std::optional<int> rawFromPhysical(const ParameterRow& row, double physical)
{
    const double nearest = std::round(physical / row.scale);
    // Written so that not-a-number fails it too; compared before narrowing to int.
    if (!(nearest >= row.minimum && nearest <= row.maximum)) {
        return std::nullopt;
    }
    return static_cast<int>(nearest);
}

QString parameterText(const ParameterRow& row, int raw)
{
    switch (row.editor) {
    case ParameterEditor::ChannelBits:
        return channelsText(raw);
    case ParameterEditor::Toggle:
        return raw == 0 ? QCoreApplication::translate("Parameters", "off")
                        : QCoreApplication::translate("Parameters", "on");
    case ParameterEditor::Choice:
    case ParameterEditor::Prescaler:
        return choiceText(row, raw);
    case ParameterEditor::Polynomial: // the top bit is always 1 and not stored (facts.md 2, 0x7D)
        return QStringLiteral("0x%1").arg(QString::number(raw | 0x80, 16).toUpper());
    case ParameterEditor::UartSettings:
        return uartText(raw);
    case ParameterEditor::Number:
    case ParameterEditor::Trigger:
        break;
    }
    return numberText(row, raw);
}

double pwmHertz(int prescaler, int pwmMaximum)
{
    // facts.md 2.1, model A: 8-bit timers of a 20 MHz clock; 0 and 1 observed, 2 and 3 inferred.
    constexpr double kClockHertz = 20e6;
    constexpr std::array<int, 4> kDividers{8, 64, 256, 1024};
    if (prescaler < 0 || prescaler >= static_cast<int>(kDividers.size()) || pwmMaximum < 0) {
        return 0.0;
    }
    return kClockHertz / kDividers[static_cast<std::size_t>(prescaler)] / (pwmMaximum + 1.0);
}

} // namespace trex
