// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/csvexport.h"

#include "protocol/savefile.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace trex {

QByteArray currentsCsvHeader()
{
    return QByteArrayLiteral("t_s,motor1_raw,motor2_raw,motor1_A,motor2_A\n");
}

QByteArray currentsCsvRow(double seconds, int raw1, int raw2, double amperesPerCount)
{
    constexpr int kTimeDecimals = 5; // the store's tick is 10 µs
    constexpr int kAmpereDecimals = 3;
    QByteArray row;
    row.reserve(48);
    row += QByteArray::number(seconds, 'f', kTimeDecimals) + ',';
    row += QByteArray::number(raw1) + ',';
    row += QByteArray::number(raw2) + ',';
    row += QByteArray::number(raw1 * amperesPerCount, 'f', kAmpereDecimals) + ',';
    row += QByteArray::number(raw2 * amperesPerCount, 'f', kAmpereDecimals) + '\n';
    return row;
}

bool isFileOrNew(const QString& path)
{
    const QFileInfo info(path);
    return !info.exists() || info.isFile();
}

Result<std::size_t> exportCurrentsCsv(const QString& path, const TelemetryStore& store,
                                      double amperesPerCount, std::optional<TimeRange> range)
{
    const auto unwritable = [&path](const QString& cause) {
        return fail(ErrorCode::FileUnwritable, QStringLiteral("%1: %2").arg(path, cause));
    };
    if (!isFileOrNew(path)) {
        return unwritable(QCoreApplication::translate("CsvExport", "not a plain file"));
    }
    SaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        return unwritable(file.errorString());
    }
    const TimeSeries& motor1 = store.series("motor1-current");
    const TimeSeries& motor2 = store.series("motor2-current");
    std::size_t begin = motor1.first();
    std::size_t end = motor1.size();
    if (range) {
        std::tie(begin, end) = motor1.range(range->from, range->to);
    }
    file.write(currentsCsvHeader());
    const Instant start = store.start().value_or(Instant());
    for (std::size_t i = begin; i < end; ++i) {
        const std::chrono::duration<double> since = motor1.time(i) - start;
        // A sample's time is kept in steps of 10 µs, which may lie a step before the true start.
        const double seconds = std::max(since.count(), 0.0);
        file.write(currentsCsvRow(seconds, motor1.value(i), motor2.value(i), amperesPerCount));
    }
    if (!file.commit()) { // also tells of a write that failed on the way, a full disk
        return unwritable(file.errorString());
    }
    return end - begin;
}

} // namespace trex
