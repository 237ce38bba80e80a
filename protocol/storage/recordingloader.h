// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingreader.h"

#include <QTimer>

namespace trex {

/// Loads a recording into a store in slices, so that a day neither blocks the window nor keeps it
/// waiting. Main thread.
class RecordingLoader : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RecordingLoader)

public:
    /// Outlived by both. Tick 0 becomes `origin`.
    RecordingLoader(RecordingReader& reader, TelemetryStore& store, Instant origin,
                    QObject* parent = nullptr);

    void start(); ///< slice by slice from the event loop; finished() follows, even for nothing
    /// One slice: at most about `budget`. True while there is more.
    bool loadSlice(std::chrono::milliseconds budget);
    [[nodiscard]] bool isFinished() const { return m_isFinished; }
    [[nodiscard]] double progress() const { return m_reader.progress(); }

signals:
    void progressed();
    void finished();

private:
    void onTurn();

    RecordingReader& m_reader;
    TelemetryStore& m_store;
    Instant m_origin;
    QTimer m_turn;
    bool m_isFinished = false;
};

} // namespace trex
