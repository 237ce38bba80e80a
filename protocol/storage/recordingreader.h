// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingdata.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QDateTime>
#include <QTemporaryDir>

#include <memory>

namespace trex {

class RecordingDatabase;

/// What is known of one block of a stream without looking into it: enough to draw a day.
struct RecordingSpan {
    Tick first = 0;
    Tick last = 0;
    Extent extent; ///< empty: no valid sample
    double mean = 0.0; ///< of the valid samples
    std::size_t samples = 0;
    bool hasGap = false; ///< somewhere in it, or right before it
};

/// A recording, opened read-only; nothing is changed or left beside it. Takes a file that a crash
/// left with its WAL, one in a folder that cannot be written, and believes nothing: what is damaged
/// is left out and told by remark(), what is no recording is refused. Not thread-safe; one thread.
class RecordingReader {
public:
    /// Reads what the overview needs. Errors: FileUnreadable, FileMalformed (no recording, one of a
    /// newer program, too damaged), with the path and one sentence.
    [[nodiscard]] static Result<std::unique_ptr<RecordingReader>> open(const QString& path);
    ~RecordingReader();
    Q_DISABLE_COPY_MOVE(RecordingReader)

    [[nodiscard]] const RecordingFacts& facts() const { return m_facts; }
    [[nodiscard]] QString fact(const char* name) const; ///< empty: not said
    [[nodiscard]] bool isFinished() const; ///< ended as it should, not by a crash
    [[nodiscard]] QDateTime started() const; ///< wall clock of tick 0; invalid: not said
    [[nodiscard]] Model model() const; ///< TReX Jr unless the signature says otherwise
    [[nodiscard]] std::optional<InputKind> input() const; ///< at the start, as far as known

    [[nodiscard]] std::size_t samples(Source source) const;
    /// First and last sample of all; none: no samples.
    [[nodiscard]] std::optional<std::pair<Tick, Tick>> range() const;
    [[nodiscard]] std::vector<RecordingSpan> overview(int streamIndex) const;

    /// Loads the next blocks into a store, in order of time: tick 0 becomes `origin`. True while
    /// there is more; blocks that are damaged leave a gap.
    [[nodiscard]] bool loadSome(TelemetryStore& store, Instant origin, std::size_t blocks);
    void loadAll(TelemetryStore& store, Instant origin);
    [[nodiscard]] double progress() const; ///< of loading, 0 to 1

    // In order of time. What cannot be read is left out and remarked upon.
    [[nodiscard]] std::vector<RecordedEvent> events();
    [[nodiscard]] std::vector<RecordedHealth> health();
    [[nodiscard]] std::vector<RecordedConfiguration> configurations();
    [[nodiscard]] std::size_t packetCount();
    [[nodiscard]] std::size_t packetsUpTo(Tick tick); ///< how many were sent by then
    /// At most `most` packets from the `from`-th on.
    [[nodiscard]] std::vector<RecordedPacket> packets(std::size_t from, std::size_t most);

    /// What a person has to know of the file: damage, an end by a crash. Empty: nothing.
    [[nodiscard]] QString remark() const;

private:
    struct Block {
        qint64 id = 0;
        Tick first = 0;
        Tick last = 0;
        std::size_t samples = 0;
        quint32 crc = 0;
        Source source = PollId::Currents;
        bool hasGap = false;
    };
    struct Summary {
        std::size_t block = 0; ///< index into m_blocks
        ColumnSummary values;
    };
    explicit RecordingReader(const QString& path);
    [[nodiscard]] Result<void> connect();
    [[nodiscard]] Result<void> connectTo(const QString& path, bool isCopy);
    [[nodiscard]] Result<void> copyAside();
    [[nodiscard]] Result<void> checkSchema();
    [[nodiscard]] Result<void> readFacts();
    [[nodiscard]] Result<void> checkStreams();
    void readBlocks();
    void readSummaries();
    [[nodiscard]] Result<SampleRun> readBlock(const Block& block);
    [[nodiscard]] Error malformed(const QString& why) const;
    /// One row of a statement after another, for as long as they can be read.
    template <class F>
    void eachRow(const QString& sql, const QVariantList& values, F&& take);

    QString m_path;
    std::unique_ptr<QTemporaryDir> m_copy; ///< of a file that cannot be read where it is
    std::unique_ptr<RecordingDatabase> m_database;
    RecordingFacts m_facts;
    std::array<bool, kSourceCount> m_isKnown{}; ///< sources whose columns are as ours
    std::vector<Block> m_blocks; ///< by time of the first sample
    std::vector<std::vector<Summary>> m_summaries; ///< by stream, in order of blocks
    std::size_t m_nextBlock = 0; ///< to be loaded
    std::optional<std::size_t> m_packetCount;
    std::size_t m_damaged = 0; ///< rows and blocks left out
    bool m_isForeign = false; ///< holds streams that this program does not know
};

} // namespace trex
