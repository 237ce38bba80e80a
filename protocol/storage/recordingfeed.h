// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/controller.h"
#include "protocol/storage/recordingdata.h"

namespace trex {

/// Tells what happens on a connection in the words of a recording: events (log, link, arming,
/// stops, orders and settings that were sent), packets, and the line's health once a second. Ticks
/// are those of the steady clock. Main thread.
class RecordingFeed : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RecordingFeed)

public:
    explicit RecordingFeed(Controller& controller, QObject* parent = nullptr);

    /// Packets cost time and memory: told only when somebody wants them.
    void setPacketsWanted(bool wanted) { m_arePacketsWanted = wanted; }
    [[nodiscard]] RecordingFacts facts() const; ///< of line and controller, as far as known now
    /// What holds now, as events: link, mode, control, learned channels. A recording begins with
    /// them.
    [[nodiscard]] std::vector<RecordedEvent> state() const;
    /// True for the kinds of state(): the latest of each says what holds.
    [[nodiscard]] static bool isState(const QString& kind);

signals:
    void eventSeen(const trex::RecordedEvent& event);
    void packetSeen(const trex::RecordedPacket& packet);
    void healthSeen(const trex::RecordedHealth& health);
    void factsChanged();

private:
    void onRecords(const std::vector<TransactionRecord>& records);
    void onBatch();
    void onDevice();
    void tell(int severity, QLatin1StringView kind, const QString& text);

    Controller& m_controller;
    bool m_arePacketsWanted = false;
    std::optional<Instant> m_lastHealth;
    DeviceInfo m_device;
};

} // namespace trex
