// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/result.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QFile>

#include <optional>

namespace trex {

/// Appends the currents to a CSV file as they come, from the moment of its start, and hands them to
/// the system at least once a second, so that a crash costs no more than that. Main thread; the
/// owner calls pump() now and then (each frame).
class CsvRecorder : public SampleHolder {
public:
    explicit CsvRecorder(const TelemetryStore& store);
    ~CsvRecorder() override;
    Q_DISABLE_COPY_MOVE(CsvRecorder)

    /// Begins a new file. Error: FileUnwritable, with the path and the cause.
    [[nodiscard]] Result<void> start(const QString& path, double amperesPerCount);
    /// Writes what is new. An error (a full disk) ends the recording; what was written stays.
    Result<void> pump(Instant now);
    Result<void> stop(); ///< writes what is new, closes; fine when nothing is recorded

    [[nodiscard]] bool isRecording() const { return m_file.isOpen(); }
    [[nodiscard]] QString path() const { return m_file.fileName(); }
    [[nodiscard]] std::size_t samples() const { return m_samples; } ///< written to this file
    [[nodiscard]] std::size_t firstNeeded(Source source) const override;

private:
    [[nodiscard]] Result<void> writeNew();
    [[nodiscard]] tl::unexpected<Error> giveUp();

    const TelemetryStore& m_store;
    QFile m_file;
    double m_amperesPerCount = 0.0;
    std::size_t m_next = 0; ///< first sample not yet written
    int m_clears = 0; ///< of the store, when m_next was right
    std::optional<Instant> m_origin; ///< time 0 of the file: its first sample
    std::optional<Instant> m_lastFlush;
    std::size_t m_samples = 0;
};

} // namespace trex
