// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/linkthread.h"

namespace trex {

namespace {

using namespace Qt::Literals::StringLiterals;

// More than the longest close, the longest reply at 1200 baud and the TCP connect together.
constexpr unsigned long kLongestJoinMs = 8000;

} // namespace

LinkThread::LinkThread(QObject* parent) : QObject(parent), m_thread(this), m_worker(new LinkWorker)
{
    m_thread.setObjectName(u"link"_s);
    m_worker->moveToThread(&m_thread);
    connect(&m_thread, &QThread::finished, m_worker, &QObject::deleteLater);
    m_thread.start();
}

LinkThread::~LinkThread()
{
    // After all that was posted before, a close with its stop packets among it.
    post([](LinkWorker& worker) { worker.thread()->quit(); });
    if (!m_thread.wait(kLongestJoinMs)) {
        qFatal("the link thread does not end");
    }
}

} // namespace trex
