// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/processclock.h"

#include <QDateTime>
#include <QFile>

#include <chrono>
#include <ctime>
#ifdef Q_OS_LINUX
#include <unistd.h>
#endif

namespace trex::processclock {

namespace {

using Clock = std::chrono::steady_clock;

/// How old the process was at the first call; the kernel counts in ticks of 10 ms.
double ageAtFirstCallMs()
{
#ifdef Q_OS_LINUX
    QFile file(QStringLiteral("/proc/self/stat"));
    timespec now{};
    if (file.open(QIODevice::ReadOnly) && clock_gettime(CLOCK_BOOTTIME, &now) == 0) {
        const QByteArray stat = file.readAll();
        // The name of the program, in brackets, may hold spaces; field 22 counts from before it.
        const QList<QByteArray> fields = stat.mid(stat.lastIndexOf(')') + 2).split(' ');
        constexpr qsizetype kStartTime = 22 - 3;
        if (fields.size() > kStartTime) {
            const double startMs =
                fields[kStartTime].toDouble() * 1000.0 / static_cast<double>(sysconf(_SC_CLK_TCK));
            const double nowMs =
                static_cast<double>(now.tv_sec) * 1000.0 + static_cast<double>(now.tv_nsec) / 1e6;
            return std::max(0.0, nowMs - startMs);
        }
    }
#endif
    return 0.0;
}

} // namespace

double sinceStartMs()
{
    static const Clock::time_point first = Clock::now();
    static const double ageMs = ageAtFirstCallMs();
    return ageMs + std::chrono::duration<double, std::milli>(Clock::now() - first).count();
}

qint64 startEpochMs()
{
    static const qint64 epoch =
        QDateTime::currentMSecsSinceEpoch() - static_cast<qint64>(sinceStartMs());
    return epoch;
}

double peakRssMiB()
{
    QFile file(QStringLiteral("/proc/self/status"));
    if (!file.open(QIODevice::ReadOnly)) {
        return 0.0;
    }
    const QList<QByteArray> lines = file.readAll().split('\n');
    for (const QByteArray& line : lines) {
        if (line.startsWith("VmHWM:")) {
            return line.mid(6).trimmed().split(' ').first().toDouble() / 1024.0;
        }
    }
    return 0.0;
}

} // namespace trex::processclock
