// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/flightrecorder.h"
#include "protocol/storage/sessionrecorder.h"
#include "widgets/common/panel.h"

#include <QElapsedTimer>
#include <QTimer>

namespace trex {

/// What is kept of the session in files: the recording that the person starts and ends, and the
/// flight recorder, which is always on. Asks for all streams while it records, stores the settings
/// at the start and whenever they change, and tells the event log where a file is and what went
/// wrong with it. GUI thread; never waits for the disk.
class Recordings : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(Recordings)

public:
    /// `program`: who writes the files (program and its version).
    Recordings(PanelContext& context, const RecordingFacts& program, QObject* parent = nullptr);
    ~Recordings() override; ///< ends a recording that still runs, and waits until the disk has it

    void start(); ///< into the folder of the settings, under a name made of date and time
    void startAs(const QString& path); ///< replaces an older file of that name
    void stop();
    /// The last minutes of what was seen, to a file of their own, now.
    void keepLastMinutes();

    [[nodiscard]] bool isRecording() const { return m_recorder.isRecording(); }
    [[nodiscard]] std::chrono::milliseconds length() const; ///< since the start
    [[nodiscard]] qint64 bytes() const { return m_recorder.bytes(); }
    [[nodiscard]] QString path() const { return m_recorder.path(); }
    /// Why the last recording ended before its time; empty: it did not.
    [[nodiscard]] QString problem() const { return m_problem; }
    static constexpr int kMostFlightMinutes = 60;
    [[nodiscard]] QString folder() const; ///< where recordings go
    [[nodiscard]] QString flightFolder() const; ///< where the flight recorder keeps its files
    [[nodiscard]] int flightMinutes() const; ///< kept before a fault, 1 to kMostFlightMinutes

signals:
    void changed(); ///< a recording began, ended or failed
    void kept(const QString& path); ///< a recording, or the last minutes, in a whole file

private:
    void begin(const RecordingPlan& plan);
    void connectContext();
    void connectRecorders();
    void applySettings();
    void updateWishes();
    void noteMarks(); ///< the person's own marks
    void noteSettings(); ///< the configuration as known now, if it is another than before
    void onFrozen(const QString& path, const QString& reason);
    [[nodiscard]] bool isJoint() const;

    PanelContext& m_context;
    RecordingFacts m_program;
    SessionRecorder m_recorder;
    FlightRecorder m_flight;
    QTimer m_settled; ///< a burst of settings read or written makes one configuration
    QElapsedTimer m_since;
    std::size_t m_marks = 0; ///< how many there were when it was looked last
    std::optional<Configuration> m_noted; ///< the newest in the running recording
    QString m_problem;
};

/// "00:12:31", "27:00:00".
[[nodiscard]] QString recordingTimeText(std::chrono::milliseconds length);
[[nodiscard]] QString recordingSizeText(qint64 bytes); ///< "1.2 MiB"

} // namespace trex
