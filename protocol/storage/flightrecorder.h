// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recorder.h"
#include "protocol/storage/recordingfeed.h"
#include "protocol/storage/sampletap.h"

#include <QTimer>

#include <deque>

namespace trex {

struct FlightPolicy {
    bool isEnabled = true;
    bool onFault = true; ///< a motor fault, an over-current, the controller's serial timeout
    bool onStop = true; ///< stop() while the motors were armed
    bool onLoss = true;
    QString folder{}; ///< made when first needed
    Duration before = std::chrono::minutes(5); ///< kept and frozen
    Duration packetsBefore = std::chrono::minutes(1); ///< packets are many; 0: none
    std::chrono::milliseconds after{2000}; ///< recorded after what happened
    Duration distance = std::chrono::seconds(30); ///< between two freezes
    int files = 20; ///< the oldest ones beyond go
    RecordingFacts facts{}; ///< program and version
};

/// Always on: keeps the last minutes in memory (the samples are in the store anyway) and freezes
/// them to a recording of their own when something goes wrong. Main thread; never waits for the
/// disk.
class FlightRecorder : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(FlightRecorder)

public:
    /// Outlived by both.
    FlightRecorder(Controller& controller, const TelemetryStore& store, QObject* parent = nullptr);
    ~FlightRecorder() override; ///< what waits to be frozen is frozen now

    void setPolicy(const FlightPolicy& policy);
    [[nodiscard]] const FlightPolicy& policy() const { return m_policy; }
    /// The settings as last read; stored with every freeze.
    void setConfiguration(const Configuration& configuration) { m_configuration = configuration; }
    /// Freezes in `after` from now, unless another freeze was too short ago. `reason`: "fault",
    /// "stop", "loss", or the caller's word of small letters; part of the file's name.
    void freeze(const QString& reason);
    /// Freezes now, whatever the policy says but for its folder.
    void keepNow(const QString& reason);

signals:
    void frozen(const QString& path, const QString& reason);
    void failed(const trex::Error& error);

private:
    void onBatch();
    void onEvent(const RecordedEvent& event);
    void writeFile(Duration after);
    void forgetOld();
    void dropOldestEvent();
    [[nodiscard]] RecordingBatch collect(Instant from);

    Controller& m_controller;
    const TelemetryStore& m_store;
    RecordingFeed m_feed;
    FlightPolicy m_policy;
    std::deque<RecordedEvent> m_events;
    std::map<QString, RecordedEvent> m_before; ///< by kind: what held before the first of m_events
    std::deque<RecordedPacket> m_packets;
    std::deque<RecordedHealth> m_health;
    std::optional<Configuration> m_configuration;
    std::array<std::size_t, 2> m_nextStatus{}; ///< status and UART samples looked at
    int m_clears = 0;
    QTimer m_after;
    QString m_reason;
    std::optional<Instant> m_lastFreeze;
    RecorderThread m_thread; ///< last: ends first
};

} // namespace trex
