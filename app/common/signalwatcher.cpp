// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/signalwatcher.h"

#include <QSocketNotifier>
#include <QtGlobal>

#ifdef Q_OS_UNIX
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>

#include <fcntl.h>
#include <unistd.h>
#endif

namespace trex {

#ifdef Q_OS_UNIX
namespace {

// A signal handler can only reach what is global; an int is all it needs.
volatile std::sig_atomic_t writeEnd = -1;
volatile std::sig_atomic_t readEnd = -1;
std::array<bool, 64> watched{};

void onSignal(int signalNumber)
{
    const int kept = errno;
    const auto byte = static_cast<std::uint8_t>(signalNumber);
    [[maybe_unused]] const auto written = ::write(writeEnd, &byte, 1);
    errno = kept;
}

} // namespace

SignalWatcher::SignalWatcher(std::initializer_list<int> signalNumbers, QObject* parent)
    : QObject(parent)
{
    std::array<int, 2> ends{-1, -1};
    if (writeEnd != -1 || ::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
        return;
    }
    readEnd = ends[0];
    writeEnd = ends[1];
    m_notifier = new QSocketNotifier(ends[0], QSocketNotifier::Read, this);
    connect(m_notifier, &QSocketNotifier::activated, this, &SignalWatcher::readPipe);
    for (const int number : signalNumbers) {
        struct sigaction before { };
        if (number == SIGHUP && ::sigaction(number, nullptr, &before) == 0
            && before.sa_handler == SIG_IGN) {
            continue;
        }
        struct sigaction action { };
        action.sa_handler = onSignal;
        action.sa_flags = SA_RESTART;
        ::sigemptyset(&action.sa_mask);
        ::sigaction(number, &action, nullptr);
        watched.at(static_cast<std::size_t>(number)) = true;
    }
}

SignalWatcher::~SignalWatcher()
{
    if (m_notifier == nullptr) {
        return;
    }
    for (std::size_t number = 0; number < watched.size(); ++number) {
        if (watched.at(number)) {
            std::signal(static_cast<int>(number), SIG_DFL);
        }
    }
    watched.fill(false);
    m_notifier->setEnabled(false);
    ::close(static_cast<int>(writeEnd));
    ::close(static_cast<int>(readEnd));
    writeEnd = -1;
    readEnd = -1;
}

void SignalWatcher::readPipe()
{
    std::uint8_t byte = 0;
    while (::read(static_cast<int>(readEnd), &byte, 1) == 1) {
        emit received(byte);
    }
}
#else
SignalWatcher::SignalWatcher(std::initializer_list<int>, QObject* parent) : QObject(parent) { }
SignalWatcher::~SignalWatcher() = default;
void SignalWatcher::readPipe() { }
#endif

} // namespace trex
