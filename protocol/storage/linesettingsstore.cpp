// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/linesettingsstore.h"

#include <QStringList>
#include <QUrl>

namespace trex {
namespace {

const Setting<QString>& lastPortSetting()
{
    static const Setting<QString> setting{QStringLiteral("line/lastPort"), QStringLiteral("sim:")};
    return setting;
}

/// A port's name has slashes, which QSettings takes for groups: percent-encoded it has none.
Setting<QString> portSetting(const QString& port)
{
    const auto encoded = QString::fromLatin1(QUrl::toPercentEncoding(port));
    return {QStringLiteral("linePorts/") + encoded, {}};
}

/// "3 9"
Setting<QString> numbersSetting(const QString& port)
{
    const auto encoded = QString::fromLatin1(QUrl::toPercentEncoding(port));
    return {QStringLiteral("lineNumbers/") + encoded, {}};
}

constexpr std::array<QLatin1StringView, 3> kEchoKeys{
    QLatin1StringView("auto"), QLatin1StringView("on"), QLatin1StringView("off")};

QString latin(std::string_view text)
{
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

/// "19200 none 137 1 compact 7 auto 100": all fields in the order of LineSettings.
QString toText(const LineSettings& settings)
{
    const QStringList parts{QString::number(settings.baud),
                            latin(keyOf(settings.errorDetection)),
                            QString::number(settings.polynomial),
                            QString::number(settings.stopBits),
                            latin(keyOf(settings.form)),
                            QString::number(settings.device),
                            kEchoKeys.at(static_cast<std::size_t>(settings.echo)),
                            QString::number(settings.timeout.count())};
    return parts.join(u' ');
}

std::optional<LineSettings> fromText(const QString& text)
{
    const QStringList parts = text.split(u' ');
    if (parts.size() != 8) {
        return std::nullopt;
    }
    const auto detection = errorDetectionFromKey(parts[1]);
    const auto form = packetFormFromKey(parts[4]);
    const auto* const echo = std::ranges::find(kEchoKeys, parts[6]);
    const int polynomial = parts[2].toInt();
    const int device = parts[5].toInt();
    if (!detection || !form || echo == kEchoKeys.end() || polynomial < 0 || polynomial > 255
        || device < 0 || device > 127) {
        return std::nullopt;
    }
    const LineSettings settings{.baud = parts[0].toInt(),
                                .errorDetection = *detection,
                                .polynomial = static_cast<std::uint8_t>(polynomial),
                                .stopBits = parts[3].toInt(),
                                .form = *form,
                                .device = static_cast<std::uint8_t>(device),
                                .echo = static_cast<EchoMode>(echo - kEchoKeys.begin()),
                                .timeout = std::chrono::milliseconds(parts[7].toInt())};
    return validate(settings) ? std::optional(settings) : std::nullopt;
}

} // namespace

QString LineSettingsStore::lastPort() const
{
    const QString port = m_file.value(lastPortSetting());
    return port.isEmpty() ? lastPortSetting().fallback : port;
}

std::optional<LineSettings> LineSettingsStore::lastGood(const QString& port) const
{
    return fromText(m_file.value(portSetting(port)));
}

void LineSettingsStore::remember(const QString& port, const LineSettings& settings)
{
    m_file.set(lastPortSetting(), port);
    m_file.set(portSetting(port), toText(settings));
    m_file.sync();
}

std::set<int> LineSettingsStore::numbersInUse(const QString& port) const
{
    std::set<int> numbers;
    for (const QString& part : m_file.value(numbersSetting(port)).split(u' ', Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const int number = part.toInt(&isNumber);
        if (isNumber && number >= 0 && number <= 127) {
            numbers.insert(number);
        }
    }
    return numbers;
}

void LineSettingsStore::rememberNumbers(const QString& port, const std::set<int>& numbers)
{
    QStringList parts;
    for (const int number : numbers) {
        parts << QString::number(number);
    }
    m_file.set(numbersSetting(port), parts.join(u' '));
    m_file.sync();
}

} // namespace trex
