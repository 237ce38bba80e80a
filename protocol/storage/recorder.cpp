// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storage/recorder.h"

#include "protocol/storage/recordingwriter.h"

#include <QDir>
#include <QFileInfo>

namespace trex {

using namespace Qt::Literals::StringLiterals;

namespace {

// A slow disk may take its time with what waits for it; one that does not answer may not.
constexpr unsigned long kLongestJoinMs = 60'000;

/// "run.trexrec", "run-2.trexrec", …: the first that nobody has.
QString freeName(const QString& path)
{
    const QFileInfo info(path);
    const QString suffix = info.suffix().isEmpty() ? QString() : u'.' + info.suffix();
    QString name = path;
    for (int i = 2; QFileInfo::exists(name); ++i) {
        name = info.dir().filePath(u"%1-%2%3"_s.arg(info.completeBaseName()).arg(i).arg(suffix));
    }
    return name;
}

Result<std::unique_ptr<RecordingWriter>> createNew(const QString& path, const RecordingFacts& facts)
{
    const QString folder = QFileInfo(path).path();
    if (!QDir().mkpath(folder)) {
        return fail(ErrorCode::FileUnwritable, folder);
    }
    return RecordingWriter::create(path, facts);
}

} // namespace

class RecorderThread::Worker : public QObject {
public:
    Writer writer;
    QString path;
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

void RecorderThread::measure(const QString& path)
{
    m_bytes = QFileInfo(path).size() + QFileInfo(path + u"-wal"_s).size();
}

void RecorderThread::create(const QString& path, const RecordingFacts& facts, Existing existing,
                            const Created& handler)
{
    m_bytes = 0;
    QMetaObject::invokeMethod(
        m_worker,
        [this, worker = m_worker, path, facts, existing, handler] {
            worker->writer.reset(); // an earlier file keeps what it has
            worker->path = existing == Existing::Keep ? freeName(path) : path;
            auto created = existing == Existing::Keep
                ? createNew(worker->path, facts)
                : RecordingWriter::create(worker->path, facts);
            Result<QString> result = worker->path;
            if (created) {
                worker->writer = std::move(*created);
                measure(worker->path);
            } else {
                result = tl::make_unexpected(created.error());
            }
            QMetaObject::invokeMethod(
                this, [handler, result] { handler(result); }, Qt::QueuedConnection);
        },
        Qt::QueuedConnection);
}

void RecorderThread::write(RecordingBatch batch, const Handler& handler)
{
    post(
        [this, worker = m_worker, batch = std::move(batch)](Writer& writer) -> Result<void> {
            if (!writer) {
                return fail(ErrorCode::Cancelled);
            }
            auto written = writer->write(batch);
            measure(worker->path);
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
        [this, worker = m_worker](Writer& writer) -> Result<void> {
            if (!writer) {
                return fail(ErrorCode::Cancelled);
            }
            auto finished = writer->finish();
            writer.reset();
            measure(worker->path);
            return finished;
        },
        handler);
}

} // namespace trex
