// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingdata.h"

#include <QThread>

#include <functional>
#include <memory>

namespace trex {

class RecordingWriter;

/// Owns the thread that waits for the disk, so that nobody else does. Jobs run in order; each
/// handler runs once, on the thread that owns this, unless this dies before. One file at a time.
class RecorderThread : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(RecorderThread)

public:
    using Handler = std::function<void(const Result<void>&)>;
    using Writer = std::unique_ptr<RecordingWriter>;
    using Job = std::function<Result<void>(Writer&)>; ///< on the recorder's thread

    explicit RecorderThread(QObject* parent = nullptr);
    /// After all jobs that were posted: what was handed over reaches the disk.
    ~RecorderThread() override;

    void create(const QString& path, const RecordingFacts& facts, const Handler& handler);
    /// An error closes the file, with what it has; further batches are refused.
    void write(RecordingBatch batch, const Handler& handler);
    void finish(const Handler& handler);
    void post(Job job, const Handler& handler);

private:
    class Worker;
    QThread m_thread;
    Worker* m_worker; ///< deleted on its own thread when that ends
};

} // namespace trex
