// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/controller.h"
#include "protocol/session/devicesettings.h"
#include "protocol/storage/recordinghistory.h"
#include "protocol/storage/recordinglatch.h"
#include "protocol/storage/recordingloader.h"

namespace trex {

/// Where a recording is shown: the façade and the stores that a window's panels look at.
struct RecordingStage {
    Controller& controller; ///< a recording's (becomeRecording())
    DeviceSettings& settings;
    TelemetryStore& store;
    StatusLatch& latch;
};

/// Plays a recording onto a stage: samples, latched bits, the state of link and controller,
/// settings, events and packets, all as they were at the playhead, which runs at any speed, is
/// moved, or steps. Time comes in as an argument. Main thread.
class RecordingPlayer : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RecordingPlayer)

public:
    /// A moment of a recording on its stage's clock.
    [[nodiscard]] static Instant instantOf(Tick tick) { return TimeAxis::instantOf(tick); }

    RecordingPlayer(std::unique_ptr<RecordingReader> reader, const RecordingStage& stage,
                    QObject* parent = nullptr);
    ~RecordingPlayer() override;

    [[nodiscard]] const RecordingReader& reader() const { return *m_reader; }
    [[nodiscard]] const TelemetryStore& store() const { return m_stage.store; }
    [[nodiscard]] RecordingLoader& loader() { return m_loader; }
    [[nodiscard]] const RecordingHistory& history() const { return m_history; }

    [[nodiscard]] Tick first() const { return m_first; }
    [[nodiscard]] Tick last() const { return m_last; }
    [[nodiscard]] Tick playhead() const { return m_playhead; }
    [[nodiscard]] QDateTime wallClock() const; ///< at the playhead; invalid: not said in the file
    [[nodiscard]] bool wasArmed() const { return m_wasArmed; } ///< at the playhead
    void seek(Tick tick); ///< kept within first() and last()

    [[nodiscard]] bool isPlaying() const { return m_playedFrom.has_value(); }
    void play(Instant now); ///< from the start when the playhead is at the end
    void pause();
    [[nodiscard]] double speed() const { return m_speed; }
    void setSpeed(double speed, Instant now); ///< times real time; above 0
    void advance(Instant now); ///< moves the playhead to where it is due

    void stepSample(int direction); ///< +1 or −1: to the next sample of any stream
    void stepEvent(int direction); ///< to the next moment at which something happened

signals:
    void moved(); ///< the stage shows another moment
    void playingChanged(bool playing);
    /// Events [begin, end) of the history have passed. `isAnew`: those told before are no longer
    /// the past.
    void eventsPassed(std::size_t begin, std::size_t end, bool isAnew);

private:
    void show(bool isJump);
    void showSettings(const std::optional<std::size_t>& configuration);
    void showPackets(bool isJump);
    void tellEvents(bool isJump);
    [[nodiscard]] std::array<MotorOrder, 3> orders(Tick since) const;
    [[nodiscard]] TransactionRecord recordOf(const RecordedPacket& packet) const;

    std::unique_ptr<RecordingReader> m_reader;
    RecordingStage m_stage;
    RecordingLoader m_loader;
    RecordingHistory m_history;
    RecordingLatch m_latch;
    Tick m_first = 0;
    Tick m_last = 0;
    Tick m_playhead = 0;
    double m_speed = 1.0;
    struct Start {
        Tick tick = 0;
        Instant time;
    };
    std::optional<Start> m_playedFrom; ///< playhead and clock when play or its speed began
    bool m_wasArmed = false;
    std::size_t m_passedEvents = 0;
    std::size_t m_passedPackets = 0;
    std::optional<std::size_t> m_shownConfiguration;
};

} // namespace trex
