// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/laststop.h"

#include <QtGlobal>

#include <array>
#include <csignal>
#include <cstring>

#ifdef Q_OS_UNIX
#include <poll.h>
#include <termios.h>
#include <unistd.h>
#endif

namespace trex::laststop {

namespace {

constexpr std::size_t kLines = 8;
constexpr std::size_t kMostBytes = 32; // two packets of the longest form, and room
constexpr std::size_t kStackBytes = 32'768;
constexpr int kReplyMs = 60; // no reply of ours is longer on its way

#ifdef Q_OS_UNIX
constexpr std::array kFatal{SIGSEGV, SIGABRT, SIGBUS,    SIGFPE,  SIGILL,  SIGQUIT, SIGSYS,
                            SIGTRAP, SIGXCPU, SIGVTALRM, SIGPROF, SIGALRM, SIGUSR1, SIGUSR2};
#endif

/// Filled while all is well and read by a signal handler: plain memory, and a size that is set last
/// and taken back first.
struct Line {
    const void* owner = nullptr;
    volatile std::sig_atomic_t descriptor = -1;
    volatile std::sig_atomic_t size = 0;
    std::array<char, kMostBytes> bytes{};
};
std::array<Line, kLines> lines;
volatile std::sig_atomic_t crashing = 0;

#ifdef Q_OS_UNIX
void sendAll(bool first)
{
    for (const Line& line : lines) {
        if (line.size <= 0 || line.descriptor < 0) {
            continue;
        }
        if (first) {
            ::tcflush(line.descriptor, TCOFLUSH); // orders that have not left
        }
        [[maybe_unused]] const auto written =
            ::write(line.descriptor, line.bytes.data(), static_cast<std::size_t>(line.size));
    }
}

// Nothing here but what signal-safety(7) allows.
void onCrash(int number)
{
    crashing = 1;
    sendAll(true);
    ::poll(nullptr, 0, kReplyMs);
    sendAll(false);
    std::signal(number, SIG_DFL);
    std::raise(number);
}
#endif

} // namespace

void prepare(const void* owner, int descriptor, const QByteArray& bytes)
{
    withdraw(owner);
    if (descriptor < 0 || bytes.isEmpty() || bytes.size() > static_cast<qsizetype>(kMostBytes)) {
        return;
    }
    for (Line& line : lines) {
        if (line.owner == nullptr) {
            line.owner = owner;
            std::memcpy(line.bytes.data(), bytes.constData(),
                        static_cast<std::size_t>(bytes.size()));
            line.descriptor = descriptor;
            line.size = static_cast<std::sig_atomic_t>(bytes.size());
            return;
        }
    }
}

void withdraw(const void* owner)
{
    for (Line& line : lines) {
        if (line.owner == owner) {
            line.size = 0;
            line.descriptor = -1;
            line.owner = nullptr;
        }
    }
}

bool isCrashing()
{
    return crashing != 0;
}

void installCrashHandlers()
{
#ifdef Q_OS_UNIX
    // A stack of its own: the crash may be that there is none left.
    alignas(16) static std::array<char, kStackBytes> stack;
    stack_t alternate{};
    alternate.ss_sp = stack.data();
    alternate.ss_size = stack.size();
    ::sigaltstack(&alternate, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int number : kFatal) {
        struct sigaction action { };
        action.sa_handler = onCrash;
        action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND);
        ::sigemptyset(&action.sa_mask);
        ::sigaction(number, &action, nullptr);
    }
#endif
}

} // namespace trex::laststop
