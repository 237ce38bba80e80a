// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recordingloader.h"

#include <QElapsedTimer>

namespace trex {
namespace {

constexpr std::size_t kBlocksBetweenLooks = 4;
constexpr std::chrono::milliseconds kSlice{12}; // between two frames of 33 ms

} // namespace

RecordingLoader::RecordingLoader(RecordingReader& reader, TelemetryStore& store, Instant origin,
                                 QObject* parent)
    : QObject(parent), m_reader(reader), m_store(store), m_origin(origin)
{
    connect(&m_turn, &QTimer::timeout, this, &RecordingLoader::onTurn);
}

void RecordingLoader::start()
{
    m_turn.start(0);
}

bool RecordingLoader::loadSlice(std::chrono::milliseconds budget)
{
    QElapsedTimer timer;
    timer.start();
    bool isMore = true;
    while (isMore && timer.elapsed() < budget.count()) {
        isMore = m_reader.loadSome(m_store, m_origin, kBlocksBetweenLooks);
    }
    m_isFinished = !isMore;
    return isMore;
}

void RecordingLoader::onTurn()
{
    if (loadSlice(kSlice)) {
        emit progressed();
        return;
    }
    m_turn.stop();
    emit finished();
}

} // namespace trex
