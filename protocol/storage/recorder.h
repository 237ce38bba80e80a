// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingdata.h"

#include <QThread>

#include <atomic>
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
    using Created = std::function<void(const Result<QString>& path)>;
    enum class Existing : std::uint8_t {
        Replace, ///< an older file of that name goes
        Keep, ///< the new one gets another name ("NAME-2"), and its folder is made when missing
    };
    using Writer = std::unique_ptr<RecordingWriter>;
    using Job = std::function<Result<void>(Writer&)>; ///< on the recorder's thread

    explicit RecorderThread(QObject* parent = nullptr);
    /// After all jobs that were posted: what was handed over reaches the disk.
    ~RecorderThread() override;

    void create(const QString& path, const RecordingFacts& facts, Existing existing,
                const Created& handler);
    /// An error closes the file, with what it has; further batches are refused.
    void write(RecordingBatch batch, const Handler& handler);
    void finish(const Handler& handler);
    void post(Job job, const Handler& handler);
    /// Size of the file that is, or was last, written, with what SQLite keeps beside it.
    [[nodiscard]] qint64 bytes() const { return m_bytes; }

private:
    void measure(const QString& path); ///< on the recorder's thread
    class Worker;
    QThread m_thread;
    std::atomic<qint64> m_bytes = 0;
    Worker* m_worker; ///< deleted on its own thread when that ends
};

} // namespace trex
