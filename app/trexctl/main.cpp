// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/logging.h"
#include "app/common/signalwatcher.h"
#include "app/common/version.h"
#include "app/trexctl/commandline.h"
#include "app/trexctl/session.h"
#include "protocol/storage/datafolder.h"
#include "protocol/storage/linesettingsstore.h"
#include "protocol/transport/laststop.h"

#include <QCoreApplication>

#include <csignal>

using namespace trex;

namespace {

int run(CommandLine& commandLine, SettingsFile& settings, const OpenOptions& options)
{
#ifdef SIGHUP
    SignalWatcher signalWatcher{SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGTSTP};
#else
    SignalWatcher signalWatcher{SIGINT, SIGTERM};
#endif
    Session session(commandLine.verb(), options, commandLine.isJson(),
                    journalPath(settings.path()));
    if (const auto problem = settings.problem();
        problem && problem->code == ErrorCode::FileMalformed) {
        session.warn(
            settings.problemText()); // another's place to be told: a folder not to write in
    }
    logWire(session.controller(), commandLine.verbosity());
    QObject::connect(&session, &Session::finished, qApp, &QCoreApplication::exit);
    QObject::connect(&session, &Session::connected, &session, [&] {
        if (commandLine.lineOptions().port) {
            LineSettingsStore(settings).remember(options.port, options.line);
        }
    });
    QObject::connect(&signalWatcher, &SignalWatcher::received, &session, [&](int number) {
#ifdef SIGHUP
        if (number == SIGUSR1) {
            commandLine.verb().powerCycle();
            return;
        }
        if (number == SIGTSTP && !commandLine.verb().stopsOnClose()) {
            std::raise(SIGSTOP); // no motor is in its care
            return;
        }
#else
        Q_UNUSED(number)
#endif
        session.interrupt(); // Ctrl+Z, too: a program that stands still cannot stop a motor
    });
    QMetaObject::invokeMethod(&session, &Session::start, Qt::QueuedConnection);
    return QCoreApplication::exec();
}

} // namespace

int main(int argc, char* argv[])
{
    laststop::installCrashHandlers();
    QCoreApplication app(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("trexctl"));
    QCoreApplication::setApplicationVersion(QLatin1StringView(kVersion));
    CommandLine commandLine;
    if (const auto exitCode = commandLine.parse(argc, argv)) {
        return *exitCode;
    }
    installLogging(commandLine.verbosity());
    SettingsFile settings;
    const auto options = commandLine.openOptions(settings);
    const Checked checkedLine = checked(options);
    const Checked checkedVerb = checkedLine ? commandLine.verb().check(*options) : checkedLine;
    if (!checkedVerb) {
        printMessage(checkedVerb.error().text);
        return checkedVerb.error().exitCode;
    }
    return run(commandLine, settings, *options);
}
