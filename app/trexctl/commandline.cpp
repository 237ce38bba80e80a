// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/commandline.h"

#include "app/common/logging.h"
#include "app/common/version.h"
#include "app/trexctl/verbs.h"

#include <QStringList>

#include <CLI/CLI.hpp>

#include <iostream>

namespace trex {
namespace {

constexpr auto kHelpColumn = 30;

std::string words(const QString& text)
{
    return text.toStdString();
}

/// Arguments by their name alone: what they may be stands in their help.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_option_opts(const CLI::Option* option) const override
    {
        return option->get_positional() ? std::string() : CLI::Formatter::make_option_opts(option);
    }
    std::string make_option_usage(const CLI::Option* option) const override
    {
        const std::string name =
            make_option_name(option, true) + (option->get_expected_max() > 1 ? "..." : "");
        return option->get_required() ? name : '[' + name + ']';
    }
};

/// The verb that was typed as far as it was recognised: "param get".
QString pathOf(const CLI::App& app)
{
    QString path;
    for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
        at = at->get_subcommands().front();
        path += u' ' + QString::fromStdString(at->get_name());
    }
    return path;
}

} // namespace

CommandLine::CommandLine()
    : m_app(std::make_unique<CLI::App>(
        words(Cli::tr("Control of Pololu TReX Jr and TReX motor controllers.")), "trexctl"))
{
    const std::string output = words(Cli::tr("Output"));
    m_app->formatter_fn([formatter = HelpFormatter()](const CLI::App* app, const std::string& name,
                                                      CLI::AppFormatMode mode) mutable {
        formatter.column_width(kHelpColumn);
        return formatter.make_help(app, name, mode);
    });
    m_app->set_version_flag("--version", std::string("trexctl ") + kVersion)->group(output);
    m_app->get_help_ptr()->description(words(Cli::tr("this help; after a command, its help")));
    m_app->get_help_ptr()->group(output);
    addLineOptions(*m_app, m_lineOptions);
    m_app->add_flag("--json", m_isJson, words(Cli::tr("JSON on stdout instead of text")))
        ->group(output);
    m_app
        ->add_flag(
            "-v", [this](std::int64_t count) { m_verbosity = static_cast<int>(count); },
            words(Cli::tr("log transactions to stderr; -vv the bytes, too")))
        ->group(output);
    m_app->require_subcommand(1);
    m_app->footer(words(Cli::tr("Options go before the command. Numbers may be decimal or 0x hex.\n"
                                "Exit: 0 done, 1 refused, 2 usage, 3 no reply, 4 port, 5 read-back "
                                "differs, 130 interrupted.")));
    addVerbs();
}

CommandLine::~CommandLine() = default;

CLI::App& CommandLine::addVerbPath(const QString& path, const QString& group)
{
    const QStringList names = path.split(u' ');
    CLI::App* at = m_app.get();
    for (qsizetype i = 0; i < names.size(); ++i) {
        const std::string name = words(names[i]);
        const auto found =
            at->get_subcommands([&name](const CLI::App* each) { return each->get_name() == name; });
        CLI::App* next = found.empty() ? nullptr : found.front();
        if (next == nullptr) {
            const bool isFamily = i + 1 < names.size();
            const QString help = isFamily ? Cli::tr(familyHelp(name)) : QString();
            next = at->add_subcommand(name, words(help));
            next->fallthrough(); // `trexctl info --json` is as good as `trexctl --json info`
            next->group(i == 0 ? words(group) : words(Cli::tr("Commands")));
            if (isFamily) {
                next->require_subcommand(1);
            }
        }
        at = next;
    }
    return *at;
}

void CommandLine::addVerbs()
{
    for (const VerbRow& row : verbs()) {
        CLI::App& app = addVerbPath(QLatin1StringView(row.path), Cli::tr(row.group));
        app.description(words(Cli::tr(row.help)));
        Verb* const verb = m_verbs.emplace_back(row.make()).get();
        verb->declare(app);
        app.final_callback([this, verb, &app] {
            if (app.get_subcommands().empty()) { // else a command below it was typed
                m_chosen = verb;
            }
        });
    }
}

QString CommandLine::complaint(const QString& what) const
{
    const QString path = pathOf(*m_app);
    QString reason = what;
    if (path.isEmpty() && !m_app->remaining().empty()) {
        reason = Cli::tr("There is no command '%1'")
                     .arg(QString::fromStdString(m_app->remaining().front()));
    } else if (path.isEmpty()) {
        reason = what.contains(QLatin1StringView("ubcommand")) ? Cli::tr("No command given") : what;
    }
    return Cli::tr("%1; nothing was sent. See: trexctl%2 --help").arg(reason, path);
}

std::optional<int> CommandLine::parse(int argc, char** argv)
{
    try {
        m_app->parse(argc, argv);
    } catch (const CLI::Success& success) { // --help, --version
        m_app->exit(success, std::cout, std::cerr);
        std::cout.flush();
        return exitcode::kDone;
    } catch (const CLI::Error& error) {
        printMessage(complaint(QString::fromUtf8(error.what())));
        return exitcode::kUsage;
    }
    if (m_chosen == nullptr) {
        printMessage(complaint(Cli::tr("No command given")));
        return exitcode::kUsage;
    }
    return std::nullopt;
}

Result<OpenOptions> CommandLine::openOptions(SettingsFile& settings) const
{
    if (m_chosen->usesPort()) {
        return toOpenOptions(m_lineOptions, settings);
    }
    return toLineSettings(m_lineOptions).map([](const LineSettings& line) {
        return OpenOptions{.port = {}, .line = line};
    });
}

} // namespace trex
