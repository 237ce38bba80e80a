// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recorder.h"
#include "protocol/storage/recordingfeed.h"
#include "protocol/storage/sampletap.h"

#include <QTimer>

namespace trex {

/// The polls that a stream's name on the command line stands for: "currents", "channels" (raw and
/// remapped), "status" (both latched bytes). None: no such name.
[[nodiscard]] std::optional<std::vector<PollId>> pollsOfStreamName(QStringView name);

struct RecordingPlan {
    QString path{};
    /// Keep: the file gets a name of its own when this one is taken; path() says which.
    RecorderThread::Existing existing = RecorderThread::Existing::Replace;
    SampleTap::Wanted polls{}; ///< and other sources; states have no samples
    bool hasPackets = false; ///< every attempt on the wire, too
    Duration history{0}; ///< how much of what the store already holds goes before
    RecordingFacts facts{}; ///< program and version, and whatever else is known
};

/// Records what goes through a controller and its store, as it comes, until stopped. Main thread;
/// never waits for the disk. What was handed over at most kInterval ago is on the disk, unless the
/// disk is slower: then samples wait in the store, and only packets and events beyond a bound are
/// left out, counted, and named in the file.
class SessionRecorder : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(SessionRecorder)

public:
    static constexpr std::chrono::milliseconds kInterval{300};

    SessionRecorder(Controller& controller, const TelemetryStore& store, QObject* parent = nullptr);
    /// Ends a recording that still runs, and waits until the disk has it.
    ~SessionRecorder() override;

    /// Begins; an earlier recording ends first. What cannot be written is told by failed().
    void start(const RecordingPlan& plan);
    void stop(); ///< finished() follows, or failed()

    /// Takes what is new in the store. Done with each batch of the controller; a store that
    /// somebody else fills is told here.
    void pull();
    void addConfiguration(const Configuration& configuration);
    void addEvent(int severity, const QString& kind, const QString& text);
    void addEvent(const RecordedEvent& event); ///< its tick is the steady clock's

    [[nodiscard]] bool isRecording() const { return m_isRecording; }
    [[nodiscard]] QString path() const { return m_plan.path; }
    /// Of the source that has most: the rows of its CSV.
    [[nodiscard]] std::size_t samples() const;
    /// On the disk, as of the last batch that it took.
    [[nodiscard]] qint64 bytes() const { return m_thread.bytes(); }
    [[nodiscard]] std::size_t dropped() const { return m_dropped; } ///< events and packets
    [[nodiscard]] Duration length() const; ///< from the first sample to the last

signals:
    void started(const QString& path);
    void finished(const QString& path);
    /// FileUnwritable, with the path and the cause. The recording has ended; the file holds what
    /// was written before.
    void failed(const trex::Error& error);

private:
    void flush();
    void write(RecordingBatch batch);
    void onFailure(const Error& error);
    [[nodiscard]] RecordingBatch takePending();
    [[nodiscard]] RecordingFacts startFacts() const;
    template <class T>
    void keep(std::vector<T>& list, const T& entry);

    const TelemetryStore& m_store;
    RecordingFeed m_feed;
    RecordingPlan m_plan;
    SampleTap m_tap;
    QTimer m_timer;
    RecordingBatch m_pending;
    Tick m_origin = 0;
    bool m_isRecording = false;
    int m_underWay = 0; ///< batches that the disk has not taken yet
    quint32 m_generation = 0; ///< of the recording; answers of earlier ones are no news
    std::array<std::size_t, kSourceCount> m_samples{};
    std::optional<Tick> m_first;
    Tick m_last = 0;
    std::size_t m_dropped = 0;
    std::size_t m_droppedTold = 0;
    RecorderThread m_thread; ///< last: ends first, while all else is still there
};

} // namespace trex
