// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script/metrics.h"

#include "app/script/processclock.h"
#include "protocol/session/controller.h"
#include "widgets/common/frameticker.h"

#include <QJsonObject>

namespace trex {

namespace {

void add(LinkStats& sum, const LinkStats& stats)
{
    sum.transactions += stats.transactions;
    sum.retries += stats.retries;
    sum.timeouts += stats.timeouts;
    sum.crcErrors += stats.crcErrors;
    sum.bytesSent += stats.bytesSent;
    sum.bytesReceived += stats.bytesReceived;
}

double rounded(double value)
{
    return std::round(value * 1000.0) / 1000.0;
}

} // namespace

Metrics::Metrics(const Controller& controller, const FrameTicker& ticker, QObject* parent)
    : QObject(parent), m_controller(controller), m_ticker(ticker)
{
    connect(&controller, &Controller::batchArrived, this, &Metrics::onBatch);
    connect(&controller, &Controller::stateChanged, this, &Metrics::onBatch);
    connect(&controller, &Controller::recordsArrived, this, &Metrics::onRecords);
}

void Metrics::firstFramePainted()
{
    m_startupMs = processclock::sinceStartMs();
}

void Metrics::onBatch()
{
    const LinkStats& stats = m_controller.stats();
    if (stats.transactions < m_now.transactions) { // counted anew since the line was opened
        add(m_earlier, m_now);
    }
    m_now = stats;
    m_stopLatencyMsMax = std::max(m_stopLatencyMsMax, m_controller.stopLatencyMsMax());
}

void Metrics::onRecords(const std::vector<TransactionRecord>& records)
{
    static const Command currents = pollCommand(PollId::Currents);
    for (const TransactionRecord& record : records) {
        if (record.priority != Priority::Poll || record.isRaw || !(record.command == currents)) {
            continue;
        }
        if (m_currentFailed && record.attempt == 1) {
            ++m_samplesLost;
        }
        m_currentFailed = record.error.has_value();
        m_samples += record.error ? 0 : 1;
    }
}

QJsonObject Metrics::toJson() const
{
    LinkStats sum = m_earlier;
    add(sum, m_now);
    const auto number = [](quint64 count) { return static_cast<qint64>(count); };
    return {
        {QStringLiteral("startupMs"), rounded(m_startupMs)},
        {QStringLiteral("framesPainted"), number(m_ticker.framesPainted())},
        {QStringLiteral("frameMsMedian"), rounded(m_ticker.medianMs())},
        {QStringLiteral("frameMsP95"), rounded(m_ticker.percentile95Ms())},
        {QStringLiteral("transactions"), number(sum.transactions)},
        {QStringLiteral("retries"), number(sum.retries)},
        {QStringLiteral("timeouts"), number(sum.timeouts)},
        {QStringLiteral("crcErrors"), number(sum.crcErrors)},
        {QStringLiteral("bytesSent"), number(sum.bytesSent)},
        {QStringLiteral("bytesReceived"), number(sum.bytesReceived)},
        {QStringLiteral("samplesCurrent"), number(m_samples)},
        {QStringLiteral("samplesLost"), number(m_samplesLost + (m_currentFailed ? 1 : 0))},
        {QStringLiteral("stopLatencyMsMax"), rounded(m_stopLatencyMsMax)},
        {QStringLiteral("peakRssMiB"), rounded(processclock::peakRssMiB())},
    };
}

} // namespace trex
