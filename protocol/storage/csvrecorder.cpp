// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/csvrecorder.h"

#include "protocol/storage/csvexport.h"

#include <QCoreApplication>

#include <limits>

namespace trex {

namespace {
constexpr std::chrono::milliseconds kFlushInterval(500);
}

CsvRecorder::CsvRecorder(const TelemetryStore& store) : m_store(store)
{
    store.addHolder(*this);
}

CsvRecorder::~CsvRecorder()
{
    stop();
    m_store.removeHolder(*this);
}

std::size_t CsvRecorder::firstNeeded(Source source) const
{
    if (!isRecording() || !(source == PollId::Currents)) {
        return std::numeric_limits<std::size_t>::max();
    }
    return m_clears == m_store.clears() ? m_next : 0;
}

Result<void> CsvRecorder::start(const QString& path, double amperesPerCount)
{
    if (auto stopped = stop(); !stopped) {
        return stopped;
    }
    if (!isFileOrNew(path)) {
        const QString cause = QCoreApplication::translate("CsvExport", "not a plain file");
        return fail(ErrorCode::FileUnwritable, QStringLiteral("%1: %2").arg(path, cause));
    }
    m_file.setFileName(path);
    if (!m_file.open(QIODevice::WriteOnly | QIODevice::Truncate)) {
        return fail(ErrorCode::FileUnwritable,
                    QStringLiteral("%1: %2").arg(path, m_file.errorString()));
    }
    m_amperesPerCount = amperesPerCount;
    m_next = m_store.series("motor1-current").size();
    m_clears = m_store.clears();
    m_origin.reset();
    m_lastFlush.reset();
    m_samples = 0;
    if (m_file.write(currentsCsvHeader()) < 0 || !m_file.flush()) {
        return giveUp();
    }
    return {};
}

Result<void> CsvRecorder::pump(Instant now)
{
    if (!isRecording()) {
        return {};
    }
    if (auto written = writeNew(); !written) {
        return written;
    }
    if (!m_lastFlush || now - *m_lastFlush >= kFlushInterval) {
        m_lastFlush = now;
        if (!m_file.flush()) {
            return giveUp();
        }
    }
    return {};
}

Result<void> CsvRecorder::stop()
{
    if (!isRecording()) {
        return {};
    }
    if (auto written = writeNew(); !written) {
        return written;
    }
    if (!m_file.flush()) {
        return giveUp();
    }
    m_file.close();
    return {};
}

Result<void> CsvRecorder::writeNew()
{
    const TimeSeries& motor1 = m_store.series("motor1-current");
    const TimeSeries& motor2 = m_store.series("motor2-current");
    if (m_clears != m_store.clears()) {
        m_clears = m_store.clears();
        m_next = 0;
    }
    for (; m_next < motor1.size(); ++m_next) {
        const Instant time = motor1.time(m_next);
        m_origin = m_origin.value_or(time);
        const std::chrono::duration<double> since = time - *m_origin;
        const QByteArray row = currentsCsvRow(since.count(), motor1.value(m_next),
                                              motor2.value(m_next), m_amperesPerCount);
        if (m_file.write(row) != row.size()) {
            return giveUp();
        }
        ++m_samples;
    }
    return {};
}

tl::unexpected<Error> CsvRecorder::giveUp()
{
    auto error = fail(ErrorCode::FileUnwritable,
                      QStringLiteral("%1: %2").arg(m_file.fileName(), m_file.errorString()));
    m_file.close();
    return error;
}

} // namespace trex
