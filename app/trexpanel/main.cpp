// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/logging.h"
#include "app/common/signalwatcher.h"
#include "app/common/version.h"
#include "app/script/processclock.h"
#include "app/trexpanel/paneloptions.h"
#include "app/trexpanel/program.h"
#include "app/trexpanel/startup.h"
#include "protocol/errortext.h"
#include "protocol/transport/laststop.h"

#include <QApplication>
#include <QLocale>

#include <csignal>
#include <memory>

using namespace trex;

int main(int argc, char* argv[])
{
    processclock::sinceStartMs(); // the clock looks at the process's age once, early
    PanelOptions options;
    if (const auto exitCode = parsePanelOptions(argc, argv, options)) {
        return *exitCode;
    }
    prepareEnvironment(options);
    installLogging(options.verbosity);

    laststop::installCrashHandlers();
    auto displayGuard = std::make_unique<DisplayGuard>();
    QApplication app(argc, argv);
    displayGuard.reset();
    if (!hasFonts()) {
        return 2;
    }
    QApplication::setApplicationName(QStringLiteral("trexpanel"));
    QApplication::setApplicationDisplayName(QStringLiteral("TReX Panel"));
    QApplication::setApplicationVersion(QLatin1StringView(kVersion));
    QApplication::setDesktopFileName(QStringLiteral("trexpanel"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/trexpanel.svg")));
    QApplication::setQuitOnLastWindowClosed(
        false); // the program quits when the motors were stopped
    QLocale::setDefault(QLocale::c()); // figures look the same everywhere: a point, no grouping

    Program program(options);
#ifdef SIGHUP
    SignalWatcher signalWatcher{SIGINT, SIGTERM, SIGHUP, SIGTSTP};
    QObject::connect(&signalWatcher, &SignalWatcher::received, &program, [&program](int number) {
        number == SIGTSTP ? program.suspend() : program.quit();
    });
#else
    SignalWatcher signalWatcher{SIGINT, SIGTERM};
    QObject::connect(&signalWatcher, &SignalWatcher::received, &program, &Program::quit);
#endif
    if (const Result<void> started = program.start(); !started) {
        printMessage(QStringLiteral("trexpanel: ") + errorText(started.error()));
        return 2;
    }
    return QApplication::exec();
}
