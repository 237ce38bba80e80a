// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/lineoptions.h"

#include "app/common/numbers.h"
#include "protocol/errortext.h"
#include "protocol/storage/linesettingsstore.h"
#include "protocol/transport/transportregistry.h"

#include <QCoreApplication>
#include <QStringList>

#include <CLI/CLI.hpp>

using namespace Qt::Literals::StringLiterals;

namespace trex {
namespace {

constexpr int kLongestTimeoutMs = 60'000;

struct OptionRow {
    const char* name;
    const char* placeholder;
    const char* help;
    std::optional<QString> LineOptionValues::*value;
};

// clang-format off
constexpr auto kOptions = std::to_array<OptionRow>({
    {"--port", "PORT", QT_TRANSLATE_NOOP("Options", "serial device, tcp://HOST:PORT, or sim: (built-in simulator); default: the last one used"), &LineOptionValues::port},
    {"--baud", "N", QT_TRANSLATE_NOOP("Options", "1200 to 115200, as set in the controller; default 19200"), &LineOptionValues::baud},
    {"--protocol", "FORM", QT_TRANSLATE_NOOP("Options", "packet form: compact (default) or pololu"), &LineOptionValues::protocol},
    {"--device", "N", QT_TRANSLATE_NOOP("Options", "device number 0 to 127; implies --protocol pololu; default 7"), &LineOptionValues::device},
    {"--error-detection", "KIND", QT_TRANSLATE_NOOP("Options", "none (default), even, odd or crc7, as set in the controller"), &LineOptionValues::errorDetection},
    {"--crc-polynomial", "N", QT_TRANSLATE_NOOP("Options", "8-bit polynomial, top bit set; default 0x89"), &LineOptionValues::polynomial},
    {"--stop-bits", "N", QT_TRANSLATE_NOOP("Options", "1 (default) or 2"), &LineOptionValues::stopBits},
    {"--echo", "WHEN", QT_TRANSLATE_NOOP("Options", "RS-232 wiring echoes what is sent: auto (default), on or off"), &LineOptionValues::echo},
    {"--timeout", "MS", QT_TRANSLATE_NOOP("Options", "wait for a reply, above its time on the wire; default 100"), &LineOptionValues::timeout},
});
// clang-format on

tl::unexpected<Error> notOneOf(const char* option, const QString& text, const QStringList& choices)
{
    return fail(ErrorCode::OutOfRange,
                QCoreApplication::translate("Options", "%1 '%2' (one of %3)")
                    .arg(QLatin1StringView(option), text, choices.join(QStringLiteral(", "))));
}

Result<void> readBaud(const QString& text, LineSettings& line)
{
    const auto number = numberFromText(text);
    if (number && *number <= kBaudRates.back() && baudIndex(static_cast<int>(*number)) >= 0) {
        line.baud = static_cast<int>(*number);
        return {};
    }
    QStringList rates;
    for (const int rate : kBaudRates) {
        rates << QString::number(rate);
    }
    return notOneOf("--baud", text, rates);
}

Result<void> readForm(const LineOptionValues& values, LineSettings& line)
{
    if (values.protocol) {
        const auto form = packetFormFromKey(*values.protocol);
        if (!form) {
            return notOneOf("--protocol", *values.protocol, {u"compact"_s, u"pololu"_s});
        }
        line.form = *form;
    }
    if (!values.device) {
        return {};
    }
    if (values.protocol && line.form == PacketForm::Compact) {
        return fail(ErrorCode::OutOfRange,
                    QCoreApplication::translate(
                        "Options", "--device with --protocol compact, which carries no number"));
    }
    line.form = PacketForm::Pololu;
    return numberInRange("--device", *values.device, 0, 127).map([&](int device) {
        line.device = static_cast<std::uint8_t>(device);
    });
}

Result<void> readDetection(const LineOptionValues& values, LineSettings& line)
{
    if (values.errorDetection) {
        const auto detection = errorDetectionFromKey(*values.errorDetection);
        if (!detection) {
            return notOneOf("--error-detection", *values.errorDetection,
                            {u"none"_s, u"even"_s, u"odd"_s, u"crc7"_s});
        }
        line.errorDetection = *detection;
    }
    if (!values.polynomial) {
        return {};
    }
    return numberInRange("--crc-polynomial", *values.polynomial, 0x80, 0xFF)
        .map([&](int polynomial) { line.polynomial = static_cast<std::uint8_t>(polynomial); });
}

Result<void> readEcho(const QString& text, LineSettings& line)
{
    constexpr std::array<std::pair<QStringView, EchoMode>, 3> kModes{
        {{u"auto", EchoMode::Auto}, {u"on", EchoMode::On}, {u"off", EchoMode::Off}}};
    for (const auto& [key, mode] : kModes) {
        if (key == text) {
            line.echo = mode;
            return {};
        }
    }
    return notOneOf("--echo", text, {u"auto"_s, u"on"_s, u"off"_s});
}

Result<void> readTimes(const LineOptionValues& values, LineSettings& line)
{
    if (values.stopBits) {
        const auto bits = numberInRange("--stop-bits", *values.stopBits, 1, 2);
        if (!bits) {
            return tl::make_unexpected(bits.error());
        }
        line.stopBits = *bits;
    }
    if (values.timeout) {
        const auto timeout = numberInRange("--timeout", *values.timeout, 1, kLongestTimeoutMs);
        if (!timeout) {
            return tl::make_unexpected(timeout.error());
        }
        line.timeout = std::chrono::milliseconds(*timeout);
    }
    return {};
}

} // namespace

bool LineOptionValues::any() const
{
    return std::ranges::any_of(
        kOptions, [this](const OptionRow& row) { return (this->*row.value).has_value(); });
}

void addLineOptions(CLI::App& app, LineOptionValues& values)
{
    const std::string group = QCoreApplication::translate("Options", "Line options").toStdString();
    for (const auto& row : kOptions) {
        app.add_option_function<std::string>(
               row.name,
               [&values, &row](const std::string& text) {
                   values.*row.value = QString::fromStdString(text);
               },
               QCoreApplication::translate("Options", row.help).toStdString())
            ->type_name(row.placeholder)
            ->group(group);
    }
}

Result<LineSettings> toLineSettings(const LineOptionValues& values)
{
    LineSettings line;
    Result<void> done;
    if (values.baud) {
        done = readBaud(*values.baud, line);
    }
    done =
        done.and_then([&] { return readForm(values, line); })
            .and_then([&] { return readDetection(values, line); })
            .and_then([&] { return readTimes(values, line); })
            .and_then([&] { return values.echo ? readEcho(*values.echo, line) : Result<void>(); })
            .and_then([&] { return validate(line); });
    return done.map([&] { return line; });
}

Result<OpenOptions> toOpenOptions(const LineOptionValues& values, SettingsFile& settings)
{
    OpenOptions options;
    const auto line = toLineSettings(values);
    if (!line) {
        return tl::make_unexpected(line.error());
    }
    options.line = *line;
    if (values.port) {
        options.port = *values.port;
    } else if (settings.problem()) {
        return tl::make_unexpected(*settings.problem());
    } else {
        options.port = LineSettingsStore(settings).lastPort();
    }
    return checkAddress(options.port).map([&] { return options; });
}

} // namespace trex
