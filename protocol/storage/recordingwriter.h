// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingdata.h"

#include <QVariant>

#include <memory>

namespace trex {

class RecordingDatabase;

/// Writes one recording (recordingdatabase.h has its schema). Blocks the thread it is called on
/// until the disk has taken what was given: it lives on the recorder's thread.
class RecordingWriter {
public:
    /// A new file; an older one of this name is replaced, with what a crash left beside it. Error:
    /// FileUnwritable, with the path and the cause.
    [[nodiscard]] static Result<std::unique_ptr<RecordingWriter>>
    create(const QString& path, const RecordingFacts& facts);
    ~RecordingWriter(); ///< what was written stays; without finish() the file keeps its WAL
    Q_DISABLE_COPY_MOVE(RecordingWriter)

    /// One transaction, on the disk when it returns (WAL, synchronous=FULL). After an error the
    /// file holds what was written before; give up then.
    [[nodiscard]] Result<void> write(const RecordingBatch& batch);
    /// Makes a single file of it that needs no WAL any more.
    [[nodiscard]] Result<void> finish();

private:
    explicit RecordingWriter(std::unique_ptr<RecordingDatabase> database);
    [[nodiscard]] Result<void> setUp(const RecordingFacts& facts);
    [[nodiscard]] Result<void> writeAll(const RecordingBatch& batch);
    [[nodiscard]] Result<void> writeFacts(const RecordingFacts& facts);
    [[nodiscard]] Result<void> writeRun(Source source, const SampleRun& run);
    [[nodiscard]] Result<void> writeBlock(Source source, bool isFinal);
    [[nodiscard]] Result<void> writeConfiguration(const RecordedConfiguration& recorded);
    [[nodiscard]] Result<void> run(const QString& sql, const QVariantList& values = {});

    struct OpenBlock {
        qint64 id = 0; ///< 0: none yet
        SampleRun run;
    };
    std::unique_ptr<RecordingDatabase> m_database;
    std::array<OpenBlock, kSourceCount> m_open; ///< the newest block of each source, still growing
    qint64 m_nextBlock = 1;
    qint64 m_nextConfiguration = 1;
};

} // namespace trex
