// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/transaction.h"

#include <QJsonObject>
#include <QObject>

namespace trex {

class Controller;
class FrameTicker;

/// Adds up what the report tells, over all connections of the run. GUI thread.
class Metrics : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Metrics)

public:
    Metrics(const Controller& controller, const FrameTicker& ticker, QObject* parent = nullptr);
    void firstFramePainted(); ///< the start is over
    [[nodiscard]] QJsonObject toJson() const;

private:
    void onBatch();
    void onRecords(const std::vector<TransactionRecord>& records);

    const Controller& m_controller;
    const FrameTicker& m_ticker;
    double m_startupMs = 0.0;
    LinkStats m_earlier; ///< of connections before this one
    LinkStats m_now;
    double m_stopLatencyMsMax = 0.0;
    quint64 m_samples = 0;
    quint64 m_samplesLost = 0;
    bool m_currentFailed = false; ///< the latest attempt; a retry may make up for it
};

} // namespace trex
