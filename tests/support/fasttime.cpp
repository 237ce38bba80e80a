// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of the C library through which Qt and the standard library read clocks and wait,
// defined once more: the program's own are taken first.
#include "tests/support/fasttime.h"

#include <poll.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>

namespace {

constexpr long long kNanosecond = 1'000'000'000;

std::atomic<double> factor = 1.0;
long long monotonicStart = 0;
long long wallStart = 0;

long long toNanoseconds(const timespec& time)
{
    return static_cast<long long>(time.tv_sec) * kNanosecond + time.tv_nsec;
}

timespec toTimespec(long long nanoseconds)
{
    return {static_cast<time_t>(nanoseconds / kNanosecond),
            static_cast<long>(nanoseconds % kNanosecond)};
}

long long realNow(clockid_t clock)
{
    timespec time{};
    ::syscall(SYS_clock_gettime, clock, &time);
    return toNanoseconds(time);
}

bool isWall(clockid_t clock)
{
    return clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE;
}

bool isSteady(clockid_t clock)
{
    return clock == CLOCK_MONOTONIC || clock == CLOCK_MONOTONIC_COARSE
        || clock == CLOCK_MONOTONIC_RAW || clock == CLOCK_BOOTTIME;
}

/// A wait of the faster time in the computer's; none is cut to nothing.
timespec slower(const timespec& wait)
{
    const auto nanoseconds = static_cast<double>(toNanoseconds(wait)) / factor;
    return toTimespec(static_cast<long long>(nanoseconds));
}

} // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* time) noexcept
{
    const auto result = static_cast<int>(::syscall(SYS_clock_gettime, clock, time));
    if (result == 0 && factor != 1.0 && (isWall(clock) || isSteady(clock))) {
        const long long start = isWall(clock) ? wallStart : monotonicStart;
        const auto since = static_cast<double>(toNanoseconds(*time) - start);
        *time = toTimespec(start + static_cast<long long>(since * factor));
    }
    return result;
}

int ppoll(pollfd* ports, nfds_t count, const timespec* timeout, const sigset_t* mask)
{
    timespec wait = timeout != nullptr ? slower(*timeout) : timespec{};
    constexpr std::size_t kMaskSize = 8; // of the kernel's sigset_t
    return static_cast<int>(
        ::syscall(SYS_ppoll, ports, count, timeout != nullptr ? &wait : nullptr, mask, kMaskSize));
}

int poll(pollfd* ports, nfds_t count, int timeoutMs)
{
    const timespec wait = toTimespec(static_cast<long long>(timeoutMs) * 1'000'000);
    return ::ppoll(ports, count, timeoutMs < 0 ? nullptr : &wait, nullptr);
}

int nanosleep(const timespec* wait, timespec* remaining)
{
    const timespec real = slower(*wait);
    return static_cast<int>(::syscall(SYS_nanosleep, &real, remaining));
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* wait, timespec* remaining)
{
    timespec real = *wait;
    if ((flags & TIMER_ABSTIME) != 0) {
        timespec now{};
        ::clock_gettime(clock, &now);
        const long long left = toNanoseconds(*wait) - toNanoseconds(now);
        real = toTimespec(left > 0 ? left : 0);
    }
    real = slower(real);
    return ::syscall(SYS_nanosleep, &real, remaining) == 0 ? 0 : errno;
}

} // extern "C"

namespace trex::test {

void makeTimeFaster(double asked)
{
    const char* given = std::getenv("TREX_TEST_SPEED");
    const double wanted = given != nullptr ? std::atof(given) : 0.0;
    monotonicStart = realNow(CLOCK_MONOTONIC);
    wallStart = realNow(CLOCK_REALTIME);
    factor = wanted > 0.0 ? wanted : asked;
}

} // namespace trex::test
