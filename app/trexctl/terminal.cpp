// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trexctl/terminal.h"

#include "app/trexctl/failure.h"

#include <QSocketNotifier>
#include <QString>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>

#ifdef Q_OS_WIN
#include <io.h>
#else
#include <unistd.h>
#endif

namespace trex {

bool isAtTerminal()
{
#ifdef Q_OS_WIN
    return ::_isatty(0) != 0 && ::_isatty(2) != 0;
#else
    return ::isatty(STDIN_FILENO) == 1 && ::isatty(STDERR_FILENO) == 1;
#endif
}

namespace {

void ask(const QString& question)
{
    std::cerr << question.toStdString() << ' ' << Cli::tr("[y/N]").toStdString() << ' '
              << std::flush;
}

bool readAnswer()
{
    std::string answer;
    std::getline(std::cin, answer);
    return answer == "y" || answer == "Y" || answer == "yes"
        || answer == Cli::tr("yes").toStdString();
}

} // namespace

bool confirm(const QString& question)
{
    // No event loop yet that could take notice: Ctrl+C ends here, with the contract's exit code.
    const auto before = std::signal(SIGINT, [](int) { std::_Exit(exitcode::kInterrupted); });
    ask(question);
    const bool isYes = readAnswer();
    std::signal(SIGINT, before);
    return isYes;
}

void confirmLater(const QString& question, QObject* context, std::function<void(bool)> handler)
{
    ask(question);
    // A terminal hands over whole lines, so that reading one does not block when it is readable.
    constexpr qintptr kStandardInput = 0;
    auto* const notifier = new QSocketNotifier(kStandardInput, QSocketNotifier::Read, context);
    QObject::connect(notifier, &QSocketNotifier::activated, context,
                     [notifier, answered = std::move(handler)] {
                         notifier->setEnabled(false);
                         notifier->deleteLater();
                         answered(readAnswer());
                     });
}

} // namespace trex
