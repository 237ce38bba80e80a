// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/comparisonrun.h"

#include <QFileInfo>

namespace trex {

ComparisonRun::ComparisonRun(std::unique_ptr<RecordingReader> reader, const QString& path,
                             QObject* parent)
    : QObject(parent)
    , m_reader(std::move(reader))
    , m_store(std::make_unique<TelemetryStore>())
    , m_loader(*m_reader, *m_store, Instant())
    , m_name(QFileInfo(path).completeBaseName())
{
    connect(&m_loader, &RecordingLoader::finished, this, &ComparisonRun::finished);
}

ComparisonRun::~ComparisonRun() = default;

void ComparisonRun::start()
{
    m_loader.start();
}

int ComparisonRun::addTo(PlotReferences& references)
{
    const Instant origin = m_store->start().value_or(Instant());
    return references.add(std::move(m_store), m_name, origin, amperesPerCount(m_reader->model()));
}

} // namespace trex
