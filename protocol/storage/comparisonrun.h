// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storage/recordingloader.h"
#include "protocol/telemetry/plotreferences.h"

namespace trex {

/// A recording on its way to be compared with: loaded in slices into a store of its own, then given
/// to the plots. Main thread.
class ComparisonRun : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(ComparisonRun)

public:
    ComparisonRun(std::unique_ptr<RecordingReader> reader, const QString& path,
                  QObject* parent = nullptr);
    ~ComparisonRun() override;

    void start(); ///< finished() follows
    /// Its name is the file's, its start the first sample. Gives the run's number. Once, when
    /// loaded.
    int addTo(PlotReferences& references);

signals:
    void finished();

private:
    std::unique_ptr<RecordingReader> m_reader;
    std::unique_ptr<TelemetryStore> m_store;
    RecordingLoader m_loader;
    QString m_name;
};

} // namespace trex
