// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexpanel/paneloptions.h"

#include "app/common/logging.h"
#include "app/common/version.h"
#include "app/trexpanel/languages.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>

#include <iostream>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int kUsage = 2;

QString words(const char* text)
{
    return QCoreApplication::translate("Options", text);
}

void addText(CLI::App& app, const char* name, const char* placeholder, QString& target,
             const char* help)
{
    app.add_option_function<std::string>(
           name, [&target](const std::string& text) { target = QString::fromStdString(text); },
           words(help).toStdString())
        ->type_name(placeholder);
}

/// "200", "2", "1.5": percent, or a factor up to 4. 0: makes no sense.
double scaleOf(const QString& text)
{
    bool ok = false;
    const double number = text.toDouble(&ok);
    if (!ok) {
        return 0.0;
    }
    const double factor = number <= 4.0 ? number : number / 100.0;
    return factor >= 0.5 && factor <= 4.0 ? factor : 0.0;
}

/// What makes no sense, in a sentence; empty: nothing.
QString complaint(PanelOptions& options, const QString& scale)
{
    if (!scale.isEmpty()) {
        options.scale = scaleOf(scale);
        if (options.scale <= 0.0) {
            return words(QT_TRANSLATE_NOOP("Options", "--scale '%1' (50 to 400 percent)"))
                .arg(scale);
        }
    }
    const QStringList themes{u"light"_s, u"dark"_s, u"system"_s};
    if (!options.theme.isEmpty() && !themes.contains(options.theme)) {
        return words(QT_TRANSLATE_NOOP("Options", "--theme '%1' (one of %2)"))
            .arg(options.theme, themes.join(u", "_s));
    }
    if (!options.language.isEmpty() && !Languages::isAvailable(options.language)) {
        QStringList codes;
        for (const auto& [code, name] : Languages::available()) {
            codes << code;
        }
        return words(QT_TRANSLATE_NOOP("Options", "--language '%1' (one of %2)"))
            .arg(options.language, codes.join(u", "_s));
    }
    if (options.simulate && options.line.port) {
        return words(QT_TRANSLATE_NOOP("Options", "--simulate and --port: one or the other"));
    }
    if (!options.plays() && !(options.report.isEmpty() && options.screenshots.isEmpty())) {
        return words(QT_TRANSLATE_NOOP("Options", "--report and --screenshots need --script"));
    }
    return {};
}

} // namespace

std::optional<int> parsePanelOptions(int argc, char** argv, PanelOptions& options)
{
    CLI::App app(words(QT_TRANSLATE_NOOP("Options",
                                         "Control panel for the Pololu TReX Jr motor controller."))
                     .toStdString(),
                 "trexpanel");
    app.set_version_flag("--version", std::string("trexpanel ") + kVersion);
    addLineOptions(app, options.line);
    QString scale;
    app.add_flag("--simulate", options.simulate,
                 words(QT_TRANSLATE_NOOP("Options", "connect to the built-in simulated controller"))
                     .toStdString());
    app.add_flag("--offscreen", options.offscreen,
                 words(QT_TRANSLATE_NOOP("Options", "needs no display")).toStdString());
    addText(app, "FILE", "FILE", options.recording,
            QT_TRANSLATE_NOOP("Options", "a recording to open beside the panel"));
    addText(app, "--script", "FILE", options.script,
            QT_TRANSLATE_NOOP(
                "Options", "play this script, then exit: 0 passed, 1 a step failed, 2 unreadable"));
    addText(app, "--report", "FILE", options.report,
            QT_TRANSLATE_NOOP("Options", "write what the script did, as JSON"));
    addText(app, "--screenshots", "DIR", options.screenshots,
            QT_TRANSLATE_NOOP("Options", "folder for the script's pictures; default out/demo"));
    addText(app, "--settings", "FILE", options.settings,
            QT_TRANSLATE_NOOP("Options", "settings file in place of your own"));
    addText(app, "--language", "XX", options.language,
            QT_TRANSLATE_NOOP("Options", "language, such as en or de"));
    addText(app, "--theme", "NAME", options.theme,
            QT_TRANSLATE_NOOP("Options", "light, dark or system"));
    addText(app, "--scale", "N", scale,
            QT_TRANSLATE_NOOP("Options", "size of everything in percent, 50 to 400"));
    app.add_flag(
        "-v", [&options](std::int64_t count) { options.verbosity = static_cast<int>(count); },
        words(QT_TRANSLATE_NOOP("Options", "log transactions to stderr; -vv the bytes, too"))
            .toStdString());
    QString problem;
    try {
        app.parse(argc, argv);
        problem = complaint(options, scale);
    } catch (const CLI::Success& success) { // --help, --version
        app.exit(success, std::cout, std::cerr);
        return 0;
    } catch (const CLI::Error& error) {
        problem = QString::fromUtf8(error.what());
    }
    if (problem.isEmpty()) {
        return std::nullopt;
    }
    printMessage(
        words(QT_TRANSLATE_NOOP("Options", "trexpanel: %1. See: trexpanel --help")).arg(problem));
    return kUsage;
}

void prepareEnvironment(const PanelOptions& options)
{
    if (options.offscreen && !qgetenv("QT_QPA_PLATFORM").startsWith("offscreen:")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    if (options.scale > 0.0) {
        qputenv("QT_SCALE_FACTOR", QByteArray::number(options.scale));
    }
}

} // namespace trex
