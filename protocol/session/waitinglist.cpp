// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/waitinglist.h"

namespace trex {

quint64 WaitingList::enlist(QObject* context, Handler handler)
{
    const quint64 id = nextId();
    wait(id, context, std::move(handler));
    return id;
}

void WaitingList::wait(quint64 id, QObject* context, Handler handler)
{
    if (handler) {
        m_waiting.insert(id, {context, context != nullptr, std::move(handler)});
    }
}

void WaitingList::answer(quint64 id, const Result<Reply>& reply)
{
    if (!m_waiting.contains(id)) {
        return;
    }
    const Waiting waiting = m_waiting.take(id);
    if (!waiting.hasContext || waiting.context) {
        waiting.handler(reply);
    }
}

void WaitingList::failAll(const Error& error)
{
    const auto ids = m_waiting.keys();
    for (const quint64 id : ids) {
        answer(id, tl::make_unexpected(error));
    }
}

} // namespace trex
