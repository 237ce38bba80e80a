// SPDX-License-Identifier: GPL-3.0-or-later
// The two ways for fresh samples to a calibration: out of the telemetry store (panel), or asked for
// one by one (command line). Main thread.
#pragma once

#include "protocol/procedures/channelcalibration.h"

namespace trex {

class TelemetryStore;

/// While the calibration collects: has the raw channels polled, and passes on every sample that the
/// store gets from then on, each once.
class StoreFeed : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(StoreFeed)

public:
    StoreFeed(Controller& controller, const TelemetryStore& store, ChannelCalibration& calibration,
              QObject* parent = nullptr);
    ~StoreFeed() override;

private:
    void onStep();
    void onBatch();

    Controller& m_controller;
    const TelemetryStore& m_store;
    ChannelCalibration& m_calibration;
    std::size_t m_next = 0;
    int m_clears = 0;
    bool m_isWanting = false;
};

/// While the calibration collects: asks for the raw channels, 50 times a second at most.
class RequestFeed : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RequestFeed)

public:
    RequestFeed(Controller& controller, ChannelCalibration& calibration, QObject* parent = nullptr);

private:
    void ask();

    Controller& m_controller;
    ChannelCalibration& m_calibration;
    QTimer m_timer;
    bool m_isAsking = false;
};

} // namespace trex
