// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/linkworker.h"

#include <QThread>

namespace trex {

/// Owns the link thread and the worker on it. Posts calls to the worker; ends with a bounded wait.
class LinkThread : public QObject {
    Q_OBJECT
    Q_DISABLE_COPY_MOVE(LinkThread)

public:
    explicit LinkThread(QObject* parent = nullptr);
    ~LinkThread() override;

    [[nodiscard]] const LinkWorker& worker() const { return *m_worker; }
    /// Runs f(worker) on the link thread, in order with all others.
    template <class F>
    void post(F&& f)
    {
        LinkWorker* worker = m_worker;
        QMetaObject::invokeMethod(
            worker, [worker, call = std::forward<F>(f)]() mutable { call(*worker); },
            Qt::QueuedConnection);
    }

private:
    QThread m_thread;
    LinkWorker* m_worker; ///< deleted on its own thread when that ends
};

} // namespace trex
