// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recorder.h"

#include "protocol/storage/recordingwriter.h"

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

// A slow disk may take its time with what waits for it; one that does not answer may not.
constexpr unsigned long kLongestJoinMs = 60'000;

} // namespace

class RecorderThread::Worker : public QObject {
public:
    Writer writer;
};

RecorderThread::RecorderThread(QObject* parent)
    : QObject(parent), m_thread(this), m_worker(new Worker)
{
    m_thread.setObjectName(u"recorder"_s);
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    m_thread.start(QThread::LowPriority);
}

RecorderThread::~RecorderThread()
{
    QMetaObject::invokeMethod(
        m_worker, [worker = m_worker] { worker->thread()->quit(); }, Qt::QueuedConnection);
    if (!m_thread.wait(kLongestJoinMs)) {
        qFatal("the recorder's thread does not end");
    }
}

void RecorderThread::post(Job job, const Handler& handler)
{
    QMetaObject::invokeMethod(
        m_worker,
        [this, worker = m_worker, work = std::move(job), handler] {
            const Result<void> result = work(worker->writer);
            // The destructor waits for this thread: `this` outlives the call, and what is still
            // queued for it then is dropped.
            QMetaObject::invokeMethod(
                this, [handler, result] { handler(result); }, Qt::QueuedConnection);
        },
        Qt::QueuedConnection);
}

void RecorderThread::create(const QString& path, const RecordingFacts& facts,
                            const Handler& handler)
{
    post(
        [path, facts](Writer& writer) -> Result<void> {
            writer.reset(); // an earlier file keeps what it has
            auto created = RecordingWriter::create(path, facts);
            if (!created) {
                return tl::make_unexpected(created.error());
            }
            writer = std::move(*created);
            return {};
        },
        handler);
}

void RecorderThread::write(RecordingBatch batch, const Handler& handler)
{
    post(
        [batch = std::move(batch)](Writer& writer) -> Result<void> {
            if (!writer) {
                return fail(ErrorCode::Cancelled);
            }
            auto written = writer->write(batch);
            if (!written) {
                writer.reset();
            }
            return written;
        },
        handler);
}

void RecorderThread::finish(const Handler& handler)
{
    post(
        [](Writer& writer) -> Result<void> {
            if (!writer) {
                return fail(ErrorCode::Cancelled);
            }
            auto finished = writer->finish();
            writer.reset();
            return finished;
        },
        handler);
}

} // namespace trex
