// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/transaction.h"

#include <QHash>
#include <QPointer>

#include <functional>

namespace trex {

/// Who waits for which transaction's outcome. Main thread.
class WaitingList {
public:
    using Handler = std::function<void(Result<Reply>)>;

    quint64 nextId() { return m_nextId++; }
    /// A number for a new transaction; the handler, if any, is called once unless `context` dies.
    quint64 enlist(QObject* context, Handler handler);
    void wait(quint64 id, QObject* context, Handler handler);
    void answer(quint64 id, const Result<Reply>& reply);
    void failAll(const Error& error);

private:
    struct Waiting {
        QPointer<QObject> context;
        bool hasContext = false;
        Handler handler;
    };
    QHash<quint64, Waiting> m_waiting;
    quint64 m_nextId = 1;
};

} // namespace trex
